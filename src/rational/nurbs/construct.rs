//! Arcs, circles and ellipses, and conversion from splines.

use super::NurbsCurve;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ratio};
use crate::rational::RationalCurve;
use crate::spline::Spline;
use casteljau_kernels::numeric::trigonometry::cos_sin;
use glam::DVec2;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, TAU};

impl<P: Point> NurbsCurve<P> {
    /// The arc center + cos(θ) u + sin(θ) v from one angle to another, in radians, over the domain [0, 1].
    ///
    /// u and v are conjugate radii of an ellipse: perpendicular ones of length r give an arc of a circle of radius r, in the plane or
    /// in space. The arc is one of degree 2 with a span for each quarter turn or less; it runs backwards if the end is below the
    /// start. A full turn starts and ends at the same point, exactly, but stays an open curve.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity, [`Error::Range`] for more than a full turn, [`Error::Item`] for a
    /// coordinate beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    ///
    /// Source: Piegl and Tiller, *The NURBS Book*, algorithm A7.1.
    ///
    /// ```
    /// use casteljau::{NurbsCurve, glam::DVec3};
    /// use std::f64::consts::FRAC_PI_2;
    ///
    /// let quarter = NurbsCurve::arc(DVec3::ZERO, DVec3::Y, DVec3::Z, 0.0, FRAC_PI_2)?;
    /// assert_eq!(quarter.end(), DVec3::Z);
    /// assert!((quarter.eval(0.5).length() - 1.0).abs() < 1e-15);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn arc(center: P, u: P, v: P, start: f64, end: f64) -> Result<Self, Error> {
        Error::unless_finite("start", &[start])?;
        Error::unless_finite("end", &[end])?;
        let sweep = end - start;
        if sweep.abs() > TAU * (1.0 + f64::EPSILON) {
            return Err(Error::Range {
                what: "end",
                expected: "at most a full turn from the start",
                got: end,
            });
        }
        // `start + sweep` is the end up to rounding. A quarter turn is divided by rounding alone if it is a few ulps larger.
        let spans = (1..4)
            .find(|&n| sweep.abs() <= as_f64(n) * FRAC_PI_2 * (1.0 + 4.0 * f64::EPSILON))
            .unwrap_or(4);
        let step = sweep / as_f64(spans);
        // The control point between two ends is where their tangents meet.
        let is_quarter = step.abs() == FRAC_PI_2;
        let (w, tan) = if is_quarter {
            (FRAC_1_SQRT_2, 1.0_f64.copysign(step))
        } else {
            let (cos, sin) = cos_sin(0.5 * step);
            (cos, sin / cos)
        };
        let at = |(x, y): (f64, f64)| center + u * x + v * y;
        let mut points = Vec::with_capacity(2 * spans + 1);
        let mut weights = Vec::with_capacity(2 * spans + 1);
        let (mut x, mut y) = cos_sin(start);
        for i in 0..spans {
            points.extend([at((x, y)), at((x - y * tan, y + x * tan))]);
            weights.extend([1.0, w]);
            // Quarter turns are exact.
            (x, y) = if is_quarter {
                (-y * tan, x * tan)
            } else {
                cos_sin(start + as_f64(i + 1) * step)
            };
        }
        points.push(at((x, y)));
        weights.push(1.0);
        Self::new(
            2,
            &points,
            Some(&weights),
            &joined_knots(2, spans, 1.0),
            false,
        )
    }
}

impl NurbsCurve<DVec2> {
    /// The circle, counter-clockwise from (x + r, y), with nine control points over the domain [0, 1].
    ///
    /// # Errors
    /// [`Error::Range`] for a negative radius, otherwise as [`arc`](Self::arc). A radius of 0 gives a curve that is a point.
    pub fn circle(center: DVec2, radius: f64) -> Result<Self, Error> {
        Self::ellipse(center, DVec2::splat(radius), 0.0)
    }

    /// The ellipse with two radii, the first of which has an angle with the x-axis, in radians; as [`circle`](Self::circle).
    ///
    /// # Errors
    /// As there.
    pub fn ellipse(center: DVec2, radii: DVec2, rotation: f64) -> Result<Self, Error> {
        if let Some(&radius) = radii.to_array().iter().find(|&&radius| radius < 0.0) {
            return Err(Error::Range {
                what: "radius",
                expected: "a number from 0",
                got: radius,
            });
        }
        Error::unless_finite("radius", &radii.to_array())?;
        Error::unless_finite("rotation", &[rotation])?;
        let (x, y) = cos_sin(rotation);
        let u = DVec2::new(x, y) * radii.x;
        let v = DVec2::new(-y, x) * radii.y;
        Self::arc(center, u, v, 0.0, TAU)
    }
}

/// The knots of `spans` segments that join at knots of multiplicity p, over [0, end].
fn joined_knots(p: usize, spans: usize, end: f64) -> Vec<f64> {
    let joints = (0..=spans).flat_map(|i| std::iter::repeat_n(ratio(i, spans) * end, p));
    let mut knots = vec![0.0];
    knots.extend(joints);
    knots.push(end);
    knots
}

impl<P: Point> From<&RationalCurve<P>> for NurbsCurve<P> {
    /// The same curve, with one span over [0, 1].
    fn from(curve: &RationalCurve<P>) -> Self {
        let n = curve.degree();
        Self::of_segments(
            n,
            curve.control_points().to_vec(),
            curve.weights().to_vec(),
            1,
        )
    }
}

impl<P: Point> From<&Curve<P>> for NurbsCurve<P> {
    /// The same curve with the weights 1, and one span over [0, 1].
    fn from(curve: &Curve<P>) -> Self {
        Self::from(&RationalCurve::from(curve))
    }
}

impl<P: Point> From<&Spline<P>> for NurbsCurve<P> {
    /// The same curve with the weights 1 and a span over [k, k + 1] for segment k, open also if the spline is closed.
    ///
    /// Segments of lower degrees are elevated to the highest one. The joints keep their parameters and have the degree as
    /// multiplicity.
    fn from(spline: &Spline<P>) -> Self {
        let degree = spline.degrees().into_iter().max().unwrap_or(1);
        let count = spline.segment_count();
        let mut points = vec![spline.control_points()[0]];
        for mut curve in spline.segments() {
            while curve.degree() < degree {
                curve = curve.elevated();
            }
            points.extend_from_slice(&curve.control_points()[1..]);
        }
        let weights = vec![1.0; points.len()];
        Self::of_segments(degree, points, weights, count)
    }
}

impl<P: Point> NurbsCurve<P> {
    /// The curve of valid segments that share their ends, over [0, count].
    fn of_segments(degree: usize, points: Vec<P>, weights: Vec<f64>, count: usize) -> Self {
        let knots = joined_knots(degree, count, as_f64(count));
        let segment = |k: usize| RationalCurve::between(&points, &weights, k * degree, degree);
        Self {
            segments: (0..count).map(segment).collect(),
            joints: (0..=count).map(as_f64).collect(),
            closed: false,
            degree,
            points,
            weights,
            knots,
        }
    }
}
