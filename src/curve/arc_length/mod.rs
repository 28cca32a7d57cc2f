//! Arc length up to a parameter, and the parameter at a given arc length.

pub(crate) mod integral;
pub(crate) mod inverse;
pub(crate) mod length;
