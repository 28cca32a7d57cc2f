//! Golden data on offset curves and on degree reduction.

use crate::facts::fact::{Fact, number, points};
use crate::support::curve;
use casteljau::Curve;
use casteljau::glam::DVec2;
use serde_json::Value;

/// The ends and straightness of the offset, or the distance of every point except beyond a cusp of the offset.
pub(crate) fn offset(fact: &Fact) {
    let plane: Curve<DVec2> = curve(&fact.points("points"));
    let distance = number(&fact.input["distance"]);
    let offset = plane.offset(distance, Some(0.1)).expect("finite");
    assert!(
        offset.control_points().iter().all(|p| p.is_finite()),
        "{}",
        fact.id
    );
    let line = offset.flatten(0.001).expect("finite");
    if let Some(ends) = fact.expect.get("ends") {
        let ends: Vec<DVec2> = points(ends).iter().map(|p| p.truncate()).collect();
        let found = [line.points[0], line.points[line.points.len() - 1]];
        assert!(
            (found[0] - ends[0]).length() + (found[1] - ends[1]).length() <= fact.tolerance,
            "{}",
            fact.id
        );
        if fact.expect["straight"] == Value::Bool(true) {
            assert!(
                offset.degrees().iter().all(|&degree| degree == 1),
                "{}",
                fact.id
            );
        }
        return;
    }
    let source = plane.sample(20_000).expect("samples");
    let nearest = |p: DVec2| {
        source
            .iter()
            .map(|&q| (q - p).length())
            .fold(f64::INFINITY, f64::min)
    };
    let curvatures: Vec<f64> = (0..=100)
        .map(|k| plane.curvature(f64::from(k) / 100.0) * distance)
        .collect();
    let passes_cusp = curvatures.iter().any(|&bend| bend > 1.0);
    for &p in &line.points {
        let off = nearest(p) - distance.abs();
        assert!(
            off <= 0.101 && (passes_cusp || off >= -0.101),
            "{}: {off} at {p}",
            fact.id
        );
    }
}

pub(crate) fn reduce(fact: &Fact) {
    let reduced = fact.curve().reduce();
    fact.all_near(&reduced.curve, &fact.expect["points"]);
    fact.number(reduced.error, &fact.expect["error"]);
}
