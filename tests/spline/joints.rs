//! Joint modes of second order and automatic handles on random splines: the point is where it was moved, and the joints
//! that can follow hold.

use crate::spline::{continuity, count, index_of, is_finite, joints, moved, smooth};
use crate::support::{Rng, Space, changed, largest, near_at, random_points, real};
use casteljau::glam::{DAffine3, DMat3, DVec2, DVec3};
use casteljau::spline::JointMode::{self, Auto, C1, C2, Free, G1, G2};
use casteljau::{Error, Point, Spline};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const ALL: [JointMode; 6] = [Free, G1, C1, C2, G2, Auto];

fn cases() -> usize {
    crate::support::cases(20_000, 1_000_000)
}

/// A random spline, often with coincident and collinear points.
fn chain<P: Space>(rng: &mut Rng, degrees: &[usize], closed: bool, scale: f64) -> Spline<P> {
    let mut points: Vec<P> = random_points(rng, count(degrees, closed));
    for i in 1..points.len() {
        match rng.below(12) {
            0 => points[i] = points[i - 1],
            1 if i > 1 => points[i] = points[i - 1] * 2.0 - points[i - 2],
            _ => {}
        }
    }
    points.iter_mut().for_each(|p| *p = *p * scale);
    Spline::with_degrees(points, degrees, closed).expect("a spline")
}

fn some_degrees(rng: &mut Rng, cubic: bool) -> Vec<usize> {
    let choice: &[usize] = if cubic { &[3] } else { &[1, 2, 3, 3, 3, 4, 5] };
    (0..1 + rng.below(6)).map(|_| rng.pick(choice)).collect()
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
        let closed = rng.chance(0.5);
        let scale = rng.pick(&[1.0, 1.0, 1e-300, 1e149, 1e9]);
        let spline = chain::<P>(&mut rng, &degrees, closed, scale);
        let chosen: Vec<JointMode> = degrees.iter().map(|_| rng.pick(modes)).collect();
        let index = rng.below(spline.control_points().len());
        let to = match rng.below(4) {
            0 => rng.pick(spline.control_points()),
            _ => P::of(rng.point(P::DIMENSION)) * scale,
        };
        let mut moved = spline.clone();
        moved.move_point(index, to, |k| chosen[k]).expect("a move");
        assert_eq!(moved.control_points()[index], to, "case {case}");
        assert_eq!((moved.degrees(), moved.is_closed()), (degrees, closed));
        assert!(is_finite(&moved), "case {case}");
        let mut again = moved.clone();
        again.move_point(index, to, |k| chosen[k]).expect("a move");
        assert_eq!(again, moved, "case {case}: nothing was to be done");
    }
}

#[test]
fn any_spline_in_the_plane() {
    adversarial::<DVec2>(71, &ALL);
}

#[test]
fn any_spline_in_space() {
    adversarial::<DVec3>(72, &[Free, G1, C1, C2, Auto]);
}

/// C2 on open splines: whatever is moved, every joint holds, and the formula is the documented one.
#[test]
fn equal_second_derivatives_are_passed_on() {
    let mut rng = Rng(73);
    let structures: [&[usize]; 5] = [&[3; 2], &[3; 6], &[4, 3, 5], &[3, 6, 3, 4], &[5; 3]];
    for round in 0..40 {
        let degrees = structures[round % 5];
        let spline = smooth::<DVec3>(&mut rng, degrees, false, C2);
        for (index, &p) in spline.control_points().iter().enumerate() {
            let moved = moved(&spline, index, p + rng.point(3), C2);
            let tolerance = Some(1e-11 * largest(moved.control_points()));
            for joint in joints(&spline) {
                let c = continuity(&moved, joint, tolerance);
                assert!(c.c2, "{degrees:?}: point {index}, joint {joint}: {c:?}");
            }
        }
    }
}

/// G2 on open splines holds where the second points lie on the same side; the handles are aligned in any case.
#[test]
fn equal_curvatures() {
    let mut rng = Rng(74);
    let (mut held, mut not) = (0, 0);
    for _ in 0..cases() / 10 {
        let degrees: Vec<usize> = (0..3).map(|_| rng.pick(&[3, 3, 4, 5])).collect();
        let spline = smooth::<DVec2>(&mut rng, &degrees, false, G1);
        let index = rng.below(spline.control_points().len());
        let moved = moved(&spline, index, DVec2::of(rng.point(2)), G2);
        // The first joint on either side is repaired if one of the four points before it was moved.
        for joint in joints(&spline).filter(|&k| index_of(&spline, k).abs_diff(index) <= 2) {
            let what = format!("{degrees:?} {index} {joint}");
            assert!(continuity(&moved, joint, Some(1e-9)).g1, "{what}");
            let tangent = around(&moved, joint, 1) - around(&moved, joint, 0);
            let side = |k| tangent.perp_dot(around(&moved, joint, k) - around(&moved, joint, 0));
            if side(-2) * side(2) > 1e-6 {
                let segment = |k: usize| moved.segment(k).expect("a segment");
                let (a, b) = (
                    segment(joint - 1).curvature(1.0),
                    segment(joint).curvature(0.0),
                );
                near_at(a, b, 1e-6 * a.abs().max(b.abs()), what);
                held += 1;
            } else {
                not += 1;
            }
        }
    }
    assert!(held.min(not) > (held + not) / 4, "{held} {not}");
}

/// Handles by the textbook formula, from the points of three joints.
fn tangent<P: Point>(a: P, b: P, c: P) -> (P, f64, f64) {
    let (d1, d2) = ((b - a).norm().sqrt(), (c - b).norm().sqrt());
    let t = (b - a) / d1 - (c - a) / (d1 + d2) + (c - b) / d2;
    (t, d1, d2)
}

fn automatic<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for round in 0..400 {
        let closed = round % 2 == 0;
        let n = 2 + rng.below(4);
        let degrees: Vec<usize> = (0..n).map(|_| rng.pick(&[3, 3, 4, 5])).collect();
        let spline = smooth::<P>(&mut rng, &degrees, closed, Auto);
        let moved_joint = rng.below(n);
        let to = P::of(rng.point(P::DIMENSION));
        let moved = moved(&spline, index_of(&spline, moved_joint), to, Auto);
        let anchor = |k: usize| around(&moved, k, 0);
        for joint in joints(&moved) {
            let (left, right) = ((joint + n - 1) % n, joint);
            let next = if closed { (joint + 1) % n } else { joint + 1 };
            let (t, d1, d2) = tangent(anchor(left), anchor(joint), anchor(next));
            let ahead = anchor(joint) + t * (d2 / real(degrees[right]));
            let behind = anchor(joint) - t * (d1 / real(degrees[left]));
            let what = (&degrees, closed, moved_joint, joint);
            near_at(around(&moved, joint, 1), ahead, 1e-12, what);
            near_at(around(&moved, joint, -1), behind, 1e-12, what);
        }
        let (p, q) = (spline.control_points(), moved.control_points());
        if !closed && moved_joint <= 1 {
            // One-sided at a free end.
            let third = q[0] + (anchor(1) - q[0]) / real(degrees[0]);
            near_at(q[1], third, 1e-15, &degrees);
        }
        // Nothing else moves.
        for i in (0..p.len()).filter(|&i| p[i] != q[i]) {
            let beside = |k: usize| i.abs_diff(index_of(&spline, k)) <= 1;
            assert!((0..=n).any(beside), "{degrees:?}: {i}");
        }
    }
}

#[test]
fn automatic_handles_follow_their_neighbours() {
    automatic::<DVec2>(75);
    automatic::<DVec3>(76);
}

/// A handle of an automatic joint that is moved explicitly keeps its position; so does a handle at an end.
#[test]
fn automatic_handles_can_be_moved() {
    let spline = smooth::<DVec2>(&mut Rng(77), &[3; 3], false, Auto);
    for index in [1, 2, 4, 5, 7, 8] {
        let moved = moved(&spline, index, DVec2::new(5.0, 7.0), Auto);
        let (p, q) = (spline.control_points(), moved.control_points());
        assert!((0..10).all(|i| (p[i] != q[i]) == (i == index)), "{index}");
    }
}

/// Modes may differ from joint to joint: a free joint stops the propagation.
#[test]
fn free_joints_stop_the_propagation() {
    let spline = smooth::<DVec2>(&mut Rng(78), &[3; 6], false, C2);
    let mode = |k: usize| if k == 3 { Free } else { C2 };
    let mut dragged = spline.clone();
    dragged.move_point(2, DVec2::ZERO, mode).expect("a point");
    assert!(continuity(&dragged, 2, None).c2 && !continuity(&dragged, 3, None).g1);
    assert_eq!(dragged.control_points()[9..], spline.control_points()[9..]);
    // G1 propagates only the direction: the next joint is unchanged.
    let dragged = moved(&spline, 2, DVec2::ZERO, G1);
    assert_eq!(dragged.control_points()[5..], spline.control_points()[5..]);
}

/// On a ring each point is set only once: where the two fronts meet one joint may break, and no other.
#[test]
fn rings_break_at_one_joint() {
    let mut rng = Rng(79);
    for count in [2, 3, 4, 5, 6, 9] {
        // A ring that is C2 everywhere: a uniform B-spline.
        let d: Vec<DVec2> = random_points(&mut rng, count);
        let piece = |k: usize| {
            let [a, b, c] = [k, k + 1, k + 2].map(|i| d[i % count]);
            let joint = (a + b * 4.0 + c) / 6.0;
            [joint, (b * 2.0 + c) / 3.0, (b + c * 2.0) / 3.0]
        };
        let points: Vec<DVec2> = (0..count).flat_map(piece).collect();
        let ring = Spline::new(&points, 3, true).expect("a ring");
        let lost = |s: &Spline<DVec2>| -> Vec<usize> {
            let tolerance = Some(1e-11 * largest(s.control_points()));
            (0..count)
                .filter(|&k| !continuity(s, k, tolerance).c2)
                .collect()
        };
        assert!(lost(&ring).is_empty());
        for index in 0..points.len() {
            let moved = moved(&ring, index, points[index] + DVec2::of(rng.point(2)), C2);
            let lost = lost(&moved);
            let away = |k: &usize| {
                let along = (3 * k + points.len() - index) % points.len();
                along.min(points.len() - along)
            };
            // The fronts meet at the last joint of a ring of n joints, or at the last two that share a segment.
            let opposite = lost.iter().all(|k| away(k) + 5 >= points.len() / 2);
            assert!(
                lost.len() <= 2 && opposite,
                "{count}: {index} loses {lost:?}"
            );
        }
    }
}

/// The growth along a long spline ends where numbers would overflow.
#[test]
fn long_splines_stay_finite() {
    let points: Vec<DVec2> = (0..=9000)
        .map(|i| DVec2::new(real(i), real(i % 3)))
        .collect();
    for closed in [false, true] {
        let points = &points[..points.len() - usize::from(closed)];
        let long = Spline::new(points, 3, closed).expect("a chain");
        for (mode, index) in ALL
            .into_iter()
            .flat_map(|m| [0, 1, 4500, 4501, 8999].map(|i| (m, i)))
        {
            let to = DVec2::new(1.0, -7.0);
            let moved = moved(&long, index, to, mode);
            let valid = moved.control_points()[index] == to && is_finite(&moved);
            assert!(valid, "{mode:?} {index}");
        }
    }
}

/// Moving points of the reversed spline gives the mirrored result, and space behaves as the plane.
#[test]
fn reversed_and_turned() {
    let mut rng = Rng(80);
    for round in 0..600 {
        let degrees = some_degrees(&mut rng, round % 2 == 0);
        let spline = chain::<DVec3>(&mut rng, &degrees, false, 1.0);
        let mut mode = || rng.pick(&[Free, G1, C1, C2, Auto]);
        let modes: Vec<JointMode> = degrees.iter().map(|_| mode()).collect();
        let p = spline.control_points();
        let index = rng.below(p.len());
        let dragged = joints(&spline).any(|k| index_of(&spline, k) == index && modes[k] != Auto);
        let to = rng.point(3);
        let moved = changed(&spline, |s| s.move_point(index, to, |k| modes[k])).expect("a point");
        let slack = 1e-9 * (largest(moved.control_points()) + largest(p));
        let what = format!("{degrees:?} {modes:?} {index}");
        let turn = DAffine3::from_mat3(DMat3::from_rotation_x(0.7) * DMat3::from_rotation_z(2.0));
        let image = |spline: &Spline<DVec3>| spline.transform(&turn).expect("a finite image");
        let turned = changed(&image(&spline), |s| {
            s.move_point(index, turn.transform_point3(to), |k| modes[k])
        });
        // Points that coincide before a rotation may not coincide after it.
        let apart = |p: &[DVec3]| p[0] == p[1] || p[0].distance(p[1]) > 1e-3;
        if p.windows(2).all(apart) {
            let turned = turned.expect("a point");
            assert!(turned.approx_eq(&image(&moved), slack), "{what}");
        }
        if !dragged {
            let (n, last) = (degrees.len(), p.len() - 1);
            let mut back = spline.reverse();
            back.move_point(last - index, to, |k| modes[n - k])
                .expect("a point");
            let back = back.reverse();
            assert!(back.approx_eq(&moved, slack), "{what}");
        }
    }
}

#[test]
fn setting_a_joint_keeps_the_handle_before_it() {
    let mut rng = Rng(81);
    for _ in 0..2000 {
        let degrees = some_degrees(&mut rng, false);
        let closed = rng.chance(0.4);
        let spline = chain::<DVec2>(&mut rng, &degrees, closed, 1.0);
        for (joint, mode) in joints(&spline).flat_map(|k| ALL.map(|mode| (k, mode))) {
            let set = spline.set_joint(joint, mode).expect("a joint");
            let what = format!("{degrees:?} {closed} {joint} {mode:?}");
            let at = |k: isize| (around(&spline, joint, k), around(&set, joint, k));
            let kept = at(0).0 == at(0).1 && (mode == Auto || at(-1).0 == at(-1).1);
            assert!(kept, "{what}");
            let c = continuity(&set, joint, Some(1e-9));
            let count = spline.control_points().len();
            let c2 = mode == C2 && cubic_beside(&spline, joint) && count > 4;
            let c1 = (mode == C1 || mode == C2) && count > 2;
            assert!((c.c2 || !c2) && (c.c1 || !c1), "{what}");
            let again = set.set_joint(joint, mode).expect("a joint");
            assert!(again.approx_eq(&set, 1e-12), "{what}");
        }
    }
}

#[test]
fn equal_curvature_is_of_the_plane() {
    let spline = smooth::<DVec3>(&mut Rng(82), &[3; 3], false, C1);
    let error = spline.set_joint(1, G2).expect_err("refused");
    let expected = "mode: expected a plane spline for G2, got one in space";
    assert_eq!(error.to_string(), expected);
    assert_eq!(error, Error::NotPlane);
    let one = |k: usize| if k == 2 { G2 } else { Free };
    let mut same = spline.clone();
    assert_eq!(same.move_point(0, DVec3::ONE, one), Err(error));
    assert_eq!(same, spline);
}
