//! Contours as paths: sub-segments of one segment are joined again, and what is whole keeps its bits. Where sub-segments
//! coincide, a result follows the same outline as long as it can.

use super::arrangement::Arrangement;
use super::contours::Contour;
use super::edges::MergedSubSegment;
use super::sub_segments::SubSegment;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use crate::path::Path;
use glam::DVec2;

/// A part of a segment, in the direction of its outline: from t₀ to t₁, where t₀ > t₁ means backwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct OutlinePiece {
    pub(super) segment: usize,
    pub(super) t: [f64; 2],
    /// The vertices at its start and at its end.
    vertices: [usize; 2],
}

impl OutlinePiece {
    /// A sub-segment of an edge, along the edge or against it.
    pub(super) fn new(member: &MergedSubSegment, forward: bool) -> Self {
        let mut piece = Self::along(&member.sub_segment);
        if member.forward != forward {
            piece.t.reverse();
            piece.vertices.reverse();
        }
        piece
    }

    /// A whole sub-segment, in its direction.
    pub(super) fn along(sub_segment: &SubSegment) -> Self {
        Self {
            segment: sub_segment.segment,
            t: sub_segment.t,
            vertices: sub_segment.vertices,
        }
    }

    pub(super) fn is_forward(&self) -> bool {
        self.t[0] < self.t[1]
    }

    /// Whether the next piece goes on along the same segment.
    fn continues_segment(&self, next: &Self) -> bool {
        self.segment == next.segment
            && self.t[1] == next.t[0]
            && self.is_forward() == next.is_forward()
    }

    /// Whether the next piece goes on along the same subpath of the input.
    pub(super) fn continues_subpath(&self, arrangement: &Arrangement, next: &Self) -> bool {
        let end = joint(arrangement, self.segment, self.t[1]);
        let start = joint(arrangement, next.segment, next.t[0]);
        let is_next = end.is_some() && end == start && self.is_forward() == next.is_forward();
        is_next || self.continues_segment(next)
    }

    /// Joins consecutive pieces of one segment; in a closed outline also the last with the first.
    pub(super) fn joined(pieces: Vec<Self>, closed: bool) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::with_capacity(pieces.len());
        for piece in pieces {
            match all.last_mut().filter(|last| last.continues_segment(&piece)) {
                Some(last) => {
                    last.t[1] = piece.t[1];
                    last.vertices[1] = piece.vertices[1];
                }
                None => all.push(piece),
            }
        }
        if let [first, .., last] = all[..]
            && closed
            && last.continues_segment(&first)
        {
            all.pop();
            all[0] = Self {
                t: [last.t[0], first.t[1]],
                vertices: [last.vertices[0], first.vertices[1]],
                ..last
            };
        }
        all
    }
}

/// The joint at t of a segment, if there is one.
fn joint(arrangement: &Arrangement, segment: usize, t: f64) -> Option<usize> {
    let ends = arrangement.segments.list[segment].ends;
    if t == 0.0 {
        Some(ends[0])
    } else if t == 1.0 {
        Some(ends[1])
    } else {
        None
    }
}

/// Appends the contours, sorted by region. A contour that runs the wrong way, because it is thinner than the distances
/// that count as one point, is left out, and so are the holes in it.
pub(super) fn push_contours(arrangement: &Arrangement, contours: &[Contour], path: &mut Path) {
    let mut left_out = None;
    for contour in contours {
        if contour.is_hole && left_out == Some(contour.region) {
            continue;
        }
        let pieces = OutlinePiece::joined(chosen_pieces(arrangement, &contour.half_edges), true);
        let mut single = Path::default();
        push_subpath(
            arrangement,
            &rotated_to_start(arrangement, pieces),
            true,
            &mut single,
        );
        let area = single.area();
        if area != 0.0 && (area < 0.0) == contour.is_hole {
            let part = single.part(0);
            let count = part.points.len() - 1;
            path.push(&part.points[..count], part.degrees(), true);
        } else if !contour.is_hole {
            left_out = Some(contour.region);
        }
    }
}

/// The pieces of a closed outline from the start of a subpath of the input if it has one, otherwise from the start of
/// the piece with the smallest index.
fn rotated_to_start(arrangement: &Arrangement, mut pieces: Vec<OutlinePiece>) -> Vec<OutlinePiece> {
    let is_first = |piece: &OutlinePiece| arrangement.segments.list[piece.segment].is_first;
    let starts = (0..pieces.len()).filter_map(|k| {
        let before = &pieces[(k + pieces.len() - 1) % pieces.len()];
        let here = &pieces[k];
        if here.t[0] == 0.0 && is_first(here) {
            Some((here.segment, k))
        } else if before.t[1] == 0.0 && is_first(before) {
            Some((before.segment, k))
        } else {
            None
        }
    });
    let any = (0..pieces.len()).map(|k| (pieces[k].segment, k));
    if let Some((_, k)) = starts.min().or_else(|| any.min()) {
        pieces.rotate_left(k);
    }
    pieces
}

/// Appends a subpath of pieces.
pub(super) fn push_subpath(
    arrangement: &Arrangement,
    pieces: &[OutlinePiece],
    closed: bool,
    path: &mut Path,
) {
    let segments = &arrangement.segments;
    let mut points: Vec<DVec2> = Vec::new();
    let mut degrees: Vec<usize> = Vec::new();
    let last = pieces.len() - 1;
    for (k, piece) in pieces.iter().enumerate() {
        let mut part = segments.part(piece.segment, piece.t[0], piece.t[1]);
        let before = (closed || k > 0).then(|| &pieces[if k > 0 { k - 1 } else { last }]);
        let after = (closed || k < last).then(|| &pieces[if k < last { k + 1 } else { 0 }]);
        // Both pieces at a junction get its point, so the outline has no gaps.
        move_start(&mut part, junction(arrangement, before, Some(piece)));
        part.reverse();
        move_start(&mut part, junction(arrangement, Some(piece), after));
        part.reverse();
        if part.iter().all(|&p| p == part[0]) {
            continue;
        }
        if points.is_empty() {
            points.push(part[0]);
        }
        points.extend(&part[1..]);
        degrees.push(part.len() - 1);
    }
    if degrees.is_empty() {
        return;
    }
    if closed {
        points.pop();
    }
    points.iter_mut().for_each(|p| *p /= segments.unit);
    path.push(&points, degrees, closed);
}

/// The point where one or two consecutive pieces of an outline end: a joint of the input where there is one.
fn junction(
    arrangement: &Arrangement,
    before: Option<&OutlinePiece>,
    after: Option<&OutlinePiece>,
) -> DVec2 {
    let end = before.map(|piece| (piece.segment, piece.t[1], piece.vertices[1]));
    let start = after.map(|piece| (piece.segment, piece.t[0], piece.vertices[0]));
    let ends = || [end, start].into_iter().flatten();
    let joints = ends().filter_map(|(segment, t, _)| joint(arrangement, segment, t));
    let vertex = ends().map(|(_, _, vertex)| vertex).min().unwrap_or(0);
    match joints.min() {
        Some(joint) => arrangement.segments.joints[joint],
        None => arrangement.sub_segments.vertices[vertex].point,
    }
}

/// Moves the start of a curve, and the handle next to it by as much.
fn move_start(points: &mut Points<DVec2>, to: DVec2) {
    let by = to - points[0];
    if points.len() > 3 && by.max_abs() > 0.0 {
        points[1] += by;
    }
    points[0] = to;
}

/// How many edges ahead the choice looks.
const LOOK_AHEAD: usize = 64;

/// The sub-segments along some half-edges, one after the other.
struct Choices<'a> {
    arrangement: &'a Arrangement,
    half_edges: &'a [usize],
}

/// For each half-edge of a contour one of its sub-segments: preferably the one that continues what comes before, or else
/// the one that goes on longest.
fn chosen_pieces(arrangement: &Arrangement, half_edges: &[usize]) -> Vec<OutlinePiece> {
    let choices = Choices {
        arrangement,
        half_edges,
    };
    let count = half_edges.len();
    // Starts at an edge of one sub-segment, where there is nothing to choose.
    let single = (0..count).find(|&k| choices.at(k).len() == 1).unwrap_or(0);
    let mut pieces: Vec<OutlinePiece> = Vec::with_capacity(count);
    for k in single..single + count {
        let continued = pieces.last().and_then(|last| choices.continuing(last, k));
        pieces.extend(continued.or_else(|| choices.longest(k)));
    }
    pieces
}

impl Choices<'_> {
    /// The pieces for half-edge k of the closed contour.
    fn at(&self, k: usize) -> impl ExactSizeIterator<Item = OutlinePiece> + '_ {
        let h = self.half_edges[k % self.half_edges.len()];
        let edges = &self.arrangement.edges;
        let members = edges.members(h / 2).iter();
        members.map(move |member| OutlinePiece::new(member, h.is_multiple_of(2)))
    }

    fn continuing(&self, last: &OutlinePiece, k: usize) -> Option<OutlinePiece> {
        self.at(k)
            .find(|piece| last.continues_subpath(self.arrangement, piece))
    }

    /// The piece for half-edge k whose outline runs along most of the next half-edges.
    fn longest(&self, k: usize) -> Option<OutlinePiece> {
        // The first and the latest piece of each outline that still goes on.
        let mut candidates: Vec<(OutlinePiece, OutlinePiece)> =
            self.at(k).map(|piece| (piece, piece)).collect();
        for ahead in k + 1..k + 1 + LOOK_AHEAD.min(self.half_edges.len()) {
            if candidates.len() == 1 {
                break;
            }
            let longer: Vec<(OutlinePiece, OutlinePiece)> = candidates
                .iter()
                .filter_map(|(first, last)| Some((*first, self.continuing(last, ahead)?)))
                .collect();
            if longer.is_empty() {
                break;
            }
            candidates = longer;
        }
        candidates.first().map(|&(first, _)| first)
    }
}
