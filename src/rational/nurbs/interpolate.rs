//! Interpolation of points.

use super::NurbsCurve;
use crate::geometry::check::check_points;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::spline::bspline::MAX_STEPS;

impl<P: Point> NurbsCurve<P> {
    /// The B-spline curve of a degree through points, over the domain [0, 1], with the weights 1.
    ///
    /// The parameters of the points grow with the square roots of the chord lengths (centripetal), and each inner knot is the
    /// mean of p parameters; so the equations Σ Nⱼ(tᵢ) Pⱼ = Qᵢ have a solution, which is found by elimination within their
    /// band, in p² steps for each point. Equal neighbours count as one point.
    ///
    /// # Errors
    /// [`Error::Range`] for a degree outside 1 to 64, [`Error::Count`] for fewer than degree + 1 points of which neighbours
    /// differ, [`Error::NotFinite`] and [`Error::Item`] for coordinates, [`Error::TooMany`] above 2²⁸/p² points,
    /// [`Error::Singular`] if a distance is lost to rounding in the sum of the others.
    ///
    /// Sources: Piegl and Tiller, *The NURBS Book*, §9.2.1; Lee, "Choosing nodes in parametric curve interpolation", CAD 21
    /// (1989); de Boor, *A Practical Guide to Splines*, ch. XIII, for elimination without exchange of rows.
    pub fn interpolate(points: &[P], degree: usize) -> Result<Self, Error> {
        if !(1..=MAX_DEGREE).contains(&degree) {
            return Err(Error::Range {
                what: "degree",
                expected: "1 to 64",
                got: as_f64(degree),
            });
        }
        check_points("points", points)?;
        let mut through = points.to_vec();
        through.dedup();
        let (count, p) = (through.len(), degree);
        if count < p + 1 {
            return Err(Error::Count {
                what: "points",
                expected: "at least degree + 1 points that differ from the one before",
                got: count,
            });
        }
        let limit = MAX_STEPS / (p * p);
        if count > limit {
            return Err(Error::too_many("points", limit, count));
        }
        let ts = centripetal(&through);
        if !ts.windows(2).all(|pair| pair[0] < pair[1]) {
            return Err(Error::Singular { what: "points" });
        }
        let mut knots = vec![0.0; p + 1];
        knots.extend((1..count - p).map(|j| ts[j..j + p].iter().sum::<f64>() / as_f64(p)));
        knots.extend(std::iter::repeat_n(1.0, p + 1));
        let solved = solved(&through, &ts, &knots, p);
        Self::new(p, &solved, None, &knots, false)
    }
}

/// Parameters from 0 to 1 whose differences are proportional to the square roots of the distances.
pub(in crate::rational) fn centripetal<P: Point>(points: &[P]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut ts = vec![0.0];
    ts.extend(points.windows(2).map(|pair| {
        sum += pair[1].distance(pair[0]).sqrt();
        sum
    }));
    let last = ts.len() - 1;
    ts.iter_mut().for_each(|t| *t /= sum);
    ts[last] = 1.0;
    ts
}

/// The control points for which the curve has the given points at the given parameters.
pub(in crate::rational) fn solved<P: Point>(
    points: &[P],
    ts: &[f64],
    knots: &[f64],
    p: usize,
) -> Vec<P> {
    let count = points.len();
    // Row i has the p + 1 values of the B-splines that are not 0 at tᵢ, the first of which has the index `starts[i]`.
    let mut starts = Vec::with_capacity(count);
    let mut rows = Vec::with_capacity(count);
    for &t in ts {
        let span = (knots.partition_point(|&u| u <= t) - 1).min(count - 1);
        starts.push(span - p);
        rows.push(basis(knots, span, p, t));
    }
    let mut right = points.to_vec();
    // The matrix is totally positive, so no rows need to be exchanged.
    for i in 0..count {
        for below in i + 1..(i + p + 1).min(count) {
            if starts[below] > i {
                break;
            }
            let factor = rows[below][i - starts[below]] / rows[i][i - starts[i]];
            let end = starts[i] + p;
            for column in i..=end {
                let value = rows[i][column - starts[i]] * factor;
                rows[below][column - starts[below]] -= value;
            }
            right[below] = right[below] - right[i] * factor;
        }
    }
    for i in (0..count).rev() {
        let mut sum = right[i];
        for column in i + 1..=(starts[i] + p).min(count - 1) {
            sum = sum - right[column] * rows[i][column - starts[i]];
        }
        right[i] = sum / rows[i][i - starts[i]];
    }
    right
}

/// The values of the p + 1 B-splines that are not 0 in a span. Source: Piegl and Tiller, *The NURBS Book*, algorithm A2.2.
fn basis(knots: &[f64], span: usize, p: usize, t: f64) -> Vec<f64> {
    let mut values = vec![1.0];
    for level in 1..=p {
        let mut carry = 0.0;
        for (r, value) in values.iter_mut().enumerate() {
            let (above, below) = (knots[span + r + 1], knots[span + 1 + r - level]);
            let part = *value / (above - below);
            *value = carry + (above - t) * part;
            carry = (t - below) * part;
        }
        values.push(carry);
    }
    values
}
