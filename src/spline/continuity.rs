//! Geometric and parametric continuity at joints.

use super::Spline;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::{CrossProduct, Point};

/// The default tolerance as a ratio of the largest extent of the two segments.
const DEFAULT_RATIO: f64 = 1e-9;

/// The continuity at a joint.
///
/// Cⁿ is parametric continuity (equal derivatives: the point moves smoothly along t), Gⁿ geometric continuity (the
/// drawn curve is smooth). Aligned handles alone give G1. For
/// equal degrees, aligned handles of equal length give C1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Continuity {
    /// The segments share their end point.
    pub c0: bool,
    /// The tangent directions are equal.
    pub g1: bool,
    /// The first derivatives are equal.
    pub c1: bool,
    /// The tangents and the curvatures are equal.
    pub g2: bool,
    /// The first and the second derivatives are equal.
    pub c2: bool,
    /// The distance between the two end points; always 0, because the segments of a spline share the point.
    pub gap: f64,
    /// The angle between the two tangents, 0 to π; 0 if a segment is a point.
    pub angle: f64,
}

impl<P: Point> Spline<P> {
    /// The continuity at the joint t = `joint`; a closed spline also has a joint 0.
    ///
    /// As [`continuity_within`](Self::continuity_within) with a tolerance of 10⁻⁹ of the extent of the two segments.
    ///
    /// # Errors
    /// [`Error::Index`] unless `joint` lies between two segments, [`Error::NoJoint`] for a single open segment.
    pub fn continuity(&self, joint: usize) -> Result<Continuity, Error> {
        self.continuity_at(joint, None)
    }

    /// The continuity at the joint t = `joint` within a tolerance; a closed spline also has a joint 0.
    ///
    /// The tolerance is a distance. Derivatives may differ by it. For G1 and G2 it bounds the distance of the tip of the
    /// shorter handle from the tangent or the osculating parabola of the other side. For handles of length zero the
    /// limit tangent is used.
    ///
    /// # Errors
    /// As [`continuity`](Self::continuity), and [`Error::Range`] unless the tolerance is above 0.
    pub fn continuity_within(&self, joint: usize, tolerance: f64) -> Result<Continuity, Error> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            self.check_joint(joint)?;
            return Err(Error::Range {
                what: "tolerance",
                expected: "a finite number above 0",
                got: tolerance,
            });
        }
        self.continuity_at(joint, Some(tolerance))
    }

    pub(crate) fn continuity_at(
        &self,
        joint: usize,
        tolerance: Option<f64>,
    ) -> Result<Continuity, Error> {
        self.check_joint(joint)?;
        let before = if joint == 0 {
            self.segment_count() - 1
        } else {
            joint - 1
        };
        let (left, right) = (self.curve(before), self.curve(joint));
        let tolerance = tolerance.unwrap_or_else(|| {
            let bounds = left.control_bounds().union(right.control_bounds());
            DEFAULT_RATIO * bounds.diagonal()
        });
        Ok(continuity_between(&left, &right, tolerance))
    }

    /// Returns an error unless `joint` is a joint; the ends of an open spline are not joints.
    pub(crate) fn check_joint(&self, joint: usize) -> Result<(), Error> {
        let (first, last) = (usize::from(!self.closed), self.segment_count() - 1);
        if first > last {
            return Err(Error::NoJoint);
        }
        if joint < first || joint > last {
            return Err(Error::Index {
                what: "joint",
                first,
                last,
                got: joint,
            });
        }
        Ok(())
    }
}

fn continuity_between<P: Point>(left: &Curve<P>, right: &Curve<P>, tolerance: f64) -> Continuity {
    let near =
        |k: usize| (left.derivative_at(1.0, k) - right.derivative_at(0.0, k)).norm() <= tolerance;
    let (before, after) = (left.tangent(1.0), right.tangent(0.0));
    let (along, across) = (before.dot(after), before.cross(after).size());
    let handle_length = handle(left, true).min(handle(right, false));
    // The product is |handle| · sin(angle): the distance of the tip of the handle from the tangent of the other side.
    let g1 = along > 0.0 && across * handle_length <= tolerance;
    // Two parabolas with these curvatures differ by Δκ/2 · reach² at the tip of the handle.
    let bend = curvature_vector(left, 1.0) - curvature_vector(right, 0.0);
    let g2 = g1 && bend.norm() * 0.5 * handle_length * handle_length <= tolerance;
    let c1 = near(1);
    Continuity {
        c0: true,
        g1,
        c1,
        g2,
        c2: c1 && near(2),
        gap: 0.0,
        angle: across.atan2(along),
    }
}

/// The length of the last nonzero handle before a joint, or of the first one after it.
fn handle<P: Point>(curve: &Curve<P>, at_end: bool) -> f64 {
    let joint = if at_end { curve.end() } else { curve.start() };
    let mut lengths = curve.control_points().iter().map(|&p| (p - joint).norm());
    let found = if at_end {
        lengths.rfind(|&l| l > 0.0)
    } else {
        lengths.find(|&l| l > 0.0)
    };
    found.unwrap_or(0.0)
}

/// The curvature vector; its length is at most `f64::MAX` where the curvature is infinite.
fn curvature_vector<P: Point>(curve: &Curve<P>, t: f64) -> P {
    curve.normal(t) * curve.curvature(t).clamp(-f64::MAX, f64::MAX)
}
