//! The tree of halvings with the D1 − D2 test.

use crate::curve::adversarial_points;
use crate::support::adversarial::ORDINARY;
use crate::support::measure::Reference;
use crate::support::{Space, curve, largest, plane, to_3d, ulp};
use casteljau::curve::Subdivision;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Error, Point};
use wasm_bindgen_test::wasm_bindgen_test;

fn polygon_length(points: &[DVec3]) -> f64 {
    points.windows(2).map(|w| (w[1] - w[0]).length()).sum()
}

/// Checks a node and its descendants; `whole` is the curve from which the node comes.
fn check<P: Space>(node: &Subdivision<P>, whole: &[DVec3], tolerance: f64) {
    let points = to_3d(node.curve.control_points());
    let rounding = 16.0 * ulp(largest(whole)) * crate::curve::steps(whole);
    let near = |a: f64, b: f64| (a - b).abs() <= rounding;
    assert!(near(node.polygon_length, polygon_length(&points)));
    assert!(near(
        node.chord_length,
        (points[points.len() - 1] - points[0]).length()
    ));
    let ends = [(node.t0, points[0]), (node.t1, points[points.len() - 1])];
    for (t, p) in ends {
        assert!((crate::support::exact::eval(whole, t) - p).length() <= rounding);
    }
    let difference = node.polygon_length - node.chord_length;
    let Some(halves) = &node.halves else {
        assert!(difference < tolerance, "a leaf with D1 - D2 = {difference}");
        return assert_bound_holds(node, &points, rounding);
    };
    assert!(difference >= tolerance, "halved without need");
    let middle = 0.5 * (node.t0 + node.t1);
    let [left, right] = &**halves;
    assert_eq!(
        (left.t0, left.t1, right.t0, right.t1),
        (node.t0, middle, middle, node.t1)
    );
    check(left, whole, tolerance);
    check(right, whole, tolerance);
}

/// Asserts that the piece is within the bound of its chord.
fn assert_bound_holds<P: Point>(node: &Subdivision<P>, points: &[DVec3], rounding: f64) {
    let reference = Reference::new(points);
    let chord = (
        reference.location(points[0]),
        reference.location(points[points.len() - 1]),
    );
    let distance = reference.deviation((0.0, 1.0), chord, f64::INFINITY);
    // The bound is a square root, so rounding of D1 and D2 counts with the square root of the length.
    let slack = rounding + (rounding * node.polygon_length).sqrt();
    assert!(
        distance <= reference.length(node.deviation_bound() + slack),
        "{distance} in {points:?}"
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn the_tree_of_every_curve() {
    fn all<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        let size = polygon_length(&to_3d(curve.control_points()));
        for part in [1e-1, 1e-4] {
            let tolerance = (size * part).max(64.0 * ulp(largest(points)).max(f64::MIN_POSITIVE));
            let tree = curve.subdivide(tolerance).expect("a tree");
            assert_eq!((tree.t0, tree.t1, &tree.curve), (0.0, 1.0, &curve));
            check(&tree, &to_3d(curve.control_points()), tolerance);
            let leaves = tree.leaves();
            assert!(leaves.iter().all(|leaf| leaf.halves.is_none()));
            assert!(
                leaves
                    .windows(2)
                    .all(|w| w[0].t1 == w[1].t0 && w[0].curve.end() == w[1].curve.start())
            );
            assert_eq!((leaves[0].t0, leaves[leaves.len() - 1].t1), (0.0, 1.0));
        }
    }
    adversarial_points(&ORDINARY, |points| {
        if points.len() <= 9 {
            all::<DVec2>(points);
            all::<DVec3>(points);
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn a_known_tree() {
    // At the root D1 = 4 and D2 = 2√2; its left half is (0, 0), (0, 1), (½, 3/2).
    let tree = plane(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0)])
        .subdivide(0.5)
        .expect("a tree");
    assert_eq!(
        (tree.polygon_length, tree.chord_length),
        (4.0, 8.0_f64.sqrt())
    );
    assert!((tree.deviation_bound() - 0.5 * (16.0 - 8.0_f64).sqrt()).abs() < 1e-15);
    let leaves = tree.leaves();
    let ts: Vec<f64> = leaves.iter().map(|leaf| leaf.t0).collect();
    assert_eq!(ts, [0.0, 0.5]);
    assert_eq!(leaves[0].polygon_length, 1.0 + 0.5_f64.sqrt());
    assert_eq!(leaves[0].chord_length, 2.5_f64.sqrt());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_straight_curve_is_one_leaf_and_a_point_too() {
    let line = plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)])
        .subdivide(1e-9)
        .expect("a tree");
    assert!(line.halves.is_none());
    let point = plane(&[(5.0, 5.0); 4]).subdivide(1e-9).expect("a tree");
    assert!(point.halves.is_none() && point.deviation_bound() == 0.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn refusals() {
    let arch = plane(&[(0.0, 0.0), (1.0, 2.0), (2.0, 0.0)]);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            arch.subdivide(bad),
            Err(Error::Range {
                what: "tolerance",
                ..
            })
        ));
    }
    let min = 4.0 * ulp(1.5);
    let got = min * 0.99;
    assert_eq!(
        plane(&[(0.0, 0.0), (1.5, 0.0)]).subdivide(got).err(),
        Some(Error::Tolerance { min, got })
    );
    let wide = plane(&[(0.0, 0.0), (1e9, 1e9), (-1e9, 1e9), (0.0, 0.0)]).subdivide(1e-6);
    assert!(matches!(
        wide,
        Err(Error::TooMany {
            what: "leaves",
            limit: 65536,
            ..
        })
    ));
}
