//! The convex hull of the control points.

use super::Curve;
use glam::DVec2;

impl Curve<DVec2> {
    /// The corners of the convex hull of the control points, counter-clockwise (x right, y up), from the leftmost.
    ///
    /// The curve lies inside. Points on a side are left out; collinear control points give the two outermost,
    /// coincident ones a single point. Source: Andrew, "Another efficient algorithm for convex hulls", 1979.
    pub fn hull(&self) -> Vec<DVec2> {
        let scale = self.max_abs().max(f64::MIN_POSITIVE);
        let mut sorted = self.points.to_vec();
        sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        sorted.dedup();
        if sorted.len() < 3 {
            return sorted;
        }
        let mut corners = half_hull(sorted.iter().copied(), scale);
        corners.pop();
        corners.extend(half_hull(sorted.iter().rev().copied(), scale));
        corners.pop();
        corners
    }
}

/// One chain of the hull: only left turns, both ends kept.
fn half_hull(points: impl Iterator<Item = DVec2>, scale: f64) -> Vec<DVec2> {
    let mut chain: Vec<DVec2> = Vec::new();
    for p in points {
        while let [.., a, b] = chain[..] {
            // Divided by the scale, the product of two differences cannot leave the range of f64.
            if ((b - a) / scale).perp_dot((p - a) / scale) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(p);
    }
    chain
}
