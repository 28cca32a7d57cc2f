//! Nearest point on patches and surfaces.
//!
//! The squared distance |S(u, v) − p|² is a polynomial of degrees 2m and 2n; its Bernstein coefficients bound it from
//! below over any piece. So the global minimum is found reliably; Newton's method only speeds up the search. Source of
//! the search by bounds: Johnson and Cohen, "A framework for efficient minimum distance computations", ICRA 1998; of
//! products in Bernstein form: Farin, *Curves and Surfaces for CAGD*, §6.9.

use super::distance::{PatchDistance, ROUGH_IN_SQUARES, SMALL_AT_THE_LIMIT, squared_distance};
use super::minimum::minimise;
use super::network::Surface;
use super::piece::PolynomialPiece;
use super::query_patch::QueryPatch;
use super::scaling::{Scaling, box_of};
use super::surface_point::SurfacePoint;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::patch::Patch;
use crate::patch::patch_point::PatchPoint;
use glam::DVec3;

impl Patch {
    /// The point of the patch that is nearest to p, with u and v from 0 to 1, edges and corners included.
    ///
    /// It is the global minimum of |S(u, v) − p|, found by branch and bound on the Bernstein coefficients of its
    /// square. Distances that differ by rounding (about 1e-7 of the size where both are near zero) count as equal, and
    /// of equally near points any one is returned. For a patch that is a point, the result is that point.
    ///
    /// Two searches take at most 2²³ steps each (2²⁶ above degree 24), about one for each multiplication: some
    /// milliseconds. The first uses the square of the distance. The second uses the distance itself and runs where the
    /// distance is below 2⁻¹⁶ of the size (2⁻⁴ if the first search reaches its limit). If a search reaches its limit,
    /// as where a whole curve of the patch is nearest, the result is the nearest point found so far: a local minimum of
    /// the distance, and no point found earlier is nearer.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    pub fn nearest(&self, p: DVec3) -> Result<PatchPoint, Error> {
        check_points("point", &[p])?;
        let nearest = nearest(std::slice::from_ref(self), p);
        Ok(nearest
            .unwrap_or_else(|| SurfacePoint::at(self, 0, 0.0, 0.0, p))
            .on_patch())
    }
}

impl QueryPatch for Patch {
    fn eval(&self, u: f64, v: f64) -> DVec3 {
        self.eval(u, v)
    }

    fn normal(&self, u: f64, v: f64) -> DVec3 {
        self.normal(u, v)
    }

    fn control_bounds(&self) -> Bounds<DVec3> {
        self.control_bounds()
    }

    fn columns(&self) -> usize {
        self.columns
    }

    fn numerator(&self, local: &dyn Fn(DVec3) -> DVec3) -> Vec<DVec3> {
        self.points.iter().map(|&p| local(p)).collect()
    }

    fn nearest_within(&self, p: DVec3, reach: f64) -> Option<PatchPoint> {
        let patches = std::slice::from_ref(self);
        let scaling = Scaling::around(box_of(patches)?);
        let images = [scaling.image(self)];
        let distance = PatchDistance::new(patches, &[0], &images, &scaling, p);
        // The cutoff is larger than `reach`, since the bounds are rounded.
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
    /// Patches whose box is farther away than a known point are skipped; each of the others adds to the maximum number
    /// of steps.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    pub fn nearest(&self, p: DVec3) -> Result<Option<SurfacePoint>, Error> {
        check_points("point", &[p])?;
        let patches: Vec<Patch> = self.patches().collect();
        Ok(nearest(&patches, p))
    }
}

/// The nearest point; `None` without patches.
fn nearest(patches: &[Patch], p: DVec3) -> Option<SurfacePoint> {
    let scaling = Scaling::around(box_of(patches)?);
    // An upper bound on the distance of the nearest point: the smallest distance of the first corner of a patch.
    let corner = |patch: &Patch| Point::norm(patch.points[0] - p);
    let reach = patches.iter().map(corner).fold(f64::INFINITY, f64::min);
    let near: Vec<usize> = (0..patches.len())
        .filter(|&k| patches[k].control_bounds().distance(p) <= reach * (1.0 + 8.0 * f64::EPSILON))
        .collect();
    let images: Vec<Patch> = near.iter().map(|&k| scaling.image(&patches[k])).collect();
    let wholes: Vec<PolynomialPiece> = (0..)
        .zip(&images)
        .map(|(index, image)| squared_distance(index, image, &scaling, p))
        .collect();
    let distance = PatchDistance::new(patches, &near, &images, &scaling, p);
    let (min, is_complete) = minimise(&wholes, &distance)?;
    let mut candidate = distance.surface_point(min.index, [min.u, min.v]);
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
