//! Distance of patches from a point: its square as a polynomial, and Gauss–Newton steps that reduce it.

use super::minimum::{Minimum, Objective};
use super::piece::{MODERATE_DEGREE, PolynomialPiece};
use super::scaling::Scaling;
use super::small_distance::search_small;
use super::surface_point::SurfacePoint;
use crate::geometry::point::Point;
use crate::patch::normal::binomial;
use crate::patch::{Partials, Patch};
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// Rounding error of a point of a patch, as a fraction of the size.
pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Below this fraction of the size, the squared distance has lost digits that Gauss–Newton steps can recover. More than
/// `MAX_REFINEMENTS` of these steps hardly improve the result.
pub(crate) const SMALL_DISTANCE: f64 = 1.0 / 1024.0;
pub(crate) const MAX_REFINEMENTS: usize = 16;

/// Below `LOST_IN_SQUARES` times the size, rounding of the squared distance hides that other points are nearer. Below
/// `ROUGH_IN_SQUARES` times the size, the search by squared distances may be slow.
const LOST_IN_SQUARES: f64 = 1.0 / 1_048_576.0;
pub(crate) const ROUGH_IN_SQUARES: f64 = 1.0 / 65_536.0;

/// If the search by squared distances reaches its work limit, the search by distances follows below this fraction of
/// the size. The latter bounds distances to first order only, so for larger distances it would exclude few pieces.
pub(crate) const SMALL_AT_THE_LIMIT: f64 = 1.0 / 16.0;

/// Damping of Gauss–Newton steps, as fractions of the sum of the squared derivatives.
const DAMPING: [f64; 4] = [1e-12, 1e-8, 1e-4, 0.1];

/// The distance of patches from a point.
pub(crate) struct PatchDistance<'a> {
    patches: &'a [Patch],
    /// The indices of the patches to which the polynomials belong.
    near: &'a [usize],
    /// These patches and the query point in scaled coordinates.
    images: &'a [Patch],
    image_of_p: DVec3,
    p: DVec3,
    /// The size to which rounding errors are relative.
    pub(crate) size: f64,
}

impl Objective for PatchDistance<'_> {
    fn value(&self, index: usize, at: [f64; 2]) -> f64 {
        self.surface_point(index, at).distance
    }

    fn degree_factor(&self) -> usize {
        2
    }

    /// Refines with Gauss–Newton steps: the difference S − p still has the digits that the square of a small distance
    /// has lost.
    fn refine(&self, index: usize, at: [f64; 2]) -> [f64; 2] {
        let surface_point = self.descend(self.surface_point(index, at));
        [surface_point.u, surface_point.v]
    }

    /// Whether the distance is so small that [`search_small`](Self::search_small) follows, or all control points lie
    /// beyond the plane through the found point that is perpendicular to the line from the query point. In the second
    /// case the convex hull of the net, and with it the patch, lies beyond this plane.
    fn is_final(&self, minimum: &Minimum) -> bool {
        if minimum.value <= LOST_IN_SQUARES * self.size {
            return true;
        }
        let surface_point = self.images[minimum.index].eval(minimum.u, minimum.v);
        let normal = Point::unit(surface_point - self.image_of_p);
        let is_behind = |point: &DVec3| (*point - surface_point).dot(normal) >= -ROUNDING;
        self.images
            .iter()
            .all(|image| image.points.iter().all(is_behind))
    }
}

impl<'a> PatchDistance<'a> {
    pub(crate) fn new(
        patches: &'a [Patch],
        near: &'a [usize],
        images: &'a [Patch],
        scaling: &Scaling,
        p: DVec3,
    ) -> Self {
        Self {
            patches,
            near,
            images,
            image_of_p: scaling.local_point(p),
            p,
            size: scaling.as_coarse_as_its_coordinates().size,
        }
    }

    /// The nearest point if its distance is at most `cutoff`, any point otherwise; and whether the search is complete.
    pub(crate) fn search_small(
        &self,
        mut best: Option<SurfacePoint>,
        cutoff: f64,
    ) -> (Option<SurfacePoint>, bool) {
        let wholes = (0..).zip(self.near).map(|(index, &k)| {
            let patch = &self.patches[k];
            let off = |q: &DVec3| (*q - self.p) / self.size;
            let axis = |axis: usize| patch.points.iter().map(move |q| off(q).coordinate(axis));
            let planes = (0..3).flat_map(axis).collect();
            PolynomialPiece::whole(index, patch.columns, patch.rows(), planes)
        });
        let min = best.map_or(f64::INFINITY, |best| best.distance / self.size);
        let mut descend = |index: usize, at: [f64; 2]| {
            let surface_point = self.descend(self.surface_point(index, at));
            if best.is_none_or(|best| surface_point.distance < best.distance) {
                best = Some(surface_point);
            }
            surface_point.distance / self.size
        };
        let limits = [ROUNDING, cutoff / self.size];
        let wholes: Vec<PolynomialPiece> = wholes.collect();
        let steps = wholes
            .iter()
            .map(|whole| whole.max_search_steps(MODERATE_DEGREE));
        let work = WorkLimit::new(steps.fold(0, usize::saturating_add));
        let is_complete = search_small(wholes, min, limits, &mut descend, work);
        (best, is_complete)
    }

    /// Refines a point with Gauss–Newton steps while the distance is small.
    fn descend(&self, mut surface_point: SurfacePoint) -> SurfacePoint {
        for _ in 0..MAX_REFINEMENTS {
            if surface_point.distance > SMALL_DISTANCE * self.size {
                break;
            }
            let next = self.refined(&surface_point);
            if next.distance == surface_point.distance {
                break;
            }
            surface_point = next;
        }
        surface_point
    }

    pub(crate) fn surface_point(&self, index: usize, [u, v]: [f64; 2]) -> SurfacePoint {
        let patch = self.near[index];
        SurfacePoint::at(&self.patches[patch], patch, u, v, self.p)
    }

    /// The nearest of the points after a Gauss–Newton step with different damping (Levenberg–Marquardt method), along
    /// both parameters or along one; the unchanged point if none is nearer. Undamped steps fail where the derivative is
    /// singular, as on a patch that is a curve; steps along both parameters may fail at edges.
    pub(crate) fn refined(&self, surface_point: &SurfacePoint) -> SurfacePoint {
        let patch = &self.patches[surface_point.patch];
        let d = patch.partials(surface_point.u, surface_point.v);
        refined(surface_point, &d, self.p, &|[u, v]| {
            SurfacePoint::at(patch, surface_point.patch, u, v, self.p)
        })
    }
}

/// [`PatchDistance::refined`] for a patch with these partial derivatives; `at` returns its points.
pub(crate) fn refined(
    surface_point: &SurfacePoint,
    d: &Partials,
    p: DVec3,
    at: &dyn Fn([f64; 2]) -> SurfacePoint,
) -> SurfacePoint {
    let off = surface_point.point - p;
    let (uu, uv, vv) = (d.u.dot(d.u), d.u.dot(d.v), d.v.dot(d.v));
    let (u, v) = (d.u.dot(off), d.v.dot(off));
    let damped = |share: f64| {
        let (uu, vv) = (uu + share * (uu + vv), vv + share * (uu + vv));
        let det = uu * vv - uv * uv;
        [(vv * u - uv * v) / det, (uu * v - uv * u) / det]
    };
    // This uses the normal instead of the scalar products, which lose the smaller of two coordinates of very
    // different sizes.
    let normal = d.u.cross(d.v);
    let square = normal.dot(normal);
    let undamped = [
        off.cross(d.v).dot(normal) / square,
        d.u.cross(off).dot(normal) / square,
    ];
    let others = [undamped, [u / uu, 0.0], [0.0, v / vv]];
    let mut nearest = *surface_point;
    for [u, v] in DAMPING.map(damped).into_iter().chain(others) {
        let [u, v] = [surface_point.u - u, surface_point.v - v].map(|t| t.clamp(0.0, 1.0));
        let next = at([u, v]);
        // A step that is not finite fails this comparison.
        if next.distance < nearest.distance {
            nearest = next;
        }
    }
    nearest
}

/// |S − p|², minus a constant and divided by a constant; both constants are the same for all patches.
///
/// With q = (S − centre)/size and d = (centre − p)/size it is q² + 2 q·d + d². The term d² is omitted, since it would
/// swamp the others for a distant p, and the rest is divided by |d| where |d| > 1.
pub(crate) fn squared_distance(
    index: usize,
    image: &Patch,
    scaling: &Scaling,
    p: DVec3,
) -> PolynomialPiece {
    let away = scaling.centre - p;
    let unit = scaling.size.max(Point::norm(away));
    let (share, toward) = (scaling.size / unit, away / unit * 2.0);
    let pairs = (0..3).map(|axis| {
        let numbers = |of: &dyn Fn(DVec3) -> DVec3| -> Vec<f64> {
            let points = image.points.iter();
            points.map(|&q| of(q).coordinate(axis)).collect()
        };
        [numbers(&|q| q), numbers(&|q| q * share + toward)]
    });
    sum_of_products(index, [image.degree_u(), image.degree_v()], pairs)
}

/// The sum of the products of pairs of polynomials of degrees m and n.
pub(crate) fn sum_of_products(
    index: usize,
    [m, n]: [usize; 2],
    pairs: impl Iterator<Item = [Vec<f64>; 2]>,
) -> PolynomialPiece {
    let columns = 2 * m + 1;
    let mut product = vec![0.0; columns * (2 * n + 1)];
    for mut pair in pairs {
        for net in &mut pair {
            for (k, coefficient) in net.iter_mut().enumerate() {
                *coefficient *= binomial(m, k % (m + 1)) * binomial(n, k / (m + 1));
            }
        }
        add_product(&mut product, &pair[0], &pair[1], m + 1);
    }
    for (k, coefficient) in product.iter_mut().enumerate() {
        *coefficient /= binomial(2 * m, k % columns) * binomial(2 * n, k / columns);
    }
    PolynomialPiece::whole(index, columns, 2 * n + 1, product)
}

/// Adds to `product`, whose rows have `2 * columns − 1` numbers, the product of two nets whose coefficients are
/// multiplied by their binomial coefficients: products of such coefficients are summed where the sums of their indices
/// agree.
fn add_product(product: &mut [f64], left: &[f64], right: &[f64], columns: usize) {
    let wide = 2 * columns - 1;
    for (j, left) in left.chunks_exact(columns).enumerate() {
        for (l, right) in right.chunks_exact(columns).enumerate() {
            let row = &mut product[(j + l) * wide..][..wide];
            for (i, a) in left.iter().enumerate() {
                for (sum, b) in row[i..i + columns].iter_mut().zip(right) {
                    *sum += a * b;
                }
            }
        }
    }
}
