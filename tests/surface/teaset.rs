//! The data of the teapot, the teacup and the teaspoon, and figures known from other sources.

use crate::support::nets::volume;
#[cfg(not(target_family = "wasm"))]
use crate::support::surfaces::listing;
use casteljau::glam::DVec3;
use casteljau::models::Up;
use casteljau::{Grid, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The control points of each patch as bits, after a map and, where `reversed`, with v reversed.
#[cfg(not(target_family = "wasm"))]
fn nets(surface: &Surface, map: fn([f64; 3]) -> [f64; 3], reversed: bool) -> Vec<Vec<[u64; 3]>> {
    let net = |patch: casteljau::Patch| {
        let mut rows: Vec<&[DVec3]> = patch.control_points().chunks(4).collect();
        if reversed {
            rows.reverse();
        }
        let points = rows.concat().into_iter();
        points
            .map(|p| map(p.to_array()).map(f64::to_bits))
            .collect()
    };
    surface.patches().map(net).collect()
}

#[cfg(not(target_family = "wasm"))]
#[test]
fn data_are_the_listings_bit_for_bit() {
    let upright: fn([f64; 3]) -> [f64; 3] = |[x, y, z]| [x, 0.0 - z, y];
    let same = |p: [f64; 3]| p;
    let lying = |[x, y, z]: [f64; 3]| [x, z, 0.0 - y];
    for (surface, name, turn) in [
        (Surface::teacup(Up::Z), "teacup", upright),
        (Surface::teacup(Up::Y), "teacup", same),
        (Surface::teaspoon(Up::Z), "teaspoon", same),
        (Surface::teaspoon(Up::Y), "teaspoon", lying),
        (crate::support::nets::teapot(), "teapot", same),
    ] {
        let listed = nets(&listing(name), turn, name != "teapot");
        assert!(nets(&surface, same, false) == listed, "{name}");
    }
}

#[test]
fn counts() {
    let (cup, spoon) = (Surface::teacup(Up::Z), Surface::teaspoon(Up::Z));
    assert_eq!((cup.patch_count(), cup.vertices().len()), (26, 251));
    // The listing's 256 vertices lie at 148 points.
    assert_eq!((spoon.patch_count(), spoon.vertices().len()), (16, 148));
}

#[test]
fn normals_point_outwards() {
    // The spoon is closed except for its gaps: the volume inside is positive.
    for up in [Up::Z, Up::Y] {
        let volume = volume(&Surface::teaspoon(up).grid(Grid::from(96), false).unwrap());
        assert!((0.001..0.1).contains(&volume), "{volume}");
    }
    let cup = Surface::teacup(Up::Z);
    for index in 0..26 {
        let patch = cup.patch(index).unwrap();
        for (u, v) in [(0.5, 0.5), (0.1, 0.9), (0.7, 0.2)] {
            let (p, normal) = (patch.eval(u, v), patch.normal(u, v));
            let around = DVec3::new(p.x, p.y, 0.0);
            let outwards = match index {
                4..8 | 18..22 => around,
                8..12 => -around,
                // Pointing away from the plane of symmetry: u runs over the half-section.
                12 => DVec3::Y,
                13 => -DVec3::Y,
                14..18 => DVec3::Z,
                22..26 => -DVec3::Z,
                _ => continue, // the rim, over which the outward direction turns by half a circle
            };
            assert!(normal.dot(outwards) >= 0.0, "{index}: {p} {normal}");
        }
    }
}

#[test]
fn cup_stands_and_spoon_lies() {
    let cup = Surface::teacup(Up::Z).control_bounds().unwrap();
    assert_eq!((cup.min.z, cup.max.x, cup.max.y), (0.0, 1.0, 1.0));
    assert_eq!(Surface::teacup(Up::Y).control_bounds().unwrap().min.y, 0.0);
    let spoon = Surface::teaspoon(Up::Z);
    // Along the middle line the inside of the bowl is lower than its edge.
    let inside = spoon.patch(0).unwrap();
    assert!(inside.eval(0.5, 0.0).z < inside.eval(0.0, 0.0).z - 0.03);
    let turned = Surface::teaspoon(Up::Y).patch(0).unwrap();
    assert_eq!(turned.eval(0.5, 0.0).y, inside.eval(0.5, 0.0).z);
}
