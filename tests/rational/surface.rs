//! Rational patches and NURBS surfaces: closed forms on spheres, tori, cylinders and cones, polynomial patches as references,
//! and operations that keep the surface.

use super::within;
use crate::support::Rng;
use casteljau::glam::{DAffine3, DMat4, DVec3};
use casteljau::{Error, NurbsCurve, NurbsSurface, Patch, RationalCurve, RationalPatch, take_steps};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn random_point(rng: &mut Rng) -> DVec3 {
    DVec3::new(rng.signed(), rng.signed(), rng.signed())
}

/// A random patch with weights from 2^−k to 2^k.
pub(super) fn random_patch(rng: &mut Rng, k: f64) -> RationalPatch {
    let (m, n) = (1 + rng.below(4), 1 + rng.below(4));
    let count = (m + 1) * (n + 1);
    let net: Vec<DVec3> = (0..count).map(|_| random_point(rng)).collect();
    let weights: Vec<f64> = (0..count).map(|_| within(rng, -k, k).exp2()).collect();
    RationalPatch::new(&net, &weights, m, n).expect("valid")
}

fn random_knots(rng: &mut Rng, degree: usize, inner: usize) -> Vec<f64> {
    let mut knots = vec![0.0; degree + 1];
    for _ in 0..inner {
        let last = knots[knots.len() - 1];
        let step = if rng.chance(0.3)
            && last > 0.0
            && knots.iter().filter(|&&u| u == last).count() < degree
        {
            0.0
        } else {
            within(rng, 0.2, 1.0)
        };
        knots.push(last + step);
    }
    let end = knots[knots.len() - 1] + 0.5;
    knots.extend(vec![end; degree + 1]);
    knots
}

/// A random surface over clamped knots.
fn random_surface(rng: &mut Rng) -> NurbsSurface {
    let (p, q) = (1 + rng.below(3), 1 + rng.below(3));
    let inner = [rng.below(4), rng.below(4)];
    let (u, v) = (
        random_knots(rng, p, inner[0]),
        random_knots(rng, q, inner[1]),
    );
    let count = (u.len() - p - 1) * (v.len() - q - 1);
    let net: Vec<DVec3> = (0..count).map(|_| random_point(rng)).collect();
    let weights: Vec<f64> = (0..count).map(|_| within(rng, -2.0, 2.0).exp2()).collect();
    NurbsSurface::new(p, q, &net, Some(&weights), &u, &v).expect("valid")
}

/// Parameters on a grid over the domain, ends included.
fn grid(surface: &NurbsSurface, steps: u32) -> Vec<(f64, f64)> {
    let ([u0, u1], [v0, v1]) = (surface.domain_u(), surface.domain_v());
    let part = |k: u32| f64::from(k) / f64::from(steps);
    let at = |i: u32, j: u32| (u0 + (u1 - u0) * part(i), v0 + (v1 - v0) * part(j));
    (0..=steps)
        .flat_map(|i| (0..=steps).map(move |j| at(i, j)))
        .collect()
}

/// Asserts that two surfaces have the same domain and the same points.
fn assert_same(a: &NurbsSurface, b: &NurbsSurface, what: &str) {
    assert_eq!(
        (a.domain_u(), a.domain_v()),
        (b.domain_u(), b.domain_v()),
        "{what}"
    );
    for (u, v) in grid(a, 12) {
        let off = (a.eval(u, v) - b.eval(u, v)).length();
        assert!(off <= 1e-13, "{what}: {off:e} at {u}, {v}");
    }
}

/// The axis, two directions across it, and the surface's center.
fn frames() -> Vec<(DVec3, DVec3)> {
    let mut rng = Rng(31);
    let mut frames = vec![(DVec3::ZERO, DVec3::Z), (DVec3::ZERO, -DVec3::X)];
    frames.extend((0..10).map(|_| (DVec3::ZERO, random_point(&mut rng) * 7.0)));
    frames.extend((0..10).map(|_| (random_point(&mut rng), random_point(&mut rng))));
    frames
}

/// The distance from the axis through a center and the height along it.
fn cylindrical(p: DVec3, center: DVec3, axis: DVec3) -> (f64, f64) {
    let (d, axis) = (p - center, axis.normalize());
    (d.cross(axis).length(), d.dot(axis))
}

fn ulps(off: f64, largest: f64) -> f64 {
    off.abs() / (largest.log2().floor().exp2() * f64::EPSILON)
}

#[test]
fn points_are_on_the_implicit_surfaces() {
    let mut worst = [0.0_f64; 4];
    for (center, axis) in frames() {
        let (radius, minor, height) = (1.7, 0.6, 2.9);
        let shapes = [
            NurbsSurface::sphere(center, radius, axis),
            NurbsSurface::torus(center, radius, minor, axis),
            NurbsSurface::cylinder(center, radius, height, axis),
            NurbsSurface::cone(center, radius, height, axis),
        ]
        .map(|shape| shape.expect("valid"));
        for (k, shape) in shapes.iter().enumerate() {
            let bounds = shape.control_bounds();
            let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
            for (u, v) in grid(shape, 60) {
                let p = shape.eval(u, v);
                let (from_axis, along) = cylindrical(p, center, axis);
                let off = match k {
                    0 => (p - center).length() - radius,
                    1 => (from_axis - radius).hypot(along) - minor,
                    2 => from_axis - radius,
                    // The distance from the line of the side in the half-plane.
                    _ => {
                        (from_axis * height + along * radius - radius * height)
                            / radius.hypot(height)
                    }
                };
                worst[k] = worst[k].max(ulps(off, largest));
            }
        }
    }
    // The distances are computed here with errors of their own.
    assert!(worst.iter().all(|&ulps| ulps <= 4.0), "{worst:?} ulps");
}

#[test]
fn curvatures_have_closed_forms() {
    for (center, axis) in frames() {
        let sphere = NurbsSurface::sphere(center, 0.5, axis).expect("valid");
        for (u, v) in grid(&sphere, 20) {
            let at = sphere.curvature(u, v);
            let tolerance = if v == 0.0 || v == 1.0 { 1e-7 } else { 1e-10 };
            assert!((at.gaussian - 4.0).abs() <= tolerance, "{u} {v}: {at:?}");
            assert!((at.mean + 2.0).abs() <= tolerance, "{u} {v}: {at:?}");
        }
        let (major, minor) = (2.0, 0.7);
        let torus = NurbsSurface::torus(center, major, minor, axis).expect("valid");
        for (u, v) in grid(&torus, 20) {
            let (from_axis, _) = cylindrical(torus.eval(u, v), center, axis);
            let cos = (from_axis - major) / minor;
            let at = torus.curvature(u, v);
            let expected = cos / (minor * from_axis);
            assert!((at.gaussian - expected).abs() <= 1e-11, "{at:?} {expected}");
            let mean = -0.5 * (1.0 / minor + cos / from_axis);
            assert!((at.mean - mean).abs() <= 1e-11, "{at:?} {mean}");
        }
        let cone = NurbsSurface::cone(center, 1.0, 2.0, axis).expect("valid");
        for (u, v) in grid(&cone, 7).into_iter().filter(|&(_, v)| v < 1.0) {
            assert!(cone.curvature(u, v).gaussian.abs() <= 1e-10);
        }
    }
}

#[test]
fn normals_point_outwards_also_at_poles() {
    for (center, axis) in frames() {
        let sphere = NurbsSurface::sphere(center, 2.0, axis).expect("valid");
        for (u, v) in grid(&sphere, 16) {
            let radial = (sphere.eval(u, v) - center) / 2.0;
            let off = (sphere.normal(u, v) - radial).length();
            assert!(off <= 1e-14, "{u} {v}: {off:e}");
        }
        let (radius, height) = (1.5, 2.5);
        let cone = NurbsSurface::cone(center, radius, height, axis).expect("valid");
        for (u, v) in grid(&cone, 16) {
            // All points of a line of the side have the normal of its foot, the tip too.
            let out = (cone.eval(u, 0.0) - center) * (height / radius);
            let expected = (out + axis.normalize() * radius).normalize();
            let off = (cone.normal(u, v) - expected).length();
            assert!(off <= 1e-14, "{u} {v}: {off:e}");
        }
    }
}

#[test]
fn normals_at_poles_are_limits() {
    let mut rng = Rng(32);
    for _ in 0..200 {
        let (m, n) = (1 + rng.below(4), 1 + rng.below(4));
        let columns = m + 1;
        let mut net: Vec<DVec3> = (0..columns * (n + 1))
            .map(|_| random_point(&mut rng))
            .collect();
        let pole = random_point(&mut rng);
        net[..columns].fill(pole);
        let weights: Vec<f64> = net
            .iter()
            .map(|_| within(&mut rng, -1.0, 1.0).exp2())
            .collect();
        let patch = RationalPatch::new(&net, &weights, m, n).expect("valid");
        for u in [0.0, 0.3, 1.0] {
            assert!((patch.eval(u, 0.0) - pole).length() <= 4.0 * f64::EPSILON);
            let (at, near) = (
                patch.normal(u, 0.0),
                patch.normal(u.clamp(1e-7, 1.0 - 1e-7), 1e-7),
            );
            assert!((at.length() - 1.0).abs() < 1e-12);
            // Where ∂u × ∂v nearly vanishes beside the pole, too, the limit is far from its neighbours.
            let cross = |v: f64| {
                let p = patch.partials(u, v);
                p.u.cross(p.v).length() / v
            };
            if cross(1e-3) > 1e-1 {
                assert!((at - near).length() <= 1e-3, "{u}: {at} {near}");
            }
        }
    }
}

#[test]
fn normals_do_not_depend_on_the_size_of_weights() {
    let mut rng = Rng(37);
    for case in 0..200 {
        let (m, n) = (1 + rng.below(3), 1 + rng.below(3));
        let columns = m + 1;
        let count = columns * (n + 1);
        let net: Vec<DVec3> = (0..count).map(|_| random_point(&mut rng)).collect();
        let weights: Vec<f64> = net
            .iter()
            .map(|_| within(&mut rng, -30.0, 30.0).exp2())
            .collect();
        let patch = RationalPatch::new(&net, &weights, m, n).expect("valid");
        // At a corner, weights change only the lengths of the derivatives.
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let (i, j) = (if u > 0.0 { m } else { 0 }, if v > 0.0 { n } else { 0 });
            let corner = net[j * columns + i];
            let inner_u = net[j * columns + if i > 0 { m - 1 } else { 1 }] - corner;
            let inner_v = net[(if j > 0 { n - 1 } else { 1 }) * columns + i] - corner;
            let sign = (1.0 - 2.0 * u) * (1.0 - 2.0 * v);
            let expected = inner_u.cross(inner_v).normalize() * sign;
            let off = (patch.normal(u, v) - expected).length();
            assert!(off < 1e-12, "{case} at ({u}, {v}): {off:e}");
        }
        // The polynomial patch with other parameters: t/(1 − t) is multiplied by r along u and by s along v.
        let [r, s] = [(); 2].map(|()| within(&mut rng, -20.0, 20.0).exp2());
        let power = |x: f64, k: usize| x.powi(i32::try_from(k).expect("small"));
        let weights: Vec<f64> = (0..count)
            .map(|k| power(r, k % columns) * power(s, k / columns))
            .collect();
        let (patch, plain) = (
            RationalPatch::new(&net, &weights, m, n).expect("valid"),
            Patch::new(&net, m, n).expect("valid"),
        );
        let mapped = |t: f64, r: f64| r * t / (1.0 - t + r * t);
        for (u, v) in [(0.5, 0.5), (0.1, 0.9), (0.001, 0.3), (0.0, 0.3), (0.7, 1.0)] {
            let [a, b] = [mapped(u, r), mapped(v, s)];
            let partials = plain.partials(a, b);
            let expected = partials.u.cross(partials.v);
            if expected.length() > 0.1 {
                let off = (patch.normal(u, v) - expected.normalize()).length();
                // The derivatives have 2^-20 of the size of the patch, and its rounding errors.
                assert!(off < 1e-8, "{case} at ({u}, {v}): {off:e}");
            }
        }
    }
}

#[test]
fn normals_at_poles_do_not_depend_on_the_degree() {
    let sphere = NurbsSurface::sphere(DVec3::ONE, 2.0, DVec3::Z).expect("valid");
    let mut patch = sphere.patches()[0].clone();
    while patch.degree_u() < 24 {
        patch = patch.elevate().expect("a low degree");
        let off = (patch.normal(0.3, 0.0) + DVec3::Z).length();
        assert!(off <= 1e-10, "{}: {off:e}", patch.degree_u());
    }
}

#[test]
fn equal_weights_give_the_polynomial_patch() {
    let mut rng = Rng(33);
    for _ in 0..50 {
        let (m, n) = (1 + rng.below(4), 1 + rng.below(4));
        let net: Vec<DVec3> = (0..(m + 1) * (n + 1))
            .map(|_| random_point(&mut rng))
            .collect();
        let patch = Patch::new(&net, m, n).expect("valid");
        let plain = RationalPatch::from(&patch);
        let heavy = RationalPatch::new(&net, &vec![3.7; net.len()], m, n).expect("valid");
        for rational in [plain, heavy] {
            let (u, v) = (rng.unit(), rng.unit());
            let close = |a: DVec3, b: DVec3| assert!((a - b).length() <= 1e-12, "{a} {b}");
            close(rational.eval(u, v), patch.eval(u, v));
            let (a, b) = (rational.partials(u, v), patch.partials(u, v));
            let all = [
                (a.u, b.u),
                (a.v, b.v),
                (a.uu, b.uu),
                (a.uv, b.uv),
                (a.vv, b.vv),
            ];
            all.into_iter().for_each(|(a, b)| close(a, b));
            close(rational.normal(u, v), patch.normal(u, v));
            let (a, b) = (rational.curvature(u, v), patch.curvature(u, v));
            assert!(
                (a.k1 - b.k1).abs() <= 1e-9 * (1.0 + b.k1.abs()),
                "{a:?} {b:?}"
            );
            let (a, b) = (rational.bounds(), patch.bounds());
            close(a.min, b.min);
            close(a.max, b.max);
        }
    }
}

#[test]
fn partials_are_limits_of_differences() {
    let mut rng = Rng(34);
    for _ in 0..100 {
        let patch = random_patch(&mut rng, 3.0);
        let (u, v) = (within(&mut rng, 0.1, 0.9), within(&mut rng, 0.1, 0.9));
        let h = 1e-4;
        let p = patch.partials(u, v);
        let [right, left] = [h, -h].map(|h| (patch.eval(u + h, v), patch.partials(u + h, v)));
        let [up, down] = [h, -h].map(|h| (patch.eval(u, v + h), patch.partials(u, v + h)));
        let pairs = [
            (p.u, right.0 - left.0),
            (p.v, up.0 - down.0),
            (p.uu, right.1.u - left.1.u),
            (p.uv, up.1.u - down.1.u),
            (p.vv, up.1.v - down.1.v),
        ];
        for (k, (derivative, difference)) in pairs.into_iter().enumerate() {
            let off = (derivative - difference / (2.0 * h)).length();
            let size = 1.0 + p.uu.length() + p.uv.length() + p.vv.length();
            assert!(off <= 1e-4 * size * size, "{k}: {off:e} of {size}");
        }
    }
}

#[test]
fn splits_elevation_and_isocurves_keep_the_patch() {
    let mut rng = Rng(35);
    for _ in 0..100 {
        let patch = random_patch(&mut rng, 2.0);
        let (s, u, v) = (within(&mut rng, 0.1, 0.9), rng.unit(), rng.unit());
        let close =
            |a: DVec3, b: DVec3, what: &str| assert!((a - b).length() <= 1e-13, "{what}: {a} {b}");
        let ((left, right), (below, above)) = (
            patch.split_u(s).expect("valid"),
            patch.split_v(s).expect("valid"),
        );
        close(left.eval(u, v), patch.eval(u * s, v), "left");
        close(right.eval(u, v), patch.eval(s + u * (1.0 - s), v), "right");
        close(below.eval(u, v), patch.eval(u, v * s), "below");
        close(above.eval(u, v), patch.eval(u, s + v * (1.0 - s)), "above");
        let (m, n) = (patch.degree_u(), patch.degree_v());
        for row in 0..=n {
            let (a, b) = (row * (m + 1) + m, row * (m + 1));
            assert_eq!(left.control_points()[a], right.control_points()[b]);
            assert_eq!(left.weights()[a], right.weights()[b]);
        }
        let high = patch.elevate().expect("a low degree");
        assert_eq!((high.degree_u(), high.degree_v()), (m + 1, n + 1));
        close(high.eval(u, v), patch.eval(u, v), "elevated");
        let (along_v, along_u) = (
            patch.isocurve_at_u(u).expect("valid"),
            patch.isocurve_at_v(v).expect("valid"),
        );
        close(along_v.eval(v), patch.eval(u, v), "isocurve at u");
        close(along_u.eval(u), patch.eval(u, v), "isocurve at v");
        let start = patch.isocurve_at_v(0.0).expect("valid").eval(u);
        close(along_v.start(), start, "ends of isocurves");
        let map = DAffine3::from_cols(
            random_point(&mut rng),
            random_point(&mut rng),
            random_point(&mut rng),
            random_point(&mut rng),
        );
        let image = patch.transform(&map).expect("finite");
        close(
            image.eval(u, v),
            map.transform_point3(patch.eval(u, v)),
            "affine",
        );
        let mut matrix = DMat4::from(map);
        // The denominator is at least 2 − 0.3·3.
        (matrix.x_axis.w, matrix.y_axis.w, matrix.z_axis.w) = (0.3, -0.2, 0.1);
        matrix.w_axis.w = 2.0;
        let image = patch.project(&matrix).expect("positive weights");
        close(
            image.eval(u, v),
            matrix.project_point3(patch.eval(u, v)),
            "projective",
        );
    }
}

#[test]
fn bounds_contain_the_patch_and_touch_it() {
    let mut rng = Rng(36);
    for round in 0..40 {
        let patch = random_patch(&mut rng, 4.0);
        let bounds = patch.bounds();
        let steps = 100;
        let mut inner = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        for i in 0..=steps {
            for j in 0..=steps {
                let p = patch.eval(
                    f64::from(i) / f64::from(steps),
                    f64::from(j) / f64::from(steps),
                );
                inner = [inner[0].min(p), inner[1].max(p)];
            }
        }
        let excess = [inner[0] - bounds.min, bounds.max - inner[1]];
        for off in excess {
            assert!(off.min_element() >= -1e-14, "{round}: {off}");
            assert!(off.max_element() <= 2e-2, "{round}: {off}");
        }
    }
    let sphere = NurbsSurface::sphere(DVec3::new(1.0, 2.0, 3.0), 2.0, DVec3::new(1.0, 2.0, -1.0));
    let bounds = sphere.expect("valid").bounds();
    let expected = [DVec3::new(-1.0, 0.0, 1.0), DVec3::new(3.0, 4.0, 5.0)];
    assert!(
        (bounds.min - expected[0]).length() <= 1e-14,
        "{}",
        bounds.min
    );
    assert!(
        (bounds.max - expected[1]).length() <= 1e-14,
        "{}",
        bounds.max
    );
}

/// The value of a B-spline by its recursion, as a definition.
fn b_spline(i: usize, p: usize, knots: &[f64], t: f64) -> f64 {
    if p == 0 {
        return f64::from(u8::from(knots[i] <= t && t < knots[i + 1]));
    }
    let share = |a: f64, b: f64, value: f64| if b > a { value / (b - a) } else { 0.0 };
    let (a, b) = (knots[i], knots[i + p + 1]);
    share(a, knots[i + p], (t - a) * b_spline(i, p - 1, knots, t))
        + share(knots[i + 1], b, (b - t) * b_spline(i + 1, p - 1, knots, t))
}

#[test]
fn points_are_those_of_the_definition() {
    let mut rng = Rng(37);
    for _ in 0..60 {
        let surface = random_surface(&mut rng);
        let (p, q) = (surface.degree_u(), surface.degree_v());
        let columns = surface.knots_u().len() - p - 1;
        for (u, v) in grid(&surface, 7) {
            if u == surface.domain_u()[1] || v == surface.domain_v()[1] {
                continue;
            }
            let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
            for (k, (&point, w)) in surface
                .control_points()
                .iter()
                .zip(surface.weights())
                .enumerate()
            {
                let share = w
                    * b_spline(k % columns, p, surface.knots_u(), u)
                    * b_spline(k / columns, q, surface.knots_v(), v);
                sum += point * share;
                weight += share;
            }
            assert!((surface.eval(u, v) - sum / weight).length() <= 1e-13);
        }
    }
}

#[test]
fn operations_on_knots_keep_the_surface() {
    let mut rng = Rng(38);
    for _ in 0..40 {
        let surface = random_surface(&mut rng);
        let ([u0, u1], [v0, v1]) = (surface.domain_u(), surface.domain_v());
        let (s, t) = (
            within(&mut rng, u0 + 0.01, u1 - 0.01),
            within(&mut rng, v0 + 0.01, v1 - 0.01),
        );
        assert_same(
            &surface,
            &surface.insert_knot_u(s, 1).expect("inside"),
            "insert_knot_u",
        );
        assert_same(
            &surface,
            &surface.insert_knot_v(t, 1).expect("inside"),
            "insert_knot_v",
        );
        let high = surface.elevate_u().expect("low");
        assert_eq!(
            (high.degree_u(), high.degree_v()),
            (surface.degree_u() + 1, surface.degree_v())
        );
        assert_same(&surface, &high, "elevate_u");
        assert_same(&surface, &surface.elevate_v().expect("low"), "elevate_v");
        let (left, right) = surface.split_u(s).expect("inside");
        let (below, above) = surface.split_v(t).expect("inside");
        assert_eq!((left.domain_u(), right.domain_u()), ([u0, s], [s, u1]));
        for part in [left, right, below, above] {
            for (u, v) in grid(&part, 5) {
                assert!((part.eval(u, v) - surface.eval(u, v)).length() <= 1e-13);
            }
        }
        let (along_v, along_u) = (
            surface.isocurve_at_u(s).expect("inside"),
            surface.isocurve_at_v(t).expect("inside"),
        );
        assert_eq!(
            (along_v.knots(), along_u.knots()),
            (surface.knots_v(), surface.knots_u())
        );
        for (u, v) in grid(&surface, 6) {
            assert!((along_v.eval(v) - surface.eval(s, v)).length() <= 1e-13);
            assert!((along_u.eval(u) - surface.eval(u, t)).length() <= 1e-13);
        }
        let back = surface.reverse();
        assert_eq!(back.domain_u(), surface.domain_u());
        assert!((back.eval(u0 + (u1 - s), t) - surface.eval(s, t)).length() <= 1e-12);
        assert!((back.normal(u0 + (u1 - s), t) + surface.normal(s, t)).length() <= 1e-6);
        let map = DAffine3::from_rotation_y(0.3) * DAffine3::from_translation(DVec3::ONE);
        let image = surface.transform(&map).expect("finite");
        let off = image.eval(s, t) - map.transform_point3(surface.eval(s, t));
        assert!(off.length() <= 1e-14);
        let p = surface.partials(s, t);
        let h = 1e-6;
        let along_u = (surface.eval(s + h, t) - surface.eval(s - h, t)) / (2.0 * h);
        assert!((p.u - along_u).length() <= 1e-6 * (1.0 + p.uu.length()).powi(2));
    }
}

#[test]
fn adjacent_patches_share_their_edges() {
    let mut rng = Rng(39);
    let mut surfaces: Vec<NurbsSurface> = (0..20).map(|_| random_surface(&mut rng)).collect();
    surfaces
        .push(NurbsSurface::torus(DVec3::ONE, 2.0, 0.3, DVec3::new(1.0, 2.0, 3.0)).expect("valid"));
    let turned = surfaces.len() - 1;
    for (index, surface) in surfaces.iter().enumerate() {
        let (m, n) = (surface.degree_u(), surface.degree_v());
        let (columns, rows) = (surface.joints_u().len() - 1, surface.joints_v().len() - 1);
        assert_eq!(surface.patches().len(), columns * rows);
        let part = |patch: &RationalPatch, column: usize, row: usize| {
            let i = row * (m + 1) + column;
            (patch.control_points()[i], patch.weights()[i])
        };
        for j in 0..rows {
            for i in 0..columns {
                let patch = &surface.patches()[j * columns + i];
                // The last one is closed in both directions.
                let (right, above) = ((i + 1) % columns, (j + 1) % rows);
                if right > 0 || index == turned {
                    let next = &surface.patches()[j * columns + right];
                    (0..=n).for_each(|row| assert_eq!(part(patch, m, row), part(next, 0, row)));
                }
                if above > 0 || index == turned {
                    let next = &surface.patches()[above * columns + i];
                    (0..=m).for_each(|column| {
                        assert_eq!(part(patch, column, n), part(next, column, 0))
                    });
                }
                let (u, v) = (surface.joints_u(), surface.joints_v());
                let middle = surface.eval(0.5 * (u[i] + u[i + 1]), 0.5 * (v[j] + v[j + 1]));
                assert!((patch.eval(0.5, 0.5) - middle).length() <= 1e-14);
            }
        }
    }
}

fn profile(points: &[(f64, f64)], weights: &[f64]) -> NurbsCurve<DVec3> {
    let points: Vec<DVec3> = points.iter().map(|&(x, z)| DVec3::new(x, 0.0, z)).collect();
    NurbsCurve::from(&RationalCurve::new(&points, weights).expect("valid"))
}

#[test]
fn a_profile_turns_around_an_axis() {
    let vase = profile(
        &[(1.0, 0.0), (2.0, 0.5), (0.3, 1.0), (0.8, 2.0)],
        &[1.0, 2.0, 0.7, 1.0],
    );
    for angle in [TAU, PI, 1.0, -2.0, -TAU] {
        let surface =
            NurbsSurface::revolve(&vase, DVec3::ZERO, DVec3::Z * 3.0, angle).expect("valid");
        assert_eq!(
            (surface.domain_u(), surface.domain_v()),
            ([0.0, 1.0], [0.0, 1.0])
        );
        for (u, v) in grid(&surface, 16) {
            let (p, on_profile) = (surface.eval(u, v), vase.eval(v));
            assert!((p.truncate().length() - on_profile.x).abs() <= 4.0 * f64::EPSILON);
            assert!((p.z - on_profile.z).abs() <= 4.0 * f64::EPSILON);
        }
        let end = surface.eval(1.0, 0.0);
        assert!(
            (end - DVec3::new(angle.cos(), angle.sin(), 0.0)).length() <= 1e-15,
            "{end}"
        );
    }
    // Both ends on an axis that is not through the origin.
    let axis = DVec3::new(1.0, 2.0, -1.0).normalize();
    let origin = DVec3::new(0.3, -0.2, 0.1);
    let side = axis.any_orthonormal_vector();
    let arc = NurbsCurve::arc(origin, -axis, side, 0.0, PI).expect("valid");
    let sphere = NurbsSurface::revolve(&arc, origin, axis, TAU).expect("touches at its ends");
    let columns = sphere.knots_u().len() - 3;
    let rows: Vec<&[DVec3]> = sphere.control_points().chunks(columns).collect();
    for row in [rows[0], rows[rows.len() - 1]] {
        assert!(row.iter().all(|&p| p == row[0]), "a pole");
    }
    for (u, v) in grid(&sphere, 16) {
        assert!(((sphere.eval(u, v) - origin).length() - 1.0).abs() <= 4.0 * f64::EPSILON);
        assert!((sphere.normal(u, v) - (sphere.eval(u, v) - origin)).length() <= 1e-14);
    }
}

#[test]
fn a_profile_that_crosses_its_axis_is_refused() {
    let revolve =
        |curve: &NurbsCurve<DVec3>| NurbsSurface::revolve(curve, DVec3::ZERO, DVec3::Z, TAU);
    let message = |curve: &NurbsCurve<DVec3>| revolve(curve).expect_err("refused").to_string();
    let line = profile(&[(-1.0, 0.0), (1.0, 1.0)], &[1.0, 1.0]);
    assert_eq!(
        message(&line),
        "t where the profile meets the axis: expected an end of the profile, got 0.5"
    );
    // It touches the axis in the middle, lies on it, or passes through it in space.
    let touching = profile(&[(1.0, 0.0), (-1.0, 0.5), (1.0, 1.0)], &[1.0, 1.0, 1.0]);
    let straight = profile(&[(0.0, 0.0), (0.0, 1.0)], &[1.0, 1.0]);
    let points = [DVec3::new(-1.0, -2.0, 0.0), DVec3::new(1.0, 2.0, 1.0)];
    let space = NurbsCurve::from(&RationalCurve::new(&points, &[1.0, 1.0]).expect("valid"));
    for refused in [touching, straight, space] {
        assert!(message(&refused).starts_with("t where the profile meets"));
    }
    // A control polygon that crosses, a curve that passes beside the axis, and both ends on the axis.
    let near = profile(&[(1.0, 0.0), (-0.5, 0.5), (1.0, 1.0)], &[1.0, 1.0, 1.0]);
    let points = [DVec3::new(-1.0, 0.1, 0.0), DVec3::new(1.0, 0.1, 1.0)];
    let beside = NurbsCurve::from(&RationalCurve::new(&points, &[1.0, 1.0]).expect("valid"));
    let flat = profile(
        &[(0.0, 0.0), (0.0, 0.5), (1.0, 0.7), (0.0, 1.0)],
        &[1.0, 1.0, 1.0, 1.0],
    );
    for accepted in [near, beside, flat] {
        assert!(revolve(&accepted).is_ok());
    }
}

#[test]
fn normals_at_a_tip_along_the_axis_are_radial() {
    // The tangent of the profile at its start is the axis, so all tangent planes at the tip contain the axis.
    let dome = profile(
        &[(0.0, 0.0), (0.0, 0.5), (1.0, 0.7), (0.0, 1.0)],
        &[1.0, 1.0, 2.0, 1.0],
    );
    for angle in [TAU, 2.0] {
        let surface = NurbsSurface::revolve(&dome, DVec3::ZERO, DVec3::Z, angle).expect("valid");
        for k in 0..=20 {
            let u = f64::from(k) / 20.0;
            let out = surface.eval(u, 0.5).truncate().normalize().extend(0.0);
            let normal = surface.normal(u, 0.0);
            assert!((normal - out).length() <= 1e-12, "{u}: {normal} {out}");
        }
    }
}

/// ∬ |∂u × ∂v| over all patches, by a Gauss rule of 6 × 6 points on 8 × 8 parts of each.
fn area(surface: &NurbsSurface) -> f64 {
    // The positive nodes and the weights of 6 points over [−1, 1].
    let rule = [
        (0.238_619_186_083_196_9, 0.467_913_934_572_691),
        (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
        (0.932_469_514_203_152, 0.171_324_492_379_170_35),
    ];
    let parts = 8;
    let nodes: Vec<(f64, f64)> = (0..parts)
        .flat_map(|k| {
            let place = move |z: f64| (f64::from(k) + 0.5 + 0.5 * z) / f64::from(parts);
            let both = move |(z, w): (f64, f64)| {
                let w = 0.5 * w / f64::from(parts);
                [(place(z), w), (place(-z), w)]
            };
            rule.into_iter().flat_map(both)
        })
        .collect();
    let mut sum = 0.0;
    for patch in surface.patches() {
        for (u, a) in &nodes {
            for (v, b) in &nodes {
                let p = patch.partials(*u, *v);
                sum += a * b * p.u.cross(p.v).length();
            }
        }
    }
    sum
}

#[test]
fn areas_are_those_of_pappus() {
    let relative = |found: f64, expected: f64| {
        assert!((found / expected - 1.0).abs() <= 1e-9, "{found} {expected}");
    };
    let axis = DVec3::new(1.0, -2.0, 0.5);
    let sphere = NurbsSurface::sphere(DVec3::ONE, 1.5, axis).expect("valid");
    relative(area(&sphere), 4.0 * PI * 1.5 * 1.5);
    let torus = NurbsSurface::torus(DVec3::ONE, 2.0, 0.6, axis).expect("valid");
    relative(area(&torus), 4.0 * PI * PI * 2.0 * 0.6);
    let cylinder = NurbsSurface::cylinder(DVec3::ONE, 2.0, 3.0, axis).expect("valid");
    relative(area(&cylinder), TAU * 2.0 * 3.0);
    let cone = NurbsSurface::cone(DVec3::ONE, 3.0, 4.0, axis).expect("valid");
    relative(area(&cone), PI * 3.0 * 5.0);
    // Angle · length · distance of the centroid, here of a circle, turned by less than a full turn.
    let circle = NurbsCurve::arc(DVec3::X * 3.0, DVec3::X, DVec3::Z, 0.0, TAU).expect("valid");
    let part = NurbsSurface::revolve(&circle, DVec3::ZERO, DVec3::Z, 2.0).expect("valid");
    relative(area(&part), 2.0 * TAU * 3.0);
}

#[test]
fn bounds_of_many_patches_search_few() {
    let (degree, count) = (3, 24);
    let knots: Vec<f64> = (0..count + degree + 1)
        .map(|k| (k.clamp(degree, count) - degree) as f64)
        .collect();
    let net: Vec<DVec3> = (0..count * count)
        .map(|i| DVec3::new((i % count) as f64, (i / count) as f64, (i as f64).sin()))
        .collect();
    let surface = NurbsSurface::new(degree, degree, &net, None, &knots, &knots).expect("valid");
    let network = surface.to_surface().expect("valid");
    take_steps();
    let expected = network.bounds().expect("patches");
    let of_network = take_steps();
    assert_eq!(surface.bounds(), expected);
    assert_eq!(take_steps(), of_network);
    let every: usize = surface
        .patches()
        .iter()
        .map(|patch| {
            patch.bounds();
            take_steps()
        })
        .sum();
    assert!(4 * of_network < every, "{of_network}, {every}");
}

#[test]
fn ruled_extruded_and_plane_surfaces() {
    let plane = NurbsSurface::plane(DVec3::ONE, DVec3::X * 2.0, DVec3::Y).expect("finite");
    assert_eq!(plane.eval(0.25, 0.5), DVec3::new(1.5, 1.5, 1.0));
    assert_eq!(plane.normal(0.5, 0.5), DVec3::Z);
    let mut rng = Rng(40);
    let weights = [1.0, 2.0, 0.5, 3.0, 1.0];
    let points: Vec<DVec3> = weights.iter().map(|_| random_point(&mut rng)).collect();
    let knots = [2.0, 2.0, 2.0, 3.0, 4.5, 5.0, 5.0, 5.0];
    let a = NurbsCurve::new(2, &points, Some(&weights), &knots, false).expect("valid");
    let b = profile(
        &[(0.0, 0.0), (1.0, 2.0), (2.0, 0.0), (3.0, 1.0)],
        &[2.0, 1.0, 1.0, 3.0],
    );
    let ruled = NurbsSurface::ruled(&a, &b).expect("valid");
    assert_eq!((ruled.degree_u(), ruled.degree_v()), (3, 1));
    for (u, _) in grid(&ruled, 20) {
        assert!((ruled.eval(u, 0.0) - a.eval(2.0 + 3.0 * u)).length() <= 1e-13);
        assert!((ruled.eval(u, 1.0) - b.eval(u)).length() <= 1e-13);
        // Points between are on the line.
        let (p, q, r) = (ruled.eval(u, 0.0), ruled.eval(u, 0.3), ruled.eval(u, 1.0));
        assert!((q - p).cross(r - p).length() <= 1e-12);
    }
    let moved = NurbsSurface::extrude(&a, DVec3::Z).expect("valid");
    for (u, v) in grid(&moved, 10) {
        assert!((moved.eval(u, v) - a.eval(2.0 + 3.0 * u) - DVec3::Z * v).length() <= 1e-13);
    }
    // A closed curve is opened at its start.
    let closed =
        NurbsCurve::new(2, &points, None, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], true).expect("valid");
    let tube = NurbsSurface::extrude(&closed, DVec3::Z).expect("valid");
    assert_eq!(tube.eval(0.0, 0.5), tube.eval(1.0, 0.5));
    assert!((tube.eval(0.3, 0.0) - closed.eval(1.5)).length() <= 1e-13);
}

#[test]
fn lofts_pass_through_their_curves() {
    let circle = |z: f64, r: f64| {
        NurbsCurve::arc(DVec3::Z * z, DVec3::X * r, DVec3::Y * r, 0.0, TAU).expect("valid")
    };
    let circles = [
        circle(0.0, 1.0),
        circle(1.0, 0.5),
        circle(1.5, 0.8),
        circle(3.0, 0.2),
    ];
    let vase = NurbsSurface::loft(&circles, 3).expect("valid");
    assert_eq!((vase.degree_u(), vase.degree_v()), (2, 3));
    assert_eq!(vase.domain_v(), [0.0, 1.0]);
    assert_eq!(vase.isocurve_at_v(0.0).expect("inside"), circles[0]);
    assert_eq!(vase.isocurve_at_v(1.0).expect("inside"), circles[3]);
    // Circles that are interpolated point by point are circles.
    for (u, v) in grid(&vase, 20) {
        let (p, start) = (vase.eval(u, v), vase.eval(0.0, v));
        assert!((p.truncate().length() - start.x).abs() <= 1e-14 && (p.z - start.z).abs() <= 1e-14);
    }
    // Different degrees, knots and weights.
    let mut rng = Rng(41);
    for _ in 0..30 {
        let curves: Vec<NurbsCurve<DVec3>> = (0..4)
            .map(|k| {
                let p = 1 + rng.below(3);
                let inner = rng.below(4);
                let knots = random_knots(&mut rng, p, inner);
                let count = knots.len() - p - 1;
                let points: Vec<DVec3> = (0..count)
                    .map(|_| random_point(&mut rng) + DVec3::Z * f64::from(k) * 3.0)
                    .collect();
                let weights: Vec<f64> = (0..count).map(|_| within(&mut rng, 0.9, 1.1)).collect();
                NurbsCurve::new(p, &points, Some(&weights), &knots, false).expect("valid")
            })
            .collect();
        let loft = NurbsSurface::loft(&curves, 2).expect("weights near 1");
        for curve in &curves {
            let [from, to] = curve.domain();
            let at = |u: f64| curve.eval(from + (to - from) * u);
            // The curve is the isocurve through its start.
            let start = loft.isocurve_at_u(0.0).expect("inside");
            let v = start.nearest(curve.start()).expect("finite").t;
            for k in 0..=10 {
                let u = f64::from(k) / 10.0;
                assert!((loft.eval(u, v) - at(u)).length() <= 1e-8, "{u} {v}");
            }
        }
    }
}

#[test]
fn bad_input_is_refused_by_name() {
    let message = |result: Result<NurbsSurface, Error>| result.expect_err("refused").to_string();
    let (net, knots) = ([DVec3::ZERO; 4], [0.0, 0.0, 1.0, 1.0]);
    let new = |net: &[DVec3], weights: Option<&[f64]>, u: &[f64], v: &[f64]| {
        message(NurbsSurface::new(1, 1, net, weights, u, v))
    };
    assert_eq!(
        message(NurbsSurface::new(0, 1, &net, None, &knots, &knots)),
        "degree_u: expected a whole number from 1 to 64, got 0"
    );
    assert_eq!(
        new(&net, None, &knots, &knots[1..]),
        "knots_v: expected at least 2·(degree + 1) knots (rhino3dm leaves out the first and the last one), got 3"
    );
    assert_eq!(
        new(&net[1..], None, &knots, &knots),
        "net: expected (knots_u − degree_u − 1)·(knots_v − degree_v − 1) control points (rhino3dm leaves out the first and the last knot), got 3"
    );
    assert_eq!(
        new(&net, Some(&[1.0; 3]), &knots, &knots),
        "weights: expected a weight for each point, got 3"
    );
    assert_eq!(
        new(&net, Some(&[1.0, 1.0, 0.0, 1.0]), &knots, &knots),
        "weights[2]: expected a number above 0, from 2^-500 to 2^500, got 0"
    );
    assert!(new(&net, None, &knots, &[0.0, 1.0, 0.5, 1.0]).starts_with("knots_v[2]: "));
    assert!(
        new(&net, None, &[0.0, 0.0, f64::NAN, 1.0], &knots)
            .starts_with("knots_u[2]: expected a finite")
    );
    let bad = [DVec3::ZERO, DVec3::NAN, DVec3::ZERO, DVec3::ZERO];
    assert_eq!(
        new(&bad, None, &knots, &knots),
        "net[1]: expected a finite number, got NaN"
    );
    assert_eq!(
        message(NurbsSurface::sphere(DVec3::ZERO, -1.0, DVec3::Z)),
        "radius: expected a number from 0, got -1"
    );
    assert_eq!(
        message(NurbsSurface::sphere(DVec3::ZERO, 1.0, DVec3::ZERO)),
        "axis: expected a vector that is not 0, got 0"
    );
    assert_eq!(
        message(NurbsSurface::torus(DVec3::ZERO, 1.0, 2.0, DVec3::Z)),
        "major_radius: expected a number above the minor radius, got 1"
    );
    let line = profile(&[(1.0, 0.0), (1.0, 1.0)], &[1.0, 1.0]);
    assert_eq!(
        message(NurbsSurface::revolve(&line, DVec3::ZERO, DVec3::Z, 7.0)),
        "angle: expected at most a full turn, 2π, got 7"
    );
    assert_eq!(
        message(NurbsSurface::loft(std::slice::from_ref(&line), 1)),
        "curves: expected at least degree + 1 curves, got 1"
    );
    assert!(
        message(NurbsSurface::loft(&[line.clone(), line.clone()], 1))
            .starts_with("curves[1]: expected a curve that differs")
    );
    let points = [DVec3::X, DVec3::Y, DVec3::Z];
    let closed = NurbsCurve::new(2, &points, None, &[0.0, 1.0, 2.0, 3.0], true).expect("valid");
    assert_eq!(
        message(NurbsSurface::loft(&[line.clone(), closed], 1)),
        "index of the first curve of another kind: expected either open or closed curves, got 1"
    );
    // A weight that is small between large ones would fall below 0.
    let heavy = |x: f64, w: f64| profile(&[(x, 0.0), (x, 1.0)], &[1.0, w]);
    let uneven = [
        heavy(1.0, 1.0),
        heavy(2.0, 100.0),
        heavy(3.0, 1.0),
        heavy(4.0, 100.0),
    ];
    assert!(message(NurbsSurface::loft(&uneven, 3)).starts_with("weights in v["));
    let surface = NurbsSurface::plane(DVec3::ZERO, DVec3::X, DVec3::Y).expect("valid");
    let error = surface.isocurve_at_u(1.5).expect_err("outside");
    assert_eq!(
        error.to_string(),
        "u: expected a number in the domain of the surface, got 1.5"
    );
    let patch = &surface.patches()[0];
    assert!(patch.split_u(f64::NAN).is_err() && patch.isocurve_at_v(f64::INFINITY).is_err());
    assert!(RationalPatch::new(&net, &[1.0; 3], 1, 1).is_err());
    // Radius 0 gives a defined result.
    let point = NurbsSurface::sphere(DVec3::ONE, 0.0, DVec3::Z).expect("a point");
    assert_eq!(
        (point.eval(0.3, 0.4), point.normal(0.3, 0.4)),
        (DVec3::ONE, DVec3::ZERO)
    );
    assert_eq!(point.curvature(0.3, FRAC_PI_2 / 2.0).gaussian, 0.0);
}
