//! The division of the plane by the segments of some paths: vertices, edges and faces.

use super::arcs::Arcs;
use super::contacts::{Contact, contacts};
use super::edges::Edges;
use super::faces::Faces;
use super::order::Order;
use super::segments::{Role, Segment, Segments};
use super::union_find::UnionFind;
use super::windings::{Windings, visit_faces};
use crate::geometry::bounds::Bounds;
use crate::geometry::box_tree::BoxTree;
use crate::geometry::error::Error;
use crate::path::Path;
use crate::path::winding::FillRule;
use glam::DVec2;

/// The parts of epsilon within which contacts count. Where one of them leads to winding numbers that contradict each
/// other, because features are of about this size, the next is tried.
const TOLERANCES: [f64; 5] = [0.2, 0.02, 0.1, 1e-3, 1e-5];

/// Edges, their order around vertices, and faces.
pub(super) struct Arrangement {
    pub(super) segments: Segments,
    pub(super) arcs: Arcs,
    pub(super) edges: Edges,
    pub(super) faces: Faces,
}

/// What depends on the tolerance.
struct Attempt {
    arcs: Arcs,
    edges: Edges,
    faces: Faces,
}

impl Arrangement {
    /// The division by the segments of the paths; if that contradicts itself with every tolerance, the one by polygons
    /// with corners on a grid.
    ///
    /// # Errors
    /// [`Error::TooMany`] as [`contacts`], [`Segments::new`] and [`Segments::on_grid`].
    pub(super) fn new(paths: &[(&Path, Role)]) -> Result<Self, Error> {
        let segments = Segments::new(paths)?;
        if let Some(attempt) = Attempt::consistent(&segments)? {
            return Ok(attempt.with(segments));
        }
        let polygons = segments.on_grid()?;
        let attempt = Attempt::of_arcs(&polygons, &tree_of(&polygons), Arcs::whole(&polygons), 0.0);
        if attempt.is_consistent(&polygons) {
            Ok(attempt.with(polygons))
        } else {
            let attempts = TOLERANCES.len() + 1;
            Err(Error::too_many(
                "attempts to divide the plane",
                attempts,
                attempts + 1,
            ))
        }
    }

    /// Calls `enter` for each face with its winding numbers.
    pub(super) fn visit_faces(&self, rule: FillRule, enter: impl FnMut(usize, &Windings)) {
        visit_faces(&self.segments, &self.edges, &self.faces, rule, enter);
    }

    /// A label for each face inside, equal where the faces on both sides of an edge are joined; `None` for others.
    pub(super) fn joined_faces(
        &self,
        inside: &[bool],
        is_joined: impl Fn(usize) -> bool,
    ) -> Vec<Option<usize>> {
        let mut sets = UnionFind::new(self.faces.count);
        for e in 0..self.edges.list.len() {
            let [a, b] = [2 * e, 2 * e + 1].map(|h| self.faces.left[h]);
            if inside[a] && inside[b] && is_joined(e) {
                sets.join(a, b);
            }
        }
        let label = |(face, &inside): (usize, &bool)| inside.then(|| sets.find(face));
        inside.iter().enumerate().map(label).collect()
    }
}

impl Attempt {
    /// The first attempt that does not contradict itself.
    fn consistent(segments: &Segments) -> Result<Option<Self>, Error> {
        let tree = tree_of(segments);
        let contacts = contacts(segments, &tree)?;
        Ok(TOLERANCES
            .iter()
            .map(|part| Self::new(segments, &tree, &contacts, part * segments.epsilon))
            .find(|attempt| attempt.is_consistent(segments)))
    }

    fn new(segments: &Segments, tree: &BoxTree, contacts: &[Contact], tolerance: f64) -> Self {
        let arcs = Arcs::new(segments, contacts, tolerance);
        Self::of_arcs(segments, tree, arcs, 2.0 * tolerance)
    }

    /// The faces between arcs; those within a distance of each other become one edge.
    fn of_arcs(segments: &Segments, tree: &BoxTree, arcs: Arcs, distance: f64) -> Self {
        let edges = Edges::new(segments, &arcs, distance);
        let order = Order::new(&arcs, &edges);
        let faces = Faces::new(segments, tree, &arcs, &edges, &order);
        Self { arcs, edges, faces }
    }

    fn is_consistent(&self, segments: &Segments) -> bool {
        let Self { edges, faces, .. } = self;
        faces.is_plane && visit_faces(segments, edges, faces, FillRule::NonZero, |_, _| ())
    }

    fn with(self, segments: Segments) -> Arrangement {
        let Self { arcs, edges, faces } = self;
        Arrangement {
            segments,
            arcs,
            edges,
            faces,
        }
    }
}

/// The tree of the boxes of the segments, enlarged by epsilon.
fn tree_of(segments: &Segments) -> BoxTree {
    let enlarged = |segment: &Segment| segment.bounds.enlarged(DVec2::splat(segments.epsilon));
    let boxes: Vec<Bounds<DVec2>> = segments.list.iter().map(enlarged).collect();
    BoxTree::new(&boxes)
}
