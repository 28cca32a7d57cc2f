//! Strokes whose width varies, judged by the discs around dense points of the path and by closed forms.

use crate::stroke::cases::{curves, hard, size};
use crate::support::paths::path;
use crate::support::{Rng, near, real};
use casteljau::glam::DVec2;
use casteljau::path::{
    FillRule, Join, StrokeCap, StrokeOptions, WidthInterpolation, WidthPosition, WidthProfile,
};
use casteljau::{Curve, Path, Spline};
use std::f64::consts::{PI, TAU};

const POINTS: usize = 60;

/// The centres and radii of the discs of an open path of one subpath, at dense parameters.
pub(super) struct Discs(pub(super) Vec<(DVec2, f64)>);

const STEPS: usize = 4_000;

/// The width of a profile, written again from its documentation.
pub(super) fn width(profile: &WidthProfile, position: f64) -> f64 {
    let stops = &profile.stops;
    let next = stops.iter().position(|stop| stop.0 > position);
    let k = match next {
        Some(0) => return stops[0].1,
        None => return stops[stops.len() - 1].1,
        Some(k) => k,
    };
    let ((a, from), (b, to)) = (stops[k - 1], stops[k]);
    let t = (position - a) / (b - a);
    if profile.interpolation == WidthInterpolation::Linear {
        return from + (to - from) * t;
    }
    let [before, after] = [k - 1, k].map(|k| slope(stops, k) * (b - a) / 3.0);
    let cubic = Curve::new(&[from, from + before, to - after, to].map(|y| DVec2::new(0.0, y)));
    cubic.expect("finite numbers").eval(t).y
}

/// The slope of a smooth profile at a stop: the weighted harmonic mean of Fritsch and Butland.
fn slope(stops: &[(f64, f64)], k: usize) -> f64 {
    let secant = |pair: &[(f64, f64)]| {
        let h = pair[1].0 - pair[0].0;
        (h, (pair[1].1 - pair[0].1) / h)
    };
    let is_end = [0.0, 1.0].contains(&stops[k].0);
    match (k.checked_sub(1), stops.get(k + 1)) {
        (None, None) => 0.0,
        (None, _) => f64::from(u8::from(is_end)) * secant(&stops[..2]).1,
        (Some(before), None) => f64::from(u8::from(is_end)) * secant(&stops[before..]).1,
        (Some(before), Some(_)) => {
            let ((g, p), (h, q)) = (secant(&stops[before..]), secant(&stops[k..]));
            let mean = 3.0 * (g + h) / ((2.0 * g + h) / q + (g + 2.0 * h) / p);
            if p * q > 0.0 { mean } else { 0.0 }
        }
    }
}

impl Discs {
    pub(super) fn new(path: &Path, profile: &WidthProfile) -> Self {
        let spline = path.subpath(0).expect("a subpath");
        let count = real(spline.segment_count());
        let mut ts: Vec<f64> = (0..=STEPS).map(|k| count * real(k) / real(STEPS)).collect();
        // Joints are corners, and the radius may change fast between stops.
        ts.extend((1..spline.segment_count()).map(real));
        let length = spline.length();
        let time = |position: f64| match profile.at {
            WidthPosition::T => position * count,
            _ => spline.time_at_length(position * length),
        };
        let between = |pair: &[(f64, f64)]| {
            let [from, to] = [pair[0].0, pair[1].0];
            (0..=100).map(move |k| from + (to - from) * real(k) / 100.0)
        };
        ts.extend(profile.stops.windows(2).flat_map(between).map(time));
        ts.sort_by(f64::total_cmp);
        let points: Vec<DVec2> = ts.iter().map(|&t| spline.eval(t)).collect();
        let mut lengths = vec![0.0];
        for pair in points.windows(2) {
            lengths.push(lengths[lengths.len() - 1] + pair[0].distance(pair[1]));
        }
        let whole = lengths[lengths.len() - 1];
        let position = |k: usize| match profile.at {
            WidthPosition::T => ts[k] / count,
            _ if whole == 0.0 => 0.0,
            _ => lengths[k] / whole,
        };
        let disc = |k: usize| (points[k], 0.5 * width(profile, position(k)));
        Self((0..ts.len()).map(disc).collect())
    }

    /// The distance of a point from the union of the discs and of the disks between neighbours; negative inside.
    pub(super) fn distance(&self, p: DVec2) -> f64 {
        let between = |pair: &[(DVec2, f64)]| {
            let [(a, r), (b, s)] = [pair[0], pair[1]];
            let chord = b - a;
            // The minimum of |p − c| − r along the chord: where the disc's tangent passes p.
            let length = chord.length();
            let mut t = (p - a).dot(chord) / chord.length_squared();
            let slope = (s - r) / length;
            if slope.abs() < 1.0 {
                let across = (p - a).perp_dot(chord).abs() / length;
                t += slope / (1.0 - slope * slope).sqrt() * across / length;
            }
            let t = if t > 0.0 { t.min(1.0) } else { 0.0 };
            let at = |t: f64| (p - a - chord * t).length() - r - (s - r) * t;
            at(t).min(at(0.0)).min(at(1.0))
        };
        self.0.windows(2).map(between).fold(f64::INFINITY, f64::min)
    }
}

fn round(tolerance: f64) -> StrokeOptions {
    StrokeOptions::new()
        .join(Join::Round)
        .cap(StrokeCap::Round)
        .tolerance(tolerance)
}

fn profile(width: f64, rng: &mut Rng) -> WidthProfile {
    let mut positions: Vec<f64> = (0..1 + rng.below(4)).map(|_| rng.unit()).collect();
    if rng.unit() < 0.5 {
        positions.extend([0.0, 1.0]);
    }
    positions.sort_by(f64::total_cmp);
    positions.dedup();
    let stop = |position| {
        let part = rng.unit();
        (position, if part < 0.25 { 0.0 } else { width * part })
    };
    let stops: Vec<(f64, f64)> = positions.into_iter().map(stop).collect();
    let at = if rng.unit() < 0.5 {
        WidthPosition::T
    } else {
        WidthPosition::Length
    };
    let interpolation = if rng.unit() < 0.5 {
        WidthInterpolation::Linear
    } else {
        WidthInterpolation::Smooth
    };
    WidthProfile::new(&stops)
        .at(at)
        .interpolation(interpolation)
}

fn found_in(path: &Path, p: DVec2, profile: &WidthProfile, options: &StrokeOptions) -> bool {
    path.stroke_contains_with(p, profile, options)
        .expect("few segments")
}

/// The samples that a stroke gets wrong, farther than the tolerance from its boundary.
pub(super) fn wrong(
    path: &Path,
    profile: &WidthProfile,
    tolerance: f64,
    rng: &mut Rng,
) -> Vec<String> {
    let options = round(tolerance);
    let simple = path.stroke_with(profile, &options).expect("few segments");
    let overlapping = path
        .stroke_with(profile, &options.clone().simple(false))
        .unwrap();
    let discs = Discs::new(path, profile);
    let mut wrong = Vec::new();
    let size = size(path);
    for k in 0..POINTS {
        let (center, radius) = discs.0[rng.below(STEPS)];
        let far = if k % 3 == 0 {
            radius * 2.0 * rng.unit()
        } else {
            radius + tolerance * rng.magnitude(0.0, 2.0) * rng.signed().signum()
        };
        let p = center + DVec2::from_angle(rng.unit() * TAU) * far;
        let distance = discs.distance(p);
        // The chords of the dense points are within 1e-6 of the curves here.
        if distance.abs() <= tolerance + 3e-6 * size {
            continue;
        }
        let winding = simple.winding_number(p);
        if (winding != 0) != (distance < 0.0) || !(0..=1).contains(&winding) {
            wrong.push(format!("at {p}: {winding}, distance {distance}"));
        }
        if k == 0 && found_in(path, p, profile, &options) != (winding != 0) {
            wrong.push(format!("stroke_contains_with at {p}"));
        }
        // Gaps inside are thinner than twice the tolerance.
        let is_near = |k: i32| {
            let by = DVec2::from_angle(TAU * f64::from(k) / 8.0) * tolerance;
            overlapping.contains(p + by, FillRule::NonZero)
        };
        let found =
            overlapping.contains(p, FillRule::NonZero) || distance < 0.0 && (0..8).any(is_near);
        if found != (distance < 0.0) {
            wrong.push(format!("overlapping at {p}, distance {distance}"));
        }
    }
    wrong
}

#[test]
fn outlines_are_the_union_of_all_discs() {
    let mut rng = Rng(11);
    let mut faults = Vec::new();
    let rounds = crate::support::cases(1, 200);
    for (name, path) in (0..rounds).flat_map(|_| curves()) {
        for part in [0.1, 0.5, 2.0] {
            let profile = profile(part * size(&path), &mut rng);
            let tolerance = rng.magnitude(-4.0, -1.0) * size(&path);
            let found = wrong(&path, &profile, tolerance, &mut rng);
            if let Some(first) = found.first() {
                let count = found.len();
                faults.push(format!(
                    "{name} {profile:?} {tolerance:e}: {count}, {first}"
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// Every point of the boundary is within the tolerance of the union of the discs, and of what is outside of it.
#[test]
fn boundaries_are_within_the_tolerance() {
    let mut rng = Rng(23);
    let mut faults = Vec::new();
    for case in 0..crate::support::cases(150, 6_000) {
        let closed = rng.unit() < 0.3;
        let count = 3 * (1 + rng.below(3)) + usize::from(!closed);
        let point = |_| DVec2::new(rng.signed(), rng.signed()) * 100.0;
        let points: Vec<DVec2> = (0..count).map(point).collect();
        let path = Path::from(Spline::new(&points, 3, closed).unwrap());
        let mut profile = profile(100.0 * rng.magnitude(-2.0, 0.0), &mut rng);
        if rng.unit() < 0.3 {
            profile = WidthProfile::constant(profile.stops[0].1);
        }
        let tolerance = rng.magnitude(-2.0, -0.5);
        let outline = path
            .stroke_with(&profile, &round(tolerance))
            .expect("few segments");
        let discs = Discs::new(&path, &profile);
        for p in outline
            .segments()
            .flat_map(|curve| (0..6).map(move |k| curve.eval(real(k) / 6.0 + 0.03)))
        {
            let distance = discs.distance(p);
            // The chords of the dense points are within 1e-3 of the curves here.
            if distance.abs() > tolerance + 1e-3 {
                faults.push(format!(
                    "{case}: {points:?} {profile:?} {tolerance:e}: {distance} at {p}"
                ));
                break;
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// The area of the union of two discs at a distance, neither in the other, and of all discs between them.
fn hull(r: f64, s: f64, distance: f64) -> f64 {
    let angle = ((r - s) / distance).acos();
    let side = (distance * distance - (r - s) * (r - s)).sqrt();
    (r + s) * side + r * r * (PI - angle) + s * s * angle
}

#[test]
fn cones_have_their_area() {
    let line = path("M1 2L7 10");
    let near_to = |outline: &Path, area: f64| near(outline.area(), area, 1e-6 * area);
    for (a, b) in [(1.0, 3.0), (4.0, 0.0), (2.0, 2.0)] {
        let profile = WidthProfile::new(&[(0.0, a), (1.0, b)]);
        let outline = line.stroke_with(&profile, &round(1e-9)).unwrap();
        near_to(&outline, hull(0.5 * a, 0.5 * b, 10.0));
        let butt = StrokeOptions::new();
        let outline = line.stroke_with(&profile, &butt).unwrap();
        // The discs touch their sides at r r′ before the ends, and r √(1 − r′²) beside the line.
        let slope: f64 = 0.05 * (b - a);
        let across = (1.0 - slope * slope).sqrt();
        let length = 10.0 - 0.5 * slope * (b - a);
        near_to(&outline, 0.5 * (a + b) * across * length);
        assert_eq!(outline.segment_count(), if b == 0.0 { 3 } else { 4 });
    }
    // The second disc contains the others.
    let profile = WidthProfile::new(&[(0.0, 2.0), (1.0, 60.0)]);
    let outline = line.stroke_with(&profile, &round(1e-9)).unwrap();
    near_to(&outline, PI * 900.0);
    // Both discs of a step at the start of a closed subpath: half of an annulus's inner and outer radius apart.
    let square = path("M0 0H10V10H0Z");
    let profile = WidthProfile::new(&[(0.0, 4.0), (1.0, 1.0)]);
    let outline = square.stroke_with(&profile, &round(1e-6)).unwrap();
    assert!(outline.contains(DVec2::new(-1.9, 0.0), FillRule::NonZero));
    assert!(!outline.contains(DVec2::new(-1.0, 9.0), FillRule::NonZero));
    assert_eq!(outline.subpath_count(), 2);
}

/// A constant profile is a stroke of constant width, for all joins and caps.
#[test]
fn constant_profiles_are_plain_strokes() {
    let mut rng = Rng(5);
    let mut faults = Vec::new();
    for (k, (name, curve)) in hard().enumerate() {
        let end = curve.segments().last().expect("a curve").end();
        let [a, b] =
            [DVec2::new(0.3, 0.1), DVec2::new(0.05, 0.5)].map(|by| end + by * size(&curve));
        let path = path(&format!("{curve} L{} {} L{} {}", a.x, a.y, b.x, b.y));
        let join = [Join::Miter, Join::Round, Join::Bevel][k % 3];
        for cap in [StrokeCap::Butt, StrokeCap::Round, StrokeCap::Square] {
            let tolerance = 1e-3 * size(&path);
            let options = StrokeOptions::new()
                .join(join)
                .cap(cap)
                .tolerance(tolerance);
            for part in [0.02, 0.5, 1.5] {
                let width = part * size(&path);
                let profile = WidthProfile::constant(width);
                let outline = path.stroke_with(&profile, &options).expect("few segments");
                for _ in 0..POINTS {
                    let p = path.subpath(0).unwrap().eval(rng.unit() * 3.0)
                        + DVec2::from_angle(rng.unit() * TAU) * (0.6 * width * rng.unit());
                    let contains =
                        |p, width| path.stroke_contains(p, width, &options).expect("finite");
                    let expected = contains(p, width);
                    let around = (0..12).all(|k| {
                        let by = DVec2::from_angle(TAU * f64::from(k) / 12.0) * 2.1 * tolerance;
                        contains(p + by, width) == expected
                    });
                    let wider = [-4.2, 4.2].map(|k| contains(p, (width + k * tolerance).max(0.0)));
                    if around
                        && wider == [expected; 2]
                        && outline.contains(p, FillRule::NonZero) != expected
                    {
                        faults.push(format!("{name} {part} {join:?} {cap:?}: {p} {expected}"));
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn dashes_have_the_widths_of_their_subpath() {
    let arch = path("M0 0C0 60 80 60 80 0");
    let options = round(1e-4);
    for at in [WidthPosition::Length, WidthPosition::T] {
        let profile = WidthProfile::new(&[(0.0, 2.0), (0.4, 10.0), (1.0, 4.0)]).at(at);
        let dashed = arch
            .stroke_with(&profile, &options.clone().dash(&[12.0, 15.0], 5.0))
            .unwrap();
        let discs = Discs::new(&arch, &profile);
        let length = arch.length();
        let mut rng = Rng(3);
        for _ in 0..400 {
            let s = rng.unit() * length;
            let point = arch.point_at_length(s).unwrap();
            let (time, center) = (point.t, point.point);
            let position = if at == WidthPosition::T {
                time.t
            } else {
                s / length
            };
            let radius = 0.5 * width(&profile, position);
            let on = (s + 5.0).rem_euclid(27.0) < 12.0;
            let normal = arch.normal(time).unwrap();
            if on {
                assert!(dashed.contains(center + normal * (0.98 * radius), FillRule::NonZero));
            }
            let beyond = center + normal * (1.05 * radius + 1e-3);
            if discs.distance(beyond) > 1e-3 {
                assert!(!dashed.contains(beyond, FillRule::NonZero));
            }
        }
        let dashes = arch.dash(&[12.0, 15.0], 5.0).unwrap();
        assert_eq!(dashed.subpath_count(), dashes.subpath_count());
    }
    // A dash that passes the start of a closed subpath, with the same width on both sides of it.
    let circle = Path::circle(DVec2::ZERO, 10.0).unwrap();
    let profile = WidthProfile::new(&[(0.0, 4.0), (0.5, 1.0), (1.0, 4.0)]);
    let dashed = circle
        .stroke_with(&profile, &options.dash(&[TAU * 5.0, TAU * 5.0], TAU * 2.5))
        .unwrap();
    assert_eq!(dashed.subpath_count(), 1);
    assert!(dashed.contains(DVec2::new(11.9, 0.0), FillRule::NonZero));
    assert!(!dashed.contains(DVec2::new(-10.0, 0.0), FillRule::NonZero));
}

/// The position of the end exceeds 1 by rounding; in a short last curve that is a part of its own.
#[test]
fn open_subpaths_end_with_their_last_width() {
    let mut rng = Rng(17);
    for _ in 0..400 {
        let mut points: Vec<DVec2> = (0..31)
            .map(|k| DVec2::new(10.0 * real(k), 40.0 * rng.signed()))
            .collect();
        let end = points[30];
        points.extend([1.0, 2.0, 3.0].map(|k| end + DVec2::new(k, 0.1 * k * k) * 1e-2));
        let path = Path::from(Spline::new(&points, 3, false).unwrap());
        let profile = WidthProfile::new(&[(0.0, 50.0), (0.5, 1.0), (1.0, 1.0)]);
        let outline = path
            .stroke_with(&profile, &round(0.01).simple(false))
            .unwrap();
        let ahead = end + DVec2::new(5.0, 0.0);
        assert!(!outline.contains(ahead, FillRule::NonZero), "{points:?}");
    }
}

#[test]
fn smooth_profiles_stay_between_their_stops_and_have_no_kinks() {
    let line = path("M0 0H100");
    let stops = [(0.0, 0.0), (0.3, 10.0), (0.5, 10.0), (1.0, 2.0)];
    let profile = WidthProfile::new(&stops).interpolation(WidthInterpolation::Smooth);
    let outline = line.stroke_with(&profile, &round(1e-6)).unwrap();
    let bounds = outline.bounds().unwrap();
    near(bounds.max.y, 5.0, 1e-5);
    near(bounds.min.y, -5.0, 1e-5);
    let spline = outline.subpath(0).unwrap();
    let corners = (1..spline.segment_count()).filter(|&k| {
        let curve = |k| spline.segment(k).expect("a segment");
        curve(k - 1).tangent(1.0).distance(curve(k).tangent(0.0)) > 1e-3
    });
    assert_eq!(corners.count(), 0);
}

#[test]
fn degenerate_input_is_defined() {
    let line = path("M0 0H10");
    let options = StrokeOptions::new().cap(StrokeCap::Round);
    let stroke =
        |path: &Path, stops: &[(f64, f64)]| path.stroke_with(&WidthProfile::new(stops), &options);
    assert_eq!(stroke(&line, &[(0.0, 0.0)]), Ok(Path::default()));
    let point = stroke(&path("M3 4L3 4"), &[(0.0, 2.0), (1.0, 8.0)]).unwrap();
    near(point.area(), PI * 16.0, 1e-2);
    assert_eq!(stroke(&Path::default(), &[(0.0, 1.0)]), Ok(Path::default()));
    // Far away, tiny and huge.
    for (scale, by) in [(1e-150, 0.0), (1e140, 0.0), (1.0, 1e9)] {
        let moved = |x: f64| x * scale + by;
        let d = format!("M{} {}L{} {}", moved(0.0), by, moved(10.0), by);
        let profile = [(0.0, 2.0 * scale), (1.0, 6.0 * scale)];
        let outline = stroke(&path(&d), &profile).unwrap();
        let area = hull(1.0, 3.0, 10.0) * scale * scale;
        near(outline.area() / area, 1.0, 1e-3);
    }
}

/// The positions and widths of a profile.
type Stops = &'static [(f64, f64)];

/// Paths with a profile and a tolerance, and a number of cubics that their sides had exceeded.
#[test]
fn hard_sides_have_few_cubics() {
    use WidthInterpolation::{Linear, Smooth};
    use WidthPosition::{Length, T};
    let sides: [(&str, Stops, _, _, f64, usize); 4] = [
        // Next to the turns of a straight curve r′ grows from nearly 0 to ±1 within 10⁻⁴ of t.
        (
            "M10,0 C0,0 20,0 10,0",
            &[(0.0, 13.14), (0.915, 13.133), (1.0, 18.894)],
            T,
            Linear,
            3e-3,
            150,
        ),
        // Next to a tight turn a side runs backwards in intervals that are much shorter than those between regular
        // parameters.
        (
            "M-46.548,39.675 C8.516,69.419 -25.323,-86.695 -4.475,87.441",
            &[(0.0, 2.946), (0.771, 2.69), (1.0, 0.0)],
            T,
            Smooth,
            8e-4,
            120,
        ),
        // In the middle of the interval in which the right side runs backwards, 1 − r′² − r r″ + rκ √(1 − r′²) is just
        // above 0.
        (
            "M-2.2286876275328327,-39.85889998319634 C-20.268090638434867,61.32099198758591 \
             76.46904677545206,-84.88048317911343 -62.554828878553856,45.52165449799508",
            &[(0.0, 49.229058486265494), (1.0, 0.0)],
            Length,
            Smooth,
            1.1954168663402796e-3,
            60,
        ),
        // Next to the point where a straight curve starts with speed 0, the sign of its curvature is a rounding error.
        (
            "M400.75 100.05C400.75 100.05 100.05 300.95 100.05 300.95",
            &FROM_A_STOP,
            Length,
            Smooth,
            0.064,
            20,
        ),
    ];
    for (d, stops, at, interpolation, tolerance, max) in sides {
        let profile = WidthProfile::new(stops).at(at).interpolation(interpolation);
        let options = round(tolerance).simple(false);
        let outline = path(d).stroke_with(&profile, &options).unwrap();
        let count = outline.segment_count();
        assert!(count < max, "{d}: {count}");
    }
}

const FROM_A_STOP: [(f64, f64); 4] = [
    (0.0, 30.852259172657504),
    (0.06022722708232042, 33.53723744392491),
    (0.8203130957817838, 26.03878252089834),
    (1.0, 14.73072743028229),
];

#[test]
fn points_that_strokes_had_missed() {
    use WidthInterpolation::{Linear, Smooth};
    let strokes: [(&str, Stops, _, f64, DVec2); 2] = [
        // Between two points where the width is 0 the stroke is thin on average, but not everywhere.
        (
            "M0 0H100",
            &[
                (0.0, 0.0),
                (0.45, 0.01),
                (0.5, 2.0),
                (0.55, 0.01),
                (1.0, 0.0),
            ],
            Linear,
            0.2,
            DVec2::new(50.0, 0.5),
        ),
        (
            "M400.75 100.05C400.75 100.05 100.05 300.95 100.05 300.95",
            &FROM_A_STOP,
            Smooth,
            0.064,
            DVec2::new(406.36730245857876, 115.13639374810698),
        ),
    ];
    for (d, stops, interpolation, tolerance, p) in strokes {
        let profile = WidthProfile::new(stops).interpolation(interpolation);
        let outline = path(d).stroke_with(&profile, &round(tolerance)).unwrap();
        assert!(outline.contains(p, FillRule::NonZero), "{d}: {p}");
    }
}

/// A bulb is in few of the thousands of segments of a contour that is thinner than the tolerance elsewhere.
#[test]
fn bulbs_of_long_thin_strokes_are_kept() {
    let waves = (0..600).map(|k| {
        let (x, side) = (10 * k, if k % 2 == 0 { 2 } else { -2 });
        format!("C{} {side} {} {} {} 0", x + 3, x + 7, -side, x + 10)
    });
    let line = path(&format!("M0 0{}", waves.collect::<String>()));
    for at in [0.25, 0.3137, 0.5, 0.9123] {
        let (before, after) = (at - 1.0 / 300.0, at + 1.0 / 300.0);
        let stops = [
            (0.0, 0.02),
            (before, 0.02),
            (at, 20.0),
            (after, 0.02),
            (1.0, 0.02),
        ];
        let profile = WidthProfile::new(&stops);
        let options = StrokeOptions::new().tolerance(0.1);
        let area = line.stroke_with(&profile, &options).unwrap().area();
        assert!((560.0..580.0).contains(&area), "{at}: {area}");
    }
}

/// The disc that shows that a hole is thick must be inside of it; next to the tip of this hole there is room for one outside.
#[test]
fn holes_thinner_than_the_tolerance_are_removed() {
    let lap = path(
        "M20.572541806103107,-72.8344738896334 C59.85368489744805,-81.68552037235708 \
         -33.32588450704292,1.8587736008538247 20.572541806103107,-72.8344738896334 Z",
    );
    let stops = [
        (0.0, 6.268483735668749),
        (0.9338902419390812, 16.957724658460556),
        (0.9953143558301931, 20.020602966656746),
        (1.0, 6.268483735668749),
    ];
    let profile = WidthProfile::new(&stops).interpolation(WidthInterpolation::Smooth);
    let outline = lap.stroke_with(&profile, &round(0.148)).unwrap();
    assert_eq!(outline.subpath_count(), 1);
}

/// The control points of the last part are equal up to rounding, so only the first one shows its direction.
#[test]
fn caps_of_parts_with_rounded_control_points_face_outwards() {
    let line =
        path("M465.24423 107.11105C475.50754 107.11105 475.50754 107.11105 475.50754 107.11105");
    let profile = WidthProfile::new(&[
        (0.297, 0.787),
        (0.877_658_989_380_693_6, 0.817),
        (0.98, 0.801),
    ]);
    for part in 0..200 {
        let mut profile = profile.clone();
        profile.stops[2].0 = 0.9 + 0.0995 * real(part) / 200.0;
        let outline = line
            .stroke_with(&profile, &round(2e-3))
            .expect("few segments");
        assert!(
            outline.contains(DVec2::new(475.8, 107.11), FillRule::NonZero),
            "{part}"
        );
    }
}

/// Where the radius changes faster than the path advances, next to a corner, all joins contain the disc at the corner.
#[test]
fn corners_between_fast_changes_keep_their_disc() {
    for d in ["M0 0H10L20 2", "M0 0H10L20 9", "M20 2L10 0H0", "M0 0H10V10"] {
        let bent = path(d);
        let corner = bent.subpath(0).unwrap().eval(1.0);
        for stops in [
            [(0.0, 2.0), (0.5, 60.0), (1.0, 2.0)],
            [(0.0, 60.0), (0.5, 2.0), (1.0, 2.0)],
        ] {
            let profile = WidthProfile::new(&stops).at(WidthPosition::T);
            let discs = Discs::new(&bent, &profile);
            for join in [Join::Round, Join::Miter, Join::Bevel] {
                let options = round(1e-3).join(join);
                let outline = bent.stroke_with(&profile, &options).expect("few segments");
                for k in 0..200 {
                    let far = DVec2::from_angle(0.7 * real(k)) * (40.0 * real(k) / 200.0);
                    let distance = discs.distance(corner + far);
                    if distance.abs() > 0.02 {
                        let contains = outline.contains(corner + far, FillRule::NonZero);
                        assert_eq!(contains, distance < 0.0, "{d}, {join:?}: {far}");
                    }
                }
            }
        }
    }
}
