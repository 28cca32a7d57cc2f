//! Knot insertion, knot removal, and splitting.

use super::NurbsCurve;
use crate::curve::split::ends_of;
use crate::geometry::bounds::Bounds;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, unit_scale};
use crate::rational::weighted::{Homogeneous, WeightedPoint};
use casteljau_kernels::numeric::vector::Interpolate;
use std::ops::RangeBounds;

impl<P: Point> NurbsCurve<P> {
    /// The same curve with the knot t inserted `times` times.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a t that is not finite, [`Error::Range`] for one outside the domain and for more than p times
    /// the same knot inside.
    ///
    /// Source: Böhm, "Inserting new knots into B-spline curves", CAD 12 (1980).
    pub fn insert_knot(&self, t: f64, times: usize) -> Result<Self, Error> {
        let free = self.degree.saturating_sub(self.multiplicity(t));
        if times > free {
            return Err(Error::Range {
                what: "times",
                expected: "at most as many as make the knot's multiplicity the degree",
                got: as_f64(times),
            });
        }
        self.refine(&vec![t; times])
    }

    /// The same curve with knots inserted, in any order.
    ///
    /// The cost grows with the number of points and with p steps for each knot.
    ///
    /// # Errors
    /// As [`insert_knot`](Self::insert_knot), with [`Error::Item`] for a knot outside the domain or of too high a multiplicity.
    ///
    /// Source: Piegl and Tiller, *The NURBS Book*, algorithm A5.4.
    pub fn refine(&self, ts: &[f64]) -> Result<Self, Error> {
        Error::unless_finite("ts", ts)?;
        let [from, to] = self.domain();
        let mut knots = ts.to_vec();
        knots.sort_by(f64::total_cmp);
        let mut run = 0;
        for (i, &t) in knots.iter().enumerate() {
            run = if i > 0 && knots[i - 1] == t {
                run + 1
            } else {
                1
            };
            let fault = if !(from..=to).contains(&t) {
                "a knot in the domain of the curve"
            } else if self.multiplicity(t) + run > self.degree {
                "at most degree times the same knot"
            } else {
                continue;
            };
            let index = ts.iter().position(|&u| u == t).unwrap_or(0);
            return Err(Error::Item {
                what: "ts",
                index,
                expected: fault,
                got: t,
            });
        }
        if knots.is_empty() {
            return Ok(self.clone());
        }
        if !self.closed {
            let (all, parts) = refined(&self.knots, &self.weighted(), self.degree, &knots);
            return Ok(self.with_parts(self.degree, &parts, all));
        }
        let (parts, first) = self.refined_period(&knots);
        let count = self.points.len() + knots.len();
        let parts = &parts[first..first + count];
        let inserted = knots.iter().map(|&t| if t == to { from } else { t });
        let mut period: Vec<f64> = self.knots.iter().copied().chain(inserted).collect();
        period.sort_by(f64::total_cmp);
        Ok(self.with_parts(self.degree, parts, period))
    }

    /// The control points of an unwrapped closed curve after the insertion of knots in every period, and the index of the first one of
    /// the period.
    fn refined_period(&self, knots: &[f64]) -> (Vec<WeightedPoint<P>>, usize) {
        let (n, p) = (self.points.len(), self.degree);
        // The points of a period depend on the next p knots on both sides.
        let turns = p.div_ceil(n) + 1;
        let (all, parts) = self.unwrapped(turns);
        let (from, to) = (all[p], all[parts.len()]);
        let [start, end] = self.domain();
        let period = end - start;
        let images = (0..=2 * turns).flat_map(|k| {
            let turn = as_f64(k) - as_f64(turns);
            knots.iter().map(move |&t| {
                let t = if t == end { start } else { t };
                t + turn * period
            })
        });
        let mut images: Vec<f64> = images.filter(|t| (from..=to).contains(t)).collect();
        images.sort_by(f64::total_cmp);
        let before = images.iter().filter(|&&t| t < start).count();
        let (_, parts) = refined(&all, &parts, p, &images);
        (parts, turns * n + before)
    }

    /// How often a knot occurs, across the end of the period as well; at the ends of an open curve at most p.
    fn multiplicity(&self, t: f64) -> usize {
        let count = |t: f64| self.knots.iter().filter(|&&u| u == t).count();
        let [start, end] = self.domain();
        if self.closed && (t == start || t == end) {
            return count(start) + count(end) - 1;
        }
        count(t).min(self.degree)
    }

    /// A curve of the same kind.
    pub(super) fn with_parts(
        &self,
        degree: usize,
        parts: &[WeightedPoint<P>],
        knots: Vec<f64>,
    ) -> Self {
        let points = parts.iter().map(|part| part.point).collect();
        let weights = parts.iter().map(|part| part.weight).collect();
        self.rebuilt(degree, points, weights, knots)
    }

    /// The curve with the knot t removed once, and a bound on its distance from this curve at equal parameters.
    ///
    /// The new control points are computed from both sides; where the sides meet they differ by what the removal changes. The
    /// bound is 0 up to rounding if the curve is as smooth at t as without the knot. Removing the last copy of a knot joins two
    /// segments.
    ///
    /// # Errors
    /// [`Error::Range`] if t is not a knot inside the domain, [`Error::Item`] if a new weight would not be above 0 or a new
    /// coordinate beyond the limit: then no curve without the knot is near.
    ///
    /// Sources: Tiller, "Knot-removal algorithms for NURBS curves and surfaces", CAD 24 (1992), for the points; the bound is that
    /// of a quotient: |wᵢ(Pᵢ − c) − vᵢ(Qᵢ − c)| + ρ |wᵢ − vᵢ|, divided by the smallest weight, for points within ρ of c.
    pub fn remove_knot(&self, t: f64) -> Result<(Self, f64), Error> {
        let [start, end] = self.domain();
        let is_knot = self.knots.contains(&t) && start < t && t < end;
        let enough = self.points.len() > if self.closed { 1 } else { self.degree + 1 };
        if !is_knot || !enough {
            return Err(Error::Range {
                what: "t",
                expected: "a knot inside the domain",
                got: t,
            });
        }
        let (n, p) = (self.points.len(), self.degree);
        let mut knots = self.knots.clone();
        knots.remove(last_index(&knots, t));
        if !self.closed {
            let parts = removed(&self.knots, &self.weighted(), p, t);
            return self.without_knot(t, &parts, knots);
        }
        // It is removed in every period of the unwrapped curve, whose points in the middle do not depend on the ends.
        let turns = p.div_ceil(n) + 1;
        let (mut all, mut parts) = self.unwrapped(turns);
        let mut first = turns * n;
        for k in 0..=2 * turns {
            let image = t + (as_f64(k) - as_f64(turns)) * (end - start);
            let r = last_index(&all, image);
            if r > p && r < parts.len() {
                parts = removed(&all, &parts, p, image);
                all.remove(r);
                first -= usize::from(image < start);
            }
        }
        self.without_knot(t, &parts[first..first + n - 1], knots)
    }

    /// The curve of new control points and knots, and a bound on its distance.
    fn without_knot(
        &self,
        t: f64,
        parts: &[WeightedPoint<P>],
        knots: Vec<f64>,
    ) -> Result<(Self, f64), Error> {
        let points: Vec<P> = parts.iter().map(|part| part.point).collect();
        let weights: Vec<f64> = parts.iter().map(|part| part.weight).collect();
        let curve = Self::new(self.degree, &points, Some(&weights), &knots, self.closed)?;
        let error = self.difference(&curve.insert_knot(t, 1)?);
        Ok((curve, error))
    }

    /// A bound on the distance at equal parameters from a curve with the same knots.
    fn difference(&self, other: &Self) -> f64 {
        let bounds = Bounds::from_points(&self.points).union(Bounds::from_points(&other.points));
        let center = bounds.min.lerp(bounds.max, 0.5);
        let radius = bounds.max.distance(center);
        let scale = unit_scale(self.weights.iter().copied().fold(0.0, f64::max));
        let at = |curve: &Self, i: usize| {
            Homogeneous::new(curve.points[i] - center, curve.weights[i] * scale)
        };
        let differences = (0..self.points.len()).map(|i| {
            let off = at(self, i) - at(other, i);
            off.vector.norm() + radius * off.weight.abs()
        });
        let min = self.weights.iter().copied().fold(f64::INFINITY, f64::min);
        differences.fold(0.0, f64::max) / (min * scale)
    }

    /// Splits the curve at t into two open curves, whose knots at t have the multiplicity p + 1.
    ///
    /// The domains of both together are that of the curve.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a t that is not finite, [`Error::Range`] unless it is inside the domain.
    pub fn split(&self, t: f64) -> Result<(Self, Self), Error> {
        let [start, end] = self.domain();
        self.check_inside("t", t)?;
        if t <= start || t >= end {
            return Err(Error::Range {
                what: "t",
                expected: "a number inside the domain of the curve",
                got: t,
            });
        }
        Ok((self.part(start, t), self.part(t, end)))
    }

    /// The part in a range of t, as an open curve with that domain; a decreasing range gives the reversed part.
    ///
    /// A range without a start begins with the domain, one without an end ends with it. A part of length 0 is refused.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a bound that is not finite, [`Error::Range`] for one outside the domain, and for equal ones.
    pub fn subsegment(&self, range: impl RangeBounds<f64>) -> Result<Self, Error> {
        let [start, end] = self.domain();
        let [t0, t1] = ends_of(&range, end);
        let t0 = if matches!(range.start_bound(), std::ops::Bound::Unbounded) {
            start
        } else {
            t0
        };
        self.check_inside("t0", t0)?;
        self.check_inside("t1", t1)?;
        if t0 == t1 {
            return Err(Error::Range {
                what: "t1",
                expected: "another parameter than the start",
                got: t1,
            });
        }
        if t0 > t1 {
            return Ok(self.part(t1, t0).reverse());
        }
        Ok(self.part(t0, t1))
    }

    fn check_inside(&self, what: &'static str, t: f64) -> Result<(), Error> {
        Error::unless_finite(what, &[t])?;
        let [start, end] = self.domain();
        if (start..=end).contains(&t) {
            return Ok(());
        }
        Err(Error::Range {
            what,
            expected: "a number in the domain of the curve",
            got: t,
        })
    }

    /// The part from t₀ to t₁, two different parameters of the domain in ascending order.
    pub(super) fn part(&self, t0: f64, t1: f64) -> Self {
        let p = self.degree;
        let (all, parts) = self.unwrapped(0);
        let mut knots = Vec::new();
        for t in [t0, t1] {
            let present = all.iter().filter(|&&u| u == t).count();
            knots.extend(std::iter::repeat_n(t, p.saturating_sub(present)));
        }
        let (all, parts) = refined(&all, &parts, p, &knots);
        // The last of the knots t₀, and the first of the knots t₁.
        let (from, to) = (
            last_index(&all, t0),
            all.iter().position(|&u| u == t1).unwrap_or(all.len() - 1),
        );
        let inner = &all[from + 1..to];
        let mut knots = vec![t0; p + 1];
        knots.extend_from_slice(inner);
        knots.extend(std::iter::repeat_n(t1, p + 1));
        let parts = &parts[from - p..=from + inner.len()];
        let open = Self {
            closed: false,
            ..self.clone()
        };
        open.with_parts(p, parts, knots)
    }
}

/// The index of the last knot that is equal to t, or less if there is none.
fn last_index(knots: &[f64], t: f64) -> usize {
    knots.partition_point(|&u| u <= t).saturating_sub(1)
}

/// Inserts knots, which are in ascending order and inside the domain of an open curve.
///
/// From the last new knot to the first, existing points move up, and p − 1 points before the knot are replaced by points
/// between two neighbours. Source: Piegl and Tiller, *The NURBS Book*, algorithm A5.4.
fn refined<V: Interpolate + Default>(
    knots: &[f64],
    points: &[V],
    p: usize,
    new: &[f64],
) -> (Vec<f64>, Vec<V>) {
    let count = points.len();
    // The span of a new knot; that of the end of the domain is the last one.
    let span = |t: f64| last_index(knots, t).min(count - 1);
    let [Some(&first), Some(&last)] = [new.first(), new.last()] else {
        return (knots.to_vec(), points.to_vec());
    };
    let (a, b, added) = (span(first), span(last) + 1, new.len());
    let mut all = vec![0.0; knots.len() + added];
    let mut result = vec![V::default(); count + added];
    result[..=a - p].copy_from_slice(&points[..=a - p]);
    result[b - 1 + added..].copy_from_slice(&points[b - 1..]);
    all[..=a].copy_from_slice(&knots[..=a]);
    all[b + p + added..].copy_from_slice(&knots[b + p..]);
    let (mut i, mut k) = (b + p - 1, b + p + added - 1);
    for &t in new.iter().rev() {
        while t <= knots[i] && i > a {
            result[k - p - 1] = points[i - p - 1];
            all[k] = knots[i];
            (i, k) = (i - 1, k - 1);
        }
        result[k - p - 1] = result[k - p];
        for l in 1..=p {
            let index = k - p + l;
            let (above, width) = (all[k + l] - t, all[k + l] - knots[i + l - p]);
            result[index - 1] = if above == 0.0 {
                result[index]
            } else {
                result[index].interpolate(result[index - 1], above / width)
            };
        }
        all[k] = t;
        k -= 1;
    }
    (all, result)
}

/// The control points without one copy of the knot t.
///
/// With r the last index of t and s its multiplicity, the points r − p to r − s change: point i is computed from its predecessor
/// on the left side, from its successor on the right side. Source: Piegl and Tiller, *The NURBS Book*, algorithm A5.8.
fn removed<P: Point>(
    knots: &[f64],
    parts: &[WeightedPoint<P>],
    p: usize,
    t: f64,
) -> Vec<WeightedPoint<P>> {
    let r = last_index(knots, t);
    let s = knots.iter().filter(|&&u| u == t).count();
    let scale = unit_scale(parts.iter().map(|part| part.weight).fold(0.0, f64::max));
    let mut points: Vec<Homogeneous<P>> = parts
        .iter()
        .map(|part| Homogeneous::new(part.point, part.weight * scale))
        .collect();
    let (mut left, mut right) = (r - p, r - s);
    while left < right {
        let share = |i: usize| (t - knots[i]) / (knots[i + p + 1] - knots[i]);
        let (a, b) = (share(left), share(right));
        // P_left = a Q_left + (1 − a) Q_left−1, and likewise on the right with its successor.
        let (before, after) = (points[left - 1], points[right + 1]);
        points[left] = (points[left] - before * (1.0 - a)) * (1.0 / a);
        points[right] = (points[right] - after * b) * (1.0 / (1.0 - b));
        (left, right) = (left + 1, right - 1);
    }
    // The two sides meet in one point, or in two that are to be equal.
    let dropped = if left == right { left } else { right };
    points.remove(dropped);
    let from = r - p;
    let mut kept: Vec<WeightedPoint<P>> = Vec::with_capacity(points.len());
    for (i, point) in points.into_iter().enumerate() {
        let old = if i < from {
            Some(parts[i])
        } else if i + 1 > r - s {
            parts.get(i + 1).copied()
        } else {
            None
        };
        kept.push(old.unwrap_or_else(|| WeightedPoint {
            point: point.point(),
            weight: point.weight / scale,
        }));
    }
    kept
}
