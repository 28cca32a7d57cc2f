//! Numbers, lists and sorting, independent of geometry.
//!
//! In the kernels, which need them too: Gauss rules, order, trigonometry, vectors, work limits, zeros in a bracket.

pub(crate) mod float;
pub(crate) mod list;
pub(crate) mod sort;
