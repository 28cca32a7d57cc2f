//! Offset curves: at the requested distance from the curve everywhere, without gaps.

mod corners;
mod lower;
mod narrow;
mod reference;
mod simplify;
mod splines;
mod strokes;
mod work;

use crate::support::adversarial;
use crate::support::threads::on_all;
use crate::support::{Rng, largest, ulp};
use casteljau::Curve;
use casteljau::glam::DVec2;
use reference::{DenseReference, dense};

/// The maximum distance of chords from their curves, in tolerances: at first, and if the result is in doubt.
const SAGS: [f64; 2] = [0.04, 0.002];

/// The distance of the offset from the reference, and of the reference from the offset, in tolerances.
fn error(curve: &Curve<DVec2>, distance: f64, tolerance: f64) -> f64 {
    let offset = curve.offset_within(distance, tolerance).expect("finite");
    let finite = offset.control_points().iter().all(|p| p.is_finite());
    assert!(finite, "{curve:?} at {distance}");
    let measure = |sag: f64| {
        let ours = dense(&offset, sag * tolerance);
        let enough = (1.0 - sag) * tolerance;
        let apart = |reference: DenseReference| {
            let there = reference.farthest(&ours, enough);
            let back = reference::farthest(&ours, &reference.vertices, enough);
            there.max(back) / tolerance
        };
        let all = DenseReference::all(curve.control_points(), distance, sag * tolerance);
        least(all.map(apart))
    };
    least(SAGS.into_iter().map(measure))
}

/// The minimum of some errors; stops at the first one within the tolerance.
fn least(errors: impl Iterator<Item = f64>) -> f64 {
    let mut min = f64::INFINITY;
    for error in errors {
        min = min.min(error);
        if min <= 1.0 {
            break;
        }
    }
    min
}

/// A few thousand, or a hundred thousand with CASTELJAU_DEEP.
fn cases() -> usize {
    crate::support::cases(8_000, 100_000)
}

#[test]
fn adversarial_curves() {
    let mut rng = Rng(1986);
    let cases = (0..cases()).map(|case| {
        let kind = rng.pick(&adversarial::ORDINARY);
        let degree = match rng.below(20) {
            0..14 => 3,
            14..17 => 1 + rng.below(3),
            17 => 1 + rng.below(7),
            _ => 1 + rng.below(20),
        };
        let points = adversarial::points(&mut rng, kind, degree, 2);
        let points: Vec<DVec2> = points.iter().map(|p| p.truncate()).collect();
        let size = largest(&points);
        let side = if rng.chance(0.5) { 1.0 } else { -1.0 };
        let distance = size * rng.magnitude(-3.0, 1.5) * side;
        let reach = size + distance.abs();
        let tolerance = (size * rng.magnitude(-4.0, -1.0)).max(64.0 * ulp(reach));
        (case, kind, points, distance, tolerance)
    });
    on_all(cases, |(case, kind, points, distance, tolerance)| {
        let curve = Curve::new(&points).expect("finite");
        if points.iter().all(|&p| p == points[0]) {
            let offset = curve.offset_within(distance, tolerance).expect("finite");
            assert!(offset.control_points().iter().all(|p| p.is_finite()));
            return;
        }
        let found = error(&curve, distance, tolerance);
        let what = format!("{case} {kind:?}, {curve:?} at {distance}, {tolerance}");
        assert!(found <= 1.0, "{found} tolerances: {what}");
    });
}

/// Distances next to a radius of curvature, where the offset has a cusp or almost one and the foot of a perpendicular is
/// not determined by the first derivative.
#[test]
fn distances_next_to_a_radius_of_curvature() {
    let mut rng = Rng(2022);
    let cases = (0..cases() / 4).map(|case| {
        let points = [(); 4].map(|()| DVec2::new(rng.signed(), rng.signed()));
        let curve = Curve::new(&points).expect("finite");
        let radius = 1.0 / curve.curvature(rng.unit());
        let distance = radius * (1.0 + rng.signed() * rng.magnitude(-9.0, -1.0));
        let reach = 1.0 + distance.abs();
        let tolerance = rng.magnitude(-7.0, -1.0).max(64.0 * ulp(reach));
        (case, curve, distance, tolerance)
    });
    on_all(cases, |(case, curve, distance, tolerance)| {
        if distance.abs() > 30.0 {
            return;
        }
        let found = error(&curve, distance, tolerance);
        assert!(
            found <= 1.0,
            "{found} tolerances: {case} {curve:?} at {distance}, {tolerance}"
        );
    });
}

/// Almost a cusp at the start: the foot of a perpendicular may be many parts away, where a bound of one part says nothing.
#[test]
fn feet_far_away_prove_nothing() {
    let curve = Curve::new(&[
        DVec2::new(0.6509320390646245, -0.8577206577962122),
        DVec2::new(0.07479403842377463, -0.28605753994343974),
        DVec2::new(-0.5711409049282405, -0.3800446199259646),
        DVec2::new(-0.635390615107307, 0.39999368140976554),
    ]);
    let found = error(
        &curve.expect("finite"),
        1.9051521353270293,
        1.0636582474878334e-5,
    );
    assert!(found <= 1.0, "{found} tolerances");
}

/// Huge and tiny curves of any degree: the result consists of finite numbers and is returned in time.
#[test]
fn any_curve_has_an_offset() {
    let mut rng = Rng(1999);
    for _ in 0..500 {
        let kind = rng.pick(&adversarial::ALL);
        let cubic = rng.chance(0.8);
        let degree = if cubic { 3 } else { 1 + rng.below(12) };
        let points = adversarial::points(&mut rng, kind, degree, 2);
        let points: Vec<DVec2> = points.iter().map(|p| p.truncate()).collect();
        let curve = Curve::new(&points).expect("finite");
        let max = if kind == adversarial::Kind::Huge {
            1.0
        } else {
            3.0
        };
        let distance = largest(&points) * rng.signed() * rng.magnitude(-9.0, max);
        let offset = curve.offset(distance).expect("finite");
        let finite = offset.control_points().iter().all(|p| p.is_finite());
        let valid = finite && offset.segment_count() < 20_000;
        assert!(valid, "{curve:?} at {distance}");
    }
}

/// A power of two scales a curve and its offset exactly, also where products of coordinates underflow.
#[test]
fn the_cusp_of_a_tiny_curve() {
    let cusp = [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)].map(DVec2::from);
    let offset = |scale: f64| {
        let curve = Curve::new(&cusp.map(|p| p * scale)).expect("finite");
        let offset = curve.offset_within(0.1 * scale, 1e-4 * scale);
        offset.expect("a distance").control_points().to_vec()
    };
    let scale = 2.0_f64.powi(-700);
    let expected: Vec<DVec2> = offset(1.0).iter().map(|&p| p * scale).collect();
    assert_eq!(offset(scale), expected);
}
