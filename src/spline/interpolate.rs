//! Interpolating cubic splines: natural and Catmull-Rom.

use super::Spline;
use super::joint::catmull_rom;
use crate::curve::eval::MAX_OUTPUT_F64;
use crate::geometry::check::{check_points, is_within_limit};
use crate::geometry::error::Error;
use crate::geometry::point::Point;

/// The kind of interpolating spline.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Interpolation {
    /// The natural cubic spline: the second derivatives are equal at all joints and zero at open ends. Each point
    /// affects the whole curve; its influence decreases to about a quarter from joint to joint.
    #[default]
    Natural,
    /// The Catmull-Rom spline: the tangent at a point depends on the point and its two neighbours. The tangent
    /// directions are equal at the joints; for `alpha` = 0 the derivatives are equal too.
    CatmullRom {
        /// The exponent of the chord lengths, 0 (uniform) to 1 (chordal); ½ (centripetal) avoids cusps and loops within
        /// a segment.
        alpha: f64,
    },
}

/// The pole of the recursive filter that inverts (1, 4, 1): √3 − 2.
const FILTER_POLE: f64 = -0.267_949_192_431_122_7;

/// After this many steps the power of the pole is below the rounding error of 1: 0.268³² = 5·10⁻¹⁹.
const FILTER_STEPS: usize = 32;

impl<P: Point> Spline<P> {
    /// A cubic spline through points; its joints are the points, at t = 0, 1, 2, …
    ///
    /// Natural: the derivatives Dᵢ at the points Pᵢ satisfy Dᵢ₋₁ + 4Dᵢ + Dᵢ₊₁ = 3(Pᵢ₊₁ − Pᵢ₋₁), and 2D₀ + D₁ = 3(P₁ −
    /// P₀) at an open end; the handles are Pᵢ ± Dᵢ/3. Catmull-Rom: with d₁ and d₂ the lengths of the chords at Pᵢ to
    /// the power alpha, T = (Pᵢ − Pᵢ₋₁)/d₁ − (Pᵢ₊₁ − Pᵢ₋₁)/(d₁ + d₂) + (Pᵢ₊₁ − Pᵢ)/d₂; the handles are Pᵢ − T d₁/3 and
    /// Pᵢ + T d₂/3; at an open end the handle is at a third of the chord. Two equal consecutive points make a corner of
    /// a Catmull-Rom spline with alpha > 0: each side ends there as at an open end.
    ///
    /// Takes 2 points or more. Two points give a straight line; a closed spline runs along it and back.
    ///
    /// ```
    /// use casteljau::{Spline, spline::Interpolation, glam::DVec2};
    ///
    /// let points = [(0.0, 0.0), (1.0, 1.0), (3.0, 1.0), (4.0, 0.0)].map(DVec2::from);
    /// let spline = Spline::interpolate(&points, Interpolation::Natural, false)?;
    /// assert_eq!(spline.eval(2.0), points[2]);
    /// assert!(spline.continuity(1)?.c2);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than 2 points, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Range`] for an
    /// alpha outside 0 to 1, [`Error::TooMany`] above 1 GiB.
    ///
    /// Sources: Unser, "Splines: a perfect fit for signal and image processing", 1999 (the recursive filter); Yuksel,
    /// Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.
    pub fn interpolate(points: &[P], kind: Interpolation, closed: bool) -> Result<Self, Error> {
        let Interpolation::CatmullRom { alpha } = kind else {
            return Self::interpolate_with(points, closed, None);
        };
        if !(0.0..=1.0).contains(&alpha) {
            return Err(Error::Range {
                what: "alpha",
                expected: "0 to 1",
                got: alpha,
            });
        }
        Self::interpolate_with(points, closed, Some(&|length| power(length, alpha)))
    }

    /// The Catmull-Rom spline with the parameter steps `step(chord length)`; `None` gives the natural spline.
    pub(crate) fn interpolate_with(
        points: &[P],
        closed: bool,
        step: Option<&dyn Fn(f64) -> f64>,
    ) -> Result<Self, Error> {
        let count = points.len();
        if count < 2 {
            return Err(Error::Count {
                what: "points",
                expected: "at least 2 points",
                got: count,
            });
        }
        let limit = MAX_OUTPUT_F64 / (3 * P::DIMENSION);
        if count > limit {
            return Err(Error::too_many("points", limit, count));
        }
        check_points("points", points)?;
        let sequence = PointSequence { points, closed };
        let derivatives = match step {
            None => sequence.natural_derivatives(),
            Some(step) => sequence.catmull_rom(step),
        };
        let handle = |i: usize, along: P| {
            let handle = points[i] + along / 3.0;
            // Near the limit of coordinates a handle can exceed it; it is then placed at the point.
            if is_within_limit(handle) {
                handle
            } else {
                points[i]
            }
        };
        let segments = count - usize::from(!closed);
        let mut all = Vec::with_capacity(3 * segments + 1);
        for i in 0..segments {
            let next = (i + 1) % count;
            all.extend([
                points[i],
                handle(i, derivatives[i].1),
                handle(next, -derivatives[next].0),
            ]);
        }
        if !closed {
            all.push(points[segments]);
        }
        Ok(Self::from_parts(all, &vec![3; segments], closed))
    }
}

/// `length` to the power `alpha`, 0 to 1: the product of its square root, fourth root … for the binary digits of alpha.
/// Accurate to some ulps, and independent of the power function of the standard library.
fn power(length: f64, alpha: f64) -> f64 {
    if alpha >= 1.0 {
        return length;
    }
    let (mut product, mut root, mut rest) = (1.0, length, alpha);
    // Invariant: the result is product · root^rest.
    while rest > 0.0 && root != 1.0 {
        (root, rest) = (root.sqrt(), 2.0 * rest);
        if rest >= 1.0 {
            product *= root;
            rest -= 1.0;
        }
    }
    product
}

/// The points to interpolate, open or closed.
struct PointSequence<'a, P> {
    points: &'a [P],
    closed: bool,
}

impl<P: Point> PointSequence<'_, P> {
    /// The indices of the neighbours of a point; at an open end the missing neighbour is the point itself.
    fn neighbours(&self, i: usize) -> (usize, usize) {
        let count = self.points.len();
        if self.closed {
            ((i + count - 1) % count, (i + 1) % count)
        } else {
            (i.saturating_sub(1), (i + 1).min(count - 1))
        }
    }

    /// At each point, the derivative of the segment before it and of the segment after it.
    fn catmull_rom(&self, step: &dyn Fn(f64) -> f64) -> Vec<(P, P)> {
        let derivatives = |i: usize| {
            let (before, after) = self.neighbours(i);
            let points = [before, i, after].map(|k| self.points[k]);
            let step = |from: usize, to: usize, chord: P| {
                if from == to { 0.0 } else { step(chord.norm()) }
            };
            let steps = [
                step(before, i, points[1] - points[0]),
                step(i, after, points[2] - points[1]),
            ];
            let (ahead, behind) = catmull_rom(points, steps);
            (behind, ahead)
        };
        (0..self.points.len()).map(derivatives).collect()
    }

    /// The derivatives of the natural spline at each point, where both are equal.
    ///
    /// The system (1, 4, 1) is solved by a forward and a backward recursive filter, each of which needs only its
    /// previous value. Both start some steps early, where earlier values have no weight: on the periodic continuation
    /// of a closed spline, or on the mirror image beyond an open end (the natural spline continues by point reflection
    /// at its end, so its derivatives are mirrored).
    fn natural_derivatives(&self) -> Vec<(P, P)> {
        let count = self.points.len();
        let period = if self.closed { count } else { 2 * (count - 1) };
        let right = |i: usize| {
            // Index into the period: the closed sequence, or the open one and its mirror image.
            let i = i % period;
            let i = if i < count { i } else { period - i };
            let (before, after) = self.neighbours(i);
            let at_end = !self.closed && (i == before || i == after);
            // At an open end D₋₁ = D₁, so the equation is twice 2D₀ + D₁ = 3(P₁ − P₀).
            (self.points[after] - self.points[before]) * if at_end { 6.0 } else { 3.0 }
        };
        // Start a whole number of periods before the first point.
        let early = FILTER_STEPS.div_ceil(period) * period;
        let mut found = Vec::with_capacity(count + FILTER_STEPS);
        // 1/(x + 4 + 1/x) = −z / ((1 − z x)(1 − z/x)) with the pole z: a forward and a backward filter.
        let mut forward = P::default();
        for i in early - FILTER_STEPS..early + count + FILTER_STEPS {
            forward = right(i) + forward * FILTER_POLE;
            if i >= early {
                found.push((forward, forward));
            }
        }
        let mut back = P::default();
        for pair in found.iter_mut().rev() {
            back = pair.0 + back * FILTER_POLE;
            *pair = (back * -FILTER_POLE, back * -FILTER_POLE);
        }
        found.truncate(count);
        found
    }
}
