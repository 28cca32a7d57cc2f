//! Is a point inside?
//!
//! The winding number counts how often the outline runs around the point, counter-clockwise (x right, y up) positive. A
//! ray runs from the point to the right; an outline that crosses it upwards counts +1, downwards −1.
//!
//! "Above" means y > p.y, and a piece crosses the ray's line upwards if it starts not above and ends above. So a
//! joint, an extremum or a horizontal line at the height of the point needs no special case: whatever touches the line
//! and goes back has not crossed it. What lies on one side of the point altogether is decided by its control points;
//! only the piece that has the point in its box is halved, and both halves share their middle, bit for bit, so that no
//! rounding can open the outline.

use super::Path;
use crate::geometry::check::max_abs;
use crate::numeric::float::ulp;
use crate::numeric::list::{Points, points_of};
use glam::DVec2;

/// Which windings count as inside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum FillRule {
    /// All but 0.
    #[default]
    NonZero,
    /// The odd ones.
    EvenOdd,
}

/// Pieces of so many ulps of the segment's largest coordinate are lines: halving them moves points by as much.
const SMALLEST_ULPS: f64 = 4.0;
/// After so many halvings a piece has 2⁻⁶⁴ of the segment's parameters.
const MAX_HALVINGS: u32 = 64;
/// So many halvings of one segment find every crossing that f64 can tell apart: 64 for each of the 64 at most.
const MAX_PIECES: u32 = 4096;
/// The determinant of two differences each is certain to so many times ε of its terms. Source: Shewchuk, "Adaptive
/// precision floating-point arithmetic", 1997, (3 + 16ε)ε.
const CERTAIN: f64 = 4.0 * f64::EPSILON;

impl Path {
    /// How often the path runs around a point: counter-clockwise positive (x right, y up; the other way round on a
    /// canvas). Open subpaths are closed by a line, as filling does.
    ///
    /// On the boundary the point counts as if it lay a little to the right and above; of two regions that share a segment,
    /// each in its own direction, exactly one has the points on it. For a NaN 0.
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

    /// Whether the path, filled by that rule, covers a point; see [`winding_number`](Self::winding_number) for the boundary.
    pub fn contains(&self, p: DVec2, rule: FillRule) -> bool {
        let winding = self.winding_number(p);
        match rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding % 2 != 0,
        }
    }
}

/// The upward less the downward crossings of a curve with the ray from p to the right.
fn crossings(points: &[DVec2], p: DVec2) -> i32 {
    match by_box(points, p) {
        Some(count) => count,
        None => Search {
            p,
            min: SMALLEST_ULPS * ulp(max_abs(points)),
            pieces: MAX_PIECES,
        }
        .crossings(points, MAX_HALVINGS),
    }
}

/// The same, where all control points lie on one side of p.
#[inline]
fn by_box(points: &[DVec2], p: DVec2) -> Option<i32> {
    let above = points.iter().filter(|q| q.y > p.y).count();
    if above == 0 || above == points.len() {
        return Some(0);
    }
    let right = points.iter().filter(|q| q.x > p.x).count();
    match right {
        0 => Some(0),
        _ if right == points.len() => Some(across(points, p)),
        _ => None,
    }
}

/// The crossings of the whole line through p, which depend on the ends alone.
fn across(points: &[DVec2], p: DVec2) -> i32 {
    let above = |q: DVec2| i32::from(q.y > p.y);
    above(points[points.len() - 1]) - above(points[0])
}

struct Search {
    p: DVec2,
    /// Pieces of this size are lines.
    min: f64,
    /// How many more may be halved.
    pieces: u32,
}

impl Search {
    fn crossings(&mut self, points: &[DVec2], halvings: u32) -> i32 {
        if let Some(count) = by_box(points, self.p) {
            return count;
        }
        let side = self.side(points);
        let small = |q: &DVec2| (*q - self.p).abs().max_element() <= self.min;
        let decided = points.len() == 2 && side.is_some();
        if decided || halvings == 0 || self.pieces == 0 || points.iter().all(small) {
            let across = across(points, self.p);
            return if across.signum() == side.unwrap_or(0) {
                across
            } else {
                0
            };
        }
        self.pieces -= 1;
        let (left, right) = halves(points);
        self.crossings(&left, halvings - 1) + self.crossings(&right, halvings - 1)
    }

    /// 1 where p lies to the left of the line from start to end, −1 to the right of it, where that is certain.
    fn side(&self, points: &[DVec2]) -> Option<i32> {
        let (a, b) = (points[0], points[points.len() - 1]);
        // Always from the same end, so that the two directions of a segment are never judged differently.
        let swapped = (b.y, b.x) < (a.y, a.x);
        let (a, b) = if swapped { (b, a) } else { (a, b) };
        let (chord, to_point) = (b - a, self.p - a);
        let (one, other) = (chord.x * to_point.y, chord.y * to_point.x);
        let side = one - other;
        let certain = side.abs() > CERTAIN * (one.abs() + other.abs());
        certain.then_some(if (side > 0.0) == swapped { -1 } else { 1 })
    }
}

fn halves(points: &[DVec2]) -> (Points<DVec2>, Points<DVec2>) {
    let (mut left, mut right) = (points_of(points), points_of(points));
    for (level, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for i in 1..points.len() - level {
            right[i - 1] = right[i - 1] * 0.5 + right[i] * 0.5;
        }
    }
    (left, right)
}
