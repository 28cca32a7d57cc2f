//! Offset curves of splines.
//!
//! In the kernels, where an offset spends its time: the cubics along the offset of one curve, and their bound.

pub(crate) mod curve;

use super::Spline;
use super::spline_builder::SplineBuilder;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use curve::offset_tolerance;
use glam::DVec2;

/// The kind of join between the offset curves of two segments at a corner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Join {
    /// A circular arc about the corner: all its points have the offset distance from it.
    #[default]
    Round,
    /// The tangents extended to their intersection, if it is at most 4 distances away (as in SVG); otherwise `Bevel`.
    /// On the inner side of the corner `Bevel`.
    Miter,
    /// A straight line.
    Bevel,
}

/// The maximum distance of a miter tip from its corner, in offset distances: SVG's default `stroke-miterlimit`.
const MITER_LIMIT: f64 = 4.0;

/// The ends of two offset curves at a joint may differ by this ratio of the tolerance without a join.
pub(crate) const SMOOTH_PART: f64 = 1.0 / 64.0;

impl Spline<DVec2> {
    /// The offset curve at a distance along the normal: the offset curves of the segments, joined at corners.
    ///
    /// As [`Curve::offset`], including its treatment of cusps, tolerance and points; a segment that is a point is
    /// skipped. Where the tangents differ at a joint, `join` connects both sides, also on the inner side of a corner,
    /// where the offset curves cross: nothing is trimmed. A smooth joint needs no join (the ends may differ by 1/64 of
    /// the tolerance). The offset curve of a closed spline is closed.
    ///
    /// A parallel curve on one side is not an enlarged region: a positive distance is to the left of the direction, which
    /// is inside of an outline that runs counter-clockwise (x right, y up). [`Path::offset`](crate::Path::offset) grows
    /// regions whatever their direction.
    ///
    /// # Errors
    /// As [`Curve::offset`].
    pub fn offset(&self, distance: f64, join: Join) -> Result<Self, Error> {
        self.offset_by(distance, join, None)
    }

    /// [`offset`](Self::offset) with a maximum distance from the exact offset curve, in the unit of the points.
    ///
    /// # Errors
    /// As [`Curve::offset_within`].
    pub fn offset_within(&self, distance: f64, join: Join, tolerance: f64) -> Result<Self, Error> {
        self.offset_by(distance, join, Some(tolerance))
    }

    fn offset_by(&self, distance: f64, join: Join, tolerance: Option<f64>) -> Result<Self, Error> {
        let curves: Vec<Curve<DVec2>> = self.segments().collect();
        offset_of_curves(&curves, self.closed, distance, tolerance, join).map(SplineBuilder::spline)
    }
}

/// The offset curve of consecutive curves.
pub(crate) fn offset_of_curves(
    curves: &[Curve<DVec2>],
    closed: bool,
    distance: f64,
    tolerance: Option<f64>,
    join: Join,
) -> Result<SplineBuilder, Error> {
    let largest = curves.iter().map(Curve::max_abs).fold(0.0, f64::max);
    let box_of = || {
        let boxes = curves.iter().map(Curve::control_bounds);
        boxes
            .reduce(|a, b| a.union(b))
            .map_or(0.0, |b| b.diagonal())
    };
    let tolerance = offset_tolerance(distance, tolerance, largest, box_of)?;
    // A part of the tolerance is reserved for the gaps at joints without a join.
    let own = tolerance * (1.0 - SMOOTH_PART);
    let mut builder = SplineBuilder::default();
    let moves = |curve: &&Curve<DVec2>| distance == 0.0 || curve.has_size();
    let mut moving: Vec<&Curve<DVec2>> = curves.iter().filter(moves).collect();
    if moving.is_empty() {
        moving.extend(&curves[..1]);
    }
    let corner = |builder: &mut SplineBuilder, before: &Curve<DVec2>, after: &Curve<DVec2>| {
        let (from, to) = (before.end_tangent(), after.start_tangent());
        // The ends of both offset curves are |to − from| · |distance| apart.
        if Point::norm(to - from) * distance.abs() > SMOOTH_PART * tolerance {
            builder.join(after.start(), from, to, distance, own, join);
        }
    };
    for (k, curve) in moving.iter().enumerate() {
        if k > 0 {
            corner(&mut builder, moving[k - 1], curve);
        }
        builder.add_offset(curve, distance, own)?;
    }
    if closed {
        corner(&mut builder, moving[moving.len() - 1], moving[0]);
        // The end equals the start, which the list contains only once.
        builder.points.pop();
        builder.closed = true;
    }
    Ok(builder)
}

impl SplineBuilder {
    /// Connects the offset curve before a corner to the one after it.
    fn join(
        &mut self,
        corner: DVec2,
        from: DVec2,
        to: DVec2,
        distance: f64,
        tolerance: f64,
        join: Join,
    ) {
        if join == Join::Round {
            return self.add_arc_about(corner, from, to, distance, tolerance);
        }
        let outside = from.perp_dot(to) * distance < 0.0;
        // The tip is 1/cos(θ/2) distances away, and 1 + cos θ = 2cos²(θ/2).
        let twice = 1.0 + from.dot(to);
        if join == Join::Miter && outside && twice * MITER_LIMIT * MITER_LIMIT >= 2.0 {
            self.line_to(corner + (from + to).perp() * (distance / twice));
        }
        self.line_to(corner + to.perp() * distance);
    }
}
