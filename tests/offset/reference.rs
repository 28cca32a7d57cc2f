//! The true offset curve, computed slowly: a dense polyline with each vertex from the curve's own point and derivative.

use crate::support::measure::from_segment;
use crate::support::{de_casteljau as at, real};
use casteljau::glam::DVec2;
use std::f64::consts::PI;

/// A dense polyline of the offset curve.
pub(crate) struct DenseReference {
    pub(crate) vertices: Vec<DVec2>,
}

fn differences(points: &[DVec2]) -> Vec<DVec2> {
    points.windows(2).map(|p| p[1] - p[0]).collect()
}

/// Below this fraction of the maximum speed only rounding decides in which sense a curve turns at a stop (a point of
/// zero speed).
const STOP: f64 = 1e-13;

/// The largest number of stops of a curve: each doubles the number of curves that rounding cannot distinguish.
const MAX_STOPS: usize = 12;

/// Half the length of the parameter interval around a stop that is omitted: beside it the tangent is known to 10⁻⁷.
const BESIDE: f64 = 1e-9;

/// A handle below this fraction of the longest one counts as zero, since the rounding of the control points is as
/// large.
const NO_HANDLE: f64 = 1e-15;

/// A curve with its derivative.
struct Walker<'a> {
    points: &'a [DVec2],
    hodograph: Vec<DVec2>,
    distance: f64,
    step: f64,
}

impl Walker<'_> {
    fn tangent(&self, t: f64) -> DVec2 {
        let velocity = at(&self.hodograph, t);
        // The square of a tiny velocity would be 0.
        (velocity / velocity.abs().max_element().max(f64::MIN_POSITIVE)).normalize_or_zero()
    }

    fn point(&self, t: f64, tangent: DVec2) -> DVec2 {
        at(self.points, t) + tangent.perp() * self.distance
    }

    /// The tangents at both ends: toward the first control point that differs from the end.
    fn end_tangents(&self) -> (DVec2, DVec2) {
        let toward = |p: DVec2, q: &DVec2| (*q != p).then(|| (*q - p).normalize());
        let (p, q) = (self.points[0], self.points[self.points.len() - 1]);
        let first = self.points.iter().find_map(|r| toward(p, r));
        let last = self.points.iter().rev().find_map(|r| toward(q, r));
        (first.unwrap_or_default(), -last.unwrap_or_default())
    }

    /// Adds an arc around a point by an angle; its first vertex is already in the list.
    fn turn(&self, t: f64, from: DVec2, angle: f64, out: &mut Vec<DVec2>) {
        let steps = (1.0 + angle.abs() * (self.distance.abs() / self.step).sqrt())
            .min(65_536.0)
            .floor();
        let mut k = 1.0;
        while k <= steps {
            out.push(self.point(t, DVec2::from_angle(angle * k / steps).rotate(from)));
            k += 1.0;
        }
    }

    /// Adds the offset from one parameter to another, whose tangents are known; its first vertex is already in the
    /// list.
    fn walk(&self, (t0, n0): (f64, DVec2), (t1, n1): (f64, DVec2), out: &mut Vec<DVec2>) {
        let (o0, o1) = (self.point(t0, n0), self.point(t1, n1));
        let angle = n0.angle_to(n1);
        if t1 - t0 < 1e-13 {
            return self.turn(t1, n0, angle, out);
        }
        let t = 0.5 * (t0 + t1);
        let n = self.tangent(t);
        let o = self.point(t, n);
        let flat = (o - (o0 + o1) * 0.5).length() < self.step && angle.abs() < 0.2;
        if flat && t1 - t0 < 0.01 {
            out.push(o1);
            return;
        }
        self.walk((t0, n0), (t, n), out);
        self.walk((t, n), (t1, n1), out);
    }
}

fn fastest(vectors: &[DVec2]) -> f64 {
    vectors.iter().map(|v| v.length()).fold(0.0, f64::max)
}

/// The control points, where those that an end's handle of rounding size leads to are moved to that end.
fn without_tiny_handles(points: &[DVec2]) -> Vec<DVec2> {
    let longest = fastest(&differences(points));
    let min = NO_HANDLE * real(points.len() - 1) * longest;
    let mut moved = points.to_vec();
    let (first, last) = (points[0], points[points.len() - 1]);
    for p in moved
        .iter_mut()
        .take_while(|p| (**p - first).length() <= min)
    {
        *p = first;
    }
    let ending = moved.iter_mut().rev();
    for p in ending.take_while(|p| (**p - last).length() <= min) {
        *p = last;
    }
    moved
}

/// The parameters inside (0, 1) with a minimum of the speed, and these speeds as fractions of the maximum.
pub(crate) fn slowest(points: &[DVec2]) -> Vec<(f64, f64)> {
    let slopes = differences(points);
    let fastest = fastest(&slopes);
    let speed = |t: f64| at(&slopes, t).length();
    // The steps are also small next to the ends, where short handles cause stops.
    let near: Vec<f64> = (10..40).map(|k| 0.5_f64.powi(k)).collect();
    let mut ts: Vec<f64> = (0..=512).map(|k| real(k) / 512.0).collect();
    ts.extend(near.iter().flat_map(|t| [*t, 1.0 - t]));
    ts.sort_by(f64::total_cmp);
    let speeds: Vec<f64> = ts.iter().map(|&t| speed(t)).collect();
    let mut found = Vec::new();
    for k in 1..ts.len() - 1 {
        if speeds[k] > speeds[k - 1] || speeds[k] >= speeds[k + 1] {
            continue;
        }
        let (mut lo, mut hi) = (ts[k - 1], ts[k + 1]);
        for _ in 0..90 {
            let (a, b) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
            if speed(a) < speed(b) {
                hi = b;
            } else {
                lo = a;
            }
        }
        found.push((lo, speed(lo) / fastest));
    }
    found
}

impl DenseReference {
    /// The vertices of the offset curve, with chords within about `step` of it. The bits of `around` tell which stops
    /// are passed on their inside: a curve that almost stops may turn in either sense.
    pub(crate) fn new(
        points: &[DVec2],
        stops: &[f64],
        distance: f64,
        step: f64,
        around: u32,
    ) -> Self {
        let walker = Walker {
            points,
            hodograph: differences(points),
            distance,
            step,
        };
        let (first, last) = walker.end_tangents();
        let mut vertices = vec![walker.point(0.0, first)];
        let mut from = (0.0, first);
        for (k, stop) in stops.iter().enumerate() {
            let (before, after) = (stop - BESIDE, stop + BESIDE);
            let (n0, n1) = (walker.tangent(before), walker.tangent(after));
            walker.walk(from, (before, n0), &mut vertices);
            let angle = n0.angle_to(n1);
            let inside = around >> k & 1 != 0;
            let outside = 1.0_f64.copysign(if inside { distance } else { -distance });
            // A stop without a turn back has no inside.
            let known = angle.abs() < 3.0 || angle.signum() == outside;
            let angle = if known {
                angle
            } else {
                angle + outside * 2.0 * PI
            };
            walker.turn(*stop, n0, angle, &mut vertices);
            from = (after, n1);
        }
        walker.walk(from, (1.0, last), &mut vertices);
        Self { vertices }
    }

    /// All offset curves that rounding cannot distinguish from the true one, each computed when it is asked for.
    pub(crate) fn all(points: &[DVec2], distance: f64, step: f64) -> impl Iterator<Item = Self> {
        let points = without_tiny_handles(points);
        let inside = |t: &f64| *t > 2.0 * BESIDE && *t < 1.0 - 2.0 * BESIDE;
        let slow = slowest(&points)
            .into_iter()
            .filter(|&(_, speed)| speed < STOP);
        let stops: Vec<f64> = slow.map(|(t, _)| t).filter(inside).collect();
        assert!(stops.len() <= MAX_STOPS, "too many stops: {stops:?}");
        (0..1_u32 << stops.len())
            .map(move |around| Self::new(&points, &stops, distance, step, around))
    }

    /// The maximum distance from the polyline of points that follow it.
    pub(crate) fn farthest(&self, points: &[DVec2], enough: f64) -> f64 {
        farthest(&self.vertices, points, enough)
    }
}

/// Each point is searched for next to the previous point's position; only if that fails, everywhere.
pub(crate) fn farthest(line: &[DVec2], points: &[DVec2], enough: f64) -> f64 {
    let mut location: usize = 0;
    let mut max: f64 = 0.0;
    let last = line.len() - 2;
    for &p in points {
        let (mut best, mut here) = (f64::INFINITY, location);
        let distance = |k: usize| from_segment(p, line[k], line[k + 1]);
        let mut k = location.saturating_sub(8);
        while k <= last && k <= here + 24 {
            if distance(k) < best {
                (best, here) = (distance(k), k);
            }
            k += 1;
        }
        if best > enough {
            for k in 0..=last {
                if distance(k) < best {
                    (best, here) = (distance(k), k);
                }
            }
        }
        location = here;
        max = max.max(best);
    }
    max
}

/// Points of each segment, with chords within `sag`.
pub(crate) fn dense(spline: &casteljau::Spline<DVec2>, sag: f64) -> Vec<DVec2> {
    let mut points = Vec::new();
    for curve in spline.segments() {
        let p = curve.control_points();
        let bend = fastest(&differences(&differences(p)));
        let n = real(p.len() - 1);
        let steps = (n * (n - 1.0) * bend / (8.0 * sag)).sqrt().ceil();
        let steps = steps.clamp(4.0, 16_384.0);
        let mut k = 0.0;
        while k <= steps {
            points.push(curve.eval(k / steps));
            k += 1.0;
        }
    }
    points
}
