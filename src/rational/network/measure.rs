//! Bounding box, area and volume of surfaces of rational patches.
//!
//! The integrands are quotients, |∂u × ∂v| and det(S, ∂u, ∂v): a patch is halved until its weights differ by a factor of 2 at most,
//! and then split where two levels of a Gauss rule disagree.

use super::RationalSurface;
use super::mesh::RationalSampler;
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::parallel::map_patches;
use crate::rational::patch::{RationalPatch, bounds_of};
use crate::surface::piece::PolynomialPiece;
use crate::surface::scaling::Scaling;
use casteljau_kernels::numeric::gauss::GAUSS_8;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// The change of an integral from one level to the next at which it is accepted, relative to the integral of its absolute value.
const MAX_CHANGE: f64 = 1e-11;

/// The change that is always accepted, for a patch of size 1: rounding noise.
const NOISE: f64 = 4.0 * f64::EPSILON;

/// The area below which a patch counts as having no area, for a patch of size 1.
const NO_AREA: f64 = 32.0 * f64::EPSILON;

/// The maximum number of steps of an integral, about one for each multiplication. Only weights of very different sizes and folds
/// need this many.
const MAX_STEPS: usize = 1 << 25;

/// The number of samples of the rule over one tile.
const SAMPLES: usize = 64;

/// A rectangle of parameters, and the integral over it.
#[derive(Clone, Copy)]
struct Tile {
    u: [f64; 2],
    v: [f64; 2],
    integral: f64,
}

impl RationalSurface {
    /// The smallest box that contains the surface; `None` without patches. See [`RationalPatch::bounds`].
    pub fn bounds(&self) -> Option<Bounds<DVec3>> {
        bounds_of(self.patches())
    }

    /// The total area of all patches; 0 without patches.
    ///
    /// Regions that a patch covers twice count twice. The relative error is about 1e-11 for patches without folds; where a patch
    /// folds back, fewer digits may be right. Each patch takes at most 2²⁵ steps, about one for each multiplication.
    pub fn area(&self) -> f64 {
        let area = |k| self.patch(k).map_or(0.0, area);
        let mut sum = 0.0; // `Iterator::sum` would start with −0
        for area in map_patches(self.patch_count(), area) {
            sum += area;
        }
        sum
    }

    /// The volume that a closed surface encloses, with an error of about 1e-11 of it; `None` for a surface that is not closed.
    ///
    /// By the divergence theorem it is ⅓ ∮ S·(∂u × ∂v) du dv. Signs, and when a surface is closed, are as of
    /// [`Surface::volume`](crate::Surface::volume). Each patch takes at most 2²⁵ steps.
    pub fn volume(&self) -> Option<f64> {
        let signs = self.network.orientation(&self.topology())?;
        let whole = Scaling::around(self.control_bounds()?);
        let cone = |k: usize| {
            self.patch(k)
                .map_or(0.0, |patch| signs[k] * cone(patch, &whole))
        };
        let mut sum = 0.0;
        for cone in map_patches(self.patch_count(), cone) {
            sum += cone;
        }
        Some(sum / 3.0 * whole.size * whole.size * whole.size)
    }
}

fn area(patch: RationalPatch) -> f64 {
    let size = Scaling::around(patch.control_bounds()).size;
    let area = integral(patch, |[_, along_u, along_v]| {
        Point::norm(along_u.cross(along_v))
    });
    if area <= NO_AREA {
        return 0.0;
    }
    area * size * size
}

/// ∫∫ S·(∂u × ∂v) du dv in the scaled coordinates of a surface: three times the volume of the cone from its center over the patch.
fn cone(patch: RationalPatch, whole: &Scaling) -> f64 {
    let own = Scaling::around(patch.control_bounds());
    let (size, offset) = (own.size / whole.size, whole.local_point(own.centre));
    let cone = integral(patch, |[point, along_u, along_v]| {
        (point * size + offset).dot(along_u.cross(along_v))
    });
    cone * size * size
}

/// The integral of a function of S, ∂S/∂u and ∂S/∂v in the scaled coordinates of a patch.
fn integral(patch: RationalPatch, f: impl Fn([DVec3; 3]) -> f64) -> f64 {
    let steps = SAMPLES * (16 + 12 * patch.weights().len());
    let mut work = WorkLimit::new(MAX_STEPS);
    let max_tiles = MAX_STEPS / steps / 8;
    let rectangles = of_similar_weights(&patch, max_tiles);
    let mut sampler = RationalSampler::new(patch);
    let mut rule = |u: [f64; 2], v: [f64; 2]| {
        let tile = Tile {
            u,
            v,
            integral: 0.0,
        };
        tile.integrated(&mut |u, v| f(sampler.derivatives(u, v)))
    };
    let mut tiles: Vec<Tile> = rectangles.map(|[u, v]| rule(u, v)).collect();
    let mut finished = 0.0;
    while !tiles.is_empty() {
        let level = 4 * steps * tiles.len();
        if work.used() + level > MAX_STEPS {
            break;
        }
        work.count(level);
        let split: Vec<([Tile; 4], f64)> = tiles
            .iter()
            .map(|tile| {
                let quarters = tile.quarters().map(|[u, v]| rule(u, v));
                let sum: f64 = quarters.iter().map(|quarter| quarter.integral).sum();
                (quarters, (sum - tile.integral).abs())
            })
            .collect();
        let size = split.iter().flat_map(|(quarters, _)| quarters);
        let size = size.fold(f64::abs(finished), |sum, tile| sum + tile.integral.abs());
        let allowed = (MAX_CHANGE * size + NOISE) / as_f64(split.len());
        tiles.clear();
        for (quarters, change) in split {
            if change > allowed {
                tiles.extend(quarters);
            } else {
                finished += quarters.iter().map(|tile| tile.integral).sum::<f64>();
            }
        }
    }
    tiles.iter().fold(finished, |sum, tile| sum + tile.integral)
}

/// Rectangles of parameters over which the weights of the patch differ by a factor of 2 at most, unless there would be too many.
fn of_similar_weights(
    patch: &RationalPatch,
    max: usize,
) -> impl Iterator<Item = [[f64; 2]; 2]> + use<> {
    let (columns, rows) = (patch.degree_u() + 1, patch.degree_v() + 1);
    let whole = PolynomialPiece::whole(0, columns, rows, patch.weights().to_vec());
    let (mut pieces, mut similar) = (vec![whole], Vec::new());
    while let Some(piece) = pieces.pop() {
        let [low, high] = piece.range(0);
        if high <= 2.0 * low || pieces.len() + similar.len() >= max || !piece.is_divisible() {
            similar.push([piece.u, piece.v]);
        } else {
            pieces.extend(piece.halves(1));
        }
    }
    similar.into_iter()
}

impl Tile {
    fn quarters(&self) -> [[[f64; 2]; 2]; 4] {
        let halves = |[from, to]: [f64; 2]| {
            let middle = 0.5 * (from + to);
            [[from, middle], [middle, to]]
        };
        let ([u0, u1], [v0, v1]) = (halves(self.u), halves(self.v));
        [[u0, v0], [u1, v0], [u0, v1], [u1, v1]]
    }

    /// The tile with the integral of a function of (u, v) by Gauss–Legendre quadrature with 8 × 8 points.
    fn integrated(mut self, f: &mut dyn FnMut(f64, f64) -> f64) -> Self {
        for (v, weight_v) in nodes(self.v) {
            for (u, weight_u) in nodes(self.u) {
                self.integral += weight_u * weight_v * f(u, v);
            }
        }
        self
    }
}

/// The nodes and weights of the rule in an interval.
fn nodes([from, to]: [f64; 2]) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    (0..2 * GAUSS_8.nodes.len()).map(move |k| {
        let offset = half * GAUSS_8.nodes[k / 2];
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        (middle + sign * offset, half * GAUSS_8.weights[k / 2])
    })
}
