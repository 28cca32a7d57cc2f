//! Golden data on joints, B-splines and timing functions.

use crate::facts::fact::{Fact, count, number, numbers};
use crate::support::real;
use casteljau::{Easing, Spline};

pub(crate) fn continuity(fact: &Fact) {
    let spline = Spline::from_curves(&[fact.named("a"), fact.named("b")], false).expect("joined");
    let found = spline.continuity(1).expect("a joint");
    let of = |name: &str| fact.expect[name].as_bool();
    let found = [
        ("C0", found.c0),
        ("G1", found.g1),
        ("C1", found.c1),
        ("C2", found.c2),
    ];
    for (name, value) in found {
        assert_eq!(Some(value), of(name), "{} {name}", fact.id);
    }
}

/// A point of a B-spline, whose span covers t = k to k + 1.
pub(crate) fn bspline(fact: &Fact) {
    let degree = count(&fact.input["degree"]);
    let (points, knots) = (fact.points("points"), numbers(&fact.input["knots"]));
    let spline = Spline::from_bspline(&points, degree, Some(&knots), false).expect("a B-spline");
    let u = number(&fact.input["u"]);
    let mut joints = knots[degree..=points.len()].to_vec();
    joints.dedup();
    let k = joints[1..joints.len() - 1].partition_point(|&joint| joint <= u);
    let rest = (u - joints[k]) / (joints[k + 1] - joints[k]);
    fact.near(spline.eval(real(k) + rest), &fact.expect);
}

/// A timing function: both x and y are checked.
pub(crate) fn easing(fact: &Fact) {
    let b = numbers(&fact.input["bezier"]);
    let ease = Easing::new(b[0], b[1], b[2], b[3]).expect("handles in range");
    fact.number(ease.eval(number(&fact.input["x"])), &fact.expect);
}
