//! Meshes of surfaces that are rotated, scaled, or have u and v exchanged or reversed.

use super::checks::{assert_watertight, degrees_between};
use super::shapes::{all, diagonal, meshed, scaled, tolerance};
use super::soup::{Soup, vectors};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::Weld;
use casteljau::{Mesh, Surface};

/// A change of the surface, and its effect on the mesh: the scale, −1 where the orientation of triangles is reversed.
type Change = (&'static str, fn(&Surface) -> Surface, f64, f64);

const CHANGES: [Change; 7] = [
    ("turned", turned, 1.0, 1.0),
    ("a million times as large", |s| scaled(s, 1e6), 1e6, 1.0),
    ("a millionth", |s| scaled(s, 1e-6), 1e-6, 1.0),
    (
        "u and v exchanged",
        |s| rearranged(s, transposed),
        1.0,
        -1.0,
    ),
    ("u reversed", |s| rearranged(s, reversed_u), 1.0, -1.0),
    ("v reversed", |s| rearranged(s, reversed_v), 1.0, -1.0),
    (
        "both reversed",
        |s| rearranged(s, <[u32]>::reverse),
        1.0,
        1.0,
    ),
];

fn turned(surface: &Surface) -> Surface {
    let axis = DVec3::new(1.0, 2.0, 3.0).normalize();
    let turn = DAffine3::from_axis_angle(axis, 0.7);
    surface.transform(&turn).unwrap()
}

/// A bicubic surface with all nets in another order.
fn rearranged(surface: &Surface, change: fn(&mut [u32])) -> Surface {
    let mut indices = surface.indices().to_vec();
    indices.chunks_mut(16).for_each(change);
    Surface::new(surface.vertices().to_vec(), indices, 3, 3).unwrap()
}

fn transposed(net: &mut [u32]) {
    for j in 0..4 {
        for i in 0..j {
            net.swap(4 * j + i, 4 * i + j);
        }
    }
}

fn reversed_u(net: &mut [u32]) {
    net.chunks_mut(4).for_each(<[u32]>::reverse);
}

fn reversed_v(net: &mut [u32]) {
    net.reverse();
    reversed_u(net);
}

/// A mesh whose tolerance does not change when the surface is rotated.
fn mesh(surface: &Surface) -> Mesh {
    let first = surface.vertices()[0];
    let distances = surface.vertices().iter().map(|p| p.distance(first));
    let size = distances.fold(0.0, f64::max);
    meshed(surface, tolerance(size * 2e-3), Weld::None)
}

#[test]
fn meshes_follow() {
    all()
        .iter()
        .for_each(|(name, surface)| check_changes(name, surface, 1e-2));
}

/// `max_off` is the largest relative difference of the volumes between the origin and the meshes.
pub(crate) fn check_changes(name: &str, surface: &Surface, max_off: f64) {
    let before = mesh(surface);
    let soup = Soup::new(&before);
    for (change, apply, scale, sense) in CHANGES {
        let changed = apply(surface);
        let after = mesh(&changed);
        assert_watertight(&changed, &after, 1);
        let image = Soup::new(&after);
        let triangles = after.triangle_count() as f64 / before.triangle_count() as f64;
        let areas = image.area() / (soup.area() * scale * scale);
        let volumes = image.volume() / (soup.volume() * scale.powi(3) * sense);
        let what = format!("{name}, {change}: {triangles} {areas} {volumes}");
        assert!((triangles - 1.0).abs() < 0.02, "{what}");
        assert!((areas - 1.0).abs() < 1e-3, "{what}");
        assert!((volumes - 1.0).abs() < max_off, "{what}");
    }
}

#[test]
fn powers_of_two_change_nothing() {
    all()
        .iter()
        .for_each(|(name, surface)| check_powers_of_two(name, surface));
}

/// Powers of two change only exponents.
pub(crate) fn check_powers_of_two(name: &str, surface: &Surface) {
    let size = diagonal(surface) * 1e-2;
    let before = meshed(surface, tolerance(size), Weld::Normal);
    for exponent in [-60, -1, 40] {
        let factor = f64::from(exponent).exp2();
        let image = scaled(surface, factor);
        let after = meshed(&image, tolerance(size * factor), Weld::Normal);
        assert_eq!(before.indices, after.indices, "{name}");
        let mut pairs = vectors(&before.positions).zip(vectors(&after.positions));
        assert!(pairs.all(|(a, b)| a * factor == b), "{name}");
        let mut pairs = vectors(&before.normals).zip(vectors(&after.normals));
        assert!(pairs.all(|(a, b)| degrees_between(a, b) < 1e-4), "{name}");
    }
}
