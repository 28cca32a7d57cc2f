//! The faces between the edges.

use super::arcs::Arcs;
use super::edges::Edges;
use super::nesting::containing_half_edges;
use super::order::Order;
use super::segments::Segments;
use super::union_find::UnionFind;
use crate::curve::area::area_about;
use crate::geometry::box_tree::BoxTree;
use glam::DVec2;

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
    /// Whether the order of the edges is that of a plane figure, by Euler's formula.
    pub(super) is_plane: bool,
}

impl Faces {
    pub(super) fn new(
        segments: &Segments,
        tree: &BoxTree,
        arcs: &Arcs,
        edges: &Edges,
        order: &Order,
    ) -> Self {
        let next = next_half_edges(edges, order);
        let (cycle, cycle_count) = cycles(&next);
        let (component, component_count) = components(arcs, edges);
        let outer = outer_cycles(edges, &cycle, cycle_count, &component, component_count);
        let is_plane = is_plane(edges, order, cycle_count, component_count);
        // One more number for the unbounded face, which joins the outer cycles that nothing contains.
        let mut sets = UnionFind::new(cycle_count + 1);
        let is_outer = |h: usize| outer[component[h / 2]] == cycle[h];
        let components = (&component[..], component_count);
        let hits = containing_half_edges(segments, tree, edges, components, is_outer);
        for (outer, hit) in outer.iter().zip(&hits) {
            let around = hit.map_or(cycle_count, |h| cycle[h]);
            sets.join(*outer, around);
        }
        Self::numbered(next, &cycle, sets, cycle_count, is_plane)
    }

    fn numbered(
        next: Vec<usize>,
        cycle: &[usize],
        mut sets: UnionFind,
        cycle_count: usize,
        is_plane: bool,
    ) -> Self {
        let mut numbers = vec![usize::MAX; cycle_count + 1];
        let mut count = 0;
        for c in 0..=cycle_count {
            let root = sets.find(c);
            if numbers[root] == usize::MAX {
                numbers[root] = count;
                count += 1;
            }
            numbers[c] = numbers[root];
        }
        Self {
            left: cycle.iter().map(|&c| numbers[c]).collect(),
            next,
            count,
            outside: numbers[cycle_count],
            is_plane,
        }
    }
}

/// For each half-edge, the next one around the face to its left: at its end, the next clockwise of the way back.
fn next_half_edges(edges: &Edges, order: &Order) -> Vec<usize> {
    let mut next = vec![0; 2 * edges.list.len()];
    for ends in order.starts.windows(2) {
        let around = &order.around[ends[0]..ends[1]];
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
fn components(arcs: &Arcs, edges: &Edges) -> (Vec<usize>, usize) {
    let mut sets = UnionFind::new(arcs.vertices.len());
    for edge in &edges.list {
        sets.join(edge.vertices[0], edge.vertices[1]);
    }
    let mut numbers = vec![usize::MAX; arcs.vertices.len()];
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
        let centre: DVec2 = *centres[c].get_or_insert(points[0]);
        let area = area_about(points, centre, 1.0);
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

/// Euler's formula for all components: V − E + F = 2 for each, where F counts its cycles.
fn is_plane(edges: &Edges, order: &Order, cycle_count: usize, component_count: usize) -> bool {
    let vertices = order.starts.windows(2).filter(|ends| ends[0] < ends[1]);
    vertices.count() + cycle_count == edges.list.len() + 2 * component_count
}
