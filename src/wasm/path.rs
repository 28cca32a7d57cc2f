//! Bindings of paths. Arguments: the number of subpaths, each subpath as a plane spline, followed by further arguments.

use super::arena;
use super::arena::Arena;
use super::intersect::write_intersection;
use super::spline::spline_at;
use super::{optional, within};
use crate::curve::Curve;
use crate::curve::flatten::MAX_VERTICES;
use crate::curve::intersect::intersection::Intersection;
use crate::curve::trace::PathSink;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::path::intersect::PathIntersection;
use crate::path::length::SegmentIndex;
use crate::path::winding::crossings;
use crate::path::{Path, PathTime};
use crate::spline::Spline;
use glam::{DVec2, DVec3};
use wasm_bindgen::prelude::wasm_bindgen;

/// Calls `f` with each subpath as 3D (see [`Arena::points_in_space`]); returns the index where the last one ends.
fn each(a: &Arena, mut f: impl FnMut(Spline<DVec3>)) -> usize {
    (0..a.count(0)).fold(1, |at, _| {
        let (spline, end) = spline_at(a, at, 2);
        f(spline);
        end
    })
}

/// The path at the start of the arena, and the index where it ends.
fn path(a: &Arena) -> (Path, usize) {
    path_at(a, 0)
}

/// The path at index `start` of the arena, and the index where it ends.
pub(super) fn path_at(a: &Arena, start: usize) -> (Path, usize) {
    let mut path = Path::default();
    let mut at = start + 1;
    for _ in 0..a.count(start) {
        let (segments, closed) = (a.count(at), a.number(at + 1) != 0.0);
        let degrees: Vec<usize> = (at + 2..at + 2 + segments).map(|k| a.count(k)).collect();
        let count = degrees.iter().sum::<usize>() + usize::from(!closed);
        at += 2 + segments;
        path.push(a.points(at, count), degrees, closed);
        at += 2 * count;
    }
    (path, at)
}

/// Writes the minimum and the maximum corner of the box of the path or of its control points; returns 0 for an empty
/// path.
#[wasm_bindgen]
pub fn path_bounds(exact: bool) -> usize {
    arena::with(|a| {
        let (path, _) = path(a);
        let bounds = if exact {
            path.bounds()
        } else {
            path.control_bounds()
        };
        bounds.map_or(0, |bounds| a.write(0, &[bounds.min, bounds.max]))
    })
}

/// The signed area inside.
#[wasm_bindgen]
pub fn path_area() -> f64 {
    arena::with(|a| path(a).0.area())
}

/// Writes the integrals of 1, x, y, x², xy and y² over the inside.
#[wasm_bindgen]
pub fn path_moments() -> usize {
    arena::with(|a| {
        let m = path(a).0.moments();
        a.write_numbers(0, &[m.area, m.x, m.y, m.xx, m.xy, m.yy])
    })
}

/// Writes the length; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn path_length(tolerance: f64) -> isize {
    arena::answer(|a| {
        let path = path(a).0;
        let length = within(
            tolerance,
            || path.length(),
            |error| path.length_within(error),
        )?;
        Ok(a.write_numbers(0, &[length]))
    })
}

/// Arguments: a point after the path. Writes the subpath, t, the nearest point and its distance; returns 0 for an empty
/// path.
#[wasm_bindgen]
pub fn path_nearest() -> isize {
    arena::answer(|a| {
        let (path, end) = path(a);
        let nearest = path.nearest(DVec2::new(a.number(end), a.number(end + 1)))?;
        Ok(nearest.map_or(0, |n| {
            a.write_numbers(
                0,
                &[n.subpath as f64, n.t, n.point.x, n.point.y, n.distance],
            )
        }))
    })
}

/// Writes the arc lengths from the start of the path to the end of each segment, after a 0.
#[wasm_bindgen]
pub fn path_segment_ends() -> usize {
    arena::with(|a| {
        let path = path(a).0;
        let lengths = SegmentIndex::new(&path).lengths();
        a.write_numbers(0, lengths.ends())
    })
}

/// Writes the subpath and t at an arc length; a tolerance of 0 stands for the default. Returns 0 for an empty path.
#[wasm_bindgen]
pub fn path_time_at_length(s: f64, tolerance: f64) -> isize {
    arena::answer(|a| {
        let path = path(a).0;
        let time = within(
            tolerance,
            || path.time_at_length(s),
            |error| path.time_at_length_within(s, error),
        )?;
        Ok(write_times(a, time.as_slice()))
    })
}

/// Writes the subpaths and parameters of equidistant positions.
#[wasm_bindgen]
pub fn path_equidistant_times(segments: usize) -> isize {
    arena::answer(|a| {
        let times = path(a).0.equidistant_times(segments)?;
        Ok(write_times(a, &times))
    })
}

fn write_times(a: &mut Arena, times: &[PathTime]) -> usize {
    times.iter().fold(0, |at, time| {
        a.write_numbers(at, &[time.subpath as f64, time.t])
    })
}

/// Arguments: one path, or, if `two`, two paths, one after the other. Writes for each intersection or self-intersection
/// the numbers of an intersection and both subpaths.
#[wasm_bindgen]
pub fn path_intersect(two: bool) -> usize {
    arena::with(|a| {
        let (first, end) = path_at(a, 0);
        let found = if two {
            first.intersections(&path_at(a, end).0)
        } else {
            first.self_intersections()
        };
        found.iter().fold(0, |at, location| {
            let PathIntersection {
                t, u, point, kind, ..
            } = *location;
            let at = write_intersection(a, at, Intersection { t, u, point, kind });
            a.write_numbers(
                at,
                &[location.subpath as f64, location.other_subpath as f64],
            )
        })
    })
}

/// The winding number of a point.
#[wasm_bindgen]
pub fn path_winding_number(x: f64, y: f64) -> i32 {
    arena::with(|a| path(a).0.winding_number(DVec2::new(x, y)))
}

/// The crossings of a curve with the ray from a point to the right, see `path_winding_number`.
#[wasm_bindgen]
pub fn curve_crossings(count: usize, x: f64, y: f64) -> i32 {
    arena::with(|a| crossings(a.points(0, count), DVec2::new(x, y)))
}

/// Writes for each subpath the number of its vertices, the vertices and their parameters; returns the number of f64.
#[wasm_bindgen]
pub fn path_flatten(tolerance: f64) -> isize {
    arena::answer(|a| {
        let mut splines = Vec::new();
        each(a, |spline| splines.push(spline));
        let (mut at, mut vertices) = (0, 0);
        for spline in splines {
            let line = spline.flatten(tolerance)?;
            vertices += line.ts.len();
            if vertices > MAX_VERTICES {
                return Err(Error::too_many("vertices", MAX_VERTICES, vertices));
            }
            at = a.write_numbers(at, &[line.ts.len() as f64]);
            at = a.write_from_space(at, &line.points, 2);
            at = a.write_numbers(at, &line.ts);
        }
        Ok(at)
    })
}

/// Returns an error for a tolerance that coordinates up to `size` cannot resolve, otherwise 0.
#[wasm_bindgen]
pub fn path_check_tolerance(tolerance: f64, size: f64) -> isize {
    arena::encode_result(check_tolerance(tolerance, size).map(|()| 0))
}

/// Writes the cubics that approximate a plane curve of a higher degree, six coordinates each; returns the number of
/// f64.
#[wasm_bindgen]
pub fn curve_cubics(count: usize, tolerance: f64) -> usize {
    struct Cubics(Vec<DVec2>);
    impl PathSink for Cubics {
        fn move_to(&mut self, _: DVec2) {}
        fn line_to(&mut self, _: DVec2) {}
        fn quad_to(&mut self, _: DVec2, _: DVec2) {}
        fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
            self.0.extend([p1, p2, p]);
        }
        fn close(&mut self) {}
    }
    arena::with(|a| {
        let curve = Curve::<DVec3>::from_points(a.points_in_space(0, count, 2));
        let mut cubics = Cubics(Vec::new());
        curve.trace_on(&mut cubics, optional(tolerance));
        a.write(0, &cubics.0)
    })
}
