//! Arc lengths, compared with closed forms and an independent integral.

use crate::support::adversarial::{self, Kind, ORDINARY};
use crate::support::{Rng, cases, curve, integral, plane, real, to_3d};
use casteljau::glam::{DVec2, DVec3};
use casteljau::take_steps;
use casteljau::{Curve, MAX_COORDINATE, Point, Spline};

fn length<P: Point>(curve: &Curve<P>) -> f64 {
    curve.length(None).expect("no tolerance, no error")
}

fn agree(got: f64, expected: f64, part: f64, what: impl std::fmt::Debug) {
    let off = (got - expected).abs() / expected.abs().max(f64::MIN_POSITIVE);
    assert!(
        off <= part,
        "{got:e} instead of {expected:e}, {off:e} off: {what:?}"
    );
}

#[test]
fn closed_forms() {
    assert_eq!(length(&plane(&[(0., 0.), (3., 4.)])), 5.0);
    assert_eq!(length(&plane(&[(0.1, 0.1); 4])), 0.0);
    agree(
        length(&plane(&[(0., 0.), (0.5, 1.), (1., 0.)])),
        1.478_942_857_544_597_5,
        3e-16,
        "y = x²",
    );
    // A turn-back: the curve runs forth and back again.
    agree(
        length(&plane(&[(1., 3.), (2., 5.), (-9., -17.)])),
        22.733_357_771_247_864,
        3e-16,
        "turn-back",
    );
    agree(
        length(&plane(&[(0., 0.), (1., 0.), (0., 0.)])),
        1.0,
        1e-15,
        "there and back",
    );
    agree(
        length(&plane(&[(0., 0.), (1., 0.), (1., 0.), (0., 0.)])),
        1.5,
        1e-13,
        "there and back, cubic",
    );
    // A cusp: (t², t³) from −1 to 1, twice (13√13 − 8)/27.
    let cusp = [(1., -1.), (-1. / 3., 1.), (-1. / 3., -1.), (1., 1.)];
    agree(
        length(&plane(&cusp)),
        2.0 * (13.0 * 13_f64.sqrt() - 8.0) / 27.0,
        1e-13,
        "cusp",
    );
}

/// A hostile curve in the plane or in space, mostly of low degree.
pub(crate) fn hostile(rng: &mut Rng, kinds: &[Kind]) -> Vec<DVec3> {
    let kind = rng.pick(kinds);
    let degree = if rng.chance(0.05) {
        1 + rng.below(64)
    } else {
        1 + rng.below(6)
    };
    let dimension = 2 + rng.below(2);
    adversarial::points(rng, kind, degree, dimension)
}

#[test]
fn the_integral_of_the_speed() {
    let mut rng = Rng(1654);
    for _ in 0..cases(20_000, 300_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let expected = integral::length(&points, 0.0, 1.0);
        let flat = points.iter().all(|p| p.z == 0.0);
        let got = if flat {
            length::<DVec2>(&curve(&points))
        } else {
            length::<DVec3>(&curve(&points))
        };
        agree(got, expected, 1e-12, &points);
    }
}

#[test]
fn a_tolerance_is_kept() {
    let mut rng = Rng(1659);
    for _ in 0..cases(5_000, 200_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let curve: Curve<DVec3> = curve(&points);
        let expected = integral::length(&points, 0.0, 1.0);
        let tolerance = expected * rng.magnitude(-15.0, 0.0);
        if let Ok(got) = curve.length(Some(tolerance)) {
            let slack = tolerance.max(1e-14 * expected);
            assert!(
                (got - expected).abs() <= slack,
                "{got} instead of {expected} to {tolerance}: {points:?}"
            );
        }
    }
}

#[test]
fn lengths_of_pieces_add_up() {
    let mut rng = Rng(1660);
    for _ in 0..cases(5_000, 200_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let curve: Curve<DVec3> = curve(&points);
        let whole = length(&curve);
        let (left, right) = curve.split(rng.unit());
        // Splitting rounds the control points by a few ulps of the largest coordinate: once for each step and each
        // piece.
        let slack =
            1e-15 * (curve.degree() * curve.degree()) as f64 * crate::support::largest(&points);
        assert!(
            (length(&left) + length(&right) - whole).abs() <= 1e-12 * whole + slack,
            "{points:?}"
        );
        assert!(
            (length(&curve.reverse()) - whole).abs() <= 1e-12 * whole,
            "{points:?}"
        );
    }
}

#[test]
fn huge_and_tiny() {
    let mut rng = Rng(1661);
    for kind in [Kind::Huge, Kind::Tiny] {
        for degree in [1, 2, 3, 4, 9, 64] {
            for dimension in [2, 3] {
                let points = adversarial::points(&mut rng, kind, degree, dimension);
                let size = if kind == Kind::Huge { 1e-300 } else { 1e300 };
                let unit: Vec<DVec3> = points.iter().map(|&p| p * size).collect();
                let got = length::<DVec3>(&curve(&points)) * size;
                let (flat, expected) = (
                    length::<DVec2>(&curve(&points)) * size,
                    integral::length(&unit, 0.0, 1.0),
                );
                agree(got, expected, 1e-12, &points);
                assert!(
                    dimension == 3 || (flat - got).abs() <= 1e-12 * got,
                    "{points:?}"
                );
            }
        }
    }
    let far = plane(&[
        (MAX_COORDINATE, -MAX_COORDINATE),
        (-MAX_COORDINATE, MAX_COORDINATE),
        (MAX_COORDINATE, MAX_COORDINATE),
        (0.0, 1.0),
    ]);
    assert!(length(&far) > MAX_COORDINATE && length(&far) < 8.0 * MAX_COORDINATE);
    let min = plane(&[(0.0, 0.0), (5e-324, 0.0), (0.0, 5e-324), (5e-324, 5e-324)]);
    assert!(length(&min) <= 2e-323);
}

/// A nearly straight curve turns back on an interval so short that no quadrature has a node on it: at the start, where
/// the derivative is almost zero, or between two nodes.
#[test]
fn short_hooks_count() {
    let at_the_start = [
        (
            0.005283409476472238,
            3.4415596864721716e-6,
            2.981413666217073e-11,
        ),
        (0.0, 1.9945282932347007e-6, 0.0),
        (2.288882504181101e-6, -131228288205.83002, 0.0),
        (0.0, 163344568710855.28, 1495662883.3251665),
    ];
    let points = at_the_start.map(DVec3::from);
    let (start, end) = Curve::new(&points).expect("a curve").split(0.01);
    agree(
        length(&Curve::new(&points).expect("a curve")),
        length(&start) + length(&end),
        1e-12,
        "a hook at the start",
    );
    // x on a line turns back at t = 0.1859 and t = 0.2.
    let slopes = [
        0.0638464425235657,
        -0.147838538438109,
        0.117486481885397,
        1.60023974077283,
    ];
    let mut points = vec![DVec3::ZERO];
    for slope in slopes {
        points.push(points[points.len() - 1] + DVec3::new(slope, 0.0, 0.0));
    }
    let line: Curve<DVec3> = curve(&points);
    let turns = line.extrema(0).expect("an axis");
    assert_eq!(turns.len(), 2);
    let [a, b, c, d] = [0.0, turns[0], turns[1], 1.0].map(|t| line.eval(t).x);
    agree(
        length(&line),
        (b - a) + (b - c) + (d - c),
        1e-12,
        "a hook between nodes",
    );
}

/// With the cumulative lengths, one segment answers for the whole spline, with the same bits.
#[test]
fn a_segment_answers_for_the_spline() {
    let mut rng = Rng(1913);
    for case in 0..60 {
        let points: Vec<DVec2> = (0..=3 * (1 + case % 20))
            .map(|_| rng.point(2).truncate())
            .collect();
        let closed = case % 2 == 0;
        let points = if closed { &points[1..] } else { &points[..] };
        let spline = Spline::new(points, 3, closed).expect("cubics");
        let ends = spline.cumulative_lengths();
        assert_eq!(ends.len(), spline.segment_count() + 1);
        let mut sum = 0.0;
        for (k, segment) in spline.segments().enumerate() {
            assert_eq!(ends[k], sum);
            let expected = integral::length(&to_3d(segment.control_points()), 0.0, 1.0);
            agree(ends[k + 1] - ends[k], expected, 1e-11, case);
            sum += segment.length(None).expect("no tolerance");
        }
        assert_eq!(
            ends.last(),
            Some(&spline.length(None).expect("no tolerance"))
        );
        for i in 0..50 {
            let s = if i < ends.len() - 1 {
                ends[i]
            } else {
                sum * rng.unit()
            };
            let k = ends[1..].partition_point(|&end| end <= s);
            let segment = spline.segment(k).expect("s is on the spline");
            let (segment_t, steps) = {
                take_steps();
                let t = segment.time_at_length(s - ends[k], None).expect("finite");
                (t, take_steps())
            };
            assert_eq!(spline.time_at_length(s, None), Ok(real(k) + segment_t));
            // The work does not grow with the number of segments.
            assert!(steps < 200, "{steps} intervals");
        }
    }
    let point = Spline::new(&[DVec2::ONE; 7], 3, false).expect("a point");
    assert_eq!(point.cumulative_lengths(), [0.0; 3]);
}

/// The curve nearly stops at t = 0.58 and t = 0.77, where two levels of the integration agree by chance. The length was
/// integrated with 40 digits between the minima of the speed.
#[test]
fn near_cusps() {
    let points = [
        (-0.6701735937274308, -0.3743531619204457),
        (-0.1988385135896993, 0.153512660274498),
        (0.25213331090990504, 0.6588637712424616),
        (-0.34352965965721705, -0.008339286447687966),
        (0.06153840932269821, 0.4454515716325279),
    ];
    let curve = Curve::new(&points.map(DVec2::from)).expect("a curve");
    agree(length(&curve), 1.1397560972614685, 1e-13, "two near-cusps");
}
