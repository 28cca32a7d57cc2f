//! Recursive subdivision at t = ½ as a tree, for teaching.

use super::Curve;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;

/// Maximum number of leaves of a tree.
const MAX_LEAVES: usize = 1 << 16;

/// A node of the tree of recursive halving: a segment of the curve.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Subdivision<P: Point> {
    /// The segment.
    pub curve: Curve<P>,
    /// The parameter of its start on the whole curve.
    pub t0: f64,
    /// The parameter of its end on the whole curve.
    pub t1: f64,
    /// D1, the length of its control polygon.
    pub polygon_length: f64,
    /// D2, the length of its chord.
    pub chord_length: f64,
    /// The two halves; `None` for a leaf, which counts as straight.
    pub halves: Option<Box<[Subdivision<P>; 2]>>,
}

impl<P: Point> Subdivision<P> {
    /// A bound on the distance of the segment from its chord: ½√(D1² − D2²).
    ///
    /// The polygon, and with it the curve, lies in the ellipse whose foci are the ends of the chord and whose distances
    /// sum to D1. D1 − D2 itself is not a distance.
    pub fn deviation_bound(&self) -> f64 {
        let (d1, d2) = (self.polygon_length, self.chord_length);
        0.5 * ((d1 - d2).max(0.0) * (d1 + d2)).sqrt()
    }

    /// The leaves from start to end; their chords are the polyline of the recursion.
    pub fn leaves(&self) -> Vec<&Self> {
        match &self.halves {
            None => vec![self],
            Some(halves) => halves.iter().flat_map(Self::leaves).collect(),
        }
    }
}

impl<P: Point> Curve<P> {
    /// Halves the curve until D1 − D2 < `tolerance` for every segment, where D1 is the length of its control polygon
    /// and D2 the length of its chord.
    ///
    /// This is for teaching: D1 − D2 is not a distance. [`Subdivision::deviation_bound`] bounds the distance, and
    /// [`flatten`](Self::flatten) guarantees a tolerance. Source: Angel and Shreiner, *Interactive Computer Graphics*,
    /// 7th ed., §10.
    ///
    /// # Errors
    /// Same as [`flatten`](Self::flatten) for the tolerance; [`Error::TooMany`] above 2¹⁶ leaves.
    pub fn subdivide(&self, tolerance: f64) -> Result<Subdivision<P>, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        let mut leaves = 0;
        grow(self.clone(), 0.0, 1.0, tolerance, &mut leaves).ok_or(Error::too_many(
            "leaves",
            MAX_LEAVES,
            MAX_LEAVES + 1,
        ))
    }
}

/// The tree of one segment; `None` if there are too many leaves. The depth is limited by the halvings of t, at most
/// 1100; in practice it is below 60, since the length halves with t.
fn grow<P: Point>(
    curve: Curve<P>,
    t0: f64,
    t1: f64,
    tolerance: f64,
    leaves: &mut usize,
) -> Option<Subdivision<P>> {
    let polygon_length = curve
        .control_points()
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).norm())
        .sum::<f64>();
    let chord_length = (curve.end() - curve.start()).norm();
    let middle = 0.5 * (t0 + t1);
    let straight = polygon_length - chord_length < tolerance || middle <= t0 || middle >= t1;
    let halves = if straight {
        *leaves += 1;
        None
    } else {
        let (left, right) = curve.halve();
        let left = grow(left, t0, middle, tolerance, leaves)?;
        let right = grow(right, middle, t1, tolerance, leaves)?;
        Some(Box::new([left, right]))
    };
    (*leaves <= MAX_LEAVES).then_some(Subdivision {
        curve,
        t0,
        t1,
        polygon_length,
        chord_length,
        halves,
    })
}
