//! Golden data on intersections, through the public methods.

use crate::facts::fact::{Fact, numbers, point};
use crate::support::{curve, largest};
use casteljau::Curve;
use casteljau::curve::{Intersection, IntersectionKind};
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
        let whole = matches!(
            found[..],
            [Intersection {
                kind: IntersectionKind::Overlap { .. },
                ..
            }]
        );
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
        let wrong = (location.t - t[k]).abs().max((location.u - s[k]).abs());
        assert!(
            wrong <= fact.tolerance,
            "{}: {location:?}, expected {} {}",
            fact.id,
            t[k],
            s[k]
        );
        let at = point(&fact.expect["points"][k]).truncate();
        let size = largest(a.control_points());
        assert!(
            (location.point - at).length() <= fact.tolerance * size.max(1.0),
            "{}: {location:?}",
            fact.id
        );
        let tangent = fact
            .expect
            .get("tangent")
            .is_some_and(|list| list[k] == Value::Bool(true));
        assert_eq!(
            location.kind == IntersectionKind::Tangent,
            tangent,
            "{}: {location:?}",
            fact.id
        );
    }
}

/// `selfintersect`: the pairs of parameters of the double points.
pub(crate) fn double_points(fact: &Fact) {
    let found = named(fact, "points").self_intersections();
    let expected = numbers(&fact.expect["t"]);
    assert_eq!(2 * found.len(), expected.len(), "{}: {found:?}", fact.id);
    for (location, pair) in found.iter().zip(expected.chunks_exact(2)) {
        let wrong = (location.t - pair[0])
            .abs()
            .max((location.u - pair[1]).abs());
        assert!(
            wrong <= fact.tolerance,
            "{}: {location:?}, expected {pair:?}",
            fact.id
        );
        let at = point(&fact.expect["point"]).truncate();
        assert!(
            (location.point - at).length() <= fact.tolerance,
            "{}: {location:?}",
            fact.id
        );
    }
}
