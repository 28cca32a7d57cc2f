//! Recursive subdivision into pieces that are flat enough.

use crate::support::nets::{RandomNet, as_surface, assert_near, graph, net, nothing};
use crate::support::nets::{points, scaled, single, teapot};
use crate::support::{Rng, assert_refused};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::FlatPiece;
use casteljau::models::Up;
use casteljau::{Patch, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The paraboloid z = (x² + y²)·height over the unit square.
fn bowl(height: f64) -> Surface {
    as_surface(&graph(2, 2, &[(height, 2, 0), (height, 0, 2)]))
}

fn count(surface: &Surface, tolerance: f64) -> usize {
    surface.subdivide(tolerance).unwrap().len()
}

#[test]
fn pieces_cover_the_patch() {
    let pieces = teapot().subdivide(0.02).unwrap();
    let patches: Vec<Patch> = teapot().patches().collect();
    for patch in 0..32 {
        let own = pieces.iter().filter(|piece| piece.patch == patch);
        // Sizes are powers of two, so the sum is exact.
        let area: f64 = own.map(|p| (p.u1 - p.u0) * (p.v1 - p.v0)).sum();
        assert_eq!(area, 1.0);
    }
    assert!(pieces.is_sorted_by_key(|piece| piece.patch));
    for piece in &pieces {
        let &FlatPiece {
            patch,
            u0,
            u1,
            v0,
            v1,
            corners,
        } = piece;
        let locations = [(u0, v0), (u1, v0), (u1, v1), (u0, v1)];
        for ((u, v), corner) in locations.into_iter().zip(corners) {
            assert_near(patches[patch].eval(u, v), corner, 1e-14);
        }
        let [a, b, c, d] = corners;
        assert_eq!(piece.triangles(), [[a, b, c], [a, c, d]]);
    }
}

#[test]
fn depth_of_a_paraboloid_is_known() {
    // The control points of a square piece of size h are at most 1·h²·height from the plane of three corners: the
    // fourth corner lies in that plane, and at the middles of the edges x² has the coefficient 0 between 0 and h². Each
    // halving divides the distance by four.
    let height = 0.01;
    for tolerance in [0.011, 0.004, 0.001, 1e-4, 1e-6] {
        let pieces = count(&bowl(height), tolerance);
        let side = pieces.isqrt();
        assert_eq!(side * side, pieces);
        let h = 1.0 / side as f64;
        // The middle control point: both coefficients are 0, and the plane has the height (h² + h²)/2 there.
        let distance = |h: f64| height * h * h / (1.0 + 2.0 * (height * (2.0 - h)).powi(2)).sqrt();
        assert!(distance(h) <= tolerance * 1.001, "{h} {tolerance}");
        assert!(side == 1 || distance(2.0 * h) > tolerance * 0.999, "{h}");
    }
}

#[test]
fn plane_pieces_are_not_split() {
    // A plane patch is one leaf, whatever its parametrisation.
    let mut random = Rng(4);
    let turn = DAffine3::from_rotation_x(0.3) * DAffine3::from_rotation_z(1.1);
    for _ in 0..200 {
        let mut net = random.net(3, 3);
        net.iter_mut().for_each(|p| p.z = 0.0);
        // Three corners that are not collinear, so that the plane is accurate to the last digits.
        (net[0], net[3], net[12]) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        let surface = single(&net, 3, 3).transform(&turn).unwrap();
        assert_eq!(count(&surface, 1e-12), 1);
    }
}

#[test]
fn corners_without_a_plane() {
    // All corners coincide: the control points must be near this point. Corners on a line, control points off it.
    let mut bubble = vec![DVec3::ZERO; 16];
    bubble[5] = DVec3::Z;
    let mut fin = net(3, 3, |i, j| DVec3::X * (i + 4.0 * j));
    fin[6].z = 1.0;
    for net in [bubble, fin] {
        let surface = single(&net, 3, 3);
        assert!(count(&surface, 1.5) == 1 && count(&surface, 0.5) > 1);
    }
    // A line and a point are flat.
    for net in [
        net(3, 3, |i, j| DVec3::X * (i + 4.0 * j).powi(2)),
        vec![DVec3::ONE; 16],
    ] {
        assert_eq!(count(&single(&net, 3, 3), 1e-9), 1);
    }
    assert_eq!(count(&nothing(), 1.0), 0);
    // Two neighbouring edges are collapsed: three corners remain.
    let mut sliver = Rng(2).net(3, 3);
    sliver[..4].fill(DVec3::ZERO);
    assert!(count(&single(&sliver, 3, 3), 0.01) > 4);
}

#[test]
fn it_bounds_no_distance_to_the_triangles() {
    // As documented: the control points of a flat S are in one plane, but the curve is not on the triangles.
    let net = points("0 0 0  0 2 0  1 -2 0  1 0 0  0 1 0  0 3 0  1 -1 0  1 1 0");
    let surface = single(&net, 3, 1);
    assert_eq!(count(&surface, 1e-9), 1);
    let bulge = surface.patch(0).unwrap().eval(0.2, 1.0).y;
    assert!(bulge > 1.5);
}

#[test]
fn finer_tolerances_and_sizes() {
    let cup = Surface::teacup(Up::Z);
    let counts = [0.1, 0.01, 1e-3, 1e-4].map(|tolerance| count(&cup, tolerance));
    assert!(counts.is_sorted() && counts[0] >= 26);
    // About four times as many pieces for a quarter of the tolerance.
    assert!((2..6).contains(&(counts[2] / count(&cup, 4e-3))));
    for scale in [1e-150, 2.0, 1e150] {
        assert!(count(&scaled(&cup, scale), 0.01 * scale).abs_diff(counts[1]) <= 8);
    }
    // The same after a rotation, which changes the rounding.
    let turned = cup.transform(&DAffine3::from_rotation_y(2.0)).unwrap();
    assert!(count(&turned, 0.01).abs_diff(counts[1]) <= 8);
}

#[test]
fn refused() {
    let surface = bowl(1.0);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_refused(surface.subdivide(bad), "tolerance: expected a ");
    }
    assert_refused(surface.subdivide(1e-17), "tolerance: expected at least ");
    assert_refused(surface.subdivide(1e-12), "leaves: expected at most 262208,");
    let huge = scaled(&single(&Rng(1).net(3, 3), 3, 3), 1e150);
    let pieces = huge.subdivide(1e148).unwrap();
    let mut corners = pieces.iter().flat_map(|piece| piece.corners);
    assert!(corners.all(|corner| corner.is_finite()));
}
