//! Rounded corners: closed forms, tangency, the distance of arcs from their centres, and degenerate input.

use crate::support::paths::path;
use crate::support::{Rng, near};
use casteljau::glam::DVec2;
use casteljau::path::{CornerOptions, FillRule, PathTime};
use casteljau::{Curve, Path};
use std::f64::consts::PI;

fn rounded(d: &str, radius: f64) -> Path {
    path(d).round_corners(radius).expect("a radius")
}

/// The sines of the turns at the joints of a path, without the ends of open subpaths.
fn turns(path: &Path) -> Vec<f64> {
    let mut turns = Vec::new();
    for spline in path.subpaths() {
        let curves: Vec<Curve<DVec2>> = spline.segments().collect();
        for (k, curve) in curves.iter().enumerate() {
            if k + 1 < curves.len() || spline.is_closed() {
                let next = &curves[(k + 1) % curves.len()];
                turns.push(curve.tangent(1.0).perp_dot(next.tangent(0.0)));
            }
        }
    }
    turns
}

fn assert_smooth(path: &Path, what: &str) {
    for turn in turns(path) {
        assert!(turn.abs() < 1e-7, "{what}: a turn of {turn:e} in {path}");
    }
}

#[test]
fn a_square_has_the_area_and_length_of_the_closed_form() {
    for (s, r) in [(10.0, 2.0), (10.0, 0.01), (1e-6, 3e-7), (1e6, 4e5)] {
        let square = format!("M0 0H{s}V{s}H0Z");
        for d in [square.clone(), format!("{square} M0 0V{s}H{s}V0Z")] {
            let result = rounded(&d, r);
            let count = result.subpath_count() as f64;
            assert_smooth(&result, &d);
            let first = Path::new(&[result.subpath(0).expect("a subpath")]);
            near(first.area(), s * s - (4.0 - PI) * r * r, 2e-9 * r * s);
            let length = result.length();
            near(length, count * (4.0 * s - (8.0 - 2.0 * PI) * r), 1e-8 * s);
        }
    }
}

#[test]
fn tangent_points_of_straight_segments_are_exact() {
    let result = rounded("M0 0H10V10H0Z", 2.0);
    let starts: Vec<DVec2> = result.segments().map(|curve| curve.start()).collect();
    for p in [(2.0, 0.0), (8.0, 0.0), (10.0, 2.0), (8.0, 10.0), (0.0, 2.0)] {
        assert!(starts.contains(&DVec2::from(p)), "{p:?} in {result}");
    }
    assert_eq!(starts[0], DVec2::new(2.0, 0.0));
}

#[test]
fn chosen_corners_are_rounded_and_others_stay() {
    let square = path("M0 0H10V10H0Z M20 0H30V10");
    let corners = |places: &[(usize, f64)]| {
        let places: Vec<PathTime> = places.iter().map(|&(k, t)| PathTime::new(k, t)).collect();
        let options = CornerOptions::new().corners(&places);
        square.round_corners_with(2.0, &options)
    };
    let areas = |places| {
        corners(places)
            .expect("joints")
            .filled_area(FillRule::NonZero)
    };
    let missing = (4.0 - PI) * 1.0;
    for (places, count) in [
        (&[][..], 0.0),
        (&[(0, 1.0)], 1.0),
        (&[(0, 0.0), (0, 4.0)], 1.0), // the same joint
        (&[(0, 0.0), (0, 2.0), (0, 2.0)], 2.0),
        (&[(1, 0.0), (1, 2.0)], 0.0), // ends
        (&[(1, 1.0)], 1.0),
    ] {
        near(
            areas(places).expect("an area"),
            150.0 - count * missing,
            1e-7,
        );
    }
    // An arc does not go beyond a corner that stays.
    let options = CornerOptions::new().corners(&[PathTime::new(0, 2.0)]);
    let large = path("M0 0H10V10H0Z")
        .round_corners_with(50.0, &options)
        .expect("a joint");
    near(large.area(), 100.0 - (1.0 - 0.25 * PI) * 100.0, 1e-6);
    // Segments that are points lie at the corner.
    let repeated = path("M0 0H10L10 0L10 0V10H0Z");
    for t in [1.0, 2.0, 3.0] {
        let options = CornerOptions::new().corners(&[PathTime::new(0, t)]);
        let result = repeated.round_corners_with(2.0, &options).expect("a joint");
        near(result.area(), 100.0 - missing, 1e-7);
    }
}

#[test]
fn each_corner_has_its_radius_in_the_order_of_the_path() {
    let options = CornerOptions::new();
    let square = path("M0 0H10V10H0Z M20 0H30V10");
    let mut corners = Vec::new();
    let radius = |corner: PathTime| {
        corners.push((corner.subpath, corner.t));
        corner.t + 1.0
    };
    let result = square.round_corners_by(radius, &options).expect("radii");
    let expected = [(0, 0.0), (0, 1.0), (0, 2.0), (0, 3.0), (1, 1.0)];
    assert_eq!(corners, expected);
    let missing = (1.0 - 0.25 * PI) * (1.0 + 4.0 + 9.0 + 16.0);
    near(
        result.subpath(0).expect("a square").area(),
        100.0 - missing,
        1e-7,
    );
    let starts: Vec<DVec2> = result.segments().map(|curve| curve.start()).collect();
    for p in [
        (1.0, 0.0),
        (8.0, 0.0),
        (10.0, 2.0),
        (10.0, 7.0),
        (7.0, 10.0),
        (4.0, 10.0),
    ] {
        assert!(starts.contains(&DVec2::from(p)), "{p:?} in {result}");
    }
    // 0 leaves corners.
    assert_eq!(
        square.round_corners_by(|_| 0.0, &options),
        Ok(square.clone())
    );
    // Segments that are points have one corner, at their last joint.
    let repeated = path("M0 0H0H10L10 0L10 0V10H0Z");
    let mut ts = Vec::new();
    let radius = |corner: PathTime| {
        ts.push(corner.t);
        if corner.t == 4.0 { 2.0 } else { 0.0 }
    };
    let result = repeated.round_corners_by(radius, &options).expect("radii");
    assert_eq!(ts, [1.0, 4.0, 5.0, 6.0]);
    near(result.area(), 100.0 - (4.0 - PI), 1e-7);
    // Radii belong to the chosen corners, and the largest one counts.
    let chosen = [(1.0, 2.0), (0.0, 1.0), (4.0, 3.0), (1.0, 0.0)];
    let places: Vec<PathTime> = chosen.iter().map(|&(t, _)| PathTime::new(0, t)).collect();
    let mut radii = chosen.iter().map(|&(_, radius)| radius);
    let result = path("M0 0H10V10H0Z")
        .round_corners_by(
            |_| radii.next().expect("a radius"),
            &options.corners(&places),
        )
        .expect("radii");
    near(result.area(), 100.0 - (1.0 - 0.25 * PI) * (4.0 + 9.0), 1e-7);
}

/// One side of 10 between the corners with radii a and b, and one at each other corner.
#[test]
fn a_short_arc_keeps_its_radius_beside_a_long_one() {
    for (a, b, expected) in [
        (8.0, 2.0, [8.0, 2.0]),
        (9.0, 2.0, [8.0, 2.0]),
        (2.0, 9.0, [2.0, 8.0]),
        (9.0, 5.0, [5.0, 5.0]),
        (9.0, 6.0, [5.0, 5.0]),
        (9.0, 0.0, [9.0, 0.0]),
    ] {
        let mut radii = [a, b, 0.0, 0.0].into_iter();
        let corner = |_: PathTime| radii.next().expect("a corner");
        let result = path("M0 0H10V10H0Z")
            .round_corners_by(corner, &CornerOptions::new())
            .expect("radii");
        let missing = (1.0 - 0.25 * PI) * (expected[0] * expected[0] + expected[1] * expected[1]);
        near(result.area(), 100.0 - missing, 1e-6);
    }
}

#[test]
fn a_tolerance_takes_fewer_cubics() {
    let square = path("M0 0H10V10H0Z");
    let mut count = usize::MAX;
    for tolerance in [1e-9, 1e-6, 1e-3, 10.0] {
        let options = CornerOptions::new().tolerance(tolerance);
        let result = square
            .round_corners_with(4.0, &options)
            .expect("a tolerance");
        assert!(result.segment_count() < count, "{tolerance}");
        count = result.segment_count();
        for curve in result.segments().filter(|curve| curve.degree() == 3) {
            for t in [0.2, 0.4, 0.7] {
                let p = curve.eval(t);
                let center = DVec2::new(
                    if p.x < 5.0 { 4.0 } else { 6.0 },
                    if p.y < 5.0 { 4.0 } else { 6.0 },
                );
                near(p.distance(center), 4.0, tolerance);
            }
        }
    }
    assert_eq!(count, 8);
}

/// The arc at an angle of 2α is r cot α away from the corner, and each point of it r from the centre.
#[test]
fn arcs_of_any_angle_have_the_radius() {
    for degrees in [1.0, 30.0, 60.0, 90.0, 120.0, 170.0, 179.0_f64] {
        for sign in [1.0, -1.0] {
            let turn = degrees.to_radians();
            let end = DVec2::new(turn.cos(), sign * turn.sin()) * 100.0;
            let r = 10.0 / (0.5 * turn).tan();
            let result = rounded(&format!("M-100 0L0 0L{} {}", end.x, end.y), r);
            let centre = DVec2::new(-10.0, sign * r);
            assert_smooth(&result, "an angle");
            let curves: Vec<Curve<DVec2>> = result.segments().collect();
            assert!(curves.len() >= 3, "{degrees}°: {result}");
            for curve in &curves[1..curves.len() - 1] {
                for k in 0..=8 {
                    let distance = curve.eval(f64::from(k) / 8.0).distance(centre);
                    near(distance, r, 2e-9 * r);
                }
            }
        }
    }
}

#[test]
fn arcs_that_would_overlap_are_reduced() {
    // A circle of the square, and no line of length 0 between its arcs.
    for r in [5.0, 7.0, 1e150] {
        let circle = rounded("M0 0H10V10H0Z", r);
        near(circle.area(), 25.0 * PI, 1e-6);
        assert!(circle.segments().all(|curve| curve.degree() == 3));
        assert_smooth(&circle, "a circle");
    }
    // Only the arcs at the short side are reduced, to a half of it.
    let slot = rounded("M0 0H10V2H0", 3.0);
    near(slot.length(), 18.0 + PI, 1e-7);
    // A long arc and a short one share a side without a reduction.
    let shared = rounded("M0 0H10L-10 9", 2.0);
    assert_smooth(&shared, "an acute angle");
}

/// The centre of the arc is as far from both curves as the radius.
#[test]
fn the_circle_is_tangent_to_curves() {
    for (first, second) in [
        ("M0 0Q10 0 12 8", "M12 8Q4 9 0 20"),
        ("M0 0Q10 0 12 8", "M12 8L0 20"),
        ("M0 0L12 8", "M12 8C2 8 9 12 0 20"),
        ("M0 0C5 5 10 -5 12 8", "M12 8C12 8 9 12 0 20"),
        ("M0 0C5 5 12 8 12 8", "M12 8Q4 9 0 20"),
    ] {
        let (_, rest) = second.split_at(5);
        for radius in [0.01, 0.5, 1.0] {
            let result = rounded(&format!("{first}{rest}"), radius);
            assert_smooth(&result, first);
            let curves: Vec<Curve<DVec2>> = result.segments().collect();
            assert!(curves.len() > 3, "{first}{rest}: {result}");
            for arc in &curves[1..curves.len() - 1] {
                let towards = arc.normal(0.5) * arc.curvature(0.5).signum();
                let centre = arc.eval(0.5) + towards * radius;
                for side in [first, second] {
                    let nearest = path(side).nearest(centre).unwrap().unwrap();
                    near(nearest.distance, radius, 3e-9 * radius + 1e-12);
                }
            }
        }
    }
}

/// A quarter circle consists of many cubics, and a line of ten pieces: the arc replaces several of them.
#[test]
fn arcs_reach_across_smooth_joints() {
    let quarter = "M0 8A4 4 0 0 0 4 4";
    let pieces: String = (1..=10).map(|k| format!("H{}", 4 - 2 * k)).collect();
    for d in [
        format!("{quarter}H-16"),
        format!("{quarter}{pieces}"),
        format!("M4 4{pieces}V8H0A4 4 0 0 0 4 4Z"),
    ] {
        let fine = Path::from_svg_with(&d, 1e-9).expect("path data");
        let result = fine.round_corners(1.0).expect("a radius");
        // The centre is 1 above the line, and 3 from the centre of the quarter circle.
        let centre = DVec2::new(8.0_f64.sqrt(), 5.0);
        let on_arc = |curve: &Curve<DVec2>| (curve.eval(0.5).distance(centre) - 1.0).abs() < 1e-8;
        let arcs: Vec<Curve<DVec2>> = result.segments().filter(on_arc).collect();
        assert!(arcs.len() >= 4, "{} cubics in {result}", arcs.len());
        let end = arcs[arcs.len() - 1].end();
        assert!(end.distance(DVec2::new(centre.x, 4.0)) < 1e-9, "{end}");
        assert_smooth(&result, &d);
    }
}

#[test]
fn what_is_no_corner_is_kept_bit_for_bit() {
    for d in [
        "M0 0C1 2 3 2 4 0C5 -2 7 -2 8 0", // a smooth joint
        "M0 0L1 1L2 2.0001",              // a turn by less than the limit
        "M0 0H10H2V5",                    // a turn-back, and a corner
        "M0 0L0 0L0 0",
        "M3 3Z",
        "",
    ] {
        let given = path(d);
        assert_eq!(given.round_corners(0.0).expect("a radius"), given);
        let expected = if d.contains('V') { None } else { Some(&given) };
        let result = given.round_corners(1.0).expect("a radius");
        assert!(expected.is_none_or(|path| *path == result), "{d}: {result}");
        assert_eq!(result.segments().next(), given.segments().next());
    }
    let far = rounded("M0 0C1 2 3 2 4 0C5 -2 7 -2 8 0L8 5L4 5", 0.5);
    let first = path("M0 0C1 2 3 2 4 0").segments().next();
    assert_eq!(far.segments().next(), first);
}

#[test]
fn an_arc_ends_where_the_path_turns_back() {
    // The segment before the corner is 3 long; that before it runs in the opposite direction on the same line.
    let result = rounded("M3 0H1H4L-6 7", 100.0);
    let bounds = result.control_bounds().expect("points");
    assert!(bounds.min.y > -1e-12, "{result}");
    let (before, after) = (DVec2::NEG_X, DVec2::new(-10.0, 7.0).normalize());
    let radius = 3.0 * (0.5 * before.angle_to(after).abs()).tan();
    let arc = result.segments().nth(1).expect("an arc");
    near(arc.curvature(0.0), 1.0 / radius, 1e-4);
    near(arc.start().x, 1.0, 1e-12);
}

#[test]
fn results_that_are_another_path() {
    for (given, radius, expected) in [
        // Segments of length 0 at a corner are omitted.
        ("M0 0H10L10 0L10 0V10", 2.0, rounded("M0 0H10V10", 2.0)),
        ("M0 0L0 0H10V10H0Z", 2.0, rounded("M0 0H10V10H0Z", 2.0)),
        // A corner between segments of very different size stays.
        (
            "M1e-300 0L0 0L0 1e150",
            1e149,
            path("M1e-300 0L0 0L0 1e150"),
        ),
    ] {
        assert_eq!(rounded(given, radius), expected, "{given}");
    }
}

/// Polygons, whose angles are known: at each corner there is an arc of the radius, or one that reaches the middle of a
/// side or the whole of it.
#[test]
fn corners_of_random_polygons_are_rounded() {
    let mut random = Rng(7);
    for case in 0..500 {
        let count = 3 + case % 5;
        let mut point = || format!("{} {}", random.signed(), random.signed());
        let points: Vec<String> = (0..count).map(|_| point()).collect();
        let d = format!("M{}Z", points.join("L"));
        for radius in [1e-3, 0.1, 10.0] {
            let result = rounded(&d, radius);
            for turn in turns(&result) {
                // Turns of less than 0.06°, and turn-backs, stay.
                assert!(turn.abs() < 1e-3, "{d}: a turn of {turn:e}");
            }
            for curve in result.segments().filter(|curve| curve.degree() == 3) {
                let own = 1.0 / curve.curvature(0.5).abs();
                assert!(radius / own > 1.0 - 1e-5, "{d}: a radius of {own}");
            }
        }
    }
}

/// Random cubics: no joint turns by more than the 0.06° that are no corner, and small radii change little.
#[test]
fn corners_of_random_cubics_are_rounded() {
    let mut random = Rng(8);
    for _ in 0..500 {
        let mut p = || format!("{} {}", random.signed(), random.signed());
        let d = format!("M{}C{} {} {}C{} {} {}Z", p(), p(), p(), p(), p(), p(), p());
        let given = path(&d);
        for radius in [1e-4, 0.05, 2.0] {
            let result = given.round_corners(radius).expect("a radius");
            for turn in turns(&result) {
                assert!(turn.abs() < 1e-3, "{d}: a turn of {turn:e}");
            }
            if radius < 1e-3 {
                let area = (result.area() - given.area()).abs();
                // The arc starts at most 2,000 radii before the corner.
                assert!(area < 1e-4, "{d}: the area changes by {area:e}");
            }
        }
    }
}
