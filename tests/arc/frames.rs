//! Torsion and frames, compared with closed forms and the differential equation of a rotation-minimising frame.

use crate::support::adversarial::{self, ALL, Kind, ORDINARY};
use crate::support::{Rng, bezier, binomial, cases, curve, integral, near, near_at};
use crate::support::{random_points, real, refused, xy, xyz};
use casteljau::curve::Frame;
use casteljau::glam::{DAffine3, DQuat, DVec3};
use casteljau::spline::Interpolation;
use casteljau::{Curve, Spline};

/// The Bézier points of Σ cₖ tᵏ.
fn from_powers(powers: &[DVec3]) -> Curve<DVec3> {
    let n = powers.len() - 1;
    let term = |i: usize, k: usize| powers[k] * (binomial(i, k) / binomial(n, k));
    let points: Vec<DVec3> = (0..=n).map(|i| (0..=i).map(|k| term(i, k)).sum()).collect();
    Curve::new(&points).expect("finite")
}

/// (t, t², t³).
fn twisted() -> Curve<DVec3> {
    from_powers(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z])
}

/// One turn of the helix (cos, sin, c·t) by its Taylor series, accurate to 10⁻¹⁵.
fn helix(pitch: f64) -> Curve<DVec3> {
    let mut term = 1.0;
    let mut powers = vec![DVec3::X];
    for k in 1..=24 {
        term /= real(k);
        powers.push([DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y][k % 4] * term);
    }
    powers[1].z = pitch;
    from_powers(&powers)
}

fn scaled(curve: &Curve<DVec3>, scale: DVec3) -> Curve<DVec3> {
    let map = DAffine3::from_scale(scale);
    curve.transform(&map).expect("a finite image")
}

const MIRROR: DVec3 = DVec3::new(1.0, 1.0, -1.0);

#[test]
fn torsion_has_closed_forms() {
    let (curve, mirrored) = (twisted(), scaled(&twisted(), MIRROR));
    let large = scaled(&curve, DVec3::splat(1e140));
    for t in (0..=10).map(|i| real(i) / 10.0) {
        let expected = 3.0 / (1.0 + 9.0 * t * t + 9.0 * t.powi(4));
        let max = 1e-13 * expected;
        near_at(curve.torsion(t), expected, max, t);
        near_at(curve.reverse().torsion(1.0 - t), expected, max, t);
        near_at(mirrored.torsion(t), -expected, max, t);
        near_at(large.torsion(t) * 1e140, expected, max, t);
        for pitch in [0.3, 1.0, -2.0] {
            let expected = pitch / (1.0 + pitch * pitch);
            near_at(helix(pitch).torsion(t), expected, 1e-10, (pitch, t));
        }
    }
}

#[test]
fn torsion_where_it_has_no_value_or_a_limit() {
    assert_eq!(bezier("0 0, 1 2, 3 1, 4 4").torsion(0.3), 0.0);
    for flat in [
        "0 0 0, 1 0 0, 2 1 0, 2 3 0",
        "0 0 0, 1 1 1",
        "1 1 1, 1 1 1, 1 1 1, 1 1 1",
    ] {
        assert_eq!(curve::<DVec3>(&xyz(flat)).torsion(0.5), 0.0, "{flat}");
    }
    // (t, t³, t⁴): a limit at the inflection; by the formula 12·24 t² · … ∼ 2 · 1 at 0.
    let inflection = from_powers(&xyz("0 0 0, 1 0 0, 0 0 0, 0 1 0, 0 0 1"));
    near(inflection.torsion(0.0), inflection.torsion(1e-5), 1e-6);
    // (t², t³, t⁴) has infinite torsion, (t², t³, t⁵) finite torsion.
    let sharp = from_powers(&xyz("0 0 0, 0 0 0, 1 0 0, 0 1 0, 0 0 1"));
    assert_eq!(sharp.torsion(0.0), f64::INFINITY);
    assert_eq!(scaled(&sharp, MIRROR).torsion(0.0), f64::NEG_INFINITY);
    let smooth = from_powers(&xyz("0 0 0, 0 0 0, 1 0 0, 0 1 0, 0 0 0, 0 0 1"));
    let beside = smooth.torsion(1e-4);
    near(smooth.torsion(0.0), beside, 1e-3 * beside.abs());
    let mut rng = Rng(1847);
    for kind in ALL {
        for degree in [1, 2, 3, 4, 6, 64] {
            let curve: Curve<DVec3> = curve(&adversarial::points(&mut rng, kind, degree, 3));
            let valid = |&t: &f64| !curve.torsion(t).is_nan();
            assert!([0.0, 0.3, 1.0].iter().all(valid), "{curve:?}");
        }
    }
}

fn orthonormal(frame: &Frame) {
    let axes = [frame.tangent, frame.normal, frame.binormal];
    for k in 0..3 {
        near_at(axes[k].length(), 1.0, 1e-14, frame);
        near_at(axes[k].dot(axes[(k + 1) % 3]), 0.0, 1e-14, frame);
    }
    near_at(axes[0].cross(axes[1]), axes[2], 1e-14, frame);
}

/// N′ = −(N·T′) T by the Runge–Kutta method.
fn without_twist(curve: &Curve<DVec3>, mut normal: DVec3, lo: f64, hi: f64) -> DVec3 {
    let steps = 4000;
    let h = (hi - lo) / real(steps);
    let change = |t: f64, n: DVec3| {
        let (first, second) = (curve.derivative_at(t, 1), curve.derivative_at(t, 2));
        let (speed, tangent) = (first.length(), first.normalize());
        let turning = (second - tangent * tangent.dot(second)) / speed;
        tangent * -n.dot(turning)
    };
    for i in 0..steps {
        let t = lo + h * real(i);
        let a = change(t, normal);
        let b = change(t + h / 2.0, normal + a * (h / 2.0));
        let c = change(t + h / 2.0, normal + b * (h / 2.0));
        let d = change(t + h, normal + c * h);
        normal += (a + (b + c) * 2.0 + d) * (h / 6.0);
    }
    normal
}

fn frames(curve: &Curve<DVec3>, segments: usize) -> Vec<Frame> {
    let frames = curve.frames(segments).expect("frames");
    frames.iter().for_each(orthonormal);
    assert_eq!(frames.len(), segments + 1);
    frames
}

/// The frames at some parameters, from a normal in the direction of z.
fn upright(spline: &Spline<DVec3>, ts: &[f64]) -> Vec<Frame> {
    spline.frames_at(ts, Some(DVec3::Z)).expect("frames")
}

#[test]
fn frames_do_not_twist() {
    let mut rng = Rng(2008);
    let mut curves = vec![twisted(), helix(0.5)];
    for degree in [2, 3, 3, 3, 4, 5, 9] {
        let points = adversarial::points(&mut rng, adversarial::Kind::Random, degree, 3);
        curves.push(curve(&points));
    }
    for curve in &curves {
        for segments in [1, 2, 10] {
            for pair in frames(curve, segments).windows(2) {
                let expected = without_twist(curve, pair[0].normal, pair[0].t, pair[1].t);
                near_at(pair[1].normal, expected, 1e-8, (segments, curve));
            }
        }
    }
}

#[test]
fn plane_curves_keep_their_binormal() {
    // In a tilted plane.
    let (u, v) = (DVec3::new(0.6, 0.0, 0.8), DVec3::Y);
    let up = u.cross(v);
    for (name, shape) in [
        ("arch", "0 0, 0 2, 2 2, 2 0"),
        ("S", "0 0, 2 2, 0 -2, 2 0"),
        ("cusp", "0 0, 1 1, 0 1, 1 0"),
        ("handle of length zero", "0 0, 0 0, 2 2, 2 0"),
        ("loop", "0 0, 3 2, -1 2, 2 0"),
        (
            "(t², t³)",
            "1 -1, -0.3333333333333333 1, -0.3333333333333333 -1, 1 1",
        ),
    ] {
        let points: Vec<DVec3> = xy(shape).iter().map(|p| u * p.x + v * p.y).collect();
        let path: Curve<DVec3> = curve(&points);
        for segments in [1, 3, 10, 101] {
            let frames = frames(&path, segments);
            let first = frames[0].binormal;
            for frame in frames {
                near_at(frame.binormal, first, 1e-8, (name, segments, frame.t));
            }
            assert!(first.cross(up).length() < 1e-12);
        }
        // A normal perpendicular to the plane stays constant.
        let ts = path.equidistant_times(20).expect("steps");
        for frame in path.frames_at(&ts, Some(up)).expect("frames") {
            near_at(frame.normal, up, 1e-8, (name, frame.t));
        }
    }
}

#[test]
fn straight_pieces_change_nothing() {
    let frames = frames(&curve(&xyz("0 0 0, 1 2 2")), 4);
    frames
        .iter()
        .for_each(|f| near(f.normal, frames[0].normal, 1e-15));
    // The curve runs forth and back: the normal stays, the binormal changes its sign.
    let back = Spline::new(&xyz("0 0 0, 2 0 0, 0 0 0"), 2, false).expect("a spline");
    let frames = upright(&back, &[0.0, 0.3, 0.7, 1.0]);
    frames.iter().for_each(orthonormal);
    frames.iter().for_each(|f| near(f.normal, DVec3::Z, 1e-12));
    near(frames[3].tangent, -DVec3::X, 1e-12);
    let point = curve::<DVec3>(&[DVec3::ONE; 4]).frames(2).expect("frames");
    for f in point {
        assert_eq!(
            (f.tangent, f.normal, f.point),
            (DVec3::ZERO, DVec3::ZERO, DVec3::ONE)
        );
    }
}

#[test]
fn frames_of_hostile_curves() {
    let mut rng = Rng(2009);
    for case in 0..cases(2_000, 100_000) {
        let degree = if case % 50 == 0 { 64 } else { 1 + rng.below(6) };
        let kinds: &[Kind] = if case % 10 == 0 { &ALL } else { &ORDINARY };
        let kind = rng.pick(kinds);
        let curve: Curve<DVec3> = curve(&adversarial::points(&mut rng, kind, degree, 3));
        let frames = curve.frames(1 + rng.below(4)).expect("frames");
        if frames[0].tangent != DVec3::ZERO {
            frames.iter().for_each(orthonormal);
        }
    }
}

#[test]
fn splines_go_round_corners() {
    // Frames around an upright square: the upward normal stays upward.
    let square = Spline::new(&xyz("0 0 0, 2 0 0, 2 2 0, 0 2 0"), 1, true).expect("a square");
    let frames = square.frames(3).expect("frames");
    assert_eq!((frames.len(), frames[3].t), (13, 1.0));
    near(frames[3].tangent, DVec3::Y, 1e-15);
    let up = upright(&square, &[0.0, 0.5, 1.5, 2.0, 3.5, 4.0, 1.0]);
    up.iter().chain(&frames).for_each(orthonormal);
    up.iter().for_each(|f| near(f.normal, DVec3::Z, 1e-12));
    // A smooth spline has the same frames as the single curve that it consists of.
    let (left, right) = twisted().split(0.5);
    let halves = Spline::from_curves(&[left, right], false).expect("joined");
    let whole = twisted().frames(8).expect("frames");
    for (a, b) in whole.iter().zip(halves.frames(4).expect("frames")) {
        near(a.normal, b.normal, 1e-9);
        near(a.point, b.point, 1e-15);
    }
    // A segment of length 0, at the start and in the middle.
    let degenerate = xyz("0 0 0, 0 0 0, 2 0 0, 2 0 0, 2 2 0");
    let degenerate = Spline::new(&degenerate, 1, false).expect("a spline");
    for frame in &upright(&degenerate, &[0.0, 1.0, 2.5, 3.5])[1..] {
        orthonormal(frame);
        assert_eq!(frame.normal, DVec3::Z, "{frame:?}");
    }
    // The tangent of a closed plane curve stays in the plane, so nothing twists.
    let points = xyz("0 0 1, 3 0 1, 4 2 1, 1 5 1");
    let closed = Spline::interpolate(&points, Interpolation::Natural, true).expect("finite");
    let frames = upright(&closed, &[0.0, 0.7, 2.5, 4.0]);
    frames.iter().for_each(|f| near(f.normal, DVec3::Z, 1e-9));
}

#[test]
fn refusals() {
    let curve = twisted();
    refused(curve.frames(0), "Range segments");
    refused(curve.frames(usize::MAX), "TooMany segments 10324439");
    refused(curve.frames_at(&[0.0, f64::NAN], None), "NotFinite ts 1");
    refused(
        curve.frames_at(&[0.0], Some(DVec3::NAN)),
        "NotFinite normal 0",
    );
    assert_eq!(curve.frames_at(&[], None), Ok(Vec::new()));
}

/// Smooth closed splines in space through random points.
fn closed_splines() -> impl Iterator<Item = Spline<DVec3>> {
    let mut rng = Rng(2024);
    let kinds = [
        Interpolation::Natural,
        Interpolation::CatmullRom { alpha: 0.5 },
    ];
    (0..40).map(move |case| {
        let points: Vec<DVec3> = random_points(&mut rng, 3 + case % 9);
        Spline::interpolate(&points, kinds[case % 2], true).expect("finite")
    })
}

/// The same curve as an open spline.
fn opened(spline: &Spline<DVec3>) -> Spline<DVec3> {
    Spline::from_curves(&spline.segments().collect::<Vec<_>>(), false).expect("joined")
}

/// The first and the last of the orthonormal frames.
fn ends(spline: &Spline<DVec3>, per_curve: usize) -> (Frame, Frame) {
    let frames = spline.frames(per_curve).expect("frames");
    frames.iter().for_each(orthonormal);
    (frames[0], frames[frames.len() - 1])
}

#[test]
fn frames_of_closed_splines_close() {
    for spline in closed_splines() {
        for per_curve in [1, 3, 20] {
            let (first, last) = ends(&spline, per_curve);
            near(last.normal, first.normal, 1e-13);
            near(last.tangent, first.tangent, 1e-13);
        }
    }
    // Where the start is a corner, the last frame is the first one after the smallest rotation between the tangents.
    let mut rng = Rng(2025);
    for _ in 0..50 {
        let count = 3 + rng.below(5);
        let points: Vec<DVec3> = random_points(&mut rng, count);
        let (first, last) = ends(&Spline::new(&points, 1, true).expect("a polygon"), 2);
        let turn = DQuat::from_rotation_arc(last.tangent, first.tangent);
        near(turn * last.normal, first.normal, 1e-12);
    }
}

/// A closed spline as an open one has rotation-minimising frames; the frames of the closed one deviate from them by an
/// angle that is proportional to the arc length.
#[test]
fn the_closing_twist_is_even_along_the_length() {
    let mut twisted = 0;
    for spline in closed_splines() {
        let curves: Vec<Curve<DVec3>> = spline.segments().collect();
        let open = opened(&spline).frames(8).expect("few");
        let closed = spline.frames(8).expect("few");
        let length = |k: usize, t: f64| integral::length(curves[k].control_points(), 0.0, t);
        let whole: f64 = (0..curves.len()).map(|k| length(k, 1.0)).sum();
        let (a, b) = (open[open.len() - 1], closed[closed.len() - 1]);
        let total = a.normal.dot(b.normal).clamp(-1.0, 1.0).acos();
        twisted += usize::from(total > 0.3);
        let mut done = 0.0;
        for (i, (a, b)) in open.iter().zip(&closed).enumerate() {
            let (k, rest) = (i / 8, real(i % 8) / 8.0);
            let s = done + if rest > 0.0 { length(k, rest) } else { 0.0 };
            let sine = a.normal.cross(b.normal).dot(a.tangent).abs();
            let angle = sine.atan2(a.normal.dot(b.normal));
            near_at(angle, total * s / whole, 1e-6, (i, total));
            if i % 8 == 7 {
                done += length(k, 1.0);
            }
        }
    }
    assert!(twisted > 20, "{twisted}");
}

#[test]
fn a_frame_does_not_depend_on_the_other_parameters() {
    let whole = twisted();
    let mut frames = whole.frames(16).expect("few");
    for (i, frame) in frames.iter().enumerate() {
        let alone = whole.frames_at(&[real(i) / 16.0], None).expect("one");
        assert_eq!(alone, [*frame]);
    }
    frames.reverse();
    let ts: Vec<f64> = frames.iter().map(|frame| frame.t).collect();
    assert_eq!(whole.frames_at(&ts, None).expect("few"), frames);
    for spline in closed_splines() {
        let frames = spline.frames(5).expect("few");
        for frame in &frames {
            for ts in [&[frame.t][..], &[2.9, frame.t, 0.1]] {
                let found = spline.frames_at(ts, None).expect("few");
                assert_eq!(found[ts.len() / 2], *frame);
            }
        }
        let open = opened(&spline);
        for frame in open.frames(5).expect("few") {
            assert_eq!(open.frames_at(&[frame.t], None).expect("one"), [frame]);
        }
    }
}
