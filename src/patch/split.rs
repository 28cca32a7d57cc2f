//! Isocurves, subdivision, degree elevation and change of basis of patches.

use super::Patch;
use super::net::{curve_at_u, transpose};
use crate::curve::Curve;
use crate::curve::basis::{Basis, apply};
use crate::geometry::check::{check_points, clamp_to_limit};
use crate::geometry::error::Error;
use crate::numeric::list::Net;
use casteljau_kernels::bernstein::de_casteljau::split;
use glam::DVec3;

impl Patch {
    /// The bicubic patch of sixteen geometry points in another basis.
    ///
    /// S(u, v) = \[u³ u² u 1\]·M·G·Mᵀ·\[v³ v² v 1\]ᵀ; the geometry point Gᵢⱼ has the index 4j + i. Each row is
    /// converted to the Bézier basis, then each column. In the Hermite basis, a row holds two points and two
    /// derivatives in u, and the last two rows are derivatives in v. A singular matrix is allowed. Source: Foley et
    /// al., *Computer Graphics: Principles and Practice*, 2nd ed., §11.3.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity in the points or the matrix.
    pub fn from_basis(basis: Basis, net: &[DVec3; 16]) -> Result<Self, Error> {
        check_points("net", net)?;
        let matrix = basis.to_bezier()?;
        let bezier_rows = |net: &[DVec3]| -> Net {
            net.chunks_exact(4)
                .flat_map(|row| apply(&matrix, [row[0], row[1], row[2], row[3]]))
                .collect()
        };
        let across = bezier_rows(&transpose(&bezier_rows(net), 4));
        Self::new(&transpose(&across, 4), 3, 3)
    }

    /// The curve u = constant, of degree n in v, from S(u, 0) to S(u, 1).
    pub fn isocurve_at_u(&self, u: f64) -> Curve<DVec3> {
        Curve::from_points(curve_at_u(&self.points, self.columns, u)).clamped()
    }

    /// The curve v = constant, of degree m in u, from S(0, v) to S(1, v).
    pub fn isocurve_at_v(&self, v: f64) -> Curve<DVec3> {
        let across = transpose(&self.points, self.columns);
        Curve::from_points(curve_at_u(&across, self.rows(), v)).clamped()
    }

    /// Splits the patch at u into two patches of the same degrees: before u and after u.
    ///
    /// Each row of the net is split by de Casteljau's algorithm. Both patches have the same control points along the
    /// isocurve at u and keep the outer corners exactly. For u outside [0, 1] one patch extends beyond the original and
    /// the other is traversed backwards.
    pub fn split_u(&self, u: f64) -> (Self, Self) {
        let (before, after) = split_rows(&self.points, self.columns, u);
        (
            Self::from_net(before, self.columns),
            Self::from_net(after, self.columns),
        )
    }

    /// Splits the patch at v into two patches: before v and after v; see [`split_u`](Self::split_u).
    pub fn split_v(&self, v: f64) -> (Self, Self) {
        let across = transpose(&self.points, self.columns);
        let (before, after) = split_rows(&across, self.rows(), v);
        let back = |net: Net| Self::from_net(transpose(&net, self.rows()), self.columns);
        (back(before), back(after))
    }

    /// Splits the patch at (u, v) into four patches, in the order of net indices: before both u and v, after u, after
    /// v, after both.
    pub fn split(&self, u: f64, v: f64) -> [Self; 4] {
        let (below, above) = self.split_v(v);
        let ((p00, p10), (p01, p11)) = (below.split_u(u), above.split_u(u));
        [p00, p10, p01, p11]
    }

    /// The same patch with one more row and one more column of control points: degree elevation to m + 1 and n + 1.
    ///
    /// Each row and then each column is elevated as a curve; see [`Curve::elevate`].
    ///
    /// # Errors
    /// [`Error::Range`] when a degree is 64.
    pub fn elevate(&self) -> Result<Self, Error> {
        let wide = elevate_rows(&self.points, self.columns)?;
        let across = transpose(&wide, self.columns + 1);
        let high = elevate_rows(&across, self.rows())?;
        let points = transpose(&high, self.rows() + 1);
        Ok(Self::from_net(points, self.columns + 1))
    }

    /// n + 1, the length of a column.
    pub(crate) fn rows(&self) -> usize {
        self.points.len() / self.columns
    }
}

/// Splits every row at t.
fn split_rows(net: &[DVec3], columns: usize, t: f64) -> (Net, Net) {
    let (mut before, mut after) = (Net::from(net), Net::from(net));
    for (left, right) in before.chunks_mut(columns).zip(after.chunks_mut(columns)) {
        split(left, right, t);
    }
    for p in before.iter_mut().chain(&mut after) {
        *p = clamp_to_limit(*p);
    }
    (before, after)
}

/// Elevates every row.
fn elevate_rows(net: &[DVec3], columns: usize) -> Result<Net, Error> {
    let mut wide = Net::new();
    for row in net.chunks(columns) {
        wide.extend_from_slice(Curve::from_slice(row).elevate()?.control_points());
    }
    Ok(wide)
}
