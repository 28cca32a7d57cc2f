//! Which point of the surface is nearest?
//!
//! The squared distance |S(u, v) − p|² is a polynomial of degrees 2m and 2n; its Bernstein coefficients bound it from
//! below over any piece. So the least value can be found for certain, with Newton's method only to speed things up.
//! Source of the search by bounds: Johnson and Cohen, "A framework for efficient minimum distance computations", ICRA
//! 1998; of products in Bernstein form: Farin, *Curves and Surfaces for CAGD*, §6.9.

use super::frame::{Frame, box_of};
use super::minimum::{Minimum, Objective, minimise};
use super::normal::binomial;
use super::piece::Piece;
use super::small_distance::search_small;
use super::{Patch, Surface};
use crate::curve::{Bounds, check_finite};
use crate::error::Error;
use crate::point::Point;
use casteljau_kernels::add_product;
use glam::DVec3;

/// What rounding makes of a point of a patch, as a share of the size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Below this share of the size, the squared distance has lost digits that Gauss–Newton steps can bring back; more of
/// these steps than the maximum only creep.
const SMALL_DISTANCE: f64 = 1.0 / 1024.0;
const MAX_REFINEMENTS: usize = 16;

/// Below the lesser share of the size, rounding of the squared distance hides that other places are nearer; below the
/// greater one, the search by squares may take long.
const LOST_IN_SQUARES: f64 = 1.0 / 1_048_576.0;
const ROUGH_IN_SQUARES: f64 = 1.0 / 65_536.0;

/// The damping of steps, as shares of the sum of the squared derivatives.
const DAMPING: [f64; 4] = [1e-12, 1e-8, 1e-4, 0.1];

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
    /// Two searches, by the square of the distance and, where it is below 2⁻¹⁶ of the size, by the distance itself, take at
    /// most 2²³ steps each, about one for each multiplication: some milliseconds (2²⁶ above degree 24). Where that is not
    /// enough, as where a whole curve of the patch is nearest, the point is the nearest one found by then: a local minimum
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
    pub(super) fn nearest_within(&self, p: DVec3, reach: f64) -> Option<PatchPoint> {
        let patches = std::slice::from_ref(self);
        let frame = Frame::around(box_of(patches)?);
        let images = [frame.image(self)];
        let distance = Distance::new(patches, &[0], &images, &frame, p);
        // Farther away, since the bounds round.
        let (found, is_complete) = distance.search_small(None, 4.0 * reach);
        let is_near = |place: &SurfacePoint| place.distance <= reach;
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
    let corner = |patch: &Patch| (patch.points[0] * 0.5 - p * 0.5).norm();
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
    let least = minimise(&roots, &distance)?;
    let mut place = distance.place(least.root, [least.u, least.v]);
    if place.distance <= ROUGH_IN_SQUARES * distance.size {
        let (nearer, _) = distance.search_small(Some(place), f64::INFINITY);
        place = nearer.unwrap_or(place);
    }
    Some(distance.refined(&place))
}

/// The distance of patches from a point.
struct Distance<'a> {
    patches: &'a [Patch],
    /// The numbers of the patches that the polynomials are for …
    near: &'a [usize],
    /// … and these patches in a frame, with the point there.
    images: &'a [Patch],
    image_of_p: DVec3,
    p: DVec3,
    /// The size that rounding is relative to.
    size: f64,
}

impl Objective for Distance<'_> {
    fn value(&self, root: usize, at: [f64; 2]) -> f64 {
        self.place(root, at).distance
    }

    fn degree_factor(&self) -> usize {
        2
    }

    /// The square of a small distance has lost the digits that the difference S − p still has.
    fn refine(&self, root: usize, at: [f64; 2]) -> [f64; 2] {
        let place = self.descend(self.place(root, at));
        [place.u, place.v]
    }

    /// Whether the distance is so small that [`search_small`](Self::search_small) follows, or all control points lie
    /// behind the plane through the place at right angles to the way from the point to it: so does the convex hull of the
    /// net, and with it the patch.
    fn is_least(&self, minimum: &Minimum) -> bool {
        if minimum.value <= LOST_IN_SQUARES * self.size {
            return true;
        }
        let place = self.images[minimum.root].eval(minimum.u, minimum.v);
        let normal = (place - self.image_of_p).unit();
        let is_behind = |point: &DVec3| (*point - place).dot(normal) >= -ROUNDING;
        self.images
            .iter()
            .all(|image| image.points.iter().all(is_behind))
    }
}

impl<'a> Distance<'a> {
    fn new(
        patches: &'a [Patch],
        near: &'a [usize],
        images: &'a [Patch],
        frame: &Frame,
        p: DVec3,
    ) -> Self {
        Self {
            patches,
            near,
            images,
            image_of_p: frame.place(p),
            p,
            size: frame.as_coarse_as_its_coordinates().size,
        }
    }

    /// The nearest place, if it is no farther away than `cutoff`, some place otherwise; and whether the search came to its
    /// end.
    fn search_small(
        &self,
        mut best: Option<SurfacePoint>,
        cutoff: f64,
    ) -> (Option<SurfacePoint>, bool) {
        let roots = (0..).zip(self.near).map(|(root, &k)| {
            let patch = &self.patches[k];
            let off = |q: &DVec3| (*q * 0.5 - self.p * 0.5) * (2.0 / self.size);
            let axis = |axis: usize| patch.points.iter().map(move |q| off(q).coordinate(axis));
            let planes = (0..3).flat_map(axis).collect();
            Piece::whole(root, patch.columns, patch.rows(), planes)
        });
        let least = best.map_or(f64::INFINITY, |best| best.distance / self.size);
        let mut descend = |root: usize, at: [f64; 2]| {
            let place = self.descend(self.place(root, at));
            if best.is_none_or(|best| place.distance < best.distance) {
                best = Some(place);
            }
            place.distance / self.size
        };
        let limits = [ROUNDING, cutoff / self.size];
        let is_complete = search_small(roots.collect(), least, limits, &mut descend);
        (best, is_complete)
    }

    /// A place that Gauss–Newton steps lead to where the distance is small.
    fn descend(&self, mut place: SurfacePoint) -> SurfacePoint {
        for _ in 0..MAX_REFINEMENTS {
            if place.distance > SMALL_DISTANCE * self.size {
                break;
            }
            let next = self.refined(&place);
            if next.distance == place.distance {
                break;
            }
            place = next;
        }
        place
    }

    fn place(&self, root: usize, [u, v]: [f64; 2]) -> SurfacePoint {
        let patch = self.near[root];
        SurfacePoint::at(&self.patches[patch], patch, u, v, self.p)
    }

    /// The nearest of the places after a Gauss–Newton step, more or less damped (Levenberg and Marquardt's method), along
    /// both parameters or along one; the place itself if none is nearer. Undamped steps fail where the derivative is
    /// singular, as on a patch that is a curve; steps along both may fail at the sides.
    fn refined(&self, place: &SurfacePoint) -> SurfacePoint {
        let patch = &self.patches[place.patch];
        let d = patch.partials(place.u, place.v);
        let off = place.point - self.p;
        let (uu, uv, vv) = (d.u.dot(d.u), d.u.dot(d.v), d.v.dot(d.v));
        let (u, v) = (d.u.dot(off), d.v.dot(off));
        let damped = |share: f64| {
            let (uu, vv) = (uu + share * (uu + vv), vv + share * (uu + vv));
            let det = uu * vv - uv * uv;
            [(vv * u - uv * v) / det, (uu * v - uv * u) / det]
        };
        // By the normal and not by the products: these lose the lesser of two coordinates of very different sizes.
        let normal = d.u.cross(d.v);
        let square = normal.dot(normal);
        let undamped = [
            off.cross(d.v).dot(normal) / square,
            d.u.cross(off).dot(normal) / square,
        ];
        let others = [undamped, [u / uu, 0.0], [0.0, v / vv]];
        let mut nearest = *place;
        for [u, v] in DAMPING.map(damped).into_iter().chain(others) {
            let [u, v] = [place.u - u, place.v - v].map(|t| t.clamp(0.0, 1.0));
            let next = SurfacePoint::at(patch, place.patch, u, v, self.p);
            // A step that is not finite leads nowhere.
            if next.distance < nearest.distance {
                nearest = next;
            }
        }
        nearest
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
fn squared_distance(root: usize, image: &Patch, frame: &Frame, p: DVec3) -> Piece {
    let away = frame.centre * 0.5 - p * 0.5;
    let unit = (0.5 * frame.size).max(away.norm());
    let (share, toward) = (0.5 * frame.size / unit, away / unit * 2.0);
    let (m, n) = (image.degree_u(), image.degree_v());
    let weights: Vec<f64> = (0..image.points.len())
        .map(|k| binomial(m, k % (m + 1)) * binomial(n, k / (m + 1)))
        .collect();
    let columns = 2 * m + 1;
    let mut product = vec![0.0; columns * (2 * n + 1)];
    for axis in 0..3 {
        let weighted = |of: &dyn Fn(DVec3) -> DVec3| -> Vec<f64> {
            let points = image.points.iter().zip(&weights);
            points.map(|(&q, w)| of(q).coordinate(axis) * w).collect()
        };
        let left = weighted(&|q| q);
        let right = weighted(&|q| q * share + toward);
        add_product(&mut product, &left, &right, m + 1);
    }
    for (k, coefficient) in product.iter_mut().enumerate() {
        *coefficient /= binomial(2 * m, k % columns) * binomial(2 * n, k / columns);
    }
    Piece::whole(root, columns, 2 * n + 1, product)
}
