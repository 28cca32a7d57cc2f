//! Tolerances that are rejected before any vertex is made.

use crate::support::{plane, ulp};
use casteljau::Error;
use casteljau::glam::DVec2;

#[test]
fn a_tolerance_is_a_finite_number_above_zero() {
    let curve = plane(&[(0.0, 0.0), (1.0, 2.0), (2.0, 0.0)]);
    for bad in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = curve.flatten(bad).expect_err("refused");
        assert!(
            matches!(
                error,
                Error::Range {
                    what: "tolerance",
                    ..
                }
            ),
            "{bad}: {error}"
        );
        assert!(
            error.to_string().starts_with("tolerance: expected "),
            "{error}"
        );
    }
}

#[test]
fn a_tolerance_below_4_ulps_of_the_largest_coordinate_is_refused_with_that_figure() {
    for size in [1.1, 1.5, 1e-300, 1e150, 12345.678] {
        let curve = plane(&[(0.0, 0.0), (size, 0.1 * size), (-0.3 * size, 0.0)]);
        let min = 4.0 * ulp(size);
        let got = min.next_down();
        assert_eq!(
            curve.flatten(got),
            Err(Error::Tolerance { min, got }),
            "{size}"
        );
        // A straight curve is flat at any tolerance that is accepted.
        let line = plane(&[(0.0, 0.0), (size, 0.0)]);
        assert_eq!(line.flatten(min).map(|line| line.ts.len()), Ok(2), "{size}");
    }
}

#[test]
fn more_than_2_to_the_24_vertices_are_refused_before_the_first() {
    let curve = plane(&[(0.0, 0.0), (1.0, 1.9), (1.9, 0.0)]);
    let limit = 1 << 24;
    let mut handed_out = 0;
    let refused = curve.flatten_with(4.0 * ulp(1.9), |_: f64, _: DVec2| handed_out += 1);
    assert!(
        matches!(refused, Err(Error::TooMany { limit: l, needed, .. }) if l == limit && needed > limit),
        "{refused:?}"
    );
    assert_eq!(handed_out, 0);
}

/// Wang's bound is far above the limit here, but the curve itself needs few chords.
#[test]
fn a_safe_bound_above_the_limit_is_no_reason_to_refuse() {
    let nearly_straight = plane(&[
        (0.0, 0.0),
        (1e6, 1e-3),
        (1e6, -1e-3),
        (0.0, 0.0),
        (1e6, 0.0),
    ]);
    let line = nearly_straight.flatten(1e-8).expect("few vertices");
    assert!(line.ts.len() < 10_000, "{}", line.ts.len());
}
