//! Torsion and frames, compared with closed forms and the differential equation of a rotation-minimising frame.

use crate::support::adversarial::{self, ALL, ORDINARY};
use crate::support::{Rng, cases, curve, integral, plane, real};
use casteljau::curve::Frame;
use casteljau::glam::{DAffine3, DQuat, DVec3};
use casteljau::spline::Interpolation;
use casteljau::{Curve, Error, Spline};

/// The Bézier points of Σ cₖ tᵏ.
fn from_powers(powers: &[DVec3]) -> Curve<DVec3> {
    let n = powers.len() - 1;
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * real(n - i) / real(i + 1));
    let point = |i: usize| {
        (0..=i)
            .map(|k| powers[k] * (binomial(i, k) / binomial(n, k)))
            .sum()
    };
    Curve::new(&(0..=n).map(point).collect::<Vec<_>>()).expect("finite")
}

fn twisted() -> Curve<DVec3> {
    from_powers(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z])
}

/// One turn of the helix (cos, sin, c·t) by its Taylor series, accurate to 10⁻¹⁵.
fn helix(pitch: f64) -> Curve<DVec3> {
    let mut term = 1.0;
    let powers: Vec<DVec3> = (0..=24)
        .map(|k: usize| {
            if k > 0 {
                term /= real(k);
            }
            let [x, y] = [[1., 0.], [0., 1.], [-1., 0.], [0., -1.]][k % 4];
            DVec3::new(x * term, y * term, if k == 1 { pitch } else { 0.0 })
        })
        .collect();
    from_powers(&powers)
}

#[test]
fn torsion_has_closed_forms() {
    for i in 0..=10 {
        let t = real(i) / 10.0;
        let expected = 3.0 / (1.0 + 9.0 * t * t + 9.0 * t.powi(4));
        assert!((twisted().torsion(t) - expected).abs() < 1e-13 * expected);
        assert!((twisted().reverse().torsion(1.0 - t) - expected).abs() < 1e-13 * expected);
        let mirrored = twisted()
            .transform(&DAffine3::from_scale(DVec3::new(1.0, 1.0, -1.0)))
            .expect("a finite image");
        assert!((mirrored.torsion(t) + expected).abs() < 1e-13 * expected);
        let large = twisted()
            .transform(&DAffine3::from_scale(DVec3::splat(1e140)))
            .expect("a finite image");
        assert!((large.torsion(t) * 1e140 - expected).abs() < 1e-13 * expected);
        for pitch in [0.3, 1.0, -2.0] {
            let expected = pitch / (1.0 + pitch * pitch);
            assert!(
                (helix(pitch).torsion(t) - expected).abs() < 1e-10,
                "{t} {}",
                helix(pitch).torsion(t)
            );
        }
    }
}

#[test]
fn torsion_where_it_has_no_value_or_a_limit() {
    assert_eq!(
        plane(&[(0., 0.), (1., 2.), (3., 1.), (4., 4.)]).torsion(0.3),
        0.0
    );
    let flat = curve::<DVec3>(&[
        DVec3::ZERO,
        DVec3::X,
        DVec3::new(2., 1., 0.),
        DVec3::new(2., 3., 0.),
    ]);
    assert_eq!(flat.torsion(0.5), 0.0);
    assert_eq!(curve::<DVec3>(&[DVec3::ZERO, DVec3::ONE]).torsion(0.5), 0.0);
    assert_eq!(curve::<DVec3>(&[DVec3::ONE; 4]).torsion(0.5), 0.0);
    // (t, t³, t⁴): a limit at the inflection; by the formula 12·24 t² · … ∼ 2 · 1 at 0.
    let inflection = from_powers(&[DVec3::ZERO, DVec3::X, DVec3::ZERO, DVec3::Y, DVec3::Z]);
    let near = inflection.torsion(1e-5);
    assert!(
        (inflection.torsion(0.0) - near).abs() < 1e-6,
        "{} {near}",
        inflection.torsion(0.0)
    );
    // (t², t³, t⁴) has infinite torsion, (t², t³, t⁵) finite torsion.
    let sharp = from_powers(&[DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
    assert_eq!(sharp.torsion(0.0), f64::INFINITY);
    assert_eq!(
        sharp
            .transform(&DAffine3::from_scale(DVec3::new(1., 1., -1.)))
            .expect("a finite image")
            .torsion(0.0),
        f64::NEG_INFINITY
    );
    let smooth = from_powers(&[
        DVec3::ZERO,
        DVec3::ZERO,
        DVec3::X,
        DVec3::Y,
        DVec3::ZERO,
        DVec3::Z,
    ]);
    let near = smooth.torsion(1e-4);
    assert!(
        (smooth.torsion(0.0) - near).abs() < 1e-3 * near.abs(),
        "{} {near}",
        smooth.torsion(0.0)
    );
    let mut rng = Rng(1847);
    for kind in ALL {
        for degree in [1, 2, 3, 4, 6, 64] {
            let curve: Curve<DVec3> = curve(&adversarial::points(&mut rng, kind, degree, 3));
            for t in [0.0, 0.3, 1.0] {
                assert!(!curve.torsion(t).is_nan());
            }
        }
    }
}

fn orthonormal(frame: &Frame) {
    let Frame {
        tangent,
        normal,
        binormal,
        ..
    } = *frame;
    for v in [tangent, normal, binormal] {
        assert!((v.length() - 1.0).abs() < 1e-14, "{frame:?}");
    }
    for (u, v) in [(tangent, normal), (normal, binormal), (binormal, tangent)] {
        assert!(u.dot(v).abs() < 1e-14, "{frame:?}");
    }
    assert!((tangent.cross(normal) - binormal).length() < 1e-14);
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

#[test]
fn frames_do_not_twist() {
    let mut rng = Rng(2008);
    let mut curves = vec![twisted(), helix(0.5)];
    for degree in [2, 3, 3, 3, 4, 5, 9] {
        curves.push(curve(&adversarial::points(
            &mut rng,
            adversarial::Kind::Random,
            degree,
            3,
        )));
    }
    for curve in &curves {
        for segments in [1, 2, 10] {
            let frames = curve.frames(segments).expect("frames");
            assert_eq!(frames.len(), segments + 1);
            frames.iter().for_each(orthonormal);
            for pair in frames.windows(2) {
                let expected = without_twist(curve, pair[0].normal, pair[0].t, pair[1].t);
                let off = (pair[1].normal - expected).length();
                assert!(off < 1e-8, "{off:e} off, {segments} segments of {curve:?}");
            }
        }
    }
}

#[test]
fn plane_curves_keep_their_binormal() {
    // An arch, an S, a cusp, a zero-length handle, a loop and half of a turn-back, in a tilted plane.
    let shapes: [&[(f64, f64)]; 6] = [
        &[(0., 0.), (0., 2.), (2., 2.), (2., 0.)],
        &[(0., 0.), (2., 2.), (0., -2.), (2., 0.)],
        &[(0., 0.), (1., 1.), (0., 1.), (1., 0.)],
        &[(0., 0.), (0., 0.), (2., 2.), (2., 0.)],
        &[(0., 0.), (3., 2.), (-1., 2.), (2., 0.)],
        &[(1., -1.), (-1. / 3., 1.), (-1. / 3., -1.), (1., 1.)],
    ];
    let (u, v) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.0, 1.0, 0.0));
    for shape in shapes {
        let points: Vec<DVec3> = shape.iter().map(|&(x, y)| u * x + v * y).collect();
        let path: Curve<DVec3> = curve(&points);
        for segments in [1, 3, 10, 101] {
            let frames = path.frames(segments).expect("frames");
            frames.iter().for_each(orthonormal);
            let first = frames[0].binormal;
            for frame in &frames {
                assert!(
                    (frame.binormal - first).length() < 1e-8,
                    "{shape:?} {segments} at {}: {frame:?}",
                    frame.t
                );
            }
            assert!(first.cross(u.cross(v)).length() < 1e-12);
        }
        // A normal perpendicular to the plane stays constant.
        let up = u.cross(v);
        for frame in path
            .frames_at(&path.equidistant_times(20).expect("steps"), Some(up))
            .expect("frames")
        {
            assert!(
                (frame.normal - up).length() < 1e-8,
                "{shape:?} at {}: {frame:?}",
                frame.t
            );
        }
    }
}

#[test]
fn straight_pieces_change_nothing() {
    let line = curve::<DVec3>(&[DVec3::ZERO, DVec3::new(1., 2., 2.)]);
    let frames = line.frames(4).expect("frames");
    frames.iter().for_each(orthonormal);
    assert!(
        frames
            .iter()
            .all(|frame| (frame.normal - frames[0].normal).length() < 1e-15)
    );
    // The curve runs forth and back: the normal stays, the binormal changes its sign.
    let back = curve::<DVec3>(&[DVec3::ZERO, DVec3::X * 2.0, DVec3::ZERO]);
    let frames = back
        .frames_at(&[0.0, 0.3, 0.7, 1.0], Some(DVec3::Z))
        .expect("frames");
    frames.iter().for_each(orthonormal);
    assert!(
        frames
            .iter()
            .all(|frame| (frame.normal - DVec3::Z).length() < 1e-12),
        "{frames:?}"
    );
    assert!((frames[3].tangent + DVec3::X).length() < 1e-12);
    let point = curve::<DVec3>(&[DVec3::ONE; 4]).frames(2).expect("frames");
    assert!(
        point
            .iter()
            .all(|f| f.tangent == DVec3::ZERO && f.normal == DVec3::ZERO && f.point == DVec3::ONE)
    );
}

#[test]
fn frames_of_hostile_curves() {
    let mut rng = Rng(2009);
    for case in 0..cases(2_000, 100_000) {
        let degree = if case % 50 == 0 { 64 } else { 1 + rng.below(6) };
        let kind = if case % 10 == 0 {
            rng.pick(&ALL)
        } else {
            rng.pick(&ORDINARY)
        };
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
    let corners = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(|(x, y)| DVec3::new(x, y, 0.0));
    let square = Spline::new(&corners, 1, true).expect("a square");
    let frames = square.frames(3).expect("frames");
    assert_eq!(frames.len(), 13);
    let up = square
        .frames_at(&[0.0, 0.5, 1.5, 2.0, 3.5, 4.0, 1.0], Some(DVec3::Z))
        .expect("frames");
    up.iter().chain(&frames).for_each(orthonormal);
    assert!(
        up.iter()
            .all(|frame| (frame.normal - DVec3::Z).length() < 1e-12),
        "{up:?}"
    );
    assert!((frames[3].tangent - DVec3::Y).length() < 1e-15 && frames[3].t == 1.0);
    // A smooth spline has the same frames as the single curve that it consists of.
    let whole = twisted();
    let (left, right) = whole.split(0.5);
    let halves = Spline::from_curves(&[left, right], false).expect("joined");
    let (a, b) = (
        whole.frames(8).expect("frames"),
        halves.frames(4).expect("frames"),
    );
    for (a, b) in a.iter().zip(&b) {
        assert!((a.normal - b.normal).length() < 1e-9 && (a.point - b.point).length() < 1e-15);
    }
    // A segment of length 0, at the start and in the middle.
    let degenerate = [
        [0., 0., 0.],
        [0., 0., 0.],
        [2., 0., 0.],
        [2., 0., 0.],
        [2., 2., 0.],
    ]
    .map(DVec3::from);
    let frames = Spline::new(&degenerate, 1, false)
        .expect("a spline")
        .frames_at(&[0.0, 1.0, 2.5, 3.5], Some(DVec3::Z));
    let frames = frames.expect("frames");
    frames[1..].iter().for_each(orthonormal);
    assert!(
        frames[1..].iter().all(|frame| frame.normal == DVec3::Z),
        "{frames:?}"
    );
}

#[test]
fn refusals() {
    let curve = twisted();
    assert!(matches!(curve.frames(0), Err(Error::Range { .. })));
    assert!(matches!(
        curve.frames(usize::MAX),
        Err(Error::TooMany { .. })
    ));
    assert!(matches!(
        curve.frames_at(&[0.0, f64::NAN], None),
        Err(Error::NotFinite {
            what: "ts",
            index: 1,
            ..
        })
    ));
    assert!(matches!(
        curve.frames_at(&[0.0], Some(DVec3::NAN)),
        Err(Error::NotFinite { what: "normal", .. })
    ));
    assert_eq!(curve.frames_at(&[], None), Ok(Vec::new()));
}

/// Smooth closed splines in space through random points.
fn closed_splines() -> impl Iterator<Item = Spline<DVec3>> {
    let mut rng = Rng(2024);
    (0..40).map(move |case| {
        let points: Vec<DVec3> = (0..3 + case % 9).map(|_| rng.point(3)).collect();
        let kind = if case % 2 == 0 {
            Interpolation::Natural
        } else {
            Interpolation::CatmullRom { alpha: 0.5 }
        };
        Spline::interpolate(&points, kind, true).expect("finite")
    })
}

#[test]
fn frames_of_closed_splines_close() {
    for spline in closed_splines() {
        for per_curve in [1, 3, 20] {
            let frames = spline.frames(per_curve).expect("frames");
            frames.iter().for_each(orthonormal);
            let (first, last) = (frames[0], frames[frames.len() - 1]);
            let off = (last.normal - first.normal)
                .length()
                .max((last.tangent - first.tangent).length());
            assert!(off < 1e-13, "{off:e}");
        }
    }
}

/// Where the start is a corner, the last frame is the first one after the smallest rotation between the tangents.
#[test]
fn frames_of_closed_polygons_close() {
    let mut rng = Rng(2025);
    for _ in 0..50 {
        let points: Vec<DVec3> = (0..3 + rng.below(5)).map(|_| rng.point(3)).collect();
        let frames = Spline::new(&points, 1, true)
            .expect("a polygon")
            .frames(2)
            .expect("frames");
        frames.iter().for_each(orthonormal);
        let (first, last) = (frames[0], frames[frames.len() - 1]);
        let turn = DQuat::from_rotation_arc(last.tangent, first.tangent);
        let off = (turn * last.normal - first.normal).length();
        assert!(off < 1e-12, "{off:e}");
    }
}

/// A closed spline as an open one has rotation-minimising frames; the frames of the closed one deviate from them by an
/// angle that is proportional to the arc length.
#[test]
fn the_closing_twist_is_even_along_the_length() {
    let mut twisted = 0;
    for spline in closed_splines() {
        let curves: Vec<Curve<DVec3>> = spline.segments().collect();
        let open = Spline::from_curves(&curves, false).expect("joined");
        let (a, b) = (open.frames(8).expect("few"), spline.frames(8).expect("few"));
        let length =
            |curve: usize, t: f64| integral::length(curves[curve].control_points(), 0.0, t);
        let whole: f64 = (0..curves.len()).map(|k| length(k, 1.0)).sum();
        let end = a[a.len() - 1];
        let total = end
            .normal
            .dot(b[b.len() - 1].normal)
            .clamp(-1.0, 1.0)
            .acos();
        twisted += usize::from(total > 0.3);
        let mut done = 0.0;
        for (i, (a, b)) in a.iter().zip(&b).enumerate() {
            let (k, rest) = (i / 8, real(i % 8) / 8.0);
            let s = done + if rest > 0.0 { length(k, rest) } else { 0.0 };
            let sine = a.normal.cross(b.normal).dot(a.tangent).abs();
            let angle = sine.atan2(a.normal.dot(b.normal));
            assert!(
                (angle - total * s / whole).abs() < 1e-6,
                "{i}: {angle} of {total}"
            );
            if i % 8 == 7 {
                done += length(k, 1.0);
            }
        }
    }
    assert!(twisted > 20, "{twisted}");
}

/// The tangent of a closed plane curve stays in the plane, so nothing twists.
#[test]
fn closed_plane_splines_keep_their_binormal() {
    let points = [(0., 0.), (3., 0.), (4., 2.), (1., 5.)].map(|(x, y)| DVec3::new(x, y, 1.0));
    let spline = Spline::interpolate(&points, Interpolation::Natural, true).expect("finite");
    for frame in spline
        .frames_at(&[0.0, 0.7, 2.5, 4.0], Some(DVec3::Z))
        .expect("few")
    {
        assert!((frame.normal - DVec3::Z).length() < 1e-9, "{frame:?}");
    }
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
        let curves: Vec<Curve<DVec3>> = spline.segments().collect();
        let open = Spline::from_curves(&curves, false).expect("joined");
        for frame in open.frames(5).expect("few") {
            assert_eq!(open.frames_at(&[frame.t], None).expect("one"), [frame]);
        }
    }
}
