//! Bindings of operations on regions. Paths are passed as in `path.rs`, one after the other.

use super::arena;
use super::arena::Arena;
use super::path::path_at;
use crate::geometry::error::Error;
use crate::path::{BooleanOperation, FillRule, Path};
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
fn write_path(a: &mut Arena, at: usize, path: &Path) -> usize {
    let mut at = a.write_numbers(at, &[path.subpath_count() as f64]);
    for part in path.parts() {
        let closed = usize::from(part.closed);
        at = a.write_counts(at, [part.segment_count(), closed].into_iter());
        at = a.write_counts(at, part.segments().map(|points| points.len() - 1));
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
