//! Tight bounding boxes of rational patches.
//!
//! The minimum c of a quotient A/w is the c for which the minimum of the polynomial A − cw is 0. Starting with the value at a
//! point, the value at the minimum of A − cw is the next c; it falls until rounding stops it, and the steps converge faster
//! than linearly. Source: Dinkelbach, "On nonlinear fractional programming", *Management Science* 13 (1967).

use super::RationalPatch;
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use crate::patch::Patch;
use crate::surface::minimum::{Objective, minimise};
use crate::surface::piece::PolynomialPiece;
use glam::DVec3;
use std::borrow::Borrow;

/// More steps than it takes to converge, for weights of any ratio that leaves digits.
const MAX_STEPS: usize = 32;

/// The smallest box that contains all patches; `None` without patches.
pub(in crate::rational) fn bounds_of(
    patches: impl Iterator<Item = impl Borrow<RationalPatch>>,
) -> Option<Bounds<DVec3>> {
    patches.fold(None, |all: Option<Bounds<DVec3>>, patch| {
        let patch = patch.borrow();
        let control = patch.control_bounds();
        match all {
            Some(all) if all.contains(control.min) && all.contains(control.max) => Some(all),
            Some(all) => Some(all.union(patch.bounds())),
            None => Some(patch.bounds()),
        }
    })
}

impl RationalPatch {
    /// The smallest axis-aligned box that contains the patch.
    ///
    /// It is exact to rounding, about 1e-15 of the size along each axis. Each of its six faces takes a few searches of at most
    /// 2²³ steps (2²⁶ above degree 24), as those of [`Patch::bounds`]; [`control_bounds`](Self::control_bounds) is cheaper and
    /// larger.
    pub fn bounds(&self) -> Bounds<DVec3> {
        let mut bounds = self.control_bounds();
        for axis in 0..3 {
            let [min, max] = [bounds.min, bounds.max].map(|p| p.coordinate(axis));
            let size = max - min;
            if size > 0.0 {
                let (low, high) = (self.face(axis, 1.0, size), -self.face(axis, -1.0, size));
                bounds.min = bounds.min.with_coordinate(axis, low.max(min));
                bounds.max = bounds.max.with_coordinate(axis, high.min(max));
            }
        }
        bounds
    }

    /// The minimum of a coordinate multiplied by the sign 1 or −1, where the control points have the given extent.
    fn face(&self, axis: usize, sign: f64, size: f64) -> f64 {
        let at = |[u, v]: [f64; 2]| sign * self.eval(u, v).coordinate(axis);
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(at);
        let mut best = corners.into_iter().fold(f64::INFINITY, f64::min);
        for _ in 0..MAX_STEPS {
            let origin = DVec3::ZERO.with_coordinate(axis, sign * best);
            let (mut numerator, _) = self.numerator_and_denominator(origin);
            for p in &mut numerator.points {
                *p = DVec3::X * (sign * p.coordinate(axis) / size);
            }
            let coefficients = numerator.points.iter().map(|p| p.x).collect();
            let whole =
                PolynomialPiece::whole(0, numerator.columns, numerator.rows(), coefficients);
            let Some((min, _)) = minimise(&[whole], &Coordinate(numerator)) else {
                break;
            };
            let next = at([min.u, min.v]);
            if next >= best {
                break;
            }
            best = next;
        }
        best
    }
}

/// The x-coordinate of a polynomial patch.
struct Coordinate(Patch);

impl Objective for Coordinate {
    fn value(&self, _index: usize, [u, v]: [f64; 2]) -> f64 {
        self.0.eval(u, v).x
    }
}
