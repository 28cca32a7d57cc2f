//! Polynomials in Bernstein form: values, subdivision, products, roots.
//!
//! In the kernels, which need them too: de Casteljau's algorithm, Bernstein weights, products of degree at most 6.

pub(crate) mod evaluate;
pub(crate) mod polynomials;
pub(crate) mod product;
pub(crate) mod roots;
pub(crate) mod wronskian;
