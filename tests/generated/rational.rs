//! Checks of rational curves.

use crate::arguments::Space;
use crate::check::*;
use crate::geometry::*;
use crate::recorder::Recorder;
use casteljau::curve::{Intersection, IntersectionKind, SelfIntersection};
use casteljau::glam::DVec2;
use casteljau::{Curve, RationalCurve};
use std::iter::zip;

finite! {
    // tests/rational
    [P: Space] accessors(curve: RationalCurve<P>):
        call(|| (curve.degree(), [curve.control_points(), &[curve.start(), curve.end()]].concat()))?;
    [P: Space] conic(points: [P; 4], w: f64): answer!(RationalCurve::conic(points[0], points[1], points[2], w));
    [P: Space] from(curve: Curve<P>): call(|| RationalCurve::from(&curve))?;
    [P: Space] derivative_at(curve: RationalCurve<P>, t: f64, k: usize): answer!(curve.derivative_at(t, k));
    [P: Space] tangent(curve: RationalCurve<P>, t: f64): call(|| curve.tangent(t))?;
    [P: Space] normal(curve: RationalCurve<P>, t: f64): call(|| curve.normal(t))?;
    [P: Space] curvature(curve: RationalCurve<P>, t: f64): call_unbounded(|| curve.curvature(t))?;
    [P: Space] elevate(curve: RationalCurve<P>): answer!(curve.elevate());
    [P: Space] reparametrize(curve: RationalCurve<P>): answer!(curve.reparametrize(), "weights");
    [P: Space] project(curve: RationalCurve<P>, map: P::Projective): answer!(curve.project(&map), "projected weights|image|weights");
    [P: Space] control_bounds(curve: RationalCurve<P>): call(|| curve.control_bounds())?;
    [] area(curve: RationalCurve<DVec2>): call(|| curve.area())?;
    [] inflections(curve: RationalCurve<DVec2>): call(|| curve.inflections())?;
    [] to_elliptical_arc(curve: RationalCurve<DVec2>): call(|| curve.to_elliptical_arc())?;
    [] to_svg(curve: RationalCurve<DVec2>, tolerance: f64): answer!(curve.to_svg(tolerance), "tolerance");
}

pub(crate) fn new<P: Space>(points: Vec<P>, weights: Vec<f64>) -> Checked {
    let curve = answer!(RationalCurve::new(&points, &weights), "weights");
    same(curve.control_points(), points.as_slice(), "the points")?;
    same(curve.weights(), weights.as_slice(), "the weights")
}

pub(crate) fn approx_eq<P: Space>(curve: RationalCurve<P>, tolerance: f64) -> Checked {
    let equal = call(|| curve.approx_eq(&curve.reverse(), tolerance))?;
    holds!(curve.approx_eq(&curve, 0.0) || equal, "not equal to itself")
}

/// Whether the curve has no point at t because its denominator is not above 0 there.
fn has_no_point<P: Space>(curve: &RationalCurve<P>, t: f64) -> bool {
    !(0.0..=1.0).contains(&t) && !curve.eval(t).is_finite()
}

pub(crate) fn eval<P: Space>(curve: RationalCurve<P>, t: f64) -> Checked {
    if has_no_point(&curve, t) {
        return Ok(());
    }
    let p = value!(curve.eval(t));
    let slack = slack(size(), curve.degree());
    let inside = !(0.0..=1.0).contains(&t) || holds(&curve.control_bounds(), p, slack);
    holds!(inside, "outside of the box of the control points")
}

pub(crate) fn eval_at<P: Space>(curve: RationalCurve<P>, ts: Vec<f64>) -> Checked {
    let ts: Vec<f64> = ts
        .into_iter()
        .filter(|&t| !has_no_point(&curve, t))
        .collect();
    let points = call(|| curve.eval_at(&ts))?;
    let expected: Vec<P> = ts.iter().map(|&t| curve.eval(t)).collect();
    same(points, expected, "the points")
}

pub(crate) fn sample<P: Space>(curve: RationalCurve<P>, segments: usize) -> Checked {
    let points = answer!(curve.sample(segments), "segments");
    same(points.len(), segments + 1, "the number of points")?;
    same(
        [points[0], points[segments]],
        [curve.start(), curve.end()],
        "the ends",
    )
}

/// Checks that a part has points of the curve.
fn is_on<P: Space>(curve: &RationalCurve<P>, part: &RationalCurve<P>) -> Checked {
    let slack = 64.0 * slack(size(), curve.degree());
    for p in part.sample(4)? {
        at_most(curve.nearest(p)?.distance, slack, "not on the curve")?;
    }
    Ok(())
}

pub(crate) fn split<P: Space>(curve: RationalCurve<P>, t: f64) -> Checked {
    let (left, right) = answer!(curve.split(t), "weights|points");
    same(left.end(), right.start(), "the point between the parts")?;
    same(
        [left.start(), right.end()],
        [curve.start(), curve.end()],
        "the ends",
    )
}

pub(crate) fn halve<P: Space>(curve: RationalCurve<P>) -> Checked {
    let (left, right) = value!(curve.halve());
    is_on(&curve, &left)?;
    is_on(&curve, &right)
}

pub(crate) fn subsegment<P: Space>(curve: RationalCurve<P>, t0: f64, t1: f64) -> Checked {
    let part = answer!(curve.subsegment(t0..t1), "weights|points");
    same(
        [part.start(), part.end()],
        [curve.eval(t0), curve.eval(t1)],
        "the ends",
    )
}

pub(crate) fn reverse<P: Space>(curve: RationalCurve<P>) -> Checked {
    let reversed = call(|| curve.reverse())?;
    same(reversed.reverse(), curve, "twice backwards")
}

pub(crate) fn transform<P: Space>(curve: RationalCurve<P>, map: P::Affine) -> Checked {
    let image = answer!(curve.transform(&map), "image");
    crate::lines::are_images(curve.control_points(), image.control_points(), &map)
}

pub(crate) fn bounds<P: Space>(curve: RationalCurve<P>) -> Checked {
    let bounds = value!(curve.bounds());
    let slack = 4.0 * slack(size(), curve.degree());
    for p in curve.sample(32)? {
        ensure!(holds(&bounds, p, slack), "a point is outside");
    }
    Ok(())
}

pub(crate) fn extrema<P: Space>(curve: RationalCurve<P>, axis: usize) -> Checked {
    let ts = answer!(curve.extrema(axis), "axis");
    holds!(
        ascends(&ts, f64::MIN_POSITIVE, 1.0_f64.next_down()),
        "{ts:?} do not ascend inside (0, 1)"
    )
}

pub(crate) fn nearest<P: Space>(curve: RationalCurve<P>, p: P) -> Checked {
    let found = answer!(curve.nearest(p));
    let slack = 64.0 * slack(size(), curve.degree()) + 1e-9 * found.distance;
    let samples = curve.sample(64)?;
    at_most(
        found.distance,
        from_nearest(p, samples) + slack,
        "samples are nearer",
    )
}

/// Whether the documented precision of lengths holds: for weights whose ratios are at most 2²⁰.
pub(crate) fn has_moderate_weights(weights: &[f64]) -> bool {
    max(weights.iter().copied()) <= 1_048_576.0 * min(weights.iter().copied())
}

pub(crate) fn length<P: Space>(curve: RationalCurve<P>) -> Checked {
    let length = value!(curve.length());
    if !has_moderate_weights(curve.weights()) {
        return Ok(());
    }
    let chord = curve.start().distance(curve.end());
    let slack = 1e-9 * length + slack(size(), curve.degree());
    at_most(chord, length + slack, "the chord")?;
    at_most(
        length,
        polygon_length(curve.control_points()) + slack,
        "the length",
    )
}

pub(crate) fn time_at_length<P: Space>(curve: RationalCurve<P>, s: f64) -> Checked {
    let found = value!(curve.point_at_length(s));
    ensure!((0.0..=1.0).contains(&found.t), "t = {}", found.t);
    same(found.point, curve.eval(found.t), "the point")
}

pub(crate) fn flatten<P: Space>(curve: RationalCurve<P>, tolerance: f64) -> Checked {
    let line = answer!(curve.flatten(tolerance), "tolerance");
    same(line.points.len(), line.ts.len(), "the number of parameters")?;
    let pairs = line.ts.windows(2).zip(line.points.windows(2));
    for (t, p) in pairs.step_by(1 + line.ts.len() / 64) {
        let off = from_segment(curve.eval(0.5 * (t[0] + t[1])), p[0], p[1]);
        at_most(off, tolerance * (1.0 + 1e-9), "the distance")?;
    }
    Ok(())
}

pub(crate) fn to_spline<P: Space>(curve: RationalCurve<P>, tolerance: f64) -> Checked {
    let spline = answer!(curve.to_spline(tolerance), "tolerance");
    same(
        [spline.eval(0.0), spline.eval(real(spline.segment_count()))],
        [curve.start(), curve.end()],
        "the ends",
    )?;
    let slack = tolerance + 256.0 * slack(size(), curve.degree());
    for segment in spline.segments().step_by(1 + spline.segment_count() / 16) {
        let p = segment.eval(0.5);
        at_most(curve.nearest(p)?.distance, slack, "the distance")?;
    }
    Ok(())
}

/// The largest distance of a curve at an intersection from its point, for weights whose ratios are at most 10⁴: rounding of
/// the parameter moves the point by its speed, which the ratio enlarges. Larger ratios have no bound.
pub(crate) fn contact_slack(degree: usize, weights: &[&[f64]]) -> f64 {
    let ratios = weights
        .iter()
        .map(|w| max(w.iter().copied()) / min(w.iter().copied()));
    let ratio = max(ratios);
    if ratio > 1e4 {
        return f64::INFINITY;
    }
    ratio * 64.0 * slack(size(), degree)
}

/// Checks that both curves are at the stated points at the stated parameters, which are in the domains, and that the list is
/// sorted.
pub(crate) fn are_contacts(
    found: &[Intersection],
    domains: [[f64; 2]; 2],
    a: impl Fn(f64) -> DVec2,
    b: impl Fn(f64) -> DVec2,
    slack: f64,
) -> Checked {
    let times = found.iter().map(|contact| (contact.t, contact.u));
    ensure!(times.is_sorted(), "the list is not sorted");
    for contact in found {
        at_most(a(contact.t).distance(contact.point), slack, "the point")?;
        let mut pairs = vec![[contact.t, contact.u]];
        if let IntersectionKind::Overlap { t_end, u_end } = contact.kind {
            pairs.push([t_end, u_end]);
        }
        for [t, u] in pairs {
            let mut inside = zip([t, u], domains);
            let is_inside = inside.all(|(t, [from, to])| (from..=to).contains(&t));
            ensure!(is_inside, "({t}, {u}) is out of range");
            at_most(a(t).distance(b(u)), slack, format_args!("({t}, {u})"))?;
        }
    }
    Ok(())
}

/// Checks that the curve passes the stated points twice.
pub(crate) fn are_passed_twice(
    found: &[SelfIntersection],
    [from, to]: [f64; 2],
    curve: impl Fn(f64) -> DVec2,
    slack: f64,
) -> Checked {
    ensure!(found.is_sorted_by(|a, b| a.t <= b.t), "not sorted");
    for &SelfIntersection { t, u, point, .. } in found {
        let in_range = from <= t && t < u && u <= to;
        ensure!(in_range, "({t}, {u}) is out of range");
        at_most(curve(t).distance(point), slack, "the point")?;
        at_most(curve(u).distance(point), slack, format_args!("({t}, {u})"))?;
    }
    Ok(())
}

pub(crate) fn intersections(curve: RationalCurve<DVec2>, other: RationalCurve<DVec2>) -> Checked {
    let found = value!(curve.intersections(&other));
    let degree = curve.degree().max(other.degree());
    let slack = contact_slack(degree, &[curve.weights(), other.weights()]);
    let (a, b) = (|t| curve.eval(t), |u| other.eval(u));
    are_contacts(&found, [[0.0, 1.0]; 2], a, b, slack)
}

pub(crate) fn intersections_with_curve(
    rational: RationalCurve<DVec2>,
    curve: Curve<DVec2>,
) -> Checked {
    let found = value!(rational.intersections_with_curve(&curve));
    let degree = rational.degree().max(curve.degree());
    let slack = contact_slack(degree, &[rational.weights()]);
    let (a, b) = (|t| rational.eval(t), |u| curve.eval(u));
    are_contacts(&found, [[0.0, 1.0]; 2], a, b, slack)
}

pub(crate) fn self_intersections(curve: RationalCurve<DVec2>) -> Checked {
    let found = value!(curve.self_intersections());
    let slack = contact_slack(curve.degree(), &[curve.weights()]);
    are_passed_twice(&found, [0.0, 1.0], |t| curve.eval(t), slack)
}

pub(crate) fn trace(curve: RationalCurve<DVec2>, tolerance: f64) -> Checked {
    let mut recorder = Recorder::default();
    answer!(curve.trace_within(&mut recorder, tolerance), "tolerance");
    Ok(())
}
