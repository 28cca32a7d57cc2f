//! Tolerances that are rejected before any vertex is made.

use crate::support::{bezier, refused, ulp};
use casteljau::glam::DVec2;
use casteljau::{Curve, Error};

#[test]
fn a_tolerance_is_a_finite_number_above_zero() {
    for bad in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let flat = bezier("0 0, 1 2, 2 0").flatten(bad);
        let message = flat.as_ref().expect_err("refused").to_string();
        assert!(message.starts_with("tolerance: expected "), "{message}");
        refused(flat, "Range tolerance");
    }
}

#[test]
fn a_tolerance_below_4_ulps_of_the_largest_coordinate_is_refused_with_that_figure() {
    for size in [1.1, 1.5, 1e-300, 1e150, 12345.678] {
        let [p1, p2] = [(1.0, 0.1), (-0.3, 0.0)].map(|p| DVec2::from(p) * size);
        let min = 4.0 * ulp(size);
        let got = min.next_down();
        let refused = Curve::quad(DVec2::ZERO, p1, p2).flatten(got);
        assert_eq!(refused, Err(Error::Tolerance { min, got }), "{size}");
        // A straight curve is flat at any tolerance that is accepted.
        let line = Curve::line(DVec2::ZERO, DVec2::X * size);
        assert_eq!(line.flatten(min).map(|line| line.ts.len()), Ok(2), "{size}");
    }
}

#[test]
fn more_than_2_to_the_24_vertices_are_refused_before_the_first() {
    let curve = bezier("0 0, 1 1.9, 1.9 0");
    let mut handed_out = 0;
    let many = curve.flatten_with(4.0 * ulp(1.9), |_: f64, _: DVec2| handed_out += 1);
    assert!(matches!(many, Err(Error::TooMany { limit, needed, .. }) if needed > limit));
    refused(many, "TooMany vertices 16777216");
    assert_eq!(handed_out, 0);
    // Wang's bound is far above the limit here, but the curve itself needs few chords.
    let nearly_straight = bezier("0 0, 1e6 1e-3, 1e6 -1e-3, 0 0, 1e6 0");
    let line = nearly_straight.flatten(1e-8).expect("few vertices");
    assert!(line.ts.len() < 10_000, "{}", line.ts.len());
}
