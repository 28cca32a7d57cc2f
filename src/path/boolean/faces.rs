//! The faces between the edges: the cycles of half-edges around them, and which face contains a connected component. This
//! is found by a ray from a point where the component extends farthest.

use super::edges::Edges;
use super::segments::Segments;
use super::sub_segments::SubSegments;
use super::union_find::UnionFind;
use super::vertex_stars::VertexStars;
use crate::bernstein::evaluate::{evaluate, evaluate_scalar};
use crate::bernstein::roots::roots_inside;
use crate::curve::area::area_about;
use crate::curve::extrema::extrema_of;
use crate::geometry::box_tree::BoxTree;
use crate::numeric::list::Scalars;
use crate::numeric::sort::sort_by;
use glam::DVec2;

/// The direction in which extreme points are farthest and rays run. Both coordinates are not rational, so that a ray
/// does not run along lines of a drawing or through its corners: −cos 35°, −sin 35°.
const RAY: DVec2 = DVec2::new(-0.819_152_044_288_991_8, -0.573_576_436_351_046);

/// Distances along a ray that differ by at most this are equal up to rounding; coordinates are up to 2.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The faces of all edges.
pub(super) struct Faces {
    /// The half-edge that follows on the boundary of the face to the left.
    pub(super) next: Vec<usize>,
    /// The face to the left of each half-edge.
    pub(super) left: Vec<usize>,
    /// The number of faces.
    pub(super) count: usize,
    /// The face that is not bounded.
    pub(super) outside: usize,
    /// The connected component of each edge, and the number of components.
    pub(super) component: Vec<usize>,
    pub(super) component_count: usize,
    /// An edge of each component in which the order of the edges is not planar, by Euler's formula.
    pub(super) not_planar: Vec<usize>,
}

impl Faces {
    pub(super) fn new(
        segments: &Segments,
        tree: &BoxTree,
        sub_segments: &SubSegments,
        edges: &Edges,
        stars: &VertexStars,
    ) -> Self {
        let next = next_half_edges(edges, stars);
        let (cycle, cycle_count) = cycles(&next);
        let (component, component_count) = components(sub_segments, edges);
        let outer = outer_cycles(edges, &cycle, cycle_count, &component, component_count);
        let not_planar = not_planar(edges, stars, &cycle, &component, component_count);
        // One more number for the unbounded face, which joins the outer cycles that nothing contains.
        let mut sets = UnionFind::new(cycle_count + 1);
        let is_outer = |h: usize| outer[component[h / 2]] == cycle[h];
        let components = (&component[..], component_count);
        let hits = containing_half_edges(segments, tree, edges, components, is_outer);
        for (outer, hit) in outer.iter().zip(&hits) {
            let around = hit.map_or(cycle_count, |h| cycle[h]);
            sets.join(*outer, around);
        }
        let (numbers, count) = numbers_of_sets(sets, cycle_count + 1);
        Self {
            left: cycle.iter().map(|&c| numbers[c]).collect(),
            next,
            count,
            outside: numbers[cycle_count],
            component,
            component_count,
            not_planar,
        }
    }
}

/// The numbers of the sets in which numbers up to a limit are, and of the sets.
fn numbers_of_sets(mut sets: UnionFind, limit: usize) -> (Vec<usize>, usize) {
    let mut numbers = vec![usize::MAX; limit];
    let mut count = 0;
    for c in 0..limit {
        let root = sets.find(c);
        if numbers[root] == usize::MAX {
            numbers[root] = count;
            count += 1;
        }
        numbers[c] = numbers[root];
    }
    (numbers, count)
}

/// For each half-edge, the next one around the face to its left: at its end, the next clockwise of the way back.
fn next_half_edges(edges: &Edges, stars: &VertexStars) -> Vec<usize> {
    let mut next = vec![0; 2 * edges.list.len()];
    for ends in stars.starts.windows(2) {
        let around = &stars.half_edges[ends[0]..ends[1]];
        for (k, &h) in around.iter().enumerate() {
            let clockwise = around[(k + around.len() - 1) % around.len()];
            next[h ^ 1] = clockwise;
        }
    }
    next
}

/// The number of the cycle of each half-edge, and the number of cycles.
fn cycles(next: &[usize]) -> (Vec<usize>, usize) {
    let mut cycle = vec![usize::MAX; next.len()];
    let mut count = 0;
    for start in 0..next.len() {
        if cycle[start] != usize::MAX {
            continue;
        }
        let mut h = start;
        while cycle[h] == usize::MAX {
            cycle[h] = count;
            h = next[h];
        }
        count += 1;
    }
    (cycle, count)
}

/// The number of the connected component of each edge, and the number of components.
fn components(sub_segments: &SubSegments, edges: &Edges) -> (Vec<usize>, usize) {
    let mut sets = UnionFind::new(sub_segments.vertices.len());
    for edge in &edges.list {
        sets.join(edge.vertices[0], edge.vertices[1]);
    }
    let mut numbers = vec![usize::MAX; sub_segments.vertices.len()];
    let mut count = 0;
    let component = edges.list.iter().map(|edge| {
        let root = sets.find(edge.vertices[0]);
        if numbers[root] == usize::MAX {
            numbers[root] = count;
            count += 1;
        }
        numbers[root]
    });
    (component.collect(), count)
}

/// The cycle around the outside of each component: the one that runs clockwise and so has the smallest area.
fn outer_cycles(
    edges: &Edges,
    cycle: &[usize],
    cycle_count: usize,
    component: &[usize],
    component_count: usize,
) -> Vec<usize> {
    let mut centres = vec![None; component_count];
    let mut areas = vec![0.0; cycle_count];
    let mut component_of_cycle = vec![0; cycle_count];
    for (e, &c) in component.iter().enumerate() {
        let points = edges.points(e);
        // The area of a closed cycle is the same about any centre; about one that is near, rounding changes it least.
        let centre: DVec2 = *centres[c].get_or_insert(points[0]);
        let area = area_about(points, centre);
        for (h, area) in [(2 * e, area), (2 * e + 1, -area)] {
            areas[cycle[h]] += area;
            component_of_cycle[cycle[h]] = c;
        }
    }
    let mut outer = vec![usize::MAX; component_count];
    for k in 0..cycle_count {
        let best = &mut outer[component_of_cycle[k]];
        if *best == usize::MAX || areas[k] < areas[*best] {
            *best = k;
        }
    }
    outer
}

/// An edge of each component that does not satisfy Euler's formula V − E + F = 2, where F counts its cycles.
fn not_planar(
    edges: &Edges,
    stars: &VertexStars,
    cycle: &[usize],
    component: &[usize],
    component_count: usize,
) -> Vec<usize> {
    // E + 2 − V − F; each vertex is counted at its first half-edge, and each cycle too.
    let mut excess = vec![2_isize; component_count];
    component.iter().for_each(|&c| excess[c] += 1);
    let vertices = stars.starts.windows(2).filter(|ends| ends[0] < ends[1]);
    vertices.for_each(|ends| excess[component[stars.half_edges[ends[0]] / 2]] -= 1);
    let mut cycles = 0;
    for (h, &c) in cycle.iter().enumerate() {
        if c == cycles {
            excess[component[h / 2]] -= 1;
            cycles += 1;
        }
    }
    let contradicts = |e: &usize| std::mem::take(&mut excess[component[*e]]) != 0;
    (0..edges.list.len()).filter(contradicts).collect()
}

/// The point of a component that is farthest in the direction of the ray.
#[derive(Clone, Copy)]
struct ExtremePoint {
    point: DVec2,
    along: f64,
}

impl ExtremePoint {
    fn of_components(edges: &Edges, component: &[usize], count: usize) -> Vec<Self> {
        let start = Self {
            point: DVec2::ZERO,
            along: f64::NEG_INFINITY,
        };
        let mut extremes = vec![start; count];
        for (e, &c) in component.iter().enumerate() {
            extremes[c].include(edges.points(e));
        }
        extremes
    }

    fn include(&mut self, points: &[DVec2]) {
        let along: Scalars = points.iter().map(|p| RAY.dot(*p)).collect();
        // No point of the curve is farther than the farthest control point.
        if along.iter().all(|&x| x <= self.along) {
            return;
        }
        for t in extrema_of(&along).into_iter().chain([0.0, 1.0]) {
            let point = evaluate(points, t);
            if RAY.dot(point) > self.along {
                *self = Self {
                    point,
                    along: RAY.dot(point),
                };
            }
        }
    }
}

/// A part of a segment and its half-edge.
#[derive(Clone, Copy)]
struct HalfEdgeStart {
    segment: usize,
    from: f64,
    half_edge: usize,
}

/// Where a ray meets another component.
struct Rays<'a> {
    segments: &'a Segments,
    tree: &'a BoxTree,
    component: &'a [usize],
    /// Sorted by segment and parameter.
    starts: Vec<HalfEdgeStart>,
}

/// For each component, the half-edge that the ray from its extreme point meets first, on the side of the point.
fn containing_half_edges(
    segments: &Segments,
    tree: &BoxTree,
    edges: &Edges,
    (component, count): (&[usize], usize),
    is_outer: impl Fn(usize) -> bool,
) -> Vec<Option<usize>> {
    if count < 2 {
        return vec![None; count];
    }
    let mut starts = Vec::with_capacity(segments.list.len());
    for e in 0..edges.list.len() {
        starts.extend(edges.members(e).iter().map(|member| HalfEdgeStart {
            segment: member.sub_segment.segment,
            from: member.sub_segment.t[0],
            half_edge: 2 * e + usize::from(!member.forward),
        }));
    }
    sort_by(&mut starts, |a, b| {
        a.segment.cmp(&b.segment).then(a.from.total_cmp(&b.from))
    });
    let rays = Rays {
        segments,
        tree,
        component,
        starts,
    };
    let extremes = ExtremePoint::of_components(edges, component, count);
    let first =
        |(own, extreme): (usize, &ExtremePoint)| rays.first_hit(own, extreme.point, &is_outer);
    extremes.iter().enumerate().map(first).collect()
}

impl Rays<'_> {
    /// The first half-edge of another component that the ray from p meets. Of several at distances that are equal up to
    /// rounding it is one on the outside of its component, if there is one: p is not within a face that thin.
    fn first_hit(&self, own: usize, p: DVec2, is_outer: impl Fn(usize) -> bool) -> Option<usize> {
        let (mut nearest, mut hit) = (f64::INFINITY, None);
        self.tree.along_ray(p, RAY, |segment| {
            let points = &self.segments.list[segment].points;
            // The distance from the line of the ray; its zeros are where the segment meets this line.
            let across: Scalars = points.iter().map(|&q| RAY.perp_dot(q - p)).collect();
            for t in roots_inside(&across) {
                let distance = RAY.dot(evaluate(points, t) - p);
                if distance <= 0.0 || distance > nearest + ROUNDING {
                    continue;
                }
                let Some(half_edge) = self.half_edge_at(segment, t) else {
                    continue;
                };
                if self.component[half_edge / 2] != own {
                    let slopes: Scalars = across.windows(2).map(|a| a[1] - a[0]).collect();
                    // A segment that crosses the ray from its left to its right has the point on its right.
                    let turned = usize::from(evaluate_scalar(&slopes, t) < 0.0);
                    let half_edge = half_edge ^ turned;
                    let is_equal = distance >= nearest - ROUNDING;
                    let comes_first = match hit.map(|last| [last, half_edge].map(&is_outer)) {
                        Some([false, true]) if is_equal => true,
                        Some([true, false]) if is_equal => false,
                        _ => distance < nearest,
                    };
                    if comes_first {
                        hit = Some(half_edge);
                    }
                    nearest = nearest.min(distance);
                }
            }
            nearest + ROUNDING
        });
        hit
    }

    /// The half-edge along a segment at t.
    fn half_edge_at(&self, segment: usize, t: f64) -> Option<usize> {
        let after = self
            .starts
            .partition_point(|start| (start.segment, start.from) <= (segment, t));
        let start = self.starts.get(after.checked_sub(1)?)?;
        (start.segment == segment).then_some(start.half_edge)
    }
}
