//! Winding numbers of densely sampled outlines; independent of the code under test.

use casteljau::Path;
use casteljau::glam::DVec2;

/// The number of chords of a curved segment.
const CHORDS: usize = 96;

/// Closed polylines, and the largest distance of a point of the outline from its polyline.
pub(crate) struct Outline {
    lines: Vec<Vec<DVec2>>,
    pub(crate) error: f64,
}

impl Outline {
    pub(crate) fn new(path: &Path) -> Self {
        let (mut lines, mut error) = (Vec::new(), 0.0_f64);
        for spline in path.subpaths() {
            let mut line = vec![spline.control_points()[0]];
            for curve in spline.segments() {
                let points = curve.control_points().to_vec();
                let chords = if points.len() == 2 { 1 } else { CHORDS };
                line.extend((1..=chords).map(|k| casteljau(&points, k as f64 / chords as f64)));
                error = error.max(deviation(&points, chords));
            }
            lines.push(line);
        }
        Self { lines, error }
    }

    fn chords(&self) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
        self.lines
            .iter()
            .flat_map(|line| (0..line.len()).map(move |k| (line[k], line[(k + 1) % line.len()])))
    }

    /// The vertices of all polylines.
    pub(crate) fn vertices(&self) -> Vec<DVec2> {
        self.lines.iter().flatten().copied().collect()
    }

    pub(crate) fn distance(&self, p: DVec2) -> f64 {
        let to_chord = |(a, b): (DVec2, DVec2)| {
            let along = b - a;
            let t = (p - a).dot(along) / along.dot(along);
            let nearest = if t > 0.0 { a + along * t.min(1.0) } else { a };
            p.distance_squared(nearest)
        };
        self.chords()
            .map(to_chord)
            .fold(f64::INFINITY, f64::min)
            .sqrt()
    }

    pub(crate) fn winding(&self, p: DVec2) -> i32 {
        let crossing = |(a, b): (DVec2, DVec2)| {
            let side = (b - a).perp_dot(p - a);
            i32::from(a.y <= p.y && b.y > p.y && side > 0.0)
                - i32::from(a.y > p.y && b.y <= p.y && side < 0.0)
        };
        self.chords().map(crossing).sum()
    }
}

/// The point of a curve by repeated linear interpolation.
fn casteljau(points: &[DVec2], t: f64) -> DVec2 {
    let mut level = points.to_vec();
    while level.len() > 1 {
        level = level
            .windows(2)
            .map(|p| p[0] * (1.0 - t) + p[1] * t)
            .collect();
    }
    level[0]
}

/// The distance of a curve from its chords: h²/8 · max |B″|.
fn deviation(points: &[DVec2], chords: usize) -> f64 {
    let n = (points.len() - 1) as f64;
    let second = points
        .windows(3)
        .map(|p| (p[2] - p[1] * 2.0 + p[0]).length());
    let most = second.fold(0.0, f64::max) * n * (n - 1.0);
    most / (8.0 * (chords * chords) as f64)
}
