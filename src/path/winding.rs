//! Winding number and point-in-path test.
//!
//! The winding number counts how often the outline winds around the point; counter-clockwise (x right, y up) is
//! positive. It is the number of crossings of the outline with the ray from the point to the right: +1 for an upward
//! crossing, −1 for a downward crossing.
//!
//! "Above" means y > p.y. A part of a curve crosses the line of the ray upwards if it starts not above and ends above.
//! So a joint, an extremum or a horizontal line at the height of the point needs no special case: a curve that touches
//! the line and turns back does not cross it. If all control points lie on one side of the point, they decide the
//! crossings. Only a part whose box contains the point is halved; both halves share their midpoint bit for bit, so
//! rounding cannot open the outline.

use super::Path;
use crate::geometry::check::max_abs;
use crate::numeric::float::ulp;
use crate::numeric::list::{Points, points_of};
use casteljau_kernels::bernstein::de_casteljau::split;
use glam::DVec2;

/// The rule that decides which winding numbers are inside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum FillRule {
    /// All except 0.
    #[default]
    NonZero,
    /// Odd winding numbers.
    EvenOdd,
}

impl FillRule {
    /// Whether points with a winding number are inside.
    pub(crate) fn is_inside(self, winding: i32) -> bool {
        match self {
            Self::NonZero => winding != 0,
            Self::EvenOdd => winding % 2 != 0,
        }
    }
}

/// Parts smaller than this many ulps of the segment's largest coordinate count as lines; halving moves points by as
/// much.
const SMALLEST_ULPS: f64 = 4.0;
/// After this many halvings a part covers 2⁻⁶⁴ of the parameter range: more than the 53 bits of a parameter.
const MAX_DEPTH: u32 = 64;
/// The maximum number of halvings per segment, enough for every crossing that f64 can distinguish: 64 for each of at
/// most 64 crossings.
const MAX_PIECES: u32 = 64 * MAX_DEPTH;
/// A determinant of rounded differences has the right sign if it exceeds this ratio of the sum of its terms. Source:
/// Shewchuk, "Adaptive precision floating-point arithmetic", 1997, (3 + 16ε)ε.
const SIDE_ROUNDING: f64 = 4.0 * f64::EPSILON;

impl Path {
    /// The winding number of the path around a point: counter-clockwise is positive (x right, y up; clockwise on a
    /// canvas). Open subpaths are closed by a line, as for filling.
    ///
    /// A point on the boundary counts as slightly displaced to the right and upwards; if two regions share a segment in
    /// opposite directions, each of its points belongs to exactly one of them. For a NaN the result is 0.
    ///
    /// Source of the crossing rule: Haines, "Point in polygon strategies", *Graphics Gems IV* (1994).
    pub fn winding_number(&self, p: DVec2) -> i32 {
        self.parts()
            .map(|part| {
                let (start, end) = part.ends();
                let around: i32 = part.segments().map(|points| crossings(points, p)).sum();
                around + crossings(&[end, start], p)
            })
            .sum()
    }

    /// Whether the path, filled by `rule`, contains a point; see [`winding_number`](Self::winding_number) for the
    /// boundary.
    pub fn contains(&self, p: DVec2, rule: FillRule) -> bool {
        rule.is_inside(self.winding_number(p))
    }
}

/// The number of upward minus downward crossings of a curve with the ray from p to the right.
pub(crate) fn crossings(points: &[DVec2], p: DVec2) -> i32 {
    match crossings_by_box(points, p) {
        Some(count) => count,
        None => CrossingCounter {
            p,
            min: SMALLEST_ULPS * ulp(max_abs(points)),
            pieces: MAX_PIECES,
        }
        .crossings(points, MAX_DEPTH),
    }
}

/// The crossings if all control points lie on one side of p, otherwise `None`.
#[inline]
fn crossings_by_box(points: &[DVec2], p: DVec2) -> Option<i32> {
    let above = points.iter().filter(|q| q.y > p.y).count();
    if above == 0 || above == points.len() {
        return Some(0);
    }
    let right = points.iter().filter(|q| q.x > p.x).count();
    match right {
        0 => Some(0),
        _ if right == points.len() => Some(crossings_by_ends(points, p)),
        _ => None,
    }
}

/// The crossings with the whole horizontal line through p, which depend only on the ends.
fn crossings_by_ends(points: &[DVec2], p: DVec2) -> i32 {
    let above = |q: DVec2| i32::from(q.y > p.y);
    above(points[points.len() - 1]) - above(points[0])
}

struct CrossingCounter {
    p: DVec2,
    /// Parts of at most this size count as lines.
    min: f64,
    /// The number of halvings that are left.
    pieces: u32,
}

impl CrossingCounter {
    fn crossings(&mut self, points: &[DVec2], halvings: u32) -> i32 {
        if let Some(count) = crossings_by_box(points, self.p) {
            return count;
        }
        let side = self.side(points);
        let small = |q: &DVec2| (*q - self.p).abs().max_element() <= self.min;
        let decided = points.len() == 2 && side.is_some();
        if decided || halvings == 0 || self.pieces == 0 || points.iter().all(small) {
            let count = crossings_by_ends(points, self.p);
            return if count.signum() == side.unwrap_or(0) {
                count
            } else {
                0
            };
        }
        self.pieces -= 1;
        let (left, right) = halves(points);
        self.crossings(&left, halvings - 1) + self.crossings(&right, halvings - 1)
    }

    /// 1 if p lies to the left of the line from start to end, −1 if to the right, `None` if rounding makes it
    /// uncertain.
    fn side(&self, points: &[DVec2]) -> Option<i32> {
        let (a, b) = (points[0], points[points.len() - 1]);
        // Use a canonical order of the ends, so that both directions of a segment give the same decision.
        let swapped = (b.y, b.x) < (a.y, a.x);
        let (a, b) = if swapped { (b, a) } else { (a, b) };
        let (chord, to_point) = (b - a, self.p - a);
        let (one, other) = (chord.x * to_point.y, chord.y * to_point.x);
        let side = one - other;
        let certain = side.abs() > SIDE_ROUNDING * (one.abs() + other.abs());
        certain.then_some(if (side > 0.0) == swapped { -1 } else { 1 })
    }
}

fn halves(points: &[DVec2]) -> (Points<DVec2>, Points<DVec2>) {
    let (mut left, mut right) = (points_of(points), points_of(points));
    split(&mut left, &mut right, 0.5);
    (left, right)
}
