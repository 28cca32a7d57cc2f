//! Splines: construction, evaluation, joints, editing, natively and in wasm.

mod bspline;
mod build;
mod continuity;
mod cut;
mod interpolate;
mod joints;
mod measure;
mod move_point;
mod queries;

use crate::support::Rng;
use casteljau::Spline;
use casteljau::glam::{DVec2, DVec3};

/// A plane spline from pairs of coordinates.
fn plane(points: &[(f64, f64)], degree: usize, closed: bool) -> Spline<DVec2> {
    let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    Spline::new(&points, degree, closed).expect("a spline")
}

/// A random spline with these degrees.
fn random(rng: &mut Rng, degrees: &[usize], closed: bool) -> Spline<DVec3> {
    let count = degrees.iter().sum::<usize>() + usize::from(!closed);
    let points = (0..count).map(|_| rng.point(3)).collect();
    Spline::with_degrees(points, degrees, closed).expect("a spline")
}

/// The control points of segment k by the definition, without the code under test.
fn control(points: &[DVec3], degrees: &[usize], k: usize) -> Vec<DVec3> {
    let from: usize = degrees[..k].iter().sum();
    let at = |i: usize| points[(from + i) % points.len()];
    (0..=degrees[k]).map(at).collect()
}

const STRUCTURES: [&[usize]; 7] = [
    &[3],
    &[1, 1],
    &[2, 2, 2],
    &[3, 3, 3, 3],
    &[1, 2, 3, 4, 5],
    &[3, 1, 3],
    &[5, 64, 2],
];
