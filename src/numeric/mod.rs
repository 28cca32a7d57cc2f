//! Numbers, lists and sorting, independent of geometry.

pub(crate) mod float;
pub(crate) mod list;
pub(crate) mod sort;
