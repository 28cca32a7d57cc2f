//! The outline of the stroke of one subpath.
//!
//! Let r be the radius as a function of arc length, T and N the tangent and the normal. The discs touch their envelope at
//! c − r r′ T ± r √(1 − r′²) N: the left and the right side, which are offset curves if r is constant. Where |r′| ≥ 1 one
//! disc contains the others, and both sides pass through it on the same line. So they do at a step of the radius.
//!
//! The outline consists of two chains of sides, on the left and on the right. Where the direction changes, the outer side
//! has a join, and the inner side passes through the corner, so that the outline is a sum of the outlines of the parts and
//! of the joins. Where r′ changes suddenly, both sides follow on the circle.
//!
//! Source of the envelope: Choi, Choi and Moon, "Mathematical theory of medial axis transform", Pacific J. Math. 181
//! (1997).

use super::options::{Pen, StrokeCap};
use super::section::{Disc, LEFT, RIGHT, Section, SectionEvaluator, SideInterval, SideKind};
use super::side::Side;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::path::Path;
use crate::spline::Join;
use crate::spline::offset::SMOOTH_PART;
use crate::spline::spline_builder::SplineBuilder;
use casteljau_kernels::spline::offset::offset_curve::add_arc;
use glam::DVec2;
use std::f64::consts::PI;

/// The outline of a subpath under construction.
pub(super) struct Outline<'a> {
    pen: &'a Pen,
    /// The radii on both sides at the start and at the end, from which those of the sections may differ by a step.
    end_radii: [[f64; 2]; 2],
    left: SplineBuilder,
    right: SplineBuilder,
    /// The first and the last disc so far, and whether the sections there have straight sides.
    ends: Option<[(Disc, bool); 2]>,
    /// The discs beyond which the stroke ends with less than a half disc, at butt caps and bevels; their tangents point
    /// out of the stroke.
    blunt_ends: Vec<Disc>,
    /// The intervals of sections in which a side runs backwards.
    backward: Vec<(Section<'a>, f64, SideInterval)>,
}

impl<'a> Outline<'a> {
    /// `end_radii` are the radii on both sides at the start and at the end.
    pub(super) fn new(pen: &'a Pen, end_radii: [[f64; 2]; 2]) -> Self {
        Self {
            pen,
            end_radii,
            left: SplineBuilder::default(),
            right: SplineBuilder::default(),
            ends: None,
            blunt_ends: Vec::new(),
            backward: Vec::new(),
        }
    }

    fn sides(&mut self) -> [(f64, &mut SplineBuilder); 2] {
        [(LEFT, &mut self.left), (RIGHT, &mut self.right)]
    }

    fn tolerance(&self) -> f64 {
        self.pen.tolerance * (1.0 - SMOOTH_PART)
    }

    /// Begins both sides, on the first disc of the subpath.
    fn start(&mut self, section_start: (Disc, bool)) -> (Disc, bool) {
        let from = section_start.0;
        let before = Disc {
            radii: self.end_radii[0],
            ..from
        };
        let first = if self.is_step(&before, &from) {
            let slope = before.contained_slope(&from);
            (Disc { slope, ..before }, false)
        } else {
            section_start
        };
        for (side, chain) in self.sides() {
            chain.start(first.0.point(side));
        }
        self.ends = Some([first; 2]);
        first
    }

    /// Appends a section. `is_corner`: whether a change of direction at its start is a corner of the subpath and not a
    /// reversal of a curve.
    pub(super) fn add(&mut self, section: &Section<'a>, is_corner: bool) -> Result<(), Error> {
        let discs = section.end_discs();
        let is_straight = section.is_straight();
        let [from, to] = [(discs[0], is_straight), (discs[1], is_straight)];
        let last = match self.ends {
            Some([_, last]) => last,
            None => self.start(from),
        };
        self.connect(last, from, is_corner, false);
        let mut backward = Vec::new();
        if is_straight {
            for (side, chain) in self.sides() {
                chain.connect_to(to.0.point(side));
            }
        } else {
            let (pen, tolerance) = (self.pen, self.tolerance());
            let evaluator = SectionEvaluator::new(section);
            let samples = evaluator.samples();
            for (side, chain) in self.sides() {
                let of_side = Side {
                    evaluator: &evaluator,
                    side,
                    tolerance,
                };
                for interval in evaluator.side_intervals(&samples, side, discs) {
                    match interval.kind {
                        SideKind::Inside => pass_contained(chain, side, interval.ends, pen),
                        _ if section.is_point(&interval) => {
                            pass_contained(chain, side, interval.ends, pen);
                        }
                        SideKind::Forward => of_side.add(&interval, 1.0, chain)?,
                        SideKind::Backward => {
                            of_side.add_midway(&interval, chain);
                            backward.push((side, interval));
                        }
                    }
                }
            }
        }
        if let Some([_, last]) = &mut self.ends {
            *last = to;
        }
        for (side, interval) in backward {
            self.backward.push((section.clone(), side, interval));
        }
        Ok(())
    }

    /// Whether two radii are so different that the step is part of the outline.
    fn is_step(&self, from: &Disc, to: &Disc) -> bool {
        (to.radius() - from.radius()).abs() > SMOOTH_PART * self.pen.tolerance
    }

    /// Connects both sides where the radius, r′ and the direction change; `is_last`: at the end of a closed subpath.
    fn connect(
        &mut self,
        (from, from_line): (Disc, bool),
        (to, to_line): (Disc, bool),
        is_corner: bool,
        is_last: bool,
    ) {
        let (pen, center, radius) = (self.pen, to.center, to.radius());
        // First the radius and r′ change, then the direction.
        let before_turn = Disc {
            tangent: from.tangent,
            ..to
        };
        let is_step = self.is_step(&from, &to);
        for (side, chain) in self.sides() {
            if is_step {
                pass_contained(chain, side, [from, before_turn], pen);
            } else {
                follow_circle(chain, side, [from, before_turn], pen);
            }
        }
        // A turn by 180° is a left turn, also if the sine is −0. At reversals, the half disk ahead is that of the wider side.
        let sin = before_turn.tangent.perp_dot(to.tangent) + 0.0;
        let is_left_turn = match pen.sides {
            Some([left, right]) if !is_corner || sin == 0.0 => left <= right,
            _ => sin >= 0.0,
        };
        let (outer, inner) = if is_left_turn {
            (RIGHT, LEFT)
        } else {
            (LEFT, RIGHT)
        };
        if Point::norm(to.tangent - before_turn.tangent) * radius <= SMOOTH_PART * pen.tolerance {
            return;
        }
        let [outer_chain, inner_chain] = if outer == RIGHT {
            [&mut self.right, &mut self.left]
        } else {
            [&mut self.left, &mut self.right]
        };
        // Through the corner, so that the outline is the sum of those of both sections and of the join.
        inner_chain.connect_to(center);
        inner_chain.connect_to(to.point(inner));
        let radius = to.radius_of(outer);
        let normals = [before_turn.normal(outer), to.normal(outer)];
        let has_sides = to.slope.abs() < 1.0;
        if !is_corner || pen.join == Join::Round || !has_sides {
            let turn = sin.atan2(before_turn.tangent.dot(to.tangent));
            // The arc goes around the outer side; rounding decides the sign of a sine near 0.
            let turn = match is_left_turn {
                true if turn < 0.0 => turn + 2.0 * PI,
                false if turn > 0.0 => turn - 2.0 * PI,
                _ => turn,
            };
            push_arc(outer_chain, (center, radius), normals, turn, pen);
            return;
        }
        if let Some(reach) = pen.miter(radius, normals[0].dot(normals[1])) {
            let tip = center + (normals[0] + normals[1]) * reach;
            push_tip(
                outer_chain,
                tip,
                from_line && from.slope == to.slope && !is_step,
            );
            // A straight side goes on from the tip; at the end of a closed subpath this is the first side.
            if to_line {
                if is_last {
                    outer_chain.points[0] = tip;
                }
                return;
            }
        } else {
            self.blunt_ends.push(before_turn);
        }
        outer_chain.connect_to(to.point(outer));
    }

    /// The contours. `surrounds`: whether both sides of a closed subpath may surround points in the same direction.
    pub(super) fn finish(
        mut self,
        closed: bool,
        cap: StrokeCap,
        surrounds: bool,
    ) -> Result<Contours, Error> {
        let mut contours = Contours::default();
        let Some([first, mut last]) = self.ends else {
            return Ok(contours);
        };
        if closed {
            self.connect(last, first, true, true);
        } else {
            let after = Disc {
                radii: self.end_radii[1],
                ..last.0
            };
            if self.is_step(&last.0, &after) {
                let slope = last.0.contained_slope(&after);
                let end = (Disc { slope, ..after }, false);
                self.connect(last, end, false, false);
                last = end;
            }
        }
        if !closed && cap == StrokeCap::Butt {
            // At its start, the stroke ends against the direction of the path.
            let back = Disc {
                tangent: -first.0.tangent,
                slope: -first.0.slope,
                ..first.0
            };
            self.blunt_ends.extend([last.0, back]);
        }
        let tolerance = self.tolerance();
        let Self {
            pen,
            mut left,
            mut right,
            blunt_ends,
            backward,
            ..
        } = self;
        let is_sided = pen.sides.is_some();
        if is_sided || !blunt_ends.is_empty() {
            for (section, side, interval) in &backward {
                let side = Side {
                    evaluator: &SectionEvaluator::new(section),
                    side: *side,
                    tolerance,
                };
                if is_sided || surrounds || side.is_near_blunt_end(interval.span, &blunt_ends) {
                    contours.folds.push(side.fold(interval)?);
                }
            }
        }
        contours.surrounds = surrounds && blunt_ends.is_empty();
        // Forwards on the right and backwards on the left: a closed outline.
        left.points.reverse();
        left.degrees.reverse();
        if closed {
            contours.outlines.extend([right, left]);
            return Ok(contours);
        }
        add_cap(&mut right, last.0, 1.0, cap, pen);
        right.points.extend(&left.points[1..]);
        right.degrees.extend(&left.degrees);
        add_cap(&mut right, first.0, -1.0, cap, pen);
        contours.outlines.push(right);
        Ok(contours)
    }
}

/// The contours of the stroke of a subpath; each ends where it starts.
#[derive(Default)]
pub(super) struct Contours {
    pub(super) outlines: Vec<SplineBuilder>,
    /// The parts that are swept backwards, where the outlines can leave them out.
    pub(super) folds: Vec<SplineBuilder>,
    /// Whether the points within all discs may be left out. They are within the first one.
    pub(super) surrounds: bool,
}

/// Follows the circle of a disc while r′ changes.
fn follow_circle(chain: &mut SplineBuilder, side: f64, [from, to]: [Disc; 2], pen: &Pen) {
    if from.slope != to.slope {
        let normals = [from, to].map(|disc| disc.normal(side));
        let angle = side * (to.angle() - from.angle());
        push_arc(chain, (to.center, to.radius()), normals, angle, pen);
    }
}

/// Continues from one disc to another one, if one of them contains the other and all between them.
fn pass_contained(chain: &mut SplineBuilder, side: f64, [from, to]: [Disc; 2], pen: &Pen) {
    let slope = from.contained_slope(&to);
    let [leaving, arriving] = [from, to].map(|disc| Disc { slope, ..disc });
    follow_circle(chain, side, [from, leaving], pen);
    chain.connect_to(arriving.point(side));
    follow_circle(chain, side, [arriving, to], pen);
}

/// Appends the tip of a miter; a line before it is extended.
fn push_tip(chain: &mut SplineBuilder, tip: DVec2, extends: bool) {
    match chain.points.last_mut() {
        Some(end) if extends => *end = tip,
        _ => chain.connect_to(tip),
    }
}

/// Appends an arc about a centre while the normal turns by an angle, unless it is too short to matter.
fn push_arc(
    chain: &mut SplineBuilder,
    (center, radius): (DVec2, f64),
    normals: [DVec2; 2],
    angle: f64,
    pen: &Pen,
) {
    if angle.abs() * radius <= SMOOTH_PART * pen.tolerance {
        return;
    }
    let tangents = normals.map(|normal| -normal.perp());
    let before = chain.points.len();
    let centers = [center; 2];
    add_arc(
        centers,
        tangents,
        angle,
        radius,
        pen.tolerance,
        &mut chain.points,
    );
    let count = (chain.points.len() - before) / 3;
    chain.degrees.extend(std::iter::repeat_n(3, count));
}

/// Appends a cap to a chain that ends on one side of a disc: around the front if `sign` is 1, around the rear if it is −1.
pub(super) fn add_cap(chain: &mut SplineBuilder, end: Disc, sign: f64, cap: StrokeCap, pen: &Pen) {
    let (from, to) = (-sign, sign);
    let disc = end.cap_disc();
    match cap {
        StrokeCap::Round => {
            let normals = [end.normal(from), end.normal(to)];
            let angle = if sign > 0.0 {
                end.angle()
            } else {
                PI - end.angle()
            };
            push_arc(
                chain,
                (disc.center, disc.radius()),
                normals,
                2.0 * angle,
                pen,
            );
        }
        StrokeCap::Square => {
            let ahead = end.tangent * (sign * disc.radius());
            chain.connect_to(end.point(from) + ahead);
            chain.connect_to(end.point(to) + ahead);
        }
        StrokeCap::Butt => {}
    }
    chain.connect_to(end.point(to));
}

/// Appends a closed subpath that ends where it starts; none if rounding leaves a point.
pub(super) fn push_closed(path: &mut Path, mut chain: SplineBuilder) {
    if !chain.degrees.is_empty() {
        chain.points.pop();
        path.push(&chain.points, chain.degrees.iter().copied(), true);
    }
}
