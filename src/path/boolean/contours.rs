//! The boundaries of regions that consist of faces, as simple contours.

use super::arrangement::Arrangement;
use super::vertex_stars::origin;
use crate::curve::area::area_about;
use crate::geometry::point::Point;
use crate::numeric::sort::sort_by;

/// A contour of this width, in parts of epsilon, has the shape of rounding, and is left out unless nothing touches it.
const MAX_THIN_WIDTH: f64 = 0.02;

/// A simple closed contour, with its region on the left.
pub(super) struct Contour {
    pub(super) region: usize,
    pub(super) half_edges: Vec<usize>,
    pub(super) is_hole: bool,
    area: f64,
    /// The smallest index of a segment on it.
    first: usize,
}

/// The contours of all regions, sorted by region: each outer contour is followed by its holes. `regions` has a label for
/// each face that belongs to a region.
pub(super) fn contours(arrangement: &Arrangement, regions: &[Option<usize>]) -> Vec<Contour> {
    let tracer = BoundaryTracer {
        arrangement,
        regions,
    };
    let mut all = Vec::new();
    let mut visited = vec![false; arrangement.faces.left.len()];
    let mut slots = vec![None; arrangement.sub_segments.vertices.len()];
    for h in 0..visited.len() {
        if !visited[h] && tracer.is_boundary(h) {
            tracer.trace(h, &mut visited, &mut slots, &mut all);
        }
    }
    sorted(all, regions)
}

struct BoundaryTracer<'a> {
    arrangement: &'a Arrangement,
    regions: &'a [Option<usize>],
}

impl BoundaryTracer<'_> {
    fn region(&self, h: usize) -> Option<usize> {
        self.regions[self.arrangement.faces.left[h]]
    }

    fn is_boundary(&self, h: usize) -> bool {
        self.region(h).is_some() && self.region(h) != self.region(h ^ 1)
    }

    /// The next half-edge on the boundary of the same region: at its end, the first one clockwise.
    fn next(&self, h: usize) -> usize {
        let next = &self.arrangement.faces.next;
        let mut h = next[h];
        while self.region(h) == self.region(h ^ 1) {
            h = next[h ^ 1];
        }
        h
    }

    /// Follows the boundary of a region, and ends a contour wherever a vertex comes again.
    fn trace(
        &self,
        start: usize,
        visited: &mut [bool],
        slots: &mut [Option<usize>],
        all: &mut Vec<Contour>,
    ) {
        let mut chain: Vec<usize> = Vec::new();
        let mut h = start;
        while !visited[h] {
            visited[h] = true;
            let vertex = origin(&self.arrangement.edges, h);
            if let Some(first) = slots[vertex] {
                self.end_contour(chain.split_off(first), slots, all);
            }
            slots[vertex] = Some(chain.len());
            chain.push(h);
            h = self.next(h);
        }
        self.end_contour(chain, slots, all);
    }

    fn end_contour(
        &self,
        half_edges: Vec<usize>,
        slots: &mut [Option<usize>],
        all: &mut Vec<Contour>,
    ) {
        let Some(region) = self.region(half_edges[0]) else {
            return; // not the boundary of a region
        };
        let (edges, vertices) = (
            &self.arrangement.edges,
            &self.arrangement.sub_segments.vertices,
        );
        let (mut area, mut length, mut first) = (0.0, 0.0, usize::MAX);
        let mut is_untouched = true;
        let centre = edges.points(half_edges[0] / 2)[0];
        for &h in &half_edges {
            let (points, vertex) = (edges.points(h / 2), origin(edges, h));
            // A later contour may pass the vertex again.
            slots[vertex] = None;
            is_untouched &= vertices[vertex].count == 1;
            let swept = area_about(points, centre);
            area += if h % 2 == 0 { swept } else { -swept };
            length += points
                .windows(2)
                .map(|p| (p[1] - p[0]).max_abs())
                .sum::<f64>();
            first = first.min(edges.members(h / 2)[0].sub_segment.segment);
        }
        let is_thin = area.abs() <= MAX_THIN_WIDTH * self.arrangement.segments.epsilon * length;
        if is_untouched || !is_thin {
            all.push(Contour {
                region,
                half_edges,
                is_hole: area < 0.0,
                area,
                first,
            });
        }
    }
}

/// Sorts the contours: regions by the first segment of the outer contour, and within a region the holes last. A region
/// has one outer contour, its largest; others that run counter-clockwise are so thin that rounding decides the direction,
/// and are left out, as are the contours of a region without an outer one.
fn sorted(all: Vec<Contour>, regions: &[Option<usize>]) -> Vec<Contour> {
    let mut outer: Vec<Option<usize>> = vec![None; regions.len()];
    for (k, contour) in all
        .iter()
        .enumerate()
        .filter(|(_, contour)| !contour.is_hole)
    {
        let largest = &mut outer[contour.region];
        if largest.is_none_or(|other| all[other].area < contour.area) {
            *largest = Some(k);
        }
    }
    let mut order: Vec<usize> = (0..all.len())
        .filter(|&k| match outer[all[k].region] {
            Some(largest) => all[k].is_hole || k == largest,
            None => false,
        })
        .collect();
    let key = |k: usize| {
        let Contour {
            region,
            is_hole,
            first,
            ..
        } = all[k];
        let outer_first = outer[region].map(|k| all[k].first);
        (outer_first, region, is_hole, first)
    };
    sort_by(&mut order, |&a, &b| key(a).cmp(&key(b)));
    let mut slots: Vec<Option<Contour>> = all.into_iter().map(Some).collect();
    order.into_iter().filter_map(|k| slots[k].take()).collect()
}
