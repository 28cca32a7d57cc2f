//! Distances between two curves, and local searches for nearest points, crossings and tangencies.

use super::constants::{
    BOX_SAMPLES, CROSSING_STEPS, END_OF_CONTACT, EQUAL_POINTS, NEARLY_PARALLEL, PARALLEL,
    TANGENCY_STEPS,
};
use super::pair::NormalizedPair;
use super::plane_curve::PlaneCurve;
use crate::curve::with_derivatives::{LAST_STEP, foot};
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use casteljau_kernels::curve::intersect::clipping::crossing_step;
use glam::DVec2;

impl<S: PlaneCurve> NormalizedPair<S> {
    /// The distance between A(t) and B(u) in the maximum norm.
    pub(crate) fn apart(&self, t: f64, u: f64) -> f64 {
        (self.point(0, t) - self.point(1, u)).max_abs()
    }

    /// Whether the points A(t) and B(u) are equal up to rounding.
    pub(crate) fn coincide(&self, (t, u): (f64, f64)) -> bool {
        self.apart(t, u) <= EQUAL_POINTS * self.slack
    }

    /// The distance of A(t) from the tangent of B at u.
    pub(crate) fn height(&self, t: f64, u: f64) -> f64 {
        let [a, da, _] = self.curves[0].jets()(t);
        let [b, db, _] = self.curves[1].jets()(u);
        // At a zero of B′ the direction of A is used.
        let direction = if db == DVec2::ZERO { da } else { db };
        match Point::unit(direction) {
            DVec2::ZERO => Point::norm(a - b),
            along => along.perp_dot(a - b).abs(),
        }
    }

    /// Whether points of each segment lie in the box of the other one's control points, as they do if the segments are
    /// the same. `margin` is the amount by which a box is widened, as a function of its size.
    pub(crate) fn have_equal_boxes(
        &self,
        t: [f64; 2],
        u: [f64; 2],
        margin: impl Fn(f64) -> f64,
    ) -> bool {
        let inside = |first: usize, [from, to]: [f64; 2], second: usize, ends: [f64; 2]| {
            let bounds = self.bounds_of(second, ends);
            let margin =
                END_OF_CONTACT * self.slack + margin((bounds.max - bounds.min).max_element());
            (1..BOX_SAMPLES).all(|k| {
                let point = self.point(first, from + ratio(k, BOX_SAMPLES) * (to - from));
                bounds.outside(point).max_element() <= margin
            })
        };
        inside(0, t, 1, u) && inside(1, u, 0, t)
    }

    /// The box of the control points of a segment; its ends may be in any order.
    fn bounds_of(&self, curve: usize, [from, to]: [f64; 2]) -> Bounds<DVec2> {
        Bounds::from_points(&self.curves[curve].part(from.min(to), from.max(to)))
    }

    /// The parameter on one curve that is nearest to a point, found from a nearby parameter.
    pub(crate) fn nearest(&self, curve: usize, point: DVec2, near: f64) -> f64 {
        foot(self.curves[curve].jets(), point, near)
    }

    /// The parameters of A(t) and of the nearest point on the second curve.
    pub(crate) fn project_onto_b(&self, t: f64, u: f64) -> (f64, f64) {
        (t, self.nearest(1, self.point(0, t), u))
    }

    /// The parameters of B(u) and of the nearest point on the first curve.
    pub(crate) fn project_onto_a(&self, t: f64, u: f64) -> (f64, f64) {
        (self.nearest(0, self.point(1, u), t), u)
    }

    /// The crossing to which Newton's method converges from here.
    pub(crate) fn crossing(&self, (mut t, mut u): (f64, f64)) -> Option<(f64, f64)> {
        let (of_a, of_b) = (self.curves[0].jets(), self.curves[1].jets());
        for _ in 0..CROSSING_STEPS {
            let ([a, da, _], [b, db, _]) = (of_a(t), of_b(u));
            let ([dt, du], _) = crossing_step((b - a).into(), da.into(), db.into());
            if !(dt.is_finite() && du.is_finite()) {
                break;
            }
            (t, u) = ((t + dt).clamp(0.0, 1.0), (u + du).clamp(0.0, 1.0));
            if dt.abs() + du.abs() < LAST_STEP {
                break;
            }
        }
        Some((t, u)).filter(|&location| self.coincide(location))
    }

    /// The tangency near the given parameters, where both curves have the same direction and are nearest to each other:
    /// A′ × B′ = 0 and (A − B) · A′ = 0.
    pub(crate) fn tangency(&self, (mut t, mut u): (f64, f64)) -> Option<(f64, f64)> {
        let (of_a, of_b) = (self.curves[0].jets(), self.curves[1].jets());
        for _ in 0..TANGENCY_STEPS {
            let ([a, da, dda], [b, db, ddb]) = (of_a(t), of_b(u));
            let (cross, ahead) = (da.perp_dot(db), (a - b).dot(da));
            if cross.abs() <= PARALLEL * Point::norm(da) * Point::norm(db)
                && ahead.abs() <= self.slack * Point::norm(da)
            {
                // A multiple root cannot be determined more accurately.
                break;
            }
            // The partial derivatives of both functions; the step follows by Cramer's rule.
            let (cross_t, cross_u) = (dda.perp_dot(db), da.perp_dot(ddb));
            let (ahead_t, ahead_u) = (da.dot(da) + (a - b).dot(dda), -db.dot(da));
            let det = cross_t * ahead_u - cross_u * ahead_t;
            let dt = (cross * ahead_u - ahead * cross_u) / det;
            let du = (cross_t * ahead - ahead_t * cross) / det;
            if !(dt.is_finite() && du.is_finite()) {
                break;
            }
            (t, u) = (t - dt, u - du);
            if dt.abs() + du.abs() < LAST_STEP {
                break;
            }
        }
        let inside = (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&u);
        let ([_, da, _], [_, db, _]) = (of_a(t), of_b(u));
        let is_parallel =
            da.perp_dot(db).abs() <= NEARLY_PARALLEL * Point::norm(da) * Point::norm(db);
        (inside && is_parallel && self.coincide((t, u))).then_some((t, u))
    }
}
