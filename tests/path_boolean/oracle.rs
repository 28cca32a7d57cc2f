//! Winding numbers and distances by halving control polygons; independent of the code under test.

use crate::support::de_casteljau;
use crate::support::measure::from_segment;
use casteljau::Path;
use casteljau::glam::DVec2;

/// After this many halvings a part counts as its chord.
const HALVINGS: usize = 60;

/// The curves of all subpaths, closed by lines.
pub(crate) struct Outline {
    curves: Vec<Vec<DVec2>>,
}

impl Outline {
    pub(crate) fn new(path: &Path) -> Self {
        let mut curves = Vec::new();
        for spline in path.subpaths() {
            let start = curves.len();
            let segments = spline.segments();
            curves.extend(segments.map(|curve| curve.control_points().to_vec()));
            let last = curves.last().and_then(|curve: &Vec<DVec2>| curve.last());
            curves.push(vec![*last.expect("points"), curves[start][0]]);
        }
        Self { curves }
    }

    /// Points spread over the outline.
    pub(crate) fn samples(&self, count: usize) -> Vec<DVec2> {
        let ts = (0..count).map(|k| k as f64 / count as f64);
        let curves = self.curves.iter();
        curves
            .flat_map(|curve| ts.clone().map(|t| de_casteljau(curve, t)))
            .collect()
    }

    /// The winding number around p: upward minus downward crossings to the right of p.
    pub(crate) fn winding(&self, p: DVec2) -> i32 {
        let curves = self.curves.iter();
        curves.map(|curve| crossings(curve, p, HALVINGS)).sum()
    }

    /// Whether p may be within a distance of the outline. The answer is right unless the distance of p is between this
    /// one and 1.1 times this one.
    pub(crate) fn is_near(&self, p: DVec2, distance: f64) -> bool {
        let mut curves = self.curves.iter();
        curves.any(|curve| is_near(curve, p, distance, HALVINGS))
    }
}

fn crossings(curve: &[DVec2], p: DVec2, halvings: usize) -> i32 {
    let (first, last) = (curve[0], curve[curve.len() - 1]);
    let rise = i32::from(last.y > p.y) - i32::from(first.y > p.y);
    if curve.iter().all(|q| q.y > p.y) || curve.iter().all(|q| q.y <= p.y) {
        return 0;
    }
    if curve.iter().all(|q| q.x <= p.x) {
        return 0;
    }
    if curve.iter().all(|q| q.x > p.x) {
        return rise;
    }
    if curve.len() == 2 || halvings == 0 {
        let side = (last - first).perp_dot(p - first) * f64::from(rise);
        return if side > 0.0 { rise } else { 0 };
    }
    let (before, after) = halves(curve);
    crossings(&before, p, halvings - 1) + crossings(&after, p, halvings - 1)
}

/// Both halves of a curve, by repeated interpolation.
fn halves(curve: &[DVec2]) -> (Vec<DVec2>, Vec<DVec2>) {
    let (mut before, mut after) = (Vec::new(), Vec::new());
    let mut level = curve.to_vec();
    loop {
        before.push(level[0]);
        after.push(level[level.len() - 1]);
        if level.len() == 1 {
            break;
        }
        level = level.windows(2).map(|q| (q[0] + q[1]) * 0.5).collect();
    }
    after.reverse();
    (before, after)
}

/// The hull is in the box of the control points.
fn is_near(curve: &[DVec2], p: DVec2, distance: f64, halvings: usize) -> bool {
    if let [a, b] = *curve {
        return from_segment(p, a, b) <= distance;
    }
    let min = curve.iter().copied().reduce(DVec2::min).expect("points");
    let max = curve.iter().copied().reduce(DVec2::max).expect("points");
    if p.distance(p.clamp(min, max)) > distance {
        return false;
    }
    if min.distance(max) <= 0.1 * distance || halvings == 0 {
        return true;
    }
    let (before, after) = halves(curve);
    let is_near = |half: &[DVec2]| is_near(half, p, distance, halvings - 1);
    is_near(&before) || is_near(&after)
}
