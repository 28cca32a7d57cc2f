//! Bindings of curves. Arguments: `count` control points at the start of the arena, followed by further arguments.

use super::arena;
use super::arena::Arena;
use super::by_dimension;
use crate::bernstein::evaluate::{evaluate, weigh4};
use crate::bernstein::polynomials::bernstein;
use crate::curve::Curve;
use crate::curve::basis::Basis;
use crate::curve::subdivide::Subdivision;
use crate::geometry::check::images;
use crate::geometry::point::Point;
use bytemuck::Pod;
use casteljau_kernels::bernstein::de_casteljau::split_net_with;
use glam::{DAffine3, DVec2, DVec3};
use wasm_bindgen::prelude::wasm_bindgen;

fn curve<P: Point + Pod>(arena: &Arena, count: usize) -> Curve<P> {
    Curve::from_slice(arena.points(0, count))
}

/// Decodes a curve as 3D; see [`Arena::points_in_space`].
fn curve_in_space(arena: &Arena, dimension: usize, count: usize) -> Curve<DVec3> {
    Curve::from_points(arena.points_in_space(0, count, dimension))
}

fn write_curves(arena: &mut Arena, dimension: usize, curves: &[&Curve<DVec3>]) -> usize {
    curves.iter().fold(0, |at, curve| {
        arena.write_from_space(at, curve.control_points(), dimension)
    })
}

/// Writes the point at t.
#[wasm_bindgen]
pub fn curve_eval(dimension: usize, count: usize, t: f64) {
    arena::with(
        |a| by_dimension!(dimension, P => { let p: P = evaluate(a.points(0, count), t); a.write_point(p) }),
    );
}

/// One coordinate at t of a cubic with the given control values. The most frequent call; it does not use the arena, and
/// it is exported without `wasm_bindgen`, whose wrapper, compiled for size, would take longer than the formula.
#[unsafe(no_mangle)]
pub extern "C" fn cubic_eval(a: f64, b: f64, c: f64, d: f64, t: f64) -> f64 {
    weigh4([a, b, c, d], t)
}

/// Writes `segments` + 1 points; returns the number of f64.
#[wasm_bindgen]
pub fn curve_sample(dimension: usize, count: usize, segments: usize) -> isize {
    arena::answer(|a| {
        crate::curve::eval::check_segments(segments, dimension)?;
        by_dimension!(dimension, P => curve::<P>(a, count).sample_into(a.reserve(segments + 1)));
        Ok((segments + 1) * dimension)
    })
}

/// Arguments: `number` parameters after the points. Writes the points at the parameters.
#[wasm_bindgen]
pub fn curve_eval_at(dimension: usize, count: usize, number: usize) -> usize {
    arena::with(|a| {
        let points =
            curve_in_space(a, dimension, count).eval_at(a.numbers(count * dimension, number));
        a.write_from_space(0, &points, dimension)
    })
}

/// Writes the control points of the derivative.
#[wasm_bindgen]
pub fn curve_derivative(dimension: usize, count: usize) -> usize {
    arena::with(|a| {
        let derivative = curve_in_space(a, dimension, count).derivative();
        write_curves(a, dimension, &[&derivative])
    })
}

/// Writes the k-th derivative at t.
#[wasm_bindgen]
pub fn curve_derivative_at(dimension: usize, count: usize, t: f64, k: usize) {
    arena::with(|a| a.write_point(curve_in_space(a, dimension, count).derivative_at(t, k)));
}

/// Writes the unit tangent at t.
#[wasm_bindgen]
pub fn curve_tangent(dimension: usize, count: usize, t: f64) {
    arena::with(|a| a.write_point(curve_in_space(a, dimension, count).tangent(t)));
}

/// Writes the unit normal at t.
#[wasm_bindgen]
pub fn curve_normal(dimension: usize, count: usize, t: f64) {
    arena::with(|a| {
        let curve = curve_in_space(a, dimension, count);
        let turned = || DVec2::normal_of(curve.tangent(t).truncate(), DVec2::ZERO).extend(0.0);
        a.write_point(if dimension == 2 {
            turned()
        } else {
            curve.normal(t)
        });
    });
}

/// The curvature at t; signed in the plane.
#[wasm_bindgen]
pub fn curve_curvature(dimension: usize, count: usize, t: f64) -> f64 {
    arena::with(|a| {
        let curve = curve_in_space(a, dimension, count);
        let clockwise = dimension == 2 && curve.tangent(t).cross(curve.normal(t)).z < 0.0;
        if clockwise {
            -curve.curvature(t)
        } else {
            curve.curvature(t)
        }
    })
}

/// Writes the control points of both parts.
#[wasm_bindgen]
pub fn curve_split(dimension: usize, count: usize, t: f64) {
    arena::with(|a| {
        if !(0.0..=1.0).contains(&t) {
            let (before, after) = curve_in_space(a, dimension, count).split(t);
            write_curves(a, dimension, &[&before, &after]);
            return;
        }
        let (left, right) = a.two_outputs(count * dimension);
        // The rows are the points, the columns their coordinates.
        split_net_with(left, right, dimension, false, |a, b| a * (1.0 - t) + b * t);
    });
}

/// Writes the control points of the subsegment.
#[wasm_bindgen]
pub fn curve_subsegment(dimension: usize, count: usize, t0: f64, t1: f64) {
    arena::with(|a| {
        let piece = curve_in_space(a, dimension, count).part(t0, t1);
        write_curves(a, dimension, &[&piece]);
    });
}

/// Writes the control points of the elevated curve.
#[wasm_bindgen]
pub fn curve_elevate(dimension: usize, count: usize) -> isize {
    arena::answer(|a| {
        let raised = curve_in_space(a, dimension, count).elevate()?;
        Ok(write_curves(a, dimension, &[&raised]))
    })
}

/// Writes all levels of de Casteljau's algorithm, one after the other.
#[wasm_bindgen]
pub fn curve_de_casteljau(dimension: usize, count: usize, t: f64) -> usize {
    arena::with(|a| {
        let levels = curve_in_space(a, dimension, count).de_casteljau(t);
        levels
            .iter()
            .fold(0, |at, level| a.write_from_space(at, level, dimension))
    })
}

/// Writes the Bernstein weights.
#[wasm_bindgen]
pub fn bernstein_weights(degree: usize, t: f64) -> isize {
    arena::answer(|a| Ok(a.write_numbers(0, &bernstein(degree, t)?)))
}

/// Writes the matrix of a basis: 0 Bézier, 1 Hermite, 2 B-spline, 3 Catmull-Rom.
#[wasm_bindgen]
pub fn basis_matrix(kind: usize) -> usize {
    let basis = [
        Basis::Bezier,
        Basis::Hermite,
        Basis::BSpline,
        Basis::CatmullRom,
    ][kind.min(3)];
    arena::with(|a| a.write_numbers(0, &basis.matrix()))
}

fn matrix_behind(a: &Arena, dimension: usize, count: usize) -> Basis {
    let mut matrix = [0.0; 16];
    matrix.copy_from_slice(a.numbers(count * dimension, 16));
    Basis::Matrix(matrix)
}

/// Arguments: four geometry points and a basis matrix. Writes the control points.
#[wasm_bindgen]
pub fn curve_from_basis(dimension: usize) -> isize {
    arena::answer(|a| {
        let points = [0, 1, 2, 3].map(|k| a.point_in_space(k * dimension, dimension));
        let curve = Curve::from_basis(matrix_behind(a, dimension, 4), points)?;
        Ok(write_curves(a, dimension, &[&curve]))
    })
}

/// Arguments: a basis matrix after the control points. Writes the four geometry points.
#[wasm_bindgen]
pub fn curve_to_basis(dimension: usize, count: usize) -> isize {
    arena::answer(|a| {
        let basis = matrix_behind(a, dimension, count);
        let points = curve_in_space(a, dimension, count).to_basis(basis)?;
        Ok(a.write_from_space(0, &points, dimension))
    })
}

/// Writes the points, then the parameters of a polyline; returns the number of vertices.
#[wasm_bindgen]
pub fn curve_flatten(dimension: usize, count: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let line = curve_in_space(a, dimension, count).flatten(tolerance)?;
        let end = a.write_from_space(0, &line.points, dimension);
        a.write_numbers(end, &line.ts);
        Ok(line.ts.len())
    })
}

/// Writes the tree of halvings in preorder: t0, t1, D1, D2, the bound on the deviation, 1 if
/// halved (else 0), control points; returns the number of f64.
#[wasm_bindgen]
pub fn curve_subdivide(dimension: usize, count: usize, tolerance: f64) -> isize {
    fn write(a: &mut Arena, dimension: usize, at: usize, node: &Subdivision<DVec3>) -> usize {
        let halved = if node.halves.is_some() { 1.0 } else { 0.0 };
        let head = [
            node.t0,
            node.t1,
            node.polygon_length,
            node.chord_length,
            node.deviation_bound(),
            halved,
        ];
        let at = a.write_numbers(at, &head);
        let at = a.write_from_space(at, node.curve.control_points(), dimension);
        node.halves
            .iter()
            .flat_map(|halves| halves.iter())
            .fold(at, |at, half| write(a, dimension, at, half))
    }
    arena::answer(|a| {
        let tree = curve_in_space(a, dimension, count).subdivide(tolerance)?;
        Ok(write(a, dimension, 0, &tree))
    })
}

/// Writes the minimum and the maximum corner of the box of the curve or of its control points.
#[wasm_bindgen]
pub fn curve_bounds(dimension: usize, count: usize, exact: bool) {
    arena::with(|a| {
        let curve = curve_in_space(a, dimension, count);
        let bounds = if exact {
            curve.bounds()
        } else {
            curve.control_bounds()
        };
        a.write_from_space(0, &[bounds.min, bounds.max], dimension);
    });
}

/// Writes the corners of the convex hull.
#[wasm_bindgen]
pub fn curve_hull(count: usize) -> usize {
    arena::with(|a| {
        let hull = curve::<DVec2>(a, count).hull();
        a.write(0, &hull)
    })
}

/// Arguments: an affine map after any number of points, as four columns of 3 numbers. Writes the images of the points.
#[wasm_bindgen]
pub fn points_transform(dimension: usize, count: usize) -> isize {
    arena::answer(|a| {
        let map = DAffine3::from_cols_slice(a.numbers(count * dimension, 12));
        let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
        let images = images(&points, &map)?;
        Ok(a.write_from_space(0, &images, dimension))
    })
}

/// The area that a plane curve sweeps.
#[wasm_bindgen]
pub fn curve_area(count: usize) -> f64 {
    arena::with(|a| curve_in_space(a, 2, count).area_xy())
}

/// Writes the error, then the control points of the curve with the degree reduced by one.
#[wasm_bindgen]
pub fn curve_reduce(dimension: usize, count: usize) -> usize {
    arena::with(|a| {
        let curve: Curve<DVec3> = Curve::from_points(a.points_in_space(0, count, dimension));
        let reduced = curve.reduce();
        let at = a.write_numbers(0, &[reduced.error]);
        a.write_from_space(at, reduced.curve.control_points(), dimension)
    })
}
