//! Conversion between B-splines and Bézier splines.

use super::Spline;
use super::knots::Knots;
use crate::curve::eval::MAX_OUTPUT_F64;
use crate::geometry::check::check_points;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use casteljau_kernels::bernstein::de_casteljau::lerp;
use casteljau_kernels::numeric::vector::Interpolate;

/// The maximum number of knot insertions, which take a few seconds. A segment of degree p needs p (p − 1).
pub(crate) const MAX_STEPS: usize = 1 << 28;

/// A B-spline: control points, knots and a degree.
///
/// An open B-spline with n points of degree p has n + p + 1 knots u₀ ≤ u₁ ≤ …, and its curve covers [uₚ, uₙ]. A closed
/// one has n + 1 knots, which are the joints of one period; its first segment depends on the points 0 to p.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct BSpline<P: Point> {
    /// The control points (de Boor points).
    pub points: Vec<P>,
    /// The knots, in ascending order.
    pub knots: Vec<f64>,
    /// The degree of each segment.
    pub degree: usize,
    /// Whether the points and the knots are periodic.
    pub closed: bool,
}

impl<P: Point> BSpline<P> {
    /// A B-spline whose numbers of points and knots and whose knots are valid; the default knots are 0, 1, 2, …
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2, spline::BSpline};
    ///
    /// let points = [(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)].map(DVec2::from);
    /// let knots = vec![0.0, 0.0, 0.0, 1.0, 3.0, 3.0, 3.0];
    /// let b_spline = BSpline::new(points.to_vec(), 2, Some(knots), false)?;
    /// assert_eq!(b_spline.eval(0.5)?, b_spline.to_spline()?.eval(0.5));
    /// assert_eq!(Spline::try_from(&b_spline)?.segment_count(), 2);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Spline::from_bspline`].
    pub fn new(
        points: Vec<P>,
        degree: usize,
        knots: Option<Vec<f64>>,
        closed: bool,
    ) -> Result<Self, Error> {
        checked_knots(&points, degree, knots.as_deref(), closed)?;
        let count = points.len() + if closed { 1 } else { degree + 1 };
        let knots = knots.unwrap_or_else(|| (0..count).map(as_f64).collect());
        Ok(Self {
            points,
            knots,
            degree,
            closed,
        })
    }

    /// The point at the parameter u of the knots, which is clamped to the range of the curve.
    ///
    /// Σ Nᵢ(u) Pᵢ, by de Boor's algorithm. At a knot the span that starts there counts. The cost is that of checking the
    /// knots, which grows with their number, and p² steps.
    ///
    /// # Errors
    /// As [`Spline::from_bspline`]; [`Error::NotFinite`] for a u that is NaN.
    ///
    /// Source: de Boor, "On calculating with B-splines", Journal of Approximation Theory 6 (1972).
    pub fn eval(&self, u: f64) -> Result<P, Error> {
        let knots = checked_knots(&self.points, self.degree, Some(&self.knots), self.closed)?;
        if u.is_nan() {
            return Err(Error::NotFinite {
                what: "u",
                index: 0,
                got: u,
            });
        }
        let p = self.degree;
        let u = knots.in_units(u);
        let starts: Vec<usize> = knots.starts().collect();
        // The last nonempty span that starts at or before u; for a u below the range, the first one.
        let after = starts.partition_point(|&k| knots.at(k + p) <= u);
        let k = starts[after.saturating_sub(1)];
        let u = u.clamp(knots.at(k + p), knots.at(k + p + 1));
        let at = |i: usize| self.points[(k + i) % self.points.len()];
        let mut points: Vec<P> = (0..=p).map(at).collect();
        // Before level l, point i is the blossom at l − 1 times u and the knots k + i + l to k + i + p (de Boor).
        for level in 1..=p {
            for i in 0..=p - level {
                let (from, to) = (knots.at(k + i + level), knots.at(k + i + p + 1));
                points[i] = points[i].lerp(points[i + 1], (u - from) / (to - from));
            }
        }
        Ok(points[0])
    }

    /// The Bézier form; see [`Spline::from_bspline`].
    ///
    /// # Errors
    /// As [`Spline::from_bspline`].
    pub fn to_spline(&self) -> Result<Spline<P>, Error> {
        Spline::from_bspline(&self.points, self.degree, Some(&self.knots), self.closed)
    }
}

impl<P: Point> TryFrom<&BSpline<P>> for Spline<P> {
    type Error = Error;

    /// The Bézier form; see [`Spline::from_bspline`].
    fn try_from(b_spline: &BSpline<P>) -> Result<Self, Error> {
        b_spline.to_spline()
    }
}

/// The knots of a valid B-spline.
pub(crate) fn checked_knots<P: Point>(
    points: &[P],
    degree: usize,
    knots: Option<&[f64]>,
    closed: bool,
) -> Result<Knots, Error> {
    if !(1..=MAX_DEGREE).contains(&degree) {
        return Err(Error::Range {
            what: "degree",
            expected: "1 to 64",
            got: as_f64(degree),
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
    check_points("points", points)?;
    Knots::new(knots, count, degree, closed)
}

impl<P: Point> Spline<P> {
    /// The Bézier form of a B-spline: one segment of the same degree for each nonempty knot span.
    ///
    /// The control points of a segment over [a, b] are the values of its blossom at a … a b … b. They are computed by
    /// inserting a and b until each has multiplicity p (Böhm). The default knots are 0, 1, 2, …: the uniform B-spline,
    /// whose joints are (P₀ + 4P₁ + P₂)/6 for degree 3. An open B-spline passes through its first and its last point
    /// only if the knot at that end has multiplicity p (usually p + 1; the first and the last knot do not affect the
    /// curve). Segment k covers t from k to k + 1 whatever the length of its knot span; with unequal spans the
    /// derivatives at a joint are therefore parallel but not equal.
    ///
    /// A closed B-spline with n points has n spans. Segment k depends on the points k to k + p, as for an open one.
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
    /// [`Error::Range`] for a degree outside 1 to 64, [`Error::Count`] for too few points (an open B-spline needs
    /// degree + 1) or a wrong number of knots, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a
    /// knot that is smaller than its predecessor or has too high a multiplicity (an interior multiplicity above p would
    /// disconnect the curve), [`Error::TooMany`] above 1 GiB or above 2²⁸/p² segments.
    ///
    /// Sources: Böhm, "Inserting new knots into B-spline curves", 1980; Ramshaw, "Blossoms are polar forms", 1989.
    pub fn from_bspline(
        points: &[P],
        degree: usize,
        knots: Option<&[f64]>,
        closed: bool,
    ) -> Result<Self, Error> {
        let knots = checked_knots(points, degree, knots, closed)?;
        let spans = knots.spans();
        // The output has degree · spans + 1 points; a span takes at most degree² steps.
        let limit = (MAX_OUTPUT_F64 / P::DIMENSION / degree - 1).min(MAX_STEPS / degree / degree);
        if spans > limit {
            return Err(Error::too_many("segments", limit, spans));
        }
        Ok(bezier_form(points, &knots, closed))
    }

    /// The same curve as a B-spline. Its knots are the joints, each with the degree as its multiplicity, and its
    /// control points are those of the spline, so [`from_bspline`](Self::from_bspline) returns exactly this spline.
    ///
    /// # Errors
    /// [`Error::Item`] for a segment whose degree differs from that of the first one.
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
            // One period: the last joint equals the first one.
            knots.extend(repeated.take(points.len() + 1));
            // Control point p − 1 is the blossom at the p copies of the first joint, which is the start of the spline.
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
    // The knots on which a span depends: p up to its start, its end, and p − 1 after it.
    let mut local = vec![0.0; 2 * degree + 1];
    for k in knots.starts() {
        let at = |i: usize| points[(k + i) % points.len()];
        segment.iter_mut().enumerate().for_each(|(i, p)| *p = at(i));
        local
            .iter_mut()
            .enumerate()
            .for_each(|(i, u)| *u = knots.at(k + i));
        to_bezier(&mut segment, &local);
        // The last point is the first one of the next segment.
        all.extend_from_slice(&segment[..degree]);
    }
    if !closed {
        all.push(segment[degree]);
    }
    Spline::from_parts(all, &vec![degree; spans], closed)
}

/// Converts the de Boor points of the span [a, b] between the knots uₚ and uₚ₊₁ to Bézier control points.
///
/// With f the blossom of the segment, point i is initially f(uᵢ₊₁ … uᵢ₊ₚ). Inserting a gives f(a … a uₚ₊₁ … uₚ₊ᵢ), with
/// i knots from b on; inserting b gives f(a … a b … b).
pub(crate) fn to_bezier<P: Interpolate>(points: &mut [P], u: &[f64]) {
    let p = points.len() - 1;
    let (a, b) = (u[p], u[p + 1]);
    // Insert a until p − i arguments of point i are a; at first uₚ is one.
    for level in 1..p {
        for i in 0..p - level {
            let (from, to) = (u[i + level], u[i + p + 1]);
            points[i] = lerp(points[i], points[i + 1], (a - from) / (to - from));
        }
    }
    // Insert b until i arguments of point i are b. In descending order of i, point i − 1 is not updated yet.
    for level in 1..p {
        for i in (level + 1..=p).rev() {
            let to = u[p + i - level + 1];
            points[i] = lerp(points[i - 1], points[i], (b - a) / (to - a));
        }
    }
}
