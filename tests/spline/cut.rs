//! Insertion and removal of joints.

use crate::spline::{control, each_spline, random};
use crate::support::{Rng, all_near, exact, near_at, real, spline, xy, xyz};
use casteljau::Spline;
use casteljau::glam::{DVec2, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The maximum difference of control points, for the same structure.
fn difference(a: &Spline<DVec3>, b: &Spline<DVec3>) -> f64 {
    assert_eq!((a.degrees(), a.is_closed()), (b.degrees(), b.is_closed()));
    let pairs = a.control_points().iter().zip(b.control_points());
    pairs.map(|(&p, &q)| (p - q).length()).fold(0.0, f64::max)
}

#[test]
fn inserting_keeps_the_curve() {
    each_spline(31, |spline, degrees| {
        let points = spline.control_points();
        for k in 0..degrees.len() {
            let cut = 0.375;
            let more = spline.insert(real(k) + cut).expect("inside");
            let mut expected = degrees.to_vec();
            expected.insert(k, degrees[k]);
            assert_eq!(
                (more.degrees(), more.is_closed()),
                (expected, spline.is_closed())
            );
            assert_eq!(more.control_points()[0], points[0]);
            let whole = control(points, degrees, k);
            for s in [0.0, 0.25, 0.5, 1.0] {
                for (k, t) in [(k, cut * s), (k + 1, cut + (1.0 - cut) * s)] {
                    let got = more.eval(real(k) + s);
                    near_at(got, exact::eval(&whole, t), 1e-14 * 66.0, degrees);
                }
            }
        }
    });
}

#[test]
fn at_a_joint_or_an_end_there_is_nothing_to_insert() {
    let spline = random::<DVec3>(&mut Rng(32), &[3, 2, 1], false);
    for t in [0.0, 1.0, 2.0, 3.0] {
        assert_eq!(spline.insert(t), Ok(spline.clone()));
    }
}

#[test]
fn removing_undoes_an_insert() {
    let mut rng = Rng(33);
    let single: [&[usize]; 6] = [&[1], &[2], &[3], &[4], &[5], &[7]];
    let several: [&[usize]; 3] = [&[3, 3, 3], &[2, 4, 1], &[1, 2, 3, 4, 5]];
    for degrees in single.into_iter().chain(several) {
        for closed in [false, true] {
            let spline = random(&mut rng, degrees, closed);
            for k in 0..degrees.len() {
                for cut in [0.5_f64, 0.25, 0.3, 0.7] {
                    let more = spline.insert(real(k) + cut).expect("inside");
                    let off = difference(&more.remove(k + 1).expect("a joint"), &spline);
                    // Each level of extrapolation by 1/cut may double the rounding error or more.
                    let steps = i32::try_from(degrees[k]).expect("small");
                    let growth = (2.0 / cut.min(1.0 - cut)).powi(steps);
                    let max = if degrees[k] > 3 { 1e-15 * growth } else { 0.0 };
                    assert!(off <= max.max(1e-12), "{degrees:?} at {k} + {cut}: {off:e}");
                }
            }
        }
    }
}

#[test]
fn zero_length_handles_heal_too() {
    let stopping = Spline::new(&xyz("0 0 0, 0 0 0, 1 2 0, 3 1 1"), 3, false);
    let stopping = stopping.expect("a spline");
    for spline in [stopping.reverse(), stopping] {
        let more = spline.insert(0.5).expect("inside");
        assert!(difference(&more.remove(1).expect("a joint"), &spline) < 1e-12);
    }
    // A joint with two handles of length 0: from the second points, t₀ = √|P₁P₃| / (√|P₁P₃| + √|P₅P₃|).
    let healed = spline("0 0, -1 0, 0 0, 0 0, 0 0, 4 1, 6 0", 3, false).remove(1);
    let t0 = 1.0 / (1.0 + 17.0_f64.sqrt().sqrt());
    let p1 = DVec2::new(-1.0 / t0, 0.0);
    let p2 = DVec2::new(6.0 - 2.0 / (1.0 - t0), 1.0 / (1.0 - t0));
    let expected = [DVec2::ZERO, p1, p2, DVec2::new(6.0, 0.0)];
    all_near(healed.expect("a joint").control_points(), &expected, 1e-14);
    // All points coincide: the result is finite.
    let point = spline("1 1, 1 1, 1 1, 1 1, 1 1, 1 1, 1 1", 3, false).remove(1);
    assert_eq!(
        point.expect("a joint").control_points(),
        xy("1 1, 1 1, 1 1, 1 1")
    );
}

/// P₁′ = P₀ + (P₁ − P₀)/t₀, P₂′ = P₆ + (P₅ − P₆)/(1 − t₀), t₀ = a/(a + b).
#[test]
fn any_two_cubics_become_one_by_the_rule() {
    let mut rng = Rng(34);
    for _ in 0..50 {
        let spline = random::<DVec3>(&mut rng, &[3, 3], false);
        let p = spline.control_points();
        let (a, b) = ((p[3] - p[2]).length(), (p[4] - p[3]).length());
        let t0 = a / (a + b);
        let (p1, p2) = (p[0] + (p[1] - p[0]) / t0, p[6] + (p[5] - p[6]) / (1.0 - t0));
        let healed = spline.remove(1).expect("a joint");
        let scale = 1.0 / t0.min(1.0 - t0);
        all_near(
            healed.control_points(),
            &[p[0], p1, p2, p[6]],
            1e-14 * scale * scale,
        );
    }
}

#[test]
fn the_first_joint_of_a_closed_spline_can_go() {
    let spline = random::<DVec3>(&mut Rng(35), &[3, 3, 3], true);
    let less = spline.remove(0).expect("a joint");
    // The list starts at the former joint 1; the merged segment, from joint 2 over 0 to 1, comes last.
    assert_eq!((less.degrees(), less.is_closed()), (vec![3, 3], true));
    assert_eq!(less.control_points()[..4], spline.control_points()[3..7]);
    assert_eq!(less.control_points().len(), 6);
}

#[test]
fn the_lower_degree_is_elevated() {
    let spline = random::<DVec3>(&mut Rng(36), &[1, 3], false);
    let healed = spline.remove(1).expect("a joint");
    assert_eq!(healed.degrees(), [3]);
    let (p, q) = (spline.control_points(), healed.control_points());
    assert_eq!((q[0], q[3]), (p[0], p[4]));
}
