//! Distance of a curve from a polyline, computed independently of the code under test: samples, then refined peaks.

use super::{de_casteljau, highest, largest, real, ulp};
use casteljau::Point;
use casteljau::glam::DVec3;

/// The number of samples of the piece for one chord. Their order finds a large deviation early.
const SAMPLES: usize = 24;

/// A curve in measuring coordinates: relative to its start, and scaled by a power of two to about 1. This loses no
/// digits for curves far from the origin and keeps squares in range.
pub(crate) struct Reference {
    points: Vec<DVec3>,
    start: DVec3,
    scale: f64,
}

impl Reference {
    pub(crate) fn new(points: &[DVec3]) -> Self {
        let size = largest(points);
        let scale = if size > 0.0 {
            (-size.log2().round()).exp2().min(1e300)
        } else {
            1.0
        };
        let start = points[0] * scale;
        let points = points.iter().map(|&p| p * scale - start).collect();
        Self {
            points,
            start,
            scale,
        }
    }

    /// The caller's point in measuring coordinates.
    pub(crate) fn location(&self, p: DVec3) -> DVec3 {
        p * self.scale - self.start
    }

    pub(crate) fn locations<P: Point>(&self, points: &[P]) -> Vec<DVec3> {
        points.iter().map(|p| self.location(p.to_3d())).collect()
    }

    /// The caller's length in measuring coordinates.
    pub(crate) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// The rounding error of a measurement.
    pub(crate) fn noise(&self) -> f64 {
        2.0 * ulp(largest(&self.points))
    }

    pub(crate) fn at(&self, t: f64) -> DVec3 {
        de_casteljau(&self.points, t)
    }

    /// The maximum distance of the piece from t₀ to t₁ from the segment a b (scaled); stops once it exceeds `enough`.
    pub(crate) fn deviation(
        &self,
        (t0, t1): (f64, f64),
        (a, b): (DVec3, DVec3),
        enough: f64,
    ) -> f64 {
        let distance = |s: f64| from_segment(self.at(t0 + (t1 - t0) * s), a, b);
        let mut samples = [0.0; SAMPLES + 1];
        let mut max: f64 = 0.0;
        for k in 1..SAMPLES {
            // 7 and 24 have no common factor, so the strides cover the whole piece.
            let i = (k * 7) % SAMPLES;
            samples[i] = distance(real(i) / real(SAMPLES));
            max = max.max(samples[i]);
            if max > enough {
                return max;
            }
        }
        for i in 1..SAMPLES {
            let peak = samples[i] >= samples[i - 1] && samples[i] >= samples[i + 1];
            if peak && samples[i] > 0.7 * max && max > 0.6 * enough {
                let around = [i - 1, i + 1].map(|i| real(i) / real(SAMPLES));
                max = max.max(highest(distance, around, 16));
            }
        }
        max
    }
}

/// The distance from a point to a segment.
pub(crate) fn from_segment<P: Point>(p: P, a: P, b: P) -> f64 {
    let (along, square) = ((p - a).dot(b - a), (b - a).dot(b - a));
    // The parameter of the nearest point, from 0 to 1.
    let share = if square > 0.0 {
        (along / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p - (a + (b - a) * share)).norm()
}

/// The distance from a point to a polyline.
pub(crate) fn from_polyline<P: Point>(p: P, line: &[P]) -> f64 {
    let distances = line.windows(2).map(|s| from_segment(p, s[0], s[1]));
    distances.fold(f64::INFINITY, f64::min)
}

/// The maximum distance from the curve to a polyline: of each piece from its own chord, and where that exceeds
/// `enough`, of its samples from all chords.
pub(crate) fn farthest(reference: &Reference, ts: &[f64], vertices: &[DVec3], enough: f64) -> f64 {
    let mut max: f64 = 0.0;
    for (t, v) in ts.windows(2).zip(vertices.windows(2)) {
        let own = reference.deviation((t[0], t[1]), (v[0], v[1]), enough);
        max = max.max(if own > enough {
            from_all(reference, (t[0], t[1]), vertices)
        } else {
            own
        });
    }
    max
}

fn from_all(reference: &Reference, (t0, t1): (f64, f64), vertices: &[DVec3]) -> f64 {
    let steps = 400;
    let at = |i: usize| reference.at(t0 + (t1 - t0) * (real(i) / real(steps)));
    (0..=steps)
        .map(|i| from_polyline(at(i), vertices))
        .fold(0.0, f64::max)
}

/// Greedy search for the fewest chords: from each vertex the longest chord within the tolerance (scaled).
pub(crate) fn fewest(reference: &Reference, tolerance: f64) -> usize {
    const CELLS: usize = 64;
    let fits = |t0: f64, t1: f64| {
        reference.deviation((t0, t1), (reference.at(t0), reference.at(t1)), tolerance) <= tolerance
    };
    let (mut t, mut count) = (0.0, 0);
    while t < 1.0 && count < 1_000_000 {
        let grid = |i: usize| t + (1.0 - t) * (real(i) / real(CELLS));
        count += 1;
        if fits(t, 1.0) {
            break;
        }
        let (mut safe, mut failing) = match (1..CELLS).rev().find(|&i| fits(t, grid(i))) {
            Some(i) => (grid(i), grid(i + 1)),
            None => below(&fits, t, grid(1)),
        };
        for _ in 0..20 {
            let middle = 0.5 * (safe + failing);
            if fits(t, middle) {
                safe = middle;
            } else {
                failing = middle;
            }
        }
        t = safe.max(t.next_up());
    }
    count
}

/// Halves a failing step until the chord fits.
fn below(fits: &impl Fn(f64, f64) -> bool, t: f64, failing: f64) -> (f64, f64) {
    let mut step = failing - t;
    while step > f64::EPSILON && !fits(t, t + 0.5 * step) {
        step *= 0.5;
    }
    (t + 0.5 * step, t + step)
}
