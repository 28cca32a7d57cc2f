//! Derivatives, tangents, normals and curvature.

use super::Curve;
use crate::bernstein::evaluate::evaluate;
use crate::geometry::check::clamp_to_limit;
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::list::Points;
use casteljau_kernels::numeric::vector::Vector;
use std::cmp::Ordering;

/// A derivative counts as zero if it is below this part of the largest value that its control points allow. Rounding of
/// the control points and of the evaluation leaves about n·2⁻⁵³.
pub(crate) const VANISHING_RATIO: f64 = 1e-13;

impl<P: Point> Curve<P> {
    /// The derivative (hodograph) as a curve: B′(t) has the control points n (Pᵢ₊₁ − Pᵢ) and degree n − 1.
    ///
    /// The derivative of a line is constant; the result is a line with two coincident points. Coordinates beyond
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE) are set to it.
    pub fn derivative(&self) -> Self {
        let mut points = differences(&self.points);
        for p in &mut points {
            *p = clamp_to_limit(*p * self.degree() as f64);
        }
        if points.len() == 1 {
            points.push(points[0]);
        }
        Self::from_points(points)
    }

    /// The k-th derivative at t. k = 0 is the point itself; beyond the degree the result is zero.
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

    /// The unit tangent at t: the direction of the first derivative that does not vanish at t.
    ///
    /// At zero-length handles and at cusps this is the limit from the right, except at t = 1, where it is the limit
    /// from the left. The result is zero for a curve that is a point. Source: Farin, *Curves and Surfaces for CAGD*,
    /// §5.3.
    pub fn tangent(&self, t: f64) -> P {
        self.taylor(t).map_or(P::default(), |local| local.tangent())
    }

    /// The unit normal at t.
    ///
    /// In the plane it is the tangent rotated by +90°, (x, y) → (−y, x). In space it is the principal normal: the
    /// direction of the component perpendicular to the tangent of the first higher derivative that has one. The result
    /// is zero for a curve that is a point and, in space, for a straight curve.
    pub fn normal(&self, t: f64) -> P {
        self.taylor(t).map_or(P::default(), |local| local.normal())
    }

    /// The curvature κ = (B′ × B″) / |B′|³ at t, in 1 / unit of length.
    ///
    /// In the plane it is positive for a counter-clockwise turn (x right, y up); in space it is never negative. Where
    /// B′ vanishes it is the limit, which may be infinite (a cusp, a zero-length handle). For a straight curve or a
    /// point it is 0. In space a curve counts as straight where the angle between B″ and B′ is at most 10⁻¹³. Source:
    /// Farin, *Curves and Surfaces for CAGD*, §11.2.
    pub fn curvature(&self, t: f64) -> f64 {
        self.taylor(t).map_or(0.0, |local| local.curvature())
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
        // Just before a zero of B′, the remaining B′ points against the first term that does not vanish.
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

/// The Taylor expansion of the curve at one parameter: B(t + τ) = B(t) + scale · Σ cₖ τᵏ.
///
/// `scale` is the largest coordinate difference of the control polygon, so that neither 1e300 nor 1e-300 leaves the
/// range of f64.
pub(crate) struct Taylor<P: Point> {
    pub(crate) scale: f64,
    /// c₁ … cₙ.
    pub(crate) coefficients: Points<P>,
    /// The order of the first coefficient that does not vanish.
    pub(crate) first: usize,
    /// Whether limits are taken from the left, where odd powers of τ are negative: at t = 1, and just before a zero of
    /// B′.
    pub(crate) from_left: bool,
}

impl<P: Point> Taylor<P> {
    /// The unit tangent.
    pub(crate) fn tangent(&self) -> P {
        self.direction(self.first)
    }

    /// The unit normal; see [`Curve::normal`].
    pub(crate) fn normal(&self) -> P {
        let tangent = self.tangent();
        if P::DIMENSION == 2 {
            return P::normal_of(tangent, P::default());
        }
        self.bend().map_or(P::default(), |order| {
            let bend = self.coefficients[order - 1];
            // In the limit from the left, odd powers of τ change sign.
            P::normal_of(
                tangent,
                if self.from_left && !order.is_multiple_of(2) {
                    -bend
                } else {
                    bend
                },
            )
        })
    }

    /// The curvature; see [`Curve::curvature`].
    pub(crate) fn curvature(&self) -> f64 {
        let Some(order) = self.bend() else {
            return 0.0;
        };
        let (a, c) = (self.first as f64, order as f64);
        let first = self.coefficients[self.first - 1];
        let cross = first.cross(self.coefficients[order - 1]);
        let turned = P::DIMENSION == 2 && self.from_left && (self.first + order).is_multiple_of(2);
        let sign = if turned {
            -cross.curvature_sign()
        } else {
            cross.curvature_sign()
        };
        // With B ≈ A tᵃ + C tᶜ the curvature is A×C·c(c−a)/(a²|A|³) · t to the power c − 2a.
        match order.cmp(&(2 * self.first)) {
            Ordering::Less => sign * f64::INFINITY,
            Ordering::Greater => 0.0,
            Ordering::Equal => {
                sign * cross.size() / first.norm().powi(3) * (c * (c - a) / (a * a)) / self.scale
            }
        }
    }

    /// The direction in which the term of this order moves the point as t increases.
    fn direction(&self, order: usize) -> P {
        let unit = self.coefficients[order - 1].unit();
        if self.from_left && order.is_multiple_of(2) {
            -unit
        } else {
            unit
        }
    }

    /// The order of the first later coefficient that is not parallel to the first; 2 at regular points.
    pub(crate) fn bend(&self) -> Option<usize> {
        if self.first == 1 && P::DIMENSION == 2 {
            return (self.coefficients.len() > 1).then_some(2);
        }
        let first = self.coefficients[self.first - 1];
        (self.first + 1..=self.coefficients.len()).find(|&order| {
            let later = self.coefficients[order - 1];
            first.cross(later).size() > VANISHING_RATIO * first.norm() * later.norm()
        })
    }
}

/// The differences Pᵢ₊₁ − Pᵢ, one fewer than the points; zero for a single point.
fn differences<P: Vector>(points: &[P]) -> Points<P> {
    if points.len() < 2 {
        return Points::from([P::default()].as_slice());
    }
    points.windows(2).map(|pair| pair[1] - pair[0]).collect()
}
