//! The distance between curves (minimum and Hausdorff), compared with grids of samples.

use crate::points::{cases, hostile, steps};
use crate::support::adversarial::ORDINARY;
use crate::support::{Rng, Space, curve, largest, plane, real, ulp};
use casteljau::Curve;
use casteljau::glam::{DVec2, DVec3};
use casteljau::take_steps;

/// Two curves that may cross, touch, overlap, or be equal.
fn pair(rng: &mut Rng, dimension: usize) -> (Vec<DVec3>, Vec<DVec3>) {
    let a = hostile(rng, &ORDINARY, dimension);
    let on: Curve<DVec3> = curve(&a);
    let (s, t) = (rng.unit(), rng.unit());
    let b = match rng.below(8) {
        0 => a.clone(),
        1 => on.subsegment(s, t).control_points().to_vec(),
        2 => {
            let direction = rng.point(dimension) * rng.magnitude(-12.0, 1.0);
            a.iter().map(|&p| p + direction).collect()
        }
        3 => a
            .iter()
            .rev()
            .map(|&p| p + rng.point(dimension) * 1e-9)
            .collect(),
        4 => {
            let mut b = hostile(rng, &ORDINARY, dimension);
            b[0] = on.eval(t);
            b
        }
        _ => {
            let direction = rng.point(dimension) * rng.pick(&[0.0, 1.0, 3.0]);
            hostile(rng, &ORDINARY, dimension)
                .iter()
                .map(|&p| p + direction)
                .collect()
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
    let there = (p.eval(found.t) - q.eval(found.u)).length();
    assert!((there - found.distance).abs() <= slack, "{found:?} {there}");
    // From samples of one curve to the nearest point of the other, which is tested elsewhere.
    let min = |p: &Curve<P>, q: &Curve<P>| {
        let of = |t: f64| q.nearest(p.eval(t)).expect("finite").distance;
        steps(60).map(of).fold(f64::INFINITY, f64::min)
    };
    let sampled = min(&p, &q).min(min(&q, &p));
    let side_by_side = 1e-5 * size;
    assert!(
        found.distance <= sampled + side_by_side,
        "{found:?}, but {sampled}: {a:?} {b:?}"
    );
    let back = q.distance_to(&p);
    let apart = (back.distance - found.distance).abs();
    assert!(
        apart <= side_by_side + slack,
        "{found:?} {back:?}: {a:?} {b:?}"
    );
    found.distance <= sampled * (1.0 + 1e-11) + slack && apart <= 1e-9 * found.distance + slack
}

#[test]
fn nothing_sampled_is_less_apart() {
    let mut rng = Rng(120);
    let mut rough = 0;
    for case in 0..cases() / 4 {
        let (a, b) = pair(&mut rng, 2 + case % 2);
        let exact = if case % 2 == 0 {
            check::<DVec2>(&a, &b)
        } else {
            check::<DVec3>(&a, &b)
        };
        rough += usize::from(!exact);
    }
    println!("{rough} of {} to fewer digits", cases() / 4);
    assert!(rough <= cases() / 400, "{rough}");
}

#[test]
fn known_distances() {
    let arch = plane(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)]);
    let line = plane(&[(0.0, 2.0), (2.0, 2.0)]);
    let found = arch.distance_to(&line);
    assert!(
        (found.distance - 0.5).abs() < 1e-15 && (found.t - 0.5).abs() < 1e-7,
        "{found:?}"
    );
    assert_eq!(arch.distance_to(&arch).distance, 0.0);
    assert_eq!(
        arch.distance_to(&plane(&[(1.0, 0.0), (1.0, 5.0)])).distance,
        0.0
    );
    // Parallel lines, a point, and curves that touch.
    assert_eq!(
        line.distance_to(&plane(&[(5.0, 7.0), (1.0, 7.0)])).distance,
        5.0
    );
    assert_eq!(
        line.distance_to(&plane(&[(1.0, 3.0), (1.0, 3.0)])).distance,
        1.0
    );
    let bowl = plane(&[(-1.0, 1.0), (0.0, -1.0), (1.0, 1.0)]);
    assert_eq!(
        bowl.distance_to(&plane(&[(-1.0, -1.0), (0.0, 1.0), (1.0, -1.0)]))
            .distance,
        0.0
    );
    // One above the other in space, at the same distance everywhere.
    let points = [(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)];
    let at = |z: f64| Curve::new(&points.map(|(x, y)| DVec3::new(x, y, z))).expect("finite");
    assert_eq!(at(0.0).distance_to(&at(3.0)).distance, 3.0);
    for scale in [1e149, 1e-300] {
        let big = |curve: &Curve<DVec2>| {
            Curve::new(
                &curve
                    .control_points()
                    .iter()
                    .map(|&p| p * scale)
                    .collect::<Vec<_>>(),
            )
            .expect("finite")
        };
        let found = big(&arch).distance_to(&big(&line));
        assert!((found.distance / scale - 0.5).abs() < 1e-15, "{found:?}");
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
        let slack = if found < 1e-8 * size {
            0.4 * found
        } else {
            0.0
        } + 1e-11 * size;
        let farthest = |p: &Curve<DVec3>, q: &Curve<DVec3>| {
            let of = |t: f64| q.nearest(p.eval(t)).expect("finite").distance;
            let (far, at) = steps(60)
                .map(|t| (of(t), t))
                .fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
            // Refined around the farthest sample.
            steps(20)
                .map(|s| of((at + (s - 0.5) / 30.0).clamp(0.0, 1.0)))
                .fold(far, f64::max)
        };
        let sampled = farthest(&p, &q).max(farthest(&q, &p));
        assert!(
            found >= sampled * (1.0 - 2e-9) - slack,
            "{found}, but {sampled}: {a:?} {b:?}"
        );
        // The farthest point is within one step of a sample, so the sampled maximum is off by at most this step.
        let max = sampled
            + (p.derivative()
                .control_points()
                .iter()
                .chain(q.derivative().control_points()))
            .map(|d| d.length())
            .fold(0.0, f64::max)
                / 120.0;
        assert!(found <= max + slack, "{found} above {max}: {a:?} {b:?}");
        let back = q.hausdorff(&p);
        assert!(
            (back - found).abs() <= 4e-9 * found + slack,
            "{found} {back}: {a:?} {b:?}"
        );
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
    for found in [a.hausdorff(&b), b.hausdorff(&a)] {
        assert!((found - sampled).abs() < 1e-14, "{found}, but {sampled}");
    }
}

#[test]
fn known_hausdorff_distances() {
    let arch = plane(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)]);
    let line = plane(&[(0.0, 0.0), (2.0, 0.0)]);
    assert_eq!(arch.hausdorff(&arch), 0.0);
    assert_eq!(arch.hausdorff(&arch.reverse()), 0.0);
    assert_eq!(arch.elevate().expect("below 64").hausdorff(&arch), 0.0);
    assert_eq!(arch.hausdorff(&line), 1.5);
    assert_eq!(
        line.hausdorff(&plane(&[(0.0, 0.0), (2.0, 0.0), (0.0, 0.0), (2.0, 0.0)])),
        0.0
    );
    assert_eq!(
        line.hausdorff(&plane(&[(0.5, 0.0), (0.0, 0.0), (2.0, 0.0), (5.0, 0.0)])),
        3.0
    );
    assert_eq!(line.hausdorff(&plane(&[(0.0, 7.0), (2.0, 7.0)])), 7.0);
    assert_eq!(
        line.hausdorff(&plane(&[(0.0, 3.0), (0.0, 3.0)])),
        13.0_f64.sqrt()
    );
    assert!(
        (arch.hausdorff(&arch.subsegment(0.0, 0.5)) - arch.hausdorff(&arch.subsegment(0.5, 1.0)))
            .abs()
            < 1e-9
    );
}

/// The first intersection found is not exact, but another one is.
#[test]
fn a_curve_meets_its_reverse() {
    let points = [
        (0.0002543344871933788, 10989.3293293552),
        (-20355.57064578817, 16056.545368093748),
        (700211776.1813443, -174296297.85941),
        (0.00013144108736206755, 10989.32935994768),
    ];
    let curve = Curve::new(&points.map(DVec2::from)).expect("a curve");
    assert_eq!(curve.distance_to(&curve.reverse()).distance, 0.0);
}
