//! Bindings of intersections, all in the plane. In: both curves or both splines, one after the other. Out: for each place
//! t, u, x, y, the code of its kind (0 cross, 1 tangent, 2 overlap), and t and u of its end.

use super::arena::{self, Arena};
use super::spline::spline_at;
use crate::curve::{Curve, Intersection, IntersectionKind, SelfIntersection};
use crate::spline::Spline;
use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

fn curve(a: &Arena, at: usize, count: usize) -> Curve<DVec2> {
    Curve::from_slice(a.points(at, count))
}

/// The spline at a place of the arena, and where it ends.
fn spline(a: &Arena, at: usize) -> (Spline<DVec2>, usize) {
    let (spline, end) = spline_at(a, at, 2);
    let points = spline
        .control_points()
        .iter()
        .map(|p| p.truncate())
        .collect();
    (
        Spline::from_parts(points, &spline.degrees(), spline.is_closed()),
        end,
    )
}

fn put(a: &mut Arena, places: &[Intersection]) -> usize {
    places.iter().fold(0, |at, &place| put_place(a, at, place))
}

/// Writes one place and returns where it ends.
pub(super) fn put_place(a: &mut Arena, at: usize, place: Intersection) -> usize {
    let Intersection { t, u, point, kind } = place;
    let (code, t_end, u_end) = match kind {
        IntersectionKind::Cross => (0.0, t, u),
        IntersectionKind::Tangent => (1.0, t, u),
        IntersectionKind::Overlap { t_end, u_end } => (2.0, t_end, u_end),
    };
    a.put_numbers(at, &[t, u, point.x, point.y, code, t_end, u_end])
}

fn put_selves(a: &mut Arena, places: &[SelfIntersection]) -> usize {
    let crossing = |place: &SelfIntersection| {
        let SelfIntersection { t, u, point } = *place;
        let kind = IntersectionKind::Cross;
        Intersection { t, u, point, kind }
    };
    let places: Vec<Intersection> = places.iter().map(crossing).collect();
    put(a, &places)
}

/// Leaves the places that two curves share.
#[wasm_bindgen]
pub fn curve_intersect(count: usize, other_count: usize) -> usize {
    arena::with(|a| {
        let other = curve(a, 2 * count, other_count);
        let places = curve(a, 0, count).intersections(&other);
        put(a, &places)
    })
}

/// Leaves the points that a curve passes twice.
#[wasm_bindgen]
pub fn curve_self_intersections(count: usize) -> usize {
    arena::with(|a| {
        let places = curve(a, 0, count).self_intersections();
        put_selves(a, &places)
    })
}

/// Leaves the places that two splines share.
#[wasm_bindgen]
pub fn spline_intersect() -> usize {
    arena::with(|a| {
        let (first, end) = spline(a, 0);
        let places = first.intersections(&spline(a, end).0);
        put(a, &places)
    })
}

/// Leaves the points that a spline passes twice.
#[wasm_bindgen]
pub fn spline_self_intersections() -> usize {
    arena::with(|a| {
        let places = spline(a, 0).0.self_intersections();
        put_selves(a, &places)
    })
}
