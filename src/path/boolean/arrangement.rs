//! The division of the plane by the segments of some paths: vertices, edges and faces.

use super::contacts::{Contact, contacts};
use super::edges::Edges;
use super::faces::Faces;
use super::rescue::ReplacedSegments;
use super::segments::{Role, Segment, Segments};
use super::sub_segments::SubSegments;
use super::union_find::UnionFind;
use super::vertex_stars::VertexStars;
use super::windings::{Windings, visit_faces};
use crate::geometry::bounds::Bounds;
use crate::geometry::box_tree::BoxTree;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::path::Path;
use crate::path::winding::FillRule;
use glam::DVec2;

/// The parts of epsilon within which contacts count. Where one of them leads to winding numbers that contradict each
/// other, because features are of about this size, the next is tried.
const TOLERANCES: [f64; 5] = [0.2, 0.02, 0.1, 1e-3, 1e-5];

/// Edges up to this length, in parts of epsilon, are small features. If lines in the place of the segments next to them
/// contradict each other as well, the next one is tried.
const SMALL_FEATURES: [f64; 3] = [64.0, 4096.0, f64::INFINITY];

/// Different points that are one vertex are a small feature if they are farther apart than this part of epsilon: more than
/// rounding.
const MIN_SPREAD: f64 = 1.0 / 64.0;

/// Edges, their order around vertices, and faces.
pub(super) struct Arrangement {
    pub(super) segments: Segments,
    pub(super) sub_segments: SubSegments,
    pub(super) edges: Edges,
    pub(super) faces: Faces,
}

/// What depends on the tolerance.
struct Attempt {
    sub_segments: SubSegments,
    edges: Edges,
    faces: Faces,
}

impl Arrangement {
    /// The division by the segments of the paths. Where that contradicts itself with every tolerance, lines with corners
    /// on a grid replace the segments next to small features, and at last all segments.
    ///
    /// # Errors
    /// [`Error::TooMany`] as [`contacts`], [`Segments::new`] and [`Segments::on_grid`].
    pub(super) fn new(paths: &[(&Path, Role)]) -> Result<Self, Error> {
        let mut segments = Segments::new(paths)?;
        let mut sizes = SMALL_FEATURES.iter();
        let mut all_replaced = false;
        loop {
            let failed = match Attempt::consistent(&segments)? {
                Ok(attempt) => return Ok(attempt.into_arrangement(segments)),
                Err(failed) => failed,
            };
            if all_replaced {
                let attempts = TOLERANCES.len() * (SMALL_FEATURES.len() + 2);
                let what = "attempts to divide the plane";
                return Err(Error::too_many(what, attempts, attempts + 1));
            }
            let next = sizes.find_map(|size| failed.at_small_features(&segments, *size));
            all_replaced = next.is_none();
            segments =
                segments.on_grid(next.unwrap_or_else(|| ReplacedSegments::all(&segments)))?;
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
    /// The first attempt that does not contradict itself, or as an error the first one.
    fn consistent(segments: &Segments) -> Result<Result<Self, Self>, Error> {
        let tree = tree_of(segments);
        let contacts = contacts(segments, &tree)?;
        let attempt = |part: &f64| Self::new(segments, &tree, &contacts, part * segments.epsilon);
        let is_consistent = |attempt: &Self| attempt.contradictory(segments).is_empty();
        let first = attempt(&TOLERANCES[0]);
        if is_consistent(&first) {
            return Ok(Ok(first));
        }
        let consistent = TOLERANCES[1..].iter().map(attempt).find(is_consistent);
        Ok(consistent.ok_or(first))
    }

    /// The faces between the sub-segments; those within twice the tolerance of each other become one edge.
    fn new(segments: &Segments, tree: &BoxTree, contacts: &[Contact], tolerance: f64) -> Self {
        let sub_segments = SubSegments::new(segments, contacts, tolerance);
        let edges = Edges::new(segments, &sub_segments, 2.0 * tolerance);
        let stars = VertexStars::new(&sub_segments, &edges);
        let faces = Faces::new(segments, tree, &sub_segments, &edges, &stars);
        Self {
            sub_segments,
            edges,
            faces,
        }
    }

    /// At least one edge of each component that contradicts itself: every edge at which winding numbers do, or one edge of
    /// each component that is not planar.
    fn contradictory(&self, segments: &Segments) -> Vec<usize> {
        let Self { edges, faces, .. } = self;
        if !faces.not_planar.is_empty() {
            return faces.not_planar.clone();
        }
        visit_faces(segments, edges, faces, FillRule::NonZero, |_, _| ())
    }

    /// The segments at vertices with features of at most a size, in components that contradict themselves: at both ends
    /// of an edge that is not longer, and where different points are one vertex. `None` if there are none.
    fn at_small_features(&self, segments: &Segments, size: f64) -> Option<ReplacedSegments> {
        let Self {
            sub_segments,
            edges,
            faces,
        } = self;
        let mut is_contradictory = vec![false; faces.component_count];
        for e in self.contradictory(segments) {
            is_contradictory[faces.component[e]] = true;
        }
        let mut is_small = vec![false; sub_segments.vertices.len()];
        for (e, edge) in edges.list.iter().enumerate() {
            if is_contradictory[faces.component[e]] {
                let is_short = length(edges.points(e)) <= size * segments.epsilon;
                for v in edge.vertices {
                    is_small[v] |=
                        is_short || sub_segments.vertices[v].spread > MIN_SPREAD * segments.epsilon;
                }
            }
        }
        let mut replaced = ReplacedSegments {
            segments: vec![false; segments.list.len()],
            joints: sub_segments
                .joints
                .iter()
                .map(|&vertex| is_small[vertex])
                .collect(),
        };
        for (e, edge) in edges.list.iter().enumerate() {
            if edge.vertices.iter().any(|&v| is_small[v]) {
                for member in edges.members(e) {
                    replaced.segments[member.sub_segment.segment] = true;
                }
            }
        }
        // Segments that are so short that no sub-segment of them is left.
        for (segment, is_replaced) in segments.list.iter().zip(&mut replaced.segments) {
            *is_replaced |= segment.ends.iter().any(|&joint| replaced.joints[joint]);
        }
        replaced.segments.contains(&true).then_some(replaced)
    }

    fn into_arrangement(self, segments: Segments) -> Arrangement {
        let Self {
            sub_segments,
            edges,
            faces,
        } = self;
        Arrangement {
            segments,
            sub_segments,
            edges,
            faces,
        }
    }
}

/// The length of a control polygon.
fn length(points: &[DVec2]) -> f64 {
    let steps = points.windows(2).map(|p| Point::norm(p[1] - p[0]));
    steps.sum()
}

/// The tree of the boxes of the segments, enlarged by epsilon.
fn tree_of(segments: &Segments) -> BoxTree {
    let enlarged = |segment: &Segment| segment.bounds.enlarged(DVec2::splat(segments.epsilon));
    let boxes: Vec<Bounds<DVec2>> = segments.list.iter().map(enlarged).collect();
    BoxTree::new(&boxes)
}
