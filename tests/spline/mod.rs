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
mod refusals;

use crate::support::{Rng, Space, changed, random_points};
use casteljau::glam::DVec3;
use casteljau::spline::{Continuity, JointMode};
use casteljau::{Point, Spline};

/// The number of control points.
fn count(degrees: &[usize], closed: bool) -> usize {
    degrees.iter().sum::<usize>() + usize::from(!closed)
}

/// A random spline with these degrees.
fn random<P: Space>(rng: &mut Rng, degrees: &[usize], closed: bool) -> Spline<P> {
    let points = random_points(rng, count(degrees, closed));
    Spline::with_degrees(points, degrees, closed).expect("a spline")
}

/// A random spline in space of each structure, open and closed.
fn each_spline(seed: u64, mut check: impl FnMut(&Spline<DVec3>, &[usize])) {
    let mut rng = Rng(seed);
    for degrees in STRUCTURES {
        for closed in [false, true] {
            check(&random(&mut rng, degrees, closed), degrees);
        }
    }
}

/// The control points of segment k by the definition, without the code under test.
fn control<P: Point>(points: &[P], degrees: &[usize], k: usize) -> Vec<P> {
    let from: usize = degrees[..k].iter().sum();
    let at = |i: usize| points[(from + i) % points.len()];
    (0..=degrees[k]).map(at).collect()
}

fn joints<P: Point>(spline: &Spline<P>) -> std::ops::Range<usize> {
    usize::from(!spline.is_closed())..spline.segment_count()
}

/// The index of the point of a joint.
fn index_of<P: Point>(spline: &Spline<P>, joint: usize) -> usize {
    spline.degrees()[..joint].iter().sum()
}

fn continuity<P: Point>(spline: &Spline<P>, joint: usize, tolerance: Option<f64>) -> Continuity {
    let found = match tolerance {
        None => spline.continuity(joint),
        Some(tolerance) => spline.continuity_within(joint, tolerance),
    };
    found.expect("a joint")
}

/// The control points after a point is moved, all joints in one mode.
fn moved<P: Point>(spline: &Spline<P>, index: usize, to: P, mode: JointMode) -> Spline<P> {
    changed(spline, |s| s.move_point(index, to, |_| mode)).expect("a point")
}

/// Sets all joints to a mode, one after the other, the first joint of a closed spline at the end.
fn smooth<P: Space>(rng: &mut Rng, degrees: &[usize], closed: bool, mode: JointMode) -> Spline<P> {
    let mut spline = random(rng, degrees, closed);
    for joint in (1..degrees.len()).chain(closed.then_some(0)) {
        spline = spline.set_joint(joint, mode).expect("a joint");
    }
    spline
}

fn is_finite<P: Point>(spline: &Spline<P>) -> bool {
    let points = spline.control_points();
    points.iter().all(|p| p.max_abs().is_finite())
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
