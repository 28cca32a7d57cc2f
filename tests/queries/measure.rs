//! Area and volume.

use crate::queries::shapes::{map, odd_patches};
use crate::support::nets::{RandomNet, cube, graph, net, nothing, patch, points, teapot};
use crate::support::{Rng, near};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::models::Up;
use casteljau::{Patch, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[track_caller]
fn assert_relative(got: f64, expected: f64, relative: f64) {
    near(got, expected, relative * expected.abs());
}

fn with_indices(surface: &Surface, indices: Vec<u32>) -> Surface {
    Surface::new(surface.vertices().to_vec(), indices, 1, 1).unwrap()
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

#[test]
fn areas_in_closed_form() {
    assert_relative(graph(3, 2, &[]).area(), 1.0, 1e-14);
    let plane = graph(2, 2, &[(3.0, 1, 0), (-2.0, 0, 1)]);
    assert_relative(plane.area(), 14_f64.sqrt(), 1e-14);
    // z = u²: ∫√(1 + 4u²) du.
    let parabola = 5_f64.sqrt() / 2.0 + 2_f64.asinh() / 4.0;
    assert_relative(graph(2, 1, &[(1.0, 2, 0)]).area(), parabola, 1e-9);
    assert_relative(graph(5, 3, &[(1.0, 0, 2)]).area(), parabola, 1e-9);
    // A triangle: one edge is a point.
    let triangle = patch(&points("0 0 0  0 0 0  1 0 0  0 1 0"), 1, 1);
    assert_relative(triangle.area(), 0.5, 1e-14);
    // Folded in u and v: x goes to 3/2 and back, and so does y.
    let turn = |k: f64| if (1.0..=2.0).contains(&k) { 2.0 } else { 0.0 };
    let folded = net(3, 3, |i, j| DVec3::new(turn(i), turn(j), 0.0));
    assert_relative(patch(&folded, 3, 3).area(), 9.0, 1e-12);
    // Folded along the diagonal u = v, on (u, v) → (u + v, uv): ∫∫|u − v| = 1/3.
    let folded = patch(&points("0 0 0  1 0 0  1 0 0  2 1 0"), 1, 1);
    assert_relative(folded.area(), 1.0 / 3.0, 1e-7);
}

#[test]
fn areas_of_cup_and_spoon() {
    for up in [Up::Z, Up::Y] {
        // The last digit of the known figures, and the eighth digit.
        assert_relative(Surface::teacup(up).area(), 9.981_697_616, 1.5e-8);
        near(Surface::teaspoon(up).area(), 0.342_881_444, 1.5e-8);
    }
}

#[test]
fn volumes_in_closed_form() {
    assert_relative(cube().volume().unwrap(), 1.0, 1e-15);
    // 16 u(1 − u) v(1 − v) over its unit square, with which it shares its edges: 4/9.
    let bump = [(16.0, 1, 1), (-16.0, 2, 1), (-16.0, 1, 2), (16.0, 2, 2)];
    for n in [2, 3, 5, 9] {
        let top = graph(n, n, &bump);
        // Edges that are equal to the last bit, and z = 0 inside.
        let is_inside =
            |k: usize| (1..n).contains(&(k % (n + 1))) && (1..n).contains(&(k / (n + 1)));
        let floor = (0..).zip(top.control_points());
        let floor = floor.map(|(k, p)| p.with_z(if is_inside(k) { 0.0 } else { p.z }));
        let vertices: Vec<DVec3> = top.control_points().iter().copied().chain(floor).collect();
        let count = u32::try_from(vertices.len()).unwrap();
        let surface = Surface::new(vertices, (0..count).collect(), n, n).unwrap();
        // The normals of the floor point inwards, those of the first patch outwards; the first patch decides.
        assert_relative(surface.volume().unwrap(), 4.0 / 9.0, 1e-13);
    }
}

#[test]
fn the_sign_of_a_volume() {
    let cube = cube();
    // Neighbours whose normals disagree do not change the result …
    for patch in 1..6 {
        assert_relative(with_swapped(&cube, patch).volume().unwrap(), 1.0, 1e-15);
    }
    // … except for the first patch, whose normals decide.
    assert_relative(with_swapped(&cube, 0).volume().unwrap(), -1.0, 1e-15);
    let mirror = DAffine3::from_scale(DVec3::new(1.0, 1.0, -2.0));
    let mirrored = cube.transform(&mirror).unwrap();
    assert_relative(mirrored.volume().unwrap(), -2.0, 1e-15);
}

#[test]
fn what_is_open_has_no_volume() {
    let cube = cube();
    let five = with_indices(&cube, cube.indices()[4..].to_vec());
    // A seventh face inside: its edges are shared by three patches.
    let seven = with_indices(&cube, [cube.indices(), &[0, 1, 6, 7]].concat());
    for surface in [teapot(), nothing(), five, seven] {
        assert_eq!(surface.volume(), None);
    }
}

#[test]
fn area_and_volume_follow_the_map() {
    let (teapot, cube) = (teapot(), cube());
    let area = teapot.area();
    for scale in [1e-6, 1.0, 1e6] {
        let map = map([-2.0, 1.0, 2.0], 0.4, scale, 3.0);
        let (image, body) = (
            teapot.transform(&map).unwrap(),
            cube.transform(&map).unwrap(),
        );
        assert_relative(image.area(), area * scale * scale, 1e-9);
        assert_relative(body.volume().unwrap(), scale.powi(3), 1e-14);
    }
    assert_relative(with_swapped(&teapot, 5).area(), area, 1e-9);
    let patch = Rng(14).patch(3, 4);
    let pieces: f64 = patch.split(0.3, 0.8).iter().map(Patch::area).sum();
    assert_relative(pieces, patch.area(), 1e-8);
}

#[test]
fn points_and_curves_have_no_area() {
    let turn = DAffine3::from_rotation_x(0.7);
    for (k, patch) in odd_patches().iter().enumerate() {
        let area = patch.area();
        assert!(area.is_finite() && (area == 0.0) == (k < 5), "{k}: {area}");
        let turned = patch.transform(&turn).unwrap().area();
        assert_eq!(turned == 0.0, k < 5);
    }
    assert_eq!(nothing().area().to_bits(), 0);
    for size in [1e-150, 1e150] {
        let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y].map(|p| p * size);
        assert_relative(patch(&net, 1, 1).area(), size * size, 1e-14);
    }
}
