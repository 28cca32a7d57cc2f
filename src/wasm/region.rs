//! Bindings of operations on regions. Paths are passed as in `path.rs`, one after the other.

use super::arena;
use super::arena::Arena;
use super::offset::offset_join;
use super::optional;
use super::path::path_at;
use crate::geometry::error::Error;
use crate::path::{
    BooleanOperation, CornerOptions, FillRule, OffsetOptions, Path, PathTime, StrokeCap,
    StrokeOptions, WidthInterpolation, WidthPosition, WidthProfile,
};
use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

fn fill_rule(even_odd: bool) -> FillRule {
    if even_odd {
        FillRule::EvenOdd
    } else {
        FillRule::NonZero
    }
}

/// The given number of paths from the start of the arena, and the index where the last one ends.
fn paths(a: &Arena, count: usize) -> (Vec<Path>, usize) {
    let mut at = 0;
    let paths = (0..count)
        .map(|_| {
            let (path, end) = path_at(a, at);
            at = end;
            path
        })
        .collect();
    (paths, at)
}

/// Writes a path in the form in which paths are passed; returns the end.
pub(super) fn write_path(a: &mut Arena, at: usize, path: &Path) -> usize {
    let mut at = a.write_numbers(at, &[path.subpath_count() as f64]);
    for part in path.parts() {
        let closed = usize::from(part.closed);
        at = a.write_counts(at, [part.segment_count(), closed].into_iter());
        at = a.write_counts(at, part.degrees());
        at = a.write(at, &part.points[..part.points.len() - closed]);
    }
    at
}

fn answer_path(compute: impl FnOnce(&Arena) -> Result<Path, Error>) -> isize {
    arena::answer(|a| {
        let path = compute(a)?;
        Ok(write_path(a, 0, &path))
    })
}

/// Writes the union (0), the intersection (1) or the symmetric difference (2) of the regions of `count` paths.
#[wasm_bindgen]
pub fn region_combine(operation: u32, count: usize, even_odd: bool) -> isize {
    let operation = match operation {
        0 => BooleanOperation::Union,
        1 => BooleanOperation::Intersect,
        _ => BooleanOperation::Exclude,
    };
    answer_path(|a| Path::combine(&paths(a, count).0, operation, fill_rule(even_odd)))
}

/// Writes the first region without the second one.
#[wasm_bindgen]
pub fn region_subtract(even_odd: bool) -> isize {
    answer_path(|a| {
        let (paths, _) = paths(a, 2);
        paths[0].subtract(&paths[1], fill_rule(even_odd))
    })
}

/// Writes for each bounded face whether each of the `count` paths contains it, 1 or 0, and the face.
#[wasm_bindgen]
pub fn region_faces(count: usize, even_odd: bool) -> isize {
    arena::answer(|a| {
        let faces = Path::faces(&paths(a, count).0, fill_rule(even_odd))?;
        Ok(faces.iter().fold(0, |at, face| {
            let at = a.write_counts(at, face.inside.iter().map(|&inside| usize::from(inside)));
            write_path(a, at, &face.path)
        }))
    })
}

/// Writes the parts into which the second path divides the region of the first one.
#[wasm_bindgen]
pub fn region_divide(even_odd: bool) -> isize {
    arena::answer(|a| {
        let (paths, _) = paths(a, 2);
        let parts = paths[0].divide(&paths[1], fill_rule(even_odd))?;
        Ok(parts.iter().fold(0, |at, part| write_path(a, at, part)))
    })
}

/// Writes the parts of the first path inside the region of the second one.
#[wasm_bindgen]
pub fn region_clip(even_odd: bool) -> isize {
    answer_path(|a| {
        let (paths, _) = paths(a, 2);
        paths[0].clip(&paths[1], fill_rule(even_odd))
    })
}

/// A cap by its index in `CAPS` of js/geometry/path/path-stroke.ts.
fn stroke_cap(index: u32) -> StrokeCap {
    match index {
        0 => StrokeCap::Butt,
        1 => StrokeCap::Round,
        _ => StrokeCap::Square,
    }
}

/// The path at the start of the arena, the options of its stroke and its widths: after the path, the miter limit, the
/// dash offset, the tolerance (0 for the default), `dashes` lengths, and `stops` pairs of a position and a width.
fn stroke_arguments(
    a: &Arena,
    join: u32,
    cap: u32,
    dashes: usize,
    stops: usize,
    kind: u32,
) -> (Path, StrokeOptions, WidthProfile) {
    let (path, end) = path_at(a, 0);
    let options = StrokeOptions {
        join: offset_join(join),
        miter_limit: a.number(end),
        cap: stroke_cap(cap),
        dash: a.numbers(end + 3, dashes).to_vec(),
        dash_offset: a.number(end + 1),
        tolerance: optional(a.number(end + 2)),
        simple: true,
    };
    let numbers = a.numbers(end + 3 + dashes, 2 * stops).chunks_exact(2);
    let profile = WidthProfile {
        at: if kind & 1 == 0 {
            WidthPosition::Length
        } else {
            WidthPosition::T
        },
        stops: numbers.map(|stop| (stop[0], stop[1])).collect(),
        interpolation: if kind & 2 == 0 {
            WidthInterpolation::Linear
        } else {
            WidthInterpolation::Smooth
        },
    };
    (path, options, profile)
}

/// Writes the region of a stroke of a constant width; see `stroke_arguments`.
#[wasm_bindgen]
pub fn region_stroke(width: f64, join: u32, cap: u32, dashes: usize, simple: bool) -> isize {
    answer_path(|a| {
        let (path, options, _) = stroke_arguments(a, join, cap, dashes, 0, 0);
        path.stroke(width, &StrokeOptions { simple, ..options })
    })
}

/// Writes the region of a stroke with different widths on both sides; see `stroke_arguments`.
#[wasm_bindgen]
pub fn region_stroke_sides(
    left: f64,
    right: f64,
    join: u32,
    cap: u32,
    dashes: usize,
    simple: bool,
) -> isize {
    answer_path(|a| {
        let (path, options, _) = stroke_arguments(a, join, cap, dashes, 0, 0);
        path.stroke_sides(left, right, &StrokeOptions { simple, ..options })
    })
}

/// Writes the region of a stroke of varying width; see `stroke_arguments`. Bit 0 of `kind`: positions by t, bit 1: smooth.
#[wasm_bindgen]
pub fn region_stroke_with(
    stops: usize,
    kind: u32,
    join: u32,
    cap: u32,
    dashes: usize,
    simple: bool,
) -> isize {
    answer_path(|a| {
        let (path, options, profile) = stroke_arguments(a, join, cap, dashes, stops, kind);
        path.stroke_with(&profile, &StrokeOptions { simple, ..options })
    })
}

/// Returns 1 if a point is in a stroke of a constant width, otherwise 0; see `stroke_arguments`.
#[wasm_bindgen]
pub fn region_stroke_contains(
    x: f64,
    y: f64,
    width: f64,
    join: u32,
    cap: u32,
    dashes: usize,
) -> isize {
    arena::answer(|a| {
        let (path, options, _) = stroke_arguments(a, join, cap, dashes, 0, 0);
        let contains = path.stroke_contains(DVec2::new(x, y), width, &options)?;
        Ok(usize::from(contains))
    })
}

/// Returns 1 if a point is in a stroke of varying width, otherwise 0; see `region_stroke_with`.
#[wasm_bindgen]
pub fn region_stroke_contains_with(
    x: f64,
    y: f64,
    stops: usize,
    kind: u32,
    join: u32,
    cap: u32,
    dashes: usize,
) -> isize {
    arena::answer(|a| {
        let (path, options, profile) = stroke_arguments(a, join, cap, dashes, stops, kind);
        let contains = path.stroke_contains_with(DVec2::new(x, y), &profile, &options)?;
        Ok(usize::from(contains))
    })
}

/// Writes the dashes of a path. Arguments: `count` lengths after the path.
#[wasm_bindgen]
pub fn region_dash(count: usize, offset: f64) -> isize {
    answer_path(|a| {
        let (path, end) = path_at(a, 0);
        path.dash(a.numbers(end, count), offset)
    })
}

/// Writes the region of a path, grown by a distance; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn region_offset(distance: f64, join: u32, miter_limit: f64, tolerance: f64) -> isize {
    answer_path(|a| {
        let options = OffsetOptions {
            join: offset_join(join),
            miter_limit,
            tolerance: optional(tolerance),
        };
        path_at(a, 0).0.offset(distance, &options)
    })
}

/// Writes lines and arcs that approximate a path: for each subpath their number, then start, end, centre, radius and
/// angles of each.
#[wasm_bindgen]
pub fn region_arcs(tolerance: f64) -> isize {
    arena::answer(|a| {
        let subpaths = path_at(a, 0).0.to_arcs(tolerance)?;
        let mut numbers = Vec::new();
        for arcs in subpaths {
            numbers.push(arcs.len() as f64);
            for arc in arcs {
                let center = arc.center.unwrap_or_default();
                let points = [arc.start, arc.end, center];
                numbers.extend(points.iter().flat_map(DVec2::to_array));
                numbers.extend([arc.radius, arc.start_angle, arc.end_angle]);
            }
        }
        Ok(a.write_numbers(0, &numbers))
    })
}

/// Writes the corners of a path that can be rounded, as pairs of a subpath and a joint.
#[wasm_bindgen]
pub fn region_corners() -> isize {
    arena::answer(|a| {
        let mut numbers = Vec::new();
        let add = |corner: PathTime| {
            numbers.extend([corner.subpath as f64, corner.t]);
            0.0
        };
        let _ = path_at(a, 0)
            .0
            .round_corners_by(add, &CornerOptions::new())?;
        Ok(a.write_numbers(0, &numbers))
    })
}

/// Writes a path with its corners rounded; a tolerance of 0 stands for the default. Arguments: `count` triples of a
/// subpath, a joint and a radius after the path; −1 stands for all corners with one radius.
#[wasm_bindgen]
pub fn region_round_corners(radius: f64, tolerance: f64, count: i32) -> isize {
    answer_path(|a| {
        let (path, end) = path_at(a, 0);
        let mut options = CornerOptions::new();
        options.tolerance = optional(tolerance);
        let Ok(count) = usize::try_from(count) else {
            return path.round_corners_with(radius, &options);
        };
        let places = (0..count).map(|k| end + 3 * k);
        let corners: Vec<PathTime> = places
            .clone()
            .map(|at| PathTime::new(a.count(at), a.number(at + 1)))
            .collect();
        let mut radii = places.map(|at| a.number(at + 2));
        path.round_corners_by(
            |_| radii.next().unwrap_or_default(),
            &options.corners(&corners),
        )
    })
}
