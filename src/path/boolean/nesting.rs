//! Which face contains a connected component: found by a ray from a point where the component extends farthest.

use super::edges::Edges;
use super::segments::Segments;
use crate::bernstein::evaluate::{evaluate, evaluate_scalar};
use crate::bernstein::roots::roots_inside;
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

/// The point of a component that is farthest in the direction of the ray.
#[derive(Clone, Copy)]
struct Extreme {
    point: DVec2,
    along: f64,
}

impl Extreme {
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
struct Place {
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
    places: Vec<Place>,
}

/// For each component, the half-edge that the ray from its extreme point meets first, on the side of the point.
pub(super) fn containing_half_edges(
    segments: &Segments,
    tree: &BoxTree,
    edges: &Edges,
    (component, count): (&[usize], usize),
    is_outer: impl Fn(usize) -> bool,
) -> Vec<Option<usize>> {
    if count < 2 {
        return vec![None; count];
    }
    let mut places = Vec::with_capacity(segments.list.len());
    for e in 0..edges.list.len() {
        places.extend(edges.members(e).iter().map(|member| Place {
            segment: member.arc.segment,
            from: member.arc.t[0],
            half_edge: 2 * e + usize::from(!member.forward),
        }));
    }
    sort_by(&mut places, |a, b| {
        a.segment.cmp(&b.segment).then(a.from.total_cmp(&b.from))
    });
    let rays = Rays {
        segments,
        tree,
        component,
        places,
    };
    let extremes = Extreme::of_components(edges, component, count);
    let first = |(own, extreme): (usize, &Extreme)| rays.first_hit(own, extreme.point, &is_outer);
    extremes.iter().enumerate().map(first).collect()
}

impl Rays<'_> {
    /// The first half-edge of another component that the ray from p meets. Of several at distances that are equal up to
    /// rounding it is one on the outside of its component, if there is one: p is not within a face that thin.
    fn first_hit(&self, own: usize, p: DVec2, is_outer: impl Fn(usize) -> bool) -> Option<usize> {
        let (mut nearest, mut hit) = (f64::INFINITY, None);
        self.tree.along_ray(p, RAY, |segment| {
            let points = &self.segments.list[segment].points;
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
            .places
            .partition_point(|place| (place.segment, place.from) <= (segment, t));
        let place = self.places.get(after.checked_sub(1)?)?;
        (place.segment == segment).then_some(place.half_edge)
    }
}
