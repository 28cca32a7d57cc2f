//! Degree elevation.

use super::Curve;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::ratio;

impl<P: Point> Curve<P> {
    /// The same curve with degree n + 1, and so with one more control point.
    ///
    /// Qᵢ = (i Pᵢ₋₁ + (n + 1 − i) Pᵢ) / (n + 1), Q₀ = P₀, Qₙ₊₁ = Pₙ. Source: Farin, *Curves and Surfaces for CAGD*, 5th
    /// ed., §6.1.
    ///
    /// # Errors
    /// [`Error::Range`] at degree 64.
    pub fn elevate(&self) -> Result<Self, Error> {
        if self.degree() >= MAX_DEGREE {
            return Err(Error::Range {
                what: "degree",
                expected: "a degree below 64",
                got: 64.0,
            });
        }
        Ok(self.elevated())
    }

    /// [`elevate`](Self::elevate) for a curve whose degree is known to be below 64.
    pub(crate) fn elevated(&self) -> Self {
        let count = self.points.len();
        let inner = (1..count).map(|i| self.points[i].lerp(self.points[i - 1], ratio(i, count)));
        let ends = |p: P| std::iter::once(p);
        Self {
            points: ends(self.start())
                .chain(inner)
                .chain(ends(self.end()))
                .collect(),
        }
    }
}
