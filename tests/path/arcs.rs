//! Elliptical arcs, compared with the ellipse itself; its centre is computed by another method (SVG 1.1, F.6.5).

use crate::support::paths::{RandomPlane, path};
use crate::support::{Rng, near, real};
use casteljau::glam::DVec2;
use casteljau::path::PathBuilder;
use casteljau::{MAX_COORDINATE, Path, Spline};
use std::f64::consts::{PI, TAU};

#[derive(Clone, Copy, Debug)]
struct Arc {
    from: DVec2,
    to: DVec2,
    radii: DVec2,
    degrees: f64,
    large: bool,
    sweep: bool,
}

/// The largest angle of a cubic for an error: 2/27 sin⁶(θ/4) / cos²(θ/4), solved for θ, at most a quarter turn.
fn max_angle(max: f64) -> f64 {
    let error = |angle: f64| {
        let (sin, cos) = (angle / 4.0).sin_cos();
        2.0 / 27.0 * sin.powi(6) / cos.powi(2)
    };
    let (mut low, mut high) = (0.0, PI / 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if error(middle) <= max {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

impl Arc {
    /// Cubics within a distance, as a part of the larger radius, or within the usual one.
    fn read(&self, tolerance: Option<f64>) -> Spline<DVec2> {
        let Self {
            from,
            to,
            radii,
            degrees,
            ..
        } = self;
        let [large, sweep] = [self.large, self.sweep].map(u8::from);
        let [rx, ry, x, y] = [radii.x, radii.y, to.x, to.y];
        let d = format!(
            "M{} {}A{rx} {ry} {degrees} {large} {sweep} {x} {y}",
            from.x, from.y
        );
        let (_, radii, _) = self.ellipse();
        let fine = |tolerance| Path::from_svg_with(&d, tolerance * radii.max_element());
        let path = tolerance.map_or_else(|| Path::from_svg(&d), fine);
        let path = path.unwrap_or_else(|error| panic!("{d}: {error}"));
        assert_eq!(path.subpath_count(), 1, "{d}");
        path.subpath(0).expect("a subpath")
    }

    /// The centre, the radii, and the swept angle.
    fn ellipse(&self) -> (DVec2, DVec2, f64) {
        let turn = DVec2::from_angle(self.degrees.to_radians());
        let half = back(turn, (self.from - self.to) / 2.0);
        let mut r = self.radii;
        let size = half.x.powi(2) / r.x.powi(2) + half.y.powi(2) / r.y.powi(2);
        if size > 1.0 {
            r *= size.sqrt();
        }
        let (rx2, ry2) = (r.x * r.x, r.y * r.y);
        let (x2, y2) = (half.x * half.x, half.y * half.y);
        let square = (rx2 * ry2 - rx2 * y2 - ry2 * x2) / (rx2 * y2 + ry2 * x2);
        let factor = square.max(0.0).sqrt();
        let sign = if self.large == self.sweep { -1.0 } else { 1.0 };
        let local = DVec2::new(r.x * half.y / r.y, -r.y * half.x / r.x) * (sign * factor);
        let centre = turn.rotate(local) + (self.from + self.to) / 2.0;
        let angle = |p: DVec2| (p / r).to_angle();
        let mut swept = angle(-half - local) - angle(half - local);
        if self.sweep && swept < 0.0 {
            swept += TAU;
        } else if !self.sweep && swept > 0.0 {
            swept -= TAU;
        }
        (centre, r, swept)
    }

    /// A point on the unit circle of the ellipse.
    fn on_circle(&self, p: DVec2, centre: DVec2, radii: DVec2) -> DVec2 {
        let turn = DVec2::from_angle(self.degrees.to_radians());
        back(turn, p - centre) / radii
    }
}

/// Rotation in the opposite direction.
fn back(turn: DVec2, v: DVec2) -> DVec2 {
    DVec2::new(turn.x, -turn.y).rotate(v)
}

fn check(arc: Arc, tolerance: Option<f64>) {
    let (spline, max) = (arc.read(tolerance), tolerance.unwrap_or(1e-5));
    assert_eq!(spline.eval(0.0), arc.from, "{arc:?}");
    assert_eq!(spline.eval(real(spline.segment_count())), arc.to, "{arc:?}");
    let (centre, radii, swept) = arc.ellipse();
    // The effect of rounding on the centre, in units of the unit circle.
    let far = arc.from.abs().max_element().max(arc.to.abs().max_element()) + radii.max_element();
    let noise = 1e-14 * far / radii.min_element();
    // Distances in the plane are at most the larger radius times those on the unit circle, and at least the smaller one.
    let max_off = 1.01 * max + noise;
    let mut before = arc.on_circle(arc.from, centre, radii);
    let mut angle = 0.0;
    for p in spline.sample(16).expect("few").into_iter().skip(1) {
        let unit = arc.on_circle(p, centre, radii);
        let off = (unit.length() - 1.0).abs();
        assert!(off <= max_off, "{arc:?} {max}: {off} at {p}");
        let step = before.angle_to(unit);
        assert!(step.abs() < 0.2, "{arc:?}");
        assert!(step * swept > 0.0, "{arc:?}: backwards at {p}");
        angle += step;
        before = unit;
    }
    near(angle, swept, 1e-6 + 10.0 * noise);
    // As few pieces as the bound allows; rounding decides where that number changes.
    let (pieces, min) = (real(spline.segment_count()), swept.abs() / max_angle(max));
    let slack = 1e-4 * min + noise;
    let range = (min - slack).ceil()..=(min + slack).ceil();
    assert!(
        range.contains(&pieces),
        "{arc:?}: {pieces} pieces, not {min}"
    );
}

#[test]
fn arcs_lie_on_their_ellipse() {
    let mut rng = Rng(11);
    let mut checked = 0;
    for _ in 0..20_000 {
        let scale = rng.magnitude(-6.0, 6.0);
        let (from, to) = (rng.spot(scale), rng.spot(scale));
        let arc = Arc {
            from,
            to,
            radii: DVec2::new(rng.magnitude(-0.3, 1.0), rng.magnitude(-0.3, 1.0)) * scale,
            degrees: rng.signed() * rng.pick(&[1.0, 45.0, 90.0, 180.0, 1000.0]),
            large: rng.chance(0.5),
            sweep: rng.chance(0.5),
        };
        // If the chord is nearly the diameter, the centre depends on the last digits of all arguments.
        let (_, _, swept) = arc.ellipse();
        if (swept.abs() - PI).abs() > 1e-3 {
            checked += 1;
            check(arc, None);
            if checked % 8 == 0 {
                let tolerances = [1e-3, 1e-9, 1e-11].map(Some);
                tolerances
                    .into_iter()
                    .for_each(|tolerance| check(arc, tolerance));
            }
        }
    }
    assert!(checked > 12_000, "{checked}");
}

#[test]
fn quarters_and_halves_are_found_in_spite_of_rounding() {
    let mut rng = Rng(12);
    for _ in 0..5_000 {
        let scale = rng.magnitude(-3.0, 3.0);
        let centre = rng.spot(scale) * rng.pick(&[0.0, 1.0, 1000.0]);
        let r = rng.unit() * scale + 1e-3 * scale;
        // Two halves of a circle, as drawing programs write it.
        let (left, y, width) = (centre.x - r, centre.y, 2.0 * r);
        let d = format!("M{left} {y}a{r} {r} 0 1 0 {width} 0a{r} {r} 0 1 0 -{width} 0z");
        // Rounding may leave a line from the end to the start.
        let usual = Path::from_svg(&d).expect("a circle");
        let cubics = usual.segments().filter(|curve| curve.degree() == 3);
        assert_eq!(cubics.count(), 8, "{d}");
        let path = Path::from_svg_with(&d, 1e-9 * r).expect("a circle");
        let noise = 4e-16 * (centre.abs().max_element() + r) / r;
        for p in path.subpath(0).expect("one").sample(8).expect("few") {
            near(p.distance(centre) / r, 1.0, 1e-9 + 8.0 * noise);
        }
        near(-path.area() / (PI * r * r), 1.0, 3e-9 + 8.0 * noise);
    }
}

#[test]
fn radii_that_are_too_small_grow_until_they_reach() {
    let mut rng = Rng(13);
    for _ in 0..2_000 {
        let (from, to) = (rng.spot(1.0), rng.spot(1.0));
        let radii = DVec2::new(rng.magnitude(-3.0, 0.0), rng.magnitude(-3.0, 0.0));
        let arc = Arc {
            from,
            to,
            radii: radii * 0.1 * from.distance(to),
            degrees: rng.signed() * 180.0,
            large: rng.chance(0.5),
            sweep: rng.chance(0.5),
        };
        let spline = arc.read(Some(1e-9));
        // Half an ellipse around the middle of the chord, through the point opposite.
        assert_eq!(spline.segment_count(), 17, "{arc:?}");
        assert_eq!(arc.read(None).segment_count(), 4, "{arc:?}");
        let ((centre, radii, _), middle) = (arc.ellipse(), from.midpoint(to));
        assert!(centre.distance(middle) < 1e-6 * radii.max_element());
        for p in spline.sample(8).expect("few") {
            let max = 1e-9 + 1e-13 * radii.max_element() / radii.min_element();
            near(arc.on_circle(p, middle, radii).length(), 1.0, max);
        }
    }
}

#[test]
fn adversarial_arcs_stay_finite_and_end_where_they_should() {
    let mut rng = Rng(14);
    let mut number = || {
        let size = rng.magnitude(-320.0, 150.0);
        rng.pick(&[size, -size, 1.0, 0.0, 5e-324, MAX_COORDINATE, 1e-300, 90.0])
    };
    for _ in 0..20_000 {
        let n: Vec<f64> = (0..7).map(|_| number()).collect();
        let (from, to) = (DVec2::new(n[0], n[1]), DVec2::new(n[5], n[6]));
        for flags in ["00", "01", "10", "11"] {
            let arc = format!("A{} {} {} {flags}{} {}", n[2], n[3], n[4], to.x, to.y);
            let path = match Path::from_svg(&format!("M{} {}{arc}", from.x, from.y)) {
                Ok(path) => path,
                Err(error) => {
                    assert_eq!(error.expected, "coordinates from -2^500 to 2^500");
                    let largest = n.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
                    assert!(largest > MAX_COORDINATE / 16.0, "{from} {arc}");
                    continue;
                }
            };
            if from == to {
                assert!(path.is_empty(), "{from} {arc}");
                continue;
            }
            let spline = path.subpath(0).expect("a subpath");
            let points = spline.control_points();
            assert!(spline.segment_count() <= 7, "{from} {arc}");
            assert!(points.iter().all(|p| p.is_finite()), "{from} {arc}");
            let ends = (points[0], points[points.len() - 1]);
            assert_eq!(ends, (from, to), "{from} {arc}");
        }
    }
}

#[test]
fn a_short_piece_of_a_vast_circle_keeps_its_digits() {
    // The sagitta of a chord of 2 with a radius of 1e9 is 5e-10.
    let arc = path("M0 0A1e9 1e9 0 0 1 2 0").subpath(0).expect("an arc");
    near(arc.eval(0.5).x, 1.0, 1e-15);
    near(arc.eval(0.5).y, -5e-10, 1e-18);
}

#[test]
fn an_ellipse_has_its_area_and_its_length() {
    let d = "M3 0A3 2 0 0 1 -3 0 3 2 0 0 1 3 0Z";
    let (area, fine) = (6.0 * PI, Path::from_svg_with(d, 3e-9).expect("an ellipse"));
    near(path(d).area() / area, 1.0, 2e-5);
    near(fine.area() / area, 1.0, 2e-9);
    // The perimeter of an ellipse with the semi-axes 3 and 2 is 15.865439589290589...
    let length = fine.length();
    near(length / 15.865_439_589_290_59, 1.0, 1e-9);
    let m = fine.moments();
    assert!(m.x.abs() < 1e-12 && m.xy.abs() < 1e-12);
    near(m.xx / (area * 9.0 / 4.0), 1.0, 4e-9);
    near(m.yy / (area * 4.0 / 4.0), 1.0, 4e-9);
}

#[test]
fn tolerances_that_are_not_above_0_are_refused() {
    for tolerance in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
        let error = Path::from_svg_with("M0 0A1 1 0 0 1 2 0", tolerance);
        let error = error.expect_err("no tolerance").to_string();
        assert!(error.contains("an arc tolerance above 0"), "{error}");
        let mut builder = PathBuilder::new();
        builder.arc_tolerance(tolerance);
        assert!(builder.build().is_err(), "{tolerance}");
    }
    // The finest tolerance gives a bounded number of cubics, the coarsest a quarter turn each.
    for (tolerance, count) in [(5e-324, 414), (f64::INFINITY, 4)] {
        let circle = Path::from_svg_with("M2 0A2 2 0 0 1 -2 0 2 2 0 0 1 2 0Z", tolerance);
        assert_eq!(circle.expect("a circle").segment_count(), count);
    }
}
