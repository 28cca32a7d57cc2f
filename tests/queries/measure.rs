//! Area and volume.

use crate::queries::shapes::{odd_patches, teapot};
use crate::support::Rng;
use crate::support::nets::{RandomNet, graph};
#[cfg(not(target_family = "wasm"))]
use crate::support::surfaces::{gumbo, listing};
use casteljau::glam::{DAffine3, DMat3, DQuat, DVec3};
use casteljau::{Patch, Surface};
use wasm_bindgen_test::wasm_bindgen_test;

#[track_caller]
fn assert_close(got: f64, expected: f64, relative: f64) {
    assert!(
        (got - expected).abs() <= relative * expected.abs(),
        "{got:e}, not {expected:e}"
    );
}

/// The six faces of the cube from 0 to 1 as bilinear patches, normals outwards.
fn cube() -> Surface {
    let vertices = (0..8)
        .map(|k| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)))
        .collect();
    let faces = [
        [0, 2, 1, 3],
        [4, 5, 6, 7],
        [0, 1, 4, 5],
        [2, 6, 3, 7],
        [0, 4, 2, 6],
        [1, 3, 5, 7],
    ];
    Surface::new(vertices, faces.concat(), 1, 1).unwrap()
}

/// The connected components of a surface that are closed.
#[cfg(not(target_family = "wasm"))]
fn closed_parts(surface: &Surface) -> Vec<Surface> {
    let parts = surface.topology().components;
    let mut parts: Vec<Surface> = parts.iter().map(|patches| part(surface, patches)).collect();
    parts.retain(|part| part.topology().open.is_empty());
    parts
}

/// The selected patches of a surface as a separate surface.
#[cfg(not(target_family = "wasm"))]
fn part(surface: &Surface, patches: &[usize]) -> Surface {
    let indices = patches
        .iter()
        .flat_map(|&k| surface.patch_indices(k).unwrap().to_vec())
        .collect();
    Surface::new(surface.vertices().to_vec(), indices, 3, 3).unwrap()
}

/// The surface with the parameters u and v of one patch swapped, so that the patch's normals are reversed.
fn with_swapped(surface: &Surface, patch: usize) -> Surface {
    let [m, n] = surface.degrees(patch).unwrap();
    let count = (m + 1) * (n + 1);
    let mut indices = surface.indices().to_vec();
    for (k, index) in indices[patch * count..][..count].iter_mut().enumerate() {
        *index = surface.patch_indices(patch).unwrap()[k % (n + 1) * (m + 1) + k / (n + 1)];
    }
    Surface::new(surface.vertices().to_vec(), indices, m, n).unwrap()
}

#[wasm_bindgen_test(unsupported = test)]
fn areas_in_closed_form() {
    assert_close(graph(3, 2, &[]).area(), 1.0, 1e-14);
    assert_close(
        graph(2, 2, &[(3.0, 1, 0), (-2.0, 0, 1)]).area(),
        14_f64.sqrt(),
        1e-14,
    );
    // z = u²: ∫√(1 + 4u²) du.
    let parabola = 5_f64.sqrt() / 2.0 + 2_f64.asinh() / 4.0;
    assert_close(graph(2, 1, &[(1.0, 2, 0)]).area(), parabola, 1e-9);
    assert_close(graph(5, 3, &[(1.0, 0, 2)]).area(), parabola, 1e-9);
    // A triangle: one edge is a point.
    let net = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y];
    assert_close(Patch::new(&net, 1, 1).unwrap().area(), 0.5, 1e-14);
    // Folded in u and v: x goes to 3/2 and back, and so does y.
    let there_and_back = [0.0, 2.0, 2.0, 0.0];
    let net: Vec<DVec3> = (0..16)
        .map(|k| DVec3::new(there_and_back[k % 4], there_and_back[k / 4], 0.0))
        .collect();
    assert_close(Patch::new(&net, 3, 3).unwrap().area(), 9.0, 1e-12);
    // Folded along the diagonal u = v, on (u, v) → (u + v, uv): ∫∫|u − v| = 1/3.
    let net = [DVec3::ZERO, DVec3::X, DVec3::X, DVec3::new(2.0, 1.0, 0.0)];
    assert_close(Patch::new(&net, 1, 1).unwrap().area(), 1.0 / 3.0, 1e-7);
}

#[cfg(not(target_family = "wasm"))]
#[test]
fn areas_of_cup_and_spoon() {
    for (name, area) in [("teacup", 9.981_697_616), ("teaspoon", 0.342_881_444)] {
        // The last digit of the known figures, and the eighth digit.
        assert_close(listing(name).area(), area, 1.5e-8 / f64::min(area, 1.0));
    }
}

#[cfg(not(target_family = "wasm"))]
#[test]
fn the_area_of_gumbo() {
    if let Some(surface) = gumbo() {
        assert_close(surface.area(), 1_725.974_79, 1.5e-8);
    }
}

#[cfg(not(target_family = "wasm"))]
#[test]
fn the_volume_of_gumbos_body() {
    let Some(gumbo) = gumbo() else {
        return;
    };
    assert_eq!(gumbo.volume(), None);
    let volumes: Vec<f64> = gumbo
        .topology()
        .components
        .iter()
        .filter_map(|patches| part(&gumbo, patches).volume())
        .collect();
    assert!(
        volumes.iter().any(|v| (v - 2_556.773_7).abs() < 5e-5),
        "{volumes:?}"
    );
}

/// A ray that enters a closed body leaves it again, though Gumbo's parts overlap: by the normals, a ray enters as often
/// as it leaves.
#[cfg(not(target_family = "wasm"))]
#[test]
fn rays_go_in_and_out_of_gumbos_body() {
    let Some(gumbo) = gumbo() else {
        return;
    };
    let body = closed_parts(&gumbo).swap_remove(0);
    let bounds = body.bounds().unwrap();
    let mut random = Rng(1);
    let mut hits = 0;
    for _ in 0..1000 {
        let share = DVec3::new(random.unit(), random.unit(), random.unit());
        let inside = bounds.min + (bounds.max - bounds.min) * share;
        let along = random.grid_point().normalize_or(DVec3::X);
        let found = body.intersect_ray(inside - along * 100.0, along).unwrap();
        assert_eq!(found.len() % 2, 0, "{found:?}");
        let depth = found.iter().fold(0.0, |depth, hit| {
            let normal = body.patch(hit.patch).unwrap().normal(hit.u, hit.v);
            depth - normal.dot(along).signum()
        });
        assert_eq!(depth, 0.0, "{found:?}");
        hits += found.len();
    }
    assert!(hits > 1500, "{hits}");
}

#[wasm_bindgen_test(unsupported = test)]
fn volumes_in_closed_form() {
    assert_close(cube().volume().unwrap(), 1.0, 1e-15);
    // 16 u(1 − u) v(1 − v) over its unit square, with which it shares its edges: 4/9.
    let bump = [(16.0, 1, 1), (-16.0, 2, 1), (-16.0, 1, 2), (16.0, 2, 2)];
    for n in [2, 3, 5, 9] {
        let top = graph(n, n, &bump);
        // Edges that are equal to the last bit, and z = 0 inside.
        let is_inside =
            |k: usize| (1..n).contains(&(k % (n + 1))) && (1..n).contains(&(k / (n + 1)));
        let floor = (0..).zip(top.control_points()).map(|(k, p)| {
            p - if is_inside(k) {
                DVec3::Z * p.z
            } else {
                DVec3::ZERO
            }
        });
        let vertices: Vec<DVec3> = top.control_points().iter().copied().chain(floor).collect();
        let count = u32::try_from(vertices.len()).unwrap();
        let surface = Surface::new(vertices, (0..count).collect(), n, n).unwrap();
        // The normals of the floor point inwards, those of the first patch outwards; the first patch decides.
        assert_close(surface.volume().unwrap(), 4.0 / 9.0, 1e-13);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_sign_of_a_volume() {
    let cube = cube();
    // Neighbours whose normals disagree do not change the result …
    for patch in 1..6 {
        assert_close(with_swapped(&cube, patch).volume().unwrap(), 1.0, 1e-15);
    }
    // … except for the first patch, whose normals decide.
    assert_close(with_swapped(&cube, 0).volume().unwrap(), -1.0, 1e-15);
    let mirror = DAffine3::from_mat3(DMat3::from_diagonal(DVec3::new(1.0, 1.0, -2.0)));
    assert_close(
        cube.transform(&mirror)
            .expect("a finite image")
            .volume()
            .unwrap(),
        -2.0,
        1e-15,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_open_has_no_volume() {
    assert_eq!(teapot().volume(), None);
    assert_eq!(Surface::new(vec![], vec![], 1, 1).unwrap().volume(), None);
    let cube = cube();
    let five = Surface::new(cube.vertices().to_vec(), cube.indices()[4..].to_vec(), 1, 1).unwrap();
    assert_eq!(five.volume(), None);
    // A seventh face inside: its edges are shared by three patches.
    let mut indices = cube.indices().to_vec();
    indices.extend([0, 1, 6, 7]);
    assert_eq!(
        Surface::new(cube.vertices().to_vec(), indices, 1, 1)
            .unwrap()
            .volume(),
        None
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn area_and_volume_follow_the_map() {
    let (teapot, cube) = (teapot(), cube());
    let area = teapot.area();
    let turn = DQuat::from_axis_angle(DVec3::new(-2.0, 1.0, 2.0) / 3.0, 0.4);
    for scale in [1e-6, 1.0, 1e6] {
        let map = DAffine3::from_scale_rotation_translation(
            DVec3::splat(scale),
            turn,
            DVec3::ONE * 3.0 * scale,
        );
        assert_close(
            teapot.transform(&map).expect("a finite image").area(),
            area * scale * scale,
            1e-9,
        );
        assert_close(
            cube.transform(&map)
                .expect("a finite image")
                .volume()
                .unwrap(),
            scale.powi(3),
            1e-14,
        );
    }
    assert_close(with_swapped(&teapot, 5).area(), area, 1e-9);
    let patch = Rng(14).patch(3, 4);
    let pieces: f64 = patch.split(0.3, 0.8).iter().map(Patch::area).sum();
    assert_close(pieces, patch.area(), 1e-8);
}

#[wasm_bindgen_test(unsupported = test)]
fn points_and_curves_have_no_area() {
    let turn = DAffine3::from_rotation_x(0.7);
    for (k, patch) in odd_patches().iter().enumerate() {
        let area = patch.area();
        assert!(area.is_finite() && (area == 0.0) == (k < 5), "{k}: {area}");
        assert_eq!(
            patch.transform(&turn).expect("a finite image").area() == 0.0,
            k < 5
        );
    }
    assert_eq!(
        Surface::new(vec![], vec![], 3, 3).unwrap().area().to_bits(),
        0
    );
    for size in [1e-150, 1e150] {
        let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y].map(|p| p * size);
        assert_close(Patch::new(&net, 1, 1).unwrap().area(), size * size, 1e-14);
    }
}
