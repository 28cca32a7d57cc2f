//! Teacup and teaspoon: their data, and figures known from other sources.

use casteljau::Surface;
use casteljau::glam::DVec3;
use casteljau::models::Up;
use wasm_bindgen_test::wasm_bindgen_test;

/// A listing of tests/data, rotated and with v reversed: the control points of each patch as bits.
#[cfg(not(target_family = "wasm"))]
fn listed(name: &str, turn: fn([f64; 3]) -> [f64; 3]) -> Vec<Vec<[u64; 3]>> {
    let data = crate::support::golden::golden(name);
    let point = |index: &serde_json::Value| {
        let vertex = &data["vertices"][usize::try_from(index.as_u64().unwrap()).unwrap()];
        turn([0, 1, 2].map(|axis| vertex[axis].as_f64().unwrap())).map(f64::to_bits)
    };
    let patches = data["patches"].as_array().unwrap().iter();
    let net = |patch: &serde_json::Value| {
        let rows = patch.as_array().unwrap().chunks(4).rev();
        rows.flatten().map(point).collect()
    };
    patches.map(net).collect()
}

#[cfg(not(target_family = "wasm"))]
fn ours(surface: &Surface) -> Vec<Vec<[u64; 3]>> {
    let bits = |p: &DVec3| p.to_array().map(f64::to_bits);
    let patches = surface.patches();
    patches
        .map(|patch| patch.control_points().iter().map(bits).collect())
        .collect()
}

#[cfg(not(target_family = "wasm"))]
#[test]
fn data_are_the_listings_bit_for_bit() {
    let upright = |[x, y, z]: [f64; 3]| [x, 0.0 - z, y];
    let same = |p: [f64; 3]| p;
    let lying = |[x, y, z]: [f64; 3]| [x, z, 0.0 - y];
    for (surface, name, turn) in [
        (
            Surface::teacup(Up::Z),
            "teacup",
            upright as fn([f64; 3]) -> [f64; 3],
        ),
        (Surface::teacup(Up::Y), "teacup", same),
        (Surface::teaspoon(Up::Z), "teaspoon", same),
        (Surface::teaspoon(Up::Y), "teaspoon", lying),
    ] {
        assert!(ours(&surface) == listed(name, turn), "{name}");
    }
}

/// The numbers of shared and open edges, by vertices.
fn sides(surface: &Surface) -> (usize, usize) {
    let mut names = Vec::new();
    for patch in 0..surface.patch_count() {
        let net = surface.patch_indices(patch).unwrap();
        let column = |i: usize| [net[i], net[i + 4], net[i + 8], net[i + 12]];
        let row = |j: usize| [net[4 * j], net[4 * j + 1], net[4 * j + 2], net[4 * j + 3]];
        for side in [column(0), column(3), row(0), row(3)] {
            let [a, b, c, d] = side;
            names.push(side.min([d, c, b, a]));
        }
    }
    let count = |name: &[u32; 4]| names.iter().filter(|&other| other == name).count();
    let times = |n: usize| names.iter().filter(|name| count(name) == n).count();
    assert_eq!(times(1) + times(2), names.len());
    (times(2) / 2, times(1))
}

#[wasm_bindgen_test(unsupported = test)]
fn counts() {
    let (cup, spoon) = (Surface::teacup(Up::Z), Surface::teaspoon(Up::Z));
    assert_eq!((cup.patch_count(), cup.vertices().len()), (26, 251));
    // The listing's 256 vertices lie at 148 points.
    assert_eq!((spoon.patch_count(), spoon.vertices().len()), (16, 148));
    assert_eq!(sides(&cup), (46, 12));
    assert_eq!(sides(&spoon), (28, 8));
}

/// The area of a fine grid, and the volume under its faces.
fn area_and_volume(surface: &Surface) -> (f64, f64) {
    let n = 96;
    let (mut area, mut volume) = (0.0, 0.0);
    for patch in surface.patches() {
        let at = |i: usize, j: usize| patch.eval(i as f64 / n as f64, j as f64 / n as f64);
        for (i, j) in (0..n * n).map(|k| (k % n, k / n)) {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            for [p, q, r] in [[a, b, c], [a, c, d]] {
                area += (q - p).cross(r - p).length() / 2.0;
                volume += p.dot(q.cross(r)) / 6.0;
            }
        }
    }
    (area, volume)
}

#[wasm_bindgen_test(unsupported = test)]
fn areas_are_those_measured_elsewhere() {
    // The area of a grid of 1/96 is too small by about 1e-4.
    for (surface, expected) in [
        (Surface::teacup(Up::Z), 9.981_697_616),
        (Surface::teaspoon(Up::Z), 0.342_881_444),
    ] {
        let (area, _) = area_and_volume(&surface);
        assert!((area / expected - 1.0).abs() < 3e-4, "{area}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn normals_point_outwards() {
    // The spoon is closed except for its gaps: the volume inside is positive.
    for up in [Up::Z, Up::Y] {
        let (_, volume) = area_and_volume(&Surface::teaspoon(up));
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

#[wasm_bindgen_test(unsupported = test)]
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
