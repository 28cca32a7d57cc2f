//! Knot vectors of B-splines, open or periodic.

use crate::geometry::error::Error;

/// Knots above this value are scaled by 2⁻¹⁰, so that no difference and no sum of 64 periods overflows. Only ratios of
/// differences affect the curve.
const HUGE: f64 = 1e300;

/// Knots in ascending order with valid multiplicities.
pub(crate) struct Knots {
    values: Vec<f64>,
    /// A knot of the caller is the sum of a value and `start`, times `unit`.
    start: f64,
    unit: f64,
    /// The number of control points.
    count: usize,
    degree: usize,
    closed: bool,
}

impl Knots {
    /// The knots for `count` control points; the default is 0, 1, 2, …
    pub(crate) fn new(
        explicit: Option<&[f64]>,
        count: usize,
        degree: usize,
        closed: bool,
    ) -> Result<Self, Error> {
        let needed = if closed {
            count + 1
        } else {
            count + degree + 1
        };
        let mut values = match explicit {
            None => (0..needed).map(|i| i as f64).collect(),
            Some(explicit) => explicit.to_vec(),
        };
        if values.len() != needed {
            return Err(Error::Count {
                what: "knots",
                expected: if !closed && values.len() + 2 == needed {
                    "points + degree + 1 knots (rhino3dm leaves out the first and the last one)"
                } else {
                    "points + degree + 1 knots (closed: points + 1)"
                },
                got: values.len(),
            });
        }
        Error::unless_finite("knots", &values)?;
        let is_huge = values.iter().any(|u| u.abs() > HUGE);
        let unit = if is_huge { 1024.0 } else { 1.0 };
        values.iter_mut().for_each(|u| *u /= unit);
        // With the start at 0, the first and the last knot of a period are exactly one period apart.
        let start = if closed { values[0] } else { 0.0 };
        values.iter_mut().for_each(|u| *u -= start);
        let knots = Self {
            values,
            start,
            unit,
            count,
            degree,
            closed,
        };
        match knots.first_invalid() {
            None => Ok(knots),
            Some((index, expected)) => Err(Error::Item {
                what: "knots",
                index,
                expected,
                got: explicit.map_or(0.0, |explicit| explicit[index]),
            }),
        }
    }

    /// The index of the first invalid knot, and what a valid one must satisfy.
    fn first_invalid(&self) -> Option<(usize, &'static str)> {
        let (v, p, n) = (&self.values, self.degree, self.count);
        if let Some(index) = v.windows(2).position(|pair| pair[0] > pair[1]) {
            return Some((index + 1, "a knot not below the one before it"));
        }
        let (first, last) = if self.closed { (0, n) } else { (p, n) };
        if v[first] == v[last] {
            return Some((last, "a knot above that where the curve starts"));
        }
        if self.closed {
            // degree + 1 equal knots would disconnect the curve, also across the end of the period.
            let parted = (0..n).find(|&i| self.at(i + p) == self.at(i + 2 * p));
            return parted.map(|i| ((i + p).min(n), "at most degree times the same knot"));
        }
        // If the knots i and i + p + 1 are equal, the basis function of point i is 0 everywhere.
        if let Some(i) = (0..n).find(|&i| v[i] == v[i + p + 1]) {
            return Some((i + p + 1, "at most degree + 1 times the same knot"));
        }
        // At the ends p + 1 equal knots are usual; inside they would disconnect the curve.
        let inside = |i: &usize| v[first] < v[*i] && v[*i] < v[last];
        let parted = (p..n).filter(inside).find(|&i| v[i] == v[i + p]);
        parted.map(|i| (i + p, "at most degree times the same knot inside"))
    }

    /// A parameter of the caller in the units of these knots.
    pub(crate) fn in_units(&self, u: f64) -> f64 {
        u / self.unit - self.start
    }

    pub(crate) fn degree(&self) -> usize {
        self.degree
    }

    /// Knot i of the (periodically extended) knot vector of the control points 0, 1, 2, …
    pub(crate) fn at(&self, i: usize) -> f64 {
        if !self.closed {
            return self.values[i];
        }
        // The first joint is preceded by `degree` knots.
        let (n, period) = (self.count, self.values[self.count]);
        // Whole periods are added before the division, so that the index is not negative.
        let turns = self.degree.div_ceil(n);
        let from_before = i + turns * n - self.degree;
        let turn = (from_before / n) as f64 - turns as f64;
        match self.values[from_before % n] {
            // Equal to the first knot of the next period, also after rounding.
            value if value == period => (turn + 1.0) * period,
            value => value + turn * period,
        }
    }

    /// The index of the first control point of each nonempty knot span.
    pub(crate) fn starts(&self) -> impl Iterator<Item = usize> {
        let p = self.degree;
        let all = if self.closed {
            self.count
        } else {
            self.count - p
        };
        (0..all).filter(move |&k| self.at(k + p) < self.at(k + p + 1))
    }

    pub(crate) fn spans(&self) -> usize {
        self.starts().count()
    }
}
