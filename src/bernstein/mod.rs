//! Polynomials in Bernstein form: values, subdivision, products, roots.

pub(crate) mod casteljau;
pub(crate) mod evaluate;
pub(crate) mod polynomials;
pub(crate) mod product;
pub(crate) mod roots;
