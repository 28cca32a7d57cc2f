//! Curvature, flatness, de Casteljau's algorithm, other bases.

use crate::queries::shapes::{map, odd_patches, random_patches};
use crate::support::nets::{RandomNet, assert_near, graph, patch, points, samples, teapot};
use crate::support::{Rng, assert_refused, near};
use casteljau::curve::Basis;
use casteljau::glam::DVec3;
use casteljau::patch::Curvature;
use casteljau::{Curve, MAX_COORDINATE, Patch};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Asserts k1 and k2, and that the other curvatures agree with them.
#[track_caller]
fn assert_curvature(got: Curvature, k1: f64, k2: f64, tolerance: f64) {
    near(got.k1, k1, tolerance);
    near(got.k2, k2, tolerance);
    assert!((got.gaussian - got.k1 * got.k2).abs() <= 1e-15 * got.gaussian.abs());
    assert!((got.mean - 0.5 * (got.k1 + got.k2)).abs() <= 1e-15 * got.k1.abs().max(got.k2.abs()));
}

#[test]
fn curvature_of_graphs() {
    // z = a u² + b v² at its vertex has the curvatures 2a and 2b, toward the normal (0, 0, 1).
    let (a, b) = (
        [1.0, 1.0, 2.0, -1.0, 0.0, 0.0],
        [0.5, 1.0, -3.0, -0.25, 1.0, 0.0],
    );
    for (a, b) in a.into_iter().zip(b) {
        let patch = graph(3, 2, &[(a, 2, 0), (b, 0, 2)]);
        let (k1, k2) = (2.0 * f64::max(a, b), 2.0 * f64::min(a, b));
        assert_curvature(patch.curvature(0.0, 0.0), k1, k2, 1e-13);
    }
    // Monge's formulas for z = u² + u v − v³/2 at other points.
    let patch = graph(2, 3, &[(1.0, 2, 0), (1.0, 1, 1), (-0.5, 0, 3)]);
    for (u, v) in samples(5) {
        let (p, q) = (2.0 * u + v, u - 1.5 * v * v);
        let (r, s, t) = (2.0, 1.0, -3.0 * v);
        let w = 1.0 + p * p + q * q;
        let got = patch.curvature(u, v);
        assert!((got.gaussian - (r * t - s * s) / (w * w)).abs() < 1e-12);
        let mean = ((1.0 + q * q) * r - 2.0 * p * q * s + (1.0 + p * p) * t) / (2.0 * w.powf(1.5));
        assert!((got.mean - mean).abs() < 1e-12);
        assert!(got.k1 >= got.k2);
    }
}

#[test]
fn curvature_follows_the_map() {
    let patch = Rng(7).patch(3, 3);
    for scale in [1e-6, 1e6] {
        let map = map([2.0, 2.0, -1.0], 2.0, scale, 1.0);
        let image = patch.transform(&map).unwrap();
        for (u, v) in samples(4) {
            let (a, b) = (patch.curvature(u, v), image.curvature(u, v));
            let size = a.k1.abs().max(a.k2.abs());
            assert!((a.k1 - b.k1 * scale).abs() < 1e-8 * size, "{a:?} {b:?}");
            assert!((a.k2 - b.k2 * scale).abs() < 1e-8 * size);
        }
    }
    // With u reversed, the normal has the opposite direction.
    let mut reversed = patch.control_points().to_vec();
    reversed.chunks_mut(4).for_each(<[DVec3]>::reverse);
    let other = Patch::new(&reversed, 3, 3).unwrap();
    for (u, v) in samples(3) {
        let (a, b) = (patch.curvature(u, v), other.curvature(1.0 - u, v));
        let size = a.k1.abs().max(a.k2.abs());
        assert!((a.k1 + b.k2).abs() < 1e-9 * size && (a.k2 + b.k1).abs() < 1e-9 * size);
        assert!((a.gaussian - b.gaussian).abs() < 1e-9 * size * size);
    }
}

#[test]
fn curvature_at_poles() {
    // The paraboloid z = r² with the pole at v = 0: the point (v cos, v sin, v²), with any curve instead of the circle.
    let arc = points("1 0 0  1 0.55 0  0.55 1 0  0 1 0");
    let around = |rows: [(f64, f64); 3]| {
        let rows = rows.map(|(r, z)| arc.iter().map(move |&p| p * r + DVec3::Z * z));
        patch(&rows.into_iter().flatten().collect::<Vec<_>>(), 3, 2)
    };
    let pole = around([(0.0, 0.0), (0.5, 0.0), (1.0, 1.0)]);
    // The direction from the middle, u = ½, is the diagonal, where the arc has the radius r: z = v² there, and across
    // it the curvature of the circle decides. Along the diagonal the curvature is 2/r², and negative, since ∂u × ∂v
    // points down.
    let r = pole.eval(0.5, 1.0).truncate().length();
    let got = pole.curvature(0.5, 0.0);
    let fits = |k: f64| (k + 2.0 / (r * r)).abs() < 1e-6;
    assert!(fits(got.k1) || fits(got.k2), "{got:?}, {r}");
    // A cone has no curvature at its tip, where the limit would be infinite.
    let cone = around([0.0, 0.5, 1.0].map(|r| (r, r)));
    assert_eq!(cone.curvature(0.3, 0.0), Curvature::default());
    assert!(cone.curvature(0.3, 0.5).gaussian.abs() < 1e-14);
    // On the axis of the teapot's lid all four patches give the same curvature.
    let lid: Vec<Patch> = teapot().patches().skip(20).take(4).collect();
    let first = lid[0].curvature(0.5, 0.0);
    assert!(first.k1.is_finite() && first.k1 != 0.0);
    for patch in &lid {
        let got = patch.curvature(0.5, 0.0);
        assert_curvature(got, first.k1, first.k2, 1e-6 * first.k1.abs());
    }
}

#[test]
fn curvature_is_finite_on_odd_patches() {
    for patch in odd_patches() {
        for (u, v) in samples(4) {
            let c = patch.curvature(u, v);
            let all = [c.gaussian, c.mean, c.k1, c.k2];
            assert!(all.iter().all(|k| k.is_finite()));
        }
    }
    for k in 0..5 {
        assert_eq!(odd_patches()[k].curvature(0.3, 0.6), Curvature::default());
    }
}

#[test]
fn flatness_bounds_the_two_triangles() {
    let random = random_patches(15, &[(3, 3), (2, 4), (1, 1), (6, 2), (3, 3)]);
    for patch in odd_patches().iter().chain(&random) {
        let bound = patch.flatness();
        let [a, b, c, d] =
            [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(u, v)| patch.eval(u, v));
        for (u, v) in samples(30) {
            // With both diagonals.
            let rising = if u > v {
                a + (b - a) * u + (d - b) * v
            } else {
                a + (d - c) * u + (c - a) * v
            };
            let falling = if u + v < 1.0 {
                a + (b - a) * u + (c - a) * v
            } else {
                d + (c - d) * (1.0 - u) + (b - d) * (1.0 - v)
            };
            let p = patch.eval(u, v);
            assert!(p.distance(rising).max(p.distance(falling)) <= bound + 1e-14);
        }
    }
    // The middle of z = uv is ¼ away from its triangles; a regular grid is flat; z = u² deviates by ¼.
    assert_eq!(graph(1, 1, &[(1.0, 1, 1)]).flatness(), 0.25);
    assert_eq!(graph(2, 2, &[(1.0, 2, 0)]).flatness(), 0.25);
    assert!(graph(3, 3, &[]).flatness() < 1e-15);
    let quarter = random[4].split(0.5, 0.5)[0].flatness();
    assert!(quarter <= 0.25 * random[4].flatness() + 1e-15);
    let huge = [1.0, -1.0, -1.0, 1.0].map(|x| DVec3::splat(x * MAX_COORDINATE));
    assert!(!patch(&huge, 1, 1).flatness().is_nan());
}

#[test]
fn de_casteljau_leads_from_rows_to_the_point() {
    let patch = Rng(9).patch(3, 2);
    let lengths = |levels: &[Vec<DVec3>]| levels.iter().map(Vec::len).collect::<Vec<_>>();
    for (u, v) in [(0.0, 0.0), (0.25, 0.5), (1.0, 0.3), (1.5, -0.5)] {
        let levels = patch.de_casteljau(u, v);
        assert_eq!(levels.rows.len(), 3);
        assert_eq!(lengths(&levels.column), [3, 2, 1]);
        let nets = patch.control_points().chunks(4).zip(&levels.column[0]);
        for (of_row, (row, &end)) in levels.rows.iter().zip(nets) {
            assert_eq!(lengths(of_row), [4, 3, 2, 1]);
            assert_eq!((&of_row[0][..], of_row[3][0]), (row, end));
            assert_near(end, Curve::new(row).unwrap().eval(u), 1e-14);
        }
        assert_eq!(levels.column[2], [levels.point]);
        assert_near(levels.point, patch.eval(u, v), 1e-14);
    }
}

#[test]
fn a_patch_from_another_basis() {
    let mut random = Rng(30);
    let net: [DVec3; 16] = std::array::from_fn(|_| random.grid_point());
    // The Bézier basis and its matrix leave the points unchanged.
    let same = Patch::from_basis(Basis::Bezier, &net).unwrap();
    assert!(same.approx_eq(&Patch::new(&net, 3, 3).unwrap(), 1e-14));
    // Every basis is converted along the rows, then along the columns.
    let matrix = Basis::Matrix(Basis::BSpline.matrix());
    for basis in [Basis::Hermite, Basis::BSpline, Basis::CatmullRom, matrix] {
        let patch = Patch::from_basis(basis, &net).unwrap();
        for (u, v) in samples(3) {
            let ends = [0, 1, 2, 3].map(|j| {
                let row = [0, 1, 2, 3].map(|i| net[4 * j + i]);
                Curve::from_basis(basis, row).unwrap().eval(u)
            });
            let expected = Curve::from_basis(basis, ends).unwrap().eval(v);
            assert_near(patch.eval(u, v), expected, 1e-14);
        }
    }
    // Catmull–Rom passes through the four inner points; Hermite has its corners and derivatives at the positions of the
    // geometry points.
    let patch = Patch::from_basis(Basis::CatmullRom, &net).unwrap();
    assert_near(patch.eval(0.0, 0.0), net[5], 1e-15);
    assert_near(patch.eval(1.0, 1.0), net[10], 1e-15);
    let patch = Patch::from_basis(Basis::Hermite, &net).unwrap();
    assert_near(patch.eval(1.0, 0.0), net[1], 1e-15);
    assert_near(patch.partials(0.0, 0.0).u, net[2], 1e-14);
    assert_near(patch.partials(0.0, 1.0).v, net[12], 1e-14);
    assert_near(patch.partials(1.0, 1.0).uv, net[15], 1e-14);
}

#[test]
fn a_basis_and_its_net_are_finite() {
    let net = [DVec3::ONE; 16];
    let point = Patch::from_basis(Basis::BSpline, &net).unwrap();
    assert_near(point.eval(0.3, 0.8), DVec3::ONE, 1e-15);
    let mut matrix = Basis::BSpline.matrix();
    matrix[5] = f64::NAN;
    let refused = Patch::from_basis(Basis::Matrix(matrix), &net);
    assert_refused(refused, "basis[5]: expected a finite number");
    let mut broken = net;
    broken[3].y = f64::INFINITY;
    let refused = Patch::from_basis(Basis::BSpline, &broken);
    assert_refused(refused, "net[3]: expected a finite number");
}

/// At a collapsed edge of a plane patch both limits are rounding noise; k1 is still the larger one.
#[test]
fn limits_are_in_order() {
    let mut rng = Rng(17);
    for _ in 0..200 {
        let [p, q] = [(); 2].map(|()| DVec3::from([(); 3].map(|()| 100.0 * rng.signed())));
        let patch = patch(&[DVec3::ZERO, p, DVec3::ZERO, q], 1, 1);
        let Curvature { k1, k2, .. } = patch.curvature(0.0, 1.0);
        assert!(k1 >= k2, "{p} {q}: {k1:e} is less than {k2:e}");
    }
}
