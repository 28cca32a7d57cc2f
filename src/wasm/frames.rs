//! Bindings of the torsion and of frames of curves and splines in space.

use super::arena;
use super::arena::Arena;
use super::spline::spline;
use crate::curve::Curve;
use crate::curve::frames::Frame;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

fn curve(a: &Arena, count: usize) -> Curve<DVec3> {
    Curve::from_slice(a.points(0, count))
}

/// The torsion at t of a 3D curve.
#[wasm_bindgen]
pub fn curve_torsion(count: usize, t: f64) -> f64 {
    arena::with(|a| curve(a, count).torsion(t))
}

/// Arguments: `number` parameters after the points of a 3D curve, then, if `wanted`, a first normal. Writes all points,
/// then all tangents, normals and binormals; returns the number of frames.
#[wasm_bindgen]
pub fn curve_frames(count: usize, number: usize, wanted: bool) -> isize {
    arena::answer(|a| {
        let (ts, normal) = parameters_and_normal(a, 3 * count, number, wanted);
        let frames = curve(a, count).frames_at(&ts, normal)?;
        Ok(write_frames(a, &frames))
    })
}

/// `curve_frames` for a spline.
#[wasm_bindgen]
pub fn spline_frames(number: usize, wanted: bool) -> isize {
    arena::answer(|a| {
        let (spline, end) = spline(a, 3);
        let (ts, normal) = parameters_and_normal(a, end, number, wanted);
        let frames = spline.frames_at(&ts, normal)?;
        Ok(write_frames(a, &frames))
    })
}

fn parameters_and_normal(
    a: &Arena,
    at: usize,
    number: usize,
    wanted: bool,
) -> (Vec<f64>, Option<DVec3>) {
    let normal = wanted.then(|| a.point_in_space(at + number, 3));
    (a.numbers(at, number).to_vec(), normal)
}

fn write_frames(a: &mut Arena, frames: &[Frame]) -> usize {
    let kinds: [fn(&Frame) -> DVec3; 4] =
        [|f| f.point, |f| f.tangent, |f| f.normal, |f| f.binormal];
    let mut at = 0;
    for kind in kinds {
        let vectors: Vec<DVec3> = frames.iter().map(kind).collect();
        at = a.write_from_space(at, &vectors, 3);
    }
    frames.len()
}
