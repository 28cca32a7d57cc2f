//! Edges: arcs that coincide, taken together.

use super::arcs::{Arc, Arcs};
use super::segments::Segments;
use crate::bernstein::evaluate::evaluate;
use crate::curve::nearest::nearest_on;
use crate::numeric::float::ratio;
use crate::numeric::list::Points;
use crate::numeric::sort::sort_by;
use glam::DVec2;

/// The number of parts of an arc at whose ends its distance from another arc is measured.
const SAMPLES: usize = 8;

/// An arc of an edge, and whether it runs in the direction of the edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    pub(super) arc: Arc,
    pub(super) forward: bool,
}

/// One or more arcs that coincide; its direction is that of the first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) vertices: [usize; 2],
    /// The range of its arcs in the list of members.
    members: [usize; 2],
    /// The range of the control points of its first arc.
    points: [usize; 2],
}

/// All edges.
pub(super) struct Edges {
    pub(super) list: Vec<Edge>,
    members: Vec<Member>,
    points: Vec<DVec2>,
}

impl Edges {
    /// Takes arcs between the same vertices together if no point is farther than `tolerance` from the other arc.
    pub(super) fn new(segments: &Segments, arcs: &Arcs, tolerance: f64) -> Self {
        let mut keyed: Vec<(usize, usize, usize)> = Vec::with_capacity(arcs.list.len());
        for (k, arc) in arcs.list.iter().enumerate() {
            let [from, to] = arc.vertices;
            keyed.push((from.min(to), from.max(to), k));
        }
        sort_by(&mut keyed, |a, b| a.cmp(b));
        let mut all = Self {
            list: Vec::with_capacity(keyed.len()),
            members: Vec::with_capacity(keyed.len()),
            points: Vec::with_capacity(4 * keyed.len()),
        };
        for group in keyed.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            all.add_group(segments, arcs, group, tolerance);
        }
        all
    }

    /// Adds the edges of the arcs between two vertices.
    fn add_group(
        &mut self,
        segments: &Segments,
        arcs: &Arcs,
        group: &[(usize, usize, usize)],
        tolerance: f64,
    ) {
        if let [(_, _, k)] = *group {
            let arc = arcs.list[k];
            let from = self.points.len();
            segments.push_part(arc.segment, arc.t[0], arc.t[1], &mut self.points);
            return self.add_edge(from, &[Member { arc, forward: true }]);
        }
        let mut edges: Vec<(Points<DVec2>, Vec<Member>)> = Vec::new();
        for &(_, _, k) in group {
            let arc = arcs.list[k];
            let points = segments.part(arc.segment, arc.t[0], arc.t[1]);
            let same = edges.iter().enumerate().find_map(|(e, (other, members))| {
                let is_loop = arc.vertices[0] == arc.vertices[1];
                let parallel = arc.vertices == members[0].arc.vertices;
                coincide(&points, other, parallel, is_loop, tolerance).map(|forward| (e, forward))
            });
            match same {
                Some((e, forward)) => edges[e].1.push(Member { arc, forward }),
                None => edges.push((points, vec![Member { arc, forward: true }])),
            }
        }
        for (points, members) in edges {
            let from = self.points.len();
            self.points.extend_from_slice(&points);
            self.add_edge(from, &members);
        }
    }

    /// Adds an edge whose control points are those from an index on.
    fn add_edge(&mut self, first_point: usize, members: &[Member]) {
        let from = self.members.len();
        self.members.extend(members);
        self.list.push(Edge {
            vertices: members[0].arc.vertices,
            members: [from, self.members.len()],
            points: [first_point, self.points.len()],
        });
    }

    /// The control points of the first arc of an edge.
    pub(super) fn points(&self, edge: usize) -> &[DVec2] {
        let [from, to] = self.list[edge].points;
        &self.points[from..to]
    }

    /// The arcs of an edge.
    pub(super) fn members(&self, edge: usize) -> &[Member] {
        let [from, to] = self.list[edge].members;
        &self.members[from..to]
    }
}

/// Whether two arcs with the same ends coincide, and if so, whether in the same direction.
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
        // The first two samples have nothing before them in the order of the arc.
        let in_order = k == 4 || k == 1 || (u >= before) == forward || u == before;
        in_order && nearest.distance <= tolerance
    })
}
