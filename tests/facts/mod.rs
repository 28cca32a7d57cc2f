//! Golden data on curves from closed forms (`tests/data/curve-facts.json`) and from other libraries
//! (`../shared/data/curve-facts.json`).

mod along;
mod fact;
mod intersections;
mod joined;
mod locations;
mod offsets;
mod outlines;

use crate::support::measure::{Reference, farthest};
use crate::support::{near_at, real};
use casteljau::curve::Basis;
use casteljau::glam::DVec3;
use casteljau::{Curve, RationalCurve};
use fact::{Fact, count, number, numbers, points, text};
use serde_json::Value;

#[test]
fn golden_values_hold() {
    let records = crate::support::golden::golden("curve-facts");
    let records = records.as_array().expect("a list of facts");
    records.iter().for_each(check);
    assert_eq!(records.len(), 116);
}

/// Golden data of other libraries, which are not part of the repository.
#[test]
fn golden_values_of_other_libraries_hold() {
    let Some(records) = crate::support::golden::shared("curve-facts") else {
        return;
    };
    let records = records.as_array().expect("a list of facts").iter();
    let theirs: Vec<&Value> = records.filter(|fact| fact["truth"] == "library").collect();
    assert_eq!(theirs.len(), 5);
    theirs.into_iter().for_each(check);
}

fn check(fact: &Value) {
    let kind = text(&fact["kind"]);
    let fact = &Fact::new(fact);
    match kind {
        "eval_rational" => {
            let (points, weights) = (
                points(&fact.input["points"]),
                numbers(&fact.input["weights"]),
            );
            let curve = RationalCurve::new(&points, &weights).expect("valid");
            fact.near(curve.eval(fact.t()), &fact.expect);
        }
        "eval" => fact.near(fact.curve().eval(fact.t()), &fact.expect),
        "derivative" => {
            let order = count(&fact.input["order"]);
            fact.near(fact.curve().derivative_at(fact.t(), order), &fact.expect);
        }
        "tangent" => fact.near(fact.curve().tangent(fact.t()), &fact.expect),
        "curvature" => fact.number(fact.flat().curvature(fact.t()), &fact.expect),
        "bbox" => {
            let bounds = fact.curve().bounds();
            fact.near(bounds.min, &fact.expect["min"]);
            fact.near(bounds.max, &fact.expect["max"]);
        }
        "split" => {
            let (left, right) = fact.curve().split(fact.t());
            fact.all_near(&left, &fact.expect["left"]);
            fact.all_near(&right, &fact.expect["right"]);
        }
        "subsegment" => {
            let (t0, t1) = (number(&fact.input["t0"]), number(&fact.input["t1"]));
            fact.all_near(&fact.curve().subsegment(t0..t1), &fact.expect);
        }
        "elevate" => fact.all_near(&fact.curve().elevate().expect("degree 2"), &fact.expect),
        "length" => along::length(fact),
        "inverse_length" => along::inverse_length(fact),
        "length_centroid" => along::length_centroid(fact),
        "area" => along::area(fact),
        "convert" => convert(fact),
        "flatten" => flatten(fact),
        "continuity" => joined::continuity(fact),
        "bspline" => joined::bspline(fact),
        "offset" => offsets::offset(fact),
        "reduce" => offsets::reduce(fact),
        "easing" => joined::easing(fact),
        "extrema" => locations::extrema(fact),
        "inflection" => locations::inflections(fact),
        "circle" => outlines::circle(fact),
        "svgpath" => outlines::path_data(fact),
        "contains" => outlines::contains(fact),
        "intersect" | "line_intersect" => intersections::check_intersections(fact),
        "selfintersect" => intersections::double_points(fact),
        "nearest" => locations::nearest(fact),
        "roots" => locations::roots(fact),
        "classify" => locations::classify(fact),
        "min_distance" => locations::min_distance(fact),
        "solve_t" => locations::solve(fact),
        _ => panic!("{}: no check for facts of the kind {kind}", fact.id),
    }
}

fn convert(fact: &Fact) {
    if fact.input.get("catmull_rom").is_some() {
        let geometry: [DVec3; 4] = fact.points("catmull_rom").try_into().expect("four points");
        let curve = Curve::from_basis(Basis::CatmullRom, geometry).expect("finite");
        return fact.all_near(&curve, &fact.expect);
    }
    // The power basis is the identity matrix; the record lists its coefficients from low to high.
    let mut unit = [0.0; 16];
    (0..4).for_each(|k| unit[5 * k] = 1.0);
    let powers = fact.curve().to_basis(Basis::Matrix(unit)).expect("a cubic");
    let (x, y) = (numbers(&fact.expect["x"]), numbers(&fact.expect["y"]));
    for (k, power) in powers.iter().rev().enumerate() {
        let difference = (*power - DVec3::new(x[k], y[k], 0.0)).abs().max_element();
        near_at(difference, 0.0, 10.0 * fact.tolerance, (fact.id, k));
    }
}

fn flatten(fact: &Fact) {
    let tolerance = number(&fact.input["tolerance"]);
    let line = fact.curve().flatten(tolerance).expect("flat");
    let reference = Reference::new(&fact.points("points"));
    let vertices = reference.locations(&line.points);
    let max = reference.length(tolerance) * (1.0 + 1e-12);
    assert!(
        farthest(&reference, &line.ts, &vertices, max) <= max,
        "{}",
        fact.id
    );
    let few = real(count(&fact.expect["greedy_min_segments"]));
    let ours = real(line.ts.len() - 1);
    let allowed = ours <= 1.5 * few + 4.0;
    assert!(allowed, "{}: {ours} chords, fewest {few}", fact.id);
    for location in fact.expect.get("must_reach").into_iter().flat_map(points) {
        let mut distances = line.points.iter().map(|p| p.distance(location));
        let reached = distances.any(|distance| distance <= tolerance);
        assert!(reached, "{}: no vertex at {location}", fact.id);
    }
}
