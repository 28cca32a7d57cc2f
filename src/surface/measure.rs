//! Volume enclosed by a surface.

use super::network::Surface;
use super::scaling::{Scaling, box_of};
use super::topology::{EdgeUse, PatchEdge, Topology};
use crate::bernstein::polynomials::bernstein_into;
use crate::numeric::float::{as_f64, ratio};
use crate::parallel::map_patches;
use crate::patch::Patch;
use crate::patch::net::differences_u;
use casteljau_kernels::numeric::gauss::GAUSS_8;
use glam::DVec3;

/// The largest degree that one interval of the quadrature has to integrate; the 8-point rule is exact to 15.
const DEGREES_PER_INTERVAL: usize = 12;

/// A rectangle of parameters.
#[derive(Clone, Copy)]
struct ParameterRectangle {
    u: [f64; 2],
    v: [f64; 2],
}

impl Patch {
    /// ∫∫ S·(∂u × ∂v) du dv: three times the volume of the cone from the origin over the patch.
    fn cone(&self) -> f64 {
        let [along_u, along_v] =
            [self.degree_u(), self.degree_v()].map(|n| (3 * n - 1).div_ceil(DEGREES_PER_INTERVAL));
        let part = |k: usize, n: usize| [ratio(k, n), ratio(k + 1, n)];
        let tiles = (0..along_u * along_v).map(|k| ParameterRectangle {
            u: part(k % along_u, along_u),
            v: part(k / along_u, along_v),
        });
        tiles
            .map(|tile| self.integral(tile, &|p, du, dv| p.dot(du.cross(dv))))
            .sum()
    }

    /// The integral of a function of S, ∂u and ∂v over a tile.
    fn integral(&self, tile: ParameterRectangle, f: &dyn Fn(DVec3, DVec3, DVec3) -> f64) -> f64 {
        let [m, n] = [self.degree_u(), self.degree_v()];
        let du = differences_u(&self.points, self.columns);
        let along_v: Vec<QuadratureNode> = nodes(tile.v, n).collect();
        let mut sum = 0.0;
        for at_u in nodes(tile.u, m) {
            let curve: Vec<DVec3> = blends(&self.points, &at_u.weights).collect();
            let slopes: Vec<DVec3> = blends(&du, &at_u.lower).collect();
            let along = differences_u(&curve, curve.len());
            for at_v in &along_v {
                let value = f(
                    blend(&curve, &at_v.weights),
                    blend(&slopes, &at_v.weights) * as_f64(m),
                    blend(&along, &at_v.lower) * as_f64(n),
                );
                sum += at_u.weight * at_v.weight * value;
            }
        }
        sum
    }
}

/// A node of the quadrature: its weight, and the Bernstein weights of a degree and of the degree below.
struct QuadratureNode {
    weight: f64,
    weights: Vec<f64>,
    lower: Vec<f64>,
}

/// The nodes of the quadrature in an interval.
fn nodes([from, to]: [f64; 2], degree: usize) -> impl Iterator<Item = QuadratureNode> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    (0..2 * GAUSS_8.nodes.len()).map(move |k| {
        let (x, weight) = (GAUSS_8.nodes[k / 2], GAUSS_8.weights[k / 2]);
        let t = middle + if k % 2 == 0 { half * x } else { -half * x };
        let bernstein = |count: usize| {
            let mut weights = vec![0.0; count];
            bernstein_into(&mut weights, t);
            weights
        };
        QuadratureNode {
            weight: half * weight,
            weights: bernstein(degree + 1),
            lower: bernstein(degree),
        }
    })
}

/// The weighted sum of each row of points.
fn blends(points: &[DVec3], weights: &[f64]) -> impl Iterator<Item = DVec3> {
    points.chunks(weights.len()).map(|row| blend(row, weights))
}

fn blend(points: &[DVec3], weights: &[f64]) -> DVec3 {
    points
        .iter()
        .zip(weights)
        .fold(DVec3::ZERO, |sum, (&p, &w)| sum + p * w)
}

impl Surface {
    /// The volume that a closed surface encloses; `None` for a surface that is not closed.
    ///
    /// By the divergence theorem it is ⅓ ∮ S·(∂u × ∂v) du dv. The integrand is a polynomial, which Gauss–Legendre
    /// quadrature integrates exactly to rounding up to degree 5, and almost exactly above. The volume is positive where
    /// the normals point outwards, negative where they point inwards. Where the normals of neighbours disagree, the
    /// first patch of each connected component decides. A cavity whose normals point into it is subtracted.
    ///
    /// Closed means that the [`topology`](Self::topology) has no open edge, and no edge that more than two patches
    /// share. The result is also `None` without patches, and for a one-sided surface such as the Klein bottle.
    pub fn volume(&self) -> Option<f64> {
        let patches: Vec<Patch> = self.patches().collect();
        let scaling = Scaling::around(box_of(&patches)?);
        let signs = self.orientation(&self.topology())?;
        let cones = map_patches(patches.len(), |k| {
            signs[k] * scaling.image(&patches[k]).cone()
        });
        let cones: f64 = cones.into_iter().sum();
        Some(cones / 3.0 * scaling.size * scaling.size * scaling.size)
    }

    /// For each patch 1 or −1, so that all normals of a component point to the same side as the normals of its first
    /// patch; `None` unless the surface is closed and orientable.
    pub(crate) fn orientation(&self, topology: &Topology) -> Option<Vec<f64>> {
        if !(topology.open.is_empty() && topology.non_manifold.is_empty()) {
            return None;
        }
        let mut neighbours = vec![Vec::new(); self.patch_count()];
        for pair in &topology.shared {
            let [a, b] = pair.as_slice() else { return None };
            let flip = if is_counter_clockwise(a) == is_counter_clockwise(b) {
                -1.0
            } else {
                1.0
            };
            neighbours[a.patch].push((b.patch, flip));
            neighbours[b.patch].push((a.patch, flip));
        }
        let mut signs = vec![0.0; neighbours.len()];
        for part in &topology.components {
            let mut open: Vec<usize> = part.first().copied().into_iter().collect();
            open.iter().for_each(|&first| signs[first] = 1.0);
            while let Some(patch) = open.pop() {
                for &(other, flip) in &neighbours[patch] {
                    let sign = signs[patch] * flip;
                    if signs[other] == 0.0 {
                        signs[other] = sign;
                        open.push(other);
                    } else if signs[other] != sign {
                        return None;
                    }
                }
            }
        }
        Some(signs)
    }
}

/// Whether the edge, in its shared direction, runs counter-clockwise around the patch as seen from its normal. Two
/// neighbours whose normals agree traverse a shared edge in opposite directions.
fn is_counter_clockwise(side: &EdgeUse) -> bool {
    let along = matches!(side.edge, PatchEdge::V0 | PatchEdge::U1);
    along != side.reversed
}
