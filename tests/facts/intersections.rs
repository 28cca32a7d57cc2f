//! Golden data on intersections, through the public methods.

use crate::facts::fact::{Fact, numbers, point};
use crate::intersect::kinds;
use crate::support::{curve, largest, near_at};
use casteljau::Curve;
use casteljau::curve::IntersectionKind;
use casteljau::glam::DVec2;
use serde_json::Value;

fn named(fact: &Fact, name: &str) -> Curve<DVec2> {
    curve(&fact.points(name))
}

/// `intersect` and `line_intersect`: the same intersections with the same kinds; no others, and none twice.
pub(crate) fn check_intersections(fact: &Fact) {
    let (a, b) = (named(fact, "a"), named(fact, "b"));
    let found = a.intersections(&b);
    if fact.expect.get("overlap").is_some() {
        let whole = matches!(kinds(&found)[..], [(.., IntersectionKind::Overlap { .. })]);
        return assert!(whole, "{}: {found:?}", fact.id);
    }
    let Some(t) = fact
        .expect
        .get("t")
        .filter(|_| fact.expect.get("count").is_some())
    else {
        // The gap is two units of rounding: both answers are accepted.
        return assert!(found.len() <= 1, "{}: {found:?}", fact.id);
    };
    let (t, s) = (numbers(t), numbers(&fact.expect["s"]));
    assert_eq!(found.len(), t.len(), "{}: {found:?}", fact.id);
    for (k, location) in found.iter().enumerate() {
        let what = format!("{}: {location:?}", fact.id);
        near_at(location.t, t[k], fact.tolerance, &what);
        near_at(location.u, s[k], fact.tolerance, &what);
        let at = point(&fact.expect["points"][k]).truncate();
        let size = largest(a.control_points());
        near_at(location.point, at, fact.tolerance * size.max(1.0), &what);
        let tangents = fact.expect.get("tangent");
        let tangent = tangents.is_some_and(|list| list[k] == Value::Bool(true));
        assert_eq!(
            location.kind == IntersectionKind::Tangent,
            tangent,
            "{what}"
        );
    }
}

/// `selfintersect`: the pairs of parameters of the double points.
pub(crate) fn double_points(fact: &Fact) {
    let found = fact.flat().self_intersections();
    let expected = numbers(&fact.expect["t"]);
    assert_eq!(2 * found.len(), expected.len(), "{}: {found:?}", fact.id);
    for (location, pair) in found.iter().zip(expected.chunks_exact(2)) {
        let what = format!("{}: {location:?}", fact.id);
        near_at(location.t, pair[0], fact.tolerance, &what);
        near_at(location.u, pair[1], fact.tolerance, &what);
        let at = point(&fact.expect["point"]).truncate();
        near_at(location.point, at, fact.tolerance, &what);
    }
}
