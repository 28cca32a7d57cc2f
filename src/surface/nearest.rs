//! Which point of the surface is nearest?
//!
//! The squared distance |S(u, v) − p|² is a polynomial of degrees 2m and 2n; its Bernstein coefficients bound it from
//! below over any piece. So the least value can be found for certain, with Newton's method only to speed things up.
//! Source of the search by bounds: Johnson and Cohen, "A framework for efficient minimum distance computations", ICRA
//! 1998; of products in Bernstein form: Farin, *Curves and Surfaces for CAGD*, §6.9.

use super::distance::{Distance, ROUGH_IN_SQUARES, SMALL_AT_THE_LIMIT, squared_distance};
use super::frame::{Frame, box_of};
use super::minimum::minimise;
use super::network::Surface;
use super::piece::Piece;
use super::surface_point::SurfacePoint;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_finite;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::patch::Patch;
use crate::patch::patch_point::PatchPoint;
use glam::DVec3;

impl Patch {
    /// The point of the patch that is nearest to p: u and v from 0 to 1, sides and corners included.
    ///
    /// The least |S(u, v) − p|, found by branch and bound on the Bernstein coefficients of its square, so it is the least
    /// of all, not of a neighbourhood; distances that differ by rounding (some 1e-7 of the size where both are about zero)
    /// count as equal, and of equally near points any one is given. On a patch that is a point, that point.
    ///
    /// Two searches, by the square of the distance and, where it is below 2⁻¹⁶ of the size (2⁻⁴ if the first search reaches
    /// its limit), by the distance itself, take at most 2²³ steps each, about one for each multiplication: some
    /// milliseconds (2²⁶ above degree 24). Where that is not enough, as where a whole curve of the patch is nearest, the point is the nearest one found by then: a local minimum
    /// of the distance that no point found before is nearer than.
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

impl Patch {
    /// The nearest point to p, if it is no farther away than a small `reach`.
    pub(crate) fn nearest_within(&self, p: DVec3, reach: f64) -> Option<PatchPoint> {
        let patches = std::slice::from_ref(self);
        let frame = Frame::around(box_of(patches)?);
        let images = [frame.image(self)];
        let distance = Distance::new(patches, &[0], &images, &frame, p);
        // Farther away, since the bounds round.
        let (found, is_complete) = distance.search_small(None, 4.0 * reach);
        let is_near = |candidate: &SurfacePoint| candidate.distance <= reach;
        let found = found.filter(is_near).or_else(|| {
            let other = || nearest(patches, p).filter(is_near);
            if is_complete { None } else { other() }
        });
        found.map(SurfacePoint::on_patch)
    }
}

impl Surface {
    /// The point of the surface that is nearest to p; `None` without patches. See [`Patch::nearest`].
    ///
    /// Patches whose box is farther away than a point that is known are not looked at; each of the others adds to the most
    /// steps.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    pub fn nearest(&self, p: DVec3) -> Result<Option<SurfacePoint>, Error> {
        check_finite("point", &[p])?;
        let patches: Vec<Patch> = self.patches().collect();
        Ok(nearest(&patches, p))
    }
}

/// The nearest point; `None` without patches.
fn nearest(patches: &[Patch], p: DVec3) -> Option<SurfacePoint> {
    let frame = Frame::around(box_of(patches)?);
    // The farthest that the nearest point can be: at a corner of some patch.
    let corner = |patch: &Patch| Point::length(patch.points[0] * 0.5 - p * 0.5);
    let reach = patches.iter().map(corner).fold(f64::INFINITY, f64::min);
    let near: Vec<usize> = (0..patches.len())
        .filter(|&k| gap(patches[k].control_bounds(), p) <= reach * (1.0 + 8.0 * f64::EPSILON))
        .collect();
    let images: Vec<Patch> = near.iter().map(|&k| frame.image(&patches[k])).collect();
    let roots: Vec<Piece> = (0..)
        .zip(&images)
        .map(|(root, image)| squared_distance(root, image, &frame, p))
        .collect();
    let distance = Distance::new(patches, &near, &images, &frame, p);
    let (min, is_complete) = minimise(&roots, &distance)?;
    let mut candidate = distance.surface_point(min.root, [min.u, min.v]);
    let small = if is_complete {
        ROUGH_IN_SQUARES
    } else {
        SMALL_AT_THE_LIMIT
    };
    if candidate.distance <= small * distance.size {
        let (nearer, _) = distance.search_small(Some(candidate), f64::INFINITY);
        candidate = nearer.unwrap_or(candidate);
    }
    Some(distance.refined(&candidate))
}

/// Half the distance of a point from a box.
pub(crate) fn gap(bounds: Bounds<DVec3>, p: DVec3) -> f64 {
    Point::length(p.clamp(bounds.min, bounds.max) * 0.5 - p * 0.5)
}
