//! Cuts the segments at their contacts: vertices, and the sub-segments between them.

use super::contacts::Contact;
use super::segments::Segments;
use super::union_find::UnionFind;
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use crate::numeric::sort::sort_by;
use glam::DVec2;

/// The part of a segment between two vertices, with no contact inside.
#[derive(Clone, Copy, Debug)]
pub(super) struct SubSegment {
    pub(super) segment: usize,
    pub(super) t: [f64; 2],
    pub(super) vertices: [usize; 2],
}

/// A point where sub-segments end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    pub(super) point: DVec2,
    /// The largest distance of the end of a sub-segment from the point.
    pub(super) spread: f64,
    /// The number of joints and cuts in it.
    pub(super) count: usize,
}

/// All segments, cut.
pub(super) struct SubSegments {
    pub(super) vertices: Vec<Vertex>,
    /// The vertex of each joint.
    pub(super) joints: Vec<usize>,
    pub(super) list: Vec<SubSegment>,
}

/// A contact on one segment.
#[derive(Clone, Copy)]
struct Cut {
    segment: usize,
    t: f64,
    node: usize,
}

impl SubSegments {
    /// Cuts the segments at all contacts with a gap of at most `tolerance`. Cuts closer together than this on a segment
    /// become one.
    pub(super) fn new(segments: &Segments, contacts: &[Contact], tolerance: f64) -> Self {
        let mut nodes = UnionFind::new(segments.joints.len());
        let mut points = segments.joints.clone();
        let cuts = cut_segments(segments, contacts, tolerance, &mut nodes, &mut points);
        let mut sub_segments = Vec::with_capacity(segments.list.len() + cuts.len());
        let mut rest = &cuts[..];
        for (index, segment) in segments.list.iter().enumerate() {
            let count = rest.iter().take_while(|cut| cut.segment == index).count();
            let (own, others) = rest.split_at(count);
            rest = others;
            let (mut t, mut node) = (0.0, segment.ends[0]);
            let mut push = |range: [f64; 2], ends: [usize; 2]| {
                sub_segments.push(SubSegment {
                    segment: index,
                    t: range,
                    vertices: ends,
                });
            };
            for cut in own {
                if cut.t > t {
                    push([t, cut.t], [node, cut.node]);
                }
                (t, node) = (cut.t, cut.node);
            }
            push([t, 1.0], [node, segment.ends[1]]);
        }
        Self::with_vertices(segments, sub_segments, nodes, &points, tolerance)
    }

    /// Numbers the vertices, and removes sub-segments that are not longer than the distance that counts as one point.
    fn with_vertices(
        segments: &Segments,
        mut sub_segments: Vec<SubSegment>,
        mut nodes: UnionFind,
        points: &[DVec2],
        tolerance: f64,
    ) -> Self {
        let mut vertices: Vec<Vertex> = Vec::new();
        let mut numbers = vec![usize::MAX; points.len()];
        for node in 0..points.len() {
            // The root is the smallest of its set: a joint, if there is one.
            let root = nodes.find(node);
            if root == node {
                numbers[node] = vertices.len();
                vertices.push(Vertex {
                    point: points[node],
                    spread: 0.0,
                    count: 1,
                });
            } else {
                numbers[node] = numbers[root];
                let vertex = &mut vertices[numbers[root]];
                vertex.spread = vertex.spread.max(Point::norm(points[node] - vertex.point));
                vertex.count += 1;
            }
        }
        sub_segments.retain_mut(|sub_segment| {
            sub_segment.vertices = sub_segment.vertices.map(|node| numbers[node]);
            let [from, to] = sub_segment.vertices;
            // From a vertex to itself: a whole closed segment, a loop, or the rest of a segment between cuts that are
            // one point.
            from != to || vertices[from].count == 1 || !is_short(segments, *sub_segment, tolerance)
        });
        numbers.truncate(segments.joints.len());
        Self {
            vertices,
            joints: numbers,
            list: sub_segments,
        }
    }
}

fn is_short(segments: &Segments, sub_segment: SubSegment, tolerance: f64) -> bool {
    let points = segments.part(sub_segment.segment, sub_segment.t[0], sub_segment.t[1]);
    let all = Bounds::from_points(&points);
    (all.max - all.min).max_element() <= 4.0 * tolerance
}

/// The cuts inside segments, sorted by segment and parameter; cuts at one point have one node.
fn cut_segments(
    segments: &Segments,
    contacts: &[Contact],
    tolerance: f64,
    nodes: &mut UnionFind,
    points: &mut Vec<DVec2>,
) -> Vec<Cut> {
    let mut cuts: Vec<Cut> = Vec::with_capacity(2 * contacts.len());
    for contact in contacts.iter().filter(|contact| contact.gap <= tolerance) {
        let point = contact_point(segments, contact);
        let [a, b] = contact.places.map(|(segment, t)| {
            let ends = segments.list[segment].ends;
            if t == 0.0 {
                ends[0]
            } else if t == 1.0 {
                ends[1]
            } else {
                let node = nodes.add();
                // An intersection is one point on both segments. An end beside a segment gives two points, and the
                // vertex their distance as its spread.
                points.push(if contact.gap == 0.0 {
                    point
                } else {
                    segments.list[segment].at(t)
                });
                cuts.push(Cut { segment, t, node });
                node
            }
        });
        nodes.join(a, b);
    }
    sort_by(&mut cuts, |a, b| {
        a.segment.cmp(&b.segment).then(a.t.total_cmp(&b.t))
    });
    join_close_cuts(segments, &cuts, tolerance, nodes, points);
    cuts
}

/// The point of a contact; where a segment is a horizontal or vertical line, exactly on it.
fn contact_point(segments: &Segments, contact: &Contact) -> DVec2 {
    let (segment, t) = contact.places[0];
    let mut point = segments.list[segment].at(t);
    for (segment, _) in contact.places {
        let Bounds { min, max } = segments.list[segment].bounds;
        point = DVec2::select(min.cmpeq(max), min, point);
    }
    point
}

/// Joins cuts that are closer together on their segment than the tolerance, and those next to an end with the end.
fn join_close_cuts(
    segments: &Segments,
    cuts: &[Cut],
    tolerance: f64,
    nodes: &mut UnionFind,
    points: &[DVec2],
) {
    for own in cuts.chunk_by(|a, b| a.segment == b.segment) {
        let segment = &segments.list[own[0].segment];
        let is_close = |(t, p): (f64, DVec2), (t_next, q): (f64, DVec2)| {
            // Both ends of a loop are near in the plane, but its middle is not.
            let middle = segment.at(0.5 * (t + t_next));
            Point::norm(p - q) <= tolerance && Point::norm(p - middle) <= tolerance
        };
        let (mut before, mut node) = ((0.0, segment.start()), segment.ends[0]);
        for cut in own {
            let here = (cut.t, points[cut.node]);
            // The first of some close cuts is compared with all others, so a chain of them does not grow beyond the
            // tolerance.
            if is_close(before, here) {
                nodes.join(node, cut.node);
            } else {
                (before, node) = (here, cut.node);
            }
        }
        let end = (1.0, segment.end());
        for cut in own.iter().rev() {
            if !is_close((cut.t, points[cut.node]), end) {
                break;
            }
            nodes.join(cut.node, segment.ends[1]);
        }
    }
}
