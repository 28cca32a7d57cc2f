//! Walking along the lines of a surface: where are the places that a wire goes through, and how are they turned?

use super::isocurves::Isocurve;
use super::sweep::{Frame, Sweep, turned};
use super::wire::Wire;
use crate::geometry::check::max_abs;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::surface::network::Surface;
use glam::DVec3;
use std::f64::consts::PI;

/// A ribbon follows its line as a tube of so many sides does.
const RIBBON_SIDES: usize = 8;

/// The least tolerance is four ulps of the largest coordinate.
const MIN_ULPS: f64 = 4.0;

/// Walks along lines.
pub(crate) struct Tracer {
    tolerance: f64,
    /// The cosine of the greatest turn between two places.
    turn: f64,
    ribbon: bool,
}

/// A place on a line before its frame is known.
#[derive(Clone, Copy)]
struct LineSample {
    t: f64,
    point: DVec3,
    along: DVec3,
    /// The surface's normal under a ribbon, else zero.
    normal: DVec3,
}

impl Tracer {
    pub(crate) fn new(surface: &Surface, wire: &Wire) -> Result<Self, Error> {
        let (what, got) = wire.size();
        let (sides, radii) = match *wire {
            Wire::Tube { sides, .. } => (sides, 1.0),
            Wire::Ribbon { .. } => (RIBBON_SIDES, 0.5),
        };
        let bounds = surface.control_bounds();
        let size = bounds.map_or(0.0, |b| max_abs(&[b.min, b.max]));
        if size + got > f64::from(f32::MAX) {
            return Err(Error::Range {
                what: "vertices",
                expected: "coordinates that f32 can hold",
                got: size + got,
            });
        }
        // 1 − cos 2α = 2 sin² α, without cancellation.
        let [_, sine] = turned(0.5 * PI / ratio(sides, 1));
        let share = radii * 2.0 * sine * sine;
        let min = MIN_ULPS * f64::from(f32::EPSILON) * size / share;
        if got < min {
            return Err(Error::TooSmall { what, min, got });
        }
        Ok(Self {
            tolerance: got * share,
            turn: turned(2.0 * PI / ratio(sides, 1))[0],
            ribbon: matches!(wire, Wire::Ribbon { .. }),
        })
    }

    /// Moves the section along one line.
    pub(crate) fn follow(&self, line: &Isocurve<'_>, sweep: &mut Sweep<'_>) -> Result<(), Error> {
        if line.curve.tangent(0.0) == DVec3::ZERO {
            return Ok(());
        }
        let polyline = line.curve.flatten(self.tolerance)?;
        let mut before: Option<(LineSample, Frame)> = None;
        for (&t, &point) in polyline.ts.iter().zip(&polyline.points) {
            let sample = self.look(line, t, point);
            before = Some(match before {
                None => self.start(sample, sweep),
                Some(from) => self.advance(line, from, sample, sweep),
            });
        }
        if let Some((_, frame)) = before {
            sweep.end(&frame);
        }
        Ok(())
    }

    fn look(&self, line: &Isocurve<'_>, t: f64, point: DVec3) -> LineSample {
        let (u, v) = if line.constant_u {
            (line.at, t)
        } else {
            (t, line.at)
        };
        LineSample {
            t,
            point,
            along: line.curve.tangent(t),
            normal: if self.ribbon {
                line.patch.normal(u, v)
            } else {
                DVec3::ZERO
            },
        }
    }

    fn start(&self, sample: LineSample, sweep: &mut Sweep<'_>) -> (LineSample, Frame) {
        let frame = frame(&sample, sample.normal);
        sweep.begin(&frame);
        (sample, frame)
    }

    /// Goes on to the next place, over as many between as the turn asks for.
    fn advance(
        &self,
        line: &Isocurve<'_>,
        (from, before): (LineSample, Frame),
        to: LineSample,
        sweep: &mut Sweep<'_>,
    ) -> (LineSample, Frame) {
        let straight =
            |a: DVec3, b: DVec3| a.dot(b) >= self.turn || a == DVec3::ZERO || b == DVec3::ZERO;
        if straight(from.along, to.along) && straight(from.normal, to.normal) {
            let side = if to.normal == DVec3::ZERO {
                carried(&before, &to)
            } else {
                to.normal
            };
            let frame = frame(&to, side);
            sweep.add_ring(&frame);
            return (to, frame);
        }
        let middle = 0.5 * (from.t + to.t);
        let close = Point::length(to.point - from.point) <= self.tolerance;
        if close || middle <= from.t || middle >= to.t {
            // A corner.
            sweep.end(&before);
            return self.start(to, sweep);
        }
        let middle = self.look(line, middle, line.curve.eval(middle));
        let half = self.advance(line, (from, before), middle, sweep);
        self.advance(line, half, to, sweep)
    }
}

/// The frame at a place, its side as near to the given direction as may be.
fn frame(sample: &LineSample, side: DVec3) -> Frame {
    let LineSample { point, along, .. } = *sample;
    let axis = if along.x.abs() < 0.5 {
        DVec3::X
    } else {
        DVec3::Y
    };
    let across = |v: DVec3| Point::normalize_or_zero(v - along * v.dot(along));
    // Of a side almost along the line, rounding leaves some of it: twice is enough (Kahan).
    let side = across(across(side));
    let side = if side == DVec3::ZERO {
        across(across(axis))
    } else {
        side
    };
    Frame { point, along, side }
}

/// The side of a frame, carried to the next place without a turn about the line: reflected in the plane amid both
/// points, then in the one that takes the tangent to that of the next.
fn carried(from: &Frame, to: &LineSample) -> DVec3 {
    let reflect = |v: DVec3, normal: DVec3| v - normal * (2.0 * v.dot(normal));
    let chord = Point::normalize_or_zero(to.point - from.point);
    let (side, along) = (reflect(from.side, chord), reflect(from.along, chord));
    reflect(side, Point::normalize_or_zero(to.along - along))
}
