//! The Utah teapot, and the teacup and the teaspoon of the same tea set.

mod tea_set;
mod teacup_data;
pub(crate) mod teapot;
mod teapot_data;
mod teaspoon_data;

pub use teapot::{Height, TeapotOptions, Up};
