//! One side of a curve that is stroked, and where its offset runs backwards.

use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use crate::numeric::zero::regula_falsi;
use crate::spline::offset::{end_tangent, start_tangent};
use glam::DVec2;

/// A root is accurate enough when the width of its interval is this part of it.
const ROOT_WIDTH: f64 = 1e-13;

/// Steps towards a parameter of smallest speed.
const NEWTON_STEPS: usize = 4;

/// The speed and the turning of a curve at one parameter.
#[derive(Clone, Copy)]
struct Sample {
    t: f64,
    /// |B′|³ of the scaled curve.
    cube: f64,
    /// B′ × B″ of the scaled curve, times its scale: the curvature is `cross / cube`.
    cross: f64,
}

impl Sample {
    /// (1 − κd)·|B′|³ for a distance.
    fn forward(&self, distance: f64) -> f64 {
        self.cube - distance * self.cross
    }
}

/// A curve between its cusps, sampled at regular parameters and where it is slowest: a tight turn is next to those.
pub(super) struct Turns {
    pub(super) cusps: Vec<f64>,
    /// The intervals and their samples.
    parts: Vec<([f64; 2], Vec<Sample>)>,
}

impl Turns {
    /// Takes a number of samples for each degree between two cusps.
    pub(super) fn of(curve: &Curve<DVec2>, samples: usize) -> Self {
        let cusps = curve.cusps();
        let side = Side::new(curve, 0.0);
        let with = CurveWithDerivatives::new(&side.points);
        let count = samples * curve.degree();
        let mut breaks = vec![0.0];
        breaks.extend(&cusps);
        breaks.push(1.0);
        let part = |ends: &[f64]| {
            let [from, to] = [ends[0], ends[1]];
            // The speed is 0 at a cusp.
            let (first, last) = (usize::from(from > 0.0), count - usize::from(to < 1.0));
            let at = |k: usize| from + (to - from) * (k as f64 / count as f64);
            let even: Vec<Sample> = (first..=last).map(|k| side.sample(&with, at(k))).collect();
            ([from, to], side.with_slowest(&with, &even))
        };
        Self {
            parts: breaks.windows(2).map(part).collect(),
            cusps,
        }
    }
}

/// The parameter of the smallest speed near another one.
pub(super) fn slowest_near(
    with: &CurveWithDerivatives<DVec2>,
    mut t: f64,
    [from, to]: [f64; 2],
) -> f64 {
    for _ in 0..NEWTON_STEPS {
        let [first, second] = with.derivatives(t);
        let square = second.dot(second);
        if square > 0.0 {
            t = (t - first.dot(second) / square).clamp(from, to);
        }
    }
    t
}

/// One side of a curve.
pub(super) struct Side<'a> {
    pub(super) curve: &'a Curve<DVec2>,
    pub(super) distance: f64,
    /// The control points relative to the start, scaled to a size of about 1.
    pub(super) points: Points<DVec2>,
    scale: f64,
}

impl<'a> Side<'a> {
    pub(super) fn new(curve: &'a Curve<DVec2>, distance: f64) -> Self {
        let points = curve.control_points();
        let normalized = Normalized::around(curve.start(), points);
        Self {
            curve,
            distance,
            points: normalized.points(points),
            scale: normalized.scale,
        }
    }

    fn sample(&self, with: &CurveWithDerivatives<DVec2>, t: f64) -> Sample {
        let [first, second] = with.derivatives(t);
        let speed = Point::norm(first);
        Sample {
            t,
            cube: speed * speed * speed,
            cross: self.scale * first.perp_dot(second),
        }
    }

    /// Samples together with those at the smallest speeds between them.
    fn with_slowest(&self, with: &CurveWithDerivatives<DVec2>, samples: &[Sample]) -> Vec<Sample> {
        let mut all = Vec::with_capacity(samples.len() + 2);
        for (k, &own) in samples.iter().enumerate() {
            let slowest = match samples.get(k.wrapping_sub(1)..k + 2) {
                Some([a, _, b]) if own.cube <= a.cube.min(b.cube) => {
                    self.sample(with, slowest_near(with, own.t, [a.t, b.t]))
                }
                _ => own,
            };
            if slowest.t < own.t {
                all.push(slowest);
            }
            all.push(own);
            if slowest.t > own.t {
                all.push(slowest);
            }
        }
        all
    }

    /// The intervals of t with κd > 1, divided at the cusps of the curve.
    pub(super) fn backward_runs(&self, turns: &Turns) -> Vec<[f64; 2]> {
        let mut runs = Vec::new();
        for (ends, samples) in &turns.parts {
            self.push_runs(*ends, samples, &mut runs);
        }
        runs.retain(|run| run[0] < run[1]);
        runs
    }

    /// Appends the intervals with κd > 1 between two parameters.
    fn push_runs(&self, [from, to]: [f64; 2], samples: &[Sample], runs: &mut Vec<[f64; 2]>) {
        let with = CurveWithDerivatives::new(&self.points);
        let forward = |t: f64| self.sample(&with, t).forward(self.distance);
        let mut start = None;
        let mut last = (from, 0.0);
        for sample in samples {
            let (t, value) = (sample.t, sample.forward(self.distance));
            let zero = || {
                let sign = if last.1 < 0.0 { -1.0 } else { 1.0 };
                let bracket = [sign * last.1, sign * value];
                regula_falsi([last.0, t], bracket, ROOT_WIDTH, |t| sign * forward(t))
            };
            match start {
                None if value < 0.0 => start = Some(if last.1 == 0.0 { last.0 } else { zero() }),
                Some(start_of_run) if value >= 0.0 => {
                    runs.push([start_of_run, zero()]);
                    start = None;
                }
                _ => {}
            }
            last = (t, value);
        }
        runs.extend(start.map(|start| [start, to]));
    }

    /// The points of the evolute and of the offset curve at t.
    pub(super) fn ends_at(&self, with: &CurveWithDerivatives<DVec2>, t: f64) -> [DVec2; 2] {
        let Sample { cube, cross, .. } = self.sample(with, t);
        let bend = self.distance * cross;
        let tangent = match t {
            0.0 => start_tangent(self.curve),
            1.0 => end_tangent(self.curve),
            _ => Point::unit(with.derivatives(t)[0]),
        };
        let normal = tangent.perp();
        let point = self.curve.eval(t);
        // ρ/d, which is from 0 to 1 in an interval with κd > 1.
        let part = if bend > cube {
            (cube / bend).max(0.0)
        } else {
            1.0
        };
        [part, 1.0].map(|part| point + normal * (self.distance * part))
    }
}
