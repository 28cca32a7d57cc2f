//! Operations that cut: a region along a path, and a path at the boundary of a region.

use super::arrangement::Arrangement;
use super::operations::paths_of;
use super::outline::{OutlinePiece, push_subpath};
use super::segments::Role;
use crate::geometry::error::Error;
use crate::numeric::sort::sort_by;
use crate::path::Path;
use crate::path::winding::FillRule;

impl Path {
    /// The parts into which the outlines of another path, open or closed, cut the region that this path fills.
    ///
    /// `rule` fills this path; the other one only cuts, and its open subpaths are not closed. A cut that does not reach
    /// from boundary to boundary, or around a part, has no effect. The parts are sorted by the first segment on their
    /// outer contours; together they are the region. See [`union`](Self::union) for their contours and for the distance
    /// within which outlines count as one. A path without cuts gives the separate parts of the region.
    ///
    /// # Errors
    /// As [`union`](Self::union).
    ///
    /// ```
    /// use casteljau::{Path, path::FillRule};
    ///
    /// let square: Path = "M0 0H2V2H0Z".parse().expect("path data");
    /// let line: Path = "M-1 0.5H3".parse().expect("path data");
    /// let areas: Vec<f64> = square.divide(&line, FillRule::NonZero)?.iter().map(Path::area).collect();
    /// assert_eq!(areas, [1.0, 3.0]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn divide(&self, other: &Self, rule: FillRule) -> Result<Vec<Self>, Error> {
        let arrangement = Arrangement::new(&[(self, Role::Region), (other, Role::Cut)])?;
        let mut inside = vec![false; arrangement.faces.count];
        arrangement.visit_faces(rule, |face, windings| inside[face] = windings.is_inside(0));
        let is_cut = |e: usize| {
            let mut members = arrangement.edges.members(e).iter();
            members.any(|member| arrangement.segments.list[member.sub_segment.segment].path == 1)
        };
        let regions = arrangement.joined_faces(&inside, |e| !is_cut(e));
        let parts = paths_of(&arrangement, &regions).into_iter();
        Ok(parts.map(|(_, path)| path).collect())
    }

    /// The parts of the outlines of this path that lie in the region that another path fills by `rule`.
    ///
    /// Segments are cut where they enter or leave the region; its boundary belongs to it. Open subpaths stay open; a
    /// closed subpath stays closed if it lies inside, and otherwise gives open parts. Parts that continue across the
    /// start of a closed subpath are one. Segments that are not cut keep their control points bit for bit, and
    /// directions are kept. See [`union`](Self::union) for the distance within which points count as one.
    ///
    /// # Errors
    /// As [`union`](Self::union).
    ///
    /// ```
    /// use casteljau::{Path, path::FillRule};
    ///
    /// let line: Path = "M-1 1H5".parse().expect("path data");
    /// let squares: Path = "M0 0H2V2H0Z M3 0H4V2H3Z".parse().expect("path data");
    /// assert_eq!(line.clip(&squares, FillRule::NonZero)?.to_string(), "M0,1 L2,1 M3,1 L4,1");
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn clip(&self, region: &Self, rule: FillRule) -> Result<Self, Error> {
        let arrangement = Arrangement::new(&[(self, Role::Cut), (region, Role::Region)])?;
        let mut inside = vec![false; arrangement.faces.count];
        arrangement.visit_faces(rule, |face, windings| inside[face] = windings.is_inside(1));
        let mut path = Self::default();
        let pieces = pieces_of_first_path(&arrangement, &inside);
        let mut rest = &pieces[..];
        while let Some(first) = rest.first() {
            let same = |next: &&ClippedPiece| next.subpath == first.subpath;
            let count = rest.iter().take_while(same).count();
            push_inside(&arrangement, &rest[..count], &mut path);
            rest = &rest[count..];
        }
        Ok(path)
    }
}

/// A part of a segment of the path that is clipped.
#[derive(Clone, Copy)]
struct ClippedPiece {
    subpath: usize,
    piece: OutlinePiece,
    is_inside: bool,
}

/// All parts of the segments of the first path, in order and without gaps.
fn pieces_of_first_path(arrangement: &Arrangement, inside: &[bool]) -> Vec<ClippedPiece> {
    let segments = &arrangement.segments.list;
    let mut subpaths: Vec<usize> = Vec::with_capacity(segments.len());
    for segment in segments {
        let before = subpaths.last().copied().unwrap_or(0);
        subpaths.push(before + usize::from(segment.is_first));
    }
    let mut all: Vec<ClippedPiece> = Vec::new();
    for e in 0..arrangement.edges.list.len() {
        let sides = [2 * e, 2 * e + 1].map(|h| inside[arrangement.faces.left[h]]);
        for member in arrangement.edges.members(e) {
            if segments[member.sub_segment.segment].path == 0 {
                all.push(ClippedPiece {
                    subpath: subpaths[member.sub_segment.segment],
                    piece: OutlinePiece::along(&member.sub_segment),
                    // The boundary belongs to the region, so one side is sufficient.
                    is_inside: sides[0] || sides[1],
                });
            }
        }
    }
    sort_by(&mut all, |a, b| {
        let by_t = a.piece.t[0].total_cmp(&b.piece.t[0]);
        a.piece.segment.cmp(&b.piece.segment).then(by_t)
    });
    close_gaps(&mut all);
    all
}

/// Extends the parts over sub-segments that were removed because they are shorter than ε.
fn close_gaps(all: &mut [ClippedPiece]) {
    for own in all.chunk_by_mut(|a, b| a.piece.segment == b.piece.segment) {
        let mut end = 0.0;
        for clipped in own.iter_mut() {
            clipped.piece.t[0] = end;
            end = clipped.piece.t[1];
        }
        if let Some(last) = own.last_mut() {
            last.piece.t[1] = 1.0;
        }
    }
}

/// Appends the parts of one subpath that are inside.
fn push_inside(arrangement: &Arrangement, own: &[ClippedPiece], path: &mut Path) {
    let segments = &arrangement.segments.list;
    let (first, last) = (own[0].piece, own[own.len() - 1].piece);
    let is_closed = !segments[last.segment].is_last;
    let pieces = |run: &[ClippedPiece]| run.iter().map(|clipped| clipped.piece).collect();
    if is_closed && own.iter().all(|clipped| clipped.is_inside) {
        return push_subpath(
            arrangement,
            &OutlinePiece::joined(pieces(own), true),
            true,
            path,
        );
    }
    let mut runs: Vec<Vec<OutlinePiece>> = own
        .chunk_by(|a, b| a.is_inside == b.is_inside)
        .filter(|run| run[0].is_inside)
        .map(pieces)
        .collect();
    // The first run may be the rest of the last one, beyond the start of the subpath.
    let around = is_closed && own[0].is_inside && own[own.len() - 1].is_inside;
    if around && runs.len() > 1 && first.t[0] == 0.0 {
        let start = runs.remove(0);
        if let Some(run) = runs.last_mut() {
            run.extend(start);
        }
    }
    for run in runs {
        push_subpath(arrangement, &OutlinePiece::joined(run, false), false, path);
    }
}
