//! Solids of revolution: closed, with the volumes of Pappus, and caps in their planes.

use super::mesh::{deviation, edges};
use super::within;
use crate::support::nets::triangles;
use crate::support::{Rng, cases};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Mesh, NurbsCurve, RationalSurface};
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const CENTER: DVec3 = DVec3::new(0.3, -0.2, 0.5);

const ANGLES: [f64; 6] = [TAU, -TAU, FRAC_PI_2, -1.0, 0.1, 6.0];

fn axis() -> DVec3 {
    DVec3::new(1.0, 2.0, 3.0).normalize()
}

/// The point at a distance from the axis, a height along it, and an angle around it.
fn at(r: f64, z: f64, angle: f64) -> DVec3 {
    let (x, y) = axis().any_orthonormal_pair();
    CENTER + (x * angle.cos() + y * angle.sin()) * r + axis() * z
}

fn clamped(degree: usize, count: usize) -> Vec<f64> {
    let spans = u32::try_from(count - degree).expect("few");
    let inner = (1..spans).map(f64::from);
    let ends = |t: f64| std::iter::repeat_n(t, degree + 1);
    ends(0.0)
        .chain(inner)
        .chain(ends(f64::from(spans)))
        .collect()
}

/// A profile with uniform knots in a half-plane.
fn profile(degree: usize, points: &[(f64, f64)], weights: Option<&[f64]>) -> NurbsCurve<DVec3> {
    let points: Vec<DVec3> = points.iter().map(|&(r, z)| at(r, z, 0.0)).collect();
    NurbsCurve::new(
        degree,
        &points,
        weights,
        &clamped(degree, points.len()),
        false,
    )
    .expect("valid")
}

fn circle(r: f64, radius: f64) -> NurbsCurve<DVec3> {
    let out = at(1.0, 0.0, 0.0) - CENTER;
    NurbsCurve::arc(at(r, 0.0, 0.0), out * radius, axis() * radius, 0.0, TAU).expect("valid")
}

fn solid(profile: &NurbsCurve<DVec3>, angle: f64) -> RationalSurface {
    RationalSurface::solid_of_revolution(profile, CENTER, axis(), angle).expect("valid")
}

/// ½ ∫ r² dz along an open profile, by Simpson's rule between its joints.
fn half_moment(profile: &NurbsCurve<DVec3>) -> f64 {
    let at = |t: f64, inside: f64| {
        let p = profile.eval(t) - CENTER;
        let radius = p - axis() * p.dot(axis());
        let rate = profile.derivative_at(inside, 1).expect("valid").dot(axis());
        0.5 * radius.length_squared() * rate
    };
    let steps = 4000;
    let pairs = profile.joints().windows(2);
    pairs
        .map(|ends| {
            let step = (ends[1] - ends[0]) / f64::from(2 * steps);
            let sum: f64 = (0..=2 * steps)
                .map(|k| {
                    let t = ends[0] + f64::from(k) * step;
                    // The derivatives of both sides of a joint differ.
                    let inside = t.min(ends[1] - 1e-13);
                    let factor = match k {
                        0 => 1.0,
                        _ if k == 2 * steps => 1.0,
                        _ => f64::from(2 + 2 * (k % 2)),
                    };
                    factor * at(t, inside)
                })
                .sum();
            sum * step / 3.0
        })
        .sum()
}

/// The Euler characteristic of a mesh that has triangles without area: some of their edges may be one line.
const ANY: i64 = i64::MAX;

/// Asserts that as many triangles traverse each edge in one direction as in the other.
fn assert_balanced(mesh: &Mesh<f64>, name: &str) {
    let mut balance: HashMap<[usize; 2], i32> = HashMap::new();
    for triangle in triangles(mesh) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            *balance.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    assert!(balance.values().all(|&sum| sum == 0), "{name}");
}

/// Asserts that the solid is closed, and its volume; its mesh, too.
fn assert_solid(surface: &RationalSurface, volume: f64, euler: i64, name: &str) {
    let topology = surface.topology();
    assert!(topology.open.is_empty(), "{name}: {:?}", topology.open);
    assert!(topology.non_manifold.is_empty(), "{name}");
    assert!(surface.weight_mismatches().is_empty(), "{name}");
    assert_eq!(topology.components.len(), 1, "{name}");
    let got = surface.volume().expect("closed");
    assert!(
        (got / volume - 1.0).abs() < 1e-9,
        "{name}: {got} for {volume}"
    );
    for tolerance in [0.1, 0.01] {
        let options = TessellationOptions::tolerance(tolerance);
        let mesh = surface
            .tessellate_f64(&options.weld(Weld::Position))
            .expect("valid");
        if euler == ANY {
            assert_balanced(&mesh, name);
        } else {
            assert_eq!(edges(&mesh), (0, euler), "{name} at {tolerance}");
        }
        let own = surface
            .tessellate_f64(&options.weld(Weld::None))
            .expect("valid");
        assert!(
            deviation(surface, &own) <= tolerance,
            "{name} at {tolerance}"
        );
    }
}

/// Open profiles that run along the axis.
fn profiles() -> Vec<(&'static str, NurbsCurve<DVec3>)> {
    let w = [1.0, 0.3, 2.0, 5.0, 1.0];
    let helix = [
        (1.0, 0.0, 0.0),
        (2.0, 0.3, 0.4),
        (0.5, 1.0, 1.1),
        (1.5, 1.5, 2.0),
    ];
    let helix = helix.map(|(r, z, angle)| at(r, z, angle));
    let arc = NurbsCurve::arc(CENTER, axis() * -1.5, at(1.5, 0.0, 0.0) - CENTER, 0.0, PI);
    vec![
        ("cylinder", profile(1, &[(1.0, 0.0), (1.0, 2.0)], None)),
        ("cone", profile(1, &[(1.0, 0.0), (0.0, 2.0)], None)),
        (
            "frustum downwards",
            profile(1, &[(1.0, 1.0), (2.0, -0.5)], None),
        ),
        ("sphere", arc.expect("valid")),
        (
            "vase",
            profile(
                3,
                &[(0.0, 0.0), (1.5, 0.0), (0.2, 1.0), (0.6, 2.0), (1.0, 2.1)],
                Some(&w),
            ),
        ),
        (
            "twisted",
            NurbsCurve::new(3, &helix, None, &clamped(3, 4), false).expect("valid"),
        ),
        (
            "shaft with steps",
            profile(1, &[(2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 3.0)], None),
        ),
        (
            "flat end of degree 2",
            profile(
                2,
                &[(0.0, 0.0), (0.4, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 2.0)],
                None,
            ),
        ),
        (
            "repeated points",
            profile(
                1,
                &[(1.0, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 1.0), (2.0, 2.0)],
                None,
            ),
        ),
        (
            "cylinder from the axis to the axis",
            profile(1, &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], None),
        ),
    ]
}

#[test]
fn solids_of_open_profiles_are_closed() {
    for (name, profile) in profiles() {
        let moment = half_moment(&profile).abs();
        for angle in ANGLES {
            let name = format!("{name} turned by {angle}");
            let volume = moment * angle.abs();
            let euler = if name.starts_with("flat end") && angle.abs() < TAU {
                ANY
            } else {
                2
            };
            assert_solid(&solid(&profile, angle), volume, euler, &name);
            assert_solid(&solid(&profile.reverse(), angle), volume, euler, &name);
        }
    }
}

#[test]
fn solids_of_closed_profiles_are_closed() {
    let triangle = [(1.0, 0.0), (3.0, 0.5), (2.0, 2.0), (1.0, 0.0)];
    // A loop that starts and ends on the axis.
    let drop = [(0.0, 0.0), (2.0, -1.0), (2.0, 1.0), (0.0, 0.0)];
    let loops = [
        ("elbow", circle(2.0, 0.5), PI * 0.25 * 2.0, 0),
        ("triangle", profile(1, &triangle, None), 1.75 * 2.0, 0),
        (
            "drop, whose poles are one point",
            profile(3, &drop, None),
            half_moment(&profile(3, &drop, None)).abs(),
            1,
        ),
    ];
    for (name, profile, moment, euler) in loops {
        for angle in ANGLES {
            let name = format!("{name} turned by {angle}");
            let euler = if angle.abs() == TAU { euler } else { 2 };
            assert_solid(&solid(&profile, angle), moment * angle.abs(), euler, &name);
            assert_solid(
                &solid(&profile.reverse(), angle),
                moment * angle.abs(),
                euler,
                &name,
            );
        }
    }
    // A closed curve is opened at its start.
    let corners = [(2.0, 0.0), (3.0, 0.0), (3.0, 1.0), (2.0, 1.0)].map(|(r, z)| at(r, z, 0.0));
    let knots = [0.0, 1.0, 2.0, 3.0, 4.0];
    let square = NurbsCurve::new(1, &corners, None, &knots, true).expect("valid");
    assert_solid(&solid(&square, 1.0), 2.5, 2, "square");
    assert_solid(&solid(&square, TAU), 2.5 * TAU, 0, "square");
}

#[test]
fn caps_lie_in_their_planes_and_look_outwards() {
    let (first, last) = (1.5, 0.75);
    let frustum = profile(1, &[(first, 0.0), (last, 2.0)], None);
    let angle = 2.0;
    let quarter_turns = 2;
    let caps = |surface: &RationalSurface| -> Vec<(DVec3, DVec3)> {
        let patches = surface.patches();
        patches
            .map(|patch| (patch.eval(0.3, 0.6), patch.normal(0.3, 0.6)))
            .collect()
    };
    let part = caps(&solid(&frustum, angle));
    // The plane of the start, that of the end, and two sectors.
    let tangent = |angle: f64| axis().cross(at(1.0, 0.0, angle) - CENTER);
    let planes = [
        (CENTER, -tangent(0.0), 1),
        (CENTER, tangent(angle), 1),
        (CENTER, -axis(), quarter_turns),
        (CENTER + axis() * 2.0, axis(), quarter_turns),
    ];
    let mut found = part.iter();
    for (origin, normal, count) in planes {
        for (p, n) in found.by_ref().take(count) {
            assert!((*p - origin).dot(normal).abs() < 1e-15, "{p} for {normal}");
            assert!((*n - normal).length() < 1e-14, "{n} for {normal}");
        }
    }
    let disks = caps(&solid(&frustum, TAU));
    assert_eq!(disks.len(), 12);
    assert!(
        disks[..4]
            .iter()
            .all(|(_, n)| (*n + axis()).length() < 1e-14)
    );
    assert!(
        disks[4..8]
            .iter()
            .all(|(_, n)| (*n - axis()).length() < 1e-14)
    );
    // No disk at an end on the axis.
    let cone = profile(1, &[(1.0, 0.0), (0.0, 1.0)], None);
    assert_eq!(solid(&cone, TAU).patch_count(), 8);
}

#[test]
fn profiles_that_turn_back_have_no_caps_in_their_plane() {
    let refused = |profile: &NurbsCurve<DVec3>| {
        let result = RationalSurface::solid_of_revolution(profile, CENTER, axis(), 1.0);
        result.map(|_| ()).expect_err("refused").to_string()
    };
    let wall = profile(
        1,
        &[(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.8, 0.5), (0.0, 0.5)],
        None,
    );
    assert_eq!(
        refused(&wall),
        "t where the profile turns back along the axis: expected no such place for less than a full turn, got 2"
    );
    // The other way round the places are those between the same knots.
    assert!(refused(&wall.reverse()).ends_with(", got 1"));
    let volume = PI * (2.0 - 0.64 / 3.0 * 1.5 - (0.2 / 3.0 * (0.8 + 2.0)) * 1.5);
    let full = solid(&wall, TAU);
    assert!((full.volume().expect("closed") / (TAU * half_moment(&wall)) - 1.0).abs() < 1e-9);
    assert!(full.volume().expect("closed") > 0.0 && volume > 0.0);
    // The height is 3t²(1 − t)·1 + 3t(1 − t)²·1 − … : a cubic whose height has two extrema.
    let wave = profile(3, &[(1.0, 0.0), (1.0, 2.0), (1.0, -1.0), (1.0, 1.0)], None);
    let got = refused(&wave);
    // z′/3 = 2 (1 − t)² − 6t (1 − t) + 2t² = 10t² − 10t + 2.
    let t = 0.5 - 0.05_f64.sqrt();
    let number = got
        .rsplit(' ')
        .next()
        .and_then(|word| word.parse::<f64>().ok());
    assert!((number.expect("a number") - t).abs() < 1e-14, "{got}");
    // An L cannot be seen from its centroid.
    let corner = [
        (1.0, 0.0),
        (4.0, 0.0),
        (4.0, 0.2),
        (1.2, 0.2),
        (1.2, 3.0),
        (1.0, 3.0),
        (1.0, 0.0),
    ];
    let corner = profile(1, &corner, None);
    assert!(refused(&corner).starts_with("t where the profile turns back around its centroid: "));
    assert!(solid(&corner, TAU).volume().expect("closed") > 0.0);
    let crossing = profile(1, &[(-1.0, 0.0), (1.0, 1.0)], None);
    assert!(refused(&crossing).contains("meets the axis"));
}

/// Heights and radii at random, with weights and inner knots: closed, and a positive volume.
#[test]
fn random_profiles_give_closed_solids() {
    let mut rng = Rng(31);
    for case in 0..cases(40, 600) {
        let degree = 1 + rng.below(4);
        let count = degree + 1 + rng.below(4);
        let mut z = 0.0;
        let tilted = axis() * within(&mut rng, 0.5, 2.0);
        let points: Vec<(f64, f64)> = (0..count)
            .map(|k| {
                // Horizontal steps, too.
                z += if rng.chance(0.2) { 0.0 } else { rng.unit() };
                let is_end = k == 0 || k + 1 == count;
                (
                    if is_end && rng.chance(0.3) {
                        0.0
                    } else {
                        0.1 + rng.unit()
                    },
                    z,
                )
            })
            .collect();
        let weights: Vec<f64> = (0..count)
            .map(|_| within(&mut rng, -8.0, 8.0).exp2())
            .collect();
        let profile = profile(degree, &points, Some(&weights));
        let size = [1.0, 1e-9, 1e9][rng.below(3)];
        let map = DAffine3::from_scale(DVec3::splat(size));
        let profile = profile.transform(&map).expect("valid");
        let angle = if rng.chance(0.3) {
            TAU
        } else {
            within(&mut rng, -TAU, TAU)
        };
        let solid = RationalSurface::solid_of_revolution(&profile, CENTER * size, tilted, angle);
        let solid = solid.expect("valid");
        let topology = solid.topology();
        assert!(
            topology.open.is_empty() && topology.non_manifold.is_empty(),
            "{case}"
        );
        if z > 0.01 {
            assert!(solid.volume().expect("closed") > 0.0, "{case}");
        }
    }
}

#[test]
fn degenerate_solids_are_defined() {
    let point = profile(1, &[(1.0, 0.0), (1.0, 0.0)], None);
    let flat = profile(2, &[(1.0, 0.0), (3.0, 0.0), (2.0, 0.0)], None);
    let seam = profile(2, &[(1.0, 0.0), (3.0, 1.0), (1.0, 0.0)], None);
    for profile in [point, flat, seam] {
        for angle in [0.0, 1e-300, 1e-17, 1.0, TAU] {
            let solid = solid(&profile, angle);
            let volume = solid.volume().unwrap_or_default();
            assert!(volume.abs() < 1e-14, "{volume} at {angle}");
            let options = TessellationOptions::tolerance(0.1);
            let mesh = solid.tessellate_f64(&options).expect("valid");
            assert!(mesh.positions.iter().all(|x| x.is_finite()));
        }
    }
    let knots = [0.0, 0.0, 1.0, 1.0];
    let tiny = [DVec3::X, DVec3::X + DVec3::Z].map(|p| p * 1e-160);
    let tiny = NurbsCurve::new(1, &tiny, None, &knots, false).expect("valid");
    for angle in [1.0, TAU] {
        let solid = RationalSurface::solid_of_revolution(&tiny, DVec3::ZERO, DVec3::Z, angle);
        assert!(solid.expect("valid").topology().open.is_empty());
    }
    let side = profile(1, &[(1.0, 0.0), (1.0, 1.0)], None);
    for angle in [7.0, f64::NAN] {
        assert!(RationalSurface::solid_of_revolution(&side, CENTER, axis(), angle).is_err());
    }
    assert!(RationalSurface::solid_of_revolution(&side, CENTER, DVec3::ZERO, 1.0).is_err());
}
