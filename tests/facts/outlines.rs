//! Golden data on paths: path data, winding numbers, arcs.

use crate::facts::fact::{Fact, count, number, point, points, text};
use crate::support::{near_at, to_3d};
use casteljau::curve::bernstein;
use casteljau::glam::{DVec2, DVec3};
use casteljau::path::FillRule;
use casteljau::{Curve, Path};
use serde_json::Value;

/// The points of all segments, with a letter for each degree.
fn segments(path: &Path) -> Vec<(&'static str, Vec<DVec3>)> {
    let splines: Vec<_> = path.subpaths().collect();
    let row = |curve: Curve<DVec2>| {
        let letter = ["", "L", "Q", "C"][curve.degree()];
        (letter, to_3d(curve.control_points()))
    };
    splines
        .iter()
        .flat_map(|spline| spline.segments().map(row))
        .collect()
}

fn same(fact: &Fact, got: &[(&'static str, Vec<DVec3>)], expected: &[(&str, Vec<DVec3>)]) {
    assert_eq!(got.len(), expected.len(), "{}: {got:?}", fact.id);
    for ((letter, points), (other, others)) in got.iter().zip(expected) {
        assert_eq!((letter, points.len()), (other, others.len()), "{}", fact.id);
        for (p, q) in points.iter().zip(others) {
            let difference = (*p - *q).abs().max_element();
            near_at(difference, 0.0, fact.tolerance, (fact.id, p, q));
        }
    }
}

/// The facts about arcs are exact to nine digits.
const ARC_TOLERANCE: f64 = 1e-10;

/// `svgpath`: checks every property that the record states.
pub(crate) fn path_data(fact: &Fact) {
    let result = Path::from_svg_with(text(&fact.input["d"]), ARC_TOLERANCE);
    for (question, answer) in fact.expect.as_object().expect("answers") {
        let refused = question == "error" && answer == &Value::Bool(true);
        assert_eq!(result.is_err(), refused, "{}: {result:?}", fact.id);
        let Ok(path) = &result else { return };
        match question.as_str() {
            "segments" => same(fact, &segments(path), &rows(answer)),
            "segment_count" => {
                assert_eq!(path.segment_count(), count(answer), "{}", fact.id);
            }
            "reversed" => {
                let expected = Path::from_svg(text(answer)).expect("good data");
                same(fact, &segments(&path.reverse()), &segments(&expected));
            }
            "length" => fact.number(path.length(), answer),
            "area" => fact.number(path.area(), answer),
            "bbox" | "bounds" => {
                let bounds = path.bounds().expect("not empty");
                fact.near(bounds.min.extend(0.0), &answer["min"]);
                fact.near(bounds.max.extend(0.0), &answer["max"]);
            }
            "arc" => arc(fact, path, answer),
            _ => panic!("{}: what is {question}?", fact.id),
        }
    }
}

fn rows(answer: &Value) -> Vec<(&str, Vec<DVec3>)> {
    let rows = answer.as_array().expect("segments").iter();
    rows.map(|row| (text(&row[0]), points(&row[1]))).collect()
}

/// The points of an arc keep their distance from the centre, and the arc sweeps its angle.
fn arc(fact: &Fact, path: &Path, expected: &Value) {
    let centre = point(&expected["center"]).truncate();
    let radius = number(&expected["radius"]);
    let mut swept = 0.0;
    for pair in samples(path, 64).windows(2) {
        near_at(pair[1].distance(centre), radius, 1e-9 * radius, fact.id);
        swept += (pair[0] - centre).angle_to(pair[1] - centre);
    }
    let degrees = number(&expected["sweep_deg"]);
    near_at(swept.to_degrees(), degrees, 1e-6, fact.id);
}

/// Points of the first subpath.
fn samples(path: &Path, count: usize) -> Vec<DVec2> {
    let first = path.subpaths().next().expect("not empty");
    first.sample(count).expect("few")
}

/// `contains`.
pub(crate) fn contains(fact: &Fact) {
    let path = Path::from_svg(text(&fact.input["svg"])).expect("good data");
    let rule = match fact.input.get("rule").and_then(Value::as_str) {
        Some("evenodd") => FillRule::EvenOdd,
        _ => FillRule::NonZero,
    };
    let queries = points(&fact.input["queries"]).into_iter();
    let answers: Vec<bool> = queries.map(|p| path.contains(p.truncate(), rule)).collect();
    assert_eq!(Value::from(answers), fact.expect, "{}", fact.id);
}

/// `circle`: the error of a quarter circle by one cubic, from its radius at many points, and the library's own arcs.
pub(crate) fn circle(fact: &Fact) {
    let k = number(&fact.input["k"]);
    let points = [DVec2::X, DVec2::new(1.0, k), DVec2::new(k, 1.0), DVec2::Y];
    let (mut max, mut min) = (0.0_f64, 0.0_f64);
    for i in 0..=100_000_u32 {
        let weights = bernstein(3, f64::from(i) / 1e5).expect("degree 3");
        let p: DVec2 = points.iter().zip(&weights).map(|(&p, &w)| p * w).sum();
        (max, min) = (max.max(p.length() - 1.0), min.min(p.length() - 1.0));
    }
    fact.number(max, &fact.expect["max_radial_error"]);
    fact.number(min, &fact.expect["min_radial_error"]);
    let quarter = Path::from_svg_with("M1 0A1 1 0 0 1 0 1", ARC_TOLERANCE).expect("an arc");
    for p in samples(&quarter, 100) {
        near_at(p.length(), 1.0, 1e-9, p);
    }
}
