//! Recursive subdivision into pieces that are flat enough.

use crate::support::Rng;
use crate::support::nets::{RandomNet, assert_near};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::FlatPiece;
use casteljau::models::Up;
use casteljau::{Error, Surface, TeapotOptions};
use wasm_bindgen_test::wasm_bindgen_test;

fn single(net: &[DVec3], m: usize, n: usize) -> Surface {
    let indices = (0..u32::try_from(net.len()).unwrap()).collect();
    Surface::new(net.to_vec(), indices, m, n).unwrap()
}

/// The paraboloid z = (x² + y²)·height over the unit square.
fn bowl(height: f64) -> Surface {
    let patch = crate::support::nets::graph(2, 2, &[(height, 2, 0), (height, 0, 2)]);
    single(patch.control_points(), 2, 2)
}

#[wasm_bindgen_test(unsupported = test)]
fn pieces_cover_the_patch() {
    let surface = Surface::teapot(TeapotOptions::default());
    let pieces = surface.subdivide(0.02).unwrap();
    for patch in 0..32 {
        let own = pieces.iter().filter(|piece| piece.patch == patch);
        // Sizes are powers of two, so the sum is exact.
        let area: f64 = own.map(|p| (p.u1 - p.u0) * (p.v1 - p.v0)).sum();
        assert_eq!(area, 1.0);
    }
    assert!(pieces.is_sorted_by_key(|piece| piece.patch));
    for piece in &pieces {
        let patch = surface.patch(piece.patch).unwrap();
        let &FlatPiece { u0, u1, v0, v1, .. } = piece;
        let locations = [(u0, v0), (u1, v0), (u1, v1), (u0, v1)];
        for ((u, v), corner) in locations.into_iter().zip(piece.corners) {
            assert_near(patch.eval(u, v), corner, 1e-14);
        }
        let [a, b, c, d] = piece.corners;
        assert_eq!(piece.triangles(), [[a, b, c], [a, c, d]]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn depth_of_a_paraboloid_is_known() {
    // The control points of a square piece of size h are at most 1·h²·height from the plane of three corners: the
    // fourth corner lies in that plane, and at the middles of the edges x² has the coefficient 0 between 0 and h². Each
    // halving divides the distance by four.
    let height = 0.01;
    for tolerance in [0.011, 0.004, 0.001, 1e-4, 1e-6] {
        let pieces = bowl(height).subdivide(tolerance).unwrap();
        let side = pieces.len().isqrt();
        assert_eq!(side * side, pieces.len());
        let h = 1.0 / side as f64;
        // The middle control point: both coefficients are 0, and the plane has the height (h² + h²)/2 there.
        let distance = |h: f64| height * h * h / (1.0 + 2.0 * (height * (2.0 - h)).powi(2)).sqrt();
        assert!(distance(h) <= tolerance * 1.001, "{h} {tolerance}");
        assert!(
            side == 1 || distance(2.0 * h) > tolerance * 0.999,
            "{h} {tolerance}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn plane_pieces_are_not_split() {
    // A plane patch is one leaf, whatever its parametrisation.
    let mut random = Rng(4);
    let turn = DAffine3::from_rotation_x(0.3) * DAffine3::from_rotation_z(1.1);
    for _ in 0..200 {
        let net: Vec<DVec3> = random
            .net(3, 3)
            .iter()
            .map(|p| DVec3::new(p.x, p.y, 0.0))
            .collect();
        // Three corners that are not collinear, so that the plane is accurate to the last digits.
        let mut net = net;
        (net[0], net[3], net[12]) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        let surface = single(&net, 3, 3).transform(&turn).expect("a finite image");
        assert_eq!(surface.subdivide(1e-12).unwrap().len(), 1);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn corners_without_a_plane() {
    // All corners coincide: the control points must be near this point.
    let mut net = vec![DVec3::ZERO; 16];
    net[5] = DVec3::Z;
    let bubble = single(&net, 3, 3);
    assert_eq!(bubble.subdivide(1.5).unwrap().len(), 1);
    assert!(bubble.subdivide(0.5).unwrap().len() > 1);
    // Corners on a line, control points off it.
    let mut net: Vec<DVec3> = (0..16)
        .map(|i| DVec3::new(f64::from(i), 0.0, 0.0))
        .collect();
    net[6].z = 1.0;
    let fin = single(&net, 3, 3);
    assert_eq!(fin.subdivide(1.5).unwrap().len(), 1);
    assert!(fin.subdivide(0.5).unwrap().len() > 1);
    // A line and a point are flat.
    let line: Vec<DVec3> = (0..16)
        .map(|i| DVec3::new(f64::from(i * i), 0.0, 0.0))
        .collect();
    assert_eq!(single(&line, 3, 3).subdivide(1e-9).unwrap().len(), 1);
    assert_eq!(
        single(&[DVec3::ONE; 16], 3, 3)
            .subdivide(1e-9)
            .unwrap()
            .len(),
        1
    );
    let nothing = Surface::new(Vec::new(), Vec::new(), 3, 3).unwrap();
    assert!(nothing.subdivide(1.0).unwrap().is_empty());
    // Two neighbouring edges are collapsed: three corners remain.
    let mut sliver = Rng(2).net(3, 3);
    sliver[..4].fill(DVec3::ZERO);
    assert!(single(&sliver, 3, 3).subdivide(0.01).unwrap().len() > 4);
}

#[wasm_bindgen_test(unsupported = test)]
fn it_bounds_no_distance_to_the_triangles() {
    // As documented: the control points of a flat S are in one plane, but the curve is not on the triangles.
    let row = |y: f64| [(0.0, y), (0.0, y + 2.0), (1.0, y - 2.0), (1.0, y)];
    let net: Vec<DVec3> = [row(0.0), row(1.0)]
        .concat()
        .iter()
        .map(|&(x, y)| DVec3::new(x, y, 0.0))
        .collect();
    let surface = single(&net, 3, 1);
    assert_eq!(surface.subdivide(1e-9).unwrap().len(), 1);
    let bulge = surface.patch(0).unwrap().eval(0.2, 1.0).y;
    assert!(bulge > 1.5);
}

#[wasm_bindgen_test(unsupported = test)]
fn finer_tolerances_and_sizes() {
    let cup = Surface::teacup(Up::Z);
    let count = |surface: &Surface, tolerance: f64| surface.subdivide(tolerance).unwrap().len();
    let counts = [0.1, 0.01, 1e-3, 1e-4].map(|tolerance| count(&cup, tolerance));
    assert!(counts.is_sorted() && counts[0] >= 26);
    // About four times as many pieces for a quarter of the tolerance.
    assert!((2..6).contains(&(counts[2] / count(&cup, 4e-3))));
    for scale in [1e-150, 2.0, 1e150] {
        let scaled = cup
            .transform(&DAffine3::from_scale(DVec3::splat(scale)))
            .expect("a finite image");
        assert!(count(&scaled, 0.01 * scale).abs_diff(counts[1]) <= 8);
    }
    // The same after a rotation, which changes the rounding.
    let turned = cup
        .transform(&DAffine3::from_rotation_y(2.0))
        .expect("a finite image");
    assert!(count(&turned, 0.01).abs_diff(counts[1]) <= 8);
}

#[wasm_bindgen_test(unsupported = test)]
fn refused() {
    let surface = bowl(1.0);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(surface.subdivide(bad), Err(Error::Range { .. })));
    }
    assert!(matches!(
        surface.subdivide(1e-17),
        Err(Error::Tolerance { .. })
    ));
    assert!(matches!(
        surface.subdivide(1e-12),
        Err(Error::TooMany { limit: 262_208, .. })
    ));
    let huge = single(
        &Rng(1)
            .net(3, 3)
            .iter()
            .map(|&p| p * 1e150)
            .collect::<Vec<_>>(),
        3,
        3,
    );
    assert!(
        huge.subdivide(1e148)
            .unwrap()
            .iter()
            .all(|piece| piece.corners.iter().all(|c| c.is_finite()))
    );
}
