//! Derivatives, tangents and curvature of splines, and their parts.

use crate::spline::{STRUCTURES, plane, random};
use crate::support::{Rng, real};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Spline};
use wasm_bindgen_test::wasm_bindgen_test;

/// Calls `check` with splines of several structures and their segments.
fn each_spline(mut check: impl FnMut(&Spline<DVec3>, &[Curve<DVec3>])) {
    let mut rng = Rng(77);
    for degrees in STRUCTURES {
        for closed in [false, true] {
            let spline = random(&mut rng, degrees, closed);
            let segments: Vec<_> = spline.segments().collect();
            check(&spline, &segments);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn queries_are_those_of_the_segment_of_t() {
    each_spline(|spline, segments| {
        for (k, segment) in segments.iter().enumerate() {
            let t = real(k) + 0.25;
            assert_eq!(spline.derivative_at(t, 1), segment.derivative_at(0.25, 1));
            assert_eq!(spline.derivative_at(t, 2), segment.derivative_at(0.25, 2));
            assert_eq!(spline.tangent(t), segment.tangent(0.25));
            assert_eq!(spline.normal(t), segment.normal(0.25));
            assert_eq!(
                spline.curvature(t).to_bits(),
                segment.curvature(0.25).to_bits()
            );
            assert_eq!(spline.torsion(t).to_bits(), segment.torsion(0.25).to_bits());
            assert_eq!(spline.tangent(real(k)), segment.tangent(0.0));
        }
        let (count, last) = (segments.len(), &segments[segments.len() - 1]);
        assert_eq!(spline.tangent(real(count)), last.tangent(1.0));
    });
}

/// Four cubics with |curvature − 1| < 0.022: the usual approximation of a circle.
fn circle() -> Spline<DVec2> {
    let c = 4.0 / 3.0 * (2_f64.sqrt() - 1.0);
    let quarter = [(1.0, 0.0), (1.0, c), (c, 1.0)];
    let turned = |(x, y): (f64, f64), k: usize| [(x, y), (-y, x), (-x, -y), (y, -x)][k];
    let points: Vec<_> = (0..4).flat_map(|k| quarter.map(|p| turned(p, k))).collect();
    plane(&points, 3, true)
}

#[wasm_bindgen_test(unsupported = test)]
fn a_circle_has_the_tangents_and_the_curvature_of_a_circle() {
    let circle = circle();
    for i in 0..=16 {
        let t = real(i) / 4.0;
        let (p, tangent, normal) = (circle.eval(t), circle.tangent(t), circle.normal(t));
        assert!((tangent - p.perp()).length() < 5e-3, "{t}: {tangent}");
        assert!((normal + p).length() < 5e-3, "{t}: {normal}");
        assert!((circle.curvature(t) - 1.0).abs() < 0.022, "{t}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn parts_of_a_spline_are_the_same_curve() {
    each_spline(|spline, segments| {
        let count = real(segments.len());
        for t in [0.0, 0.4, 1.0, count / 2.0, count - 0.75, count] {
            let (left, right) = spline.split(t);
            assert!(!left.is_closed() && !right.is_closed());
            assert_eq!(left.eval(0.0), spline.eval(0.0));
            assert_eq!(
                right.control_points()[0],
                left.eval(real(left.segment_count()))
            );
            let end = right.eval(real(right.segment_count()));
            assert_eq!(end, spline.eval(count));
            let joint = left.eval(real(left.segment_count()));
            assert!((joint - spline.eval(t)).length() < 1e-13, "{t} of {count}");
            let pieces = left.segment_count() + right.segment_count();
            let inside = t > 0.0 && t < count && t.fract() == 0.0;
            assert_eq!(
                pieces,
                segments.len() + usize::from(!inside),
                "{t} of {count}"
            );
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn untouched_segments_of_a_part_keep_their_points() {
    each_spline(|spline, segments| {
        let count = segments.len();
        let part = spline.subsegment(0.25, real(count) - 0.25);
        assert_eq!(part.segment_count(), count);
        let same = part
            .segments()
            .zip(segments)
            .skip(1)
            .take(count.saturating_sub(2));
        for (a, b) in same {
            assert_eq!(a, *b);
        }
        assert_eq!(part.eval(0.0), spline.eval(0.25));
        assert_eq!(part.eval(real(count)), spline.eval(real(count) - 0.25));
        assert_eq!(spline.subsegment(real(count) - 0.25, 0.25), part.reverse());
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn a_part_between_joints_has_no_empty_segment() {
    let spline = plane(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], 1, true);
    let part = spline.subsegment(1.0, 3.0);
    assert_eq!(part.segment_count(), 2);
    assert_eq!(part.control_points(), &spline.control_points()[1..]);
    let all = spline.subsegment(0.0, 4.0);
    assert_eq!((all.segment_count(), all.is_closed()), (4, false));
    let point = spline.subsegment(1.5, 1.5);
    assert_eq!(point.control_points(), [DVec2::new(1.0, 0.5); 2]);
}

#[wasm_bindgen_test(unsupported = test)]
fn segments_run_forward_and_backward() {
    each_spline(|spline, segments| {
        assert_eq!(spline.segments().len(), segments.len());
        let back: Vec<_> = spline.segments().rev().collect();
        assert!(back.iter().rev().eq(segments));
    });
}
