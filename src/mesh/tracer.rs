//! Samples and frames along the isocurves of a surface, for tubes and ribbons.

use super::isocurves::Isocurve;
use super::mesh_patch::{MeshPatch, SpaceCurve};
use super::sweep::{Sweep, SweepFrame, cos_sin};
use super::wire::Wire;
use crate::curve::carried_frame::double_reflection;
use crate::geometry::check::max_abs;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::surface::network::Surface;
use glam::DVec3;
use std::f64::consts::PI;

/// A ribbon follows its line as closely as a tube with this number of sides.
const RIBBON_SIDES: usize = 8;

/// The smallest tolerance, in ulps of the largest coordinate.
const MIN_ULPS: f64 = 4.0;

/// Sweeps a cross-section along isocurves.
pub(crate) struct Tracer {
    tolerance: f64,
    /// The cosine of the largest angle between the tangents at two successive samples.
    max_turn_cosine: f64,
    ribbon: bool,
}

/// A sample of a line, before its frame is computed.
#[derive(Clone, Copy)]
struct LineSample {
    t: f64,
    point: DVec3,
    along: DVec3,
    /// The surface normal for a ribbon, otherwise zero.
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
        // The sides of a tube are (1 − cos π/n) radii from its circle; the line may deviate by as much from the curve.
        // 1 − cos 2α = 2 sin² α, without cancellation.
        let [_, sine] = cos_sin(0.5 * PI / as_f64(sides));
        let share = radii * 2.0 * sine * sine;
        let min = MIN_ULPS * f64::from(f32::EPSILON) * size / share;
        if got < min {
            return Err(Error::TooSmall { what, min, got });
        }
        Ok(Self {
            tolerance: got * share,
            max_turn_cosine: cos_sin(2.0 * PI / as_f64(sides))[0],
            ribbon: matches!(wire, Wire::Ribbon { .. }),
        })
    }

    /// Sweeps the section along one line.
    pub(crate) fn sweep_line(
        &self,
        line: &Isocurve<'_, impl MeshPatch>,
        sweep: &mut Sweep<'_>,
    ) -> Result<(), Error> {
        // Only a curve that is a point has no tangent.
        if line.curve.tangent(0.0) == DVec3::ZERO {
            return Ok(());
        }
        let polyline = line.curve.flatten(self.tolerance)?;
        let mut before: Option<(LineSample, SweepFrame)> = None;
        for (&t, &point) in polyline.ts.iter().zip(&polyline.points) {
            let sample = self.sample_at(line, t, point);
            before = Some(match before {
                None => self.start(sample, sweep),
                Some(from) => self.sweep_to(line, from, sample, sweep),
            });
        }
        if let Some((_, frame)) = before {
            sweep.end(&frame);
        }
        Ok(())
    }

    fn sample_at(&self, line: &Isocurve<'_, impl MeshPatch>, t: f64, point: DVec3) -> LineSample {
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

    fn start(&self, sample: LineSample, sweep: &mut Sweep<'_>) -> (LineSample, SweepFrame) {
        let frame = frame(&sample, sample.normal);
        sweep.begin(&frame);
        (sample, frame)
    }

    /// Advances to the next sample, with intermediate samples as the largest angle requires.
    fn sweep_to(
        &self,
        line: &Isocurve<'_, impl MeshPatch>,
        (from, before): (LineSample, SweepFrame),
        to: LineSample,
        sweep: &mut Sweep<'_>,
    ) -> (LineSample, SweepFrame) {
        let straight = |a: DVec3, b: DVec3| {
            a.dot(b) >= self.max_turn_cosine || a == DVec3::ZERO || b == DVec3::ZERO
        };
        if straight(from.along, to.along) && straight(from.normal, to.normal) {
            let side = if to.normal == DVec3::ZERO {
                transported(&before, &to)
            } else {
                to.normal
            };
            let frame = frame(&to, side);
            sweep.add_ring(&frame);
            return (to, frame);
        }
        let middle = 0.5 * (from.t + to.t);
        let close = Point::norm(to.point - from.point) <= self.tolerance;
        if close || middle <= from.t || middle >= to.t {
            // The line has a corner here: the tube ends, and another one begins.
            sweep.end(&before);
            return self.start(to, sweep);
        }
        let middle = self.sample_at(line, middle, line.curve.eval(middle));
        let half = self.sweep_to(line, (from, before), middle, sweep);
        self.sweep_to(line, half, to, sweep)
    }
}

/// The frame at a sample, with its side direction as close as possible to the given direction.
fn frame(sample: &LineSample, side: DVec3) -> SweepFrame {
    let LineSample { point, along, .. } = *sample;
    let mut side = DVec3::normal_of(along, side);
    if side == DVec3::ZERO {
        // The given direction is zero or parallel to the tangent; an axis at an angle of at least 30° to the tangent is
        // neither.
        let axis = if along.x.abs() < 0.5 {
            DVec3::X
        } else {
            DVec3::Y
        };
        side = DVec3::normal_of(along, axis);
    }
    SweepFrame { point, along, side }
}

/// The side direction of a frame, transported to the next sample without rotation about the line.
fn transported(from: &SweepFrame, to: &LineSample) -> DVec3 {
    double_reflection(from.side, [from.along, to.along], to.point - from.point)
}
