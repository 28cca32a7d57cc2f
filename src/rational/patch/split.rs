//! Splitting, isocurves and degree elevation of rational patches.

use super::RationalPatch;
use crate::curve::elevate::elevate_once;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::numeric::list::{Points, points_of};
use crate::rational::RationalCurve;
use crate::rational::weighted::{WeightedPoint, transposed};
use casteljau_kernels::bernstein::de_casteljau::{keep_after, lerp, split_net_with};
use glam::DVec3;

impl RationalPatch {
    /// Splits the patch at u into two patches of the same degrees: before u and after u.
    ///
    /// Both have the same control points and weights along the isocurve at u, and the outer corners are exact.
    ///
    /// # Errors
    /// As [`RationalCurve::split`].
    pub fn split_u(&self, u: f64) -> Result<(Self, Self), Error> {
        Error::unless_finite("u", &[u])?;
        self.split_along(u, true)
    }

    /// Splits the patch at v into two patches: before v and after v; see [`split_u`](Self::split_u).
    ///
    /// # Errors
    /// As there.
    pub fn split_v(&self, v: f64) -> Result<(Self, Self), Error> {
        Error::unless_finite("v", &[v])?;
        self.split_along(v, false)
    }

    fn split_along(&self, t: f64, along_u: bool) -> Result<(Self, Self), Error> {
        let (before, after) = self.split_unchecked(t, along_u);
        Ok((before.checked()?, after.checked()?))
    }

    /// The two halves at ½.
    pub(in crate::rational) fn halves(&self, along_u: bool) -> (Self, Self) {
        self.split_unchecked(0.5, along_u)
    }

    fn split_unchecked(&self, t: f64, along_u: bool) -> (Self, Self) {
        let columns = self.net.columns;
        let mut before = self.weighted();
        let mut after = before.clone();
        let between = |a, b| lerp(a, b, t);
        split_net_with(&mut before, &mut after, columns, along_u, between);
        let [before, after] = [before, after].map(|parts| Self::from_weighted(&parts, columns));
        (before, after)
    }

    /// The curve u = constant, of degree n in v, from S(u, 0) to S(u, 1).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a u that is not finite; for a u outside [0, 1] as [`RationalCurve::split`].
    pub fn isocurve_at_u(&self, u: f64) -> Result<RationalCurve<DVec3>, Error> {
        Error::unless_finite("u", &[u])?;
        self.curve_at_u(u).checked()
    }

    /// The curve v = constant, of degree m in u, from S(0, v) to S(1, v).
    ///
    /// # Errors
    /// As [`isocurve_at_u`](Self::isocurve_at_u).
    pub fn isocurve_at_v(&self, v: f64) -> Result<RationalCurve<DVec3>, Error> {
        Error::unless_finite("v", &[v])?;
        self.curve_at_v(v).checked()
    }

    /// The isocurve at a u that is finite.
    pub(in crate::rational) fn curve_at_u(&self, u: f64) -> RationalCurve<DVec3> {
        isocurve(&self.weighted(), self.net.columns, u)
    }

    /// The isocurve at a v that is finite.
    pub(in crate::rational) fn curve_at_v(&self, v: f64) -> RationalCurve<DVec3> {
        let across = transposed(&self.weighted(), self.net.columns);
        isocurve(&across, self.net.rows(), v)
    }

    /// The same patch with one more row and one more column of control points; see [`RationalCurve::elevate`].
    ///
    /// # Errors
    /// [`Error::Range`] when a degree is 64.
    pub fn elevate(&self) -> Result<Self, Error> {
        let (columns, rows) = (self.net.columns, self.net.rows());
        if columns.max(rows) > MAX_DEGREE {
            return Err(Error::Range {
                what: "degree",
                expected: "a degree below 64",
                got: 64.0,
            });
        }
        let wide = elevated_rows(&self.weighted(), columns);
        let high = elevated_rows(&transposed(&wide, columns + 1), rows);
        let parts = transposed(&high, rows + 1);
        Ok(Self::from_weighted(&parts, columns + 1))
    }
}

/// The curve of the points of all rows at t.
fn isocurve(parts: &[WeightedPoint<DVec3>], columns: usize, t: f64) -> RationalCurve<DVec3> {
    let point = |row: &[WeightedPoint<DVec3>]| {
        let mut row = row.to_vec();
        keep_after(&mut row, t);
        (row[0].point, row[0].weight)
    };
    RationalCurve::from_valid(parts.chunks(columns).map(point))
}

fn elevated_rows(parts: &[WeightedPoint<DVec3>], columns: usize) -> Vec<WeightedPoint<DVec3>> {
    let elevated = |row: &[WeightedPoint<DVec3>]| {
        let mut row: Points<WeightedPoint<DVec3>> = points_of(row);
        elevate_once(&mut row);
        row
    };
    parts.chunks(columns).flat_map(elevated).collect()
}
