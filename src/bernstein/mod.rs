//! Polynomials in Bernstein form: values, subdivision, products, roots.

pub(crate) mod evaluate;
pub(crate) mod polynomials;
pub(crate) mod product;
pub(crate) mod roots;

pub(crate) use casteljau_kernels::bernstein::{de_casteljau, weights};
