//! The order of the edges around each vertex.
//!
//! Edges leave a vertex in directions that may be equal, as at a tangency. They do not cross between vertices, so two
//! of them are in the same order at every distance from the vertex; they are compared where they are farthest apart.

use super::edges::Edges;
use super::sub_segments::{SubSegments, Vertex};
use crate::bernstein::evaluate::evaluate;
use crate::bernstein::roots::roots_inside;
use crate::curve::area::area_about;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::numeric::list::{Points, Scalars, points_of};
use crate::numeric::sort::sort_by;
use casteljau_kernels::numeric::zero::regula_falsi;
use glam::DVec2;

/// An edge's direction is taken where it is this many times farther from the vertex than edges end from each other.
const CLEAR_OF_SPREAD: f64 = 64.0;

/// The distance of the start of an edge from its vertex due to rounding; coordinates are up to 2.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The distance at which directions are taken is at least this part of the size of the edge.
const MIN_PROBE: f64 = 1e-6;

/// Directions closer than this are compared at several distances.
const SIMILAR_DIRECTIONS: f64 = 1e-3;

/// The end of the part of an edge that leads away from its start is searched in steps: the first 16 double the parameter
/// up to 1/16, the others add 1/16.
const MAX_STEPS: usize = 31;

/// The number of distances at which two edges are compared; each is half of the previous one.
const COMPARISONS: usize = 8;

/// The largest number of passes through the edges of a vertex that exchange neighbours.
const MAX_PASSES: usize = 64;

/// The half-edges around every vertex. Half-edge 2e runs along edge e, half-edge 2e + 1 against it.
pub(super) struct VertexStars {
    /// The half-edges that start at vertex v, counter-clockwise, are `half_edges[starts[v]..starts[v + 1]]`.
    pub(super) starts: Vec<usize>,
    pub(super) half_edges: Vec<usize>,
}

impl VertexStars {
    pub(super) fn new(sub_segments: &SubSegments, edges: &Edges) -> Self {
        let mut starts = vec![0; sub_segments.vertices.len() + 1];
        let origins = || (0..2 * edges.list.len()).map(|h| (h, origin(edges, h)));
        for (_, v) in origins() {
            starts[v + 1] += 1;
        }
        for v in 0..sub_segments.vertices.len() {
            starts[v + 1] += starts[v];
        }
        let mut half_edges = vec![0; 2 * edges.list.len()];
        let mut next = starts.clone();
        for (h, v) in origins() {
            half_edges[next[v]] = h;
            next[v] += 1;
        }
        for (v, ends) in starts.windows(2).enumerate() {
            let own = &mut half_edges[ends[0]..ends[1]];
            if own.len() > 2 {
                sort_around(&sub_segments.vertices[v], edges, own);
            }
        }
        Self { starts, half_edges }
    }
}

/// The vertex at which a half-edge starts.
pub(super) fn origin(edges: &Edges, h: usize) -> usize {
    edges.list[h / 2].vertices[h % 2]
}

/// The control points of a half-edge, from its start.
fn half_edge_points(edges: &Edges, h: usize) -> Points<DVec2> {
    let mut points = points_of(edges.points(h / 2));
    if h % 2 == 1 {
        points.reverse();
    }
    points
}

/// A half-edge as seen from the vertex at which it starts.
struct OutgoingHalfEdge {
    half_edge: usize,
    /// The control points relative to the vertex.
    points: Points<DVec2>,
    direction: DVec2,
    /// The error of the direction: the start of the edge is not exactly at the vertex, and the edge bends.
    error: f64,
    /// The distance from the vertex beyond which the start of an edge cannot be.
    clear: f64,
}

impl OutgoingHalfEdge {
    fn new(vertex: &Vertex, half_edge: usize, mut points: Points<DVec2>) -> Self {
        points.iter_mut().for_each(|p| *p -= vertex.point);
        let size = points.iter().fold(0.0, |m: f64, p| m.max(p.max_abs()));
        let spread = vertex.spread.max(ROUNDING);
        let clear = CLEAR_OF_SPREAD * spread;
        let far = clear.max(MIN_PROBE * size);
        let mut s = MIN_PROBE;
        // To the first of these points that is clear of the vertex; the directions to nearer ones are uncertain.
        while s < 0.5 && Point::norm(evaluate(&points, s)) < far {
            s *= 2.0;
        }
        let probe = evaluate(&points, s);
        let direction = Point::unit(probe);
        // Where the curvature of the edge is almost constant, the chord to s is off from the tangent at its start by
        // twice the angle between the chords to s and to s/2.
        let half_way = Point::unit(evaluate(&points, 0.5 * s));
        let uncertain = spread / Point::norm(probe).max(f64::MIN_POSITIVE);
        Self {
            half_edge,
            direction,
            error: uncertain + 2.0 * direction.perp_dot(half_way).abs(),
            clear,
            points,
        }
    }

    /// The largest distances from the vertex up to each step along the edge, as long as it leads away without turning
    /// far. Where its start can be, it has no direction yet.
    fn distances(&self) -> Vec<f64> {
        let mut reach = 0.0_f64;
        let step = |k| {
            let p = evaluate(&self.points, step_parameter(k));
            let distance = Point::norm(p);
            let turns_back = reach > self.clear && distance < reach;
            let turns_far = distance > self.clear && p.dot(self.direction) < 0.5 * distance;
            if turns_back || turns_far {
                return None;
            }
            reach = reach.max(distance);
            Some(reach)
        };
        (1..=MAX_STEPS).map_while(step).collect()
    }

    /// For an edge that ends where it starts, in a similar direction: positive if its end is counter-clockwise of its
    /// start. The sector between them is inside the loop if the loop leaves the vertex outside, and outside the loop if
    /// it runs around the vertex, and so crosses the ray in the opposite direction.
    fn loop_orientation(&self) -> f64 {
        let across: Scalars = self
            .points
            .iter()
            .map(|&p| self.direction.perp_dot(p))
            .collect();
        let is_behind = |&t: &f64| self.direction.dot(evaluate(&self.points, t)) < -self.clear;
        // Crossings of the ray that leads backwards from the vertex: their number is odd if the loop runs around the
        // vertex.
        let crossings = roots_inside(&across).into_iter().filter(is_behind).count();
        let area = area_about(&self.points, DVec2::ZERO);
        if crossings.is_multiple_of(2) {
            area
        } else {
            -area
        }
    }

    /// The first point of the edge at a distance from the vertex of at most the last of its distances.
    fn at_distance(&self, r: f64, distances: &[f64]) -> DVec2 {
        let k = distances.partition_point(|&distance| distance < r);
        let (from, nearer) = match k.checked_sub(1) {
            Some(last) => (step_parameter(k), distances[last]),
            None => (0.0, 0.0),
        };
        let Some(&farther) = distances.get(k) else {
            return evaluate(&self.points, from);
        };
        let missing = |t: f64| r - Point::norm(evaluate(&self.points, t));
        let t = regula_falsi(
            [from, step_parameter(k + 1)],
            [r - nearer, r - farther],
            f64::EPSILON,
            missing,
        );
        evaluate(&self.points, t)
    }
}

/// The parameter after k steps along an edge.
fn step_parameter(k: usize) -> f64 {
    match k.checked_sub(16) {
        Some(more) if more > 0 => ratio(more + 1, 16),
        _ => ratio(1 << k, 1 << 20),
    }
}

/// Sorts the half-edges that start at a vertex counter-clockwise.
fn sort_around(vertex: &Vertex, edges: &Edges, own: &mut [usize]) {
    let outgoing: Vec<OutgoingHalfEdge> = own
        .iter()
        .map(|&h| OutgoingHalfEdge::new(vertex, h, half_edge_points(edges, h)))
        .collect();
    let angles: Vec<f64> = outgoing.iter().map(|s| pseudo_angle(s.direction)).collect();
    let mut order: Vec<usize> = (0..outgoing.len()).collect();
    sort_by(&mut order, |&a, &b| angles[a].total_cmp(&angles[b]));
    start_after_largest_gap(&mut order, &angles);
    exchange_neighbours(&outgoing, &mut order);
    for (slot, &k) in own.iter_mut().zip(&order) {
        *slot = outgoing[k].half_edge;
    }
}

/// A number from −2 to 2 that increases with the angle of a unit vector.
fn pseudo_angle(d: DVec2) -> f64 {
    let from_axis = d.y / (d.x.abs() + d.y.abs());
    match (d.x >= 0.0, d.y >= 0.0) {
        (true, _) => from_axis,
        (false, true) => 2.0 - from_axis,
        (false, false) => -2.0 - from_axis,
    }
}

/// Rotates the order so that the largest angle without a half-edge is between the last and the first one. These two
/// are then not compared as neighbours, even if all half-edges have similar directions.
fn start_after_largest_gap(order: &mut [usize], angles: &[f64]) {
    // A whole turn of pseudo-angles is 4.
    let mut largest = (0, 4.0 + angles[order[0]] - angles[order[order.len() - 1]]);
    for k in 1..order.len() {
        let gap = angles[order[k]] - angles[order[k - 1]];
        if gap > largest.1 {
            largest = (k, gap);
        }
    }
    order.rotate_left(largest.0);
}

/// Exchanges neighbours with similar directions that are in the wrong order, until none is left.
fn exchange_neighbours(outgoing: &[OutgoingHalfEdge], order: &mut [usize]) {
    for _ in 0..MAX_PASSES {
        let mut changed = false;
        for k in 1..order.len() {
            let (a, b) = (&outgoing[order[k - 1]], &outgoing[order[k]]);
            let similar = a.direction.dot(b.direction) > 0.0
                && a.direction.perp_dot(b.direction).abs()
                    <= SIMILAR_DIRECTIONS + 2.0 * (a.error + b.error);
            // Both half-edges of one edge start here if it is a loop.
            let side = || match a.half_edge ^ 1 == b.half_edge {
                true => a.loop_orientation(),
                false => orientation(a, b),
            };
            if similar && side() < 0.0 {
                order.swap(k - 1, k);
                changed = true;
            }
        }
        if !changed {
            return;
        }
    }
}

/// The distance up to which an edge leads away from the vertex. In the last step it may have turned back.
fn reach(distances: &[f64]) -> Option<f64> {
    distances.get(distances.len().saturating_sub(2)).copied()
}

/// Positive if edge `b` is counter-clockwise of edge `a`, negative if it is clockwise: where they are farthest apart.
///
/// Edges start within the spread of the vertex, not at it; if one does not lead away from it, the starts are compared.
fn orientation(a: &OutgoingHalfEdge, b: &OutgoingHalfEdge) -> f64 {
    let distances = [a.distances(), b.distances()];
    let [Some(reach_a), Some(reach_b)] = distances.each_ref().map(|distances| reach(distances))
    else {
        return a.points[0].perp_dot(b.points[0]);
    };
    let mut largest = 0.0_f64;
    let mut r = reach_a.min(reach_b);
    for _ in 0..COMPARISONS {
        let points = [
            a.at_distance(r, &distances[0]),
            b.at_distance(r, &distances[1]),
        ];
        let side = points[0].perp_dot(points[1]) / r;
        if side.abs() > largest.abs() {
            largest = side;
        }
        r *= 0.5;
    }
    largest
}
