//! Boolean operations: unions, intersections, differences of the regions that paths fill.
//!
//! The outlines of all paths divide the plane into faces. [`contacts`] finds where segments meet, [`arcs`] cuts them
//! there, [`edges`] takes arcs together that coincide, [`order`] sorts the edges around each vertex, and [`faces`]
//! follows the boundaries of the faces. If rounding makes them contradict each other, lines replace the segments there
//! ([`grid`]). Winding numbers are carried from face to face ([`windings`]); then the
//! boundary between faces inside and faces outside is the result ([`contours`], [`outline`]).

mod arcs;
mod arrangement;
mod contacts;
mod contours;
mod cutting;
mod edges;
mod faces;
mod grid;
mod operations;
mod order;
mod outline;
mod segments;
mod union_find;
mod windings;

#[cfg(feature = "count-work")]
pub use grid::take_replaced_segments;
pub use operations::{BooleanOperation, Face};
