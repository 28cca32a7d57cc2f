//! Numbers, lists and sorting, independent of geometry.

pub(crate) mod float;
pub(crate) mod list;
pub(crate) mod sort;

#[cfg(not(feature = "wasm"))]
pub(crate) mod gauss;
#[cfg(not(feature = "wasm"))]
pub(crate) mod order;
#[cfg(not(feature = "wasm"))]
pub(crate) mod trigonometry;
#[cfg(not(feature = "wasm"))]
pub(crate) mod work_limit;
#[cfg(not(feature = "wasm"))]
pub(crate) mod zero;
#[cfg(feature = "wasm")]
pub(crate) use casteljau_fast::numeric::{gauss, order, trigonometry, work_limit, zero};
