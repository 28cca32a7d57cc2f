//! Meshes of surfaces that are rotated, scaled, or have u and v exchanged or reversed.

use super::checks::{assert_watertight, degrees_between};
use super::shapes::{all, diagonal};
use super::soup::{Soup, vectors};
use casteljau::glam::{DAffine3, DMat3, DVec3};
use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Mesh, Surface};

/// A change of the surface and its effect on the mesh.
struct Change {
    name: &'static str,
    surface: fn(&Surface) -> Surface,
    scale: f64,
    /// −1 where the orientation of triangles is reversed.
    sense: f64,
}

const CHANGES: [Change; 7] = [
    Change {
        name: "turned",
        surface: |s| s.transform(&turn()).expect("a finite image"),
        scale: 1.0,
        sense: 1.0,
    },
    Change {
        name: "a million times as large",
        surface: |s| scaled(s, 1e6),
        scale: 1e6,
        sense: 1.0,
    },
    Change {
        name: "a millionth",
        surface: |s| scaled(s, 1e-6),
        scale: 1e-6,
        sense: 1.0,
    },
    Change {
        name: "u and v exchanged",
        surface: |s| rearranged(s, transposed),
        scale: 1.0,
        sense: -1.0,
    },
    Change {
        name: "u reversed",
        surface: |s| rearranged(s, reversed_u),
        scale: 1.0,
        sense: -1.0,
    },
    Change {
        name: "v reversed",
        surface: |s| rearranged(s, reversed_v),
        scale: 1.0,
        sense: -1.0,
    },
    Change {
        name: "both reversed",
        surface: |s| rearranged(s, |net| net.reverse()),
        scale: 1.0,
        sense: 1.0,
    },
];

fn turn() -> DAffine3 {
    DAffine3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7)
}

fn scaled(surface: &Surface, factor: f64) -> Surface {
    surface
        .transform(&DAffine3::from_mat3(DMat3::from_diagonal(DVec3::splat(
            factor,
        ))))
        .expect("a finite image")
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

fn meshed(surface: &Surface) -> Mesh {
    let tolerance = TessellationOptions::tolerance(diagonal_of_sphere(surface) * 2e-3);
    surface.tessellate(&tolerance.weld(Weld::None)).unwrap()
}

/// A diagonal that does not change when the surface is rotated.
fn diagonal_of_sphere(surface: &Surface) -> f64 {
    let first = surface.vertices()[0];
    surface
        .vertices()
        .iter()
        .fold(0.0, |max, p| f64::max(max, p.distance(first)))
}

#[test]
fn meshes_follow() {
    for (name, surface) in all() {
        let before = meshed(&surface);
        let soup = Soup::new(&before);
        for change in &CHANGES {
            let changed = (change.surface)(&surface);
            let after = meshed(&changed);
            assert_watertight(&changed, &after, 1);
            let what = format!("{name}, {}", change.name);
            let counts = [
                after.triangle_count() as f64,
                before.triangle_count() as f64,
            ];
            assert!(
                (counts[0] / counts[1] - 1.0).abs() < 0.02,
                "{what}: {counts:?} triangles"
            );
            let image = Soup::new(&after);
            let areas = image.area() / (soup.area() * change.scale * change.scale);
            assert!((areas - 1.0).abs() < 1e-3, "{what}: {areas} of the area");
            let volumes = image.volume() / (soup.volume() * change.scale.powi(3) * change.sense);
            assert!(
                (volumes - 1.0).abs() < 1e-2 || name != "gumbo",
                "{what}: {volumes} of the volume"
            );
        }
    }
}

/// Powers of two change only exponents.
#[test]
fn powers_of_two_change_nothing() {
    for (name, surface) in all() {
        let size = diagonal(&surface) * 1e-2;
        for exponent in [-60, -1, 40] {
            let factor = f64::from(exponent).exp2();
            let of = |s: &Surface, size: f64| {
                s.tessellate(&TessellationOptions::tolerance(size).weld(Weld::Normal))
                    .unwrap()
            };
            let (before, after) = (
                of(&surface, size),
                of(&scaled(&surface, factor), size * factor),
            );
            assert_eq!(before.indices, after.indices, "{name}");
            let pairs = vectors(&before.positions).zip(vectors(&after.positions));
            assert!(pairs.into_iter().all(|(a, b)| a * factor == b), "{name}");
            let mut pairs = vectors(&before.normals).zip(vectors(&after.normals));
            assert!(pairs.all(|(a, b)| degrees_between(a, b) < 1e-4), "{name}");
        }
    }
}
