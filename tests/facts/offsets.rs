//! Golden data on offset curves and on degree reduction.

use crate::facts::fact::{Fact, number, points};
use crate::support::near_at;
use casteljau::glam::DVec2;

/// The ends and straightness of the offset, or the distance of every point except beyond a cusp of the offset.
pub(crate) fn offset(fact: &Fact) {
    let plane = fact.flat();
    let distance = number(&fact.input["distance"]);
    let offset = plane.offset_within(distance, 0.1).expect("finite");
    let finite = offset.control_points().iter().all(|p| p.is_finite());
    assert!(finite, "{}", fact.id);
    let line = offset.flatten(0.001).expect("finite").points;
    if let Some(ends) = fact.expect.get("ends") {
        let ends: Vec<DVec2> = points(ends).iter().map(|p| p.truncate()).collect();
        let off = line[0].distance(ends[0]) + line[line.len() - 1].distance(ends[1]);
        near_at(off, 0.0, fact.tolerance, fact.id);
        let straight = offset.degrees().iter().all(|&degree| degree == 1);
        assert!(fact.expect["straight"] != true || straight, "{}", fact.id);
        return;
    }
    let source = plane.sample(20_000).expect("samples");
    let nearest = |p: DVec2| {
        let distances = source.iter().map(|&q| (q - p).length());
        distances.fold(f64::INFINITY, f64::min)
    };
    let bend = |k: i32| plane.curvature(f64::from(k) / 100.0) * distance;
    let passes_cusp = (0..=100).any(|k| bend(k) > 1.0);
    for &p in &line {
        let off = nearest(p) - distance.abs();
        let kept = off <= 0.101 && (passes_cusp || off >= -0.101);
        assert!(kept, "{}: {off} at {p}", fact.id);
    }
}

pub(crate) fn reduce(fact: &Fact) {
    let reduced = fact.curve().reduce();
    fact.all_near(&reduced.curve, &fact.expect["points"]);
    fact.number(reduced.error, &fact.expect["error"]);
}
