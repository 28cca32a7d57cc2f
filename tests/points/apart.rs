//! The distance between curves (minimum and Hausdorff), compared with grids of samples.

use crate::points::{cases, hostile, steps};
use crate::support::adversarial::ORDINARY;
use crate::support::{Rng, Space, bezier, curve, largest, near, near_at, real, ulp, xyz};
use casteljau::Curve;
use casteljau::glam::{DAffine2, DVec2, DVec3};
use casteljau::take_steps;

/// Two curves that may cross, touch, overlap, or be equal.
fn pair(rng: &mut Rng, dimension: usize) -> (Vec<DVec3>, Vec<DVec3>) {
    let a = hostile(rng, &ORDINARY, dimension);
    let on: Curve<DVec3> = curve(&a);
    let (s, t) = (rng.unit(), rng.unit());
    let b = match rng.below(8) {
        0 => a.clone(),
        1 => on.subsegment(s..t).control_points().to_vec(),
        2 => {
            let direction = rng.point(dimension) * rng.magnitude(-12.0, 1.0);
            a.iter().map(|&p| p + direction).collect()
        }
        3 => {
            let beside = |&p: &DVec3| p + rng.point(dimension) * 1e-9;
            a.iter().rev().map(beside).collect()
        }
        4 => {
            let mut b = hostile(rng, &ORDINARY, dimension);
            b[0] = on.eval(t);
            b
        }
        _ => {
            let direction = rng.point(dimension) * rng.pick(&[0.0, 1.0, 3.0]);
            let b = hostile(rng, &ORDINARY, dimension);
            b.iter().map(|&p| p + direction).collect()
        }
    };
    (a, b)
}

/// Whether all digits are correct; some are not where curves overlap.
fn check<P: Space>(a: &[DVec3], b: &[DVec3]) -> bool {
    let (p, q): (Curve<P>, Curve<P>) = (curve(a), curve(b));
    take_steps();
    let found = p.distance_to(&q);
    let work = take_steps();
    assert!(work <= 40_000, "{work} steps: {a:?} {b:?}");
    assert!((0.0..=1.0).contains(&found.t) && (0.0..=1.0).contains(&found.u));
    let size = largest(a).max(largest(b));
    let slack = 16.0 * (2.0 + real(a.len().max(b.len()))) * ulp(size);
    let there = (p.eval(found.t) - q.eval(found.u)).norm();
    assert!((there - found.distance).abs() <= slack, "{found:?} {there}");
    // From samples of one curve to the nearest point of the other, which is tested elsewhere.
    let min = |p: &Curve<P>, q: &Curve<P>| {
        let of = |t: f64| q.nearest(p.eval(t)).expect("finite").distance;
        steps(60).map(of).fold(f64::INFINITY, f64::min)
    };
    let sampled = min(&p, &q).min(min(&q, &p));
    let side_by_side = 1e-5 * size;
    let back = q.distance_to(&p);
    let apart = (back.distance - found.distance).abs();
    let what = format!("{found:?}, but {sampled}, {back:?}: {a:?} {b:?}");
    assert!(found.distance <= sampled + side_by_side, "{what}");
    assert!(apart <= side_by_side + slack, "{what}");
    found.distance <= sampled * (1.0 + 1e-11) + slack && apart <= 1e-9 * found.distance + slack
}

#[test]
fn nothing_sampled_is_less_apart() {
    let mut rng = Rng(120);
    let mut rough = 0;
    for case in 0..cases() / 4 {
        let (a, b) = pair(&mut rng, 2 + case % 2);
        let check = [check::<DVec2>, check::<DVec3>][case % 2];
        rough += usize::from(!check(&a, &b));
    }
    println!("{rough} of {} to fewer digits", cases() / 4);
    assert!(rough <= cases() / 400, "{rough}");
}

#[test]
fn known_distances() {
    let arch = bezier("0 0, 0 2, 2 2, 2 0");
    for (points, other, distance) in [
        // A curve itself, a line that crosses it.
        ("0 0, 0 2, 2 2, 2 0", "0 0, 0 2, 2 2, 2 0", 0.0),
        ("0 0, 0 2, 2 2, 2 0", "1 0, 1 5", 0.0),
        // Parallel lines, a point, and curves that touch.
        ("0 2, 2 2", "5 7, 1 7", 5.0),
        ("0 2, 2 2", "1 3, 1 3", 1.0),
        ("-1 1, 0 -1, 1 1", "-1 -1, 0 1, 1 -1", 0.0),
    ] {
        let found = bezier(points).distance_to(&bezier(other));
        assert_eq!(found.distance, distance, "{points} and {other}");
    }
    // One above the other in space, at the same distance everywhere.
    let (low, high) = (
        xyz("0 0 0, 0 2 0, 2 2 0, 2 0 0"),
        xyz("0 0 3, 0 2 3, 2 2 3, 2 0 3"),
    );
    let (low, high) = (curve::<DVec3>(&low), curve::<DVec3>(&high));
    assert_eq!(low.distance_to(&high).distance, 3.0);
    for scale in [1.0, 1e149, 1e-300] {
        let scale = DAffine2::from_scale(DVec2::splat(scale));
        let found = (scale * &arch).distance_to(&(scale * &bezier("0 2, 2 2")));
        near(found.distance / scale.x_axis.x, 0.5, 1e-15);
        near(found.t, 0.5, 1e-7);
    }
}

#[test]
fn no_sample_is_farther_than_the_hausdorff_distance() {
    let mut rng = Rng(121);
    for case in 0..cases() / 10 {
        let dimension = 2 + case % 2;
        let (a, b) = pair(&mut rng, dimension);
        let (p, q): (Curve<DVec3>, Curve<DVec3>) = (curve(&a), curve(&b));
        let found = p.hausdorff(&q);
        // For curves that overlap with different parametrisations the search stops without proof, with about three
        // quarters of the distance or more (documented).
        let size = largest(&a).max(largest(&b));
        let unproven = if found < 1e-8 * size {
            0.4 * found
        } else {
            0.0
        };
        let slack = unproven + 1e-11 * size;
        let farthest = |p: &Curve<DVec3>, q: &Curve<DVec3>| {
            let of = |t: f64| q.nearest(p.eval(t)).expect("finite").distance;
            let farther = |a: (f64, f64), b: (f64, f64)| if b.0 > a.0 { b } else { a };
            let (far, at) = steps(60).map(|t| (of(t), t)).fold((0.0, 0.0), farther);
            // Refined around the farthest sample.
            let beside = steps(20).map(|s| (at + (s - 0.5) / 30.0).clamp(0.0, 1.0));
            beside.map(of).fold(far, f64::max)
        };
        let sampled = farthest(&p, &q).max(farthest(&q, &p));
        let what = format!("{found}, but {sampled}: {a:?} {b:?}");
        assert!(found >= sampled * (1.0 - 2e-9) - slack, "{what}");
        // The farthest point is within one step of a sample, so the sampled maximum is off by at most this step.
        let speeds = [p.derivative(), q.derivative()];
        let speeds = speeds.iter().flat_map(Curve::control_points);
        let max = sampled + speeds.map(|d| d.length()).fold(0.0, f64::max) / 120.0;
        assert!(found <= max + slack, "{max}: {what}");
        near_at(q.hausdorff(&p), found, 4e-9 * found + slack, what);
    }
}

/// A curve that runs back and forth on a line, and a curve with another parametrisation at a distance of 10⁻⁹.
#[test]
fn hausdorff_distance_of_nearly_straight_curves() {
    let (p, q) = (DVec3::new(0.35, 0.97, 0.96), DVec3::new(-0.79, 0.69, 0.19));
    let a: Curve<DVec3> = curve(&[p, p, q, p]);
    let beside = DVec3::new(0.3, -0.9, 0.2).cross(q - p).normalize() * 1e-9;
    let b: Curve<DVec3> = curve(&[p, q, p + beside * 1.5, p]);
    let off = |t: f64| {
        let (x, along) = (b.eval(t), (q - p).normalize());
        (x - p - along * (x - p).dot(along)).length()
    };
    let sampled = steps(3000).map(off).fold(0.0, f64::max);
    near(a.hausdorff(&b), sampled, 1e-14);
    near(b.hausdorff(&a), sampled, 1e-14);
}

#[test]
fn known_hausdorff_distances() {
    let arch = bezier("0 0, 0 2, 2 2, 2 0");
    assert_eq!(arch.hausdorff(&arch.reverse()), 0.0);
    assert_eq!(arch.elevate().expect("below 64").hausdorff(&arch), 0.0);
    for (a, b, expected) in [
        ("0 0, 0 2, 2 2, 2 0", "0 0, 0 2, 2 2, 2 0", 0.0),
        ("0 0, 0 2, 2 2, 2 0", "0 0, 2 0", 1.5),
        ("0 0, 2 0", "0 0, 2 0, 0 0, 2 0", 0.0),
        ("0 0, 2 0", "0.5 0, 0 0, 2 0, 5 0", 3.0),
        ("0 0, 2 0", "0 7, 2 7", 7.0),
        ("0 0, 2 0", "0 3, 0 3", 13.0_f64.sqrt()),
    ] {
        assert_eq!(bezier(a).hausdorff(&bezier(b)), expected, "{a} and {b}");
    }
    let to_part = |t0, t1| arch.hausdorff(&arch.subsegment(t0..t1));
    near(to_part(0.0, 0.5), to_part(0.5, 1.0), 1e-9);
}

/// The first intersection found is not exact, but another one is.
#[test]
fn a_curve_meets_its_reverse() {
    let curve = bezier(
        "0.0002543344871933788 10989.3293293552, -20355.57064578817 16056.545368093748,
         700211776.1813443 -174296297.85941, 0.00013144108736206755 10989.32935994768",
    );
    assert_eq!(curve.distance_to(&curve.reverse()).distance, 0.0);
}
