//! Knots, degrees, parts, isocurves and images of NURBS surfaces.

use super::{Direction, NurbsSurface};
use crate::geometry::check::images;
use crate::geometry::error::Error;
use crate::rational::nurbs::{NurbsCurve, locate};
use crate::rational::transform::projected;
use crate::rational::weighted::{WeightedPoint, transposed};
use glam::{DAffine3, DMat4, DVec3};

impl NurbsSurface {
    /// The same surface with the knot u inserted `times` times; see [`NurbsCurve::insert_knot`].
    ///
    /// # Errors
    /// As there.
    pub fn insert_knot_u(&self, u: f64, times: usize) -> Result<Self, Error> {
        self.along_u(|row| row.insert_knot(u, times))
            .map_err(|error| with_name(error, "u"))
    }

    /// The same surface with the knot v inserted `times` times; see [`NurbsCurve::insert_knot`].
    ///
    /// # Errors
    /// As there.
    pub fn insert_knot_v(&self, v: f64, times: usize) -> Result<Self, Error> {
        self.along_v(|column| column.insert_knot(v, times))
            .map_err(|error| with_name(error, "v"))
    }

    /// The same surface with a degree in u that is higher by 1; see [`NurbsCurve::elevate`].
    ///
    /// # Errors
    /// As there.
    pub fn elevate_u(&self) -> Result<Self, Error> {
        self.along_u(NurbsCurve::elevate)
    }

    /// The same surface with a degree in v that is higher by 1; see [`NurbsCurve::elevate`].
    ///
    /// # Errors
    /// As there.
    pub fn elevate_v(&self) -> Result<Self, Error> {
        self.along_v(NurbsCurve::elevate)
    }

    /// Splits the surface at u into two surfaces, whose domains together are that of this one.
    ///
    /// Both have the same control points and weights along the isocurve at u. See [`NurbsCurve::split`].
    ///
    /// # Errors
    /// As there.
    pub fn split_u(&self, u: f64) -> Result<(Self, Self), Error> {
        let before = self.along_u(|row| Ok(row.split(u)?.0));
        let after = self.along_u(|row| Ok(row.split(u)?.1));
        let both = before.and_then(|before| Ok((before, after?)));
        both.map_err(|error| with_name(error, "u"))
    }

    /// Splits the surface at v into two surfaces; see [`split_u`](Self::split_u).
    ///
    /// # Errors
    /// As there.
    pub fn split_v(&self, v: f64) -> Result<(Self, Self), Error> {
        let before = self.along_v(|column| Ok(column.split(v)?.0));
        let after = self.along_v(|column| Ok(column.split(v)?.1));
        let both = before.and_then(|before| Ok((before, after?)));
        both.map_err(|error| with_name(error, "v"))
    }

    /// The curve u = constant, with the degree and the knots in v.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a u that is not finite, [`Error::Range`] for one outside the domain.
    pub fn isocurve_at_u(&self, u: f64) -> Result<NurbsCurve<DVec3>, Error> {
        isocurve(&self.weighted(), &self.u, "u", u, &self.v)
    }

    /// The curve v = constant, with the degree and the knots in u.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a v that is not finite, [`Error::Range`] for one outside the domain.
    pub fn isocurve_at_v(&self, v: f64) -> Result<NurbsCurve<DVec3>, Error> {
        let across = transposed(&self.weighted(), self.u.count());
        isocurve(&across, &self.v, "v", v, &self.u)
    }

    /// The same surface with u in the opposite direction over the same domain, so that the normals point to the other side.
    pub fn reverse(&self) -> Self {
        // A row that is reversed stays valid; see `NurbsCurve::reverse`.
        let reversed = self.along_u(|row| Ok(row.reverse()));
        reversed.unwrap_or_else(|_| self.clone())
    }

    /// The image of the surface under an affine map, which is the surface of the mapped control points.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn transform(&self, map: &DAffine3) -> Result<Self, Error> {
        let mut parts = self.weighted();
        for (part, image) in parts.iter_mut().zip(images(&self.points, map)?) {
            part.point = image;
        }
        Self::from_weighted(&parts, self.u.clone(), self.v.clone())
    }

    /// The image of the surface under a projective map; see [`RationalCurve::project`](crate::RationalCurve::project).
    ///
    /// # Errors
    /// As there.
    pub fn project(&self, matrix: &DMat4) -> Result<Self, Error> {
        let (points, weights) = projected(&self.points, &self.weights, matrix)?;
        let parts = points.into_iter().zip(weights);
        let parts: Vec<WeightedPoint<DVec3>> = parts
            .map(|(point, weight)| WeightedPoint { point, weight })
            .collect();
        Self::from_weighted(&parts, self.u.clone(), self.v.clone())
    }

    /// The surface whose rows are the results of an operation, which has the same degree and knots for every row.
    fn along_u(
        &self,
        change: impl Fn(&NurbsCurve<DVec3>) -> Result<NurbsCurve<DVec3>, Error>,
    ) -> Result<Self, Error> {
        let (parts, u) = changed_rows(&self.weighted(), &self.u, change)?;
        Self::from_weighted(&parts, u, self.v.clone())
    }

    /// The surface whose columns are the results of an operation.
    fn along_v(
        &self,
        change: impl Fn(&NurbsCurve<DVec3>) -> Result<NurbsCurve<DVec3>, Error>,
    ) -> Result<Self, Error> {
        let across = transposed(&self.weighted(), self.u.count());
        let (across, v) = changed_rows(&across, &self.v, change)?;
        let parts = transposed(&across, v.count());
        Self::from_weighted(&parts, self.u.clone(), v)
    }
}

/// The error of an operation on rows or columns, with the name of the surface's parameter.
fn with_name(mut error: Error, name: &'static str) -> Error {
    if let Error::Range { what, .. } | Error::NotFinite { what, .. } = &mut error
        && *what == "t"
    {
        *what = name;
    }
    error
}

fn changed_rows(
    parts: &[WeightedPoint<DVec3>],
    along: &Direction,
    change: impl Fn(&NurbsCurve<DVec3>) -> Result<NurbsCurve<DVec3>, Error>,
) -> Result<(Vec<WeightedPoint<DVec3>>, Direction), Error> {
    let (mut all, mut direction) = (Vec::new(), Direction::default());
    for row in parts.chunks(along.count()) {
        let curve = change(&along.curve(row)?)?;
        all.extend(curve.weighted());
        direction = Direction::new(curve.degree(), curve.knots());
    }
    Ok((all, direction))
}

/// The curve of the points of all rows at t.
fn isocurve(
    parts: &[WeightedPoint<DVec3>],
    along: &Direction,
    name: &'static str,
    t: f64,
    across: &Direction,
) -> Result<NurbsCurve<DVec3>, Error> {
    Error::unless_finite(name, &[t])?;
    let [from, to] = along.domain();
    if !(from..=to).contains(&t) {
        return Err(Error::Range {
            what: name,
            expected: "a number in the domain of the surface",
            got: t,
        });
    }
    let point = |row: &[WeightedPoint<DVec3>]| {
        let curve = along.curve(row)?;
        let (k, s) = locate(curve.joints(), t);
        let (_, after) = curve.segments()[k].split_unchecked(s);
        Ok(after.weighted()[0])
    };
    let points: Result<Vec<WeightedPoint<DVec3>>, Error> =
        parts.chunks(along.count()).map(point).collect();
    across.curve(&points?)
}
