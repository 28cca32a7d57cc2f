//! Points, boxes, normalization, errors, and checks of arguments.

pub(crate) mod bounds;
pub(crate) mod box_tree;
pub(crate) mod check;
pub(crate) mod error;
pub(crate) mod normalized;
pub(crate) mod point;
