//! Boolean operations: unions, intersections, differences of the regions that paths fill.
//!
//! The outlines of all paths divide the plane into faces. [`contacts`] finds where segments meet, [`sub_segments`] cuts
//! them there, [`edges`] takes sub-segments together that coincide, [`vertex_stars`] sorts the edges around each vertex,
//! and [`faces`] follows the boundaries of the faces. If rounding makes them contradict each other, lines replace the
//! segments there ([`rescue`]). Winding numbers are carried from face to face ([`windings`]); then the boundary between
//! faces inside and faces outside is the result ([`contours`], [`outline`]).

mod arrangement;
mod contacts;
mod contours;
mod cutting;
mod edges;
mod faces;
mod operations;
mod outline;
mod rescue;
mod segments;
mod sub_segments;
mod union_find;
mod vertex_stars;
mod windings;

pub use operations::{BooleanOperation, Face};
#[cfg(feature = "count-work")]
pub use rescue::take_replaced_segments;
