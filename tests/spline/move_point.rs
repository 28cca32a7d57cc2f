//! Moving points of splines: the point is where it was moved, the joints hold, nothing else moves.

use crate::spline::plane;
use crate::support::{Rng, real};
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::JointMode;
use casteljau::{Error, MAX_COORDINATE, Spline};
use wasm_bindgen_test::wasm_bindgen_test;

const MODES: [JointMode; 3] = [JointMode::Free, JointMode::G1, JointMode::C1];

/// The joints of a spline.
fn joints(spline: &Spline<DVec3>) -> Vec<usize> {
    (usize::from(!spline.is_closed())..spline.segment_count()).collect()
}

/// The index of the point of a joint.
fn index_of(spline: &Spline<DVec3>, joint: usize) -> usize {
    spline.degrees()[..joint].iter().sum()
}

/// A spline whose joints all hold C1 (if closed: all except the first, unless its last segment has handles of its own).
fn smooth(rng: &mut Rng, degrees: &[usize], closed: bool) -> Spline<DVec3> {
    let mut spline = crate::spline::random(rng, degrees, closed);
    for joint in (1..degrees.len()).chain(closed.then_some(0)) {
        spline = spline.set_joint(joint, JointMode::C1).expect("a joint");
    }
    spline
}

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
    match mode {
        JointMode::Free => true,
        JointMode::G1 => left.normalize_or_zero().distance(right.normalize_or_zero()) < 1e-9,
        JointMode::C1 => left.distance(right) < 1e-9,
        _ => unreachable!("joints.rs has the other modes"),
    }
}

/// Moves every point of a spline and passes the resulting spline to `check`.
fn drag(
    degrees: &[usize],
    closed: bool,
    mut check: impl FnMut(&Spline<DVec3>, &Spline<DVec3>, usize, JointMode),
) {
    let mut rng = Rng(61);
    for mode in MODES {
        let spline = smooth(&mut rng, degrees, closed);
        for index in 0..spline.control_points().len() {
            let to = spline.control_points()[index] + rng.point(3) * 0.5;
            let moved = spline.move_point(index, to, |_| mode).expect("a point");
            assert_eq!(
                moved.control_points()[index],
                to,
                "{degrees:?} {index} {mode:?}"
            );
            assert_eq!(
                (moved.degrees(), moved.is_closed()),
                (degrees.to_vec(), closed)
            );
            assert!(moved.control_points().iter().all(|p| p.is_finite()));
            check(&spline, &moved, index, mode);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn all_joints_of_open_splines_hold() {
    let structures: [&[usize]; 7] = [
        &[3; 12],
        &[2; 12],
        &[4, 3, 5, 3, 8],
        &[3, 2, 3, 2, 2, 3],
        &[2, 4, 2, 2, 6],
        &[3, 1, 3],
        &[2, 3, 1, 2, 1, 3],
    ];
    for degrees in structures {
        drag(degrees, false, |before, after, index, mode| {
            for joint in joints(before) {
                assert!(
                    holds(before, joint, JointMode::C1) && holds(after, joint, mode),
                    "{degrees:?}: point {index}, joint {joint} {mode:?}"
                );
            }
        });
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn all_joints_of_closed_splines_with_free_handles_hold() {
    let structures: [&[usize]; 5] = [&[3; 9], &[3, 4, 5, 3], &[3], &[3, 3], &[7, 2, 3, 2]];
    for degrees in structures {
        drag(degrees, true, |before, after, index, mode| {
            for joint in joints(before) {
                assert!(
                    holds(before, joint, JointMode::C1) && holds(after, joint, mode),
                    "{degrees:?}: point {index}, joint {joint} {mode:?}"
                );
            }
        });
    }
}

/// On a ring of quadratics each handle belongs to two joints: one joint, where the two fronts meet, may break.
#[wasm_bindgen_test(unsupported = test)]
fn a_ring_of_quadratics_breaks_no_more_than_one_joint() {
    for count in [3, 4, 7, 12] {
        drag(&vec![2; count], true, |before, after, index, mode| {
            let lost = |&joint: &usize| holds(before, joint, mode) && !holds(after, joint, mode);
            let lost: Vec<usize> = joints(before).into_iter().filter(lost).collect();
            assert!(
                lost.len() <= 1,
                "{count}: point {index} {mode:?} loses {lost:?}"
            );
            // Far from the moved point.
            let away = |joint: usize| {
                let along = (2 * joint + 2 * count - index) % (2 * count);
                along.min(2 * count - along)
            };
            assert!(
                lost.iter().all(|&joint| away(joint) + 2 >= count),
                "{count}: point {index} loses {lost:?}"
            );
        });
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn free_joints_move_nothing_else() {
    for (degrees, closed) in [
        (&[3, 2, 1, 4][..], false),
        (&[2, 2, 2], true),
        (&[1, 1, 1], true),
    ] {
        drag(degrees, closed, |before, after, index, mode| {
            let kept = |i: usize| before.control_points()[i] == after.control_points()[i];
            let count = before.control_points().len();
            assert!(
                mode != JointMode::Free || (0..count).all(|i| i == index || kept(i)),
                "{degrees:?}"
            );
        });
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn on_cubics_only_the_neighbours_of_the_joint_move() {
    drag(&[3; 8], false, |before, after, index, _| {
        let changed = |i: usize| before.control_points()[i] != after.control_points()[i];
        for i in (0..before.control_points().len()).filter(|&i| changed(i)) {
            assert!(i.abs_diff(index) <= 2, "moving {index} moved {i}");
        }
    });
}

/// The tutorial's seven points; P₃ is the joint.
fn seven() -> Spline<DVec2> {
    plane(
        &[
            (0.0, 0.0),
            (0.0, 2.0),
            (2.0, 2.0),
            (2.0, 0.0),
            (2.0, -4.0),
            (4.0, -2.0),
            (4.0, 0.0),
        ],
        3,
        false,
    )
}

fn moved(index: usize, to: (f64, f64), mode: JointMode) -> Vec<DVec2> {
    let moved = seven()
        .move_point(index, DVec2::new(to.0, to.1), |_| mode)
        .expect("a point");
    moved.control_points().to_vec()
}

#[wasm_bindgen_test(unsupported = test)]
fn the_joint_of_the_applet() {
    let at = DVec2::new;
    // If a handle is moved, the other one follows, with its own length (G1, 4) or with the length of the moved one (C1,
    // 3).
    assert_eq!(moved(2, (5.0, 0.0), JointMode::G1)[4], at(-2.0, 0.0));
    assert_eq!(moved(2, (5.0, 0.0), JointMode::C1)[4], at(-1.0, 0.0));
    assert_eq!(moved(2, (5.0, 0.0), JointMode::Free)[4], at(2.0, -4.0));
    assert_eq!(moved(4, (5.0, 0.0), JointMode::G1)[2], at(0.0, 0.0));
    assert_eq!(moved(4, (5.0, 0.0), JointMode::C1)[2], at(-1.0, 0.0));
    // If the joint is moved, both handles follow; C1 makes their lengths equal.
    let [g1, c1, free] =
        [JointMode::G1, JointMode::C1, JointMode::Free].map(|mode| moved(3, (3.0, 1.0), mode));
    assert_eq!(g1[2..5], [at(3.0, 3.0), at(3.0, 1.0), at(3.0, -3.0)]);
    assert_eq!(c1[2..5], [at(3.0, 3.0), at(3.0, 1.0), at(3.0, -1.0)]);
    assert_eq!(free[2..5], [at(2.0, 2.0), at(3.0, 1.0), at(2.0, -4.0)]);
    // The other points do not affect the joint.
    for index in [0, 1, 5, 6] {
        assert_eq!(
            moved(index, (9.0, 9.0), JointMode::C1)[2..5],
            seven().control_points()[2..5]
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_handle_of_length_zero_does_not_move_the_other() {
    assert_eq!(
        moved(2, (2.0, 0.0), JointMode::G1)[4],
        DVec2::new(2.0, -4.0)
    );
    assert_eq!(moved(2, (2.0, 0.0), JointMode::C1)[4], DVec2::new(2.0, 0.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn modes_differ_by_joint() {
    let spline = smooth(&mut Rng(62), &[3, 3, 3], false);
    let p = spline.control_points();
    let mode = |k: usize| {
        if k == 1 {
            JointMode::C1
        } else {
            JointMode::Free
        }
    };
    let first = spline.move_point(2, DVec3::ONE, mode).expect("a point");
    assert!(holds(&first, 1, JointMode::C1));
    let second = spline.move_point(5, DVec3::ONE, mode).expect("a point");
    assert_eq!(second.control_points()[7], p[7]);
}

/// A huge move must not produce an infinity elsewhere.
#[wasm_bindgen_test(unsupported = test)]
fn results_stay_finite() {
    let far = DVec2::new(MAX_COORDINATE, -MAX_COORDINATE);
    for mode in MODES {
        for index in 0..7 {
            let moved = seven().move_point(index, far, |_| mode).expect("a point");
            assert_eq!(moved.control_points()[index], far);
            assert!(
                moved
                    .control_points()
                    .iter()
                    .all(|p| p.abs().max_element() <= 1.0001 * MAX_COORDINATE),
                "{mode:?} {index}"
            );
        }
    }
}

/// If both neighbours of a joint coincide, no mode can hold; the joint stays where it is.
#[wasm_bindgen_test(unsupported = test)]
fn rings_too_small_to_hold_anything() {
    for (points, degree) in [
        (&[(0.0, 0.0)][..], 1),
        (&[(0.0, 0.0), (1.0, 2.0)], 1),
        (&[(0.0, 0.0), (1.0, 2.0)], 2),
    ] {
        let ring = plane(points, degree, true);
        for mode in MODES {
            let moved = ring
                .move_point(0, DVec2::new(3.0, 0.0), |_| mode)
                .expect("a point");
            assert_eq!(moved.control_points()[0], DVec2::new(3.0, 0.0));
            let other = moved.control_points().get(1);
            let kept = [DVec2::new(1.0, 2.0), DVec2::new(4.0, 2.0)];
            assert!(
                other.is_none_or(|p| kept.contains(p)),
                "{mode:?}: {other:?}"
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refusals() {
    let spline = seven();
    for got in [7, usize::MAX] {
        let refused = spline.move_point(got, DVec2::ONE, |_| JointMode::G1);
        assert_eq!(
            refused,
            Err(Error::Index {
                what: "index",
                first: 0,
                last: 6,
                got
            })
        );
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = spline.move_point(1, DVec2::new(bad, 0.0), |_| JointMode::G1);
        assert!(matches!(refused, Err(Error::NotFinite { what: "to", .. })));
    }
}
