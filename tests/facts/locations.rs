//! Golden data on special points of curves: roots, extrema, inflections, kinds, nearest points.

use crate::facts::fact::{Fact, number, numbers, point};
use crate::support::exact::{exactly, sum};
use crate::support::{curve, largest, plane, real};
use casteljau::Curve;
use casteljau::curve::CurveKind;
use casteljau::glam::{DVec2, DVec3};
use serde_json::Value;

fn flat(fact: &Fact) -> Curve<DVec2> {
    curve(&fact.points("points"))
}

fn all(fact: &Fact, got: &[f64], expected: &Value) {
    let expected = numbers(expected);
    let apart = |(a, b): (&f64, &f64)| (a - b).abs() <= fact.tolerance;
    let alike = got.len() == expected.len() && got.iter().zip(&expected).all(apart);
    assert!(alike, "{}: {got:?}, expected {expected:?}", fact.id);
}

/// Finds the roots of a polynomial through the public API, as zeros of its graph over intervals of length 1.
pub(crate) fn roots(fact: &Fact) {
    let powers = numbers(&fact.input["coeffs_low_to_high"]);
    let expected = numbers(&fact.expect);
    // A record may list only the roots in [0, 1].
    let only_unit = expected.iter().all(|r| (0.0..=1.0).contains(r));
    let lead = powers.last().expect("coefficients").abs();
    let bound = powers.iter().map(|c| c.abs()).fold(0.0, f64::max) / lead + 1.0;
    let (mut from, to) = if only_unit || bound > 1e4 {
        (0.0, 1.0)
    } else {
        (-bound.ceil(), bound.ceil())
    };
    let mut found: Vec<f64> = Vec::new();
    while from < to {
        let graph = graph(&powers, from);
        for t in graph.times_at_coordinate(1, 0.0).expect("y") {
            if found
                .last()
                .is_none_or(|last| from + t - last > fact.tolerance)
            {
                found.push(from + t);
            }
        }
        from += 1.0;
    }
    all(fact, &found, &fact.expect);
}

/// The curve (t, p(from + t)): Taylor coefficients at `from` in double the precision of f64, then Bernstein
/// coefficients.
fn graph(powers: &[f64], from: f64) -> Curve<DVec2> {
    let n = powers.len() - 1;
    let mut taylor: Vec<_> = powers.iter().map(|&c| exactly(c)).collect();
    for k in 0..n {
        for i in (k..n).rev() {
            taylor[i] = taylor[i] + taylor[i + 1] * exactly(from);
        }
    }
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * real(n - i) / real(i + 1));
    let height = |j: usize| {
        let terms =
            (0..=j).map(|k| (taylor[k].hi + taylor[k].lo) * binomial(j, k) / binomial(n, k));
        sum(&terms.collect::<Vec<f64>>())
    };
    let points: Vec<(f64, f64)> = (0..=n).map(|j| (real(j) / real(n), height(j))).collect();
    plane(&points)
}

pub(crate) fn extrema(fact: &Fact) {
    let plane = flat(fact);
    all(fact, &plane.extrema(0).expect("x"), &fact.expect["x"]);
    all(fact, &plane.extrema(1).expect("y"), &fact.expect["y"]);
}

pub(crate) fn inflections(fact: &Fact) {
    all(fact, &flat(fact).inflections(), &fact.expect);
}

pub(crate) fn classify(fact: &Fact) {
    let (plane, space) = (flat(fact), fact.curve());
    let class = match fact.expect["class"].as_str().expect("a class") {
        "point" => CurveKind::Point,
        "line" => CurveKind::Line,
        "quadratic" => CurveKind::Quadratic,
        "arch" => CurveKind::Arch,
        "serpentine" => CurveKind::Serpentine,
        "loop" => CurveKind::Loop,
        "cusp" => CurveKind::Cusp,
        other => panic!("{}: {other}", fact.id),
    };
    assert_eq!(
        (plane.classify(), space.classify()),
        (class, class),
        "{}",
        fact.id
    );
    if let Some(t) = fact.expect.get("t") {
        match class {
            CurveKind::Cusp => all(fact, &plane.cusps(), t),
            CurveKind::Serpentine => all(fact, &plane.inflections(), t),
            _ => {}
        }
    }
}

pub(crate) fn solve(fact: &Fact) {
    let (axis, value) = match fact.input.get("x") {
        Some(x) => (0, number(x)),
        None => (1, number(&fact.input["y"])),
    };
    all(
        fact,
        &flat(fact)
            .times_at_coordinate(axis, value)
            .expect("an axis"),
        &fact.expect,
    );
}

pub(crate) fn nearest(fact: &Fact) {
    let query = point(&fact.input["query"]);
    fn check<P: casteljau::Point>(
        fact: &Fact,
        on: &Curve<P>,
        query: P,
        location: impl Fn(P) -> DVec3,
    ) {
        let found = on.nearest(query).expect("finite");
        fact.number(found.distance, &fact.expect["distance"]);
        let reach = fact.tolerance * (1.0 + largest(on.control_points()));
        let either = |t: f64| (found.t - t).abs() <= fact.tolerance;
        let also = fact.expect.get("also_t").map_or_else(Vec::new, numbers);
        if also.into_iter().any(either) {
            return;
        }
        assert!(
            either(number(&fact.expect["t"])),
            "{}: {}",
            fact.id,
            found.t
        );
        let apart = (location(found.point) - point(&fact.expect["point"])).length();
        assert!(apart <= reach, "{}: {apart}", fact.id);
    }
    check(fact, &fact.curve(), query, |p| p);
    check(fact, &flat(fact), query.truncate(), |p| p.extend(0.0));
}

pub(crate) fn min_distance(fact: &Fact) {
    let found = fact.named("a").distance_to(&fact.named("b"));
    fact.number(found.distance, &fact.expect["distance"]);
    for (got, name) in [(found.t, "t"), (found.u, "s")] {
        if let Some(expected) = fact.expect.get(name) {
            fact.number(got, expected);
        }
    }
}
