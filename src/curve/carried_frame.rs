//! Carries a normal along a curve in space without rotation about the tangent.

use super::Curve;
use crate::bernstein::evaluate::evaluate;
use crate::curve::hodograph::Hodograph;
use crate::geometry::point::Point;
use casteljau_kernels::numeric::trigonometry::cos_sin;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// A step is short enough if halving it moves the normal by less than this; the remaining error is about 20 times
/// smaller.
const MAX_STEP_ERROR: f64 = 1e-10;

/// The cosine of the largest allowed angle, 60°, between the tangents of half a step.
const GENTLE_COSINE: f64 = 0.5;

/// A step of t this short over which the tangent still turns sharply contains a cusp.
const CUSP_STEP: f64 = 1e-10;

/// Below this cosine of the angle between two tangents, the direction counts as reversed.
const BACK_COSINE: f64 = -0.9;

/// Above this part of the largest speed the tangent is the normalized derivative; below, it is the limit of the
/// tangent.
const CLEAR_SPEED: f64 = 1e-6;

/// A chord shorter than this is rounding noise. The normal is then rotated by the smallest rotation between the two
/// tangents.
const MIN_DISPLACEMENT: f64 = 1e-10;

/// Derivatives count as parallel when the sine of their angle is below this.
const PARALLELISM_SINE: f64 = 1e-9;

/// Maximum number of halvings for a frame in the middle of a step, and for one outside [0, 1].
const MAX_INSIDE: usize = 63;
const MAX_OUTSIDE: usize = 512;

/// A curve for frames. `unit` is a copy with the start at the origin and a moderate size.
pub(crate) struct FrameCurve {
    unit: Curve<DVec3>,
    slopes: crate::numeric::list::Points<DVec3>,
}

/// The tangent and the normal of a frame; both zero if all curves are points.
#[derive(Clone, Copy, Default)]
pub(crate) struct CarriedFrame {
    pub(crate) tangent: DVec3,
    pub(crate) normal: DVec3,
}

impl CarriedFrame {
    /// The frame after the tangent has rotated at one point, by the smallest rotation.
    pub(crate) fn rotated_to(self, tangent: DVec3) -> Self {
        let normal = rotated_normal(self.tangent, self.normal, tangent, DVec3::ZERO);
        Self { tangent, normal }
    }

    /// The angle, −π to π, about the common tangent to the normal of another frame.
    pub(crate) fn angle_to(self, other: Self) -> f64 {
        let binormal = self.tangent.cross(self.normal);
        let sine = binormal.dot(other.normal);
        sine.atan2(self.normal.dot(other.normal))
    }

    /// The frame rotated about its tangent.
    pub(crate) fn rotated(self, angle: f64) -> Self {
        let (cosine, sine) = cos_sin(angle);
        let normal = self.normal * cosine + self.tangent.cross(self.normal) * sine;
        let normal = Point::unit(normal);
        Self { normal, ..self }
    }
}

/// The data that a step needs of one of its ends.
#[derive(Clone, Copy)]
pub(crate) struct FrameSample {
    t: f64,
    point: DVec3,
    tangent: DVec3,
}

/// The end of a step with the normal carried to it.
#[derive(Clone, Copy)]
pub(crate) struct FrameStep {
    at: FrameSample,
    normal: DVec3,
}

impl FrameStep {
    pub(crate) fn frame(&self) -> CarriedFrame {
        CarriedFrame {
            tangent: self.at.tangent,
            normal: self.normal,
        }
    }
}

impl FrameCurve {
    pub(crate) fn new(curve: &Curve<DVec3>) -> Self {
        let slopes = Hodograph::of(curve.control_points()).vectors;
        let mut point = DVec3::ZERO;
        let later = slopes.iter().map(|&slope| {
            point += slope;
            point
        });
        let unit = Curve::from_points(std::iter::once(DVec3::ZERO).chain(later).collect());
        Self { unit, slopes }
    }

    fn tangent(&self, t: f64) -> DVec3 {
        let slope = evaluate(&self.slopes, t);
        // The largest coordinate of the slopes is between 1 and 2.
        if slope.max_abs() > CLEAR_SPEED {
            Point::unit(slope)
        } else {
            self.unit.tangent(t)
        }
    }

    fn sample(&self, t: f64) -> FrameSample {
        FrameSample {
            t,
            point: self.unit.eval(t),
            tangent: self.tangent(t),
        }
    }

    /// The frame at t = 0 with a requested normal; `None` if the curve is a point.
    pub(crate) fn first(&self, wanted: Option<DVec3>) -> Option<CarriedFrame> {
        let tangent = self.tangent(0.0);
        let normal = self.first_normal(tangent, wanted);
        (tangent != DVec3::ZERO).then_some(CarriedFrame { tangent, normal })
    }

    fn first_normal(&self, tangent: DVec3, wanted: Option<DVec3>) -> DVec3 {
        let across = |v: DVec3| DVec3::normal_of(tangent, v);
        let farthest = DVec3::AXES
            .into_iter()
            .min_by(|a, b| a.dot(tangent).abs().total_cmp(&b.dot(tangent).abs()));
        let all = [wanted, Some(self.unit.normal(0.0)), farthest];
        // Ignore a requested normal that is parallel to the tangent.
        let clear = |v: &DVec3| Point::norm(Point::unit(*v).cross(tangent)) > PARALLELISM_SINE;
        all.into_iter()
            .flatten()
            .find(clear)
            .map_or(DVec3::ZERO, across)
    }

    /// Steps from t = 0 to 1 that carry a frame without rotation about the tangent; at t = 0 it is turned from the end
    /// of the previous curve. A curve that is a point has only the first one.
    pub(crate) fn steps(&self, before: CarriedFrame, work: &mut WorkLimit) -> Vec<FrameStep> {
        let mut start = FrameStep {
            at: self.sample(0.0),
            normal: before.normal,
        };
        if self.slopes.iter().all(|&slope| slope == DVec3::ZERO) {
            start.at.tangent = before.tangent;
            return vec![start];
        }
        start.normal = before.rotated_to(start.at.tangent).normal;
        let mut steps = vec![start];
        self.transport(start, &self.sample(1.0), work, &mut |step| steps.push(step));
        steps
    }

    /// The frame at t, from the last step before it.
    pub(crate) fn frame_at(&self, steps: &[FrameStep], t: f64) -> CarriedFrame {
        let k = steps.partition_point(|step| step.at.t <= t);
        let from = steps[k.saturating_sub(1)];
        if from.at.t == t || steps.len() == 1 {
            return from.frame();
        }
        let inside = (0.0..=1.0).contains(&t);
        let mut work = WorkLimit::new(if inside { MAX_INSIDE } else { MAX_OUTSIDE });
        let mut last = from;
        self.transport(from, &self.sample(t), &mut work, &mut |step| last = step);
        if last.at.tangent == DVec3::ZERO {
            last.at.tangent = from.at.tangent;
        }
        last.frame()
    }

    /// Calls `each` with the ends of the steps; returns the normal at the end of the last one.
    fn transport(
        &self,
        from: FrameStep,
        to: &FrameSample,
        work: &mut WorkLimit,
        each: &mut dyn FnMut(FrameStep),
    ) -> DVec3 {
        let (start, middle) = (from.at, self.sample(0.5 * (from.at.t + to.t)));
        let at_once = reflected(&start, from.normal, to);
        let in_two = reflected(&middle, reflected(&start, from.normal, &middle), to);
        let cosine = start
            .tangent
            .dot(middle.tangent)
            .min(middle.tangent.dot(to.tangent));
        let gentle = cosine > GENTLE_COSINE;
        let enough = gentle && Point::norm(in_two - at_once) <= MAX_STEP_ERROR;
        let normal = if work.is_exceeded() || enough {
            in_two
        } else if (to.t - start.t).abs() <= CUSP_STEP {
            rotated_normal(start.tangent, from.normal, to.tangent, self.axis(middle.t))
        } else if !work.spend(1) {
            in_two
        } else {
            let normal = self.transport(from, &middle, work, each);
            return self.transport(FrameStep { at: middle, normal }, to, work, each);
        };
        each(FrameStep { at: *to, normal });
        normal
    }

    /// The normal of the plane in which a cusp lies; zero if there is none.
    fn axis(&self, t: f64) -> DVec3 {
        let derivative = |k: usize| Point::unit(self.unit.derivative_at(t, k));
        let second = derivative(2);
        (3..=self.unit.degree())
            .map(|k| second.cross(derivative(k)))
            .find(|axis| Point::norm(*axis) > PARALLELISM_SINE)
            .map_or(DVec3::ZERO, Point::unit)
    }
}

/// The normal carried to the next sample by a double reflection.
fn reflected(from: &FrameSample, normal: DVec3, to: &FrameSample) -> DVec3 {
    let displacement = to.point - from.point;
    if displacement.max_abs() < MIN_DISPLACEMENT && from.tangent.dot(to.tangent) > GENTLE_COSINE {
        return rotated_normal(from.tangent, normal, to.tangent, DVec3::ZERO);
    }
    let normal = double_reflection(normal, [from.tangent, to.tangent], displacement);
    Point::unit(normal - to.tangent * to.tangent.dot(normal))
}

/// A vector perpendicular to a curve, transported from one point to another without rotation about the curve: reflected
/// in the bisecting plane of both points, then in the plane that maps the reflected tangent to the tangent at the second
/// point. Source: Wang, Jüttler, Zheng and Liu, "Computation of rotation minimizing frames", ACM TOG 27 (2008).
pub(crate) fn double_reflection(
    vector: DVec3,
    [before, after]: [DVec3; 2],
    displacement: DVec3,
) -> DVec3 {
    let mirror = |v: DVec3, axis: DVec3| v - axis * (2.0 * axis.dot(v));
    let chord = Point::unit(displacement);
    let (vector, tangent) = (mirror(vector, chord), mirror(before, chord));
    mirror(vector, Point::unit(after - tangent))
}

/// The normal after the tangent has rotated from `before` to `after` at one point, by the smallest rotation. `axis` is
/// the rotation axis for a reversed tangent; if it is zero (unknown), the normal stays.
fn rotated_normal(before: DVec3, normal: DVec3, after: DVec3, axis: DVec3) -> DVec3 {
    let (mut before, mut normal) = (before, normal);
    if before.dot(after) < BACK_COSINE && (axis != DVec3::ZERO || before.dot(after) < -1.0 + 1e-12)
    {
        if axis != DVec3::ZERO {
            normal = axis * (2.0 * axis.dot(normal)) - normal;
        }
        before = -before;
    }
    let shared = normal.dot(after) / (1.0 + before.dot(after));
    let normal = normal - (before + after) * shared;
    Point::unit(normal - after * after.dot(normal))
}
