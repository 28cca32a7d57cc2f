//! Checks of curves: construction, evaluation, derivatives, other forms, measures, parameters of points with a property.

use crate::arguments::Space;
use crate::check::*;
use crate::geometry::*;
use crate::lines::*;
use crate::shared::*;
use casteljau::curve::{Basis, Moments, bernstein};
use casteljau::glam::DVec2;
use casteljau::{CrossProduct, Curve};

finite! {
    // tests/curve/copy.rs
    [P: Space] accessors(curve: Curve<P>):
        call(|| (curve.degree(), [curve.control_points(), &[curve.start(), curve.end()]].concat()))?;
    // tests/curve/convert.rs
    [P: Space] low_degrees(curve: Curve<P>): {
        let points = curve.control_points();
        let [p0, p1, p2, p3] = std::array::from_fn(|i| points[i % points.len()]);
        call(|| [Curve::line(p0, p1), Curve::quad(p0, p1, p2), Curve::cubic(p0, p1, p2, p3)])?
    };
    // tests/curve/basis.rs
    [P: Space] to_basis(curve: Curve<P>, basis: Basis): answer!(curve.to_basis(basis), "matrix|basis");
    [] basis_matrix(basis: Basis): call(|| basis.matrix())?;
    // tests/curve/eval.rs
    [] bernstein_weights(degree: usize, t: f64): answer!(bernstein(degree, t), "degree");
    [P: Space] sample_into(curve: Curve<P>, segments: usize): call(|| {
        let mut points = vec![P::default(); segments + 1];
        curve.sample_into(&mut points);
        points
    })?;
    [P: Space] every_level(curve: Curve<P>, t: f64): call(|| curve.de_casteljau(t))?;
    // tests/curve/slope.rs
    [P: Space] derivative(curve: Curve<P>): call(|| curve.derivative())?;
    [P: Space] derivative_at(curve: Curve<P>, t: f64, k: usize): call(|| curve.derivative_at(t, k))?;
    [P: Space] tangent(curve: Curve<P>, t: f64): call(|| curve.tangent(t))?;
    [P: Space] normal(curve: Curve<P>, t: f64): call(|| curve.normal(t))?;
    // tests/curve/pieces.rs
    [P: Space] halve(curve: Curve<P>): call(|| curve.halve())?;
    [P: Space] elevate(curve: Curve<P>): answer!(curve.elevate());
    // tests/curve/subdivide.rs
    [P: Space] subdivide(curve: Curve<P>, tolerance: f64): answer!(curve.subdivide(tolerance), "tolerance");
    // tests/flatten
    [P: Space] flatten_with(curve: Curve<P>, tolerance: f64): {
        let mut points = Vec::new();
        answer!(curve.flatten_with(tolerance, |_, p| points.push(p)), "tolerance");
        call(|| points)?
    };
}

pub(crate) fn new<P: Space>(points: Vec<P>) -> Checked {
    let curve = answer!(Curve::new(&points));
    same(curve.control_points(), points.as_slice(), "the points")
}

pub(crate) fn approx_eq<P: Space>(curve: Curve<P>, other: Curve<P>, tolerance: f64) -> Checked {
    compares(Curve::approx_eq, (&curve, &other), tolerance)
}

pub(crate) fn from_basis<P: Space>(basis: Basis, points: [P; 4]) -> Checked {
    let curve = answer!(Curve::from_basis(basis, points), "points");
    same(curve.degree(), 3, "the degree")
}

pub(crate) fn interpolate<P: Space>(points: Vec<P>, ts: Option<Vec<f64>>) -> Checked {
    let curve = answer!(Curve::interpolate(&points, ts.as_deref()), "ts");
    let slack = 64.0 * slack(largest(curve.control_points()), points.len());
    for (&t, &point) in ts.iter().flatten().zip(&points) {
        let slack = slack * growth(t, curve.degree());
        near(curve.eval(t), point, slack, t)?;
    }
    let misses = curve.end().distance(points[points.len() - 1]);
    holds!(ts.is_some() || misses <= slack, "misses the last point")
}

/// Checks that a direction is a unit vector or zero.
pub(crate) fn unit_or_zero<P: Space>(direction: P, slack: f64) -> Checked {
    let length = direction.norm();
    let fits = length == 0.0 || (length - 1.0).abs() <= slack;
    holds!(fits, "the length of a direction is {length}")
}

pub(crate) fn curvature<P: Space>(curve: Curve<P>, t: f64) -> Checked {
    let curvature = call_unbounded(|| curve.curvature(t))?;
    let (plane, line) = (P::DIMENSION == 2, curve.degree() == 1);
    ensure!(plane || curvature >= 0.0, "{curvature} in space");
    ensure!(!line || curvature == 0.0, "{curvature} of a line");
    let (first, second) = (curve.derivative_at(t, 1), curve.derivative_at(t, 2));
    let (speed, size) = (first.norm(), size() * growth(t, curve.degree()));
    // Far from a cusp the formula is accurate; elsewhere rounding decides.
    if is_extreme() || speed <= 1e-3 * size {
        return Ok(());
    }
    let expected = first.cross(second).size() / speed.powi(3);
    let rounding = curvature_rounding(&curve, size, speed, second.norm());
    let slack = 1e-6 * expected + rounding;
    near(curvature.abs(), expected, slack, "the formula")
}

/// The effect of rounding on B′ × B″ / |B′|³. The error of the k-th derivative is the error of points times 2ᵏ n!/(n −
/// k)!. In space B″ counts as parallel to B′ below an angle of 1e-13 between the vectors without the factors n and n (n
/// − 1).
fn curvature_rounding<P: Space>(curve: &Curve<P>, size: f64, speed: f64, bend: f64) -> f64 {
    let n = real(curve.degree());
    let slack = slack(size, curve.degree());
    let (first, second) = (2.0 * n * slack, 4.0 * n * (n - 1.0) * slack);
    (first / speed * bend + second + 1e-13 * bend) / (speed * speed)
}

pub(crate) fn torsion<P: Space>(curve: Curve<P>, t: f64) -> Checked {
    let torsion = call_unbounded(|| curve.torsion(t))?;
    let twists = P::DIMENSION == 3 && curve.degree() > 2;
    holds!(twists || torsion == 0.0, "{torsion} of a plane curve")
}

pub(crate) fn reduce<P: Space>(curve: Curve<P>) -> Checked {
    let reduced = value!(curve.reduce());
    let n = curve.degree();
    same(reduced.curve.degree(), (n - 1).max(1), "the degree")?;
    // The error comes from a formula: the control points are rounded, and the n-th difference enlarges this rounding.
    let size = largest(reduced.curve.control_points()).max(size());
    let room = reduced.error * (1.0 + 1e-9) + 16.0 * slack(size, n);
    agree(16, room, |t| reduced.curve.eval(t), |t| curve.eval(t))
}

pub(crate) fn moments(curve: Curve<DVec2>) -> Checked {
    let (moments, size) = (value!(curve.moments()), size());
    let (left, right) = curve.split(0.375);
    let mut sum = left.moments();
    sum += right.moments();
    let slack = 64.0 * slack(size, curve.degree()) * size;
    near(moments.area, curve.area(), slack, "the area")?;
    are_moments(moments, sum, slack, size)
}

/// Checks that moments are the sum of those of the parts.
pub(crate) fn are_moments(got: Moments, sum: Moments, slack: f64, size: f64) -> Checked {
    near(got.area, sum.area, slack, "the sum of the areas")?;
    near(got.x, sum.x, slack * size, "the sum of x")?;
    near(got.y, sum.y, slack * size, "the sum of y")?;
    near(got.xx, sum.xx, slack * size * size, "the sum of xx")?;
    near(got.xy, sum.xy, slack * size * size, "the sum of xy")?;
    near(got.yy, sum.yy, slack * size * size, "the sum of yy")
}

pub(crate) fn hull(curve: Curve<DVec2>) -> Checked {
    let (hull, points) = (call(|| curve.hull())?, curve.control_points());
    let known = !hull.is_empty() && hull.iter().all(|p| points.contains(p));
    ensure!(known, "a corner is no control point");
    if is_extreme() || hull.len() < 3 {
        return Ok(());
    }
    // In every direction the hull extends as far as the points. Its signed area is not negative, except for rounding.
    let slack = slack(size(), 2);
    for k in 0..32 {
        let direction = DVec2::from_angle(real(k) * std::f64::consts::TAU / 32.0);
        let reach = |points: &[DVec2]| -min(points.iter().map(|p| -p.dot(direction)));
        at_most(reach(points), reach(&hull) + slack, "a point is outside")?;
    }
    let sides = hull.iter().zip(hull.iter().cycle().skip(1));
    let area = |(&a, &b): (&DVec2, &DVec2)| (a - hull[0]).perp_dot(b - hull[0]);
    let twice: f64 = sides.map(area).sum();
    at_most(-twice, slack * size(), "clockwise")
}

/// The parameters strictly between 0 and 1.
fn ascends_inside(ts: &[f64]) -> Checked {
    let ascends = ascends(ts, f64::MIN_POSITIVE, 1.0_f64.next_down());
    holds!(ascends, "{ts:?} do not ascend inside (0, 1)")
}

pub(crate) fn extrema<P: Space>(curve: Curve<P>, axis: usize) -> Checked {
    let ts = answer!(curve.extrema(axis), "axis");
    ascends_inside(&ts)?;
    ensure!(ts.len() < curve.degree(), "too many extrema: {ts:?}");
    // The coordinate is monotone between the extrema, except for rounding.
    let slack = curve.slack();
    let all: Vec<f64> = [0.0].into_iter().chain(ts).chain([1.0]).collect();
    for w in all.windows(2) {
        let at = |s: f64| curve.eval(w[0] * (1.0 - s) + w[1] * s).coordinate(axis);
        let (low, high) = (at(0.0).min(at(1.0)) - slack, at(0.0).max(at(1.0)) + slack);
        let mut values = parameters(8, 1.0).map(at);
        let monotone = values.all(|x| (low..=high).contains(&x));
        ensure!(monotone, "an extremum is missing in {w:?}");
    }
    Ok(())
}

/// Checks that a root lies between samples whose values have opposite signs and exceed rounding.
fn roots_are_complete(ts: &[f64], values: &[(f64, f64)], slack: f64) -> Checked {
    for w in values.windows(2) {
        let ((t0, a), (t1, b)) = (w[0], w[1]);
        let crosses = a.abs() > slack && b.abs() > slack && (a > 0.0) != (b > 0.0);
        let found = ts.iter().any(|t| (t0..=t1).contains(t));
        ensure!(!crosses || found, "no root between {t0} and {t1}");
    }
    Ok(())
}

pub(crate) fn times_at_coordinate<P: Space>(curve: Curve<P>, axis: usize, value: f64) -> Checked {
    let ts = answer!(curve.times_at_coordinate(axis, value), "axis");
    ensure!(ascends(&ts, 0.0, 1.0), "{ts:?} do not ascend in [0, 1]");
    let slack = 4.0 * curve.slack();
    let at = |t: f64| curve.eval(t).coordinate(axis) - value;
    let worst = max(ts.iter().map(|&t| at(t).abs()));
    at_most(worst, slack, "the coordinate")?;
    let samples: Vec<(f64, f64)> = parameters(32, 1.0).map(|t| (t, at(t))).collect();
    roots_are_complete(&ts, &samples, slack)
}

pub(crate) fn inflections(curve: Curve<DVec2>) -> Checked {
    let ts = value!(curve.inflections());
    ascends_inside(&ts)?;
    holds!(curve.degree() > 3 || ts.len() <= 2, "{ts:?} of a cubic")
}

pub(crate) fn cusps<P: Space>(curve: Curve<P>) -> Checked {
    let ts = value!(curve.cusps());
    ascends_inside(&ts)?;
    // B′ is evaluated at the root of a function that is uncertain by rounding: B″ times the uncertainty of t is added,
    // √ε at worst.
    let slack = 1e-6 * size() * real(curve.degree()).powi(2);
    let speeds = ts.iter().map(|&t| curve.derivative_at(t, 1).norm());
    at_most(max(speeds), slack, "the speed at a cusp")
}

pub(crate) fn classify<P: Space>(curve: Curve<P>) -> Checked {
    let kind = format!("{:?}", value!(curve.classify()));
    ensure!(
        kind != "Twisted" || P::DIMENSION == 3,
        "a plane curve is twisted"
    );
    let straight = kind == "Line" || kind == "Point";
    ensure!(curve.degree() > 1 || straight, "a line is {kind}");
    let mut points = curve.control_points().iter();
    let is_point = points.all(|&p| p == curve.start());
    holds!(!is_point || kind == "Point", "a point is {kind}")
}

pub(crate) fn tangents_from(curve: Curve<DVec2>, p: DVec2) -> Checked {
    let ts = answer!(curve.tangents_from(p));
    ensure!(ascends(&ts, 0.0, 1.0), "{ts:?} do not ascend in [0, 1]");
    let at = |t: f64| (curve.eval(t) - p).perp_dot(curve.derivative_at(t, 1));
    let slack = 64.0 * curve.slack() * size() * real(curve.degree());
    // Where the curve turns back, the cross product changes its sign without a tangent through p. So this omits the
    // pieces on which the direction turns by more than a right angle, and pieces on which the speed is almost zero,
    // where the tangent counts.
    let derivative = curve.derivative();
    let fastest = max(derivative.control_points().iter().map(|v| v.length()));
    let samples: Vec<(f64, f64)> = parameters(32, 1.0).map(|t| (t, at(t))).collect();
    for pair in samples.windows(2) {
        let ends = [pair[0].0, pair[1].0];
        let [a, b] = ends.map(|t| curve.tangent(t));
        let moves = |t: f64| curve.derivative_at(t, 1).length() > 1e-7 * fastest;
        if a.dot(b) > 0.0 && ends.into_iter().all(moves) {
            roots_are_complete(&ts, pair, slack)?;
        }
    }
    Ok(())
}

pub(crate) fn distance_to<P: Space>(curve: Curve<P>, other: Curve<P>) -> Checked {
    let found = value!(curve.distance_to(&other));
    let range = 0.0..=1.0;
    let (t, u) = (found.t, found.u);
    ensure!(range.contains(&t) && range.contains(&u), "({t}, {u})");
    let slack = 4.0 * curve.slack().max(other.slack()) + 1e-11 * found.distance;
    let there = curve.eval(t).distance(other.eval(u));
    near(there, found.distance, slack, "the distance there")?;
    let others = other.sample(16)?;
    for p in curve.sample(16)? {
        let closest = from_nearest(p, others.iter().copied());
        at_most(found.distance, closest + slack, "samples are nearer")?;
    }
    Ok(())
}

pub(crate) fn hausdorff<P: Space>(curve: Curve<P>, other: Curve<P>) -> Checked {
    let got = value!(curve.hausdorff(&other));
    let slack = 4.0 * curve.slack().max(other.slack()) + 1e-8 * got;
    for (from, to) in [(&curve, &other), (&other, &curve)] {
        for p in [from.start(), from.end()] {
            at_most(to.nearest(p)?.distance, got + slack, "an end is farther")?;
        }
    }
    let (points, others) = (curve.control_points(), other.control_points());
    let farthest = |&p: &P| max(others.iter().map(|&q| p.distance(q)));
    at_most(
        got,
        max(points.iter().map(farthest)) + slack,
        "farther than all control points",
    )
}
