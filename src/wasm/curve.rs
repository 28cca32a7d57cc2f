//! Bindings of curves. In: `count` control points at the start of the arena, further arguments behind them.

use super::arena::{self, Arena};
use super::by_dimension;
use super::error::refuse;
use super::pen::CanvasPen;
use crate::curve::{Basis, Curve, Points, Subdivision, bernstein, evaluate};
use crate::point::Point;
use glam::{DAffine2, DAffine3, DMat2, DMat3, DVec2, DVec3};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

fn curve<P: Point>(arena: &Arena, count: usize) -> Curve<P> {
    Curve::from_slice(arena.points(0, count))
}

fn put_two<P: Point>(arena: &mut Arena, (left, right): (Curve<P>, Curve<P>)) {
    let end = arena.put(0, left.control_points());
    arena.put(end, right.control_points());
}

/// Leaves the point at t.
#[wasm_bindgen]
pub fn curve_eval(dimension: usize, count: usize, t: f64) {
    arena::with(
        |a| by_dimension!(dimension, P => { let p: P = evaluate(a.points(0, count), t); a.put_point(p) }),
    );
}

/// Leaves `segments` + 1 points; their number of f64.
#[wasm_bindgen]
pub fn curve_sample(dimension: usize, count: usize, segments: usize) -> Result<usize, JsValue> {
    crate::curve::check_segments(segments, dimension).map_err(refuse)?;
    arena::with(
        |a| by_dimension!(dimension, P => curve::<P>(a, count).sample_into(a.place(segments + 1))),
    );
    Ok((segments + 1) * dimension)
}

/// In: `number` parameters behind the points. Leaves their points.
#[wasm_bindgen]
pub fn curve_eval_at(dimension: usize, count: usize, number: usize) -> usize {
    arena::with(|a| {
        by_dimension!(dimension, P => {
            let points = curve::<P>(a, count).eval_at(a.numbers(count * dimension, number));
            a.put(0, &points)
        })
    })
}

/// Leaves the control points of the derivative.
#[wasm_bindgen]
pub fn curve_derivative(dimension: usize, count: usize) -> usize {
    arena::with(
        |a| by_dimension!(dimension, P => { let c = curve::<P>(a, count).derivative(); a.put(0, c.control_points()) }),
    )
}

/// Leaves the k-th derivative at t.
#[wasm_bindgen]
pub fn curve_derivative_at(dimension: usize, count: usize, t: f64, k: usize) {
    arena::with(
        |a| by_dimension!(dimension, P => { let d = curve::<P>(a, count).derivative_at(t, k); a.put_point(d) }),
    );
}

/// Leaves the unit tangent at t.
#[wasm_bindgen]
pub fn curve_tangent(dimension: usize, count: usize, t: f64) {
    arena::with(
        |a| by_dimension!(dimension, P => { let d = curve::<P>(a, count).tangent(t); a.put_point(d) }),
    );
}

/// Leaves the unit normal at t.
#[wasm_bindgen]
pub fn curve_normal(dimension: usize, count: usize, t: f64) {
    arena::with(
        |a| by_dimension!(dimension, P => { let d = curve::<P>(a, count).normal(t); a.put_point(d) }),
    );
}

/// The curvature at t.
#[wasm_bindgen]
pub fn curve_curvature(dimension: usize, count: usize, t: f64) -> f64 {
    arena::with(|a| by_dimension!(dimension, P => curve::<P>(a, count).curvature(t)))
}

/// Leaves the control points of both pieces.
#[wasm_bindgen]
pub fn curve_split(dimension: usize, count: usize, t: f64) {
    arena::with(
        |a| by_dimension!(dimension, P => { let pieces = curve::<P>(a, count).split(t); put_two(a, pieces) }),
    );
}

/// Leaves the control points of both halves.
#[wasm_bindgen]
pub fn curve_halve(dimension: usize, count: usize) {
    arena::with(
        |a| by_dimension!(dimension, P => { let pieces = curve::<P>(a, count).halve(); put_two(a, pieces) }),
    );
}

/// Leaves the control points of the piece.
#[wasm_bindgen]
pub fn curve_subsegment(dimension: usize, count: usize, t0: f64, t1: f64) {
    arena::with(|a| {
        by_dimension!(dimension, P => {
            let piece = curve::<P>(a, count).subsegment(t0, t1);
            a.put(0, piece.control_points());
        });
    });
}

/// Leaves the control points of the elevated curve.
#[wasm_bindgen]
pub fn curve_elevate(dimension: usize, count: usize) -> Result<usize, JsValue> {
    arena::with(|a| {
        by_dimension!(dimension, P => {
            let raised = curve::<P>(a, count).elevate().map_err(refuse)?;
            Ok(a.put(0, raised.control_points()))
        })
    })
}

/// Leaves all levels of de Casteljau's triangle, one after the other.
#[wasm_bindgen]
pub fn curve_scaffold(dimension: usize, count: usize, t: f64) -> usize {
    arena::with(|a| {
        by_dimension!(dimension, P => {
            let levels = curve::<P>(a, count).scaffold(t);
            levels.iter().fold(0, |at, level| a.put(at, level))
        })
    })
}

/// Leaves the Bernstein weights.
#[wasm_bindgen]
pub fn bernstein_weights(degree: usize, t: f64) -> Result<usize, JsValue> {
    let weights = bernstein(degree, t).map_err(refuse)?;
    Ok(arena::with(|a| a.put_numbers(0, &weights)))
}

/// Leaves the matrix of a basis: 0 Bézier, 1 Hermite, 2 B-spline, 3 Catmull-Rom.
#[wasm_bindgen]
pub fn basis_matrix(kind: usize) -> usize {
    let basis = [
        Basis::Bezier,
        Basis::Hermite,
        Basis::BSpline,
        Basis::CatmullRom,
    ][kind.min(3)];
    arena::with(|a| a.put_numbers(0, &basis.matrix()))
}

/// In: a basis matrix behind four geometry points. Leaves the Bézier points, or the reverse.
#[wasm_bindgen]
pub fn curve_change_basis(
    dimension: usize,
    count: usize,
    from_bezier: bool,
) -> Result<usize, JsValue> {
    arena::with(|a| {
        let mut matrix = [0.0; 16];
        matrix.copy_from_slice(a.numbers(count * dimension, 16));
        by_dimension!(dimension, P => {
            let points = if from_bezier {
                Points::from(curve::<P>(a, count).to_basis(Basis::Matrix(matrix)).map_err(refuse)?)
            } else {
                let geometry = a.points::<P>(0, 4);
                let geometry = [geometry[0], geometry[1], geometry[2], geometry[3]];
                Points::from_slice(Curve::from_basis(Basis::Matrix(matrix), geometry).map_err(refuse)?.control_points())
            };
            Ok(a.put(0, &points))
        })
    })
}

/// Leaves the points and then the parameters of a polyline; the number of its vertices.
#[wasm_bindgen]
pub fn curve_flatten(dimension: usize, count: usize, tolerance: f64) -> Result<usize, JsValue> {
    arena::with(|a| {
        by_dimension!(dimension, P => {
            let line = curve::<P>(a, count).flatten(tolerance).map_err(refuse)?;
            let end = a.put(0, &line.points);
            a.put_numbers(end, &line.ts);
            Ok(line.ts.len())
        })
    })
}

/// Leaves the tree of halvings in preorder: t0, t1, D1, D2, 1 if halved (else 0), control points; their number of f64.
#[wasm_bindgen]
pub fn curve_subdivide(dimension: usize, count: usize, tolerance: f64) -> Result<usize, JsValue> {
    fn put<P: Point>(a: &mut Arena, at: usize, node: &Subdivision<P>) -> usize {
        let halved = if node.halves.is_some() { 1.0 } else { 0.0 };
        let at = a.put_numbers(
            at,
            &[
                node.t0,
                node.t1,
                node.polygon_length,
                node.chord_length,
                halved,
            ],
        );
        let at = a.put(at, node.curve.control_points());
        node.halves
            .iter()
            .flat_map(|halves| halves.iter())
            .fold(at, |at, half| put(a, at, half))
    }
    arena::with(|a| {
        by_dimension!(dimension, P => {
            let tree = curve::<P>(a, count).subdivide(tolerance).map_err(refuse)?;
            Ok(put(a, 0, &tree))
        })
    })
}

/// Leaves the least and the greatest corner, of the curve or of its control points.
#[wasm_bindgen]
pub fn curve_bounds(dimension: usize, count: usize, exact: bool) {
    arena::with(|a| {
        by_dimension!(dimension, P => {
            let curve = curve::<P>(a, count);
            let bounds = if exact { curve.bounds() } else { curve.control_bounds() };
            a.put(0, &[bounds.min, bounds.max]);
        });
    });
}

/// Leaves the corners of the convex hull.
#[wasm_bindgen]
pub fn curve_hull(count: usize) -> usize {
    arena::with(|a| {
        let hull = curve::<DVec2>(a, count).hull();
        a.put(0, &hull)
    })
}

/// In: an affine map behind any number of points, in columns: 6 numbers in 2D, 12 in 3D. Leaves the images.
#[wasm_bindgen]
pub fn points_transform(dimension: usize, count: usize) {
    arena::with(|a| {
        let m = a.numbers(count * dimension, if dimension == 3 { 12 } else { 6 });
        if dimension == 3 {
            let column = |i: usize| DVec3::from_slice(&m[i..i + 3]);
            let map = DAffine3::from_mat3_translation(
                DMat3::from_cols(column(0), column(3), column(6)),
                column(9),
            );
            a.place::<DVec3>(count)
                .iter_mut()
                .for_each(|p| *p = p.transform(&map));
        } else {
            let column = |i: usize| DVec2::new(m[i], m[i + 1]);
            let map =
                DAffine2::from_mat2_translation(DMat2::from_cols(column(0), column(2)), column(4));
            a.place::<DVec2>(count)
                .iter_mut()
                .for_each(|p| *p = p.transform(&map));
        }
    });
}

/// Draws a 2D curve on a context or a path; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn curve_trace(count: usize, target: &JsValue, tolerance: f64) -> Result<(), JsValue> {
    let curve = arena::with(|a| curve::<DVec2>(a, count));
    curve
        .trace(
            &mut CanvasPen::new(target),
            (tolerance > 0.0).then_some(tolerance),
        )
        .map_err(refuse)
}
