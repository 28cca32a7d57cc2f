//! Golden data on arc lengths and areas.

use crate::facts::fact::{Fact, text};
use crate::support::integral;
use casteljau::Path;
use casteljau::glam::{DVec2, DVec3};

pub(crate) fn length(fact: &Fact) {
    let points = fact.points("points");
    let space = fact.curve().length();
    fact.number(space, &fact.expect);
    if points.iter().all(|p| p.z == 0.0) {
        let plane = fact.flat().length();
        fact.number(plane, &fact.expect);
    }
}

/// The arc length s may be the word "length", which stands for the whole length.
pub(crate) fn inverse_length(fact: &Fact) {
    let plane = fact.flat();
    for whole in [plane.length(), fact.curve().length()] {
        let s = fact.input["s"].as_f64().unwrap_or(whole);
        fact.number(plane.time_at_length(s), &fact.expect);
        fact.number(fact.curve().time_at_length(s), &fact.expect);
    }
}

/// The area of a curve, or of an outline together with its length.
pub(crate) fn area(fact: &Fact) {
    if let Some(outline) = fact.input.get("svg") {
        let path = Path::from_svg(text(outline)).expect("good data");
        fact.number(path.area().abs(), &fact.expect["abs_area"]);
        let length = path.length();
        fact.number(length, &fact.expect["perimeter"]);
        return;
    }
    let plane = fact.flat();
    fact.number(plane.area(), &fact.expect);
    fact.number(plane.moments().area, &fact.expect);
}

/// ∫ B |B′| dt / ∫ |B′| dt, as the mean of points at equal steps along the curve, and as an integral.
pub(crate) fn length_centroid(fact: &Fact) {
    let plane = fact.flat();
    let whole = plane.length();
    let steps = plane.equidistant_times(2000).expect("steps");
    // The mean over equal steps of arc length, by Simpson's rule.
    let weight = |i: usize| match i {
        0 | 2000 => 1.0,
        _ if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let term = |(i, &t): (usize, &f64)| plane.eval(t) * weight(i);
    let sum: DVec2 = steps.iter().enumerate().map(term).sum();
    fact.near((sum / 6000.0).extend(0.0), &fact.expect);
    // The integral itself.
    let points = fact.points("points");
    let space = fact.curve();
    let of = |k: usize| integral::integral(&points, (0.0, 1.0), &|t| space.eval(t)[k]) / whole;
    fact.near(DVec3::new(of(0), of(1), 0.0), &fact.expect);
}
