//! Joint modes of second order and automatic handles on random splines: the point is where it was moved, and the joints
//! that can follow hold.

use crate::spline::plane;
use crate::support::{Rng, Space, largest, real};
use casteljau::glam::{DAffine3, DMat3, DVec2, DVec3};
use casteljau::spline::JointMode::{self, Auto, C1, C2, Free, G1, G2};
use casteljau::{Error, Point, Spline};
use wasm_bindgen_test::wasm_bindgen_test;

const ALL: [JointMode; 6] = [Free, G1, C1, C2, G2, Auto];

fn cases() -> usize {
    crate::support::cases(20_000, 1_000_000)
}

/// A random spline, often with coincident and collinear points.
fn chain<P: Space>(rng: &mut Rng, degrees: &[usize], closed: bool) -> Spline<P> {
    let count = degrees.iter().sum::<usize>() + usize::from(!closed);
    let mut points: Vec<P> = (0..count).map(|_| P::of(rng.point(P::DIMENSION))).collect();
    for i in 1..count {
        match rng.below(12) {
            0 => points[i] = points[i - 1],
            1 if i > 1 => points[i] = points[i - 1] * 2.0 - points[i - 2],
            _ => {}
        }
    }
    Spline::with_degrees(points, degrees, closed).expect("a spline")
}

fn some_degrees(rng: &mut Rng, cubic: bool) -> Vec<usize> {
    let count = 1 + rng.below(6);
    (0..count)
        .map(|_| {
            if cubic {
                3
            } else {
                rng.pick(&[1, 2, 3, 3, 3, 4, 5])
            }
        })
        .collect()
}

fn joints<P: Point>(spline: &Spline<P>) -> std::ops::Range<usize> {
    usize::from(!spline.is_closed())..spline.segment_count()
}

fn index_of<P: Point>(spline: &Spline<P>, joint: usize) -> usize {
    spline.degrees()[..joint].iter().sum()
}

/// The k-th point from a joint; before the joint for negative k.
fn around<P: Point>(spline: &Spline<P>, joint: usize, k: isize) -> P {
    let p = spline.control_points();
    let at = (index_of(spline, joint) + 2 * p.len()).wrapping_add_signed(k);
    p[at % p.len()]
}

fn cubic_beside<P: Point>(spline: &Spline<P>, joint: usize) -> bool {
    let degrees = spline.degrees();
    degrees[(joint + degrees.len() - 1) % degrees.len()] > 2 && degrees[joint] > 2
}

/// Every mode on every joint, in the plane and in space: the moved point is where it was moved, all points stay finite,
/// and a move by zero changes nothing.
fn adversarial<P: Space>(seed: u64, modes: &[JointMode]) {
    let mut rng = Rng(seed);
    for case in 0..cases() {
        let degrees = some_degrees(&mut rng, false);
        let closed = rng.chance(0.5) && degrees.iter().sum::<usize>() > 0;
        let mut spline = chain::<P>(&mut rng, &degrees, closed);
        let scale = rng.pick(&[1.0, 1.0, 1e-300, 1e149, 1e9]);
        spline = Spline::with_degrees(
            spline.control_points().iter().map(|&p| p * scale).collect(),
            &degrees,
            closed,
        )
        .expect("finite");
        let chosen: Vec<JointMode> = degrees.iter().map(|_| rng.pick(modes)).collect();
        let index = rng.below(spline.control_points().len());
        let to = match rng.below(4) {
            0 => rng.pick(spline.control_points()),
            _ => P::of(rng.point(P::DIMENSION)) * scale,
        };
        let moved = spline.move_point(index, to, |k| chosen[k]).expect("a move");
        assert_eq!(moved.control_points()[index], to, "case {case}");
        assert_eq!((moved.degrees(), moved.is_closed()), (degrees, closed));
        assert!(
            moved
                .control_points()
                .iter()
                .all(|p| p.max_abs().is_finite()),
            "case {case}"
        );
        let again = moved.move_point(index, to, |k| chosen[k]).expect("a move");
        assert_eq!(again, moved, "case {case}: nothing was to be done");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn any_spline_in_the_plane() {
    adversarial::<DVec2>(71, &ALL);
}

#[wasm_bindgen_test(unsupported = test)]
fn any_spline_in_space() {
    adversarial::<DVec3>(72, &[Free, G1, C1, C2, Auto]);
}

/// Makes all joints hold, one after the other; for modes of second order the spline must be open.
fn smooth<P: Space>(rng: &mut Rng, degrees: &[usize], closed: bool, mode: JointMode) -> Spline<P> {
    let count = degrees.iter().sum::<usize>() + usize::from(!closed);
    let points = (0..count).map(|_| P::of(rng.point(P::DIMENSION))).collect();
    let mut spline = Spline::with_degrees(points, degrees, closed).expect("a spline");
    for joint in joints(&spline) {
        spline = spline.set_joint(joint, mode).expect("a joint");
    }
    spline
}

/// C2 on open splines: whatever is moved, every joint holds, and the formula is the documented one.
#[wasm_bindgen_test(unsupported = test)]
fn equal_second_derivatives_are_passed_on() {
    let mut rng = Rng(73);
    let structures: [&[usize]; 5] = [&[3; 2], &[3; 6], &[4, 3, 5], &[3, 6, 3, 4], &[5; 3]];
    for round in 0..40 {
        let degrees = structures[round % 5];
        let spline = smooth::<DVec3>(&mut rng, degrees, false, C2);
        for index in 0..spline.control_points().len() {
            let to = spline.control_points()[index] + rng.point(3);
            let moved = spline.move_point(index, to, |_| C2).expect("a point");
            let size = largest(moved.control_points());
            for joint in joints(&spline) {
                let c = moved
                    .continuity(joint, Some(1e-11 * size))
                    .expect("a joint");
                assert!(c.c2, "{degrees:?}: point {index}, joint {joint}: {c:?}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_formulas_of_two_cubics() {
    let points = [
        (0.0, 0.0),
        (0.0, 2.0),
        (2.0, 2.0),
        (2.0, 0.0),
        (2.0, -2.0),
        (4.0, -2.0),
        (4.0, 0.0),
    ];
    let spline = plane(&points, 3, false);
    let at = DVec2::new;
    let moved = |index: usize, to: DVec2, mode| {
        let moved = spline.move_point(index, to, |_| mode).expect("a point");
        moved.control_points().to_vec()
    };
    // P₄ = 2P₃ − P₂ and P₅ = P₁ + 4(P₃ − P₂), from either side.
    let p = moved(2, at(3.0, 1.0), C2);
    assert_eq!((p[4], p[5]), (at(1.0, -1.0), at(-4.0, -2.0)));
    assert_eq!(
        (p[0], p[1], p[6]),
        (at(0.0, 0.0), at(0.0, 2.0), at(4.0, 0.0))
    );
    let p = moved(4, at(3.0, -1.0), C2);
    assert_eq!((p[2], p[1]), (at(1.0, 1.0), at(0.0, 2.0)));
    // If the second point is moved, only the second point on the other side follows.
    let p = moved(1, at(1.0, 2.0), C2);
    assert_eq!((p[4], p[5]), (at(2.0, -2.0), at(1.0, -6.0)));
    assert_eq!(moved(5, at(4.0, -3.0), C2)[1], at(4.0, 5.0));
    // Moving an end point changes nothing else.
    for index in [0, 6] {
        assert_eq!(
            moved(index, at(9.0, 9.0), C2)[1..6],
            spline.control_points()[1..6]
        );
    }
    // If the joint is moved, both handles follow, and P₅ becomes P₁ + 4(P₃ − P₂).
    let p = moved(3, at(3.0, 1.0), C2);
    assert_eq!(
        p[2..6],
        [at(3.0, 3.0), at(3.0, 1.0), at(3.0, -1.0), at(0.0, -6.0)]
    );

    // G2: P₁ is 2 from the tangent x = 2, and so is P₅, but on the other side: the handles are only aligned.
    assert_eq!(moved(2, at(2.0, 3.0), G2)[4], at(2.0, -2.0));
    // Both on one side: lengths in the ratio of the square roots of the distances, √(8/2) · 1.
    let same = spline
        .move_point(5, at(-6.0, -2.0), |_| Free)
        .expect("a point");
    let curved = same.move_point(2, at(2.0, 1.0), |_| G2).expect("a point");
    assert_eq!(curved.control_points()[4], at(2.0, -2.0));
    assert!(curved.continuity(1, None).expect("a joint").g2);
    // The second point is moved: its distance determines the handle.
    let curved = same.move_point(1, at(-6.0, 2.0), |_| G2).expect("a point");
    assert_eq!(curved.control_points()[4], at(2.0, -2.0));
    let curved = same.move_point(1, at(0.0, 7.0), |_| G2).expect("a point");
    assert_eq!(curved.control_points()[4], at(2.0, -4.0));
}

/// G2 on open splines holds where the second points lie on the same side; the handles are aligned in any case.
#[wasm_bindgen_test(unsupported = test)]
fn equal_curvatures() {
    let mut rng = Rng(74);
    let (mut held, mut not) = (0, 0);
    for _ in 0..cases() / 10 {
        let degrees: Vec<usize> = (0..3).map(|_| rng.pick(&[3, 3, 4, 5])).collect();
        let spline = smooth::<DVec2>(&mut rng, &degrees, false, G1);
        let index = rng.below(spline.control_points().len());
        let to = DVec2::of(rng.point(2));
        let moved = spline.move_point(index, to, |_| G2).expect("a point");
        // The first joint on either side is repaired if one of the four points before it was moved.
        for joint in joints(&spline) {
            let away = index_of(&spline, joint).abs_diff(index);
            if away > 2 {
                continue;
            }
            let c = moved.continuity(joint, Some(1e-9)).expect("a joint");
            assert!(c.g1, "{degrees:?} {index} {joint}");
            let tangent = around(&moved, joint, 1) - around(&moved, joint, 0);
            let side = |k| tangent.perp_dot(around(&moved, joint, k) - around(&moved, joint, 0));
            if side(-2) * side(2) > 1e-6 {
                let [left, right] =
                    [joint - 1, joint].map(|k| moved.segment(k).expect("a segment"));
                let (a, b) = (left.curvature(1.0), right.curvature(0.0));
                assert!(
                    (a - b).abs() <= 1e-6 * a.abs().max(b.abs()),
                    "{degrees:?} {index} {joint}: {a} {b}"
                );
                held += 1;
            } else {
                not += 1;
            }
        }
    }
    assert!(held > 100 && not > 100, "{held} {not}");
}

/// Handles by the textbook formula, from the points of three joints.
fn tangent<P: Point>(a: P, b: P, c: P) -> (P, f64, f64) {
    let (d1, d2) = ((b - a).length().sqrt(), (c - b).length().sqrt());
    let t = (b - a) / d1 - (c - a) / (d1 + d2) + (c - b) / d2;
    (t, d1, d2)
}

fn automatic<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for round in 0..400 {
        let closed = round % 2 == 0;
        let degrees: Vec<usize> = (0..2 + rng.below(4))
            .map(|_| rng.pick(&[3, 3, 4, 5]))
            .collect();
        let mut spline = chain::<P>(&mut rng, &[3; 1], false);
        while spline.segment_count() < 2 {
            spline = smooth(&mut rng, &degrees, closed, Auto);
        }
        let moved_joint = rng.below(degrees.len());
        let index = index_of(&spline, moved_joint);
        let to = P::of(rng.point(P::DIMENSION));
        let moved = spline.move_point(index, to, |_| Auto).expect("a joint");
        let anchor = |k: usize| {
            let p = moved.control_points();
            let starts: usize = degrees[..k.min(degrees.len())].iter().sum();
            p[starts % p.len().max(starts + usize::from(!closed))]
        };
        let n = degrees.len();
        for joint in joints(&moved) {
            let (left, right) = ((joint + n - 1) % n, joint);
            let next = if closed { (joint + 1) % n } else { joint + 1 };
            let (t, d1, d2) = tangent(anchor(left), anchor(joint), anchor(next));
            let ahead = anchor(joint) + t * (d2 / real(degrees[right]));
            let behind = anchor(joint) - t * (d1 / real(degrees[left]));
            let off = (around(&moved, joint, 1) - ahead)
                .length()
                .max((around(&moved, joint, -1) - behind).length());
            assert!(
                off < 1e-12,
                "{degrees:?} {closed}: {moved_joint} moved, {joint}: {off}"
            );
        }
        if !closed && moved_joint <= 1 {
            // One-sided at a free end.
            let p = moved.control_points();
            let third = p[0] + (anchor(1) - p[0]) / real(degrees[0]);
            assert!((p[1] - third).length() < 1e-15);
        }
        // Nothing else moves.
        for (i, (a, b)) in spline
            .control_points()
            .iter()
            .zip(moved.control_points())
            .enumerate()
        {
            let near = degrees
                .iter()
                .scan(0, |at, d| Some(std::mem::replace(at, *at + d)))
                .chain([p_last(&spline)]);
            let beside = near.into_iter().any(|anchor| {
                i.abs_diff(anchor) <= 1 || (closed && i + 1 == spline.control_points().len())
            });
            assert!(a == b || beside, "{degrees:?}: {i}");
        }
    }
}

fn p_last<P: Point>(spline: &Spline<P>) -> usize {
    spline.control_points().len() - usize::from(!spline.is_closed())
}

#[wasm_bindgen_test(unsupported = test)]
fn automatic_handles_follow_their_neighbours() {
    automatic::<DVec2>(75);
    automatic::<DVec3>(76);
}

/// A handle of an automatic joint that is moved explicitly keeps its position; so does a handle at an end.
#[wasm_bindgen_test(unsupported = test)]
fn automatic_handles_obey_the_hand() {
    let spline = smooth::<DVec2>(&mut Rng(77), &[3; 3], false, Auto);
    for index in [1, 2, 4, 5, 7, 8] {
        let to = DVec2::new(5.0, 7.0);
        let moved = spline.move_point(index, to, |_| Auto).expect("a point");
        let changed: Vec<usize> = (0..10)
            .filter(|&i| moved.control_points()[i] != spline.control_points()[i])
            .collect();
        assert_eq!(changed, [index]);
    }
}

/// Modes may differ from joint to joint: a free joint stops the propagation.
#[wasm_bindgen_test(unsupported = test)]
fn free_joints_stop_the_fronts() {
    let spline = smooth::<DVec2>(&mut Rng(78), &[3; 6], false, C2);
    let mode = |k: usize| if k == 3 { Free } else { C2 };
    let moved = spline.move_point(2, DVec2::ZERO, mode).expect("a point");
    assert!(moved.continuity(2, None).expect("a joint").c2);
    assert!(!moved.continuity(3, None).expect("a joint").g1);
    assert_eq!(moved.control_points()[9..], spline.control_points()[9..]);
    // G1 propagates only the direction: the next joint is unchanged.
    let moved = spline.move_point(2, DVec2::ZERO, |_| G1).expect("a point");
    assert_eq!(moved.control_points()[5..], spline.control_points()[5..]);
}

/// On a ring each point is set only once: where the two fronts meet one joint may break, and no other.
#[wasm_bindgen_test(unsupported = test)]
fn rings_break_at_one_joint() {
    let mut rng = Rng(79);
    for count in [2, 3, 4, 5, 6, 9] {
        // A ring that is C2 everywhere: a uniform B-spline.
        let d: Vec<DVec2> = (0..count).map(|_| DVec2::of(rng.point(2))).collect();
        let mut points = Vec::new();
        for k in 0..count {
            let [a, b, c] = [k, k + 1, k + 2].map(|i| d[i % count]);
            points.extend([
                (a + b * 4.0 + c) / 6.0,
                (b * 2.0 + c) / 3.0,
                (b + c * 2.0) / 3.0,
            ]);
        }
        let ring = Spline::new(&points, 3, true).expect("a ring");
        let holds = |s: &Spline<DVec2>, k: usize| {
            s.continuity(k, Some(1e-11 * largest(s.control_points())))
                .expect("a joint")
                .c2
        };
        assert!((0..count).all(|k| holds(&ring, k)));
        for index in 0..points.len() {
            let to = points[index] + DVec2::of(rng.point(2));
            let moved = ring.move_point(index, to, |_| C2).expect("a point");
            let lost: Vec<usize> = (0..count).filter(|&k| !holds(&moved, k)).collect();
            let away = |k: &usize| {
                let along = (3 * k + points.len() - index) % points.len();
                along.min(points.len() - along)
            };
            // The fronts meet at the last joint of a ring of n joints, or at the last two that share a segment.
            assert!(lost.len() <= 2, "{count}: {index} loses {lost:?}");
            assert!(
                lost.iter().all(|k| away(k) + 5 >= points.len() / 2),
                "{count}: {index} loses {lost:?}"
            );
        }
    }
}

/// The growth along a long spline ends where numbers would overflow.
#[wasm_bindgen_test(unsupported = test)]
fn long_splines_stay_finite() {
    let points: Vec<DVec2> = (0..=9000)
        .map(|i| DVec2::new(real(i), real(i % 3)))
        .collect();
    for closed in [false, true] {
        let points = &points[..points.len() - usize::from(closed)];
        let spline = Spline::new(points, 3, closed).expect("a chain");
        for mode in ALL {
            for index in [0, 1, 4500, 4501, 8999] {
                let to = DVec2::new(1.0, -7.0);
                let moved = spline.move_point(index, to, |_| mode).expect("a point");
                assert_eq!(moved.control_points()[index], to);
                assert!(moved.control_points().iter().all(|p| p.is_finite()));
            }
        }
    }
}

/// Moving points of the reversed spline gives the mirrored result, and space behaves as the plane.
#[wasm_bindgen_test(unsupported = test)]
fn reversed_and_turned() {
    let mut rng = Rng(80);
    for round in 0..600 {
        let degrees = some_degrees(&mut rng, round % 2 == 0);
        let spline = chain::<DVec3>(&mut rng, &degrees, false);
        let modes: Vec<JointMode> = degrees
            .iter()
            .map(|_| rng.pick(&[Free, G1, C1, C2, Auto]))
            .collect();
        let n = degrees.len();
        let index = rng.below(spline.control_points().len());
        let dragged = joints(&spline).any(|k| index_of(&spline, k) == index && modes[k] != Auto);
        let to = rng.point(3);
        let moved = spline.move_point(index, to, |k| modes[k]).expect("a point");
        let size = largest(moved.control_points()) + largest(spline.control_points());
        let turn = DAffine3::from_mat3(DMat3::from_rotation_x(0.7) * DMat3::from_rotation_z(2.0));
        let turned = spline.transform(&turn).expect("a finite image").move_point(
            index,
            turn.transform_point3(to),
            |k| modes[k],
        );
        // Points that coincide before a rotation may not coincide after it.
        let apart = spline
            .control_points()
            .windows(2)
            .all(|p| p[0] == p[1] || p[0].distance(p[1]) > 1e-3);
        if apart {
            assert!(
                turned.expect("a point").approx_eq(
                    &moved.transform(&turn).expect("a finite image"),
                    1e-9 * size
                ),
                "{degrees:?} {modes:?} {index}"
            );
        }
        if !dragged {
            let last = spline.control_points().len() - 1;
            let back = spline
                .reverse()
                .move_point(last - index, to, |k| modes[n - k])
                .expect("a point");
            assert!(
                back.reverse().approx_eq(&moved, 1e-9 * size),
                "{degrees:?} {modes:?} {index}"
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn setting_a_joint_keeps_the_handle_before_it() {
    let mut rng = Rng(81);
    for _ in 0..2000 {
        let degrees = some_degrees(&mut rng, false);
        let closed = rng.chance(0.4);
        let spline = chain::<DVec2>(&mut rng, &degrees, closed);
        for joint in joints(&spline) {
            for mode in ALL {
                let set = spline.set_joint(joint, mode).expect("a joint");
                let index = index_of(&spline, joint);
                let count = spline.control_points().len();
                let before = (index + count - 1) % count;
                let (p, q) = (spline.control_points(), set.control_points());
                assert!(mode == Auto || p[before] == q[before]);
                assert_eq!(p[index], q[index]);
                let c = set.continuity(joint, Some(1e-9)).expect("a joint");
                if mode == C2 && cubic_beside(&spline, joint) && count > 4 {
                    assert!(c.c2, "{degrees:?} {joint}");
                } else if (mode == C1 || mode == C2) && count > 2 {
                    assert!(c.c1, "{degrees:?} {closed} {joint} {mode:?}");
                }
                let again = set.set_joint(joint, mode).expect("a joint");
                assert!(again.approx_eq(&set, 1e-12), "{degrees:?} {joint} {mode:?}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn equal_curvature_is_of_the_plane() {
    let spline = smooth::<DVec3>(&mut Rng(82), &[3; 3], false, C1);
    let refused = Error::Range {
        what: "mode",
        expected: "a spline of dimension 2 for G2",
        got: 3.0,
    };
    assert_eq!(spline.set_joint(1, G2), Err(refused));
    let one = |k: usize| if k == 2 { G2 } else { Free };
    assert_eq!(spline.move_point(0, DVec3::ONE, one), Err(refused));
}
