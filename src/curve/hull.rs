//! The convex hull of the control points.

use super::Curve;
use glam::DVec2;

impl Curve<DVec2> {
    /// The vertices of the convex hull of the control points, counter-clockwise (x right, y up), starting with the
    /// leftmost.
    ///
    /// The curve lies inside. Points on an edge are left out; collinear control points give the two outermost,
    /// coincident ones a single point. Source: Andrew, "Another efficient algorithm for convex hulls", 1979.
    pub fn hull(&self) -> Vec<DVec2> {
        let scale = self.max_abs().max(f64::MIN_POSITIVE);
        let sorted = sorted_without_repeats(&self.points);
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

/// The points ordered by x, then by y, without duplicates. For at most 65 points, insertion is as fast as a sort with
/// much less code.
fn sorted_without_repeats(points: &[DVec2]) -> Vec<DVec2> {
    let mut sorted: Vec<DVec2> = Vec::with_capacity(points.len());
    for &p in points {
        let at = sorted.partition_point(|q| (q.x, q.y) < (p.x, p.y));
        if sorted.get(at) != Some(&p) {
            sorted.insert(at, p);
        }
    }
    sorted
}

/// The lower or upper half of the hull (Andrew's monotone chain): only left turns, both ends kept.
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
