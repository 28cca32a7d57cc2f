//! Surfaces of rational patches: a network of vertices, and a weight for each index of a net.
//!
//! Weights belong to patches, so that a pole is one vertex with several weights, and a common factor of the weights of a patch
//! is free.

mod grid;
mod lines;
mod measure;
mod mesh;
mod nearest;
mod parameters;
mod solid;

use super::check_weights;
use super::patch::RationalPatch;
use super::surface::NurbsSurface;
use crate::geometry::bounds::Bounds;
use crate::geometry::error::Error;
use crate::numeric::float::ratio;
use crate::numeric::list::Scalars;
use crate::surface::hash_index::joined;
use crate::surface::network::Surface;
use crate::surface::topology::{EdgeUse, PatchEdge, SIDES, SideUse, Topology};
use casteljau_kernels::numeric::order::to_u32;
use glam::{DAffine3, DVec3};

/// The weights of two edges are in the same proportion if their quotients differ by at most this, relative to the first one:
/// 8 ulps for each of at most 64 degrees, since powers of factors have rounding errors in proportion to the degree.
const SAME_QUOTIENT: f64 = 512.0 * f64::EPSILON;

/// The width of a cell of [`proportion_keys`]: much more than [`SAME_QUOTIENT`] and rounding change it.
const KEY_CELL: f64 = 4096.0 * f64::EPSILON;

/// A network of rational Bézier patches: a [`Surface`] with a weight above 0 for each index of each net.
///
/// Weights belong to patches: patches that share a vertex may have different weights there, as at the pole of a sphere, and a
/// common factor of all weights of a patch changes nothing. [`NurbsSurface::to_surface`] makes one. Surfaces are immutable:
/// every change returns a new one.
///
/// ```
/// use casteljau::mesh::{TessellationOptions, Weld};
/// use casteljau::{NurbsSurface, glam::DVec3};
///
/// let sphere = NurbsSurface::sphere(DVec3::ZERO, 1.0, DVec3::Z)?.to_surface()?;
/// assert_eq!((sphere.patch_count(), sphere.topology().open.len()), (8, 0));
/// let mesh = sphere.tessellate(&TessellationOptions::tolerance(1e-3).weld(Weld::Position))?;
/// assert_eq!(mesh.triangle_count(), 2 * mesh.vertex_count() - 4); // closed
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct RationalSurface {
    network: Surface,
    /// A weight for each index.
    weights: Vec<f64>,
}

impl RationalSurface {
    /// A surface whose patches all have the same degrees; see [`Surface::new`]. `weights` has a weight for each index.
    ///
    /// # Errors
    /// As [`with_degrees`](Self::with_degrees).
    pub fn new(
        vertices: Vec<DVec3>,
        indices: Vec<u32>,
        weights: Vec<f64>,
        degree_u: usize,
        degree_v: usize,
    ) -> Result<Self, Error> {
        Self::weighted(
            Surface::new(vertices, indices, degree_u, degree_v)?,
            weights,
        )
    }

    /// A surface whose patches have the given degrees; see [`Surface::with_degrees`]. `weights` has a weight for each index.
    ///
    /// # Errors
    /// As [`Surface::with_degrees`]; [`Error::Count`] for another number of weights, [`Error::NotFinite`] and [`Error::Item`]
    /// for weights that [`RationalPatch::new`] refuses.
    pub fn with_degrees(
        vertices: Vec<DVec3>,
        indices: Vec<u32>,
        weights: Vec<f64>,
        degrees: &[[usize; 2]],
    ) -> Result<Self, Error> {
        Self::weighted(Surface::with_degrees(vertices, indices, degrees)?, weights)
    }

    /// A surface of patches, with one vertex for all control points that are equal, and one line for edges that are the same curve.
    ///
    /// Open edges with the same vertices are one curve with two parameters if the quotients of their weights are c·ρⁱ, as they always are
    /// for degree 1. The weights of the later patch are then multiplied by ρ⁻ⁱ along that direction, and so on for the patches beside
    /// it: its points stay the same, and t′/(1 − t′) = ρ t/(1 − t). So meshes have no cracks there.
    ///
    /// Where a closed chain of patches needs two factors, edges stay open; [`weight_mismatches`](Self::weight_mismatches) lists
    /// them. So do all edges of a connected part in which the largest weight of a patch would be more than 2²⁰ times its smallest
    /// one, and more than it was, or in which a weight would be beyond 2⁵⁰⁰ or below 2⁻⁵⁰⁰.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more control points than 2³² − 1.
    pub fn from_patches(patches: &[RationalPatch]) -> Result<Self, Error> {
        Ok(Self::of_patches(patches)?.with_common_parameters())
    }

    /// The patches with their weights, and with one vertex for all control points that are equal.
    fn of_patches(patches: &[RationalPatch]) -> Result<Self, Error> {
        let nets = patches.iter().map(RationalPatch::control_points);
        let points = nets.collect::<Vec<_>>().concat();
        let limit = u32::MAX as usize - 1;
        if points.len() > limit {
            return Err(Error::too_many("control points", limit, points.len()));
        }
        let mut number = vec![0; points.len()];
        let mut vertices = Vec::new();
        let indices = joined(&points).into_iter().zip(0..).map(|(first, index)| {
            if first == index {
                number[index as usize] = to_u32(vertices.len());
                vertices.push(points[index as usize]);
            }
            number[first as usize]
        });
        let indices = indices.collect();
        let degrees = patches.iter().map(|p| [p.degree_u(), p.degree_v()]);
        let weights = patches.iter().map(RationalPatch::weights);
        Self::with_degrees(
            vertices,
            indices,
            weights.collect::<Vec<_>>().concat(),
            &degrees.collect::<Vec<_>>(),
        )
    }

    pub(crate) fn weighted(network: Surface, weights: Vec<f64>) -> Result<Self, Error> {
        check_weights(&weights, network.indices().len())?;
        Ok(Self { network, weights })
    }

    /// All vertices.
    pub fn vertices(&self) -> &[DVec3] {
        self.network.vertices()
    }

    /// The vertex indices of all patches, one net after the other.
    pub fn indices(&self) -> &[u32] {
        self.network.indices()
    }

    /// The weight of each index.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The number of patches.
    pub fn patch_count(&self) -> usize {
        self.network.patch_count()
    }

    /// The degrees `[m, n]` of a patch; `None` if there is no such patch.
    pub fn degrees(&self, patch: usize) -> Option<[usize; 2]> {
        self.network.degrees(patch)
    }

    /// The vertex indices of a patch, u along the fast index; `None` if there is no such patch.
    pub fn patch_indices(&self, patch: usize) -> Option<&[u32]> {
        self.network.patch_indices(patch)
    }

    /// The weights of a patch, in the order of its indices; `None` if there is no such patch.
    pub fn patch_weights(&self, patch: usize) -> Option<&[f64]> {
        self.degrees(patch)?;
        self.weights.get(self.network.net_range(patch))
    }

    /// The patch with this index; `None` if there is no such patch.
    pub fn patch(&self, patch: usize) -> Option<RationalPatch> {
        let weights = self.patch_weights(patch)?.to_vec();
        Some(RationalPatch::from_valid(
            self.network.patch(patch)?,
            weights,
        ))
    }

    /// All patches in order.
    pub fn patches(&self) -> impl Iterator<Item = RationalPatch> {
        (0..self.patch_count()).map_while(|patch| self.patch(patch))
    }

    /// The point of a patch at (u, v), see [`RationalPatch::eval`].
    ///
    /// # Errors
    /// As [`Surface::eval`].
    pub fn eval(&self, patch: usize, u: f64, v: f64) -> Result<DVec3, Error> {
        self.network.check_patch(patch)?;
        let found = self.patch(patch);
        Ok(found.map_or(DVec3::NAN, |patch| patch.eval(u, v)))
    }

    /// The bounding box of all control points that patches use, which contains the surface; `None` without patches.
    pub fn control_bounds(&self) -> Option<Bounds<DVec3>> {
        self.network.control_bounds()
    }

    /// The image of the surface under an affine map, with the same weights.
    ///
    /// # Errors
    /// As [`Surface::transform`].
    pub fn transform(&self, map: &DAffine3) -> Result<Self, Error> {
        Ok(Self {
            network: self.network.transform(map)?,
            weights: self.weights.clone(),
        })
    }

    /// Moves one vertex, in place; see [`Surface::move_point`].
    ///
    /// # Errors
    /// As there.
    pub fn move_point(&mut self, index: usize, to: DVec3) -> Result<(), Error> {
        self.network.move_point(index, to)
    }

    /// How the patches are joined; see [`Surface::topology`].
    ///
    /// Two edges are the same line if their vertices agree, in the same order or reversed, and the quotients of their weights
    /// are equal to 512 ulps. Edges with the same vertices and other weights are different curves, or differ in their
    /// parameters, and are open; [`weight_mismatches`](Self::weight_mismatches) lists them. An edge whose control points are
    /// all equal is collapsed, whatever its weights.
    pub fn topology(&self) -> Topology {
        self.network.topology_of(&self.line_uses())
    }

    /// The groups of edges that have the same vertices, but weights that are not in proportion, so that they are not one line;
    /// empty where [`topology`](Self::topology) depends on no weights.
    ///
    /// Each group has the first edge of each line.
    pub fn weight_mismatches(&self) -> Vec<Vec<EdgeUse>> {
        let (lines, chains) = (self.line_uses(), self.network.side_uses());
        let mut groups: Vec<Vec<EdgeUse>> = vec![Vec::new(); chains.len()];
        for (number, (line, chain)) in lines.iter().zip(&chains).enumerate() {
            if line.first == number && !line.collapsed {
                groups[chain.first].push(EdgeUse {
                    patch: number / SIDES,
                    edge: PatchEdge::ALL[number % SIDES],
                    reversed: chain.reversed,
                });
            }
        }
        groups.retain(|group| group.len() > 1);
        groups
    }

    /// The relation of each edge to all edges.
    fn line_uses(&self) -> Vec<SideUse> {
        self.uses_of(&self.edge_weights())
    }

    /// The weights along each edge.
    fn edge_weights(&self) -> Vec<Scalars> {
        let edges = 0..SIDES * self.patch_count();
        edges
            .map(|edge| self.side_weights(edge).collect())
            .collect()
    }

    /// The relation of each edge to all edges if these are the weights along the edges.
    fn uses_of(&self, weights: &[Scalars]) -> Vec<SideUse> {
        let is_same = |a: usize, b: usize, reversed: bool| {
            let (a, b) = (&weights[a], &weights[b]);
            let last = a.len() - 1;
            let quotient = |i: usize| a[if reversed { last - i } else { i }] / b[i];
            (1..=last).all(|i| (quotient(i) - quotient(0)).abs() <= SAME_QUOTIENT * quotient(0))
        };
        self.network
            .side_uses_by(is_same, |edge| proportion_keys(&weights[edge]))
    }

    /// The weights along edge `number % 4` of patch `number / 4`.
    fn side_weights(&self, number: usize) -> impl DoubleEndedIterator<Item = f64> {
        let (from, to, step) = self.network.side_positions(number);
        let line = self.weights.get(from..to).unwrap_or_default();
        line.iter().step_by(step).copied()
    }
}

/// Two keys of the weights along an edge, of which weights in the same proportion have one in common, in either direction.
///
/// With the weights as masses at equal distances on a rod, the distance of their centroid from its middle plus their moment of
/// inertia is a number of moderate size that depends on the proportions only. The keys are the cell of this number and the
/// nearer of its neighbours.
fn proportion_keys(weights: &[f64]) -> [u64; 2] {
    let (mut mass, mut centroid, mut inertia) = (0.0, 0.0, 0.0);
    for (i, weight) in weights.iter().enumerate() {
        let x = ratio(i, weights.len() - 1) - 0.5;
        mass += weight;
        centroid += x * weight;
        inertia += x * x * weight;
    }
    let place = (centroid.abs() + inertia) / mass / KEY_CELL;
    let cell = place.floor();
    let neighbour = if place - cell < 0.5 {
        cell - 1.0
    } else {
        cell + 1.0
    };
    [cell, neighbour].map(f64::to_bits)
}

impl From<&Surface> for RationalSurface {
    /// The same surface with the weights 1.
    fn from(surface: &Surface) -> Self {
        Self {
            network: surface.clone(),
            weights: vec![1.0; surface.indices().len()],
        }
    }
}

impl From<&RationalPatch> for RationalSurface {
    /// A surface that consists of this patch only.
    fn from(patch: &RationalPatch) -> Self {
        Self {
            network: patch.net().as_surface(),
            weights: patch.weights().to_vec(),
        }
    }
}

impl NurbsSurface {
    /// The same surface as a network of its [`patches`](Self::patches), exactly.
    ///
    /// Adjacent patches share the vertices along their edge; so do a start and an end that are equal, as those of a full turn,
    /// and all edges at a pole share one vertex.
    ///
    /// # Errors
    /// As [`RationalSurface::from_patches`].
    pub fn to_surface(&self) -> Result<RationalSurface, Error> {
        RationalSurface::of_patches(self.patches())
    }
}
