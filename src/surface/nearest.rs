//! Which point of the surface is nearest?
//!
//! The squared distance |S(u, v) − p|² is a polynomial of degrees 2m and 2n; its Bernstein coefficients bound it from
//! below over any piece. So the least value can be found for certain, with Newton's method only to speed things up.
//! Source of the search by bounds: Johnson and Cohen, "A framework for efficient minimum distance computations", ICRA
//! 1998; of products in Bernstein form: Farin, *Curves and Surfaces for CAGD*, §6.9.

use super::frame::{Frame, box_of};
use super::minimum::minimise;
use super::normal::binomial;
use super::piece::Piece;
use super::{Patch, Surface};
use crate::curve::{Bounds, check_finite};
use crate::error::Error;
use crate::point::Point;
use glam::DVec3;

/// A point of a patch, found by a question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchPoint {
    /// The parameters, from 0 to 1.
    pub u: f64,
    /// See `u`.
    pub v: f64,
    /// The point S(u, v).
    pub point: DVec3,
    /// Its distance from the point that was asked for, or from the ray's origin.
    pub distance: f64,
}

/// A point of a surface, found by a question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The number of the patch.
    pub patch: usize,
    /// The parameters on it, from 0 to 1.
    pub u: f64,
    /// See `u`.
    pub v: f64,
    /// The point of the surface.
    pub point: DVec3,
    /// Its distance from the point that was asked for, or from the ray's origin.
    pub distance: f64,
}

impl SurfacePoint {
    /// The point at (u, v) of a patch, asked for from p.
    pub(super) fn at(on: &Patch, patch: usize, u: f64, v: f64, p: DVec3) -> Self {
        let point = on.eval(u, v);
        Self {
            patch,
            u,
            v,
            point,
            distance: (point * 0.5 - p * 0.5).norm() * 2.0,
        }
    }

    /// The same on its patch.
    pub(super) fn on_patch(self) -> PatchPoint {
        PatchPoint {
            u: self.u,
            v: self.v,
            point: self.point,
            distance: self.distance,
        }
    }
}

impl Patch {
    /// The point of the patch that is nearest to p: u and v from 0 to 1, sides and corners included.
    ///
    /// The least |S(u, v) − p|, found by branch and bound on the Bernstein coefficients of its square, so it is the least
    /// of all, not of a neighbourhood; distances that differ by rounding (some 1e-7 of the size where both are about zero)
    /// count as equal, and of equally near points any one is given. On a patch that is a point, that point.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    pub fn nearest(&self, p: DVec3) -> Result<PatchPoint, Error> {
        check_finite("point", &[p])?;
        let nearest = nearest(std::slice::from_ref(self), p);
        Ok(nearest
            .unwrap_or_else(|| SurfacePoint::at(self, 0, 0.0, 0.0, p))
            .on_patch())
    }
}

impl Surface {
    /// The point of the surface that is nearest to p; `None` without patches. See [`Patch::nearest`].
    ///
    /// Patches whose box is farther away than a point that is known are not looked at.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    pub fn nearest(&self, p: DVec3) -> Result<Option<SurfacePoint>, Error> {
        check_finite("point", &[p])?;
        let patches: Vec<Patch> = self.patches().collect();
        Ok(nearest(&patches, p))
    }
}

fn nearest(patches: &[Patch], p: DVec3) -> Option<SurfacePoint> {
    let frame = Frame::around(box_of(patches)?);
    // The farthest that the nearest point can be: at a corner of some patch.
    let corner = |patch: &Patch| (patch.points[0] * 0.5 - p * 0.5).norm();
    let reach = patches.iter().map(corner).fold(f64::INFINITY, f64::min);
    let near: Vec<usize> = (0..patches.len())
        .filter(|&k| gap(patches[k].control_bounds(), p) <= reach * (1.0 + 8.0 * f64::EPSILON))
        .collect();
    let roots: Vec<Piece> = (0..)
        .zip(&near)
        .map(|(root, &k)| squared_distance(root, &patches[k], &frame, p))
        .collect();
    let measure =
        |k: usize, u: f64, v: f64| SurfacePoint::at(&patches[near[k]], 0, u, v, p).distance;
    let least = minimise(&roots, &measure)?;
    let patch = near[least.root];
    let place = SurfacePoint::at(&patches[patch], patch, least.u, least.v, p);
    Some(refined(&patches[patch], place, p))
}

/// The place after a Gauss–Newton step, if that is nearer: for p on the surface the square of the distance has lost
/// half of the digits that the difference S − p still has.
fn refined(patch: &Patch, place: SurfacePoint, p: DVec3) -> SurfacePoint {
    let d = patch.partials(place.u, place.v);
    let off = place.point - p;
    let (uu, uv, vv) = (d.u.dot(d.u), d.u.dot(d.v), d.v.dot(d.v));
    let (u, v, det) = (d.u.dot(off), d.v.dot(off), uu * vv - uv * uv);
    let inside = |t: f64| t.clamp(0.0, 1.0);
    let next = SurfacePoint::at(
        patch,
        place.patch,
        inside(place.u - (vv * u - uv * v) / det),
        inside(place.v - (uu * v - uv * u) / det),
        p,
    );
    // Of a step that is not finite, no.
    if next.distance < place.distance {
        next
    } else {
        place
    }
}

/// Half the distance of a point from a box.
pub(super) fn gap(bounds: Bounds<DVec3>, p: DVec3) -> f64 {
    (p.clamp(bounds.min, bounds.max) * 0.5 - p * 0.5).norm()
}

/// |S − p|², less a constant and over a constant that are the same for all patches of the frame.
///
/// With q = (S − centre)/size and d = (centre − p)/size it is q² + 2 q·d + d²; the last is left out, since it would drown
/// the others for a p far away, and all is divided by |d| where that is above 1.
fn squared_distance(root: usize, patch: &Patch, frame: &Frame, p: DVec3) -> Piece {
    let away = frame.centre * 0.5 - p * 0.5;
    let unit = (0.5 * frame.size).max(away.norm());
    let (share, toward) = (0.5 * frame.size / unit, away / unit * 2.0);
    let (m, n) = (patch.degree_u(), patch.degree_v());
    let weighted = |k: usize| binomial(m, k % (m + 1)) * binomial(n, k / (m + 1));
    let factors: Vec<(DVec3, DVec3)> = (0..)
        .zip(&patch.points)
        .map(|(k, &point)| {
            let q = frame.place(point);
            (q * weighted(k), (q * share + toward) * weighted(k))
        })
        .collect();
    let columns = 2 * m + 1;
    let mut product = vec![0.0; columns * (2 * n + 1)];
    // Coefficients of products add up where their indices do.
    for (a, (left, _)) in factors.iter().enumerate() {
        for (b, (_, right)) in factors.iter().enumerate() {
            let (i, j) = (a % (m + 1) + b % (m + 1), a / (m + 1) + b / (m + 1));
            product[j * columns + i] += left.dot(*right);
        }
    }
    for (k, coefficient) in product.iter_mut().enumerate() {
        *coefficient /= binomial(2 * m, k % columns) * binomial(2 * n, k / columns);
    }
    Piece::whole(root, columns, 2 * n + 1, product)
}
