//! Arc lengths, compared with closed forms and an independent integral.

use crate::support::adversarial::{self, Kind, ORDINARY};
use crate::support::{Rng, bezier, cases, curve, integral, largest, near_at};
use crate::support::{random_points, real, to_3d, xy, xyz};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, MAX_COORDINATE, Point, Spline, take_steps};

pub(crate) fn length<P: Point>(curve: &Curve<P>) -> f64 {
    curve.length()
}

/// Asserts that two lengths agree to a relative error.
fn agree(got: f64, expected: f64, part: f64, what: impl std::fmt::Debug) {
    near_at(got, expected, part * expected.abs(), what);
}

#[test]
fn closed_forms() {
    // (t², t³) from −1 to 1, twice (13√13 − 8)/27.
    let cusp = 2.0 * (13.0 * 13_f64.sqrt() - 8.0) / 27.0;
    let third = "0.3333333333333333";
    for (points, expected, part) in [
        ("0 0, 3 4", 5.0, 0.0),
        ("0.1 0.1, 0.1 0.1, 0.1 0.1, 0.1 0.1", 0.0, 0.0),
        ("0 0, 0.5 1, 1 0", 1.478_942_857_544_597_5, 3e-16),
        // A turn-back: the curve runs forth and back again.
        ("1 3, 2 5, -9 -17", 22.733_357_771_247_864, 3e-16),
        ("0 0, 1 0, 0 0", 1.0, 1e-15),
        ("0 0, 1 0, 1 0, 0 0", 1.5, 1e-13),
        ("1 -1, -⅓ 1, -⅓ -1, 1 1", cusp, 1e-13),
        // The curve nearly stops at t = 0.58 and t = 0.77, where two levels of the integration agree by chance. The
        // length was integrated with 40 digits between the minima of the speed.
        (
            "-0.6701735937274308 -0.3743531619204457, -0.1988385135896993 0.153512660274498,
            0.25213331090990504 0.6588637712424616, -0.34352965965721705 -0.008339286447687966,
            0.06153840932269821 0.4454515716325279",
            1.1397560972614685,
            1e-13,
        ),
    ] {
        agree(
            length(&bezier(&points.replace('⅓', third))),
            expected,
            part,
            points,
        );
    }
}

/// A hostile curve in the plane or in space, mostly of low degree.
pub(crate) fn hostile(rng: &mut Rng, kinds: &[Kind]) -> Vec<DVec3> {
    let kind = rng.pick(kinds);
    let degree = if rng.chance(0.05) { 64 } else { 6 };
    let (degree, dimension) = (1 + rng.below(degree), 2 + rng.below(2));
    adversarial::points(rng, kind, degree, dimension)
}

#[test]
fn the_integral_of_the_speed() {
    let mut rng = Rng(1654);
    for _ in 0..cases(20_000, 150_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let expected = integral::length(&points, 0.0, 1.0);
        let flat = points.iter().all(|p| p.z == 0.0);
        let (plane, space) = (curve::<DVec2>(&points), curve::<DVec3>(&points));
        let got = if flat { length(&plane) } else { length(&space) };
        agree(got, expected, 1e-12, &points);
    }
}

#[test]
fn lengths_of_pieces_add_up() {
    let mut rng = Rng(1660);
    for _ in 0..cases(5_000, 50_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let curve: Curve<DVec3> = curve(&points);
        let whole = length(&curve);
        let (left, right) = curve.split(rng.unit());
        // Splitting rounds the control points by a few ulps of the largest coordinate: once for each step and each
        // piece.
        let slack = 1e-15 * (curve.degree() * curve.degree()) as f64 * largest(&points);
        let sum = length(&left) + length(&right);
        near_at(sum, whole, 1e-12 * whole + slack, &points);
        agree(length(&curve.reverse()), whole, 1e-12, &points);
    }
}

#[test]
fn a_tolerance_is_kept() {
    let mut rng = Rng(1659);
    for _ in 0..cases(5_000, 50_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let expected = integral::length(&points, 0.0, 1.0);
        let tolerance = expected * rng.magnitude(-15.0, 0.0);
        if let Ok(got) = curve::<DVec3>(&points).length_within(tolerance) {
            let slack = tolerance.max(1e-14 * expected);
            near_at(got, expected, slack, (tolerance, points));
        }
    }
}

#[test]
fn huge_and_tiny() {
    let mut rng = Rng(1661);
    for kind in [Kind::Huge, Kind::Tiny] {
        for (degree, dimension) in [1, 2, 3, 4, 9, 64]
            .into_iter()
            .flat_map(|n| [(n, 2), (n, 3)])
        {
            let points = adversarial::points(&mut rng, kind, degree, dimension);
            let size = if kind == Kind::Huge { 1e-300 } else { 1e300 };
            let unit: Vec<DVec3> = points.iter().map(|&p| p * size).collect();
            let got = length::<DVec3>(&curve(&points)) * size;
            agree(got, integral::length(&unit, 0.0, 1.0), 1e-12, &points);
            if dimension == 2 {
                let flat = length::<DVec2>(&curve(&points)) * size;
                agree(flat, got, 1e-12, &points);
            }
        }
    }
    let far = [(1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (0.0, 0.0)];
    let far = length(&Curve::new(&far.map(|p| DVec2::from(p) * MAX_COORDINATE)).expect("finite"));
    assert!(far > MAX_COORDINATE && far < 8.0 * MAX_COORDINATE);
    assert!(length(&bezier("0 0, 5e-324 0, 0 5e-324, 5e-324 5e-324")) <= 2e-323);
}

/// A nearly straight curve turns back on an interval so short that no quadrature has a node on it: at the start, where
/// the derivative is almost zero, or between two nodes.
#[test]
fn short_hooks_count() {
    let points = xyz(
        "0.005283409476472238 3.4415596864721716e-6 2.981413666217073e-11,
        0 1.9945282932347007e-6 0, 2.288882504181101e-6 -131228288205.83002 0,
        0 163344568710855.28 1495662883.3251665",
    );
    let hook = Curve::new(&points).expect("a curve");
    let (start, end) = hook.split(0.01);
    agree(
        length(&hook),
        length(&start) + length(&end),
        1e-12,
        "at the start",
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
        points.push(points[points.len() - 1] + DVec3::X * slope);
    }
    let line: Curve<DVec3> = curve(&points);
    let turns = line.extrema(0).expect("an axis");
    assert_eq!(turns.len(), 2);
    let [a, b, c, d] = [0.0, turns[0], turns[1], 1.0].map(|t| line.eval(t).x);
    agree(
        length(&line),
        (b - a) + (b - c) + (d - c),
        1e-12,
        "between nodes",
    );
    // The curve turns back next to its start, where the derivative is almost zero.
    let points = xy(
        "0 0, -9.958911800110698e-9 1, -2378.321009626822 -954636660740.4569,
        -2.8042010993724994e-7 1000000000000000",
    );
    let hook = Curve::new(&points).expect("a curve");
    let ts = hook.equidistant_times(10).expect("steps");
    let half = length(&hook.split(ts[5]).0);
    near_at(
        half,
        0.5 * length(&hook),
        1e-12 * length(&hook),
        "half of it",
    );
}

/// With the cumulative lengths, one segment answers for the whole spline, with the same bits.
#[test]
fn a_segment_answers_for_the_spline() {
    let mut rng = Rng(1913);
    for case in 0..60 {
        let (count, closed) = (3 * (1 + case % 20), case % 2 == 0);
        let points: Vec<DVec2> = random_points(&mut rng, count + usize::from(!closed));
        let spline = Spline::new(&points, 3, closed).expect("cubics");
        let ends = spline.cumulative_lengths();
        assert_eq!(ends.len(), spline.segment_count() + 1);
        let mut sum = 0.0;
        for (k, segment) in spline.segments().enumerate() {
            assert_eq!(ends[k], sum);
            let expected = integral::length(&to_3d(segment.control_points()), 0.0, 1.0);
            agree(ends[k + 1] - ends[k], expected, 1e-11, case);
            sum += length(&segment);
        }
        assert_eq!(spline.length(), ends[ends.len() - 1]);
        for i in 0..50 {
            let s = if i < ends.len() - 1 {
                ends[i]
            } else {
                sum * rng.unit()
            };
            let k = ends[1..].partition_point(|&end| end <= s);
            let segment = spline.segment(k).expect("s is on the spline");
            take_steps();
            let t = segment.time_at_length(s - ends[k]);
            // The work does not grow with the number of segments.
            let steps = take_steps();
            assert!(steps < 200, "{steps} intervals");
            assert_eq!(spline.time_at_length(s), real(k) + t);
        }
    }
    let point = Spline::new(&[DVec2::ONE; 7], 3, false).expect("a point");
    assert_eq!(point.cumulative_lengths(), [0.0; 3]);
}
