//! Whether a point is in a stroke.

use super::dash::Pattern;
use super::options::Pen;
use super::{StrokeCap, StrokeOptions, check_width};
use crate::bernstein::product::product_of;
use crate::bernstein::roots::roots_inside;
use crate::curve::Curve;
use crate::curve::nearest::nearest_on;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use crate::path::Path;
use crate::spline::{Join, Spline};
use glam::DVec2;

/// A vector whose component along a unit tangent is at most this part of the size is perpendicular to it.
const MAX_FOOT_DEVIATION: f64 = 1e-7;

/// The same for an end, whose tangent is exact.
const BESIDE_END: f64 = 1e-12;

/// The step in t before a cusp at which its direction is taken.
const CUSP_PROBE_STEP: f64 = 1e-6;

impl Path {
    /// Whether a point is in the stroke of the path, as [`stroke`](Self::stroke) describes it.
    ///
    /// The answer follows from the distances of the point from the path and does not need an outline, so it is exact up
    /// to rounding; `tolerance` and `simple` have no effect.
    ///
    /// ```
    /// use casteljau::{Path, glam::DVec2};
    /// use casteljau::path::StrokeOptions;
    ///
    /// let line: Path = "M0 0H10".parse().expect("path data");
    /// let options = StrokeOptions::default();
    /// assert!(line.stroke_contains(DVec2::new(9.0, 0.9), 2.0, &options)?);
    /// assert!(!line.stroke_contains(DVec2::new(10.5, 0.0), 2.0, &options)?);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a point with a NaN or an infinity, otherwise as [`stroke`](Self::stroke).
    pub fn stroke_contains(
        &self,
        p: DVec2,
        width: f64,
        options: &StrokeOptions,
    ) -> Result<bool, Error> {
        check_points("p", &[p])?;
        check_width("width", width)?;
        let pen = self.pen(width, options)?;
        let pattern = Pattern::new(&options.dash, options.dash_offset)?;
        let Some(pen) = pen else {
            return Ok(false);
        };
        let mut count = 0;
        for spline in self.subpaths() {
            let Some(pattern) = &pattern else {
                if covers(&spline, DVec2::X, p, &pen) {
                    return Ok(true);
                }
                continue;
            };
            let dashes = pattern.dashes(&spline, &mut count)?;
            if dashes
                .iter()
                .any(|dash| covers(&dash.spline, dash.tangent, p, &pen))
            {
                return Ok(true);
            }
        }
        Ok(false)
    }
}

/// Whether the stroke of a subpath contains a point. `tangent` is the direction of a subpath that is a point.
fn covers(spline: &Spline<DVec2>, tangent: DVec2, p: DVec2, pen: &Pen) -> bool {
    let curves: Vec<Curve<DVec2>> = spline.segments().filter(Curve::has_size).collect();
    let (Some(first), Some(last)) = (curves.first(), curves.last()) else {
        let center = spline.control_points()[0];
        return in_cap(p - center, tangent, pen) || in_cap(p - center, -tangent, pen);
    };
    if (pen.join, pen.cap) == (Join::Round, StrokeCap::Round) {
        let is_within = |points| nearest_on(points, p).distance <= pen.radius;
        let points = curves.iter().map(Curve::control_points);
        return points
            .filter(|own| Bounds::from_points(own).distance(p) <= pen.radius)
            .any(is_within);
    }
    let ends = if spline.is_closed() {
        in_join(last, first, p, pen)
    } else {
        in_cap(p - last.end(), last.end_tangent(), pen)
            || in_cap(p - first.start(), -first.start_tangent(), pen)
    };
    ends || curves
        .windows(2)
        .any(|pair| in_join(&pair[0], &pair[1], p, pen))
        || curves.iter().any(|curve| sweeps(curve, p, pen.radius))
}

/// Whether the cap at the origin, with a tangent that points out of the stroke, contains q.
fn in_cap(q: DVec2, tangent: DVec2, pen: &Pen) -> bool {
    let (ahead, aside) = (q.dot(tangent), q.perp_dot(tangent).abs());
    ahead >= 0.0
        && match pen.cap {
            StrokeCap::Butt => false,
            StrokeCap::Round => Point::norm(q) <= pen.radius,
            StrokeCap::Square => ahead.max(aside) <= pen.radius,
        }
}

/// Whether the join of two segments contains a point: the part ahead of the first and behind the second one.
fn in_join(before: &Curve<DVec2>, after: &Curve<DVec2>, p: DVec2, pen: &Pen) -> bool {
    let (q, from, to) = (
        p - after.start(),
        before.end_tangent(),
        after.start_tangent(),
    );
    if q.dot(from) < 0.0 || q.dot(to) > 0.0 {
        return false;
    }
    if pen.join == Join::Round {
        return Point::norm(q) <= pen.radius;
    }
    // The outer side is the right one where the path turns left.
    let outside = if from.perp_dot(to) >= 0.0 { -1.0 } else { 1.0 };
    let normals = [from, to].map(|tangent| tangent.perp() * outside);
    let cos = from.dot(to);
    match pen.miter(pen.radius, cos) {
        // On the inner side of both lines that meet in the tip.
        Some(_) => normals.iter().all(|n| q.dot(*n) <= pen.radius),
        // Below the line through the ends of both normals; nothing where the path turns back.
        None => {
            1.0 + cos > BESIDE_END && q.dot(normals[0] + normals[1]) <= pen.radius * (1.0 + cos)
        }
    }
}

/// Whether a normal of the curve, or the half disk ahead of a point where the curve reverses, contains p.
fn sweeps(curve: &Curve<DVec2>, p: DVec2, radius: f64) -> bool {
    let points = curve.control_points();
    let bounds = Bounds::from_points(points);
    if bounds.distance(p) > radius {
        return false;
    }
    let near = |t: f64| Point::norm(curve.eval(t) - p) <= radius;
    let Bounds { min, max } = bounds;
    let size = Point::norm(max - min) + radius;
    let beside_end = |end: DVec2, tangent: DVec2| {
        let q = p - end;
        q.dot(tangent).abs() <= BESIDE_END * size && Point::norm(q) <= radius
    };
    let is_foot = |t: f64| {
        let along = (curve.eval(t) - p).dot(curve.tangent(t));
        near(t) && along.abs() <= MAX_FOOT_DEVIATION * size
    };
    beside_end(curve.start(), curve.start_tangent())
        || beside_end(curve.end(), curve.end_tangent())
        || feet(points, p).into_iter().any(is_foot)
        || reversals(curve)
            .into_iter()
            .any(|(t, ahead)| near(t) && (p - curve.eval(t)).dot(ahead) >= 0.0)
        // A point inside the curve that is nearest is one of these, but rounding may hide that.
        || is_beside_nearest(points, p, radius, BESIDE_END * size)
}

/// Whether the nearest point of a curve is within the radius, and farther than `clear` from both ends.
fn is_beside_nearest(points: &[DVec2], p: DVec2, radius: f64, clear: f64) -> bool {
    let nearest = nearest_on(points, p);
    let ends = [points[0], points[points.len() - 1]];
    let is_clear = |end: DVec2| Point::norm(nearest.point - end) > clear;
    nearest.distance <= radius && ends.into_iter().all(is_clear)
}

/// The zeros of (B − p)·B′ inside (0, 1), where p is on the normal of B.
fn feet(points: &[DVec2], p: DVec2) -> Vec<f64> {
    let relative: Points<DVec2> = Normalized::around(p, points).points(points);
    let steps: Points<DVec2> = relative.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let n = points.len() - 1;
    let product = product_of(n, n - 1, |i, j| relative[i].dot(steps[j]));
    roots_inside(&product).to_vec()
}

/// The parameters at which the curve reverses its direction, with the direction before.
fn reversals(curve: &Curve<DVec2>) -> Vec<(f64, DVec2)> {
    match curve.straight_direction() {
        Some(direction) => {
            let turns = curve.turns_along(direction);
            let before = |t: f64| direction * curve.sign_along(direction, t - CUSP_PROBE_STEP);
            turns.into_iter().map(|t| (t, before(t))).collect()
        }
        None => {
            let cusps = curve.cusps().into_iter();
            cusps
                .map(|t| (t, curve.tangent(t - CUSP_PROBE_STEP)))
                .collect()
        }
    }
}
