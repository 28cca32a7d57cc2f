//! The true parallel, slowly: a dense polyline, each vertex from the curve's own point and derivative.

use crate::common::real;
use casteljau::glam::DVec2;
use std::f64::consts::PI;

/// A polyline and where its vertices come from.
pub(crate) struct Truth {
    pub(crate) vertices: Vec<DVec2>,
}

/// De Casteljau's algorithm, plainly.
pub(crate) fn at(points: &[DVec2], t: f64) -> DVec2 {
    let mut row = [DVec2::ZERO; 65];
    row[..points.len()].copy_from_slice(points);
    for last in (1..points.len()).rev() {
        for i in 0..last {
            row[i] = row[i] * (1.0 - t) + row[i + 1] * t;
        }
    }
    row[0]
}

fn differences(points: &[DVec2]) -> Vec<DVec2> {
    points.windows(2).map(|p| p[1] - p[0]).collect()
}

struct Walker<'a> {
    points: &'a [DVec2],
    hodograph: Vec<DVec2>,
    fastest: f64,
    distance: f64,
    step: f64,
}

impl Walker<'_> {
    /// The unit tangent; at a zero of the derivative that of a neighbour on the given side.
    fn tangent(&self, t: f64, side: f64) -> DVec2 {
        let mut beside = 0.0;
        loop {
            let v = at(&self.hodograph, t + side * beside);
            if v.length() > 1e-13 * self.fastest || beside > 0.1 {
                return v.normalize_or_zero();
            }
            beside = if beside == 0.0 { 1e-9 } else { beside * 4.0 };
        }
    }

    /// From one parameter to another, whose tangents are known; the first vertex is there already.
    fn walk(&self, (t0, n0): (f64, DVec2), (t1, n1): (f64, DVec2), out: &mut Vec<DVec2>) {
        let (p0, p1) = (at(self.points, t0), at(self.points, t1));
        let (o0, o1) = (
            p0 + n0.perp() * self.distance,
            p1 + n1.perp() * self.distance,
        );
        let (sin, cos) = (n0.perp_dot(n1), n0.dot(n1));
        let angle = sin.atan2(cos);
        if t1 - t0 < 1e-13 {
            // A turn about a point; half a turn goes around the outside.
            let half = angle.abs() > PI - 1e-2;
            let angle = if half {
                -angle.abs().copysign(self.distance)
            } else {
                angle
            };
            let steps = (1.0 + angle.abs() * (self.distance.abs() / self.step).sqrt())
                .min(4000.0)
                .floor();
            let mut k = 1.0;
            while k <= steps {
                let n = DVec2::from_angle(angle * k / steps).rotate(n0);
                out.push(p1 + n.perp() * self.distance);
                k += 1.0;
            }
            return;
        }
        let t = 0.5 * (t0 + t1);
        let side = if t > 0.5 { -1.0 } else { 1.0 };
        let n = self.tangent(t, side);
        let o = at(self.points, t) + n.perp() * self.distance;
        let flat = (o - (o0 + o1) * 0.5).length() < self.step && angle.abs() < 0.2;
        if flat && t1 - t0 < 0.01 {
            out.push(o1);
            return;
        }
        self.walk((t0, n0), (t, n), out);
        self.walk((t, n), (t1, n1), out);
    }
}

impl Truth {
    /// Vertices of the parallel, its chords within about `step` of it.
    pub(crate) fn new(points: &[DVec2], distance: f64, step: f64) -> Self {
        let hodograph = differences(points);
        let fastest = hodograph.iter().map(|v| v.length()).fold(0.0, f64::max);
        let walker = Walker {
            points,
            hodograph,
            fastest,
            distance,
            step,
        };
        let (first, last) = (walker.tangent(0.0, 1.0), walker.tangent(1.0, -1.0));
        let mut vertices = vec![points[0] + first.perp() * distance];
        walker.walk((0.0, first), (1.0, last), &mut vertices);
        Self { vertices }
    }

    /// The greatest distance of some points, which follow the polyline, from it.
    pub(crate) fn farthest(&self, points: &[DVec2], enough: f64) -> f64 {
        farthest(&self.vertices, points, enough)
    }
}

fn from_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let chord = b - a;
    let square = chord.length_squared();
    let s = if square > 0.0 {
        ((p - a).dot(chord) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p - (a + chord * s)).length()
}

/// Each point is looked for next to where the one before it was found; only if that fails, everywhere.
pub(crate) fn farthest(line: &[DVec2], points: &[DVec2], enough: f64) -> f64 {
    let mut place: usize = 0;
    let mut most: f64 = 0.0;
    let last = line.len() - 2;
    for &p in points {
        let mut best = f64::INFINITY;
        let mut here = place;
        let mut k = place.saturating_sub(8);
        while k <= last && k <= here + 24 {
            let distance = from_segment(p, line[k], line[k + 1]);
            if distance < best {
                (best, here) = (distance, k);
            }
            k += 1;
        }
        if best > enough {
            for k in 0..=last {
                let distance = from_segment(p, line[k], line[k + 1]);
                if distance < best {
                    (best, here) = (distance, k);
                }
            }
        }
        place = here;
        most = most.max(best);
    }
    most
}

/// Points of each segment, chords between them within `sag`.
pub(crate) fn dense(spline: &casteljau::Spline<DVec2>, sag: f64) -> Vec<DVec2> {
    let mut points = Vec::new();
    for curve in spline.segments() {
        let p = curve.control_points();
        let bend = p
            .windows(3)
            .map(|p| (p[0] + p[2] - p[1] * 2.0).length())
            .fold(0.0, f64::max);
        let n = real(p.len() - 1);
        let steps = (n * (n - 1.0) * bend / (8.0 * sag))
            .sqrt()
            .ceil()
            .clamp(4.0, 1000.0);
        let mut k = 0.0;
        while k <= steps {
            points.push(curve.eval(k / steps));
            k += 1.0;
        }
    }
    points
}
