//! Continuity at a joint: a table from closed forms.

use crate::spline::continuity;
use crate::support::{Rng, bezier, curve, near_at, random_points, refused, spline, xy, xyz};
use casteljau::glam::{DAffine2, DVec2, DVec3};
use casteljau::spline::JointMode::{C1, Free, G1};
use casteljau::{Curve, Point, Spline};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The names of the kinds of continuity at a joint without a gap.
fn kinds<P: Point>(spline: &Spline<P>, joint: usize) -> String {
    let c = continuity(spline, joint, None);
    assert!(c.c0 && c.gap == 0.0, "{c:?}");
    let all = [("G1", c.g1), ("C1", c.c1), ("G2", c.g2), ("C2", c.c2)];
    let names = all
        .iter()
        .filter(|(_, holds)| *holds)
        .map(|(name, _)| *name);
    names.collect::<Vec<_>>().join(" ")
}

/// Two cubics with their joint in the origin; `inner` is the text of P₁, P₂, P₃, P₄, P₅.
fn joint(inner: &str) -> Spline<DVec2> {
    spline(&format!("-9 2, {inner}, 9 -3"), 3, false)
}

fn joined<P: Point>(curves: (Curve<P>, Curve<P>)) -> Spline<P> {
    Spline::from_curves(&[curves.0, curves.1], false).expect("joined")
}

#[test]
fn the_table_of_continuity() {
    // |κ| = ⅔ h / a² with a the length of the handle and h the distance of the second point from the tangent. The signs
    // are equal if both second points lie on the same side of the tangent.
    let table = [
        ("a right angle", "0 1, 1 1", "", FRAC_PI_2),
        ("half of it", "1 1, 3 1", "", FRAC_PI_4),
        ("back again", "-1 0, -3 1", "", PI),
        ("aligned", "2 0, 3 -1", "G1", 0.0),
        ("aligned and as long", "1 0, 2 -1", "G1 C1", 0.0),
        // Twice as long and four times the height: the same curvature.
        ("the same curvature", "2 0, 5 4", "G1 G2", 0.0),
        ("the same curvature, as long", "1 0, 7 1", "G1 C1 G2", 0.0),
        // P₅ = P₁ + 4(P₃ − P₂).
        ("the same second derivative", "1 0, 1 1", "G1 C1 G2 C2", 0.0),
    ];
    for (name, after, expected, angle) in table {
        let spline = joint(&format!("-3 1, -1 0, 0 0, {after}"));
        for turn in [0.0_f64, 0.1, 0.7] {
            // Rotated, since the axes are not special.
            let image = spline
                .transform(&DAffine2::from_angle(turn))
                .expect("a finite image");
            assert_eq!(kinds(&image, 1), expected, "{name}");
            near_at(continuity(&image, 1, None).angle, angle, 1e-15, name);
        }
        for scale in [1e-300, 1e-9, 1e9, 1e149] {
            let points: Vec<DVec2> = spline.control_points().iter().map(|&p| p * scale).collect();
            let image = Spline::new(&points, 3, false).expect("a spline");
            assert_eq!(kinds(&image, 1), expected, "{name}, {scale:e}");
        }
    }
}

/// A curve split at t: geometric continuity always holds; derivatives are equal only if both pieces cover equal spans.
#[test]
fn pieces_of_one_curve() {
    let mut rng = Rng(51);
    for degree in [2, 3, 4, 6] {
        let points: Vec<DVec3> = random_points(&mut rng, degree + 1);
        for (t, expected) in [(0.5, "G1 C1 G2 C2"), (0.25, "G1 G2")] {
            let spline = joined(curve::<DVec3>(&points).split(t));
            assert_eq!(kinds(&spline, 1), expected, "degree {degree} at {t}");
        }
        let (left, right) = curve::<DVec2>(&points).split(0.5);
        // The same shape at a higher degree.
        let spline = joined((left, right.elevate().expect("below 64")));
        assert_eq!(kinds(&spline, 1), "G1 C1 G2 C2", "degree {degree}");
    }
}

#[test]
fn the_tolerance_is_a_distance() {
    // The end of the handle lies 1e-3 off the tangent; the derivatives differ by 3e-3.
    let spline = joint("-3 1, -1 0, 0 0, 1 1e-3, 5 1");
    let at = |tolerance: f64| continuity(&spline, 1, Some(tolerance));
    assert!(at(1.1e-3).g1 && !at(0.9e-3).g1);
    assert!(at(3.1e-3).c1 && !at(2.9e-3).c1);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(spline.continuity_within(1, bad), "Range tolerance");
    }
}

#[test]
fn zero_length_handles_are_judged_by_their_limit() {
    for (inner, g1, c1, angle) in [
        // P₄ = P₃: the direction after the joint is towards P₅.
        ("-3 0, -1 0, 0 0, 0 0, 2 0", true, false, 0.0),
        ("-3 0, -1 0, 0 0, 0 0, 0 2", false, false, FRAC_PI_2),
        // Both handles 0: the motion stops and continues.
        ("-3 0, 0 0, 0 0, 0 0, 2 0", true, true, 0.0),
    ] {
        let found = continuity(&joint(inner), 1, None);
        assert_eq!((found.g1, found.c1), (g1, c1), "{inner}");
        near_at(found.angle, angle, if g1 { 0.0 } else { 1e-15 }, inner);
    }
}

#[test]
fn in_space_and_at_the_seam_of_a_closed_spline() {
    // A nearly circular ring of four quadratics through the middles of a square's sides: C1, not C2.
    let ring = spline("1 0, 1 1, 0 1, -1 1, -1 0, -1 -1, 0 -1, 1 -1", 2, true);
    let in_space = |p: &DVec2| DVec3::new(p.y, 1.0, p.x);
    let space: Vec<DVec3> = ring.control_points().iter().map(in_space).collect();
    let space = Spline::new(&space, 2, true).expect("a spline");
    for k in 0..4 {
        assert_eq!(
            (kinds(&ring, k), kinds(&space, k)),
            ("G1 C1 G2".into(), "G1 C1 G2".into())
        );
    }
    // The osculating planes differ: the tangent is continuous, the curvature vector is not.
    let twisted = xyz("-2 1 0, -1 0 0, 0 0 0, 1 0 0, 2 0 1");
    let twisted = Spline::new(&twisted, 2, false).expect("a spline");
    assert_eq!(kinds(&twisted, 1), "G1 C1");
}

#[test]
fn set_joint_keeps_the_handle_before() {
    let cubics = joint("-3 1, -1 0, 0 0, 3 4, 5 5");
    // G1 keeps the length 5, C1 uses the length of the other handle.
    for (mode, handle) in [(Free, "3 4"), (G1, "5 0"), (C1, "1 0")] {
        let expected = joint(&format!("-3 1, -1 0, 0 0, {handle}, 5 5"));
        assert_eq!(cubics.set_joint(1, mode), Ok(expected), "{mode:?}");
    }
    // Degrees 3 and 2: 3(P₃ − P₂) = 2(P₄ − P₃).
    let mixed = |p4: &str| {
        let points = xy(&format!("-2 1, -1 2, -1 0, 0 0, {p4}, 2 0"));
        Spline::with_degrees(points, &[3, 2], false).expect("a spline")
    };
    assert_eq!(mixed("1 1").set_joint(1, C1), Ok(mixed("1.5 0")));
    assert!(continuity(&mixed("1.5 0"), 1, None).c1);
    // A handle of length 0 has no direction: the other handle is unchanged.
    let still = joint("-3 1, 0 0, 0 0, 3 4, 5 5");
    assert_eq!(still.set_joint(1, G1), Ok(still));
}

/// Two lines in one direction, a line and a curve: degrees do not matter, only derivatives.
#[test]
fn lines() {
    for (after, expected) in [
        ("1 0, 2 0", "G1 C1 G2 C2"),
        ("1 0, 4 0", "G1 G2"),
        ("1 0, 1.5 0, 2 1", "G1 C1"),
    ] {
        let spline = joined((bezier("0 0, 1 0"), bezier(after)));
        assert_eq!(kinds(&spline, 1), expected, "{after}");
    }
}
