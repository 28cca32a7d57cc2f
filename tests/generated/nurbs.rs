//! Checks of NURBS curves.

use crate::arguments::Space;
use crate::check::*;
use crate::geometry::*;
use crate::rational::{are_contacts, are_passed_twice, contact_slack};
use crate::recorder::Recorder;
use casteljau::glam::DVec2;
use casteljau::{NurbsCurve, Spline};

finite! {
    // tests/rational/nurbs.rs
    [P: Space] accessors(curve: NurbsCurve<P>): {
        let ends = [curve.start(), curve.end()];
        let domain = (curve.domain(), curve.joints().to_vec());
        call(|| ((curve.degree(), curve.is_closed()), (ends, domain)))?;
        call(|| (curve.segments().to_vec(), curve.clone()))?
    };
    [P: Space] interpolate(points: Vec<P>, degree: usize): answer!(NurbsCurve::interpolate(&points, degree), "points");
    [P: Space] greville(curve: NurbsCurve<P>): call(|| curve.greville())?;
    [P: Space] elevate(curve: NurbsCurve<P>): answer!(curve.elevate());
    [P: Space] derivative_at(curve: NurbsCurve<P>, t: f64, k: usize): answer!(curve.derivative_at(inside(&curve, t), k));
    [P: Space] tangent(curve: NurbsCurve<P>, t: f64): call(|| curve.tangent(inside(&curve, t)))?;
    [P: Space] normal(curve: NurbsCurve<P>, t: f64): call(|| curve.normal(inside(&curve, t)))?;
    [P: Space] curvature(curve: NurbsCurve<P>, t: f64): call_unbounded(|| curve.curvature(inside(&curve, t)))?;
    [P: Space] eval_at(curve: NurbsCurve<P>, ts: Vec<f64>):
        call(|| curve.eval_at(&ts.iter().map(|&t| inside(&curve, t)).collect::<Vec<_>>()))?;
    [P: Space] project(curve: NurbsCurve<P>, map: P::Projective): answer!(curve.project(&map), "projected weights|image|weights");
    [P: Space] control_bounds(curve: NurbsCurve<P>): call(|| curve.control_bounds())?;
    [P: Space] arc(curve: NurbsCurve<P>, start: f64, end: f64): {
        let points = curve.control_points();
        answer!(NurbsCurve::arc(points[0], points[1], points[0], start, end), "end|points")
    };
    [] circle(curve: NurbsCurve<DVec2>, radius: f64): answer!(NurbsCurve::circle(curve.start(), radius), "radius|points");
    [] ellipse(curve: NurbsCurve<DVec2>, radius: f64, other: f64, rotation: f64):
        answer!(NurbsCurve::ellipse(curve.start(), DVec2::new(radius, other), rotation), "radius|points");
    [] area(curve: NurbsCurve<DVec2>): call(|| curve.area())?;
    [] to_svg(curve: NurbsCurve<DVec2>, tolerance: f64): answer!(curve.to_svg(tolerance), "tolerance");
}

/// The parameter in the domain that is nearest to t.
fn inside<P: Space>(curve: &NurbsCurve<P>, t: f64) -> f64 {
    let [from, to] = curve.domain();
    t.clamp(from, to)
}

pub(crate) fn new<P: Space>(curve: NurbsCurve<P>) -> Checked {
    let (points, weights) = (curve.control_points(), Some(curve.weights()));
    let again = answer!(NurbsCurve::new(
        curve.degree(),
        points,
        weights,
        curve.knots(),
        curve.is_closed()
    ));
    same(again, curve, "the curve")
}

pub(crate) fn from<P: Space>(spline: Spline<P>) -> Checked {
    let curve = value!(NurbsCurve::from(&spline));
    let slack = 64.0 * slack(size(), curve.degree());
    let end = real(spline.segment_count());
    parameters(16, end).try_for_each(|t| near(curve.eval(t), spline.eval(t), slack, t))
}

pub(crate) fn approx_eq<P: Space>(curve: NurbsCurve<P>, tolerance: f64) -> Checked {
    call(|| curve.approx_eq(&curve.reverse(), tolerance))?;
    holds!(curve.approx_eq(&curve, 0.0), "not equal to itself")
}

/// Checks that a curve has the points of another one. Large ratios of weights enlarge rounding.
fn has_same_points<P: Space>(curve: &NurbsCurve<P>, other: &NurbsCurve<P>) -> Checked {
    let weights = curve.weights().iter().copied();
    let ratio = max(weights.clone()) / min(weights);
    if ratio > 1e4 {
        return Ok(());
    }
    let slack = ratio * 64.0 * slack(size(), curve.degree());
    let [from, to] = curve.domain();
    agree(
        8,
        slack,
        |s| other.eval(from * (1.0 - s) + to * s),
        |s| curve.eval(from * (1.0 - s) + to * s),
    )
}

pub(crate) fn reverse<P: Space>(curve: NurbsCurve<P>) -> Checked {
    let reversed = value!(curve.reverse());
    same(reversed.domain(), curve.domain(), "the domain")
}

pub(crate) fn insert_knot<P: Space>(curve: NurbsCurve<P>, t: f64, times: usize) -> Checked {
    let finer = answer!(curve.insert_knot(t, times), "t|times");
    has_same_points(&curve, &finer)
}

pub(crate) fn remove_knot<P: Space>(
    curve: NurbsCurve<P>,
    t: f64,
    tolerance: Option<f64>,
) -> Checked {
    // Without a bound, which is infinity as documented, the knot stays.
    let (kept, error) = answer!(
        curve
            .remove_knot(t, tolerance)
            .map(|(kept, error)| (kept, (error != f64::INFINITY).then_some(error))),
        "t|weights|points|tolerance"
    );
    ensure!(error.is_none_or(|error| error >= 0.0), "a negative bound");
    let stays = tolerance.is_some_and(|tolerance| error.is_none_or(|error| error > tolerance));
    ensure!(stays || error.is_some(), "no bound without a tolerance");
    holds!(stays == (kept == curve), "a knot that should stay")
}

pub(crate) fn refine<P: Space>(curve: NurbsCurve<P>, ts: Vec<f64>) -> Checked {
    let finer = answer!(curve.refine(&ts), "ts");
    has_same_points(&curve, &finer)
}

pub(crate) fn split<P: Space>(curve: NurbsCurve<P>, t: f64) -> Checked {
    let (left, right) = answer!(curve.split(t), "t");
    same([left.domain()[1], right.domain()[0]], [t; 2], "the domains")
}

pub(crate) fn subsegment<P: Space>(curve: NurbsCurve<P>, t0: f64, t1: f64) -> Checked {
    let part = answer!(curve.subsegment(t0..t1), "t0|t1");
    same(part.domain(), [t0.min(t1), t0.max(t1)], "the domain")
}

pub(crate) fn transform<P: Space>(curve: NurbsCurve<P>, map: P::Affine) -> Checked {
    let image = answer!(curve.transform(&map), "image");
    crate::lines::are_images(curve.control_points(), image.control_points(), &map)
}

pub(crate) fn eval<P: Space>(curve: NurbsCurve<P>, t: f64) -> Checked {
    let t = inside(&curve, t);
    let p = value!(curve.eval(t));
    let slack = 4.0 * slack(size(), curve.degree());
    holds!(
        holds(&curve.control_bounds(), p, slack),
        "outside of the box of the control points"
    )
}

pub(crate) fn sample<P: Space>(curve: NurbsCurve<P>, segments: usize) -> Checked {
    let points = answer!(curve.sample(segments), "segments");
    same(
        [points[0], points[segments]],
        [curve.start(), curve.end()],
        "the ends",
    )
}

pub(crate) fn bounds<P: Space>(curve: NurbsCurve<P>) -> Checked {
    let bounds = value!(curve.bounds());
    let slack = 4.0 * slack(size(), curve.degree());
    let outside = curve
        .sample(32)?
        .into_iter()
        .find(|&p| !holds(&bounds, p, slack));
    holds!(outside.is_none(), "a point is outside")
}

pub(crate) fn extrema<P: Space>(curve: NurbsCurve<P>, axis: usize) -> Checked {
    let ts = answer!(curve.extrema(axis), "axis");
    let [from, to] = curve.domain();
    holds!(ascends(&ts, from, to), "{ts:?} do not ascend in the domain")
}

pub(crate) fn nearest<P: Space>(curve: NurbsCurve<P>, p: P) -> Checked {
    let found = answer!(curve.nearest(p));
    let slack = 64.0 * slack(size(), curve.degree()) + 1e-9 * found.distance;
    at_most(
        found.distance,
        from_nearest(p, curve.sample(64)?) + slack,
        "samples are nearer",
    )
}

pub(crate) fn length<P: Space>(curve: NurbsCurve<P>) -> Checked {
    let length = value!(curve.length());
    if !crate::rational::has_moderate_weights(curve.weights()) {
        return Ok(());
    }
    let chord = curve.start().distance(curve.end());
    at_most(
        chord,
        length + 1e-9 * length + slack(size(), curve.degree()),
        "the chord",
    )
}

pub(crate) fn time_at_length<P: Space>(curve: NurbsCurve<P>, s: f64) -> Checked {
    let found = value!(curve.point_at_length(s));
    same(found.t, inside(&curve, found.t), "outside of the domain")?;
    same(found.point, curve.eval(found.t), "the point")
}

pub(crate) fn flatten<P: Space>(curve: NurbsCurve<P>, tolerance: f64) -> Checked {
    let line = answer!(curve.flatten(tolerance), "tolerance");
    let [from, to] = curve.domain();
    same(line.points.len(), line.ts.len(), "the number of parameters")?;
    holds!(ascends(&line.ts, from, to), "the parameters do not ascend")
}

pub(crate) fn to_spline<P: Space>(curve: NurbsCurve<P>, tolerance: f64) -> Checked {
    let spline = answer!(curve.to_spline(tolerance), "tolerance");
    same(spline.eval(0.0), curve.start(), "the start")
}

pub(crate) fn intersections(curve: NurbsCurve<DVec2>, other: NurbsCurve<DVec2>) -> Checked {
    let found = value!(curve.intersections(&other));
    let degree = curve.degree().max(other.degree());
    let slack = 16.0 * contact_slack(degree, &[curve.weights(), other.weights()]);
    let (a, b) = (|t| curve.eval(t), |u| other.eval(u));
    are_contacts(&found, [curve.domain(), other.domain()], a, b, slack)
}

pub(crate) fn self_intersections(curve: NurbsCurve<DVec2>) -> Checked {
    let found = value!(curve.self_intersections());
    let slack = 16.0 * contact_slack(curve.degree(), &[curve.weights()]);
    are_passed_twice(&found, curve.domain(), |t| curve.eval(t), slack)
}

pub(crate) fn trace(curve: NurbsCurve<DVec2>, tolerance: f64) -> Checked {
    let mut recorder = Recorder::default();
    answer!(curve.trace_within(&mut recorder, tolerance), "tolerance");
    Ok(())
}
