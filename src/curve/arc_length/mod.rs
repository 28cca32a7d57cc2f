//! Arc length up to a parameter, and the parameter at a given arc length.

pub(crate) mod integral;
pub(crate) mod inverse;
pub(crate) mod length;
pub(crate) mod point_at_length;
pub(crate) mod segments;

pub(crate) use casteljau_kernels::curve::arc_length::{plane_cubic, speed};
