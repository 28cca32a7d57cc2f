//! Insertion and removal of joints.

use crate::spline::{STRUCTURES, control, plane, random};
use crate::support::{Rng, exact, real};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Error, Spline};
use wasm_bindgen_test::wasm_bindgen_test;

/// The maximum difference of control points, for the same structure.
fn difference(a: &Spline<DVec3>, b: &Spline<DVec3>) -> f64 {
    assert_eq!((a.degrees(), a.is_closed()), (b.degrees(), b.is_closed()));
    let pairs = a.control_points().iter().zip(b.control_points());
    pairs.map(|(&p, &q)| (p - q).length()).fold(0.0, f64::max)
}

#[wasm_bindgen_test(unsupported = test)]
fn inserting_keeps_the_curve() {
    let mut rng = Rng(31);
    for degrees in STRUCTURES {
        for closed in [false, true] {
            let spline = random(&mut rng, degrees, closed);
            for k in 0..degrees.len() {
                let cut = 0.375;
                let more = spline.insert(real(k) + cut).expect("inside");
                let mut expected = degrees.to_vec();
                expected.insert(k, degrees[k]);
                assert_eq!((more.degrees(), more.is_closed()), (expected, closed));
                assert_eq!(more.control_points()[0], spline.control_points()[0]);
                let whole = control(spline.control_points(), degrees, k);
                for s in [0.0, 0.25, 0.5, 1.0] {
                    let near =
                        |got: DVec3, t: f64| (got - exact::eval(&whole, t)).length() < 1e-14 * 66.0;
                    assert!(near(more.eval(real(k) + s), cut * s), "{degrees:?}");
                    assert!(
                        near(more.eval(real(k + 1) + s), cut + (1.0 - cut) * s),
                        "{degrees:?}"
                    );
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn at_a_joint_or_an_end_there_is_nothing_to_insert() {
    let spline = random(&mut Rng(32), &[3, 2, 1], false);
    for t in [0.0, 1.0, 2.0, 3.0] {
        assert_eq!(spline.insert(t), Ok(spline.clone()));
    }
    for t in [-1e-9, 3.000_001, f64::NAN, f64::INFINITY] {
        assert!(
            matches!(spline.insert(t), Err(Error::Range { what: "t", .. })),
            "{t}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn removing_undoes_an_insert() {
    let mut rng = Rng(33);
    for degrees in [
        &[1][..],
        &[2],
        &[3],
        &[4],
        &[5],
        &[7],
        &[3, 3, 3],
        &[2, 4, 1],
        &[1, 2, 3, 4, 5],
    ] {
        for closed in [false, true] {
            let spline = random(&mut rng, degrees, closed);
            for k in 0..degrees.len() {
                for cut in [0.5, 0.25, 0.3, 0.7] {
                    let more = spline.insert(real(k) + cut).expect("inside");
                    let healed = more.remove(k + 1).expect("a joint");
                    let off = difference(&healed, &spline);
                    // Each level of extrapolation by 1/cut may double the rounding error or more.
                    let allowed = 1e-15
                        * (2.0 / cut.min(1.0 - cut))
                            .powi(i32::try_from(degrees[k]).expect("small"));
                    assert!(
                        off <= allowed.max(1e-12),
                        "{degrees:?} at {k} + {cut}: {off:e}"
                    );
                    assert!(
                        degrees[k] > 3 || off <= 1e-12,
                        "{degrees:?} at {k} + {cut}: {off:e}"
                    );
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn zero_length_handles_heal_too() {
    let stopping = [
        DVec3::ZERO,
        DVec3::ZERO,
        DVec3::new(1.0, 2.0, 0.0),
        DVec3::new(3.0, 1.0, 1.0),
    ];
    for points in [
        stopping,
        [stopping[3], stopping[2], stopping[1], stopping[0]],
    ] {
        let spline = Spline::new(&points, 3, false).expect("a spline");
        let healed = spline
            .insert(0.5)
            .and_then(|more| more.remove(1))
            .expect("a joint");
        assert!(difference(&healed, &spline) < 1e-12);
    }
    // A joint with two handles of length 0: from the second points, t₀ = √|P₁P₃| / (√|P₁P₃| + √|P₅P₃|).
    let p = [
        (0.0, 0.0),
        (-1.0, 0.0),
        (0.0, 0.0),
        (0.0, 0.0),
        (0.0, 0.0),
        (4.0, 1.0),
        (6.0, 0.0),
    ];
    let healed = plane(&p, 3, false).remove(1).expect("a joint");
    let t0 = 1.0 / (1.0 + 17.0_f64.sqrt().sqrt());
    let expected = [
        DVec2::ZERO,
        DVec2::new(-1.0 / t0, 0.0),
        DVec2::new(6.0 - 2.0 / (1.0 - t0), 1.0 / (1.0 - t0)),
        DVec2::new(6.0, 0.0),
    ];
    let got = healed.control_points();
    assert!(
        got.iter()
            .zip(expected)
            .all(|(&p, q)| (p - q).length() < 1e-14),
        "{got:?}"
    );
    // All points coincide: the result is finite.
    let point = plane(&[(1.0, 1.0); 7], 3, false)
        .remove(1)
        .expect("a joint");
    assert_eq!(point.control_points(), [DVec2::ONE; 4]);
}

/// P₁′ = P₀ + (P₁ − P₀)/t₀, P₂′ = P₆ + (P₅ − P₆)/(1 − t₀), t₀ = a/(a + b).
#[wasm_bindgen_test(unsupported = test)]
fn any_two_cubics_become_one_by_the_rule() {
    let mut rng = Rng(34);
    for _ in 0..50 {
        let spline = random(&mut rng, &[3, 3], false);
        let p = spline.control_points();
        let (a, b) = ((p[3] - p[2]).length(), (p[4] - p[3]).length());
        let t0 = a / (a + b);
        let expected = [
            p[0],
            p[0] + (p[1] - p[0]) / t0,
            p[6] + (p[5] - p[6]) / (1.0 - t0),
            p[6],
        ];
        let healed = spline.remove(1).expect("a joint");
        let scale = 1.0 / t0.min(1.0 - t0);
        for (&got, expected) in healed.control_points().iter().zip(expected) {
            assert!(
                (got - expected).length() < 1e-14 * scale * scale,
                "{got} instead of {expected}"
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_first_joint_of_a_closed_spline_can_go() {
    let mut rng = Rng(35);
    let spline = random(&mut rng, &[3, 3, 3], true);
    let p = spline.control_points();
    let less = spline.remove(0).expect("a joint");
    // The list starts at the former joint 1; the merged segment, from joint 2 over 0 to 1, comes last.
    assert_eq!((less.degrees(), less.is_closed()), (vec![3, 3], true));
    assert_eq!(less.control_points()[..4], p[3..7]);
    assert_eq!(less.control_points().len(), 6);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_lower_degree_is_elevated() {
    let spline = random(&mut Rng(36), &[1, 3], false);
    let healed = spline.remove(1).expect("a joint");
    assert_eq!(healed.degrees(), [3]);
    let (p, q) = (spline.control_points(), healed.control_points());
    assert_eq!((q[0], q[3]), (p[0], p[4]));
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_no_joint_is_refused() {
    let open = random(&mut Rng(37), &[3, 3, 3], false);
    for joint in [0, 3, 4, usize::MAX] {
        let refused = Error::Index {
            what: "joint",
            first: 1,
            last: 2,
            got: joint,
        };
        assert_eq!(open.remove(joint), Err(refused));
        assert_eq!(open.continuity(joint, None), Err(refused));
        assert_eq!(
            open.set_joint(joint, casteljau::spline::JointMode::G1),
            Err(refused)
        );
    }
    let closed = random(&mut Rng(38), &[3, 3], true);
    assert!(closed.remove(0).is_ok() && closed.remove(2).is_err());
    let ring = random(&mut Rng(39), &[3], true);
    assert!(matches!(
        ring.remove(0),
        Err(Error::Count {
            what: "segments",
            got: 1,
            ..
        })
    ));
    assert!(random(&mut Rng(39), &[3], false).remove(0).is_err());
}
