//! Curves that are straight, all control points being on one line.

use super::roots::roots_inside;
use super::{Curve, Scalars, ulp};
use crate::point::Point;
use glam::DVec2;

/// Control points this close to a line, in ulps of the largest coordinate, are on it, but for curves so short that this
/// would be much of their length.
const ULPS: f64 = 4.0;
const LARGEST_PART: f64 = 1e-10;

impl Curve<DVec2> {
    /// The unit vector along a straight curve, from its start to its farthest control point; `None` if it bends or is a
    /// point.
    pub(crate) fn straight_way(&self) -> Option<DVec2> {
        let start = self.start() * 0.5;
        let from_start = |p: &DVec2| *p * 0.5 - start;
        let far = self
            .points
            .iter()
            .map(from_start)
            .fold(DVec2::ZERO, |far, v| {
                if Point::max_abs(v) > Point::max_abs(far) {
                    v
                } else {
                    far
                }
            });
        let way = far.unit();
        let noise = (ULPS * ulp(0.5 * self.max_abs())).min(LARGEST_PART * far.norm());
        let across = |p: &DVec2| way.perp_dot(from_start(p)).abs();
        let straight = way != DVec2::ZERO && self.points.iter().all(|p| across(p) <= noise);
        straight.then_some(way)
    }

    /// The parameters inside (0, 1) at which the curve stops along a direction, sorted.
    pub(crate) fn turns_along(&self, way: DVec2) -> Scalars {
        let slopes: Scalars = self
            .points
            .windows(2)
            .map(|pair| (pair[1] * 0.5 - pair[0] * 0.5).dot(way))
            .collect();
        roots_inside(&slopes)
    }
}
