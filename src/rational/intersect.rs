//! Intersections of rational plane curves.
//!
//! The search and the classification are those of polynomial curves: the curve lies in the hull of its control points, and
//! its direction is a sum of the control edges with positive factors. First the parameter is replaced so that the weights
//! at both ends are about equal; distances in the parameter then mean about the same everywhere.

use super::RationalCurve;
use super::nearest::Derivatives;
use super::numerators::derivative_numerator;
use super::weighted::WeightedPoint;
use crate::bernstein::evaluate::{evaluate, evaluate_scalar};
use crate::bernstein::wronskian::Wronskian;
use crate::curve::elevate::elevate_once;
use crate::curve::hodograph::{VANISHING_RATIO, common_zeros};
use crate::curve::intersect::pair::{ClassifiedContact, NormalizedPair};
use crate::curve::intersect::plane_curve::{PlaneCurve, search_with};
use crate::curve::intersect::self_intersections::{crossings, self_locations_of};
use crate::curve::{Curve, Intersection, IntersectionKind, SelfIntersection};
use crate::geometry::bounds::Bounds;
use crate::geometry::check::max_abs;
use crate::geometry::point::Point;
use crate::numeric::float::unit_scale;
use crate::numeric::list::{Points, Scalars};
use crate::spline::spline_set::SplineSegment;
use casteljau_kernels::curve::intersect::clipping::{
    ClippingSolver, Contact, Piece, balancing_speed,
};
use glam::DVec2;

/// The smallest weight in the search, where the largest is 1 to 2: the product of two is a normal number. Smaller ones are
/// raised to it.
const MIN_WEIGHT: f64 = 1.0 / super::MAX_WEIGHT;

impl RationalCurve<DVec2> {
    /// All intersections of this curve with another one, sorted by t, then by u.
    ///
    /// A(t) = B(u) with t and u in [0, 1], end points included; kinds, overlaps and limits are those of
    /// [`Curve::intersections`]. Curves intersect where their distance is below about 2ε (L + 2(n + 1) S), with ε, L, S and n
    /// as there. Arcs of one conic section overlap however they are parametrized. Where the speed is high, because weights
    /// differ much, the rounding of t moves A(t) by more than that distance, and a tangency there may be missed.
    ///
    /// Source: Sederberg and Nishita, "Curve intersection using Bézier clipping", CAD 22 (1990), for crossings.
    ///
    /// ```
    /// use casteljau::{Curve, RationalCurve, glam::DVec2};
    ///
    /// let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    /// let quarter = RationalCurve::new(&points, &[1.0, 0.5_f64.sqrt(), 1.0])?;
    /// let line = Curve::new(&[DVec2::ZERO, DVec2::new(3.0, 4.0)])?;
    /// let found = quarter.intersections_with_curve(&line);
    /// assert!((found[0].point - DVec2::new(0.6, 0.8)).length() < 1e-15);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn intersections(&self, other: &Self) -> Vec<Intersection> {
        let (a, b) = (Balanced::of(self), Balanced::of(other));
        let locations = match (a.curve.as_polynomial(), b.curve.as_polynomial()) {
            (Some(a), Some(b)) => NormalizedPair::new(&a, &b).map(|pair| pair.solve()),
            _ => NormalizedPair::new(&a.curve, &b.curve).map(|pair| pair.solve()),
        };
        let at = |location: ClassifiedContact| {
            let kind = match location.kind {
                IntersectionKind::Overlap { t_end, u_end } => IntersectionKind::Overlap {
                    t_end: a.original(t_end),
                    u_end: b.original(u_end),
                },
                kind => kind,
            };
            let times = (a.original(location.t), b.original(location.u));
            ClassifiedContact::new(times, kind).on(|t| self.eval(t), |u| other.eval(u))
        };
        locations.map_or_else(Vec::new, |(locations, _)| {
            sorted(locations.into_iter().map(at).collect())
        })
    }

    /// All intersections with a polynomial curve; u is its parameter. See [`intersections`](Self::intersections).
    pub fn intersections_with_curve(&self, other: &Curve<DVec2>) -> Vec<Intersection> {
        self.intersections(&Self::from(other))
    }

    /// The points that the curve passes twice, sorted by t: B(t) = B(u) with 0 ≤ t < u ≤ 1. See
    /// [`Curve::self_intersections`]; conics have none.
    pub fn self_intersections(&self) -> Vec<SelfIntersection> {
        let contacts = self.self_contacts().into_iter();
        contacts
            .map(|Intersection { t, u, point, .. }| SelfIntersection { t, u, point })
            .collect()
    }

    /// [`self_intersections`](Self::self_intersections) with the kind of contact.
    fn self_contacts(&self) -> Vec<Intersection> {
        let balanced = Balanced::of(self);
        let locations = match balanced.curve.as_polynomial() {
            Some(curve) => curve.self_locations(),
            None => self_locations_of(&balanced.curve, crossings),
        };
        let at = |location: ClassifiedContact| {
            let (t, u) = (balanced.original(location.t), balanced.original(location.u));
            // B(0) and B(1) are exact: control points.
            let point = self.eval(if u == 1.0 { 1.0 } else { t });
            Intersection {
                t,
                u,
                point,
                kind: location.kind,
            }
        };
        locations.into_iter().map(at).collect()
    }
}

impl SplineSegment for RationalCurve<DVec2> {
    fn contacts_with(&self, other: &Self) -> Vec<Intersection> {
        self.intersections(other)
    }

    fn contacts_with_itself(&self) -> Vec<Intersection> {
        self.self_contacts()
    }

    fn control_box(&self) -> Bounds<DVec2> {
        self.control_bounds()
    }
}

/// Intersections sorted by t, then by u: parameters that differ before they are mapped to those of the curves may be rounded to
/// the same t.
pub(super) fn sorted(mut found: Vec<Intersection>) -> Vec<Intersection> {
    found.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.u.total_cmp(&b.u)));
    found
}

/// A curve with another parameter s, for which the weights of both ends are about equal.
struct Balanced {
    curve: RationalCurve<DVec2>,
    /// t/(1 − t) divided by s/(1 − s).
    speed: f64,
}

impl Balanced {
    /// The weights are multiplied by powers of a power of two, without rounding. A line gets equal weights.
    fn of(curve: &RationalCurve<DVec2>) -> Self {
        let n = curve.degree();
        let ratio = curve.weights[0] / curve.weights[n];
        let speed = if n == 1 {
            ratio
        } else {
            balancing_speed(ratio, n)
        };
        let mut power = curve.weight_scale();
        let times_power = |w: &f64| {
            let weight = w * power;
            power *= speed;
            weight
        };
        let mut weights: Scalars = curve.weights.iter().map(times_power).collect();
        if n == 1 {
            weights[1] = weights[0];
        }
        let scale = unit_scale(weights.iter().copied().fold(0.0, f64::max));
        weights
            .iter_mut()
            .for_each(|w| *w = (*w * scale).max(MIN_WEIGHT));
        let points = curve.points.clone();
        Self {
            curve: RationalCurve { points, weights },
            speed,
        }
    }

    /// The parameter t of the given curve at s.
    fn original(&self, s: f64) -> f64 {
        self.speed * s / (1.0 - s + self.speed * s)
    }
}

impl PlaneCurve for RationalCurve<DVec2> {
    /// Weights are rounded, too.
    const ROUNDING: f64 = 2.0;

    fn points(&self) -> &[DVec2] {
        &self.points
    }

    fn normalized(&self, origin: DVec2, scale: f64) -> Self {
        let image = |p: &DVec2| (*p - origin) * scale;
        Self {
            points: self.points.iter().map(image).collect(),
            weights: self.weights.clone(),
        }
    }

    fn at(&self, t: f64) -> DVec2 {
        self.eval(t)
    }

    fn jets(&self) -> impl Fn(f64) -> [DVec2; 3] + '_ {
        let derivatives = Derivatives::of(&self.homogeneous(DVec2::ZERO));
        move |t| derivatives.jet(t)
    }

    fn tangent_at(&self, t: f64) -> DVec2 {
        self.tangent(t)
    }

    fn part(&self, from: f64, to: f64) -> Points<DVec2> {
        RationalCurve::part(self, from, to).points
    }

    fn derivative_zeros(&self) -> Scalars {
        let wronskian = Wronskian::of_degree(self.degree());
        let numerator = derivative_numerator(&wronskian, &self.points, &self.weights);
        // A vector from which no coefficient deviates by more than 90° has a positive product with the sum, too.
        let is_between =
            |v: &DVec2| *v != DVec2::ZERO && numerator.iter().all(|d| d.dot(*v) >= 0.0);
        if numerator.iter().any(is_between) {
            return Scalars::new();
        }
        let edges: Points<DVec2> = self.points.windows(2).map(|p| p[1] - p[0]).collect();
        let max = VANISHING_RATIO * max_abs(&edges);
        common_zeros(&numerator, |t| {
            let weight = evaluate_scalar(&self.weights, t);
            evaluate(&numerator, t).max_abs() <= max * weight * weight
        })
    }

    fn search(
        [a, b]: &[Self; 2],
        slack: f64,
        cuts: [&[f64]; 2],
        pairs: impl Iterator<Item = (usize, usize)>,
    ) -> (Vec<Contact>, usize) {
        let degree = a.degree().max(b.degree());
        let whole = [a.piece(degree), b.piece(degree)];
        search_with(whole, slack, cuts, pairs, ClippingSolver::run)
    }
}

impl RationalCurve<DVec2> {
    /// The curve elevated to a given degree.
    fn piece(&self, degree: usize) -> Piece<Vec<f64>, Vec<f64>> {
        let mut parts: Points<WeightedPoint<DVec2>> = self.weighted();
        while parts.len() <= degree {
            elevate_once(&mut parts);
        }
        Piece {
            x: parts.iter().map(|part| part.point.x).collect(),
            y: parts.iter().map(|part| part.point.y).collect(),
            weights: parts.iter().map(|part| part.weight).collect(),
            from: 0.0,
            to: 1.0,
        }
    }
}
