//! Numbers, lists and sorting, independent of geometry.

pub(crate) mod float;
pub(crate) mod list;
pub(crate) mod sort;

pub(crate) use casteljau_kernels::numeric::{gauss, order, trigonometry, work_limit, zero};
