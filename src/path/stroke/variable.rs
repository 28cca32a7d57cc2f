//! Strokes whose width varies: the outline of the union of all discs around the points of a subpath.
//!
//! Let r be the radius as a function of arc length, T and N the tangent and the normal. The discs touch their envelope at
//! c − r r′ T ± r √(1 − r′²) N: the left and the right side. Where |r′| ≥ 1 one disc contains the others, and both sides
//! pass through it on the same line.
//!
//! The outline runs along the right side, around the front of the last disc, back along the left side and around the rear
//! of the first disc. Consider the outline of the part up to some point, and let that point advance: only the front of the
//! disc moves over the plane, so the winding number of a point is the number of times that it enters a disc. It is
//! positive in the union of the discs and 0 elsewhere, also where a side runs backwards or both sides cross. Where the
//! direction or r′ changes suddenly, the front turns about the centre; both sides follow on the circle. Butt caps, bevels
//! and miters replace arcs by lines; next to them, the parts that a side sweeps backwards are added (see
//! [`folds`](super::folds)).

use super::contours::{push_disk, push_dot};
use super::dash::Dash;
use super::options::{Pen, StrokeCap};
use super::outline::push_closed;
use super::profile::{Radii, WidthPosition, WidthProfile};
use super::variable_pen::{
    Along, LEFT, PenAt, RIGHT, ROUNDING, Section, SectionEvaluator, between_ends,
};
use super::variable_side::{MAX_HALVINGS, SideFit, push_line};
use super::{Strokes, has_size};
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::work_limit::WorkLimit;
use crate::path::Path;
use crate::spline::offset::offset_curve::add_arc;
use crate::spline::offset::{SMOOTH_PART, end_tangent, start_tangent};
use crate::spline::spline_builder::SplineBuilder;
use crate::spline::{OffsetJoin, Spline};
use glam::DVec2;
use std::f64::consts::PI;

/// Maximum number of attempted cubics for one subpath.
const MAX_STEPS: usize = 1 << 17;

/// The outline of a subpath under construction.
struct VariableOutline<'a> {
    pen: &'a Pen,
    left: SplineBuilder,
    right: SplineBuilder,
    /// Contours of what is swept backwards.
    folds: Vec<SplineBuilder>,
    /// Whether butt caps, square caps, bevels or miters replace parts of discs.
    is_cut: bool,
    ends: Option<[PenAt; 2]>,
    work: WorkLimit,
}

impl VariableOutline<'_> {
    fn sides(&mut self) -> [(f64, &mut SplineBuilder); 2] {
        [(LEFT, &mut self.left), (RIGHT, &mut self.right)]
    }

    /// Appends a section. `is_corner`: whether a change of direction at its start is a corner of the subpath and not a reversal
    /// of a curve.
    fn add(&mut self, section: &Section, is_corner: bool) {
        let evaluator = SectionEvaluator::new(section);
        let breaks = evaluator.breaks();
        let mut from = evaluator.at(0.0);
        match self.ends {
            Some([_, last]) => self.connect(last, from, is_corner),
            None => {
                for (side, chain) in self.sides() {
                    chain.start(from.point(side));
                }
            }
        }
        let first = self.ends.map_or(from, |[first, _]| first);
        for pair in breaks.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let to = evaluator.at(b);
            let [square, left, right] = evaluator.evaluate(0.5 * (a + b)).1;
            let is_inside = square <= 0.0 || square.is_nan() || section.radius.is_zero();
            let is_line = is_inside || section.is_straight();
            let inside = (!is_line).then(|| evaluator.inside([a, b]));
            for (side, ahead) in [(LEFT, left), (RIGHT, right)] {
                let chain = if side == LEFT {
                    &mut self.left
                } else {
                    &mut self.right
                };
                let Some(inside) = &inside else {
                    push_line(chain, to.point(side));
                    continue;
                };
                let start = (chain.points.len() - 1, chain.degrees.len());
                let sign = if ahead < -ROUNDING { -1.0 } else { 1.0 };
                let fit = SideFit {
                    evaluator: &evaluator,
                    side,
                    sign,
                    tolerance: self.pen.tolerance * (1.0 - SMOOTH_PART),
                };
                fit.add(
                    [a, b],
                    [from, to],
                    inside,
                    MAX_HALVINGS,
                    chain,
                    &mut self.work,
                );
                if sign < 0.0 {
                    let mut fold = SplineBuilder {
                        points: chain.points[start.0..].to_vec(),
                        degrees: chain.degrees[start.1..].to_vec(),
                        closed: true,
                    };
                    fit.close_fold([a, b], &mut fold);
                    self.folds.push(fold);
                }
            }
            from = to;
        }
        self.ends = Some([first, from]);
    }

    /// Connects both sides where the direction or r′ changes.
    fn connect(&mut self, from: PenAt, to: PenAt, is_corner: bool) {
        let (pen, center, radius) = (self.pen, to.center, to.radius);
        let min = SMOOTH_PART * pen.tolerance;
        let turn = from
            .tangent
            .perp_dot(to.tangent)
            .atan2(from.tangent.dot(to.tangent));
        let spread = to.angle() - from.angle();
        let turns = turn.abs() * radius > min;
        let outer = if turn >= 0.0 { RIGHT } else { LEFT };
        let (is_cut, join) = (
            self.is_cut,
            if is_corner {
                pen.join
            } else {
                OffsetJoin::Round
            },
        );
        for (side, chain) in self.sides() {
            let normals = [from.normal(side), to.normal(side)];
            if turns && is_cut && side != outer {
                // The outline is the sum of those of the parts before and after the corner, and of the join.
                push_line(chain, center);
            } else if turns && join != OffsetJoin::Round && side == outer {
                let local = Pen { radius, ..*pen };
                if let Some(reach) = local.miter(normals[0].dot(normals[1])) {
                    push_line(chain, center + (normals[0] + normals[1]) * reach);
                }
            } else {
                push_arc(chain, (center, radius), normals, turn + side * spread, pen);
                continue;
            }
            push_line(chain, to.point(side));
        }
    }

    /// Appends a cap to a chain that ends on one side of an end: around the front if `sign` is 1, around the rear if
    /// it is −1.
    fn add_cap(chain: &mut SplineBuilder, end: PenAt, sign: f64, cap: StrokeCap, pen: &Pen) {
        let (from, to) = (-sign, sign);
        match cap {
            StrokeCap::Round => {
                let normals = [end.normal(from), end.normal(to)];
                let angle = if sign > 0.0 {
                    end.angle()
                } else {
                    PI - end.angle()
                };
                push_arc(chain, (end.center, end.radius), normals, 2.0 * angle, pen);
            }
            StrokeCap::Square => {
                let ahead = end.tangent * (sign * end.radius);
                push_line(chain, end.point(from) + ahead);
                push_line(chain, end.point(to) + ahead);
            }
            StrokeCap::Butt => {}
        }
        push_line(chain, end.point(to));
    }

    /// The contours of the outline, and those of the folds.
    fn finish(mut self, closed: bool, cap: StrokeCap) -> (Vec<SplineBuilder>, Vec<SplineBuilder>) {
        let Some([first, last]) = self.ends else {
            return Default::default();
        };
        if closed {
            self.connect(last, first, true);
        }
        let Self {
            pen,
            mut left,
            mut right,
            folds,
            is_cut,
            ..
        } = self;
        let reverse = |chain: &mut SplineBuilder| {
            chain.points.reverse();
            chain.degrees.reverse();
        };
        reverse(&mut left);
        let folds = if is_cut { folds } else { Vec::new() };
        if closed {
            return (vec![right, left], folds);
        }
        Self::add_cap(&mut right, last, 1.0, cap, pen);
        right.points.extend(&left.points[1..]);
        right.degrees.extend(&left.degrees);
        Self::add_cap(&mut right, first, -1.0, cap, pen);
        (vec![right], folds)
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

/// A subpath in a scale of about 1.
pub(super) struct Subpath {
    radii: Radii,
    normalized: Normalized<DVec2>,
    /// The number of its segments, and its scaled length.
    steps: f64,
    length: f64,
}

impl Subpath {
    /// A subpath of a length, and the pen in its scale.
    fn new(
        spline: &Spline<DVec2>,
        length: f64,
        radii_of: impl Fn(f64, bool) -> Radii,
        pen: &Pen,
    ) -> (Self, Pen) {
        let points = spline.control_points();
        let size = 1.0 / Normalized::around(points[0], points).scale;
        let normalized = Normalized::new(points[0], size.max(pen.radius));
        let whole = Self {
            radii: radii_of(normalized.scale, spline.is_closed()),
            normalized,
            steps: as_f64(spline.segment_count()),
            length: length * normalized.scale,
        };
        let scaled = Pen {
            radius: pen.radius * normalized.scale,
            tolerance: pen.tolerance * normalized.scale,
            ..*pen
        };
        (whole, scaled)
    }
}

impl Strokes {
    /// Adds the stroke of a subpath or of one of its dashes; `whole` is the subpath.
    pub(super) fn add_variable(
        &mut self,
        dash: &Dash,
        whole: &Subpath,
        pen: &Pen,
    ) -> Result<(), Error> {
        let Subpath {
            ref radii,
            normalized,
            steps,
            length,
        } = *whole;
        let normal = |curve: &Curve<DVec2>| -> Curve<DVec2> {
            Curve::from_points(normalized.points(curve.control_points()))
        };
        let curves: Vec<(usize, Curve<DVec2>)> = (dash.spline.segments().enumerate())
            .filter(|(_, curve)| has_size(curve))
            .map(|(k, curve)| (k, normal(&curve)))
            .collect();
        let start = match radii.at {
            WidthPosition::T => dash.from.0 / steps,
            WidthPosition::Length if length > 0.0 => dash.from.1 * normalized.scale / length,
            WidthPosition::Length => 0.0,
        };
        if curves.is_empty() {
            self.curve_count += 1;
            // A subpath that is a point has all discs there.
            let radius = if length > 0.0 {
                radii.polynomial(start).at(start)[0]
            } else {
                pen.radius
            };
            if radius > 0.0 {
                let dot = Pen {
                    radius: radius / normalized.scale,
                    tolerance: pen.tolerance / normalized.scale,
                    ..*pen
                };
                push_dot(
                    &mut self.outlines,
                    dash.spline.control_points()[0],
                    dash.tangent,
                    &dot,
                );
            }
            return Ok(());
        }
        // Two different discs at the start of a closed subpath are both part of the stroke.
        let [from, to] = radii.ends();
        let has_step = (from - to).abs() > SMOOTH_PART * pen.tolerance;
        let closed = dash.spline.is_closed() && !has_step;
        let cap = if dash.spline.is_closed() {
            StrokeCap::Round
        } else {
            pen.cap
        };
        let is_cut = cap != StrokeCap::Round
            || pen.join != OffsetJoin::Round && has_corners(&curves, closed);
        let mut outline = VariableOutline {
            pen,
            left: SplineBuilder::default(),
            right: SplineBuilder::default(),
            folds: Vec::new(),
            is_cut,
            ends: None,
            work: WorkLimit::new(MAX_STEPS),
        };
        let mut position = start;
        let ts = dash.parameters();
        for (k, curve) in curves {
            let rate = match radii.at {
                WidthPosition::T => {
                    position = ts[k] / steps;
                    (ts[k + 1] - ts[k]) / steps
                }
                WidthPosition::Length => 1.0 / length,
            };
            let along = Along::new(curve, radii.at, position, rate);
            position = along.position(1.0);
            let breaks = breaks_of(&along, position, radii);
            self.curve_count += breaks.len();
            for (k, pair) in breaks.windows(2).enumerate() {
                let part = along.part([pair[0], pair[1]], radii);
                if has_size(&part.curve) {
                    outline.add(&part, k == 0);
                }
            }
        }
        Error::unless_within("steps of a stroke", &outline.work)?;
        let (contours, folds) = outline.finish(closed, cap);
        let back = |mut contour: SplineBuilder| {
            for p in &mut contour.points {
                *p = normalized.back(*p);
            }
            contour
        };
        for contour in contours {
            push_closed(&mut self.outlines, back(contour));
        }
        for fold in folds {
            push_closed(&mut self.folds, back(fold));
        }
        if closed {
            self.add_first_disk(&dash.spline, from / normalized.scale, pen, normalized);
        }
        Ok(())
    }

    /// The points within all discs of a closed subpath, which both of its sides surround in the same direction, are in the
    /// first disc.
    fn add_first_disk(
        &mut self,
        spline: &Spline<DVec2>,
        radius: f64,
        pen: &Pen,
        normalized: Normalized<DVec2>,
    ) {
        let bounds = spline.control_bounds();
        if radius > 0.0 && Point::max_abs(bounds.max - bounds.min) <= 2.0 * radius {
            let disk = Pen {
                radius,
                tolerance: pen.tolerance / normalized.scale,
                ..*pen
            };
            push_disk(&mut self.outlines, spline.control_points()[0], &disk);
        }
    }
}

/// Whether the direction changes between consecutive curves, by more than rounding.
fn has_corners(curves: &[(usize, Curve<DVec2>)], closed: bool) -> bool {
    let is_corner = |before: &Curve<DVec2>, after: &Curve<DVec2>| {
        Point::norm(end_tangent(before) - start_tangent(after)) > ROUNDING
    };
    curves
        .windows(2)
        .any(|pair| is_corner(&pair[0].1, &pair[1].1))
        || closed && is_corner(&curves[curves.len() - 1].1, &curves[0].1)
}

/// The parameters at which a curve is divided, with both ends: at stops of the profile, and where the curve reverses.
fn breaks_of(along: &Along, end: f64, radii: &Radii) -> Vec<f64> {
    let mut breaks = along.reversals.clone();
    for &round in radii.rounds() {
        let inside = radii.stops_between(along.start - round, end - round);
        breaks.extend(inside.map(|position| along.time(position + round)));
    }
    if radii.rounds().len() > 1 && along.start < 1.0 && end > 1.0 {
        breaks.push(along.time(1.0));
    }
    between_ends(&mut breaks);
    breaks
}

impl Path {
    /// The union of the discs of all subpaths, as contours.
    pub(super) fn variable_strokes(
        &self,
        radii_of: impl Fn(f64, bool) -> Radii,
        pen: &Pen,
        pattern: Option<&super::dash::Pattern>,
    ) -> Result<Strokes, Error> {
        let mut strokes = Strokes::default();
        let mut count = 0;
        for spline in self.subpaths() {
            let (whole, scaled) = Subpath::new(&spline, spline.length(), &radii_of, pen);
            let [from, to] = whole.radii.ends();
            // Dashes do not pass a step of the width at the start of a closed subpath.
            let opened = (spline.is_closed() && from != to).then(|| opened(&spline));
            let dashes = match pattern {
                Some(pattern) => pattern.dashes(opened.as_ref().unwrap_or(&spline), &mut count)?,
                None => vec![Dash::whole(spline.clone())],
            };
            for dash in &dashes {
                strokes.add_variable(dash, &whole, &scaled)?;
            }
        }
        Ok(strokes)
    }
}

impl Strokes {
    /// The contours of an open part of a longer subpath, which begins at a length of it.
    pub(super) fn of_part(
        part: Spline<DVec2>,
        from: f64,
        length: f64,
        profile: &WidthProfile,
        pen: &Pen,
    ) -> Result<Self, Error> {
        let (whole, scaled) = Subpath::new(
            &part,
            length,
            |scale, closed| Radii::new(profile, scale, closed),
            pen,
        );
        let mut strokes = Self::default();
        strokes.add_variable(&Dash::from_length(part, from), &whole, &scaled)?;
        Ok(strokes)
    }
}

/// A closed spline as an open one that ends where it starts.
fn opened(spline: &Spline<DVec2>) -> Spline<DVec2> {
    let mut points = spline.control_points().to_vec();
    points.push(points[0]);
    Spline::from_parts(points, &spline.degrees(), false)
}
