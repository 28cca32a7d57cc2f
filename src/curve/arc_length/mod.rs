//! Arc length up to a parameter, and the parameter at a given arc length.
//!
//! In the kernels, for their speed: the integral of the speed, and the length of a plane cubic.

pub(crate) mod integral;
pub(crate) mod inverse;
pub(crate) mod length;
pub(crate) mod point_at_length;
pub(crate) mod segments;
