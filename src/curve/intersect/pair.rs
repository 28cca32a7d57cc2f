//! Normalization of a pair of curves to a common origin and size 1.

use super::constants::{INPUT_ROUNDING, MAX_PAIRS, MAX_PAIRS_PER_DEGREE, STEP_ROUNDING};
use super::intersection::IntersectionKind;
use crate::curve::elevate::elevate_once;
use crate::curve::hodograph::derivative_zeros;
use crate::geometry::bounds::Bounds;
use crate::numeric::float::unit_scale;
use crate::numeric::list::{Points, Scalars};
use casteljau_kernels::curve::intersect::clipping::Contact;
use casteljau_kernels::curve::intersect::clipping::{ClippingSolver, Piece, intersect_cubics};
use glam::DVec2;

/// The parameters of an intersection, and its kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClassifiedContact {
    pub(crate) t: f64,
    pub(crate) u: f64,
    pub(crate) kind: IntersectionKind,
}

impl ClassifiedContact {
    pub(crate) fn new((t, u): (f64, f64), kind: IntersectionKind) -> Self {
        Self { t, u, kind }
    }

    /// The parameters on both curves.
    pub(crate) fn times(&self) -> (f64, f64) {
        (self.t, self.u)
    }

    /// Whether the intersection is a single point and not an overlap.
    pub(crate) fn is_point(&self) -> bool {
        !matches!(self.kind, IntersectionKind::Overlap { .. })
    }
}

/// Two curves translated to the origin and scaled to a size between ½ and 1.
pub(crate) struct NormalizedPair {
    pub(crate) curves: [Points<DVec2>; 2],
    /// Points closer than this are equal.
    pub(crate) slack: f64,
    /// Parameters where the derivative vanishes: cusps, and reversals of a straight curve.
    pub(crate) derivative_zeros: [Scalars; 2],
}

impl NormalizedPair {
    /// `None` if the boxes of the control points do not overlap, and for coordinates that are not finite.
    pub(crate) fn new(a: &[DVec2], b: &[DVec2]) -> Option<Self> {
        let (box_a, box_b) = (Bounds::from_points(a), Bounds::from_points(b));
        let Bounds { min, max } = box_a.union(box_b);
        let largest = min.abs().max(max.abs()).max_element();
        let nearest = INPUT_ROUNDING * largest;
        let gap = box_a.min.max(box_b.min) - box_a.max.min(box_b.max);
        if gap.max_element() > nearest {
            return None;
        }
        let origin = a[0];
        let spread = (max - origin).abs().max((min - origin).abs());
        // A power of two does not round; the spread times the scale is between ½ and 1.
        let scale = 0.5 * unit_scale(spread.max_element());
        let normalized = |p: &DVec2| (*p - origin) * scale;
        let degree = (a.len().max(b.len()) - 1) as f64;
        let (a, b): (Points<DVec2>, Points<DVec2>) = (
            a.iter().map(normalized).collect(),
            b.iter().map(normalized).collect(),
        );
        // Differences of finite coordinates may overflow.
        if !a.iter().chain(&b).all(|p| p.is_finite()) {
            return None;
        }
        Some(Self {
            derivative_zeros: [derivative_zeros(&a), derivative_zeros(&b)],
            curves: [a, b],
            slack: INPUT_ROUNDING * (largest * scale) + STEP_ROUNDING * (1.0 + degree),
        })
    }

    /// The contacts of the given pairs of segments, unsorted, and the number of steps of the search; the segments lie
    /// between cuts.
    pub(crate) fn search(
        &self,
        cuts_a: &[f64],
        cuts_b: &[f64],
        pairs: impl IntoIterator<Item = (usize, usize)>,
    ) -> (Vec<Contact>, usize) {
        let [a, b] = &self.curves;
        let degree = a.len().max(b.len()) - 1;
        if degree <= 3 {
            // Lower degrees are elevated to 3, for which the search is compiled with arrays.
            let whole = [cubic(a), cubic(b)];
            let mut solver = ClippingSolver::new(whole, self.slack, MAX_PAIRS);
            for (i, j) in pairs {
                intersect_cubics(
                    &mut solver,
                    [cuts_a[i], cuts_a[i + 1]],
                    [cuts_b[j], cuts_b[j + 1]],
                );
            }
            return (solver.found, solver.work.used());
        }
        let whole = [piece(a, degree), piece(b, degree)];
        let mut solver = ClippingSolver::new(
            whole,
            self.slack,
            MAX_PAIRS + MAX_PAIRS_PER_DEGREE * (degree - 3),
        );
        for (i, j) in pairs {
            solver.run([cuts_a[i], cuts_a[i + 1]], [cuts_b[j], cuts_b[j + 1]]);
        }
        (solver.found, solver.work.used())
    }
}

fn cubic(points: &[DVec2]) -> Piece<[f64; 4]> {
    let p = |i: usize| points[i];
    let points = match points.len() {
        2 => [
            p(0),
            p(0).lerp(p(1), 1.0 / 3.0),
            p(1).lerp(p(0), 1.0 / 3.0),
            p(1),
        ],
        3 => [
            p(0),
            (p(0) + p(1) * 2.0) / 3.0,
            (p(2) + p(1) * 2.0) / 3.0,
            p(2),
        ],
        _ => [p(0), p(1), p(2), p(3)],
    };
    Piece {
        x: points.map(|p| p.x),
        y: points.map(|p| p.y),
        from: 0.0,
        to: 1.0,
    }
}

/// The curve elevated to a given degree.
fn piece(points: &[DVec2], degree: usize) -> Piece<Vec<f64>> {
    let mut points = Points::from(points);
    while points.len() <= degree {
        elevate_once(&mut points);
    }
    Piece {
        x: points.iter().map(|p| p.x).collect(),
        y: points.iter().map(|p| p.y).collect(),
        from: 0.0,
        to: 1.0,
    }
}

/// Insertion sort: the lists are short, or nearly sorted.
pub(crate) fn sort(
    locations: &mut [ClassifiedContact],
    before: impl Fn(&ClassifiedContact, &ClassifiedContact) -> bool,
) {
    for k in 1..locations.len() {
        let mut i = k;
        while i > 0 && before(&locations[i], &locations[i - 1]) {
            locations.swap(i, i - 1);
            i -= 1;
        }
    }
}
