//! The stroke of one subpath or of one of its dashes, divided into sections.
//!
//! A curve is divided at stops of the widths, at cusps, and where a straight curve turns back.

use super::Strokes;
use super::contours::{push_disk, push_dot};
use super::dash::{Dash, Pattern};
use super::options::{Pen, StrokeCap};
use super::outline::{Outline, push_closed};
use super::profile::{Radii, WidthPosition, WidthProfile};
use super::section::{Breaks, PositionedCurve, ROUNDING, sort_with_ends};
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::path::Path;
use crate::spline::Spline;
use crate::spline::offset::SMOOTH_PART;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// A subpath in a scale of about 1.
struct ScaledSubpath {
    radii: Radii,
    scale: f64,
    /// The number of its segments, and its scaled length if the width varies.
    steps: f64,
    length: f64,
    /// The scaled pen.
    pen: Pen,
}

impl ScaledSubpath {
    /// The length is asked for if the width varies.
    fn new(
        spline: &Spline<DVec2>,
        length: impl FnOnce() -> f64,
        profile: &WidthProfile,
        pen: &Pen,
    ) -> Self {
        let points = spline.control_points();
        let size = 1.0 / Normalized::around(points[0], points).scale;
        // A power of two, so that nothing is rounded.
        let scale = Normalized::new(points[0], size.max(pen.radius)).scale;
        let pen = pen.scaled(scale);
        let mut radii = Radii::new(profile, scale, spline.is_closed());
        radii.sides = pen.sides;
        let length = if radii.is_constant() {
            0.0
        } else {
            length() * scale
        };
        Self {
            radii,
            scale,
            steps: as_f64(spline.segment_count()),
            length,
            pen,
        }
    }

    /// The position at which a dash starts.
    fn start(&self, dash: &Dash) -> f64 {
        match self.radii.at {
            WidthPosition::T => dash.from.0 / self.steps,
            WidthPosition::Length if self.length > 0.0 => dash.from.1 * self.scale / self.length,
            WidthPosition::Length => 0.0,
        }
    }

    /// The curves of a dash with the positions along them.
    fn curves(&self, dash: &Dash) -> Vec<PositionedCurve> {
        let mut position = self.start(dash);
        let ts = dash.parameters();
        let mut all = Vec::with_capacity(ts.len() - 1);
        for k in 0..dash.spline.segment_count() {
            let points = dash.spline.segment_points(k);
            if points.iter().all(|&p| p == points[0]) {
                continue;
            }
            let rate = match self.radii.at {
                WidthPosition::T => {
                    position = ts[k] / self.steps;
                    (ts[k + 1] - ts[k]) / self.steps
                }
                WidthPosition::Length => 1.0 / self.length,
            };
            let scaled = points.iter().map(|&p| p * self.scale).collect();
            let curve = Curve::from_points(scaled);
            PositionedCurve::push_parts(&mut all, curve, self.radii.at, position, rate);
            position = all.last().map_or(position, |part| part.position(1.0));
        }
        all
    }
}

impl Strokes {
    /// Adds the stroke of a subpath or of one of its dashes; `whole` is the subpath.
    fn add(&mut self, dash: &Dash, whole: &ScaledSubpath) -> Result<(), Error> {
        let (radii, pen, unit) = (&whole.radii, &whole.pen, 1.0 / whole.scale);
        let curves = whole.curves(dash);
        if curves.is_empty() {
            self.curve_count += 1;
            // A subpath that is a point has all discs there.
            let radius = if whole.length > 0.0 {
                radii.polynomial(whole.start(dash)).at(whole.start(dash))[0]
            } else {
                pen.radius
            };
            if radius > 0.0 {
                let dot = Pen { radius, ..*pen }.scaled(unit);
                let center = dash.spline.control_points()[0];
                push_dot(&mut self.outlines, center, dash.tangent, &dot);
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
        let end = curves.last().map_or(1.0, |curve| curve.position(1.0));
        let radii_at = |position| {
            let [radius, ..] = radii.polynomial(position).at(position);
            pen.sides.unwrap_or([radius; 2])
        };
        let mut outline = Outline::new(pen, [whole.start(dash), end].map(radii_at));
        for curve in &curves {
            let breaks = breaks_of(curve, radii);
            self.curve_count += breaks.len() - 1;
            for (k, pair) in breaks.windows(2).enumerate() {
                let section = curve.section([pair[0], pair[1]], radii);
                if section.curve.has_size() {
                    outline.add(&section, curve.is_first && k == 0)?;
                }
            }
        }
        let surrounds = closed && pen.sides.is_none() && fits_in_disc(&dash.spline, from * unit);
        let contours = outline.finish(closed, cap, surrounds)?;
        let unscaled = |mut contour: SplineBuilder| {
            contour.points.iter_mut().for_each(|p| *p *= unit);
            contour
        };
        for contour in contours.outlines {
            push_closed(&mut self.outlines, unscaled(contour));
        }
        for fold in contours.folds {
            push_closed(&mut self.folds, unscaled(fold));
        }
        if contours.surrounds && from > 0.0 {
            let first = Pen {
                radius: from,
                ..*pen
            }
            .scaled(unit);
            push_disk(&mut self.outlines, dash.spline.control_points()[0], &first);
        }
        Ok(())
    }

    /// The contours of an open part of a longer subpath, which begins at a length of it.
    pub(super) fn of_part(
        part: Spline<DVec2>,
        from: f64,
        length: f64,
        profile: &WidthProfile,
        pen: &Pen,
    ) -> Result<Self, Error> {
        let whole = ScaledSubpath::new(&part, || length, profile, pen);
        let mut strokes = Self::default();
        strokes.add(&Dash::from_length(part, from), &whole)?;
        Ok(strokes)
    }
}

impl Path {
    /// The contours of the strokes of all subpaths or their dashes.
    pub(super) fn strokes(
        &self,
        profile: &WidthProfile,
        pen: &Pen,
        pattern: Option<&Pattern>,
    ) -> Result<Strokes, Error> {
        let mut strokes = Strokes::default();
        let mut count = 0;
        for spline in self.subpaths() {
            let whole = ScaledSubpath::new(&spline, || spline.length(), profile, pen);
            let [from, to] = whole.radii.ends();
            let Some(pattern) = pattern else {
                strokes.add(&Dash::whole(spline), &whole)?;
                continue;
            };
            // Dashes do not pass a step of the width at the start of a closed subpath.
            let opened = (spline.is_closed() && from != to).then(|| opened(&spline));
            for dash in pattern.dashes(opened.as_ref().unwrap_or(&spline), &mut count)? {
                strokes.add(&dash, &whole)?;
            }
        }
        Ok(strokes)
    }
}

/// The parameters at which a curve is divided at stops of the profile, with both ends.
fn breaks_of(curve: &PositionedCurve, radii: &Radii) -> Breaks {
    let mut breaks = Breaks::new();
    if !radii.is_constant() {
        let end = curve.position(1.0);
        for &round in radii.rounds() {
            // A stop at an end of the curve can be inside because of rounding.
            let inside =
                radii.stops_between(curve.start - round + ROUNDING, end - round - ROUNDING);
            breaks.extend(inside.map(|position| curve.time(position + round)));
        }
        if radii.rounds().len() > 1 && curve.start < 1.0 && end > 1.0 {
            breaks.push(curve.time(1.0));
        }
    }
    sort_with_ends(&mut breaks);
    breaks
}

/// Whether a disc of the radius may contain a spline.
fn fits_in_disc(spline: &Spline<DVec2>, radius: f64) -> bool {
    let bounds = spline.bounds();
    Point::max_abs(bounds.max - bounds.min) <= 2.0 * radius
}

/// A closed spline as an open one that ends where it starts.
fn opened(spline: &Spline<DVec2>) -> Spline<DVec2> {
    let mut points = spline.control_points().to_vec();
    points.push(points[0]);
    Spline::from_parts(points, &spline.degrees(), false)
}
