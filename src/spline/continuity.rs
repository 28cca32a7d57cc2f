//! How smooth is a joint?

use super::Spline;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::{CrossProduct, Point};

/// The tolerance by default, as a part of the largest extent of the two segments.
const DEFAULT_RATIO: f64 = 1e-9;

/// What is true at a joint.
///
/// C means equal derivatives (the point moves on evenly), G equal geometry (the drawn line goes on evenly). The
/// tutorial text calls an aligned joint C1; alignment alone is G1, and C1 when the handles are as long as each other
/// (for equal degrees).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Continuity {
    /// The segments meet.
    pub c0: bool,
    /// They have the same tangent direction.
    pub g1: bool,
    /// They have the same first derivative.
    pub c1: bool,
    /// They have the same tangent and the same curvature.
    pub g2: bool,
    /// They have the same first and second derivative.
    pub c2: bool,
    /// The distance between the two ends; 0, as the segments of a spline share the point.
    pub gap: f64,
    /// The angle between the two tangents, 0 to π; 0 where a segment is a point.
    pub angle: f64,
}

impl<P: Point> Spline<P> {
    /// What is true at the joint t = `joint`; a closed spline has a joint 0 too.
    ///
    /// `tolerance` (by default 10⁻⁹ of the extent of the two segments) is a distance: derivatives may differ by it,
    /// and for G1 and G2 the shorter handle's tip may lie that far off the other side's tangent or osculating parabola.
    /// Zero-length handles are judged by their limit tangents.
    ///
    /// # Errors
    /// [`Error::Index`] unless `joint` lies between two segments, [`Error::Range`] for a tolerance that is not above 0.
    pub fn continuity(&self, joint: usize, tolerance: Option<f64>) -> Result<Continuity, Error> {
        self.check_joint(joint)?;
        if let Some(got) =
            tolerance.filter(|&tolerance| !(tolerance > 0.0 && tolerance.is_finite()))
        {
            return Err(Error::Range {
                what: "tolerance",
                expected: "a finite number above 0",
                got,
            });
        }
        let before = if joint == 0 {
            self.segment_count() - 1
        } else {
            joint - 1
        };
        let (left, right) = (self.curve(before), self.curve(joint));
        let size = left
            .control_bounds()
            .union(right.control_bounds())
            .diagonal();
        Ok(judge(
            &left,
            &right,
            tolerance.unwrap_or(DEFAULT_RATIO * size),
        ))
    }

    /// Refuses what is no joint: the ends of an open spline and what lies beyond.
    pub(crate) fn check_joint(&self, joint: usize) -> Result<(), Error> {
        let (first, last) = (usize::from(!self.closed), self.segment_count() - 1);
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

fn judge<P: Point>(left: &Curve<P>, right: &Curve<P>, tolerance: f64) -> Continuity {
    let near =
        |k: usize| (left.derivative_at(1.0, k) - right.derivative_at(0.0, k)).length() <= tolerance;
    let (before, after) = (left.tangent(1.0), right.tangent(0.0));
    let (along, across) = (before.dot(after), before.cross(after).size());
    let reach = handle(left, true).min(handle(right, false));
    let g1 = along > 0.0 && across * reach <= tolerance;
    // Two parabolas with these curvatures are κ/2 · reach² apart at the handle's tip.
    let bend = bend_of(left, 1.0) - bend_of(right, 0.0);
    let g2 = g1 && bend.length() * 0.5 * reach * reach <= tolerance;
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

/// The length of the last handle before a joint, or the first after it, that is not zero.
fn handle<P: Point>(curve: &Curve<P>, at_end: bool) -> f64 {
    let joint = if at_end { curve.end() } else { curve.start() };
    let mut lengths = curve.control_points().iter().map(|&p| (p - joint).length());
    let found = if at_end {
        lengths.rfind(|&l| l > 0.0)
    } else {
        lengths.find(|&l| l > 0.0)
    };
    found.unwrap_or(0.0)
}

/// The curvature vector; a very large one where the curvature is infinite.
fn bend_of<P: Point>(curve: &Curve<P>, t: f64) -> P {
    curve.normal(t) * curve.curvature(t).clamp(-f64::MAX, f64::MAX)
}
