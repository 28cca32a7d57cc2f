//! Golden data on paths: path data, winding numbers, arcs.

use crate::facts::fact::{Fact, number, numbers, point};
use casteljau::Path;
use casteljau::curve::bernstein;
use casteljau::glam::{DVec2, DVec3};
use casteljau::path::FillRule;
use serde_json::Value;

/// The points of all segments, with a letter for each degree.
fn segments(path: &Path) -> Vec<(&'static str, Vec<DVec3>)> {
    let splines = path.subpaths().collect::<Vec<_>>();
    let curves = splines
        .iter()
        .flat_map(|spline| spline.segments().collect::<Vec<_>>());
    curves
        .map(|curve| {
            let points = curve.control_points().iter().map(|p| p.extend(0.0));
            (["", "L", "Q", "C"][curve.degree()], points.collect())
        })
        .collect()
}

fn same(fact: &Fact, got: &[(&'static str, Vec<DVec3>)], expected: &[(&str, Vec<DVec3>)]) {
    assert_eq!(got.len(), expected.len(), "{}: {got:?}", fact.id);
    for ((letter, points), (other, others)) in got.iter().zip(expected) {
        assert_eq!((letter, points.len()), (other, others.len()), "{}", fact.id);
        for (p, q) in points.iter().zip(others) {
            assert!(
                (*p - *q).abs().max_element() <= fact.tolerance,
                "{}: {p}, not {q}",
                fact.id
            );
        }
    }
}

/// The facts about arcs are exact to nine digits.
const ARC_TOLERANCE: f64 = 1e-10;

/// `svgpath`: checks every property that the record states.
pub(crate) fn path_data(fact: &Fact) {
    let d = fact.input["d"].as_str().expect("path data");
    let result = Path::from_svg_with(d, ARC_TOLERANCE);
    for (question, answer) in fact.expect.as_object().expect("answers") {
        let refused = question == "error" && answer == &Value::Bool(true);
        assert_eq!(result.is_err(), refused, "{}: {result:?}", fact.id);
        let Ok(path) = &result else { return };
        match question.as_str() {
            "segments" => same(fact, &segments(path), &rows(answer)),
            "segment_count" => {
                assert_eq!(Value::from(path.segment_count()), *answer, "{}", fact.id)
            }
            "reversed" => {
                let expected =
                    Path::from_svg(answer.as_str().expect("path data")).expect("good data");
                let expected = segments(&expected);
                same(fact, &segments(&path.reverse()), &expected);
            }
            "length" => fact.number(path.length(None).expect("no tolerance"), answer),
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
    let row = |row: &'_ Value| -> Vec<DVec3> {
        row[1]
            .as_array()
            .expect("points")
            .iter()
            .map(point)
            .collect()
    };
    let rows = answer.as_array().expect("segments").iter();
    rows.map(|r| (r[0].as_str().expect("a letter"), row(r)))
        .collect()
}

/// The points of an arc keep their distance from the centre, and the arc sweeps its angle.
fn arc(fact: &Fact, path: &Path, expected: &Value) {
    let centre = numbers(&expected["center"]);
    let centre = DVec2::new(centre[0], centre[1]);
    let radius = number(&expected["radius"]);
    let points: Vec<DVec2> = path.subpaths().collect::<Vec<_>>()[0]
        .sample(64)
        .expect("few");
    let mut swept = 0.0;
    for pair in points.windows(2) {
        let off = (pair[1].distance(centre) - radius).abs();
        assert!(off <= 1e-9 * radius, "{}: {off}", fact.id);
        swept += (pair[0] - centre).angle_to(pair[1] - centre);
    }
    let degrees = number(&expected["sweep_deg"]);
    assert!(
        (swept.to_degrees() - degrees).abs() <= 1e-6,
        "{}: {swept}",
        fact.id
    );
}

/// `contains`.
pub(crate) fn contains(fact: &Fact) {
    let path = Path::from_svg(fact.input["svg"].as_str().expect("path data")).expect("good data");
    let queries = fact.input["queries"].as_array().expect("points").iter();
    let rule = match fact.input.get("rule").and_then(Value::as_str) {
        Some("evenodd") => FillRule::EvenOdd,
        _ => FillRule::NonZero,
    };
    let answers: Vec<Value> = queries
        .map(|query| Value::from(path.contains(point(query).truncate(), rule)))
        .collect();
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
    for p in quarter.subpaths().collect::<Vec<_>>()[0]
        .sample(100)
        .expect("few")
    {
        assert!((p.length() - 1.0).abs() <= 1e-9, "{p}");
    }
}
