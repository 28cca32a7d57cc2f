//! Moving points of splines: the joints hold, nothing else moves. joints.rs has the modes of second order.

use crate::spline::{index_of, is_finite, joints, moved, smooth};
use crate::support::{Rng, real, spline, xy};
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::JointMode::{self, C1, C2, Free, G1, G2};
use casteljau::{MAX_COORDINATE, Spline};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const MODES: [JointMode; 3] = [Free, G1, C1];

/// n(Pₙ − Pₙ₋₁) before a joint and m(P₁ − P₀) after it, from the points.
fn derivatives(spline: &Spline<DVec3>, joint: usize) -> (DVec3, DVec3) {
    let (p, degrees) = (spline.control_points(), spline.degrees());
    let (at, count) = (index_of(spline, joint), p.len());
    let before = degrees[(joint + degrees.len() - 1) % degrees.len()];
    let left = p[at] - p[(at + count - 1) % count];
    let right = p[(at + 1) % count] - p[at];
    (left * real(before), right * real(degrees[joint]))
}

fn holds(spline: &Spline<DVec3>, joint: usize, mode: JointMode) -> bool {
    let (left, right) = derivatives(spline, joint);
    let unit = DVec3::normalize_or_zero;
    match mode {
        Free => true,
        G1 => unit(left).distance(unit(right)) < 1e-9,
        _ => left.distance(right) < 1e-9,
    }
}

/// Moves every point of a spline in every mode and passes the resulting spline to `check`.
fn drag(
    degrees: &[usize],
    closed: bool,
    check: impl Fn(&Spline<DVec3>, &Spline<DVec3>, usize, JointMode),
) {
    let mut rng = Rng(61);
    for mode in MODES {
        let spline = smooth(&mut rng, degrees, closed, C1);
        let p = spline.control_points();
        for index in 0..p.len() {
            let moved = moved(&spline, index, p[index] + rng.point(3) * 0.5, mode);
            let kept = |i: usize| i == index || p[i] == moved.control_points()[i];
            let what = format!("{degrees:?} {index} {mode:?}");
            assert!(mode != Free || (0..p.len()).all(kept), "{what}");
            check(&spline, &moved, index, mode);
        }
    }
}

#[test]
fn all_joints_hold() {
    let structures: [(&[usize], bool); 13] = [
        (&[3; 12], false),
        (&[2; 12], false),
        (&[4, 3, 5, 3, 8], false),
        (&[3, 2, 3, 2, 2, 3], false),
        (&[2, 4, 2, 2, 6], false),
        (&[3, 1, 3], false),
        (&[2, 3, 1, 2, 1, 3], false),
        (&[3, 2, 1, 4], false),
        (&[3; 9], true),
        (&[3, 4, 5, 3], true),
        (&[3], true),
        (&[3, 3], true),
        (&[7, 2, 3, 2], true),
    ];
    for (degrees, closed) in structures {
        drag(degrees, closed, |before, after, index, mode| {
            // On open cubics only the neighbours of the joint move.
            let (p, q) = (before.control_points(), after.control_points());
            let beside = |i: usize| i.abs_diff(index) <= 2 || p[i] == q[i];
            let cubic = !closed && degrees.iter().all(|&degree| degree == 3);
            assert!(!cubic || (0..p.len()).all(beside), "moving {index}");
            for joint in joints(before) {
                let hold = holds(before, joint, C1) && holds(after, joint, mode);
                assert!(hold, "{degrees:?}: point {index}, joint {joint} {mode:?}");
            }
        });
    }
    // On a ring of lines no joint can hold.
    drag(&[1; 3], true, |_, after, _, _| assert!(is_finite(after)));
}

/// On a ring of quadratics each handle belongs to two joints: one joint, where the two fronts meet, may break.
#[test]
fn a_ring_of_quadratics_breaks_no_more_than_one_joint() {
    for count in [3, 4, 7, 12] {
        drag(&vec![2; count], true, |before, after, index, mode| {
            let lost = |&joint: &usize| holds(before, joint, mode) && !holds(after, joint, mode);
            let lost: Vec<usize> = joints(before).filter(lost).collect();
            // Far from the moved point.
            let away = |joint: &usize| {
                let along = (2 * joint + 2 * count - index) % (2 * count);
                along.min(2 * count - along) + 2 >= count
            };
            let few = lost.len() <= 1 && lost.iter().all(away);
            assert!(few, "{count}: point {index} {mode:?} loses {lost:?}");
        });
    }
}

/// P₃ is the joint of two cubics. In A the handle after it is twice as long as the one before it; in B it is C1; in C
/// the second points are on the same side.
const A: &str = "0 0, 0 2, 2 2, 2 0, 2 -4, 4 -2, 4 0";
const B: &str = "0 0, 0 2, 2 2, 2 0, 2 -2, 4 -2, 4 0";
const C: &str = "0 0, 0 2, 2 2, 2 0, 2 -2, -6 -2, 4 0";

/// C2 means P₄ = 2P₃ − P₂ and P₅ = P₁ + 4(P₃ − P₂). G2 means that the handles are aligned, and if P₁ and P₅ are on the
/// same side of the tangent, that their lengths are in the ratio of the square roots of the distances of P₁ and P₅.
#[test]
fn the_formulas_of_two_cubics() {
    let table = [
        // If a handle is moved, the other one follows, with its own length or with the length of the moved one.
        (A, 2, G1, "0 0, 0 2, 5 0, 2 0, -2 0, 4 -2, 4 0"),
        (A, 2, C1, "0 0, 0 2, 5 0, 2 0, -1 0, 4 -2, 4 0"),
        (A, 2, Free, "0 0, 0 2, 5 0, 2 0, 2 -4, 4 -2, 4 0"),
        (A, 4, G1, "0 0, 0 2, 0 0, 2 0, 5 0, 4 -2, 4 0"),
        (A, 4, C1, "0 0, 0 2, -1 0, 2 0, 5 0, 4 -2, 4 0"),
        // If the joint is moved, both handles follow; C1 makes their lengths equal.
        (A, 3, G1, "0 0, 0 2, 3 3, 3 1, 3 -3, 4 -2, 4 0"),
        (A, 3, C1, "0 0, 0 2, 3 3, 3 1, 3 -1, 4 -2, 4 0"),
        (A, 3, Free, "0 0, 0 2, 2 2, 3 1, 2 -4, 4 -2, 4 0"),
        // The other points do not affect the joint.
        (A, 0, C1, "9 9, 0 2, 2 2, 2 0, 2 -4, 4 -2, 4 0"),
        (A, 1, C1, "0 0, 9 9, 2 2, 2 0, 2 -4, 4 -2, 4 0"),
        (A, 5, C1, "0 0, 0 2, 2 2, 2 0, 2 -4, 9 9, 4 0"),
        (A, 6, C1, "0 0, 0 2, 2 2, 2 0, 2 -4, 4 -2, 9 9"),
        // A handle of length 0 does not turn the other one.
        (A, 2, G1, "0 0, 0 2, 2 0, 2 0, 2 -4, 4 -2, 4 0"),
        (A, 2, C1, "0 0, 0 2, 2 0, 2 0, 2 0, 4 -2, 4 0"),
        (B, 2, C2, "0 0, 0 2, 3 1, 2 0, 1 -1, -4 -2, 4 0"),
        (B, 4, C2, "0 0, 0 2, 1 1, 2 0, 3 -1, 4 -2, 4 0"),
        (B, 3, C2, "0 0, 0 2, 3 3, 3 1, 3 -1, 0 -6, 4 0"),
        // If a second point is moved, only the second point on the other side follows.
        (B, 1, C2, "0 0, 1 2, 2 2, 2 0, 2 -2, 1 -6, 4 0"),
        (B, 5, C2, "0 0, 4 5, 2 2, 2 0, 2 -2, 4 -3, 4 0"),
        (B, 0, C2, "9 9, 0 2, 2 2, 2 0, 2 -2, 4 -2, 4 0"),
        (B, 6, C2, "0 0, 0 2, 2 2, 2 0, 2 -2, 4 -2, 9 9"),
        (B, 2, G2, "0 0, 0 2, 2 3, 2 0, 2 -2, 4 -2, 4 0"),
        (C, 2, G2, "0 0, 0 2, 2 1, 2 0, 2 -2, -6 -2, 4 0"),
        (C, 1, G2, "0 0, -6 2, 2 2, 2 0, 2 -2, -6 -2, 4 0"),
        (C, 1, G2, "0 0, 0 7, 2 2, 2 0, 2 -4, -6 -2, 4 0"),
    ];
    for (points, index, mode, expected) in table {
        let to = xy(expected)[index];
        let moved = moved(&spline(points, 3, false), index, to, mode);
        let what = format!("{points}: {index} to {to}, {mode:?}");
        assert_eq!(moved.control_points(), xy(expected), "{what}");
    }
}

/// A huge move must not produce an infinity elsewhere.
#[test]
fn results_stay_finite() {
    let far = DVec2::new(MAX_COORDINATE, -MAX_COORDINATE);
    for (mode, index) in MODES
        .into_iter()
        .flat_map(|mode| (0..7).map(move |i| (mode, i)))
    {
        let moved = moved(&spline(A, 3, false), index, far, mode);
        assert_eq!(moved.control_points()[index], far);
        let bounded = |p: &DVec2| p.abs().max_element() <= 1.0001 * MAX_COORDINATE;
        let bounded = moved.control_points().iter().all(bounded);
        assert!(bounded, "{mode:?} {index}");
    }
}

/// If both neighbours of a joint coincide, no mode can hold; the joint stays where it is.
#[test]
fn rings_too_small_to_hold_anything() {
    for (points, degree) in [("0 0", 1), ("0 0, 1 2", 1), ("0 0, 1 2", 2)] {
        for mode in MODES {
            let to = DVec2::new(3.0, 0.0);
            let moved = moved(&spline(points, degree, true), 0, to, mode);
            let [joint, others @ ..] = moved.control_points() else {
                panic!()
            };
            assert_eq!(*joint, to);
            let kept = |p: &DVec2| xy("1 2, 4 2").contains(p);
            assert!(others.iter().all(kept), "{mode:?}: {others:?}");
        }
    }
}
