//! The hodograph of a curve: the control vectors of B′, its zeros, and the tangents at both ends.
//!
//! A zero of B′ is a cusp if the direction reverses there. Curves in the plane and in space have one search for cusps; intersections and
//! offset curves need all zeros, in the plane. Whether the control points of a curve lie on a line: `straight.rs`.

use super::Curve;
use crate::bernstein::evaluate::evaluate;
use crate::bernstein::product::product_of;
use crate::bernstein::roots::{DOUBLE_ROOT, roots_inside};
use crate::geometry::check::max_abs;
use crate::geometry::point::Point;
use crate::numeric::float::unit_scale;
use crate::numeric::list::{Points, Scalars};
use crate::numeric::sort::sort_by;
use glam::DVec2;

/// The step in t on both sides of a zero of B′ at which the incoming and the outgoing direction are compared.
const CUSP_PROBE_STEP: f64 = 1e-4;

/// B′ counts as zero below this part of its largest coefficient: a root is accurate to some roundings.
pub(crate) const VANISHING_RATIO: f64 = 1e-12;

/// A resultant above this part of its possible size is not 0: the limit is far above its rounding.
const NEVER_RATIO: f64 = 1e-9;

/// Points of a part of a curve that are this close together, in ulps of the coordinates, may be the same point.
const ROUNDING_ULPS: f64 = 4.0;

/// A handle shorter than this ratio of the curve's size has no direction.
const NO_HANDLE: f64 = 1e-13;

/// B′ of a curve of degree n is n · `unit` · Σ `vectors`ᵢ Bᵢ.
pub(crate) struct Hodograph<P: Point> {
    /// The differences Pᵢ₊₁ − Pᵢ divided by the unit.
    pub(crate) vectors: Points<P>,
    /// The power of two that makes the largest coordinate 1 to 2; 0 if all points coincide.
    pub(crate) unit: f64,
}

impl<P: Point> Hodograph<P> {
    /// Expects at least two points.
    pub(crate) fn of(points: &[P]) -> Self {
        let mut vectors: Points<P> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let largest = max_abs(&vectors);
        if largest == 0.0 {
            return Self { vectors, unit: 0.0 };
        }
        let scale = unit_scale(largest);
        for vector in &mut vectors {
            *vector = *vector * scale;
        }
        Self {
            vectors,
            unit: 1.0 / scale,
        }
    }

    /// The parameters inside (0, 1) where B′ is 0 and the direction reverses. `rounding` is the error bound of a
    /// coordinate of the control points.
    ///
    /// Each is a minimum of |B′|², and so a root of B′·B″, at which |B′| is no larger than rounding can make it.
    pub(crate) fn cusps(&self, rounding: f64) -> Scalars {
        let vectors = &self.vectors;
        let m = vectors.len() - 1;
        if self.unit == 0.0 || m == 0 {
            return Scalars::new();
        }
        // B′·B″ up to a positive factor.
        let rate = product_of(m, m - 1, |i, j| vectors[i].dot(vectors[j + 1] - vectors[j]));
        // The rounding of `at`: that of the control points, and that of the evaluation, which grows with the degree.
        let slack = 8.0 * (m + 2) as f64 * (rounding / self.unit + f64::EPSILON);
        let at = |t: f64| evaluate(vectors, t);
        let is_cusp = |t: f64| {
            // A probe may lie outside [0, 1]; the polynomial continues there.
            at(t).norm() <= slack && at(t - CUSP_PROBE_STEP).dot(at(t + CUSP_PROBE_STEP)) < 0.0
        };
        let stops = roots_inside(&rate).into_iter();
        stops.filter(|&t| is_cusp(t)).collect()
    }

    /// The parameters inside (0, 1) where B′ is 0: cusps, reversals of a straight curve, and points where it only stops.
    pub(crate) fn zeros(&self) -> Scalars {
        let vectors = &self.vectors;
        let max = VANISHING_RATIO * max_abs(vectors);
        common_zeros(vectors, |t| evaluate(vectors, t).max_abs() <= max)
    }
}

/// The parameters inside (0, 1) that are a root of a coordinate of Σ `vectors`ᵢ Bᵢ and at which `vanishes`.
pub(crate) fn common_zeros<P: Point>(vectors: &[P], vanishes: impl Fn(f64) -> bool) -> Scalars {
    let mut found = Scalars::new();
    // All coordinates are searched, because one of them may be 0 everywhere.
    for axis in 0..P::DIMENSION {
        let row: Scalars = vectors.iter().map(|p| p.coordinate(axis)).collect();
        let roots = roots_inside(&row).into_iter();
        found.extend(roots.filter(|&t| vanishes(t)));
    }
    sort_by(&mut found, f64::total_cmp);
    found.dedup_by(|next, last| *next - *last <= DOUBLE_ROOT);
    found
}

/// [`Hodograph::zeros`] of a curve in the plane; most curves are shown to have none without a search.
pub(crate) fn derivative_zeros(points: &[DVec2]) -> Scalars {
    if is_monotone_along_chord(points) || has_no_derivative_zero(points) {
        return Scalars::new();
    }
    Hodograph::of(points).zeros()
}

/// Whether B′ of a quadratic or a cubic certainly vanishes nowhere: the resultant of its coordinates, computed from
/// cross products of the control edges, is not 0.
fn has_no_derivative_zero(points: &[DVec2]) -> bool {
    let edge = |i: usize| points[i + 1] - points[i];
    let (resultant, size) = match points.len() {
        // The resultant is e × f; its size is compared with e·f = e × f⊥.
        3 => (edge(0).perp_dot(edge(1)), edge(0).perp_dot(edge(1).perp())),
        4 => {
            let (e, f, g) = (edge(0), edge(1), edge(2));
            let (ef, eg, fg) = (e.perp_dot(f), e.perp_dot(g), f.perp_dot(g));
            // The resultant is (e × g)² − 4 (e × f)(f × g).
            let product = 4.0 * ef * fg;
            let max = e.max_abs().max(f.max_abs()).max(g.max_abs());
            (eg * eg - product, max * max * max * max)
        }
        _ => return false,
    };
    resultant.abs() > NEVER_RATIO * size.abs()
}

/// Whether no control edge points against the chord; then the curve passes no point twice.
pub(crate) fn is_monotone_along_chord(points: &[DVec2]) -> bool {
    let chord = points[points.len() - 1] - points[0];
    // Then B′·chord has no negative Bernstein coefficient and at least one positive one, so it is positive in (0, 1).
    chord != DVec2::ZERO && points.windows(2).all(|p| (p[1] - p[0]).dot(chord) >= 0.0)
}

impl Curve<DVec2> {
    /// The unit tangent at the start: the direction to the first control point that differs from the start by more
    /// than rounding; zero for a point.
    pub(crate) fn start_tangent(&self) -> DVec2 {
        let start = self.start();
        let min = self.negligible_distance(start);
        let is_far = |v: &DVec2| Point::max_abs(*v) > min;
        Point::unit(first_step(start, self.points.iter(), is_far))
    }

    /// The unit tangent at the end, found likewise.
    pub(crate) fn end_tangent(&self) -> DVec2 {
        let end = self.end();
        let min = self.negligible_distance(end);
        let is_far = |v: &DVec2| Point::max_abs(*v) > min;
        -Point::unit(first_step(end, self.points.iter().rev(), is_far))
    }

    /// The distance up to which a control point may be the same point as an end.
    fn negligible_distance(&self, end: DVec2) -> f64 {
        let distances = self.points.iter().map(|&p| Point::max_abs(p - end));
        let far = distances.fold(0.0, f64::max);
        let rounding = ROUNDING_ULPS * f64::EPSILON * Point::max_abs(end);
        // At most half of the largest distance, so that one of the points is far enough unless all are equal.
        rounding.clamp(NO_HANDLE * far, 0.5 * far)
    }
}

/// The vector from a point to the first of other points that is far enough away; zero if there is none.
pub(crate) fn first_step<'a>(
    from: DVec2,
    others: impl Iterator<Item = &'a DVec2>,
    is_far: impl Fn(&DVec2) -> bool,
) -> DVec2 {
    let mut steps = others.map(|&p| p - from);
    steps.find(is_far).unwrap_or_default()
}
