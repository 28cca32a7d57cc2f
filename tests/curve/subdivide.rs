//! The tree of halvings with the D1 − D2 test.

use crate::curve::{adversarial_points, steps};
use crate::support::adversarial::ORDINARY;
use crate::support::measure::Reference;
use crate::support::{Space, bezier, curve, exact, largest, near, to_3d, ulp};
use casteljau::Point;
use casteljau::curve::Subdivision;
use casteljau::glam::{DVec2, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn polygon_length(points: &[DVec3]) -> f64 {
    points.windows(2).map(|w| (w[1] - w[0]).length()).sum()
}

/// Checks a node and its descendants; `whole` is the curve from which the node comes.
fn check<P: Space>(node: &Subdivision<P>, whole: &[DVec3], tolerance: f64) {
    let points = to_3d(node.curve.control_points());
    let (start, end) = (points[0], points[points.len() - 1]);
    let rounding = 16.0 * ulp(largest(whole)) * steps(whole);
    near(node.polygon_length, polygon_length(&points), rounding);
    near(node.chord_length, (end - start).length(), rounding);
    near(exact::eval(whole, node.t0), start, rounding);
    near(exact::eval(whole, node.t1), end, rounding);
    let difference = node.polygon_length - node.chord_length;
    let Some(halves) = &node.halves else {
        assert!(difference < tolerance, "a leaf with D1 - D2 = {difference}");
        return assert_bound_holds(node, &points, rounding);
    };
    assert!(difference >= tolerance, "halved without need");
    let middle = 0.5 * (node.t0 + node.t1);
    let [left, right] = &**halves;
    let found = (left.t0, left.t1, right.t0, right.t1);
    assert_eq!(found, (node.t0, middle, middle, node.t1));
    check(left, whole, tolerance);
    check(right, whole, tolerance);
}

/// Asserts that the piece is within the bound of its chord.
fn assert_bound_holds<P: Point>(node: &Subdivision<P>, points: &[DVec3], rounding: f64) {
    let reference = Reference::new(points);
    let control = reference.locations(points);
    let chord = (control[0], control[control.len() - 1]);
    let distance = reference.deviation((0.0, 1.0), chord, f64::INFINITY);
    // The bound is a square root, so rounding of D1 and D2 counts with the square root of the length.
    let slack = rounding + (rounding * node.polygon_length).sqrt();
    let max = reference.length(node.deviation_bound() + slack);
    assert!(distance <= max, "{distance} in {points:?}");
}

#[test]
fn the_tree_of_every_curve() {
    fn all<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        let control = to_3d(curve.control_points());
        let min = 64.0 * ulp(largest(points)).max(f64::MIN_POSITIVE);
        for part in [1e-1, 1e-4] {
            let tolerance = (polygon_length(&control) * part).max(min);
            let tree = curve.subdivide(tolerance).expect("a tree");
            assert_eq!((tree.t0, tree.t1, &tree.curve), (0.0, 1.0, &curve));
            check(&tree, &control, tolerance);
            let leaves = tree.leaves();
            assert!(leaves.iter().all(|leaf| leaf.halves.is_none()));
            for w in leaves.windows(2) {
                assert_eq!((w[0].t1, w[0].curve.end()), (w[1].t0, w[1].curve.start()));
            }
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

#[test]
fn known_trees() {
    // At the root D1 = 4 and D2 = 2√2; its left half is (0, 0), (0, 1), (½, 3/2).
    let tree = bezier("0 0, 0 2, 2 2").subdivide(0.5).expect("a tree");
    assert_eq!(
        (tree.polygon_length, tree.chord_length),
        (4.0, 8.0_f64.sqrt())
    );
    near(tree.deviation_bound(), 0.5 * (16.0 - 8.0_f64).sqrt(), 1e-15);
    let leaves = tree.leaves();
    assert_eq!((leaves.len(), leaves[0].t0, leaves[1].t0), (2, 0.0, 0.5));
    let lengths = (leaves[0].polygon_length, leaves[0].chord_length);
    assert_eq!(lengths, (1.0 + 0.5_f64.sqrt(), 2.5_f64.sqrt()));
    // A straight curve is one leaf, and a point too.
    for straight in ["0 0, 1 1, 2 2", "5 5, 5 5, 5 5, 5 5"] {
        let tree = bezier(straight).subdivide(1e-9).expect("a tree");
        assert!(tree.halves.is_none());
        assert!(straight.starts_with('0') || tree.deviation_bound() == 0.0);
    }
}
