//! The outline of the stroke of one subpath.
//!
//! Two chains of offset curves, on the left and on the right. At a corner the outer side has a join, and the inner side
//! passes through the corner, so that the outline is a sum of the outlines of the segments' strokes and of the joins.

use super::options::{Pen, StrokeCap};
use super::side_boundary::add_sides;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::path::Path;
use crate::spline::OffsetJoin;
use crate::spline::offset::{SMOOTH_PART, end_tangent, start_tangent};
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// The outline of a subpath.
pub(super) struct Outline {
    left: SplineBuilder,
    right: SplineBuilder,
    pub(super) closed: bool,
    /// The points and directions beyond which the stroke ends with less than a half disk: butt caps and bevels.
    pub(super) blunt_ends: Vec<(DVec2, DVec2)>,
    caps: [SplineBuilder; 2],
}

impl Outline {
    /// Expects curves that are not points.
    pub(super) fn new(curves: &[Curve<DVec2>], closed: bool, pen: &Pen) -> Result<Self, Error> {
        let mut outline = Self {
            left: SplineBuilder::default(),
            right: SplineBuilder::default(),
            closed,
            blunt_ends: Vec::new(),
            caps: Default::default(),
        };
        let own = pen.tolerance * (1.0 - SMOOTH_PART);
        for (k, curve) in curves.iter().enumerate() {
            if k > 0 {
                outline.join(&curves[k - 1], curve, false, pen);
            }
            let sides = [&mut outline.left, &mut outline.right];
            add_sides(sides, curve, pen.radius, own)?;
        }
        let (first, last) = (&curves[0], &curves[curves.len() - 1]);
        if closed {
            outline.join(last, first, true, pen);
        } else {
            let ends = [
                (last.end(), end_tangent(last)),
                (first.start(), -start_tangent(first)),
            ];
            outline.caps = ends.map(|(end, tangent)| cap(end, tangent, pen));
            if pen.cap == StrokeCap::Butt {
                outline.blunt_ends.extend(ends);
            }
        }
        Ok(outline)
    }

    /// Connects both sides of two consecutive segments; of the last and the first one if `is_last`.
    fn join(&mut self, before: &Curve<DVec2>, after: &Curve<DVec2>, is_last: bool, pen: &Pen) {
        let (corner, from, to) = (after.start(), end_tangent(before), start_tangent(after));
        if Point::norm(to - from) * pen.radius <= SMOOTH_PART * pen.tolerance {
            return;
        }
        // A turn by 180° is a left turn.
        let turns_left = from.perp_dot(to) >= 0.0;
        let (outer, inner, distance) = if turns_left {
            (&mut self.right, &mut self.left, -pen.radius)
        } else {
            (&mut self.left, &mut self.right, pen.radius)
        };
        inner.line_to(corner);
        inner.line_to(corner - to.perp() * distance);
        if pen.join == OffsetJoin::Round {
            outer.add_arc_about(corner, from, to, distance, pen.tolerance);
            return;
        }
        let Some(reach) = pen.miter(from.dot(to)) else {
            self.blunt_ends.push((corner, from));
            outer.line_to(corner + to.perp() * distance);
            return;
        };
        let tip = corner + (from + to).perp() * reach.copysign(distance);
        let lines = [before, after].map(|curve| curve.degree() == 1);
        push_miter(outer, tip, corner + to.perp() * distance, lines, is_last);
    }

    /// Appends the contours: one for an open subpath, two for a closed one.
    pub(super) fn push_to(self, path: &mut Path) {
        let Self {
            mut left,
            mut right,
            caps: [end, start],
            closed,
            ..
        } = self;
        left.points.reverse();
        left.degrees.reverse();
        if closed {
            for side in [right, left] {
                push_closed(path, side);
            }
            return;
        }
        for part in [end, left, start] {
            append(&mut right, &part);
        }
        push_closed(path, right);
    }
}

/// Appends the sides of a miter, from the end of the chain to the start of what follows. `lines` tells whether the
/// segments before and after the corner are lines, which are extended to the tip; after the last corner of a closed
/// chain the segment after it is the first one.
fn push_miter(chain: &mut SplineBuilder, tip: DVec2, next: DVec2, lines: [bool; 2], is_last: bool) {
    let end = chain.points.len() - 1;
    if lines[0] {
        chain.points[end] = tip;
    } else {
        chain.line_to(tip);
    }
    if !lines[1] {
        chain.line_to(next);
    } else if is_last {
        chain.points[0] = tip;
    }
}

/// Appends a chain that starts where another one ends.
fn append(chain: &mut SplineBuilder, next: &SplineBuilder) {
    if chain.points.is_empty() {
        chain.points.extend(&next.points);
    } else {
        chain.points.extend(&next.points[1..]);
    }
    chain.degrees.extend(&next.degrees);
}

/// Appends a closed subpath that ends where it starts.
pub(super) fn push_closed(path: &mut Path, mut chain: SplineBuilder) {
    chain.points.pop();
    path.push(&chain.points, chain.degrees.iter().copied(), true);
}

/// The cap at an end with a tangent that points out of the stroke, from the right to the left.
pub(super) fn cap(end: DVec2, tangent: DVec2, pen: &Pen) -> SplineBuilder {
    let (normal, ahead) = (tangent.perp() * pen.radius, tangent * pen.radius);
    let mut cap = SplineBuilder::default();
    cap.start(end - normal);
    if pen.cap == StrokeCap::Round {
        cap.add_arc_about(end, tangent, -tangent, -pen.radius, pen.tolerance);
        return cap;
    }
    if pen.cap == StrokeCap::Square {
        cap.line_to(end - normal + ahead);
        cap.line_to(end + normal + ahead);
    }
    cap.line_to(end + normal);
    cap
}
