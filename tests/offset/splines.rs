//! Offset curves of splines: corners, closed splines.

use crate::offset::reference::dense;
use crate::support::{Rng, near, random_points, real, spline};
use casteljau::Spline;
use casteljau::glam::DVec2;
use casteljau::spline::Join;

fn closed_spline(rng: &mut Rng) -> Spline<DVec2> {
    let count = 3 * (1 + rng.below(5));
    let points: Vec<DVec2> = random_points(rng, count);
    let points: Vec<DVec2> = points.iter().map(|&p| p * 10.0).collect();
    Spline::new(&points, 3, true).expect("finite")
}

/// No point is nearer than requested by more than the tolerance unless it is trimmed: with round joins each point lies
/// at the distance from some point of the curve.
#[test]
fn round_joins_keep_the_distance() {
    let mut rng = Rng(29);
    for _ in 0..60 {
        let spline = closed_spline(&mut rng);
        let distance = rng.signed() * 3.0;
        let offset = spline.offset_within(distance, Join::Round, 1e-3);
        let offset = offset.expect("finite");
        assert!(offset.is_closed());
        let source = dense(&spline, 1e-5);
        for p in dense(&offset, 1e-2) {
            let distances = source.iter().map(|&q| (p - q).length());
            let nearest = distances.fold(f64::INFINITY, f64::min);
            assert!(nearest <= distance.abs() + 1e-2, "{nearest} for {distance}");
        }
    }
}

#[test]
fn smooth_joints_need_no_join() {
    let mut rng = Rng(31);
    for _ in 0..100 {
        let mut point = |k: usize| DVec2::new(real(k) * 3.0, rng.signed());
        let points = [point(0), point(1), point(2), point(3)];
        let whole = Spline::new(&points, 3, false).expect("finite");
        let cut = whole
            .insert(0.3)
            .and_then(|cut| cut.insert(1.5))
            .expect("inside");
        let [one, other] = [&cut, &whole].map(|spline| {
            spline
                .offset_within(0.2, Join::Round, 1e-3)
                .expect("finite")
        });
        near(one.eval(0.0), other.eval(0.0), 1e-14);
        let g1 = |k: usize| one.continuity_within(k, 1e-6).expect("a joint").g1;
        assert!((1..one.segment_count()).all(g1));
    }
}

#[test]
fn segments_without_a_length_are_left_out() {
    let offset = spline("0 0, 2 0, 2 0, 2 2", 1, false).offset_within(-1.0, Join::Miter, 0.01);
    assert_eq!(offset, Ok(spline("0 -1, 2 -1, 3 -1, 3 0, 3 2", 1, false)));
    let point = spline("1 1, 1 1, 1 1, 1 1", 3, false);
    assert_eq!(point.offset(1.0, Join::Round), Ok(point));
}
