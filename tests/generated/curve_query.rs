//! Checks of curves: intersections, nearest points, places with a property.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::curve::{Contact, Intersection, SelfIntersection};
use casteljau::glam::DVec2;
use casteljau::{Curve, Point};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Curve::intersect", intersect),
    ("Curve::intersect_spline", intersect_spline),
    ("Curve::self_intersections", self_intersections),
    ("Curve::nearest", both!(nearest)),
    ("Curve::extrema", both!(extrema)),
    ("Curve::times_at", both!(times_at)),
    ("Curve::inflections", inflections),
    ("Curve::cusps", both!(cusps)),
    ("Curve::classify", both!(classify)),
    ("Curve::tangents_from", tangents_from),
    ("Curve::distance_to", both!(distance_to)),
    ("Curve::hausdorff", both!(hausdorff)),
];

/// Both curves are at the stated point at the stated parameters, and the list is sorted.
pub(crate) fn contacts_hold(
    found: &[Intersection],
    ends: [f64; 2],
    slack: f64,
    a: impl Fn(f64) -> DVec2,
    b: impl Fn(f64) -> DVec2,
) -> Checked {
    let sorted = found
        .windows(2)
        .all(|w| (w[0].t, w[0].u) <= (w[1].t, w[1].u));
    ensure!(sorted, "the list is not sorted");
    for contact in found {
        let mut pairs = vec![(contact.t, contact.u)];
        if let Contact::Overlap { t_end, u_end } = contact.kind {
            pairs.push((t_end, u_end));
        }
        for (t, u) in pairs {
            ensure!(
                (0.0..=ends[0]).contains(&t) && (0.0..=ends[1]).contains(&u),
                "({t}, {u}) is out of range"
            );
            let gap = distance(a(t), b(u));
            ensure!(
                gap <= slack,
                "the curves are {gap:e} apart at ({t}, {u}), more than {slack:e}"
            );
        }
        let gap = distance(a(contact.t), contact.point);
        ensure!(
            gap <= slack,
            "the point is {gap:e} away from the curve at {}",
            contact.t
        );
    }
    Ok(())
}

fn intersect(case: &Case) -> Checked {
    let (a, b) = (curve::<DVec2>(case, "curve"), curve::<DVec2>(case, "other"));
    let found = value!(case, a.intersect(&b));
    let slack = 4.0 * slack(case.size(), a.degree().max(b.degree()));
    contacts_hold(&found, [1.0, 1.0], slack, |t| a.eval(t), |u| b.eval(u))
}

fn intersect_spline(case: &Case) -> Checked {
    let (a, b) = (
        curve::<DVec2>(case, "curve"),
        spline::<DVec2>(case, "spline"),
    );
    let found = value!(case, a.intersect_spline(&b));
    let slack = 4.0 * slack(case.size(), a.degree().max(12));
    contacts_hold(
        &found,
        [1.0, real(b.segment_count())],
        slack,
        |t| a.eval(t),
        |u| b.eval(u),
    )
}

/// Each pair of parameters belongs to one point.
pub(crate) fn doubles_hold(
    found: &[SelfIntersection],
    end: f64,
    slack: f64,
    at: impl Fn(f64) -> DVec2,
) -> Checked {
    for double in found {
        ensure!(
            0.0 <= double.t && double.t < double.u && double.u <= end,
            "({}, {}) is out of range",
            double.t,
            double.u
        );
        let gap = distance(at(double.t), at(double.u)).max(distance(at(double.t), double.point));
        ensure!(
            gap <= slack,
            "{gap:e} apart at ({}, {}), more than {slack:e}",
            double.t,
            double.u
        );
    }
    ensure!(
        found.windows(2).all(|w| w[0].t <= w[1].t),
        "the list is not sorted"
    );
    Ok(())
}

fn self_intersections(case: &Case) -> Checked {
    let curve = curve::<DVec2>(case, "curve");
    let found = value!(case, curve.self_intersections());
    doubles_hold(&found, 1.0, 4.0 * slack(case.size(), curve.degree()), |t| {
        curve.eval(t)
    })
}

/// The point belongs to t, the distance to the point, and no sample is nearer.
pub(crate) fn is_nearest<P: Point>(
    p: P,
    point: P,
    got: f64,
    slack: f64,
    samples: impl Iterator<Item = P>,
) -> Checked {
    let off = (distance(point, p) - got).abs();
    ensure!(off <= slack, "the distance is {off:e} off");
    let least = samples
        .map(|q| distance(q, p))
        .fold(f64::INFINITY, f64::min);
    ensure!(
        got <= least + slack,
        "{got:e}, but a sample is {least:e} away; the slack is {slack:e}"
    );
    Ok(())
}

fn nearest<P: Space>(case: &Case) -> Checked {
    let (curve, p) = (curve::<P>(case, "curve"), point::<P>(case, "p"));
    let nearest = answer!(case, curve.nearest(p));
    ensure!((0.0..=1.0).contains(&nearest.t), "t = {}", nearest.t);
    let slack = slack(case.size(), curve.degree());
    ensure!(
        distance(nearest.point, curve.eval(nearest.t)) <= slack,
        "the point is not that at t"
    );
    is_nearest(
        p,
        nearest.point,
        nearest.distance,
        4.0 * slack,
        curve.sample(100).expect("samples").into_iter(),
    )
}

fn extrema<P: Space>(case: &Case) -> Checked {
    let (curve, axis) = (curve::<P>(case, "curve"), count(case, "axis"));
    let ts = answer!(case, curve.extrema(axis), &["axis"]);
    ensure!(
        ascends(&ts, f64::MIN_POSITIVE, 1.0_f64.next_down()),
        "{ts:?} do not ascend inside (0, 1)"
    );
    ensure!(
        ts.len() < curve.degree(),
        "{} extrema of degree {}",
        ts.len(),
        curve.degree()
    );
    // The coordinate is monotone between them, but for rounding.
    let slack = slack(case.size(), curve.degree());
    let all: Vec<f64> = [0.0].into_iter().chain(ts).chain([1.0]).collect();
    for w in all.windows(2) {
        let values: Vec<f64> = parameters(8, 1.0)
            .map(|s| curve.eval(w[0] * (1.0 - s) + w[1] * s).coordinate(axis))
            .collect();
        let (low, high) = (
            values[0].min(values[8]) - slack,
            values[0].max(values[8]) + slack,
        );
        ensure!(
            values.iter().all(|x| (low..=high).contains(x)),
            "an extremum is missing between {} and {}",
            w[0],
            w[1]
        );
    }
    Ok(())
}

/// Between samples whose values have opposite signs, both clear of rounding, lies a root.
fn roots_are_complete(ts: &[f64], values: &[(f64, f64)], slack: f64) -> Checked {
    for w in values.windows(2) {
        let ((t0, a), (t1, b)) = (w[0], w[1]);
        let crosses = a.abs() > slack && b.abs() > slack && (a > 0.0) != (b > 0.0);
        ensure!(
            !crosses || ts.iter().any(|t| (t0..=t1).contains(t)),
            "no root between {t0} and {t1}"
        );
    }
    Ok(())
}

fn times_at<P: Space>(case: &Case) -> Checked {
    let (curve, axis, value) = (
        curve::<P>(case, "curve"),
        count(case, "axis"),
        number(case, "value"),
    );
    let ts = answer!(case, curve.times_at(axis, value), &["axis"]);
    ensure!(ascends(&ts, 0.0, 1.0), "{ts:?} do not ascend in [0, 1]");
    let slack = 4.0 * slack(case.size(), curve.degree());
    let at = |t: f64| curve.eval(t).coordinate(axis) - value;
    let worst = ts.iter().map(|&t| at(t).abs()).fold(0.0, f64::max);
    ensure!(
        worst <= slack,
        "the coordinate is {worst:e} off, more than {slack:e}"
    );
    let samples: Vec<(f64, f64)> = parameters(32, 1.0).map(|t| (t, at(t))).collect();
    roots_are_complete(&ts, &samples, slack)
}

fn inflections(case: &Case) -> Checked {
    let curve = curve::<DVec2>(case, "curve");
    let ts = value!(case, curve.inflections());
    ensure!(
        ascends(&ts, f64::MIN_POSITIVE, 1.0_f64.next_down()),
        "{ts:?} do not ascend inside (0, 1)"
    );
    ensure!(
        curve.degree() > 3 || ts.len() <= 2,
        "{} inflections of a cubic",
        ts.len()
    );
    Ok(())
}

fn cusps<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let ts = value!(case, curve.cusps());
    ensure!(
        ascends(&ts, f64::MIN_POSITIVE, 1.0_f64.next_down()),
        "{ts:?} do not ascend inside (0, 1)"
    );
    // B′ is the root of a function that rounding makes uncertain: B″ times the uncertainty of t comes in, √ε at worst.
    let speed = ts
        .iter()
        .map(|&t| curve.derivative_at(t, 1).norm())
        .fold(0.0, f64::max);
    let slack = 1e-6 * case.size() * real(curve.degree()).powi(2);
    ensure!(speed <= slack, "a speed of {speed:e} at a cusp");
    Ok(())
}

fn classify<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let kind = value!(case, curve.classify());
    let words = format!("{kind:?}");
    ensure!(
        words != "Twisted" || P::DIMENSION == 3,
        "a plane curve is twisted"
    );
    ensure!(
        curve.degree() > 1 || words == "Line" || words == "Point",
        "a line is {words}"
    );
    ensure!(
        (words == "Point") == curve.control_points().iter().all(|&p| p == curve.start())
            || words == "Point",
        "a point is {words}"
    );
    Ok(())
}

fn tangents_from(case: &Case) -> Checked {
    let (curve, p) = (curve::<DVec2>(case, "curve"), point::<DVec2>(case, "p"));
    let ts = answer!(case, curve.tangents_from(p));
    ensure!(ascends(&ts, 0.0, 1.0), "{ts:?} do not ascend in [0, 1]");
    let at = |t: f64| (curve.eval(t) - p).perp_dot(curve.derivative_at(t, 1));
    let slack = 64.0 * slack(case.size(), curve.degree()) * case.size() * real(curve.degree());
    // Where the curve turns back, the product changes its sign without a tangent through p: left out are the pieces on
    // which the direction turns by more than a right angle.
    let samples: Vec<(f64, f64)> = parameters(32, 1.0).map(|t| (t, at(t))).collect();
    for pair in samples.windows(2) {
        let tangents = [pair[0].0, pair[1].0].map(|t| curve.tangent(t));
        if tangents[0].dot(tangents[1]) > 0.0 {
            roots_are_complete(&ts, pair, slack)?;
        }
    }
    Ok(())
}

fn distance_to<P: Space>(case: &Case) -> Checked {
    let (a, b) = (curve::<P>(case, "curve"), curve::<P>(case, "other"));
    let found = value!(case, a.distance_to(&b));
    ensure!(
        [found.t, found.u].iter().all(|t| (0.0..=1.0).contains(t)),
        "({}, {})",
        found.t,
        found.u
    );
    let slack = 4.0 * slack(case.size(), a.degree().max(b.degree())) + 1e-11 * found.distance;
    let there = distance(a.eval(found.t), b.eval(found.u));
    ensure!(
        (there - found.distance).abs() <= slack,
        "{there:e} apart there, not {:e}",
        found.distance
    );
    let (a, b) = (
        a.sample(16).expect("samples"),
        b.sample(16).expect("samples"),
    );
    let pairs = a
        .iter()
        .flat_map(|&p| b.iter().map(move |&q| distance(p, q)));
    let least = pairs.fold(f64::INFINITY, f64::min);
    ensure!(
        found.distance <= least + slack,
        "{:e}, but samples are {least:e} apart",
        found.distance
    );
    Ok(())
}

fn hausdorff<P: Space>(case: &Case) -> Checked {
    let (a, b) = (curve::<P>(case, "curve"), curve::<P>(case, "other"));
    let got = value!(case, a.hausdorff(&b));
    let slack = 4.0 * slack(case.size(), a.degree().max(b.degree())) + 1e-8 * got;
    for (p, other) in [
        (a.start(), &b),
        (a.end(), &b),
        (b.start(), &a),
        (b.end(), &a),
    ] {
        let away = other
            .nearest(p)
            .map_err(|error| error.to_string())?
            .distance;
        ensure!(
            got >= away - slack,
            "{got:e}, but an end is {away:e} from the other curve"
        );
    }
    let farthest = |a: &Curve<P>, b: &Curve<P>| {
        let from = |&p: &P| {
            b.control_points()
                .iter()
                .map(|&q| distance(p, q))
                .fold(0.0, f64::max)
        };
        a.control_points().iter().map(from).fold(0.0, f64::max)
    };
    ensure!(
        got <= farthest(&a, &b) + slack,
        "{got:e} is more than any control points are apart"
    );
    Ok(())
}
