//! Contours as paths: arcs of one segment are joined again, and what is whole keeps its bits.

use super::arrangement::Arrangement;
use super::edges::Member;
use super::order::origin;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use crate::path::Path;
use glam::DVec2;

/// How many edges ahead the choice between coinciding arcs looks.
const LOOK_AHEAD: usize = 64;

/// A part of a segment, in the direction of its outline: from t₀ to t₁, where t₀ > t₁ means backwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    segment: usize,
    t: [f64; 2],
    /// The vertex at its start.
    vertex: usize,
}

impl Piece {
    fn new(member: &Member, forward: bool, vertex: usize) -> Self {
        let [from, to] = member.arc.t;
        Self {
            segment: member.arc.segment,
            t: if member.forward == forward {
                [from, to]
            } else {
                [to, from]
            },
            vertex,
        }
    }

    fn is_forward(&self) -> bool {
        self.t[0] < self.t[1]
    }

    /// Whether the segment, or the one after it on its outline, continues with another piece.
    fn continues(&self, arrangement: &Arrangement, next: &Self) -> bool {
        let [end, start] = [(self, self.t[1]), (next, next.t[0])];
        self.is_forward() == next.is_forward()
            && (self.segment == next.segment && end.1 == start.1
                || [end, start]
                    .map(|(piece, t)| joint(arrangement, piece.segment, t))
                    .windows(2)
                    .all(|j| j[0].is_some() && j[0] == j[1]))
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

/// Appends a closed subpath along some half-edges.
pub(super) fn push_contour(arrangement: &Arrangement, half_edges: &[usize], path: &mut Path) {
    let pieces = pieces(arrangement, half_edges);
    let pieces = started(arrangement, joined(pieces, true));
    push_subpath(arrangement, &pieces, true, path);
}

/// For each half-edge one of its arcs: preferably one that continues what comes before, or goes on longest.
fn pieces(arrangement: &Arrangement, half_edges: &[usize]) -> Vec<Piece> {
    let edges = &arrangement.edges;
    let choices = |k: usize| {
        let h = half_edges[k % half_edges.len()];
        let vertex = origin(edges, h);
        edges
            .members(h / 2)
            .iter()
            .map(move |member| Piece::new(member, h.is_multiple_of(2), vertex))
    };
    let count = half_edges.len();
    let single = (0..count).find(|&k| choices(k).len() == 1).unwrap_or(0);
    let mut pieces: Vec<Piece> = Vec::with_capacity(count);
    for k in single..single + count {
        let continued = pieces
            .last()
            .and_then(|last| choices(k).find(|piece| last.continues(arrangement, piece)));
        let longest = || {
            let mut alive: Vec<(Piece, Piece)> = choices(k).map(|piece| (piece, piece)).collect();
            for ahead in k + 1..k + 1 + LOOK_AHEAD.min(count) {
                let goes_on = |&(first, last): &(Piece, Piece)| {
                    let mut next = choices(ahead);
                    next.find(|next| last.continues(arrangement, next))
                        .map(|next| (first, next))
                };
                let longer: Vec<(Piece, Piece)> = alive.iter().filter_map(goes_on).collect();
                if alive.len() == 1 || longer.is_empty() {
                    break;
                }
                alive = longer;
            }
            alive.first().map(|&(first, _)| first)
        };
        pieces.extend(continued.or_else(longest));
    }
    pieces
}

/// Joins consecutive pieces of one segment; in a closed outline also the last with the first.
pub(super) fn joined(pieces: Vec<Piece>, closed: bool) -> Vec<Piece> {
    let continues = |a: &Piece, b: &Piece| {
        a.segment == b.segment && a.t[1] == b.t[0] && a.is_forward() == b.is_forward()
    };
    let mut all: Vec<Piece> = Vec::with_capacity(pieces.len());
    for piece in pieces {
        match all.last_mut().filter(|last| continues(last, &piece)) {
            Some(last) => last.t[1] = piece.t[1],
            None => all.push(piece),
        }
    }
    if let [first, .., last] = &all[..]
        && closed
        && continues(last, first)
    {
        let first = Piece {
            t: [last.t[0], first.t[1]],
            ..*last
        };
        all.pop();
        all[0] = first;
    }
    all
}

/// The pieces of a closed outline from the start of a subpath of the input if it has one, otherwise from the start of
/// the piece with the smallest index.
fn started(arrangement: &Arrangement, mut pieces: Vec<Piece>) -> Vec<Piece> {
    let is_first = |piece: &Piece| arrangement.segments.list[piece.segment].is_first;
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
    pieces: &[Piece],
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
        if let Some(before) = before {
            move_start(&mut part, junction(arrangement, before, piece));
        }
        if let Some(after) = after {
            part.reverse();
            move_start(&mut part, junction(arrangement, piece, after));
            part.reverse();
        }
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
    path.push(&points, &degrees, closed);
}

/// The point where two consecutive pieces of an outline meet: a joint of the input where there is one.
fn junction(arrangement: &Arrangement, before: &Piece, after: &Piece) -> DVec2 {
    let joints = &arrangement.segments.joints;
    let [end, start] = [(before, before.t[1]), (after, after.t[0])]
        .map(|(piece, t)| joint(arrangement, piece.segment, t));
    match (end, start) {
        (Some(a), Some(b)) => joints[a.min(b)],
        (Some(a), None) | (None, Some(a)) => joints[a],
        (None, None) => arrangement.arcs.vertices[after.vertex].point,
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
