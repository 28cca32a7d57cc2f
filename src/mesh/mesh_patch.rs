//! What meshes need to know of a surface and its patches, which are polynomial or rational.
//!
//! Everything is generic over these traits and compiled for each kind of patch, so that polynomial surfaces neither take time nor
//! code for weights.

use crate::curve::flatten::Polyline;
use crate::geometry::error::Error;
use crate::patch::Patch;
use crate::surface::network::Surface;
use crate::surface::topology::SideUse;
use casteljau_kernels::mesh::second_differences::SecondDifferences;
use glam::DVec3;

/// A surface whose patches are of one kind.
pub(crate) trait PatchNetwork: Sync {
    type Patch: MeshPatch;
    /// What [`edge_point`](Self::edge_point) needs to know of an edge.
    type Edge;

    /// The vertices, indices and degrees.
    fn network(&self) -> &Surface;

    /// The patch with this index; `None` if there is no such patch.
    fn patch(&self, patch: usize) -> Option<Self::Patch>;

    /// The relation of each edge to all edges.
    fn side_uses(&self) -> Vec<SideUse>;

    /// Edge `number % 4` of patch `number / 4`.
    fn edge(&self, number: usize) -> Self::Edge;

    /// The point of an edge at t.
    fn edge_point(edge: &Self::Edge, t: f64) -> DVec3;

    /// All patches in order.
    fn patches(&self) -> impl Iterator<Item = Self::Patch> {
        (0..self.network().patch_count()).map_while(|patch| self.patch(patch))
    }
}

/// A patch that can be meshed.
pub(crate) trait MeshPatch: Send + Sync {
    type Bends: Bends;
    type Sampler: PatchSampler;
    type Isocurve: SpaceCurve;

    /// The control points, without weights.
    fn net(&self) -> &Patch;

    /// Replaces the stack by the second derivatives of the patch, and its control points if `has_position` is set.
    fn start(&self, has_position: bool, stack: &mut SecondDifferences) -> Frame;

    fn sampler(&self) -> Self::Sampler;

    /// The curve u = `at`, or v = `at`, from 0 to 1 in the other parameter.
    fn isocurve(&self, constant_u: bool, at: f64) -> Self::Isocurve;

    /// The unit normal at (u, v).
    fn normal(&self, u: f64, v: f64) -> DVec3;
}

/// An isocurve that can be drawn.
pub(crate) trait SpaceCurve {
    fn eval(&self, t: f64) -> DVec3;

    /// The unit tangent; zero for a curve that is a point.
    fn tangent(&self, t: f64) -> DVec3;

    fn flatten(&self, tolerance: f64) -> Result<Polyline<DVec3>, Error>;

    /// The control points, and weights of which the smallest is 1.
    fn weighted_points(&self) -> impl Iterator<Item = (DVec3, f64)>;
}

/// The coordinates of the vectors of [`SecondDifferences`]: (p − origin) / size.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Frame {
    pub(crate) origin: DVec3,
    pub(crate) size: f64,
}

/// Bounds on the second derivatives of a piece of a patch: along u, mixed, along v, per unit of the patch's parameters.
///
/// For a rational patch A/w they are those of A and w, such that they bound the distance of triangles in the same way.
pub(crate) trait Bends: Copy {
    /// The sum of the lengths' terms in [`distance`](Self::distance) is at most this times the distance.
    const MAX_EXCESS: f64;

    /// Whether the halves of a piece are cells without bounds of their own if those of the piece suffice. Otherwise the bounds for
    /// the halves may show that the piece needs no cut.
    const SUFFICE_FOR_HALVES: bool;

    /// The bounds for a whole patch, the only entry of the stack.
    fn of_patch(stack: &mut SecondDifferences, frame: &Frame) -> Self;

    /// The bounds for the two halves of the piece, which are on top of the stack.
    fn of_halves(&self, stack: &mut SecondDifferences, frame: &Frame) -> [Self; 2];

    /// The maximum distance of flat triangles over a piece with these sides, from the bounds for its halves, which are on top of
    /// the stack.
    fn joined_distance(halves: &[Self; 2], stack: &SecondDifferences, sides: [f64; 2]) -> f64;

    /// The bounds for the piece on top of the stack as lengths.
    fn lengths(&self, stack: &SecondDifferences) -> [f64; 3];

    /// Whether the weights of the piece on top of the stack ask for a cut along u, or along v, since the bounds follow from the
    /// smallest one.
    fn cut_by_weights(_stack: &SecondDifferences) -> Option<bool> {
        None
    }

    /// The maximum distance of flat triangles over the piece on top of the stack, if its sides in the patch's parameters are these.
    fn distance(&self, stack: &SecondDifferences, sides: [f64; 2]) -> f64;

    /// The bounding box of the control points of the piece, which is on top of the stack.
    fn control_box(&self, stack: &SecondDifferences) -> [[f32; 3]; 2];
}

/// A patch with precomputed data for repeated evaluation.
pub(crate) trait PatchSampler {
    /// Whether the patch has an area, and is not a curve or a point.
    fn has_area(&mut self) -> bool;

    /// The point and the unit normal at (u, v); the normal is a limit where the patch is not regular. Consecutive calls
    /// with the same v are cheaper.
    fn point_and_normal(&mut self, u: f64, v: f64) -> (DVec3, DVec3);
}
