//! Generated cases, compared with the reference.

use crate::intersect::generate::{Case, case};
use crate::intersect::reference::{Cluster, Reference};
use crate::intersect::spots;
use crate::support;
use crate::support::threads::on_all;
use crate::support::{Rng, bezier, exact, largest, real};
use casteljau::Curve;
use casteljau::curve::{Intersection, IntersectionKind};
use casteljau::glam::DVec2;
use std::collections::BTreeMap;
use std::sync::Mutex;

#[test]
fn complete_and_true() {
    let failures = Mutex::new(BTreeMap::new());
    on_all(0..support::cases(20_000, 300_000), |seed| {
        let mut rng = Rng(seed as u64);
        let case = case(&mut rng);
        if let Err(wrong) = judged(&case) {
            let mut failures = failures.lock().expect("nothing panics under the lock");
            let count = failures.entry(case.name).or_insert(0);
            *count += 1;
            if *count <= 3 {
                println!(
                    "{} (seed {seed}): {wrong}\n  a {:?}\n  b {:?}",
                    case.name,
                    case.a.control_points(),
                    case.b.control_points()
                );
            }
        }
    });
    let failures = failures
        .into_inner()
        .expect("nothing panics under the lock");
    assert!(failures.is_empty(), "{failures:?}");
}

/// The maximum effect of rounding on a point of either curve.
fn rounding(a: &Curve<DVec2>, b: &Curve<DVec2>) -> f64 {
    let size = largest(a.control_points()).max(largest(b.control_points()));
    let degree = real(a.degree().max(b.degree()));
    8.0 * (2.0 + degree) * f64::EPSILON * size
}

/// Curves that come as near as this part of [`rounding`] must be reported. The documented distance of contact is 2ε (L +
/// (n + 1) S), with the largest coordinate L, the size S of both curves together and the higher degree n: at least
/// 2εL. This part of 8 (n + 2) εL is (n + 2)/5 εL, at most 1.6 εL for the degrees up to 6 that are generated.
const SURELY_IN_CONTACT: f64 = 1.0 / 40.0;

pub(crate) fn judged(case: &Case) -> Result<(), String> {
    let (a, b) = (&case.a, &case.b);
    let found = a.intersections(b);
    let slack = rounding(a, b);
    for p in &found {
        let spots = spots(p);
        let gap = |&(t, u): &(f64, f64)| (a.eval(t) - b.eval(u)).length();
        let off = (a.eval(p.t) - p.point).length();
        if !(spots.iter().all(|spot| gap(spot) <= slack) && off <= slack) {
            let gaps: Vec<f64> = spots.iter().map(gap).collect();
            return Err(format!(
                "not on both, by {gaps:?} and {off:e} (allowed {slack:e}): {p:?}"
            ));
        }
        if spots.windows(2).any(|s| s[1].0 <= s[0].0) {
            return Err(format!("an empty overlap: {p:?}"));
        }
    }
    // A curve that turns back may overlap twice with one that does not, from the same point on.
    let sorted = found.windows(2).all(|p| {
        let twice = matches!(p[0].kind, IntersectionKind::Overlap { .. }) && p[0].kind != p[1].kind;
        (p[0].t, p[0].u) < (p[1].t, p[1].u) || twice && (p[0].t, p[0].u) == (p[1].t, p[1].u)
    });
    if !sorted {
        return Err(format!("not sorted or twice: {found:?}"));
    }
    // Intersections may be as far apart as the slack above allows, so the boxes around them must be as wide.
    let reference = Reference::new(a, b, slack);
    covered(a, b, &found, &reference, slack)
}

fn covered(
    a: &Curve<DVec2>,
    b: &Curve<DVec2>,
    found: &[Intersection],
    reference: &Reference,
    slack: f64,
) -> Result<(), String> {
    let mut counts = vec![Vec::new(); reference.clusters.len()];
    for location in found {
        for (t, u) in spots(location) {
            let Some(k) = reference.cluster_at(t, u) else {
                return Err(format!("outside of all clusters: {location:?}"));
            };
            counts[k].push(*location);
        }
    }
    for (cluster, locations) in reference.clusters.iter().zip(&counts) {
        if !locations.is_empty() {
            continue;
        }
        let side = reference.side;
        let rounded = |t: f64, u: f64| (a.eval(t) - b.eval(u)).length();
        if nearest(rounded, cluster, side).0 > slack {
            continue; // rounding moves two points by less than the slack
        }
        let (nearest, at) = nearest(|t, u| distance(a, b, t, u), cluster, side);
        let hidden = |p: &Intersection| hidden(a, b, p, at, slack);
        if nearest <= slack * SURELY_IN_CONTACT && !found.iter().any(hidden) {
            let boxes = cluster.boxes.len();
            return Err(format!(
                "missed, {nearest:e} apart (slack {slack:e}) in {cluster:?} of {boxes} boxes; found {found:?}"
            ));
        }
    }
    Ok(())
}

/// The distance between A(t) and B(u). It is computed in double the precision of f64, because far from the origin points
/// rounded to f64 may be nearer to each other than the curves by more than the distance that counts as contact.
fn distance(a: &Curve<DVec2>, b: &Curve<DVec2>, t: f64, u: f64) -> f64 {
    let axis = |curve: &Curve<DVec2>, t: f64, axis: usize| {
        let points: Vec<f64> = curve.control_points().iter().map(|p| p[axis]).collect();
        exact::eval_scalar(&points, t)
    };
    let gap = |k: usize| (axis(a, t, k) - axis(b, u, k)).hi;
    gap(0).hypot(gap(1))
}

/// The minimum distance in a cluster: from each box, with decreasing steps.
fn nearest(distance: impl Fn(f64, f64) -> f64, cluster: &Cluster, side: f64) -> (f64, (f64, f64)) {
    let mut best = (f64::MAX, (0.0, 0.0));
    let skip = 1 + cluster.boxes.len() / 100;
    for &(t, u) in cluster.boxes.iter().step_by(skip) {
        let (mut t, mut u, mut step) = (t + 0.5 * side, u + 0.5 * side, side);
        let mut min = distance(t, u);
        // Gauss–Newton steps, clamped to the square, then pattern search.
        for _ in 0..200 {
            let mut better = None;
            for (dt, du) in (0..9).map(|k| (real(k / 3) - 1.0, real(k % 3) - 1.0)) {
                let t = (t + dt * step).clamp(0.0, 1.0);
                let u = (u + du * step).clamp(0.0, 1.0);
                let d = distance(t, u);
                if d < min {
                    min = d;
                    better = Some((t, u));
                }
            }
            match better {
                Some(location) => (t, u) = location,
                None => step *= 0.5,
            }
            if step < 1e-18 {
                break;
            }
        }
        if min < best.0 {
            best = (min, (t, u));
        }
    }
    best
}

/// Whether the curves are as close as rounding allows all the way from an intersection that was found.
fn hidden(
    a: &Curve<DVec2>,
    b: &Curve<DVec2>,
    from: &Intersection,
    to: (f64, f64),
    slack: f64,
) -> bool {
    (1..50).all(|k| {
        let part = f64::from(k) / 50.0;
        let t = from.t + part * (to.0 - from.t);
        let u = from.u + part * (to.1 - from.u);
        let gap = a.eval(t) - b.eval(u);
        gap.perp_dot(b.tangent(u)).abs() <= slack / 4.0
    })
}

/// Lines so far from the origin that rounding moves them by more than their distance; and two straight curves that turn
/// back, four ulps apart: their rounded points are nearer to each other than they are, but not near enough for contact.
#[test]
fn within_rounding_of_each_other() {
    for (a, b) in [
        (
            "999999.8734797041 -2999999.146707923, 1000000.2698025084 -2999999.4570216937",
            "999999.8734796952 -2999999.146707912, 1000000.2698024994 -2999999.4570216825",
        ),
        (
            "1000000.9999999994 -2999997.999999998, 1000001.9999999994 -2999996.999999998,
             999999.9999999994 -2999998.999999998",
            "1000001 -2999998, 1000002 -2999997, 1000000 -2999999",
        ),
    ] {
        let case = Case {
            name: "shifted",
            a: bezier(a),
            b: bezier(b),
        };
        assert_eq!(judged(&case), Ok(()));
    }
}
