//! Bindings of intersections in the plane. Arguments: both curves or both splines, one after the other. Results: for
//! each intersection t, u, x, y, the code of its kind (0 cross, 1 tangent, 2 overlap), and t and u of its end.

use super::arena;
use super::arena::Arena;
use super::spline::spline_at;
use crate::curve::Curve;
use crate::curve::intersect::intersection::{Intersection, IntersectionKind, SelfIntersection};
use crate::spline::Spline;
use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

fn curve(a: &Arena, at: usize, count: usize) -> Curve<DVec2> {
    Curve::from_slice(a.points(at, count))
}

/// The spline at index `at` of the arena, and the index where it ends.
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

pub(super) fn write(a: &mut Arena, found: &[Intersection]) -> usize {
    found.iter().fold(0, |at, &intersection| {
        write_intersection(a, at, intersection)
    })
}

/// Writes one intersection; returns the index where it ends.
pub(crate) fn write_intersection(a: &mut Arena, at: usize, intersection: Intersection) -> usize {
    let Intersection { t, u, point, kind } = intersection;
    let (code, t_end, u_end) = match kind {
        IntersectionKind::Cross => (0.0, t, u),
        IntersectionKind::Tangent => (1.0, t, u),
        IntersectionKind::Overlap { t_end, u_end } => (2.0, t_end, u_end),
    };
    a.write_numbers(at, &[t, u, point.x, point.y, code, t_end, u_end])
}

pub(super) fn write_selves(a: &mut Arena, found: &[SelfIntersection]) -> usize {
    let crossing = |intersection: &SelfIntersection| {
        let SelfIntersection { t, u, point } = *intersection;
        let kind = IntersectionKind::Cross;
        Intersection { t, u, point, kind }
    };
    let found: Vec<Intersection> = found.iter().map(crossing).collect();
    write(a, &found)
}

/// Writes the intersections of two curves.
#[wasm_bindgen]
pub fn curve_intersect(count: usize, other_count: usize) -> usize {
    arena::with(|a| {
        let other = curve(a, 2 * count, other_count);
        let found = curve(a, 0, count).intersections(&other);
        write(a, &found)
    })
}

/// Writes the self-intersections of a curve.
#[wasm_bindgen]
pub fn curve_self_intersections(count: usize) -> usize {
    arena::with(|a| {
        let found = curve(a, 0, count).self_intersections();
        write_selves(a, &found)
    })
}

/// Writes the intersections of two splines.
#[wasm_bindgen]
pub fn spline_intersect() -> usize {
    arena::with(|a| {
        let (first, end) = spline(a, 0);
        let found = first.intersections(&spline(a, end).0);
        write(a, &found)
    })
}

/// Writes the self-intersections of a spline.
#[wasm_bindgen]
pub fn spline_self_intersections() -> usize {
    arena::with(|a| {
        let found = spline(a, 0).0.self_intersections();
        write_selves(a, &found)
    })
}
