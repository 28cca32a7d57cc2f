//! Normalization of a pair of curves to a common origin and size 1.

use super::constants::{INPUT_ROUNDING, STEP_ROUNDING};
use super::intersection::{Intersection, IntersectionKind};
use super::plane_curve::PlaneCurve;
use crate::geometry::bounds::Bounds;
use crate::numeric::float::unit_scale;
use crate::numeric::list::Scalars;
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

    /// The intersection of two curves that are given as functions. Its point is the exact end point if a curve ends there.
    pub(crate) fn on(self, a: impl Fn(f64) -> DVec2, b: impl Fn(f64) -> DVec2) -> Intersection {
        let Self { t, u, kind } = self;
        let ends = |t: f64| t == 0.0 || t == 1.0;
        let point = if ends(u) && !ends(t) { b(u) } else { a(t) };
        Intersection { t, u, point, kind }
    }

    /// Whether the intersection is a single point and not an overlap.
    pub(crate) fn is_point(&self) -> bool {
        !matches!(self.kind, IntersectionKind::Overlap { .. })
    }
}

/// Two curves translated to the origin and scaled to a size between ½ and 1.
pub(crate) struct NormalizedPair<S> {
    pub(crate) curves: [S; 2],
    /// Points closer than this are equal.
    pub(crate) slack: f64,
    /// Parameters where the derivative vanishes: cusps, and reversals of a straight curve.
    pub(crate) derivative_zeros: [Scalars; 2],
}

impl<S: PlaneCurve> NormalizedPair<S> {
    /// `None` if the boxes of the control points do not overlap, and for coordinates that are not finite.
    pub(crate) fn new(a: &S, b: &S) -> Option<Self> {
        let [box_a, box_b] = [a, b].map(|curve| Bounds::from_points(curve.points()));
        let Bounds { min, max } = box_a.union(box_b);
        let largest = min.abs().max(max.abs()).max_element();
        let nearest = INPUT_ROUNDING * largest;
        let gap = box_a.min.max(box_b.min) - box_a.max.min(box_b.max);
        if gap.max_element() > nearest {
            return None;
        }
        let origin = a.points()[0];
        let spread = (max - origin).abs().max((min - origin).abs());
        // A power of two does not round; the spread times the scale is between ½ and 1.
        let scale = 0.5 * unit_scale(spread.max_element());
        let degree = (a.points().len().max(b.points().len()) - 1) as f64;
        let curves = [a, b].map(|curve| curve.normalized(origin, scale));
        // Differences of finite coordinates may overflow.
        let is_finite = |curve: &S| curve.points().iter().all(|p| p.is_finite());
        if !curves.iter().all(is_finite) {
            return None;
        }
        Some(Self {
            derivative_zeros: curves.each_ref().map(PlaneCurve::derivative_zeros),
            curves,
            slack: INPUT_ROUNDING * (largest * scale)
                + STEP_ROUNDING * S::ROUNDING * (1.0 + degree),
        })
    }

    /// The point of one of the curves at t.
    pub(crate) fn point(&self, curve: usize, t: f64) -> DVec2 {
        self.curves[curve].at(t)
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
