//! Checks of curves: parameters of points with a property.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::glam::DVec2;
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Curve::extrema", both!(extrema)),
    ("Curve::times_at_coordinate", both!(times_at_coordinate)),
    ("Curve::inflections", inflections),
    ("Curve::cusps", both!(cusps)),
    ("Curve::classify", both!(classify)),
    ("Curve::tangents_from", tangents_from),
];

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
    // The coordinate is monotone between the extrema, except for rounding.
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

/// Checks that a root lies between samples whose values have opposite signs and exceed rounding.
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

fn times_at_coordinate<P: Space>(case: &Case) -> Checked {
    let (curve, axis, value) = (
        curve::<P>(case, "curve"),
        count(case, "axis"),
        number(case, "value"),
    );
    let ts = answer!(case, curve.times_at_coordinate(axis, value), &["axis"]);
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
    // B′ is evaluated at the root of a function that is uncertain by rounding: B″ times the uncertainty of t is added,
    // √ε at worst.
    let speed = ts
        .iter()
        .map(|&t| curve.derivative_at(t, 1).length())
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
    // Where the curve turns back, the cross product changes its sign without a tangent through p. So this omits the
    // pieces on which the direction turns by more than a right angle, and pieces on which the speed is almost zero,
    // where the tangent counts.
    let fastest = curve
        .derivative()
        .control_points()
        .iter()
        .map(|v| v.length())
        .fold(0.0, f64::max);
    let stops = |t: f64| curve.derivative_at(t, 1).length() <= 1e-7 * fastest;
    let samples: Vec<(f64, f64)> = parameters(32, 1.0).map(|t| (t, at(t))).collect();
    for pair in samples.windows(2) {
        let tangents = [pair[0].0, pair[1].0].map(|t| curve.tangent(t));
        let stop = pair.iter().any(|&(t, _)| stops(t));
        if tangents[0].dot(tangents[1]) > 0.0 && !stop {
            roots_are_complete(&ts, pair, slack)?;
        }
    }
    Ok(())
}
