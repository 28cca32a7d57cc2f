//! The tensor-product Bézier patch: evaluation, partial derivatives and normals.

use super::net::{self, evaluate_net};
use super::normal::NormalNet;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::{check_points, images};
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::list::Net;
use glam::{DAffine3, DVec3};

/// A Bézier patch of degrees 1 to 64 in u and in v.
///
/// S(u, v) = Σᵢ Σⱼ Bᵢ(u) Bⱼ(v) Pᵢⱼ with the Bernstein polynomials B of degree m in u and n in v. The control point Pᵢⱼ
/// has the index j·(m + 1) + i: u runs along the fast index. Both parameters run from 0 to 1; values outside
/// extrapolate. The patch passes exactly through its four corner points and lies in the convex hull of its net. Patches
/// are immutable: every change returns a new one.
///
/// ```
/// use casteljau::{Patch, glam::DVec3};
///
/// let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 1.0)];
/// let patch = Patch::new(&net, 1, 1)?;
/// assert_eq!(patch.eval(0.5, 0.5), DVec3::new(0.5, 0.5, 0.25));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct Patch {
    pub(crate) points: Net,
    /// m + 1, the length of a row.
    pub(crate) columns: usize,
}

/// The first and second partial derivatives of a patch at one point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Partials {
    /// ∂S/∂u.
    pub u: DVec3,
    /// ∂S/∂v.
    pub v: DVec3,
    /// ∂²S/∂u².
    pub uu: DVec3,
    /// ∂²S/∂u∂v, the twist.
    pub uv: DVec3,
    /// ∂²S/∂v².
    pub vv: DVec3,
}

impl Patch {
    /// A patch from its net of (`degree_u` + 1)·(`degree_v` + 1) control points, u along the fast index.
    ///
    /// Coincident points are allowed: an edge, or the whole patch, may be a point.
    ///
    /// # Errors
    /// [`Error::Range`] unless both degrees are 1 to 64, [`Error::Count`] for another number of points,
    /// [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a coordinate
    /// beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn new(net: &[DVec3], degree_u: usize, degree_v: usize) -> Result<Self, Error> {
        check_degree("degree_u", degree_u)?;
        check_degree("degree_v", degree_v)?;
        if net.len() != (degree_u + 1) * (degree_v + 1) {
            return Err(Error::Count {
                what: "net",
                expected: "(degree_u + 1)·(degree_v + 1) control points",
                got: net.len(),
            });
        }
        check_points("net", net)?;
        Ok(Self::from_net(Net::from(net), degree_u + 1))
    }

    /// A patch from a net that is already checked.
    pub(crate) fn from_net(points: Net, columns: usize) -> Self {
        Self { points, columns }
    }

    /// The degree m in u.
    pub fn degree_u(&self) -> usize {
        self.columns - 1
    }

    /// The degree n in v.
    pub fn degree_v(&self) -> usize {
        self.points.len() / self.columns - 1
    }

    /// The control points Pᵢⱼ at j·(m + 1) + i.
    pub fn control_points(&self) -> &[DVec3] {
        &self.points
    }

    /// The bounding box of the control points, which contains the patch.
    pub fn control_bounds(&self) -> Bounds<DVec3> {
        Bounds::from_points(&self.points)
    }

    /// The point S(u, v).
    ///
    /// Each row of the net is evaluated at u, then the curve of the resulting points at v. Corners are exact, and along
    /// an edge the coordinates equal those of the edge's curve. Source: Farin, *Curves and Surfaces for CAGD*, 5th
    /// ed., §14.3.
    pub fn eval(&self, u: f64, v: f64) -> DVec3 {
        evaluate_net(&self.points, self.columns, u, v)
    }

    /// The partial derivatives of first and second order at (u, v), in units of length per unit of u and v.
    ///
    /// ∂S/∂u = m Σ Bᵢ(u) Bⱼ(v) (Pᵢ₊₁ⱼ − Pᵢⱼ) with degree m − 1 in u, and likewise for the others: they use differences
    /// of control points, not finite differences of surface points. Second derivatives in a direction of degree 1 are
    /// zero. Source: Farin, *Curves and Surfaces for CAGD*, §14.6.
    pub fn partials(&self, u: f64, v: f64) -> Partials {
        let (m, n) = (as_f64(self.degree_u()), as_f64(self.degree_v()));
        let du = net::differences_u(&self.points, self.columns);
        let dv = net::differences_v(&self.points, self.columns);
        let (fewer, fewest) = (self.columns - 1, self.columns.max(3) - 2);
        Partials {
            u: evaluate_net(&du, fewer, u, v) * m,
            v: evaluate_net(&dv, self.columns, u, v) * n,
            uu: evaluate_net(&net::differences_u(&du, fewer), fewest, u, v) * (m * (m - 1.0)),
            uv: evaluate_net(&net::differences_v(&du, fewer), fewer, u, v) * (m * n),
            vv: evaluate_net(&net::differences_v(&dv, self.columns), self.columns, u, v)
                * (n * (n - 1.0)),
        }
    }

    /// The unit normal at (u, v): the direction of ∂S/∂u × ∂S/∂v.
    ///
    /// Where this cross product vanishes, as at a collapsed edge, the normal is the limit from the middle of the patch.
    /// It is zero where there is no limit: for a patch that is a point or a curve. The cross product counts as
    /// vanishing below 10⁻¹³ m n |Δu| |Δv|, where Δu and Δv are the largest differences of neighbouring control points
    /// along u and v, and m and n are the degrees: rounding decides the direction of a shorter one. Source of the
    /// limit: the normal net, see `normal.rs`.
    pub fn normal(&self, u: f64, v: f64) -> DVec3 {
        let (du, dv) = directions(&self.points, self.columns);
        let along_u = evaluate_net(&du, self.columns - 1, u, v);
        let along_v = evaluate_net(&dv, self.columns, u, v);
        let cross = along_u.cross(along_v);
        if cross.length_squared() > REGULAR_RATIO * REGULAR_RATIO {
            return Point::unit(cross);
        }
        NormalNet::new(&du, &dv, self.degree_u(), self.degree_v()).limit(u, v)
    }

    /// The image of the patch under an affine map: the patch of the mapped control points.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn transform(&self, map: &DAffine3) -> Result<Self, Error> {
        images(&self.points, map).map(|points| Self::from_net(Net::from(&points[..]), self.columns))
    }

    /// Moves one control point, in place.
    ///
    /// # Errors
    /// [`Error::Index`] for an index outside the net, [`Error::NotFinite`] for a target with a NaN or an infinity; the
    /// patch is then unchanged.
    pub fn move_point(&mut self, index: usize, to: DVec3) -> Result<(), Error> {
        *checked_point(&mut self.points, index, to)? = to;
        Ok(())
    }

    /// Whether both patches have the same degrees and every control point lies within `tolerance` of its counterpart.
    ///
    /// With a tolerance of 0 the coordinates must be equal.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        self.columns == other.columns
            && self.points.len() == other.points.len()
            && self
                .points
                .iter()
                .zip(&other.points)
                .all(|(&a, &b)| a == b || Point::norm(a - b) <= tolerance)
    }
}

/// The differences of a net along u and along v, each scaled to size 1 for the normal of nets of any size.
pub(crate) fn directions(points: &[DVec3], columns: usize) -> (Net, Net) {
    let mut du = net::differences_u(points, columns);
    let mut dv = net::differences_v(points, columns);
    net::unit_size(&mut du);
    net::unit_size(&mut dv);
    (du, dv)
}

/// |∂u × ∂v| of the scaled [`directions`] above which a point is regular. Their rounding noise is about 2⁻⁵²; a normal
/// accurate to 0.001° (1.7e-5 rad) needs a product that is 10⁵ times as long.
pub(crate) const REGULAR_RATIO: f64 = 1e-10;

/// Returns an error unless the degree is 1 to 64.
pub(crate) fn check_degree(what: &'static str, degree: usize) -> Result<(), Error> {
    if (1..=MAX_DEGREE).contains(&degree) {
        return Ok(());
    }
    Err(Error::Range {
        what,
        expected: "a whole number from 1 to 64",
        got: as_f64(degree),
    })
}

/// The point with this index; checks the index and the target.
pub(crate) fn checked_point(
    points: &mut [DVec3],
    index: usize,
    to: DVec3,
) -> Result<&mut DVec3, Error> {
    check_points("to", &[to])?;
    let last = points.len().saturating_sub(1);
    points.get_mut(index).ok_or(Error::Index {
        what: "index",
        first: 0,
        last,
        got: index,
    })
}
