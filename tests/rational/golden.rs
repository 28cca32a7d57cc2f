//! Figures of geomdl and of mpmath (`tests/data/nurbs.json`).

use crate::support::Space;
use crate::support::golden::golden;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{NurbsCurve, RationalCurve};
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("a number: {value}"))
}

fn list(value: &Value) -> &[Value] {
    value
        .as_array()
        .unwrap_or_else(|| panic!("a list: {value}"))
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

fn point<P: Space>(value: &Value) -> P {
    let coordinate = |i: usize| value.get(i).map_or(0.0, number);
    P::of(DVec3::new(coordinate(0), coordinate(1), coordinate(2)))
}

fn points<P: Space>(value: &Value) -> Vec<P> {
    list(value).iter().map(point).collect()
}

fn degree(value: &Value) -> usize {
    usize::try_from(value.as_u64().expect("a degree")).expect("small")
}

fn nurbs<P: Space>(value: &Value) -> NurbsCurve<P> {
    let (points, weights) = (points(&value["points"]), numbers(&value["weights"]));
    let knots = numbers(&value["knots"]);
    NurbsCurve::new(
        degree(&value["degree"]),
        &points,
        Some(&weights),
        &knots,
        false,
    )
    .expect("valid")
}

fn rational<P: Space>(value: &Value) -> RationalCurve<P> {
    let weights = numbers(&value["weights"]);
    RationalCurve::new(&points(&value["points"]), &weights).expect("valid")
}

/// Asserts that two lists of weights are equal up to a common factor.
fn assert_weights(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let factor = found[0] / expected[0];
    for (a, b) in found.iter().zip(expected) {
        assert!(
            (a / (b * factor) - 1.0).abs() <= tolerance,
            "{what}: {a} {b}"
        );
    }
}

fn assert_points<P: Space>(found: &[P], expected: &[P], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (&a, &b) in found.iter().zip(expected) {
        assert!((a - b).norm() <= tolerance, "{what}: {a:?} {b:?}");
    }
}

/// Asserts the control points and the weights of a curve.
fn assert_parts<P: Space>(
    (found_points, weights): (&[P], &[f64]),
    expected: &Value,
    tolerance: f64,
    what: &str,
) {
    let expected_points = points(&expected["points"]);
    assert_points(found_points, &expected_points, tolerance, what);
    assert_weights(weights, &numbers(&expected["weights"]), tolerance, what);
}

fn assert_curve<P: Space>(found: &NurbsCurve<P>, expected: &Value, tolerance: f64, what: &str) {
    assert_eq!(found.degree(), degree(&expected["degree"]), "{what}");
    let parts = (found.control_points(), found.weights());
    assert_parts(parts, expected, tolerance, what);
    let knots = numbers(&expected["knots"]);
    assert_eq!(found.knots().len(), knots.len(), "{what}");
    for (a, b) in found.knots().iter().zip(knots) {
        assert!((a - b).abs() <= tolerance, "{what}: knots {a} {b}");
    }
}

#[test]
fn curves_are_those_of_geomdl() {
    let data = golden("nurbs");
    let curves = list(&data["curves"]);
    assert_eq!(curves.len(), 14);
    for curve in curves {
        if list(&curve["points"][0]).len() == 2 {
            check_curve::<DVec2>(curve);
        } else {
            check_curve::<DVec3>(curve);
        }
    }
}

fn check_curve<P: Space>(value: &Value) {
    let (curve, what) = (nurbs::<P>(value), &value["id"].to_string()[..]);
    let size = points::<P>(&value["points"])
        .iter()
        .fold(1.0, |max: f64, p| max.max(p.norm()));
    for sample in list(&value["samples"]) {
        let t = number(&sample["t"]);
        for (k, name) in ["point", "first", "second"].into_iter().enumerate() {
            let expected: P = point(&sample[name]);
            let found = curve.derivative_at(t, k).expect("an order");
            let off = (found - expected).norm() / expected.norm().max(size);
            assert!(off <= 1e-12, "{what}: {name} at {t}: {off:e}");
        }
    }
    let operations = |name: &str| value.get(name).map_or(&[][..], list).iter();
    for step in operations("insert") {
        let times = usize::try_from(step["times"].as_u64().expect("a count")).expect("small");
        let found = curve
            .insert_knot(number(&step["t"]), times)
            .expect("a knot");
        assert_curve(&found, &step["curve"], 1e-12 * size, what);
    }
    if let Some(step) = value.get("refine") {
        let found = curve.refine(&numbers(&step["ts"])).expect("knots");
        assert_curve(&found, &step["curve"], 1e-12 * size, what);
    }
    if let Some(step) = value.get("split") {
        let (left, right) = curve.split(number(&step["t"])).expect("inside");
        assert_curve(&left, &step["curves"][0], 1e-12 * size, what);
        assert_curve(&right, &step["curves"][1], 1e-12 * size, what);
    }
    if let Some(expected) = value.get("elevate") {
        let found = curve.elevate().expect("below 64");
        assert_curve(&found, expected, 1e-12 * size, what);
    }
    for (segment, expected) in curve.segments().iter().zip(operations("segments")) {
        let expected = nurbs::<P>(expected);
        assert_points(
            segment.control_points(),
            expected.control_points(),
            1e-12 * size,
            what,
        );
        assert_weights(segment.weights(), expected.weights(), 1e-12, what);
    }
}

#[test]
fn facts_of_rational_curves_hold() {
    let data = golden("nurbs");
    let facts = list(&data["facts"]);
    assert_eq!(facts.len(), 231);
    facts.iter().for_each(check_fact);
}

fn check_fact(fact: &Value) {
    let input = &fact["input"];
    match input
        .get("points")
        .map_or(2, |points| list(&points[0]).len())
    {
        2 => check_fact_in::<DVec2>(fact),
        _ => check_fact_in::<DVec3>(fact),
    }
}

fn check_fact_in<P: Space>(fact: &Value) {
    let (input, expect) = (&fact["input"], &fact["expect"]);
    let (tolerance, what) = (number(&fact["tol"]), &fact["id"].to_string()[..]);
    let near = |found: f64, expected: &Value| {
        let off = (found - number(expected)).abs();
        assert!(off <= tolerance, "{what}: {off:e} of {tolerance:e}");
    };
    let all_near = |found: &[f64], expected: &Value| {
        assert_eq!(found.len(), list(expected).len(), "{what}: {found:?}");
        found
            .iter()
            .zip(list(expected))
            .for_each(|(&t, expected)| near(t, expected));
    };
    let point_near = |found: P, expected: &Value| {
        assert_points(&[found], &[point(expected)], tolerance, what);
    };
    let same = |found: &RationalCurve<P>, expected: &Value| {
        let parts = (found.control_points(), found.weights());
        assert_parts(parts, expected, tolerance, what);
    };
    let (curve, t) = (|| rational::<P>(input), || number(&input["t"]));
    let flat = || rational::<DVec2>(input);
    match fact["kind"].as_str().expect("a kind") {
        "perimeter" => {
            let radii = DVec2::new(number(&input["rx"]), number(&input["ry"]));
            let ellipse = NurbsCurve::ellipse(DVec2::ZERO, radii, 0.0).expect("finite");
            near(ellipse.length(), expect);
        }
        "length" => near(curve().length(), expect),
        "time_at_length" => near(curve().time_at_length(number(&input["length"])), expect),
        "area" => near(flat().area(), expect),
        "curvature" => near(curve().curvature(t()), expect),
        "extrema" => {
            for axis in 0..P::DIMENSION {
                let name = ["x", "y", "z"][axis];
                all_near(&curve().extrema(axis).expect("an axis"), &expect[name]);
            }
        }
        "inflections" => all_near(&flat().inflections(), expect),
        "bounds" => {
            let bounds = curve().bounds();
            point_near(bounds.min, &expect["min"]);
            point_near(bounds.max, &expect["max"]);
        }
        "nearest" => {
            let found = curve().nearest(point(&input["point"])).expect("finite");
            near(found.t, &expect["t"]);
            near(found.distance, &expect["distance"]);
            point_near(found.point, &expect["point"]);
        }
        "split" => {
            let (left, right) = curve().split(t()).expect("inside");
            same(&left, &expect["left"]);
            same(&right, &expect["right"]);
        }
        "standard_form" => {
            let standard = curve().reparametrize().expect("moderate weights");
            all_near(standard.weights(), expect);
        }
        "intersections" => {
            let [a, b] = ["a", "b"].map(|name| rational::<DVec2>(&input[name]));
            let found = a.intersections(&b);
            assert_eq!(found.len(), list(expect).len(), "{what}: {found:?}");
            for (one, expected) in found.iter().zip(list(expect)) {
                near(one.t, &expected["t"]);
                near(one.u, &expected["s"]);
                let expected = [point(&expected["point"])];
                assert_points(&[one.point], &expected, tolerance, what);
            }
        }
        kind => panic!("{what}: {kind}"),
    }
}
