//! Bindings of intersections, all in the plane. In: the control points of both curves, one after the other.

use super::arena::{self, Arena};
use crate::curve::{Contact, Curve, Intersection};
use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

fn curve(a: &Arena, at: usize, count: usize) -> Curve<DVec2> {
    Curve::from_slice(a.points(at, count))
}

/// Leaves for each place t, u, x, y, the code of its kind (0 cross, 1 tangent, 2 overlap), and t and u of its end.
fn put(a: &mut Arena, places: &[Intersection]) -> usize {
    places.iter().fold(0, |at, place| {
        let Intersection { t, u, point, kind } = *place;
        let (code, t_end, u_end) = match kind {
            Contact::Cross => (0.0, t, u),
            Contact::Tangent => (1.0, t, u),
            Contact::Overlap { t_end, u_end } => (2.0, t_end, u_end),
        };
        a.put_numbers(at, &[t, u, point.x, point.y, code, t_end, u_end])
    })
}

/// Leaves the places that two curves share.
#[wasm_bindgen]
pub fn curve_intersect(count: usize, other_count: usize) -> usize {
    arena::with(|a| {
        let other = curve(a, 2 * count, other_count);
        let places = curve(a, 0, count).intersect(&other);
        put(a, &places)
    })
}
