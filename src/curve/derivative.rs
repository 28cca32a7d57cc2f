//! Which way does it go, and how does it bend?

use super::Curve;
use crate::bernstein::evaluate::evaluate;
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::list::Points;
use std::cmp::Ordering;

/// A derivative counts as vanishing when it is below this part of the largest one that its degree allows: rounding of
/// the control points and of the evaluation leaves about n·2⁻⁵³.
pub(crate) const VANISHING_RATIO: f64 = 1e-13;

impl<P: Point> Curve<P> {
    /// The derivative as a curve: B′(t) has the control points n (Pᵢ₊₁ − Pᵢ), degree n − 1.
    ///
    /// That of a line is constant; it comes back as a line whose two points coincide.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let mut points = differences(&self.points);
        for p in &mut points {
            *p = *p * self.degree() as f64;
        }
        if points.len() == 1 {
            points.push(points[0]);
        }
        Self::from_points(points)
    }

    /// The k-th derivative at t; k = 0 is the point itself, and beyond the degree the result is zero.
    pub fn derivative_at(&self, t: f64, k: usize) -> P {
        if k > self.degree() {
            return P::default();
        }
        let mut points = self.points.clone();
        let mut factor = 1.0;
        for step in 0..k {
            points = differences(&points);
            factor *= (self.degree() - step) as f64;
        }
        evaluate(&points, t) * factor
    }

    /// The unit tangent at t: the direction of the first derivative that does not vanish there.
    ///
    /// At zero-length handles and at cusps this is the limit, taken from the right except at t = 1. Zero for a curve
    /// that is a point. Source: Farin, *Curves and Surfaces for CAGD*, §5.3.
    pub fn tangent(&self, t: f64) -> P {
        self.taylor(t)
            .map_or(P::default(), |local| local.direction(local.first))
    }

    /// The unit normal at t.
    ///
    /// In the plane the tangent turned by +90°, (x, y) → (−y, x). In space the principal normal: the part of the first
    /// fitting higher derivative that is perpendicular to the tangent. Zero for a point, in space for a straight curve.
    pub fn normal(&self, t: f64) -> P {
        let Some(local) = self.taylor(t) else {
            return P::default();
        };
        let tangent = local.direction(local.first);
        if P::DIMENSION == 2 {
            return P::normal_of(tangent, P::default());
        }
        local.bend().map_or(P::default(), |order| {
            let bend = local.coefficients[order - 1];
            // Coming from the left, odd powers change their sign.
            P::normal_of(
                tangent,
                if local.from_left && !order.is_multiple_of(2) {
                    -bend
                } else {
                    bend
                },
            )
        })
    }

    /// The curvature κ = (B′ × B″) / |B′|³ at t, in 1 / unit of length.
    ///
    /// In the plane it is positive when turning counter-clockwise (x right, y up), in space never negative. Where B′
    /// vanishes it is the limit, which may be infinite (a cusp, a zero-length handle); of a straight curve, a point
    /// included, it is 0. In space a curve counts as straight where B″ is parallel to B′ to an angle of 10⁻¹³. Source:
    /// Farin, *Curves and Surfaces for CAGD*, §11.2.
    pub fn curvature(&self, t: f64) -> f64 {
        let Some(local) = self.taylor(t) else {
            return 0.0;
        };
        let Some(order) = local.bend() else {
            return 0.0;
        };
        let (a, c) = (local.first as f64, order as f64);
        let first = local.coefficients[local.first - 1];
        let cross = first.cross(local.coefficients[order - 1]);
        let turned =
            P::DIMENSION == 2 && local.from_left && (local.first + order).is_multiple_of(2);
        let sign = if turned {
            -cross.curvature_sign()
        } else {
            cross.curvature_sign()
        };
        // With B ≈ A tᵃ + C tᶜ the curvature is A×C·c(c−a)/(a²|A|³) · t to the power c − 2a.
        match order.cmp(&(2 * local.first)) {
            Ordering::Less => sign * f64::INFINITY,
            Ordering::Greater => 0.0,
            Ordering::Equal => {
                sign * cross.size() / first.length().powi(3) * (c * (c - a) / (a * a)) / local.scale
            }
        }
    }

    /// The Taylor expansion at t; `None` for a curve that is a point.
    pub(crate) fn taylor(&self, t: f64) -> Option<Taylor<P>> {
        let mut points = differences(&self.points);
        let scale = crate::geometry::check::max_abs(&points);
        if scale == 0.0 {
            return None;
        }
        for p in &mut points {
            *p = *p / scale;
        }
        let mut coefficients = Points::new();
        let mut first = 0;
        let mut binomial = 1.0;
        for order in 1..=self.degree() {
            binomial *= (self.degree() + 1 - order) as f64 / order as f64;
            let value = evaluate(&points, t);
            if first == 0
                && value.max_abs()
                    > VANISHING_RATIO
                        * crate::geometry::check::max_abs(&points).max(VANISHING_RATIO)
            {
                first = order;
            }
            coefficients.push(value * binomial);
            points = differences(&points);
        }
        // Just before a zero of B′ what is left of it points against the term that takes its place.
        let term = coefficients[first.max(1) - 1];
        let from_left = t == 1.0 || coefficients[0].dot(term) < 0.0;
        (first > 0).then_some(Taylor {
            scale,
            coefficients,
            first,
            from_left,
        })
    }
}

/// The curve about one parameter: B(t + τ) = B(t) + scale · Σ cₖ τᵏ.
///
/// `scale` is the longest coordinate difference of the control polygon, so that neither 1e300 nor 1e-300 leaves the
/// range of f64.
pub(crate) struct Taylor<P: Point> {
    pub(crate) scale: f64,
    /// c₁ … cₙ.
    pub(crate) coefficients: Points<P>,
    /// The order of the first that does not vanish.
    pub(crate) first: usize,
    /// At t = 1, and just before a zero of B′, limits come from the left, where odd powers of τ are negative.
    pub(crate) from_left: bool,
}

impl<P: Point> Taylor<P> {
    /// The direction in which the term of this order moves the point, forwards.
    fn direction(&self, order: usize) -> P {
        let unit = self.coefficients[order - 1].normalize_or_zero();
        if self.from_left && order.is_multiple_of(2) {
            -unit
        } else {
            unit
        }
    }

    /// The order of the first later term that is not parallel to the first; at regular points the second.
    pub(crate) fn bend(&self) -> Option<usize> {
        if self.first == 1 && P::DIMENSION == 2 {
            return (self.coefficients.len() > 1).then_some(2);
        }
        let first = self.coefficients[self.first - 1];
        (self.first + 1..=self.coefficients.len()).find(|&order| {
            let later = self.coefficients[order - 1];
            first.cross(later).size() > VANISHING_RATIO * first.length() * later.length()
        })
    }
}

/// Pᵢ₊₁ − Pᵢ; one point fewer. Of a single point: zero.
fn differences<P: Point>(points: &[P]) -> Points<P> {
    if points.len() < 2 {
        return Points::from([P::default()].as_slice());
    }
    points.windows(2).map(|pair| pair[1] - pair[0]).collect()
}
