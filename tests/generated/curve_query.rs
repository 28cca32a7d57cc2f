//! Checks of curves: intersections, nearest points, parameters of points with a property.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::curve::{Intersection, IntersectionKind, SelfIntersection};
use casteljau::glam::DVec2;
use casteljau::{Curve, Point};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Curve::intersections", intersections),
    (
        "Curve::intersections_with_spline",
        intersections_with_spline,
    ),
    ("Curve::self_intersections", self_intersections),
    ("Curve::nearest", both!(nearest)),
    ("Curve::distance_to", both!(distance_to)),
    ("Curve::hausdorff", both!(hausdorff)),
];

/// The maximum distance of two curves at an intersection: the documented 64 (n + 2) ulps.
pub(crate) fn contact_slack(case: &Case, degree: usize) -> f64 {
    4.0 * slack(case.size(), degree)
}

/// Checks that both curves are at the stated point at the stated parameters, and that the list is sorted.
pub(crate) fn contacts_hold(
    found: &[Intersection],
    ends: [f64; 2],
    slack: f64,
    a: impl Fn(f64) -> DVec2,
    b: impl Fn(f64) -> DVec2,
) -> Checked {
    let sorted = found
        .windows(2)
        .all(|w| (w[0].t, w[0].u) <= (w[1].t, w[1].u));
    ensure!(sorted, "the list is not sorted");
    for contact in found {
        let mut pairs = vec![(contact.t, contact.u)];
        if let IntersectionKind::Overlap { t_end, u_end } = contact.kind {
            pairs.push((t_end, u_end));
        }
        for (t, u) in pairs {
            ensure!(
                (0.0..=ends[0]).contains(&t) && (0.0..=ends[1]).contains(&u),
                "({t}, {u}) is out of range"
            );
            let gap = distance(a(t), b(u));
            ensure!(
                gap <= slack,
                "the curves are {gap:e} apart at ({t}, {u}), more than {slack:e}"
            );
        }
        let gap = distance(a(contact.t), contact.point);
        ensure!(
            gap <= slack,
            "the point is {gap:e} away from the curve at {}",
            contact.t
        );
    }
    Ok(())
}

fn intersections(case: &Case) -> Checked {
    let (a, b) = (curve::<DVec2>(case, "curve"), curve::<DVec2>(case, "other"));
    let found = value!(case, a.intersections(&b));
    let slack = contact_slack(case, a.degree().max(b.degree()));
    contacts_hold(&found, [1.0, 1.0], slack, |t| a.eval(t), |u| b.eval(u))
}

fn intersections_with_spline(case: &Case) -> Checked {
    let (a, b) = (
        curve::<DVec2>(case, "curve"),
        spline::<DVec2>(case, "spline"),
    );
    let found = value!(case, a.intersections_with_spline(&b));
    let slack = contact_slack(case, a.degree().max(12));
    contacts_hold(
        &found,
        [1.0, real(b.segment_count())],
        slack,
        |t| a.eval(t),
        |u| b.eval(u),
    )
}

/// Checks that each pair of parameters belongs to one point.
pub(crate) fn doubles_hold(
    found: &[SelfIntersection],
    end: f64,
    slack: f64,
    at: impl Fn(f64) -> DVec2,
) -> Checked {
    for double in found {
        ensure!(
            0.0 <= double.t && double.t < double.u && double.u <= end,
            "({}, {}) is out of range",
            double.t,
            double.u
        );
        let gap = distance(at(double.t), at(double.u)).max(distance(at(double.t), double.point));
        ensure!(
            gap <= slack,
            "{gap:e} apart at ({}, {}), more than {slack:e}",
            double.t,
            double.u
        );
    }
    ensure!(
        found.windows(2).all(|w| w[0].t <= w[1].t),
        "the list is not sorted"
    );
    Ok(())
}

fn self_intersections(case: &Case) -> Checked {
    let curve = curve::<DVec2>(case, "curve");
    let found = value!(case, curve.self_intersections());
    doubles_hold(&found, 1.0, 4.0 * slack(case.size(), curve.degree()), |t| {
        curve.eval(t)
    })
}

/// Checks that the point belongs to t, that the distance is correct, and that no sample is nearer.
pub(crate) fn is_nearest<P: Point>(
    p: P,
    point: P,
    got: f64,
    slack: f64,
    samples: impl Iterator<Item = P>,
) -> Checked {
    let off = (distance(point, p) - got).abs();
    ensure!(off <= slack, "the distance is {off:e} off");
    let min = samples
        .map(|q| distance(q, p))
        .fold(f64::INFINITY, f64::min);
    ensure!(
        got <= min + slack,
        "{got:e}, but a sample is {min:e} away; the slack is {slack:e}"
    );
    Ok(())
}

fn nearest<P: Space>(case: &Case) -> Checked {
    let (curve, p) = (curve::<P>(case, "curve"), point::<P>(case, "p"));
    let nearest = answer!(case, curve.nearest(p));
    ensure!((0.0..=1.0).contains(&nearest.t), "t = {}", nearest.t);
    let slack = slack(case.size(), curve.degree());
    ensure!(
        distance(nearest.point, curve.eval(nearest.t)) <= slack,
        "the point is not that at t"
    );
    is_nearest(
        p,
        nearest.point,
        nearest.distance,
        4.0 * slack,
        curve.sample(100).expect("samples").into_iter(),
    )
}

fn distance_to<P: Space>(case: &Case) -> Checked {
    let (a, b) = (curve::<P>(case, "curve"), curve::<P>(case, "other"));
    let found = value!(case, a.distance_to(&b));
    ensure!(
        [found.t, found.u].iter().all(|t| (0.0..=1.0).contains(t)),
        "({}, {})",
        found.t,
        found.u
    );
    let slack = 4.0 * slack(case.size(), a.degree().max(b.degree())) + 1e-11 * found.distance;
    let there = distance(a.eval(found.t), b.eval(found.u));
    ensure!(
        (there - found.distance).abs() <= slack,
        "{there:e} apart there, not {:e}",
        found.distance
    );
    let (a, b) = (
        a.sample(16).expect("samples"),
        b.sample(16).expect("samples"),
    );
    let pairs = a
        .iter()
        .flat_map(|&p| b.iter().map(move |&q| distance(p, q)));
    let min = pairs.fold(f64::INFINITY, f64::min);
    ensure!(
        found.distance <= min + slack,
        "{:e}, but samples are {min:e} apart",
        found.distance
    );
    Ok(())
}

fn hausdorff<P: Space>(case: &Case) -> Checked {
    let (a, b) = (curve::<P>(case, "curve"), curve::<P>(case, "other"));
    let got = value!(case, a.hausdorff(&b));
    let slack = 4.0 * slack(case.size(), a.degree().max(b.degree())) + 1e-8 * got;
    for (p, other) in [
        (a.start(), &b),
        (a.end(), &b),
        (b.start(), &a),
        (b.end(), &a),
    ] {
        let away = other
            .nearest(p)
            .map_err(|error| error.to_string())?
            .distance;
        ensure!(
            got >= away - slack,
            "{got:e}, but an end is {away:e} from the other curve"
        );
    }
    let farthest = |a: &Curve<P>, b: &Curve<P>| {
        let from = |&p: &P| {
            b.control_points()
                .iter()
                .map(|&q| distance(p, q))
                .fold(0.0, f64::max)
        };
        a.control_points().iter().map(from).fold(0.0, f64::max)
    };
    ensure!(
        got <= farthest(&a, &b) + slack,
        "{got:e} is more than any control points are apart"
    );
    Ok(())
}
