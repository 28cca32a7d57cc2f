//! Recursive subdivision until the pieces are flat enough, for teaching.

use crate::geometry::check::{check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::list::Net;
use crate::patch::Patch;
use crate::surface::network::Surface;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// The maximum number of leaves: for each patch of a surface, and in addition for any number of them.
const LEAVES_PER_PATCH: usize = 1 << 6;
const FURTHER_LEAVES: usize = 1 << 18;

/// The maximum number of control points of all pieces together, leaves and split pieces: for each control point of a
/// patch, and in addition for any number of them. Up to degree 5, 2¹⁸ leaves need fewer.
const STEPS_PER_POINT: usize = 2 * LEAVES_PER_PATCH;
const FURTHER_STEPS: usize = 1 << 24;

/// A piece of a patch that counts as flat.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct FlatPiece {
    /// The index of the patch.
    pub patch: usize,
    /// The start of the piece in u.
    pub u0: f64,
    /// The end of the piece in u.
    pub u1: f64,
    /// The start of the piece in v.
    pub v0: f64,
    /// The end of the piece in v.
    pub v1: f64,
    /// S(u0, v0), S(u1, v0), S(u1, v1), S(u0, v1). The triangles are 0 1 2 and 0 2 3.
    pub corners: [DVec3; 4],
}

impl FlatPiece {
    /// The two triangles that approximate the piece, counter-clockwise as seen from the side to which ∂u × ∂v points.
    pub fn triangles(&self) -> [[DVec3; 3]; 2] {
        let [a, b, c, d] = self.corners;
        [[a, b, c], [a, c, d]]
    }
}

impl Surface {
    /// Splits every patch into four pieces, and these again, until the control points of each piece are within
    /// `tolerance` of the plane of three of its corners: those with the largest triangle.
    ///
    /// If the corners lie on a line, the control points must be within `tolerance` of that line; if the corners
    /// coincide, of that point. This function is for teaching. Neighbours that are split differently do not fit
    /// together along their edge (cracks). The tolerance bounds the distance of the control points from a plane, not
    /// that of the surface from the two triangles, since the fourth corner and the outline may deviate.
    /// [`tessellate`](Self::tessellate) has no cracks and keeps its tolerance. The pieces are sorted by patch; the
    /// quarters of a split piece are in the order before u and v, after u, after v, after both. Source: Angel and
    /// Shreiner, *Interactive Computer Graphics*, 7th ed., §10.
    ///
    /// # Errors
    /// [`Error::Range`] unless the tolerance is above 0, [`Error::Tolerance`] when it is below 4 ulps of the largest
    /// coordinate, [`Error::TooMany`] above 2¹⁸ pieces and 64 for each patch, and when all pieces, including those that
    /// are split, have more than 2²⁴ control points together and 128 for each of the surface (above degree 5 this limit
    /// is reached first).
    pub fn subdivide(&self, tolerance: f64) -> Result<Vec<FlatPiece>, Error> {
        let size = self.control_bounds();
        check_tolerance(tolerance, size.map_or(0.0, |b| max_abs(&[b.min, b.max])))?;
        let max_leaves = LEAVES_PER_PATCH
            .saturating_mul(self.patch_count())
            .saturating_add(FURTHER_LEAVES);
        let mut pieces = FlatSplitter {
            patch: 0,
            tolerance,
            max_leaves,
            leaves: Vec::new(),
            work: WorkLimit::new(FURTHER_STEPS),
        };
        for (number, patch) in self.patches().enumerate() {
            pieces.patch = number;
            pieces.work.raise_limit(STEPS_PER_POINT, patch.points.len());
            if !pieces.split(&patch, [0.0, 1.0, 0.0, 1.0]) {
                break;
            }
        }
        let FlatSplitter { leaves, work, .. } = pieces;
        if leaves.len() > max_leaves {
            return Err(Error::too_many("leaves", max_leaves, leaves.len()));
        }
        Error::unless_within("control points of all pieces", &work)?;
        Ok(leaves)
    }
}

/// The leaves found so far.
struct FlatSplitter {
    /// The index of the patch that is being split.
    patch: usize,
    tolerance: f64,
    max_leaves: usize,
    leaves: Vec<FlatPiece>,
    work: WorkLimit,
}

impl FlatSplitter {
    /// Adds the leaves of one piece; returns `false` as soon as there are too many or the work limit is exceeded. The
    /// recursion depth is limited by the parameters: about 52 halvings, after which a piece is a point.
    fn split(&mut self, piece: &Patch, [u0, u1, v0, v1]: [f64; 4]) -> bool {
        if !self.work.spend(piece.points.len()) || self.leaves.len() > self.max_leaves {
            return false;
        }
        let (u, v) = (0.5 * (u0 + u1), 0.5 * (v0 + v1));
        let inside = u0 < u && u < u1 && v0 < v && v < v1;
        let corners = corners(&piece.points, piece.columns);
        if !inside || is_flat(&piece.points, corners, self.tolerance) {
            self.leaves.push(FlatPiece {
                patch: self.patch,
                u0,
                u1,
                v0,
                v1,
                corners,
            });
            return true;
        }
        let ranges = [
            [u0, u, v0, v],
            [u, u1, v0, v],
            [u0, u, v, v1],
            [u, u1, v, v1],
        ];
        let quarters = piece.split(0.5, 0.5);
        let mut quarters = quarters.iter().zip(ranges);
        quarters.all(|(quarter, range)| self.split(quarter, range))
    }
}

/// The corners of a net, in cyclic order.
fn corners(net: &[DVec3], columns: usize) -> [DVec3; 4] {
    let last = net.len() - columns;
    [0, columns - 1, net.len() - 1, last].map(|index| net[index])
}

/// Whether all points are within the tolerance of the plane of three corners (or of a line, or of a point).
fn is_flat(net: &[DVec3], corners: [DVec3; 4], tolerance: f64) -> bool {
    // The points are scaled to size 1, so that products neither overflow nor underflow.
    let origin = corners[0];
    let mut around: Net = net.iter().map(|&p| p - origin).collect();
    let scale = max_abs(&around);
    if scale == 0.0 {
        return true;
    }
    around.iter_mut().for_each(|p| *p /= scale);
    let corners = corners.map(|p| (p - origin) / scale);
    let max = tolerance / scale;
    let (mut plane, mut line) = ([DVec3::ZERO; 2], [DVec3::ZERO; 2]);
    for (k, &corner) in corners.iter().enumerate() {
        let [before, next] = [3, 1].map(|step| corners[(k + step) % 4] - corner);
        keep_longer(&mut plane, [corner, before.cross(next)]);
        keep_longer(&mut line, [DVec3::ZERO, corner]);
    }
    let [[amid, normal], [_, along]] = [plane, line].map(|[from, to]| [from, Point::unit(to)]);
    around.iter().all(|&p| {
        let off = if normal != DVec3::ZERO {
            (p - amid).dot(normal).abs()
        } else if along != DVec3::ZERO {
            Point::norm(p.cross(along))
        } else {
            Point::norm(p)
        };
        off <= max
    })
}

/// Keeps the longer vector together with its origin.
fn keep_longer(kept: &mut [DVec3; 2], index: [DVec3; 2]) {
    if Point::norm(index[1]) > Point::norm(kept[1]) {
        *kept = index;
    }
}
