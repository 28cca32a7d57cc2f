//! B-splines: other control points for the same chains.

use super::Spline;
use super::knots::Knots;
use crate::curve::eval::MAX_OUTPUT_F64;
use crate::geometry::check::check_finite;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;

/// The most insertions: a few seconds. A segment of degree p takes p (p − 1).
const MAX_STEPS: usize = 1 << 28;

/// A B-spline: control points, knots and a degree.
///
/// Open: for n points of degree p there are n + p + 1 knots u₀ ≤ u₁ ≤ …, and the curve runs over [uₚ, uₙ]. Closed: there are
/// n + 1 knots, the joints of one period, and the first segment belongs to the points 0 to p.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct BSpline<P: Point> {
    /// The control points, of de Boor.
    pub points: Vec<P>,
    /// The knots, in ascending order.
    pub knots: Vec<f64>,
    /// The degree of each segment.
    pub degree: usize,
    /// Whether points and knots go around.
    pub closed: bool,
}

impl<P: Point> Spline<P> {
    /// The Bézier form of a B-spline: one segment of its degree for each span between different knots.
    ///
    /// The control points of a segment over [a, b] are the values of its blossom at a … a b … b, found by inserting both
    /// knots until they are there p times (Böhm). Without knots they are 0, 1, 2, …: the uniform B-spline, which for degree 3
    /// has the joints (P₀ + 4P₁ + P₂)/6. An open one reaches its first and last point only where a knot comes p times (at an
    /// end p + 1 times, as is usual, where the first and last knot do not matter). Each segment runs from t = k to k + 1,
    /// however far apart its knots are; so where knots are not evenly spaced derivatives at joints are parallel, not equal.
    ///
    /// A closed B-spline of n points has n spans. Segment k belongs to the points k to k + p, as in an open one.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let points = [(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)].map(DVec2::from);
    /// let knots = [0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0];
    /// let spline = Spline::from_bspline(&points, 2, Some(&knots), false)?;
    /// assert_eq!(spline.degrees(), [2, 2]);
    /// assert_eq!(spline.eval(0.5), DVec2::new(1.0, 1.5));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a degree outside of 1 to 64, [`Error::Count`] for too few points (open: degree + 1) or a wrong
    /// number of knots, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a knot below the one before it,
    /// or one too many of the same: more than p inside would part the curve. [`Error::TooMany`] above 1 GiB, or above
    /// 2²⁸/p² segments.
    ///
    /// Sources: Böhm, "Inserting new knots into B-spline curves", 1980; Ramshaw, "Blossoms are polar forms", 1989.
    pub fn from_bspline(
        points: &[P],
        degree: usize,
        knots: Option<&[f64]>,
        closed: bool,
    ) -> Result<Self, Error> {
        if !(1..=MAX_DEGREE).contains(&degree) {
            return Err(Error::Range {
                what: "degree",
                expected: "1 to 64",
                got: degree as f64,
            });
        }
        let count = points.len();
        if count < if closed { 1 } else { degree + 1 } {
            return Err(Error::Count {
                what: "points",
                expected: "at least degree + 1 points (closed: 1)",
                got: count,
            });
        }
        check_finite("points", points)?;
        let knots = Knots::new(knots, count, degree, closed)?;
        let spans = knots.spans();
        let limit = (MAX_OUTPUT_F64 / P::DIMENSION / degree - 1).min(MAX_STEPS / degree / degree);
        if spans > limit {
            return Err(Error::TooMany {
                what: "segments",
                limit,
                needed: spans,
            });
        }
        Ok(bezier_form(points, &knots, closed))
    }

    /// The same chain as a B-spline whose knots are the joints, each as often as the degree: its control points are the
    /// spline's own, so that [`from_bspline`](Self::from_bspline) gives back exactly this.
    ///
    /// # Errors
    /// [`Error::Item`] for a segment whose degree differs from the first one's.
    pub fn to_bspline(&self) -> Result<BSpline<P>, Error> {
        let degrees = self.degrees();
        let degree = degrees[0];
        if let Some(index) = degrees.iter().position(|&d| d != degree) {
            return Err(Error::Item {
                what: "degrees",
                index,
                expected: "the degree of the first segment",
                got: degrees[index] as f64,
            });
        }
        let ends = if self.closed { 0 } else { 1 };
        let joints = 0..=self.segment_count();
        let repeated = joints.flat_map(|k| std::iter::repeat_n(k as f64, degree));
        let mut knots = vec![0.0; ends];
        let mut points = self.points.clone();
        if self.closed {
            // One period: the last joint is the first one again.
            knots.extend(repeated.take(points.len() + 1));
            points.rotate_right(degree - 1);
        } else {
            knots.extend(repeated);
            knots.push(self.segment_count() as f64);
        }
        Ok(BSpline {
            points,
            knots,
            degree,
            closed: self.closed,
        })
    }
}

fn bezier_form<P: Point>(points: &[P], knots: &Knots, closed: bool) -> Spline<P> {
    let (degree, spans) = (knots.degree(), knots.spans());
    let mut all = Vec::with_capacity(spans * degree + 1);
    let mut segment = vec![P::default(); degree + 1];
    let mut local = vec![0.0; 2 * degree + 1];
    for k in knots.starts() {
        let at = |i: usize| points[(k + i) % points.len()];
        segment.iter_mut().enumerate().for_each(|(i, p)| *p = at(i));
        local
            .iter_mut()
            .enumerate()
            .for_each(|(i, u)| *u = knots.at(k + i));
        to_bezier(&mut segment, &local);
        all.extend_from_slice(&segment[..degree]);
    }
    if !closed {
        all.push(segment[degree]);
    }
    Spline::from_parts(all, &vec![degree; spans], closed)
}

/// Turns the control points of the span [a, b] between the knots uₚ and uₚ₊₁ into those of Bézier.
///
/// With f the blossom of the segment, point i comes in as f(uᵢ₊₁ … uᵢ₊ₚ). Inserting a makes it f(a … a uₚ₊₁ … uₚ₊ᵢ), with i
/// knots from b on; inserting b, f(a … a b … b).
fn to_bezier<P: Point>(points: &mut [P], u: &[f64]) {
    let p = points.len() - 1;
    let (a, b) = (u[p], u[p + 1]);
    for level in 1..p {
        for i in 0..p - level {
            let (from, to) = (u[i + level], u[i + p + 1]);
            points[i] = points[i].lerp(points[i + 1], (a - from) / (to - from));
        }
    }
    for level in 1..p {
        for i in (level + 1..=p).rev() {
            let to = u[p + i - level + 1];
            points[i] = points[i - 1].lerp(points[i], (b - a) / (to - a));
        }
    }
}
