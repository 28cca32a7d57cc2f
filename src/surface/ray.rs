//! Intersections of a ray with patches and surfaces.
//!
//! A ray is the intersection of two planes. The distances of S(u, v) from both planes are polynomials, and their common
//! zeros are the hits. No mesh is used. Source of the two planes: Kajiya, "Ray tracing parametric patches", SIGGRAPH
//! 1982; of the search by subdivision: Nishita, Sederberg and Kakimoto, "Ray tracing trimmed rational surface patches",
//! SIGGRAPH 1990.

use super::network::Surface;
use super::piece::PolynomialPiece;
use super::query_patch::QueryPatch;
use super::scaling::{Scaling, box_of};
use super::surface_point::SurfacePoint;
use super::zeros::{MAX_RAY_STEPS, ZERO_TOLERANCE, common_zeros};
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::parallel::map_patches;
use crate::patch::Patch;
use crate::patch::patch_point::PatchPoint;
use glam::DVec3;

/// A hit nearer than this to an edge, in u or v, counts as a hit on the edge. Two hits on edges are always distinct if
/// their distance exceeds this fraction of the scene's size. This is the square root of rounding, the uncertainty of a
/// hit where the ray is tangent to the surface.
const ON_SIDE: f64 = 1.0 / 8_388_608.0;

impl Patch {
    /// All hits of a ray, sorted by distance; empty if the ray misses the patch.
    ///
    /// The hits are the points S(u, v) = origin + t·direction with t ≥ 0 and u, v from 0 to 1. `distance` is the
    /// Euclidean distance from the origin, so the length of `direction` does not matter. A point where the ray is
    /// tangent to the patch counts once, and so does a hit of a collapsed edge (a pole). The ray is as wide as
    /// rounding, about 1e-14 of the size of patch and origin together; where the ray grazes, hits nearer to each other
    /// than 1e-7 of that size count as one.
    ///
    /// A ray that runs within the patch has no isolated hits. The result then contains the points where it crosses the
    /// patch's edges, and the origin if it is on the patch.
    ///
    ///
    /// # Errors
    /// [`Error::Range`] for a direction of length 0, [`Error::NotFinite`] for a NaN or an infinity, [`Error::TooMany`]
    /// when the search takes more than 2²⁷ steps, about one for each multiplication.
    pub fn intersect_ray(&self, origin: DVec3, direction: DVec3) -> Result<Vec<PatchPoint>, Error> {
        let hits = hits(std::slice::from_ref(self), origin, direction)?;
        Ok(hits.into_iter().map(SurfacePoint::on_patch).collect())
    }
}

impl Surface {
    /// All hits of a ray, sorted by distance; see [`Patch::intersect_ray`]. A hit on an edge that patches share counts
    /// once, for the first of them.
    ///
    /// # Errors
    /// As for a patch; each patch has its own work limit.
    pub fn intersect_ray(
        &self,
        origin: DVec3,
        direction: DVec3,
    ) -> Result<Vec<SurfacePoint>, Error> {
        let patches: Vec<Patch> = self.patches().collect();
        hits(&patches, origin, direction)
    }
}

/// A ray in scaled coordinates: its start, its direction, and two perpendicular directions.
struct Ray {
    start: DVec3,
    along: DVec3,
    across: [DVec3; 2],
}

/// All hits of a ray, sorted by distance; see [`Surface::intersect_ray`].
pub(crate) fn hits<P: QueryPatch>(
    patches: &[P],
    origin: DVec3,
    direction: DVec3,
) -> Result<Vec<SurfacePoint>, Error> {
    check_points("origin", &[origin])?;
    check_points("direction", &[direction])?;
    let along = Point::unit(direction);
    if along == DVec3::ZERO {
        return Err(Error::Range {
            what: "direction",
            expected: "a vector of a length above 0",
            got: 0.0,
        });
    }
    let mut found = Vec::new();
    if let Some(bounds) = box_of(patches) {
        let scaling = Scaling::around(bounds.including(origin)).as_coarse_as_its_coordinates();
        let (e1, e2) = along.any_orthonormal_pair();
        let ray = Ray {
            start: scaling.local_point(origin),
            along,
            across: [e1, e2],
        };
        let all = map_patches(patches.len(), |k| {
            hits_of(&patches[k], k, &ray, &scaling, origin)
        });
        for hits in all {
            let is_same = |a: &SurfacePoint, b: &SurfacePoint| {
                let apart = Point::norm(a.point - b.point);
                // `hit_uncertainty` computes a normal, so it is called only where the simpler limits do not decide.
                apart <= ZERO_TOLERANCE * scaling.size
                    || apart <= ON_SIDE * scaling.size
                        && [a, b]
                            .map(|hit| hit_uncertainty(patches, hit, &ray) * scaling.size)
                            .iter()
                            .any(|limit| apart <= *limit)
            };
            for hit in hits? {
                if !found.iter().any(|other| is_same(other, &hit)) {
                    let location = found
                        .partition_point(|other: &SurfacePoint| other.distance <= hit.distance);
                    found.insert(location, hit);
                }
            }
        }
    }
    Ok(found)
}

/// The hits of one patch, unsorted.
fn hits_of<P: QueryPatch>(
    patch: &P,
    number: usize,
    ray: &Ray,
    scaling: &Scaling,
    origin: DVec3,
) -> Result<Vec<SurfacePoint>, Error> {
    let Some(piece) = distances(patch, ray, scaling) else {
        return Ok(Vec::new());
    };
    let Some(zeros) = common_zeros(&piece) else {
        return Err(Error::too_many(
            "steps of a ray query",
            MAX_RAY_STEPS,
            MAX_RAY_STEPS + 1,
        ));
    };
    let mut hits: Vec<SurfacePoint> = zeros
        .points
        .iter()
        .map(|&[u, v]| SurfacePoint::at(patch, number, u, v, origin))
        .collect();
    // A point that Newton's method did not bring onto the ray is not a hit.
    hits.retain(|hit| {
        let from_start = scaling.local_point(hit.point) - ray.start;
        from_start.dot(ray.along) >= -ZERO_TOLERANCE
            && Point::norm(from_start.cross(ray.along)) <= 0.5 * ON_SIDE
    });
    let reach = ZERO_TOLERANCE * scaling.size;
    if !zeros.complete && patch.control_bounds().distance(origin) <= reach {
        let origin_on_patch = patch.nearest_within(origin, reach);
        hits.extend(
            origin_on_patch
                .map(|PatchPoint { u, v, .. }| SurfacePoint::at(patch, number, u, v, origin)),
        );
    }
    Ok(hits)
}

/// The distances of a patch from the two planes of the ray, and the distance along the ray; `None` if the whole patch
/// lies behind the start or beside the ray.
fn distances(patch: &impl QueryPatch, ray: &Ray, scaling: &Scaling) -> Option<PolynomialPiece> {
    let from_start = patch.numerator(&|p| scaling.local_point(p) - ray.start);
    let is_all =
        |test: &dyn Fn(f64) -> bool, axis: DVec3| from_start.iter().all(|p| test(p.dot(axis)));
    let is_beside = |axis: DVec3| {
        is_all(&|d| d > ZERO_TOLERANCE, axis) || is_all(&|d| d < -ZERO_TOLERANCE, axis)
    };
    if is_all(&|d| d < -ZERO_TOLERANCE, ray.along) || ray.across.iter().any(|&axis| is_beside(axis))
    {
        return None;
    }
    let [e1, e2] = ray.across;
    let planes = [e1, e2, ray.along]
        .iter()
        .flat_map(|axis| from_start.iter().map(|p| p.dot(*axis)))
        .collect();
    Some(PolynomialPiece::whole(
        0,
        patch.columns(),
        from_start.len() / patch.columns(),
        planes,
    ))
}

/// The largest distance, as a fraction of the scene's size, at which two hits count as one.
///
/// The edge that two patches share, or the seam of one patch, is the same curve from both sides except for the last
/// digits. Where the ray grazes it, a hit moves by this error divided by the cosine of the ray's angle with the normal.
/// Duplicate hits inside a patch are already merged by the patch's own search.
fn hit_uncertainty(patches: &[impl QueryPatch], hit: &SurfacePoint, ray: &Ray) -> f64 {
    let is_end = |t: f64| t.min(1.0 - t) <= ON_SIDE;
    if !(is_end(hit.u) || is_end(hit.v)) {
        return ZERO_TOLERANCE;
    }
    let normal = patches[hit.patch].normal(hit.u, hit.v);
    (8.0 * ZERO_TOLERANCE / normal.dot(ray.along).abs()).min(ON_SIDE)
}
