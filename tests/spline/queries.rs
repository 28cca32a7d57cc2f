//! Tangents and curvature of splines, and their parts.

use crate::spline::each_spline;
use crate::support::{near_at, real, spline};
use casteljau::glam::DVec2;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The usual approximation of a circle by four cubics, with |curvature − 1| < 0.022.
#[test]
fn a_circle_has_the_tangents_and_the_curvature_of_a_circle() {
    let c = 4.0 / 3.0 * (2_f64.sqrt() - 1.0);
    let right = format!("1 0, 1 {c}, {c} 1, 0 1, -{c} 1, -1 {c}");
    let circle = spline(
        &format!("{right}, -1 0, -1 -{c}, -{c} -1, 0 -1, {c} -1, 1 -{c}"),
        3,
        true,
    );
    for t in (0..=16).map(|i| real(i) / 4.0) {
        let p = circle.eval(t);
        near_at(circle.tangent(t), p.perp(), 5e-3, t);
        near_at(circle.normal(t), -p, 5e-3, t);
        near_at(circle.curvature(t), 1.0, 0.022, t);
    }
}

#[test]
fn parts_of_a_spline_are_the_same_curve() {
    each_spline(77, |spline, degrees| {
        let (n, count) = (degrees.len(), real(degrees.len()));
        for t in [0.0, 0.4, 1.0, count / 2.0, count - 0.75, count] {
            let (left, right) = spline.split(t);
            assert!(!left.is_closed() && !right.is_closed());
            let end = left.eval(real(left.segment_count()));
            assert_eq!((left.eval(0.0), right.eval(0.0)), (spline.eval(0.0), end));
            assert_eq!(right.eval(real(right.segment_count())), spline.eval(count));
            near_at(end, spline.eval(t), 1e-13, (t, degrees));
            let pieces = left.segment_count() + right.segment_count();
            let at_joint = t > 0.0 && t < count && t.fract() == 0.0;
            assert_eq!(pieces, n + usize::from(!at_joint), "{t} of {count}");
        }
        let parts = spline.split_at(&[count - 0.75, 0.2, count]);
        let ends = [0.0, 0.2, count - 0.75, count, count];
        for (part, pair) in parts.iter().zip(ends.windows(2)) {
            assert_eq!(part, &spline.subsegment(pair[0]..pair[1]), "{degrees:?}");
        }
        assert_eq!(parts.len(), 4);
        // Segments that are not cut keep their points.
        let part = spline.subsegment(0.25..count - 0.25);
        assert_eq!(part.segment_count(), n);
        assert!((1..n - 1).all(|k| part.segment(k) == spline.segment(k)));
        assert_eq!(part.eval(0.0), spline.eval(0.25));
        assert_eq!(part.eval(count), spline.eval(count - 0.25));
        assert_eq!(spline.subsegment(count - 0.25..0.25), part.reverse());
    });
}

#[test]
fn a_part_between_joints_has_no_empty_segment() {
    let square = spline("0 0, 1 0, 1 1, 0 1", 1, true);
    assert_eq!(
        square.subsegment(1.0..3.0),
        spline("1 0, 1 1, 0 1", 1, false)
    );
    let whole = spline("0 0, 1 0, 1 1, 0 1, 0 0", 1, false);
    assert_eq!(square.subsegment(0.0..4.0), whole);
    let point = square.subsegment(1.5..1.5);
    assert_eq!(point.control_points(), [DVec2::new(1.0, 0.5); 2]);
}

#[test]
fn extrema_lie_inside_segments_and_at_joints() {
    let lines = |text: &str, closed: bool| spline(text, 1, closed);
    for (what, spline, x, y) in [
        (
            "joints, not the ends",
            lines("0 0, 1 2, 2 -1, 3 -2, 2 5", false),
            vec![3.0],
            vec![1.0, 3.0],
        ),
        (
            "the inside of segments",
            spline("0 0, 1 2, 2 0, 3 2, 4 0", 2, false),
            vec![],
            vec![0.5, 1.0, 1.5],
        ),
        (
            "both joints of a constant part",
            lines("0 0, 1 1, 2 1, 3 0", false),
            vec![],
            vec![1.0, 2.0],
        ),
        (
            "two rises",
            lines("0 0, 1 1, 2 1, 3 2", false),
            vec![],
            vec![],
        ),
        (
            "a constant coordinate",
            lines("0 0, 1 0, 2 0", true),
            vec![0.0, 2.0],
            vec![],
        ),
        (
            "a constant part with the start",
            lines("1 0, 2 0, 2 3, 0 3, 0 0", true),
            vec![1.0, 2.0, 3.0, 4.0],
            vec![0.0, 1.0, 2.0, 3.0, 4.0],
        ),
    ] {
        assert_eq!(spline.extrema(0), Ok(x), "{what}");
        assert_eq!(spline.extrema(1), Ok(y), "{what}");
    }
}

#[test]
fn times_at_a_coordinate_name_joints_once() {
    let square = spline("0 0, 4 0, 4 4, 0 4", 1, true);
    assert_eq!(square.times_at_coordinate(0, 1.0), Ok(vec![0.25, 2.75]));
    // The whole last segment has the value 0, the start is the end.
    assert_eq!(square.times_at_coordinate(0, 0.0), Ok(vec![0.0, 3.0]));
    assert_eq!(square.times_at_coordinate(1, 4.0), Ok(vec![2.0, 3.0]));
}

#[test]
fn a_point_at_a_length_has_both_directions() {
    each_spline(78, |spline, degrees| {
        let s = 0.6 * spline.length();
        let found = spline.point_at_length(s);
        assert_eq!(found.t, spline.time_at_length(s));
        assert_eq!(found.point, spline.eval(found.t));
        near_at(found.tangent.dot(found.normal), 0.0, 1e-15, degrees);
        let curve = spline.segment(0).expect("a segment");
        assert_eq!(curve.point_at_length(-1.0).point, curve.start());
    });
}
