//! Numbers, lists and sorting, which know nothing of geometry.

pub(crate) mod float;
pub(crate) mod list;
pub(crate) mod sort;
