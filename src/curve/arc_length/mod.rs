//! The length of a curve up to a parameter, and the parameter at a length.

pub(crate) mod integral;
pub(crate) mod inverse;
pub(crate) mod length;
