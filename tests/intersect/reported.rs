//! Intersections at ends, at tips and between curves that nearly coincide, each reported once and exact; cases found by
//! a tester.

use casteljau::Curve;
use casteljau::curve::{Intersection, IntersectionKind};
use casteljau::glam::DVec2;

fn curve(points: &[[f64; 2]]) -> Curve<DVec2> {
    let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
    Curve::new(&points).expect("a curve")
}

fn kinds(found: &[Intersection]) -> Vec<(f64, f64, IntersectionKind)> {
    found.iter().map(|f| (f.t, f.u, f.kind)).collect()
}

#[test]
fn halves_of_a_line_touch_in_the_middle() {
    for k in 0..2000 {
        let x = |m: u32| f64::from((k * m) % 97) / 10.0;
        let line = curve(&[[x(3), x(5)], [x(7) + 0.1, x(11)]]);
        let (a, b) = line.split(0.1 + f64::from(k % 9) / 11.0);
        let expected = vec![(1.0, 0.0, IntersectionKind::Tangent)];
        assert_eq!(kinds(&a.intersections(&b)), expected, "{a:?} {b:?}");
    }
}

#[test]
fn a_part_of_a_line_lies_on_it() {
    for k in 0..2000 {
        let x = |m: u32| f64::from((k * m) % 101) / 7.0;
        let line = curve(&[[x(3), x(5)], [x(7) + 0.1, x(11)]]);
        let (from, to) = (0.05 + x(13) / 40.0, 0.55 + x(17) / 40.0);
        let found = line.intersections(&line.subsegment(from, to));
        let [location] = found[..] else {
            panic!("{line:?} from {from} to {to}: {found:?}")
        };
        let IntersectionKind::Overlap { t_end, u_end } = location.kind else {
            panic!("{line:?}: {location:?}")
        };
        assert!((location.t - from).abs() < 1e-12 && (t_end - to).abs() < 1e-12);
        assert_eq!((location.u, u_end), (0.0, 1.0));
    }
}

#[test]
fn ends_that_touch_are_exact_from_both_sides() {
    let cases = [
        (
            [[1.0, 1.0], [2.0, 1.0]].to_vec(),
            [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]].to_vec(),
        ),
        (
            [[1.0, 2.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]].to_vec(),
            [[2.0, 1.0], [2.0, 0.0], [2.0, 0.0]].to_vec(),
        ),
    ];
    for (k, (a, b)) in cases.iter().enumerate() {
        let (a, b) = (curve(a), curve(b));
        let (t, u) = if k == 0 { (0.0, 1.0) } else { (1.0, 0.0) };
        assert_eq!(
            kinds(&a.intersections(&b)),
            [(t, u, IntersectionKind::Tangent)]
        );
        assert_eq!(
            kinds(&b.intersections(&a)),
            [(u, t, IntersectionKind::Tangent)]
        );
        assert_eq!(
            kinds(&a.reverse().intersections(&b)),
            [(1.0 - t, u, IntersectionKind::Tangent)]
        );
    }
    let (a, b) = (
        curve(&[[1.1, 7.4], [5.9, 1.3]]),
        curve(&[[5.9, 1.3], [1.0, 4.6]]),
    );
    assert_eq!(
        kinds(&a.intersections(&b)),
        [(1.0, 0.0, IntersectionKind::Cross)]
    );
}

#[test]
fn one_crossing_of_curves_that_nearly_coincide_comes_once() {
    let ts = |a: &Curve<DVec2>, b: &Curve<DVec2>| -> Vec<(f64, IntersectionKind)> {
        a.intersections(b).iter().map(|f| (f.t, f.kind)).collect()
    };
    let a = curve(&[[0.0, 0.0], [1.0, 2.0], [3.0, 1.0]]);
    let b = curve(&[[1e-9, 0.0], [1.0, 2.0 + 1e-9], [3.0, 1.0]]);
    let found = ts(&a, &b);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0].0 - 0.29843788).abs() < 1e-6 && found[0].1 == IntersectionKind::Cross);
    assert_eq!(found[1].0, 1.0);
    let c = curve(&[[0.0, 0.0], [1.0, 3.0], [3.0, -2.0], [4.0, 1.0]]);
    let beside: Vec<DVec2> = c
        .control_points()
        .iter()
        .map(|&p| p + DVec2::new(1e-9, 0.0))
        .collect();
    let found = ts(&c, &Curve::new(&beside).expect("a curve"));
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(
        found
            .iter()
            .all(|&(_, kind)| kind == IntersectionKind::Cross),
        "{found:?}"
    );
    let a = curve(&[[0.0, 2.0], [1.0, 0.0]]);
    let b = curve(&[
        [3.6851080130843286e-7, 1.999999999999966],
        [0.999999999999983, -1.8425540065421643e-7],
    ]);
    assert_eq!(ts(&a, &b).len(), 1);
}

#[test]
fn the_tip_of_a_turn_back_is_one_intersection() {
    let there_and_back = curve(&[[0.0, 2.0], [0.0, 0.0], [0.0, 2.0]]);
    let across = curve(&[[-1.0, 1.0], [2.0, 1.0]]);
    let found = there_and_back.intersections(&across);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!((found[0].t - 0.5).abs() < 1e-12 && (found[0].u - 1.0 / 3.0).abs() < 1e-12);
    let from = curve(&[[0.0, 1.0], [2.0, 1.0]]);
    assert_eq!(there_and_back.intersections(&from).len(), 1);
    assert_eq!(from.intersections(&there_and_back).len(), 1);
    let (loop_, curved) = (
        curve(&[[1.0, 2.0], [2.0, 0.0], [0.0, 0.0], [1.0, 2.0]]),
        curve(&[[0.0, 2.0], [2.0, 2.0], [0.0, 2.0]]),
    );
    assert_eq!(
        loop_.intersections(&curved).len(),
        curved.intersections(&loop_).len()
    );
}

/// Both curves turn back on one line, and only their tips overlap: each of the two branches at a tip overlaps with both
/// branches of the other curve.
#[test]
fn tips_that_overlap_on_a_line() {
    let a = curve(&[[0.0, 0.0], [7.0, 14.0], [1.0, 2.0], [3.0, 6.0]]);
    let b = curve(&[[6.0, 12.0], [1.0, 2.0], [6.0, 12.0]]);
    // x(t) = 21t(1 − t)² + 3t²(1 − t) + 3t³ = 21t³ − 39t² + 21t, largest where 63t² − 78t + 21 = 0.
    let t = (13.0 - 22.0_f64.sqrt()) / 21.0;
    let tip = ((21.0 * t - 39.0) * t + 21.0) * t;
    for (first, second) in [(&a, &b), (&b, &a), (&a.reverse(), &b)] {
        let found = first.intersections(second);
        assert_eq!(found.len(), 4, "{found:?}");
        for location in found {
            let IntersectionKind::Overlap { t_end, u_end } = location.kind else {
                panic!("{location:?}")
            };
            let ends = [
                first.eval(location.t),
                second.eval(location.u),
                first.eval(t_end),
                second.eval(u_end),
            ];
            let mut xs = ends.map(|p| p.x);
            xs.sort_by(f64::total_cmp);
            let expected = [3.5, 3.5, tip, tip];
            assert!(
                xs.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-12),
                "{xs:?}"
            );
        }
    }
}

/// Next to points of zero speed there are two intersections that are too far apart on the other curve to be merged;
/// this case did not terminate.
#[test]
fn intersections_next_to_a_stop_are_merged() {
    let curve = curve(&[
        [0.0, 3.15226451847719e-6],
        [-2.7154260618674997e-6, 3.7056504482343374e-6],
        [-0.005002670546670256, 0.0010226635414463704],
        [-0.011577764137035611, 0.002362624268361621],
    ]);
    let other = Curve::new(
        &[
            [0.0, 7.767519634453476e-10],
            [-7731174.303668077, -4269303.7191457],
            [747629083536546.6, 412855214681899.8],
            [-88271658546526.19, -48745314143162.2],
        ]
        .map(DVec2::from),
    )
    .expect("finite");
    for location in curve.intersections(&other) {
        let gap = (curve.eval(location.t) - other.eval(location.u)).length();
        assert!(gap < 1.0, "{location:?} {gap}"); // the ulp of 7.5e14 is 0.125
    }
}

/// Checks that both curves are at each intersection, at both ends of each overlap, and that the list is sorted.
fn hold(a: &Curve<DVec2>, b: &Curve<DVec2>) {
    let found = a.intersections(b);
    let size = [a, b].map(|c| {
        c.control_points()
            .iter()
            .fold(0.0, |m: f64, p| m.max(p.abs().max_element()))
    });
    let degree = u32::try_from(a.degree().max(b.degree())).expect("a degree");
    let slack = 64.0 * f64::from(degree + 2) * f64::EPSILON * size[0].max(size[1]);
    let gap = |t: f64, u: f64| (a.eval(t) - b.eval(u)).length();
    for location in &found {
        assert!(gap(location.t, location.u) <= slack, "{location:?}");
        if let IntersectionKind::Overlap { t_end, u_end } = location.kind {
            assert!(
                gap(t_end, u_end) <= slack && t_end > location.t,
                "{location:?}"
            );
        }
    }
    assert!(
        found.is_sorted_by_key(|location| (location.t, location.u)),
        "{found:?}"
    );
}

/// A curve of size 1e10 and a curve that is a point in comparison do not overlap.
#[test]
fn a_tiny_curve_shares_no_piece() {
    let large = curve(&[
        [3.614879838328824e-9, 56898630290.12825],
        [0.004645787551213872, 0.0],
        [-3.013641919243123e-7, 0.00013455582954796723],
    ]);
    let tiny = curve(&[
        [0.0, 2.3155809067085324e-17],
        [1.69016478000671e-7, -3.12582499109741e-13],
        [1.69016478000671e-7, -3.12582499109741e-13],
        [0.0, 2.3155809067085324e-17],
    ]);
    hold(&large, &tiny);
    hold(&tiny, &large);
}

/// Both curves lie on a line; the first one leaves the second and returns to it.
#[test]
fn straight_pieces_end_where_both_curves_are() {
    let far = curve(&[
        [47.12282246102807, 0.0],
        [-18348638793.224117, 0.0],
        [222394810574064.8, 188420.29177297564],
        [0.0, 1.4537361518087484e-6],
        [1.0, 0.0],
    ]);
    let near = curve(&[
        [810.8427241087977, 0.0],
        [-525.9991845424469, 0.0],
        [3.5337534507966977, 0.0],
        [280.1567951943553, 0.0],
    ]);
    hold(&far, &near);
    for location in far.intersections(&near) {
        let IntersectionKind::Overlap { t_end, .. } = location.kind else {
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
    let hooks = curve(&[
        [0.0, 0.0],
        [-5.0320271562933225e-5, 3.4738443846101553e-5],
        [0.0, 0.0],
        [-1.6053392612117122e-9, 1.108240994085257e-9],
    ]);
    let elevated = curve(&[
        [0.0, 0.0],
        [-3.7740203672199916e-5, 2.6053832884576163e-5],
        [-2.5160135781466613e-5, 1.7369221923050777e-5],
        [-4.0133481530292806e-10, 2.7706024852131426e-10],
        [-1.6053392612117122e-9, 1.108240994085257e-9],
    ]);
    hold(&hooks, &elevated);
    hold(&elevated, &hooks);
}
