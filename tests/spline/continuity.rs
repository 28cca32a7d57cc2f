//! Continuity at a joint: a table from closed forms.

use crate::spline::plane;
use crate::support::{Rng, curve, plane as bezier, to_3d};
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::{Continuity, JointMode};
use casteljau::{Curve, Error, Spline};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use wasm_bindgen_test::wasm_bindgen_test;

/// G1, C1, G2, C2.
fn flags(c: &Continuity) -> [bool; 4] {
    assert!(c.c0 && c.gap == 0.0, "{c:?}");
    [c.g1, c.c1, c.g2, c.c2]
}

const CORNER: [bool; 4] = [false; 4];
const G1: [bool; 4] = [true, false, false, false];
const C1: [bool; 4] = [true, true, false, false];
const G2: [bool; 4] = [true, false, true, false];
const G2_C1: [bool; 4] = [true, true, true, false];
const C2: [bool; 4] = [true; 4];

/// P₃ = 0, P₂ = (−1, 0) and P₁ = (−1 − a, b) before it; P₄ and P₅ after it.
fn joint(p1: (f64, f64), p2: (f64, f64), p4: (f64, f64), p5: (f64, f64)) -> Spline<DVec2> {
    plane(
        &[(-9.0, 2.0), p1, p2, (0.0, 0.0), p4, p5, (9.0, -3.0)],
        3,
        false,
    )
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_of_continuity() {
    let (p1, p2) = ((-3.0, 1.0), (-1.0, 0.0));
    // |κ| = ⅔ h / a² with a the length of the handle and h the distance of the second point from the tangent. The signs
    // are equal if both second points lie on the same side of the tangent.
    let table = [
        ("a right angle", (0.0, 1.0), (1.0, 1.0), CORNER, FRAC_PI_2),
        ("half of it", (1.0, 1.0), (3.0, 1.0), CORNER, FRAC_PI_4),
        ("back again", (-1.0, 0.0), (-3.0, 1.0), CORNER, PI),
        ("aligned", (2.0, 0.0), (3.0, -1.0), G1, 0.0),
        ("aligned and as long", (1.0, 0.0), (2.0, -1.0), C1, 0.0),
        // Twice as long and four times the height: the same curvature.
        ("the same curvature", (2.0, 0.0), (5.0, 4.0), G2, 0.0),
        (
            "the same curvature, as long",
            (1.0, 0.0),
            (7.0, 1.0),
            G2_C1,
            0.0,
        ),
        // P₅ = P₁ + 4(P₃ − P₂).
        (
            "the same second derivative",
            (1.0, 0.0),
            (1.0, 1.0),
            C2,
            0.0,
        ),
    ];
    for (name, p4, p5, expected, angle) in table {
        for degrees in [0.0_f64, 0.1, 0.7] {
            // Rotated, since the axes are not special.
            let turn = DVec2::from_angle(degrees);
            let at = |(x, y): (f64, f64)| {
                let p = turn.rotate(DVec2::new(x, y));
                (p.x, p.y)
            };
            let found = joint(at(p1), at(p2), at(p4), at(p5))
                .continuity(1, None)
                .expect("a joint");
            assert_eq!(flags(&found), expected, "{name}");
            assert!(
                (found.angle - angle).abs() < 1e-15,
                "{name}: {}",
                found.angle
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn continuity_does_not_depend_on_the_scale() {
    for scale in [1e-300, 1e-9, 1e9, 1e149] {
        let at = |x: f64, y: f64| (x * scale, y * scale);
        let c2 = plane(
            &[
                at(-4.0, 2.0),
                at(-3.0, 1.0),
                at(-1.0, 0.0),
                at(0.0, 0.0),
                at(1.0, 0.0),
                at(1.0, 1.0),
                at(4.0, 4.0),
            ],
            3,
            false,
        );
        assert_eq!(
            flags(&c2.continuity(1, None).expect("a joint")),
            C2,
            "{scale}"
        );
        let g1 = plane(
            &[
                at(-4.0, 2.0),
                at(-3.0, 1.0),
                at(-1.0, 0.0),
                at(0.0, 0.0),
                at(2.0, 0.0),
                at(1.0, 1.0),
                at(4.0, 4.0),
            ],
            3,
            false,
        );
        assert_eq!(
            flags(&g1.continuity(1, None).expect("a joint")),
            G1,
            "{scale}"
        );
    }
}

/// A curve split at t: geometric continuity always holds; derivatives are equal only if both pieces cover equal spans.
#[wasm_bindgen_test(unsupported = test)]
fn pieces_of_one_curve() {
    let mut rng = Rng(51);
    for degree in [2, 3, 4, 6] {
        let points: Vec<DVec3> = (0..=degree).map(|_| rng.point(3)).collect();
        for t in [0.5, 0.25] {
            let (left, right) = curve::<DVec3>(&points).split(t);
            let spline = Spline::from_curves(&[left, right], false).expect("joined");
            let found = spline.continuity(1, None).expect("a joint");
            assert_eq!(
                flags(&found),
                if t == 0.5 { C2 } else { G2 },
                "degree {degree} at {t}"
            );
        }
        let flat: Vec<(f64, f64)> = points.iter().map(|p| (p.x, p.y)).collect();
        let (left, right) = bezier(&flat).split(0.5);
        // The same shape at a higher degree.
        let right = right.elevate().expect("below 64");
        let spline = Spline::from_curves(&[left, right], false).expect("joined");
        assert_eq!(
            flags(&spline.continuity(1, None).expect("a joint")),
            C2,
            "degree {degree}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_tolerance_is_a_distance() {
    // The end of the handle lies 1e-3 off the tangent; the derivatives differ by 3e-3.
    let spline = joint((-3.0, 1.0), (-1.0, 0.0), (1.0, 1e-3), (5.0, 1.0));
    let at = |tolerance: f64| spline.continuity(1, Some(tolerance)).expect("a joint");
    assert!(at(1.1e-3).g1 && !at(0.9e-3).g1);
    assert!(at(3.1e-3).c1 && !at(2.9e-3).c1);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            spline.continuity(1, Some(bad)),
            Err(Error::Range {
                what: "tolerance",
                ..
            })
        ));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn zero_length_handles_are_judged_by_their_limit() {
    let at = |p2: (f64, f64), p4: (f64, f64), p5: (f64, f64)| {
        let found = joint((-3.0, 0.0), p2, p4, p5)
            .continuity(1, None)
            .expect("a joint");
        (found.g1, found.c1, found.angle)
    };
    // P₄ = P₃: the direction after the joint is towards P₅.
    assert_eq!(at((-1.0, 0.0), (0.0, 0.0), (2.0, 0.0)), (true, false, 0.0));
    let (g1, c1, angle) = at((-1.0, 0.0), (0.0, 0.0), (0.0, 2.0));
    assert!(!g1 && !c1 && (angle - FRAC_PI_2).abs() < 1e-15);
    // Both handles 0: the motion stops and continues.
    let (g1, c1, angle) = at((0.0, 0.0), (0.0, 0.0), (2.0, 0.0));
    assert!(g1 && c1 && angle == 0.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn in_space_and_at_the_seam_of_a_closed_spline() {
    // A nearly circular ring of four quadratics through the middles of a square's sides: C1, not C2.
    let ring = plane(
        &[
            (1.0, 0.0),
            (1.0, 1.0),
            (0.0, 1.0),
            (-1.0, 1.0),
            (-1.0, 0.0),
            (-1.0, -1.0),
            (0.0, -1.0),
            (1.0, -1.0),
        ],
        2,
        true,
    );
    let space: Vec<DVec3> = to_3d(ring.control_points())
        .iter()
        .map(|p| DVec3::new(p.y, 1.0, p.x))
        .collect();
    let space = Spline::new(&space, 2, true).expect("a spline");
    for k in 0..4 {
        assert_eq!(flags(&ring.continuity(k, None).expect("a joint")), G2_C1);
        assert_eq!(flags(&space.continuity(k, None).expect("a joint")), G2_C1);
    }
    // The osculating planes differ: the tangent is continuous, the curvature vector is not.
    let twisted = [
        DVec3::new(-2.0, 1.0, 0.0),
        DVec3::NEG_X,
        DVec3::ZERO,
        DVec3::X,
        DVec3::new(2.0, 0.0, 1.0),
    ];
    let twisted = Spline::new(&twisted, 2, false).expect("a spline");
    assert_eq!(flags(&twisted.continuity(1, None).expect("a joint")), C1);
}

#[wasm_bindgen_test(unsupported = test)]
fn set_joint_keeps_the_handle_before() {
    let spline = joint((-3.0, 1.0), (-1.0, 0.0), (3.0, 4.0), (5.0, 5.0));
    let with = |mode| spline.set_joint(1, mode).expect("a joint").control_points()[4];
    assert_eq!(with(JointMode::Free), DVec2::new(3.0, 4.0));
    // G1 keeps the length 5, C1 uses the length of the other handle.
    assert_eq!(with(JointMode::G1), DVec2::new(5.0, 0.0));
    assert_eq!(with(JointMode::C1), DVec2::new(1.0, 0.0));
    for mode in [JointMode::Free, JointMode::G1, JointMode::C1] {
        let set = spline.set_joint(1, mode).expect("a joint");
        let kept = |i: usize| set.control_points()[i] == spline.control_points()[i];
        assert!((0..7).filter(|&i| i != 4).all(kept));
    }
    // Degrees 3 and 2: 3(P₃ − P₂) = 2(P₄ − P₃).
    let mixed = [
        (-2.0, 1.0),
        (-1.0, 2.0),
        (-1.0, 0.0),
        (0.0, 0.0),
        (1.0, 1.0),
        (2.0, 0.0),
    ];
    let mixed = mixed.map(|(x, y)| DVec2::new(x, y)).to_vec();
    let mixed = Spline::with_degrees(mixed, &[3, 2], false)
        .and_then(|s| s.set_joint(1, JointMode::C1))
        .expect("a joint");
    assert_eq!(mixed.control_points()[4], DVec2::new(1.5, 0.0));
    assert!(mixed.continuity(1, None).expect("a joint").c1);
    // A handle of length 0 has no direction: the other handle is unchanged.
    let still = joint((-3.0, 1.0), (0.0, 0.0), (3.0, 4.0), (5.0, 5.0)).set_joint(1, JointMode::G1);
    assert_eq!(
        still.expect("a joint").control_points()[4],
        DVec2::new(3.0, 4.0)
    );
}

/// Two lines in one direction, a line and a curve: degrees do not matter, only derivatives.
#[wasm_bindgen_test(unsupported = test)]
fn lines() {
    let line = |x0: f64, x1: f64| bezier(&[(x0, 0.0), (x1, 0.0)]);
    let at = |a: Curve<DVec2>, b: Curve<DVec2>| {
        let spline = Spline::from_curves(&[a, b], false).expect("joined");
        flags(&spline.continuity(1, None).expect("a joint"))
    };
    assert_eq!(at(line(0.0, 1.0), line(1.0, 2.0)), C2);
    assert_eq!(at(line(0.0, 1.0), line(1.0, 4.0)), G2);
    assert_eq!(
        at(
            line(0.0, 1.0),
            bezier(&[(1.0, 0.0), (1.5, 0.0), (2.0, 1.0)])
        ),
        C1
    );
}
