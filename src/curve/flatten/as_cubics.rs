//! Replacement of a curve of degree above 3 by cubics, for flattening at fine tolerances.
//!
//! The cubic with the same end points and end derivatives differs from a segment of the curve by at most max |B⁗| /
//! 384, where the segment is parametrized over unit time. If a sufficiently close cubic spans many chords, measuring
//! the chords on the cubic is about fifty times faster than on the curve itself. The vertices are still points of the
//! curve.

use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use crate::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// A cubic may differ from the curve by at most this part of the tolerance.
const ERROR_PART: f64 = 1.0 / 32.0;

/// The part of the tolerance that remains for chords; the error of the cubic counts twice, at a vertex and between
/// vertices.
const CHORD_PART: f64 = 1.0 - 2.0 * ERROR_PART;

/// With at least this many chords on each cubic, the additional vertices at the ends of cubics are few.
const MIN_CHORDS: f64 = 24.0;

/// Maximum number of cubics.
const MAX_CUBICS: usize = 1 << 16;

/// Halvings after which a segment is a point up to rounding.
const MAX_HALVINGS: u32 = 48;

/// A cubic that replaces a segment of a curve.
pub(crate) struct CubicPiece {
    /// Its control points.
    pub(crate) points: [DVec3; 4],
    /// The parameters of its ends on the curve.
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// A segment of the curve. `fourth` is the fourth derivative, subdivided from that of the whole curve, because fourth
/// differences of the segment's own control points would be only rounding.
struct SourceSegment {
    curve: Curve<DVec3>,
    fourth: Curve<DVec3>,
    halvings: u32,
    from: f64,
}

/// Cubics that replace a curve, and the tolerance for chords on them; `None` if there are few chords for each cubic.
///
/// # Errors
/// [`Error::TooMany`] above 2¹⁶ cubics.
pub(crate) fn as_cubics(
    points: &[DVec3],
    tolerance: f64,
) -> Result<Option<(Vec<CubicPiece>, f64)>, Error> {
    let mut cubics = Vec::new();
    let mut chords = 0.0;
    let mut rest = vec![SourceSegment::whole(points)];
    let mut work = WorkLimit::new(2 * MAX_CUBICS);
    while let Some(piece) = rest.pop() {
        if !work.spend(1) || cubics.len() + rest.len() >= MAX_CUBICS {
            return Err(Error::too_many(
                "cubics in the place of the curve",
                MAX_CUBICS,
                MAX_CUBICS + 1,
            ));
        }
        if piece.error() <= ERROR_PART * tolerance || piece.halvings == MAX_HALVINGS {
            let cubic = piece.cubic();
            chords += chord_count(&cubic.points, tolerance);
            cubics.push(cubic);
        } else {
            let [left, right] = piece.halves();
            rest.push(right);
            rest.push(left);
        }
    }
    let worth = chords >= MIN_CHORDS * cubics.len() as f64;
    Ok(worth.then_some((cubics, CHORD_PART * tolerance)))
}

impl SourceSegment {
    fn whole(points: &[DVec3]) -> Self {
        let n = (points.len() - 1) as f64;
        let factor = n * (n - 1.0) * (n - 2.0) * (n - 3.0);
        let fourth = |w: &[DVec3]| ((w[0] + w[4]) - (w[1] + w[3]) * 4.0 + w[2] * 6.0) * factor;
        let fourths: Points<DVec3> = points.windows(5).map(fourth).collect();
        Self {
            curve: Curve::from_slice(points),
            fourth: Curve::from_slice(&fourths),
            halvings: 0,
            from: 0.0,
        }
    }

    fn length(&self) -> f64 {
        1.0 / (1_u64 << self.halvings) as f64
    }

    /// A bound on the distance between the segment and its cubic at equal parameters.
    fn error(&self) -> f64 {
        let length = |p: &DVec3| Point::length(*p);
        let max = self.fourth.control_points().iter().map(length);
        max.fold(0.0, f64::max) * self.length().powi(4) / 384.0
    }

    /// The cubic with the same end points and end derivatives.
    fn cubic(&self) -> CubicPiece {
        let p = self.curve.control_points();
        let n = p.len() - 1;
        let third = n as f64 / 3.0;
        CubicPiece {
            points: [
                p[0],
                p[0] + (p[1] - p[0]) * third,
                p[n] + (p[n - 1] - p[n]) * third,
                p[n],
            ],
            from: self.from,
            to: self.from + self.length(),
        }
    }

    fn halves(&self) -> [Self; 2] {
        let (left, right) = self.curve.halve();
        let (left_fourth, right_fourth) = if self.fourth.points.len() == 1 {
            (self.fourth.clone(), self.fourth.clone())
        } else {
            self.fourth.halve()
        };
        let halvings = self.halvings + 1;
        let middle = self.from + 0.5 * self.length();
        [
            Self {
                curve: left,
                fourth: left_fourth,
                halvings,
                from: self.from,
            },
            Self {
                curve: right,
                fourth: right_fourth,
                halvings,
                from: middle,
            },
        ]
    }
}

/// Estimate of the number of chords of a cubic: with a second derivative D, of which only the part across the curve
/// counts, N equal steps are within D/(8 N²) of the curve.
fn chord_count(p: &[DVec3; 4], tolerance: f64) -> f64 {
    let across = |i: usize, edge: DVec3| {
        let second = p[i + 2] - p[i + 1] * 2.0 + p[i];
        let direction = Point::normalize_or_zero(edge);
        if direction == DVec3::ZERO {
            Point::length(second)
        } else {
            Point::length(direction.cross(second))
        }
    };
    let bend = 3.0 * (across(0, p[1] - p[0]) + across(1, p[3] - p[2]));
    (bend / (8.0 * tolerance)).sqrt()
}
