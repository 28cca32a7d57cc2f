//! Winding numbers by halving control polygons; independent of the code under test.

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
            curves.extend(
                spline
                    .segments()
                    .map(|curve| curve.control_points().to_vec()),
            );
            let (first, last) = (
                curves[start][0],
                *curves.last().and_then(|c| c.last()).expect("points"),
            );
            curves.push(vec![last, first]);
        }
        Self { curves }
    }

    /// Points spread over the outline.
    pub(crate) fn samples(&self, count: usize) -> Vec<DVec2> {
        let ts = (0..count).map(|k| k as f64 / count as f64);
        let all = self
            .curves
            .iter()
            .flat_map(|curve| ts.clone().map(|t| point_at(curve, t)));
        all.collect()
    }

    /// The winding number around p: upward minus downward crossings to the right of p.
    pub(crate) fn winding(&self, p: DVec2) -> i32 {
        self.curves
            .iter()
            .map(|curve| crossings(curve, p, HALVINGS))
            .sum()
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

fn point_at(curve: &[DVec2], t: f64) -> DVec2 {
    let mut level = curve.to_vec();
    while level.len() > 1 {
        level = level
            .windows(2)
            .map(|q| q[0] * (1.0 - t) + q[1] * t)
            .collect();
    }
    level[0]
}
