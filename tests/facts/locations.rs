//! Golden data on special points of curves: roots, extrema, inflections, kinds, nearest points.

use crate::facts::fact::{Fact, number, numbers, point, text};
use crate::support::exact::{exactly, sum};
use crate::support::{binomial, largest, near_at, real};
use casteljau::curve::CurveKind;
use casteljau::glam::DVec2;
use casteljau::{Curve, Point};
use serde_json::Value;

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
    let (mut from, mut to) = (-bound.ceil(), bound.ceil());
    if only_unit || bound > 1e4 {
        (from, to) = (0.0, 1.0);
    }
    let mut found: Vec<f64> = Vec::new();
    while from < to {
        let graph = graph(&powers, from);
        for t in graph.times_at_coordinate(1, 0.0).expect("y") {
            let another = |last: &f64| from + t - last > fact.tolerance;
            if found.last().is_none_or(another) {
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
    let height = |j: usize| {
        let share = |k: usize| binomial(j, k) / binomial(n, k);
        let terms = (0..=j).map(|k| (taylor[k].hi + taylor[k].lo) * share(k));
        sum(&terms.collect::<Vec<f64>>())
    };
    let point = |j: usize| DVec2::new(real(j) / real(n), height(j));
    Curve::new(&(0..=n).map(point).collect::<Vec<_>>()).expect("finite")
}

pub(crate) fn extrema(fact: &Fact) {
    let plane = fact.flat();
    all(fact, &plane.extrema(0).expect("x"), &fact.expect["x"]);
    all(fact, &plane.extrema(1).expect("y"), &fact.expect["y"]);
}

pub(crate) fn inflections(fact: &Fact) {
    all(fact, &fact.flat().inflections(), &fact.expect);
}

pub(crate) fn classify(fact: &Fact) {
    let (plane, space) = (fact.flat(), fact.curve());
    let name = text(&fact.expect["class"]);
    for class in [plane.classify(), space.classify()] {
        assert_eq!(format!("{class:?}").to_lowercase(), name, "{}", fact.id);
    }
    if let Some(t) = fact.expect.get("t") {
        match plane.classify() {
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
    let found = fact.flat().times_at_coordinate(axis, value);
    all(fact, &found.expect("an axis"), &fact.expect);
}

pub(crate) fn nearest(fact: &Fact) {
    let query = point(&fact.input["query"]);
    fn check<P: Point>(fact: &Fact, on: &Curve<P>, query: P) {
        let found = on.nearest(query).expect("finite");
        fact.number(found.distance, &fact.expect["distance"]);
        let reach = fact.tolerance * (1.0 + largest(on.control_points()));
        let either = |t: f64| (found.t - t).abs() <= fact.tolerance;
        let also = fact.expect.get("also_t").map_or_else(Vec::new, numbers);
        if also.into_iter().any(either) {
            return;
        }
        fact.number(found.t, &fact.expect["t"]);
        let expected = point(&fact.expect["point"]);
        near_at(found.point.to_3d(), expected, reach, fact.id);
    }
    check(fact, &fact.curve(), query);
    check(fact, &fact.flat(), query.truncate());
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
