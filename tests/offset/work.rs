//! The number of pieces and of counted steps, near cusps and where rounding limits the accuracy.

use crate::support::{Rng, bezier, real, xy};
use casteljau::glam::DVec2;
use casteljau::take_steps;
use casteljau::{Curve, Path, Spline};

/// The number of pieces and steps of an offset.
fn work(curve: &Curve<DVec2>, distance: f64, tolerance: f64) -> (usize, usize) {
    take_steps();
    let offset = curve
        .offset_within(distance, tolerance)
        .expect("within the limit");
    (offset.segment_count(), take_steps())
}

/// A hairpin whose offset has two cusps, and a cubic with coincident inner points: both once needed tens of thousands
/// of pieces.
fn near_cusps() -> [(Curve<DVec2>, f64); 2] {
    let hairpin = bezier(
        "-0.8577531296914089 0.6438049785920001, -0.14223131064801486 -0.34325283387918715,
         -0.7144329164604308 0.492865236303232, -0.11020866484004865 0.49536657922761274",
    );
    let coincident = bezier(
        "0.9619108050592042 0.41810328327357693, 0.2821937590016306 -0.8900749608524985,
         0.2821937590016306 -0.8900749608524985, 0.3098865254049781 -0.9153945771148642",
    );
    [
        (hairpin, 1.6325302658260954),
        (coincident, 0.03865658101079753),
    ]
}

/// The error of a fitted piece falls with the sixth power of its length: a tenth of the tolerance needs 10^(1/6) = 1.47
/// times the pieces.
#[test]
fn pieces_grow_slowly_with_the_accuracy() {
    for (curve, distance) in near_cusps() {
        let mut last = usize::MAX;
        for exponent in 3..=12 {
            let (pieces, steps) = work(&curve, distance, 10_f64.powi(-exponent));
            let few = pieces <= last.saturating_mul(2);
            assert!(few, "1e-{exponent}: {pieces} after {last}");
            let what = format!("1e-{exponent}: {steps} steps, {pieces} pieces");
            assert!(steps <= 100 * pieces, "{what}");
            last = pieces;
        }
        assert!(last <= 500, "{last}");
    }
}

/// Curves with points that are equal, nearly equal or of very different sizes, at tolerances near the smallest that is
/// allowed.
#[test]
fn mixed_scales_need_few_pieces() {
    let repeated =
        "-0.49 -0.62, -0.49 -0.62, -0.49 -0.62, -0.49 -0.62, -0.75 0.08, 0.39 0.11, 0.51 -0.94";
    let tiny_handles = "-1.132398445315094 1.8387921041823166e-25,
        -4.557689302309338e-21 -5.148304251235427e-13, 2.955723837548799e-24 -3.0423548035683763e-24,
        4.001423486722954e-22 -3.0035984102481294e-17";
    let xs = [0.21, 0.46, -0.11, -0.04, 0.28, 0.12, 0.9, 0.3, 0.7, 0.5];
    let beside = |i: usize| DVec2::new(xs[i], -0.69 - 0.02 * xs[i] + 1e-15 * real(i % 3));
    let collinear: Vec<DVec2> = (0..xs.len()).map(beside).collect();
    let cases = [
        (xy(repeated), 1.08),
        (xy(tiny_handles), 0.74),
        (collinear, 1.1e-3),
    ];
    for (points, distance) in cases {
        let curve = Curve::new(&points).expect("finite");
        let (pieces, steps) = work(&curve, distance, 1e-10);
        assert!(pieces <= 400, "{pieces} pieces of {points:?}");
        assert!(steps <= 100 * pieces, "{steps} steps of {points:?}");
    }
}

/// A position that is recorded while it stands still: all points are within the arms of corners.
#[test]
fn simplifying_points_in_a_small_disc_takes_few_steps() {
    let steps = |count: usize| {
        let mut rng = Rng(3);
        let points: Vec<DVec2> = (0..count)
            .map(|_| DVec2::from_angle(7.0 * rng.unit()) * (0.5 * rng.unit()))
            .collect();
        let line = Path::from(Spline::new(&points, 1, false).expect("finite points"));
        take_steps();
        let _ = line.simplify(1.0).expect("a tolerance");
        take_steps()
    };
    let (few, many) = (steps(2_000), steps(16_000));
    assert!(many < 12 * few, "{few} and {many} steps");
}
