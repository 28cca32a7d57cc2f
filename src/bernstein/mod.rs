//! Polynomials in Bernstein form: values, subdivision, products, roots.

pub(crate) mod evaluate;
pub(crate) mod polynomials;
pub(crate) mod product;
pub(crate) mod roots;

#[cfg(not(feature = "wasm"))]
pub(crate) mod de_casteljau;
#[cfg(not(feature = "wasm"))]
pub(crate) mod weights;
#[cfg(feature = "wasm")]
pub(crate) use casteljau_fast::bernstein::{de_casteljau, weights};
