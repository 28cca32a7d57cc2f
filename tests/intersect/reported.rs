//! Intersections at ends, at tips and between curves that nearly coincide, each reported once and exact; cases found by
//! a tester.

use crate::intersect::{kinds, spots};
use crate::support::{all_near, bezier, largest, near, near_at, real};
use casteljau::Curve;
use casteljau::curve::IntersectionKind::{Cross, Overlap, Tangent};
use casteljau::glam::{DAffine2, DVec2};

/// A line that depends on k.
fn line(k: usize, x: impl Fn(usize) -> f64) -> Curve<DVec2> {
    Curve::line(
        DVec2::new(x(3 * k), x(5 * k)),
        DVec2::new(x(7 * k) + 0.1, x(11 * k)),
    )
}

#[test]
fn halves_of_a_line_touch_in_the_middle() {
    for k in 0..2000 {
        let (a, b) = line(k, |n| real(n % 97) / 10.0).split(0.1 + real(k % 9) / 11.0);
        let found = kinds(&a.intersections(&b));
        assert_eq!(found, [(1.0, 0.0, Tangent)], "{a:?} {b:?}");
    }
}

#[test]
fn a_part_of_a_line_lies_on_it() {
    for k in 0..2000 {
        let x = |n: usize| real(n % 101) / 7.0;
        let line = line(k, x);
        let (from, to) = (0.05 + x(13 * k) / 40.0, 0.55 + x(17 * k) / 40.0);
        let found = line.intersections(&line.subsegment(from..to));
        let [(t, 0.0, Overlap { t_end, u_end: 1.0 })] = kinds(&found)[..] else {
            panic!("{line:?} from {from} to {to}: {found:?}")
        };
        near_at(t, from, 1e-12, &line);
        near_at(t_end, to, 1e-12, &line);
    }
}

#[test]
fn ends_that_touch_are_exact_from_both_sides() {
    for (a, b, t, u, kind) in [
        ("1 1, 2 1", "0 0, 2 0, 2 1, 1 1", 0.0, 1.0, Tangent),
        ("1 2, 0 1, 2 0, 2 1", "2 1, 2 0, 2 0", 1.0, 0.0, Tangent),
        ("1.1 7.4, 5.9 1.3", "5.9 1.3, 1 4.6", 1.0, 0.0, Cross),
    ] {
        let (a, b) = (bezier(a), bezier(b));
        assert_eq!(kinds(&a.intersections(&b)), [(t, u, kind)]);
        assert_eq!(kinds(&b.intersections(&a)), [(u, t, kind)]);
        assert_eq!(kinds(&a.reverse().intersections(&b)), [(1.0 - t, u, kind)]);
    }
}

#[test]
fn one_crossing_of_curves_that_nearly_coincide_comes_once() {
    let b = bezier("1e-9 0, 1 2.000000001, 3 1");
    let found = kinds(&bezier("0 0, 1 2, 3 1").intersections(&b));
    assert_eq!(
        (found.len(), found[0].2, found[1].0),
        (2, Cross, 1.0),
        "{found:?}"
    );
    near(found[0].0, 0.29843788, 1e-6);
    let c = bezier("0 0, 1 3, 3 -2, 4 1");
    let beside = DAffine2::from_translation(DVec2::new(1e-9, 0.0)) * &c;
    let found = kinds(&c.intersections(&beside));
    assert!(
        found.len() == 2 && found.iter().all(|p| p.2 == Cross),
        "{found:?}"
    );
    let b =
        bezier("3.6851080130843286e-7 1.999999999999966, 0.999999999999983 -1.8425540065421643e-7");
    assert_eq!(bezier("0 2, 1 0").intersections(&b).len(), 1);
}

#[test]
fn the_tip_of_a_turn_back_is_one_intersection() {
    let back = bezier("0 2, 0 0, 0 2");
    let found = back.intersections(&bezier("-1 1, 2 1"));
    assert_eq!(found.len(), 1, "{found:?}");
    near(found[0].t, 0.5, 1e-12);
    near(found[0].u, 1.0 / 3.0, 1e-12);
    let from = bezier("0 1, 2 1");
    let count = |a: &Curve<DVec2>, b: &Curve<DVec2>| a.intersections(b).len();
    assert_eq!((count(&back, &from), count(&from, &back)), (1, 1));
    let (loop_, curved) = (bezier("1 2, 2 0, 0 0, 1 2"), bezier("0 2, 2 2, 0 2"));
    assert_eq!(count(&loop_, &curved), count(&curved, &loop_));
}

/// Both curves turn back on one line, and only their tips overlap: each of the two branches at a tip overlaps with both
/// branches of the other curve.
#[test]
fn tips_that_overlap_on_a_line() {
    let (a, b) = (bezier("0 0, 7 14, 1 2, 3 6"), bezier("6 12, 1 2, 6 12"));
    // x(t) = 21t(1 − t)² + 3t²(1 − t) + 3t³ = 21t³ − 39t² + 21t, largest where 63t² − 78t + 21 = 0.
    let t = (13.0 - 22.0_f64.sqrt()) / 21.0;
    let tip = ((21.0 * t - 39.0) * t + 21.0) * t;
    for (first, second) in [(&a, &b), (&b, &a), (&a.reverse(), &b)] {
        let found = first.intersections(second);
        assert_eq!(found.len(), 4, "{found:?}");
        for spots in found.iter().map(spots) {
            let ends = |&(t, u): &(f64, f64)| [first.eval(t).x, second.eval(u).x];
            let mut xs: Vec<f64> = spots.iter().flat_map(ends).collect();
            xs.sort_by(f64::total_cmp);
            all_near(&xs, &[3.5, 3.5, tip, tip], 1e-12);
        }
    }
}

/// Next to points of zero speed there are two intersections that are too far apart on the other curve to be merged;
/// this case did not terminate.
#[test]
fn intersections_next_to_a_stop_are_merged() {
    let curve = bezier(
        "0 3.15226451847719e-6, -2.7154260618674997e-6 3.7056504482343374e-6,
         -0.005002670546670256 0.0010226635414463704, -0.011577764137035611 0.002362624268361621",
    );
    let other = bezier(
        "0 7.767519634453476e-10, -7731174.303668077 -4269303.7191457,
         747629083536546.6 412855214681899.8, -88271658546526.19 -48745314143162.2",
    );
    for p in curve.intersections(&other) {
        // The ulp of 7.5e14 is 0.125.
        near_at(curve.eval(p.t), other.eval(p.u), 1.0, p);
    }
}

/// Checks that both curves are at each intersection, at both ends of each overlap, and that the list is sorted.
fn hold(a: &Curve<DVec2>, b: &Curve<DVec2>) {
    let found = a.intersections(b);
    let size = largest(a.control_points()).max(largest(b.control_points()));
    let slack = 64.0 * real(a.degree().max(b.degree()) + 2) * f64::EPSILON * size;
    for p in &found {
        let spots = spots(p);
        assert!(spots.windows(2).all(|s| s[0].0 < s[1].0), "{p:?}");
        for (t, u) in spots {
            near_at(a.eval(t), b.eval(u), slack, p);
        }
    }
    assert!(found.is_sorted_by_key(|p| (p.t, p.u)), "{found:?}");
}

/// A curve of size 1e10 and a curve that is a point in comparison do not overlap.
#[test]
fn a_tiny_curve_shares_no_piece() {
    let large = bezier(
        "3.614879838328824e-9 56898630290.12825, 0.004645787551213872 0,
            -3.013641919243123e-7 0.00013455582954796723",
    );
    let tiny = bezier(
        "0 2.3155809067085324e-17, 1.69016478000671e-7 -3.12582499109741e-13,
            1.69016478000671e-7 -3.12582499109741e-13, 0 2.3155809067085324e-17",
    );
    hold(&large, &tiny);
    hold(&tiny, &large);
}

/// Both curves lie on a line; the first one leaves the second and returns to it.
#[test]
fn straight_pieces_end_where_both_curves_are() {
    let far = bezier(
        "47.12282246102807 0, -18348638793.224117 0,
            222394810574064.8 188420.29177297564, 0 1.4537361518087484e-6, 1 0",
    );
    let near = bezier(
        "810.8427241087977 0, -525.9991845424469 0, 3.5337534507966977 0,
            280.1567951943553 0",
    );
    hold(&far, &near);
    for location in far.intersections(&near) {
        let Overlap { t_end, .. } = location.kind else {
            continue;
        };
        // The middle must not be on the intermediate piece, which is 1e9 away.
        let middle = far.eval(0.5 * (location.t + t_end));
        assert!(middle.x.abs() <= 1e3, "{location:?} passes {middle}");
    }
}

/// A straight cubic that turns back twice, next to its ends, and its elevation: each hook overlaps with the other one
/// backwards.
#[test]
fn shared_pieces_of_short_hooks_keep_their_ends() {
    let hooks = bezier(
        "0 0, -5.0320271562933225e-5 3.4738443846101553e-5, 0 0,
            -1.6053392612117122e-9 1.108240994085257e-9",
    );
    let elevated = bezier(
        "0 0, -3.7740203672199916e-5 2.6053832884576163e-5,
            -2.5160135781466613e-5 1.7369221923050777e-5,
            -4.0133481530292806e-10 2.7706024852131426e-10,
            -1.6053392612117122e-9 1.108240994085257e-9",
    );
    hold(&hooks, &elevated);
    hold(&elevated, &hooks);
}
