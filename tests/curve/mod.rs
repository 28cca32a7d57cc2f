//! Properties of every curve, natively and in wasm, compared with closed forms and exact arithmetic.

mod basis;
mod convert;
mod copy;
mod eval;
mod limits;
mod pieces;
mod refusals;
mod shape;
mod slope;
mod subdivide;
mod trace;

use crate::support::adversarial::{self, Kind};
use crate::support::{Rng, real, ulp};
use casteljau::glam::DVec3;

/// Hostile control points of each kind, in the plane and in space, at low degrees and some high ones.
fn adversarial_points(kinds: &[Kind], mut check: impl FnMut(&[DVec3])) {
    let mut rng = Rng(1963);
    for &kind in kinds {
        for degree in [1, 2, 3, 4, 5, 8, 13, 33, 64] {
            let low = if cfg!(target_family = "wasm") { 2 } else { 6 };
            let rounds = if degree <= 8 { low } else { 1 };
            for round in 0..rounds {
                check(&adversarial::points(&mut rng, kind, degree, 2 + round % 2));
            }
        }
    }
}

/// Asserts that each coordinate of two points agrees to a number of ulps of a size.
fn near(got: DVec3, expected: DVec3, ulps: f64, size: f64) {
    let difference = (got - expected).abs().max_element();
    let found = difference / ulp(size);
    assert!(
        difference <= ulps * ulp(size),
        "{got:?} instead of {expected:?}: {found} ulps"
    );
}

/// The number of ulps of the largest coordinate that n steps of interpolation may lose.
fn steps(points: &[DVec3]) -> f64 {
    2.0 + real(points.len())
}

/// Parameters outside of [0, 1], and the factor (|t| + |1 − t|)ⁿ by which they enlarge coordinates and rounding errors.
fn outside(points: &[DVec3]) -> [(f64, f64); 2] {
    let growth = (1..points.len()).fold(1.0, |growth, _| 2.0 * growth);
    [(-0.5, growth), (1.5, growth)]
}
