//! The input of Boolean operations as one list of segments, scaled to size 1.

use crate::bernstein::evaluate::evaluate;
use crate::curve::extrema::extrema_of;
use crate::curve::straight::Chord;
use crate::geometry::bounds::Bounds;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::unit_scale;
use crate::numeric::list::{Points, Scalars, points_of};
use crate::path::Path;
use glam::DVec2;

/// The largest number of segments of all paths together.
const MAX_SEGMENTS: usize = 1 << 22;

/// Points closer than this part of the size count as one, and so do outlines that run along each other within it.
const EPSILON: f64 = 1e-9;

/// No distance below this many roundings of the largest coordinate is resolved.
const RESOLUTION: f64 = 32.0 * f64::EPSILON;

/// A curve is straight if its control points are within this part of its largest coordinate of a line.
const STRAIGHT: f64 = 4.0 * f64::EPSILON;

/// What a path contributes to an operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Role {
    /// Its interior: open subpaths are closed.
    Region,
    /// Its segments alone, which only cut: open subpaths stay open.
    Cut,
}

/// A segment of an outline.
pub(super) struct Segment {
    /// The control points, scaled.
    pub(super) points: Points<DVec2>,
    /// The box of the control points.
    pub(super) bounds: Bounds<DVec2>,
    /// The index of the path.
    pub(super) path: usize,
    /// The node of the start and that of the end: a joint of an outline is one node.
    pub(super) ends: [usize; 2],
    /// Whether the segment starts where its subpath starts.
    pub(super) is_first: bool,
    /// Whether the segment ends where an open subpath ends.
    pub(super) is_last: bool,
    /// Whether it is a line that meets others of its kind in common ends only.
    pub(super) is_noded: bool,
}

impl Segment {
    pub(super) fn start(&self) -> DVec2 {
        self.points[0]
    }

    pub(super) fn end(&self) -> DVec2 {
        self.points[self.points.len() - 1]
    }

    pub(super) fn at(&self, t: f64) -> DVec2 {
        evaluate(&self.points, t)
    }
}

/// The segments of all paths.
pub(super) struct Segments {
    pub(super) list: Vec<Segment>,
    /// The points of the joints.
    pub(super) joints: Vec<DVec2>,
    pub(super) path_count: usize,
    /// Whether a path only cuts.
    pub(super) roles: Vec<Role>,
    /// The power of two that scales the largest coordinate to about 1.
    pub(super) unit: f64,
    /// The distance below which outlines count as one, scaled.
    pub(super) epsilon: f64,
}

impl Segments {
    /// The segments of the paths, without those that are a point.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more than 2²² segments.
    pub(super) fn new(paths: &[(&Path, Role)]) -> Result<Self, Error> {
        let needed = paths.iter().map(|(path, _)| path.segment_count()).sum();
        if needed > MAX_SEGMENTS {
            return Err(Error::too_many("segments", MAX_SEGMENTS, needed));
        }
        let largest = paths.iter().fold(0.0, |m: f64, (p, _)| m.max(p.max_abs()));
        let mut segments = Self {
            list: Vec::with_capacity(needed),
            joints: Vec::with_capacity(needed),
            path_count: paths.len(),
            roles: paths.iter().map(|&(_, role)| role).collect(),
            unit: unit_scale(largest),
            epsilon: 0.0,
        };
        for (index, (path, role)) in paths.iter().enumerate() {
            for part in path.parts() {
                let (start, end) = part.ends();
                let line = [end, start];
                let closing = (*role == Role::Region && start != end).then_some(&line[..]);
                let closed = part.closed || *role == Role::Region;
                let curves = part.segments().chain(closing);
                segments.push_subpath(curves.map(|curve| (curve, false)), index, closed);
            }
        }
        segments.epsilon = segments.coincidence_distance();
        Ok(segments)
    }

    /// Appends a subpath, without segments that are a point; for each one whether it is noded.
    pub(super) fn push_subpath<'a>(
        &mut self,
        curves: impl Iterator<Item = (&'a [DVec2], bool)>,
        path: usize,
        closed: bool,
    ) {
        let (first, first_joint) = (self.list.len(), self.joints.len());
        for (curve, is_noded) in curves {
            let points: Points<DVec2> = curve.iter().map(|&p| p * self.unit).collect();
            if points.iter().all(|&p| p == points[0]) {
                continue;
            }
            // A straight curve that turns back would overlap itself: lines between its turns are segments like all
            // others.
            match straight_turns(&points) {
                Some(turns) if !turns.is_empty() => {
                    let mut from = points[0];
                    for t in turns {
                        let to = evaluate(&points, t);
                        self.push_segment(&[from, to], path, is_noded);
                        from = to;
                    }
                    self.push_segment(&[from, points[points.len() - 1]], path, is_noded);
                }
                _ => self.push_segment(&points, path, is_noded),
            }
        }
        let Some(last) = self.list.len().checked_sub(1).filter(|&last| last >= first) else {
            return;
        };
        self.list[first].is_first = true;
        if closed {
            self.list[last].ends[1] = first_joint;
        } else {
            self.list[last].is_last = true;
            self.joints.push(self.list[last].end());
        }
    }

    /// Appends a segment that starts at a new joint, and expects the next one to start where it ends.
    fn push_segment(&mut self, points: &[DVec2], path: usize, is_noded: bool) {
        let joint = self.joints.len();
        self.joints.push(points[0]);
        self.list.push(Segment {
            points: points_of(points),
            bounds: Bounds::from_points(points),
            path,
            ends: [joint, joint + 1],
            is_first: false,
            is_last: false,
            is_noded,
        });
    }

    /// The box of all control points; `None` without segments.
    pub(super) fn bounds(&self) -> Option<Bounds<DVec2>> {
        let boxes = self.list.iter().map(|segment| segment.bounds);
        boxes.reduce(Bounds::union)
    }

    fn coincidence_distance(&self) -> f64 {
        let Some(all) = self.bounds() else {
            return 0.0;
        };
        let largest = all.min.abs().max(all.max.abs()).max_element();
        let size = (all.max - all.min).max_element();
        (EPSILON * size).max(RESOLUTION * largest)
    }

    /// The control points of a part of a segment; backwards if t₀ > t₁. A whole segment keeps its bits.
    pub(super) fn part(&self, segment: usize, t0: f64, t1: f64) -> Points<DVec2> {
        let mut part = self.list[segment].points.clone();
        self.keep_part(segment, t0, t1, &mut part);
        part
    }

    /// Appends the control points of a part of a segment, as [`part`](Self::part).
    pub(super) fn push_part(&self, segment: usize, t0: f64, t1: f64, out: &mut Vec<DVec2>) {
        let first = out.len();
        out.extend_from_slice(&self.list[segment].points);
        self.keep_part(segment, t0, t1, &mut out[first..]);
    }

    /// `part` has the control points of the segment, which become those of the part.
    fn keep_part(&self, segment: usize, t0: f64, t1: f64, part: &mut [DVec2]) {
        let (from, to) = if t0 > t1 { (t1, t0) } else { (t0, t1) };
        if (from, to) != (0.0, 1.0) {
            let points = &self.list[segment].points;
            casteljau_kernels::bernstein::de_casteljau::keep_between(part, from, to);
            let last = part.len() - 1;
            // With the bits of `Segment::at`, so that the parts on both sides of a cut end in the same point.
            part[0] = evaluate(points, from);
            part[last] = evaluate(points, to);
        }
        if t0 > t1 {
            part.reverse();
        }
    }
}

/// The parameters at which a straight curve reverses its direction; `None` for a curve that is not straight.
fn straight_turns(points: &[DVec2]) -> Option<Scalars> {
    if points.len() == 2 {
        return Some(Scalars::new());
    }
    let chord = Chord::of(points);
    let largest = points.iter().fold(0.0, |m: f64, p| m.max(p.max_abs()));
    (chord.width <= STRAIGHT * largest).then(|| {
        let along: Scalars = points
            .iter()
            .map(|p| chord.direction.dot(*p - points[0]))
            .collect();
        extrema_of(&along).into_iter().collect()
    })
}
