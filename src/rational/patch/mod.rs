//! Rational patches: nets of control points with weights.
//!
//! A rational patch is the projection A/w of a polynomial one (A, w) in homogeneous coordinates. Its derivatives are
//! computed with the point itself as origin, where A vanishes, so that nothing of the size of the coordinates cancels.

mod bounds;
mod normal;
mod split;

pub(super) use bounds::bounds_of;
pub(super) use normal::NOISE;

use super::check_weights;
use super::transform::projected;
use super::weighted::{Homogeneous, WeightedPoint, are_proportional, weight_scale};
use crate::bernstein::evaluate::evaluate;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::numeric::list::{Net, Points};
use crate::patch::curvature::curvature;
use crate::patch::{Curvature, Partials, Patch};
use crate::rational::RationalCurve;
use crate::surface::scaling::Scaling;
use glam::{DAffine3, DMat4, DVec3};

/// A rational Bézier patch of degrees 1 to 64 in u and in v, in space.
///
/// S(u, v) = Σ wᵢⱼ Bᵢ(u) Bⱼ(v) Pᵢⱼ / Σ wᵢⱼ Bᵢ(u) Bⱼ(v), with the control points and the order of the net of [`Patch`] and a weight
/// above 0 for each of them. Equal weights give that patch, and a common factor of all weights changes nothing. The patch passes
/// exactly through its four corner points and lies in the convex hull of its net. Parameters outside [0, 1] extrapolate where the
/// denominator is above 0.
///
/// Source: Farin, *Curves and Surfaces for CAGD*, 5th ed., §16.6; Piegl and Tiller, *The NURBS Book*, §4.4.
///
/// ```
/// use casteljau::{RationalPatch, glam::DVec3};
///
/// // A quarter of a cylinder of radius 1 and height 2.
/// let row = |z: f64| [(1.0, 0.0, z), (1.0, 1.0, z), (0.0, 1.0, z)].map(DVec3::from);
/// let weights = [1.0, 0.5_f64.sqrt(), 1.0];
/// let quarter = RationalPatch::new(&[row(0.0), row(2.0)].concat(), &[weights, weights].concat(), 2, 1)?;
/// let p = quarter.eval(0.3, 0.5);
/// assert!((p.x * p.x + p.y * p.y - 1.0).abs() < 1e-15 && p.z == 1.0);
/// assert!((quarter.curvature(0.3, 0.5).mean + 0.5).abs() < 1e-14);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct RationalPatch {
    net: Patch,
    weights: Vec<f64>,
}

impl RationalPatch {
    /// A patch from its net of (`degree_u` + 1)·(`degree_v` + 1) control points, u along the fast index, and as many weights.
    ///
    /// # Errors
    /// As [`Patch::new`] for the net; [`Error::Count`], [`Error::NotFinite`] and [`Error::Item`] for the weights, as
    /// [`RationalCurve::new`].
    pub fn new(
        net: &[DVec3],
        weights: &[f64],
        degree_u: usize,
        degree_v: usize,
    ) -> Result<Self, Error> {
        let net = Patch::new(net, degree_u, degree_v)?;
        check_weights(weights, net.points.len())?;
        Ok(Self {
            net,
            weights: weights.to_vec(),
        })
    }

    /// Makes a patch from a valid net and as many valid weights.
    pub(super) fn from_valid(net: Patch, weights: Vec<f64>) -> Self {
        Self { net, weights }
    }

    /// The control points, without weights.
    pub(super) fn net(&self) -> &Patch {
        &self.net
    }

    /// Makes a patch from valid parts.
    pub(super) fn from_weighted(parts: &[WeightedPoint<DVec3>], columns: usize) -> Self {
        let points = parts.iter().map(|part| part.point).collect();
        Self {
            net: Patch::from_net(points, columns),
            weights: parts.iter().map(|part| part.weight).collect(),
        }
    }

    /// The patch if all its points and weights are valid: an extrapolation may have others.
    fn checked(self) -> Result<Self, Error> {
        check_weights(&self.weights, self.net.points.len())?;
        check_points("net", &self.net.points)?;
        Ok(self)
    }

    /// The degree m in u.
    pub fn degree_u(&self) -> usize {
        self.net.degree_u()
    }

    /// The degree n in v.
    pub fn degree_v(&self) -> usize {
        self.net.degree_v()
    }

    /// The control points Pᵢⱼ at j·(m + 1) + i.
    pub fn control_points(&self) -> &[DVec3] {
        &self.net.points
    }

    /// The weight of each control point.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The bounding box of the control points, which contains the patch.
    pub fn control_bounds(&self) -> Bounds<DVec3> {
        self.net.control_bounds()
    }

    /// The point S(u, v).
    ///
    /// Corners are exact, and along an edge the coordinates equal those of the edge's curve. Points within the patch are
    /// within 4 ulps of the largest coordinate up to degree 3. NaN where the denominator of an extrapolation is not above 0.
    pub fn eval(&self, u: f64, v: f64) -> DVec3 {
        let columns = self.net.columns;
        let (last_column, last_row) = (columns - 1, self.net.rows() - 1);
        let end = |t: f64, last: usize| match t {
            0.0 => Some(0),
            1.0 => Some(last),
            _ => None,
        };
        if let Some(row) = end(v, last_row) {
            let from = row * columns;
            return RationalCurve::between(self.control_points(), &self.weights, from, last_column)
                .eval(u);
        }
        if let Some(column) = end(u, last_column) {
            let part = |row: usize| {
                let index = row * columns + column;
                (self.net.points[index], self.weights[index])
            };
            return RationalCurve::from_valid((0..=last_row).map(part)).eval(v);
        }
        let across: Points<Homogeneous<DVec3>> = self
            .homogeneous(DVec3::ZERO)
            .chunks(columns)
            .map(|row| evaluate(row, u))
            .collect();
        evaluate(&across, v).point()
    }

    /// The partial derivatives of first and second order at (u, v), in units of length per unit of u and v.
    ///
    /// With the origin at S(u, v), A = wS vanishes there, and so ∂A = w ∂S, ∂u∂u A = w ∂u∂u S + 2 ∂u w ∂u S, and likewise for the
    /// others. Source: Piegl and Tiller, *The NURBS Book*, §4.5.
    pub fn partials(&self, u: f64, v: f64) -> Partials {
        let (numerator, denominator) = self.numerator_and_denominator(self.eval(u, v));
        let weight = denominator.eval(u, v).x;
        let (a, w) = (numerator.partials(u, v), denominator.partials(u, v));
        let (along_u, along_v) = (a.u / weight, a.v / weight);
        Partials {
            u: along_u,
            v: along_v,
            uu: (a.uu - along_u * (2.0 * w.u.x)) / weight,
            uv: (a.uv - along_u * w.v.x - along_v * w.u.x) / weight,
            vv: (a.vv - along_v * (2.0 * w.v.x)) / weight,
        }
    }

    /// The Gaussian, mean and principal curvatures at (u, v), with the signs and limits of [`Patch::curvature`].
    pub fn curvature(&self, u: f64, v: f64) -> Curvature {
        let scaling = Scaling::around(self.control_bounds());
        let image = self.image(&scaling);
        curvature([u, v], scaling.size, |u, v| {
            image.cross_product(u, v).map(|_| image.partials(u, v))
        })
    }

    /// The patch in scaled coordinates.
    fn image(&self, scaling: &Scaling) -> Self {
        Self {
            net: scaling.image(&self.net),
            weights: self.weights.clone(),
        }
    }

    /// The image of the patch under an affine map: the patch of the mapped control points with the same weights.
    ///
    /// # Errors
    /// As [`Patch::transform`].
    pub fn transform(&self, map: &DAffine3) -> Result<Self, Error> {
        Ok(Self {
            net: self.net.transform(map)?,
            weights: self.weights.clone(),
        })
    }

    /// The image of the patch under a projective map; see [`RationalCurve::project`].
    ///
    /// # Errors
    /// As there.
    pub fn project(&self, matrix: &DMat4) -> Result<Self, Error> {
        let (points, weights) = projected(self.control_points(), &self.weights, matrix)?;
        Ok(Self {
            net: Patch::from_net(Net::from(points), self.net.columns),
            weights,
        })
    }

    /// Whether both patches have the same degrees, every control point lies within `tolerance` of its counterpart, and the
    /// weights are equal up to a common factor, each within `tolerance` times the largest weight.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        self.net.approx_eq(&other.net, tolerance)
            && are_proportional(&self.weights, &other.weights, tolerance)
    }

    /// The control points with their weights.
    pub(super) fn weighted(&self) -> Vec<WeightedPoint<DVec3>> {
        let parts = self.net.points.iter().zip(&self.weights);
        parts
            .map(|(&point, &weight)| WeightedPoint { point, weight })
            .collect()
    }

    /// The homogeneous control points relative to an origin, with a largest weight of 1 to 2.
    pub(super) fn homogeneous(&self, origin: DVec3) -> Vec<Homogeneous<DVec3>> {
        let scale = weight_scale(&self.weights);
        let parts = self.net.points.iter().zip(&self.weights);
        parts
            .map(|(&p, &w)| Homogeneous::new(p - origin, w * scale))
            .collect()
    }

    /// The polynomial patches A = w(S − origin) and (w, 0, 0), where the largest weight is 1 to 2.
    fn numerator_and_denominator(&self, origin: DVec3) -> (Patch, Patch) {
        let parts = self.homogeneous(origin);
        let patch = |points: Net| Patch::from_net(points, self.net.columns);
        (
            patch(parts.iter().map(|part| part.vector).collect()),
            patch(parts.iter().map(|part| DVec3::X * part.weight).collect()),
        )
    }
}

impl From<&Patch> for RationalPatch {
    /// The same patch with the weights 1.
    fn from(patch: &Patch) -> Self {
        Self {
            net: patch.clone(),
            weights: vec![1.0; patch.points.len()],
        }
    }
}
