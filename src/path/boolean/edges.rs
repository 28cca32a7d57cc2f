//! Edges: sub-segments that coincide, taken together.

use super::segments::Segments;
use super::sub_segments::{SubSegment, SubSegments};
use crate::bernstein::evaluate::evaluate;
use crate::curve::nearest::nearest_on;
use crate::numeric::float::ratio;
use crate::numeric::list::Points;
use crate::numeric::sort::sort_by;
use glam::DVec2;

/// The number of parts of a sub-segment at whose ends its distance from another one is measured.
const SAMPLES: usize = 8;

/// A sub-segment of an edge, and whether it runs in the direction of the edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct MergedSubSegment {
    pub(super) sub_segment: SubSegment,
    pub(super) forward: bool,
}

/// One or more sub-segments that coincide; its direction is that of the first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) vertices: [usize; 2],
    /// The range of its sub-segments in the list of members.
    members: [usize; 2],
    /// The range of the control points of its first sub-segment.
    points: [usize; 2],
}

/// All edges.
pub(super) struct Edges {
    pub(super) list: Vec<Edge>,
    members: Vec<MergedSubSegment>,
    points: Vec<DVec2>,
}

impl Edges {
    /// Takes sub-segments between the same vertices together if no point is farther than `tolerance` from the other one.
    pub(super) fn new(segments: &Segments, sub_segments: &SubSegments, tolerance: f64) -> Self {
        let mut keyed: Vec<(usize, usize, usize)> = Vec::with_capacity(sub_segments.list.len());
        for (k, sub_segment) in sub_segments.list.iter().enumerate() {
            let [from, to] = sub_segment.vertices;
            keyed.push((from.min(to), from.max(to), k));
        }
        sort_by(&mut keyed, |a, b| a.cmp(b));
        let mut all = Self {
            list: Vec::with_capacity(keyed.len()),
            members: Vec::with_capacity(keyed.len()),
            points: Vec::with_capacity(4 * keyed.len()),
        };
        for group in keyed.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            all.add_group(segments, sub_segments, group, tolerance);
        }
        all
    }

    /// Adds the edges of the sub-segments between two vertices.
    fn add_group(
        &mut self,
        segments: &Segments,
        sub_segments: &SubSegments,
        group: &[(usize, usize, usize)],
        tolerance: f64,
    ) {
        if let [(_, _, k)] = *group {
            let sub_segment = sub_segments.list[k];
            let from = self.points.len();
            segments.push_part(
                sub_segment.segment,
                sub_segment.t[0],
                sub_segment.t[1],
                &mut self.points,
            );
            return self.add_edge(
                from,
                &[MergedSubSegment {
                    sub_segment,
                    forward: true,
                }],
            );
        }
        let mut edges: Vec<(Points<DVec2>, Vec<MergedSubSegment>)> = Vec::new();
        for &(_, _, k) in group {
            let sub_segment = sub_segments.list[k];
            let points = segments.part(sub_segment.segment, sub_segment.t[0], sub_segment.t[1]);
            let same = edges.iter().enumerate().find_map(|(e, (other, members))| {
                let is_loop = sub_segment.vertices[0] == sub_segment.vertices[1];
                let parallel = sub_segment.vertices == members[0].sub_segment.vertices;
                coincide(&points, other, parallel, is_loop, tolerance).map(|forward| (e, forward))
            });
            match same {
                Some((e, forward)) => edges[e].1.push(MergedSubSegment {
                    sub_segment,
                    forward,
                }),
                None => edges.push((
                    points,
                    vec![MergedSubSegment {
                        sub_segment,
                        forward: true,
                    }],
                )),
            }
        }
        for (points, members) in edges {
            let from = self.points.len();
            self.points.extend_from_slice(&points);
            self.add_edge(from, &members);
        }
    }

    /// Adds an edge whose control points are those from an index on.
    fn add_edge(&mut self, first_point: usize, members: &[MergedSubSegment]) {
        let from = self.members.len();
        self.members.extend(members);
        self.list.push(Edge {
            vertices: members[0].sub_segment.vertices,
            members: [from, self.members.len()],
            points: [first_point, self.points.len()],
        });
    }

    /// The control points of the first sub-segment of an edge.
    pub(super) fn points(&self, edge: usize) -> &[DVec2] {
        let [from, to] = self.list[edge].points;
        &self.points[from..to]
    }

    /// The sub-segments of an edge.
    pub(super) fn members(&self, edge: usize) -> &[MergedSubSegment] {
        let [from, to] = self.list[edge].members;
        &self.members[from..to]
    }
}

/// Whether two sub-segments with the same ends coincide, and if so, whether in the same direction.
fn coincide(
    a: &[DVec2],
    b: &[DVec2],
    parallel: bool,
    is_loop: bool,
    tolerance: f64,
) -> Option<bool> {
    if is_loop {
        return [true, false]
            .into_iter()
            .find(|&forward| is_near(a, b, forward, tolerance));
    }
    // Lines between the same two vertices.
    if a.len() == 2 && b.len() == 2 {
        return Some(parallel);
    }
    (is_near(a, b, parallel, tolerance) && is_near(b, a, parallel, tolerance)).then_some(parallel)
}

/// Whether samples of `a` are within the tolerance of `b`, in the same order on both.
fn is_near(a: &[DVec2], b: &[DVec2], forward: bool, tolerance: f64) -> bool {
    let mut last = if forward { 0.0 } else { 1.0 };
    [4, 1, 2, 3, 5, 6, 7].iter().all(|&k| {
        let s = ratio(k, SAMPLES);
        let nearest = nearest_on(b, evaluate(a, s));
        let (u, before) = (nearest.t, std::mem::replace(&mut last, nearest.t));
        // The first two samples have nothing before them in the order of the sub-segment.
        let in_order = k == 4 || k == 1 || (u >= before) == forward || u == before;
        in_order && nearest.distance <= tolerance
    })
}
