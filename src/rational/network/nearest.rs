//! Nearest points and rays on surfaces of rational patches.
//!
//! With S = A/w, the points at the distance d from p are the zeros of |A − wp|² − d²w², whose minimum is below 0 if there is a nearer
//! point. The distance of that minimum is the next d; it falls until rounding stops it, and the steps converge faster than linearly
//! (Dinkelbach, "On nonlinear fractional programming", *Management Science* 13, 1967). Patches are halved first until their
//! weights differ little, so that the rounding errors of products of weights are small everywhere.

use super::RationalSurface;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::patch::patch_point::PatchPoint;
use crate::rational::patch::RationalPatch;
use crate::rational::weighted::Homogeneous;
use crate::surface::SurfacePoint;
use crate::surface::distance::{
    MAX_REFINEMENTS, ROUGH_IN_SQUARES, ROUNDING, SMALL_AT_THE_LIMIT, SMALL_DISTANCE, refined,
    sum_of_products,
};
use crate::surface::minimum::{Minimum, Objective, minimise_within};
use crate::surface::piece::{MODERATE_DEGREE, PolynomialPiece, max_search_steps};
use crate::surface::query_patch::QueryPatch;
use crate::surface::ray::hits;
use crate::surface::scaling::{Scaling, box_of};
use crate::surface::small_distance::search_small;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// The largest quotient of two weights of a piece.
const MAX_QUOTIENT: f64 = 16.0;

/// The maximum number of pieces of a patch. The weights of the others may differ more.
const MAX_PIECES: usize = 1024;

/// More steps than it takes to converge.
const MAX_STEPS: usize = 32;

/// A step is the last one if it reduces the distance by less than this fraction of the size.
const LAST_STEP: f64 = 1e-13;

impl RationalSurface {
    /// The point of the surface that is nearest to p; `None` without patches. See [`Surface::nearest`](crate::Surface::nearest).
    ///
    /// It takes at most 2²⁴ steps for each patch (2²⁷ above degree 24), and then returns the best point found; only weights of very
    /// different sizes need this many.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    pub fn nearest(&self, p: DVec3) -> Result<Option<SurfacePoint>, Error> {
        check_points("point", &[p])?;
        let patches: Vec<RationalPatch> = self.patches().collect();
        Ok(nearest(&patches, p))
    }

    /// All hits of a ray, sorted by distance; see [`Surface::intersect_ray`](crate::Surface::intersect_ray).
    ///
    /// # Errors
    /// As there.
    pub fn intersect_ray(
        &self,
        origin: DVec3,
        direction: DVec3,
    ) -> Result<Vec<SurfacePoint>, Error> {
        let patches: Vec<RationalPatch> = self.patches().collect();
        hits(&patches, origin, direction)
    }
}

impl QueryPatch for RationalPatch {
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
        self.degree_u() + 1
    }

    fn numerator(&self, local: &dyn Fn(DVec3) -> DVec3) -> Vec<DVec3> {
        let weights = self.homogeneous(DVec3::ZERO);
        let parts = self.control_points().iter().zip(&weights);
        parts.map(|(&p, part)| local(p) * part.weight).collect()
    }

    fn nearest_within(&self, p: DVec3, reach: f64) -> Option<PatchPoint> {
        let nearest = nearest(std::slice::from_ref(self), p)?;
        (nearest.distance <= reach).then(|| nearest.on_patch())
    }
}

/// A part of a patch whose weights differ little.
struct Part {
    number: usize,
    /// Its range of parameters on the patch.
    u: [f64; 2],
    v: [f64; 2],
    patch: RationalPatch,
}

/// The distance of parts of patches from a point.
struct Distance<'a> {
    patches: &'a [RationalPatch],
    parts: &'a [&'a Part],
    p: DVec3,
    /// The size to which rounding errors are relative.
    size: f64,
}

/// The nearest point; `None` without patches.
fn nearest(patches: &[RationalPatch], p: DVec3) -> Option<SurfacePoint> {
    let scaling = Scaling::around(box_of(patches)?);
    let corner = |number: usize| SurfacePoint::at(&patches[number], number, 0.0, 0.0, p);
    let mut best = (0..patches.len())
        .map(corner)
        .min_by(|a, b| a.distance.total_cmp(&b.distance))?;
    let is_near = |patch: &RationalPatch, best: &SurfacePoint| {
        patch.control_bounds().distance(p) <= best.distance * (1.0 + 8.0 * f64::EPSILON)
    };
    let near = (0..patches.len()).filter(|&number| is_near(&patches[number], &best));
    let near: Vec<usize> = near.collect();
    let limits = near.iter().map(|&number| {
        let patch = &patches[number];
        max_search_steps(patch.degree_u().max(patch.degree_v()), MODERATE_DEGREE)
    });
    let limit = limits.fold(0, usize::saturating_add);
    let mut work = WorkLimit::new(limit);
    let parts: Vec<Part> = near
        .into_iter()
        .flat_map(|number| parts_of(&patches[number], number))
        .collect();
    let size = scaling.as_coarse_as_its_coordinates().size;
    let mut small = ROUGH_IN_SQUARES;
    for _ in 0..MAX_STEPS {
        let near: Vec<&Part> = parts
            .iter()
            .filter(|part| is_near(&part.patch, &best))
            .collect();
        let wholes: Vec<PolynomialPiece> = (0..)
            .zip(&near)
            .map(|(index, part)| excess(index, &part.patch, &scaling, p, best.distance))
            .collect();
        let distance = Distance {
            patches,
            parts: &near,
            p,
            size,
        };
        let Some((min, is_complete)) = minimise_within(&wholes, &distance, &mut work) else {
            break;
        };
        if !is_complete {
            small = SMALL_AT_THE_LIMIT;
        }
        let next = distance.surface_point(min.index, [min.u, min.v]);
        let gain = best.distance - next.distance;
        if gain > 0.0 {
            best = next;
        }
        if gain <= LAST_STEP * size || !is_complete {
            break;
        }
    }
    let all: Vec<&Part> = parts.iter().collect();
    let distance = Distance {
        patches,
        parts: &all,
        p,
        size,
    };
    if best.distance <= small * size {
        best = distance.search_small(best, WorkLimit::new(limit));
    }
    Some(distance.refined(&best))
}

/// The parts of a patch.
fn parts_of(patch: &RationalPatch, number: usize) -> Vec<Part> {
    let whole = Part {
        number,
        u: [0.0, 1.0],
        v: [0.0, 1.0],
        patch: patch.clone(),
    };
    let (mut open, mut parts) = (vec![whole], Vec::new());
    while let Some(part) = open.pop() {
        let range = part.patch.weights().iter();
        let [min, max] = range.fold([f64::INFINITY, 0.0], |[min, max]: [f64; 2], &w| {
            [min.min(w), max.max(w)]
        });
        if max <= MAX_QUOTIENT * min || open.len() + parts.len() >= MAX_PIECES {
            parts.push(part);
        } else {
            open.extend(part.halves());
        }
    }
    parts
}

/// |A − wp|² − d²w², divided by a constant that is the same for all patches.
///
/// With q = (S − center)/size and e = (center − p)/size it is w² times q² + 2 q·e + e² − (d/size)², here divided by max(1, |e|).
fn excess(
    index: usize,
    patch: &RationalPatch,
    scaling: &Scaling,
    p: DVec3,
    d: f64,
) -> PolynomialPiece {
    let away = scaling.centre - p;
    let distance = Point::norm(away);
    let unit = scaling.size.max(distance);
    let (share, toward) = (scaling.size / unit, away / unit * 2.0);
    let rest = (distance - d) / scaling.size * ((distance + d) / unit);
    let net = patch.scaled(scaling);
    // The largest weight is ½ to 1, so that coefficients have a size of at most 8.
    let numbers = |of: &dyn Fn(&Homogeneous<DVec3>) -> f64| -> Vec<f64> {
        net.iter().map(|part| 0.5 * of(part)).collect()
    };
    let squares = (0..3).map(|axis| {
        [
            numbers(&|part| part.vector.coordinate(axis)),
            numbers(&|part| (part.vector * share + toward * part.weight).coordinate(axis)),
        ]
    });
    let weights = [
        numbers(&|part| part.weight),
        numbers(&|part| part.weight * rest),
    ];
    let degrees = [patch.degree_u(), patch.degree_v()];
    sum_of_products(index, degrees, squares.chain(std::iter::once(weights)))
}

impl Part {
    /// The halves in the direction in which the weights change most.
    fn halves(self) -> [Self; 2] {
        let columns = self.patch.degree_u() + 1;
        let weights = self.patch.weights();
        let quotient = |a: f64, b: f64| (a / b).max(b / a);
        let along_u = weights.chunks(columns).flat_map(|row| row.windows(2));
        let along_u = along_u.fold(1.0, |max: f64, pair| max.max(quotient(pair[0], pair[1])));
        let along_v = weights.iter().zip(weights.iter().skip(columns));
        let along_v = along_v.fold(1.0, |max: f64, (&a, &b)| max.max(quotient(a, b)));
        let by_u = along_u >= along_v;
        let (before, after) = self.patch.halves(by_u);
        let halves = |[from, to]: [f64; 2]| {
            let middle = 0.5 * (from + to);
            [[from, middle], [middle, to]]
        };
        let ([u0, u1], [v0, v1]) = if by_u {
            (halves(self.u), [self.v; 2])
        } else {
            ([self.u; 2], halves(self.v))
        };
        let part = |u, v, patch| Self {
            number: self.number,
            u,
            v,
            patch,
        };
        [part(u0, v0, before), part(u1, v1, after)]
    }
}

impl Objective for Distance<'_> {
    fn value(&self, index: usize, at: [f64; 2]) -> f64 {
        self.surface_point(index, at).distance
    }

    fn degree_factor(&self) -> usize {
        2
    }

    fn refine(&self, index: usize, at: [f64; 2]) -> [f64; 2] {
        let part = self.parts[index];
        let start = self.surface_point(index, at);
        let found = self.descend(start);
        let within = |[from, to]: [f64; 2], t: f64| ((t - from) / (to - from)).clamp(0.0, 1.0);
        let inside = [within(part.u, found.u), within(part.v, found.v)];
        // The steps may leave the part, and its nearest boundary point may be farther than their start.
        if self.value(index, inside) < start.distance {
            inside
        } else {
            at
        }
    }

    fn is_final(&self, minimum: &Minimum) -> bool {
        minimum.value == 0.0
    }
}

impl Distance<'_> {
    /// The point at parameters of a part.
    fn surface_point(&self, index: usize, at: [f64; 2]) -> SurfacePoint {
        let part = self.parts[index];
        let within = |[from, to]: [f64; 2], t: f64| from + t * (to - from);
        let (u, v) = (within(part.u, at[0]), within(part.v, at[1]));
        SurfacePoint::at(&self.patches[part.number], part.number, u, v, self.p)
    }

    /// The nearest of a point and the points after Gauss–Newton steps from it.
    fn refined(&self, from: &SurfacePoint) -> SurfacePoint {
        let patch = &self.patches[from.patch];
        let d = patch.partials(from.u, from.v);
        refined(from, &d, self.p, &|[u, v]| {
            SurfacePoint::at(patch, from.patch, u, v, self.p)
        })
    }

    /// Refines a point while its distance is small.
    fn descend(&self, mut from: SurfacePoint) -> SurfacePoint {
        for _ in 0..MAX_REFINEMENTS {
            if from.distance > SMALL_DISTANCE * self.size {
                break;
            }
            let next = self.refined(&from);
            if next.distance == from.distance {
                break;
            }
            from = next;
        }
        from
    }

    /// The nearest point by a search of the distance itself, whose square has lost digits.
    fn search_small(&self, mut best: SurfacePoint, work: WorkLimit) -> SurfacePoint {
        let wholes = (0..).zip(self.parts).map(|(index, part)| {
            // The weights are at most 1, so that |A − wp| is at most the distance.
            let net = part.patch.numerator(&|q| (q - self.p) / self.size * 0.5);
            let planes = (0..3).flat_map(|axis| net.iter().map(move |q| q.coordinate(axis)));
            let (columns, planes) = (part.patch.columns(), planes.collect());
            PolynomialPiece::whole(index, columns, net.len() / columns, planes)
        });
        let min = best.distance / self.size;
        let mut descend = |index: usize, at: [f64; 2]| {
            let found = self.descend(self.surface_point(index, at));
            if found.distance < best.distance {
                best = found;
            }
            found.distance / self.size
        };
        let limits = [ROUNDING, f64::INFINITY];
        search_small(wholes.collect(), min, limits, &mut descend, work);
        best
    }
}
