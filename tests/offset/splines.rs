//! Offset curves of splines: corners, closed splines.

use crate::offset::reference::dense;
use crate::support::{Rng, real};
use casteljau::Spline;
use casteljau::glam::DVec2;
use casteljau::spline::OffsetJoin;

fn closed_spline(rng: &mut Rng) -> Spline<DVec2> {
    let count = 3 * (1 + rng.below(5));
    let points: Vec<DVec2> = (0..count).map(|_| rng.point(2).truncate() * 10.0).collect();
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
        let offset = spline
            .offset(distance, Some(1e-3), OffsetJoin::Round)
            .expect("finite");
        assert!(offset.is_closed());
        let source = dense(&spline, 1e-5);
        for p in dense(&offset, 1e-2) {
            let nearest = source
                .iter()
                .map(|&q| (p - q).length())
                .fold(f64::INFINITY, f64::min);
            assert!(nearest <= distance.abs() + 1e-2, "{nearest} for {distance}");
        }
    }
}

#[test]
fn smooth_joints_need_no_join() {
    let mut rng = Rng(31);
    for _ in 0..100 {
        let points: Vec<DVec2> = (0..4)
            .map(|k| DVec2::new(real(k) * 3.0, rng.signed()))
            .collect();
        let whole = Spline::new(&points, 3, false).expect("finite");
        let cut = whole
            .insert(0.3)
            .expect("inside")
            .insert(1.5)
            .expect("inside");
        let (d, tolerance) = (0.2, Some(1e-3));
        let one = cut.offset(d, tolerance, OffsetJoin::Round).expect("finite");
        assert!(
            (one.eval(0.0)
                - whole
                    .offset(d, tolerance, OffsetJoin::Round)
                    .expect("finite")
                    .eval(0.0))
            .length()
                < 1e-14
        );
        let count = one.segment_count();
        assert!((1..count).all(|k| one.continuity(k, Some(1e-6)).expect("a joint").g1));
    }
}

#[test]
fn segments_without_a_length_are_left_out() {
    let points = [(0.0, 0.0), (2.0, 0.0), (2.0, 0.0), (2.0, 2.0)].map(DVec2::from);
    let spline = Spline::new(&points, 1, false).expect("finite");
    let offset = spline
        .offset(-1.0, Some(0.01), OffsetJoin::Miter)
        .expect("finite");
    let expected = [
        (0.0, -1.0),
        (2.0, -1.0),
        (3.0, -1.0),
        (3.0, 0.0),
        (3.0, 2.0),
    ]
    .map(DVec2::from);
    assert_eq!(offset.control_points(), expected);
    let point = Spline::new(&[DVec2::ONE; 4], 3, false).expect("finite");
    assert_eq!(
        point.offset(1.0, None, OffsetJoin::Round).expect("finite"),
        point
    );
}
