//! Surfaces of rational patches: how they are joined, and queries, with closed forms and polynomial surfaces as references.

use super::within;
use crate::support::nets::{cube, teapot};
use crate::support::{Rng, cases};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::WireframeOptions;
use casteljau::surface::PatchEdge;
use casteljau::{
    Grid, NurbsCurve, NurbsSurface, RationalPatch, RationalSurface, Surface, TessellationOptions,
};
use std::f64::consts::{PI, TAU};

const CENTER: DVec3 = DVec3::new(0.3, -0.2, 0.5);

fn axis() -> DVec3 {
    DVec3::new(1.0, 2.0, 3.0).normalize()
}

fn valid<T>(result: Result<T, casteljau::Error>) -> T {
    result.expect("valid")
}

fn distance(a: DVec3, b: DVec3) -> f64 {
    (a - b).length()
}

fn random_point(rng: &mut Rng) -> DVec3 {
    DVec3::new(rng.signed(), rng.signed(), rng.signed())
}

/// The same surface with other parameters: t/(1 − t) is multiplied by a constant along u, and by another one along v.
fn reparametrized(surface: &Surface, [r, s]: [f64; 2]) -> RationalSurface {
    let degrees: Vec<[usize; 2]> = (0..surface.patch_count())
        .map(|k| surface.degrees(k).expect("a patch"))
        .collect();
    let power = |x: f64, n: usize| x.powi(i32::try_from(n).expect("small"));
    let weights = degrees.iter().flat_map(|&[m, n]| {
        (0..(m + 1) * (n + 1)).map(move |k| power(r, k % (m + 1)) * power(s, k / (m + 1)))
    });
    let weights = weights.collect();
    let (vertices, indices) = (surface.vertices().to_vec(), surface.indices().to_vec());
    valid(RationalSurface::with_degrees(
        vertices, indices, weights, &degrees,
    ))
}

fn random_surface(rng: &mut Rng) -> Surface {
    let (m, n) = (1 + rng.below(3), 1 + rng.below(3));
    let count = (m + 1) * (n + 1);
    let net: Vec<DVec3> = (0..count).map(|_| random_point(rng)).collect();
    let indices = (0..u32::try_from(count).expect("small")).collect();
    valid(Surface::new(net, indices, m, n))
}

#[test]
fn constructors_share_vertices() {
    let sphere = valid(valid(NurbsSurface::sphere(CENTER, 1.5, axis())).to_surface());
    // Eight around each of three parallels, and the poles.
    assert_eq!(sphere.vertices().len(), 3 * 8 + 2);
    let topology = sphere.topology();
    assert_eq!(
        (topology.shared.len(), topology.collapsed.len()),
        (4 * 2 + 4, 8)
    );
    assert!(topology.open.is_empty() && sphere.weight_mismatches().is_empty());
    let torus = valid(valid(NurbsSurface::torus(CENTER, 2.0, 0.5, axis())).to_surface());
    assert_eq!(torus.vertices().len(), 64);
    assert_eq!(torus.topology().shared.len(), 32);
    for (k, patch) in torus.patches().enumerate() {
        assert_eq!(patch.weights(), torus.patch_weights(k).expect("a patch"));
        assert_eq!(valid(torus.eval(k, 0.3, 0.6)), patch.eval(0.3, 0.6));
    }
    assert!(torus.eval(16, 0.0, 0.0).is_err() && torus.patch_weights(16).is_none());
}

#[test]
fn weights_in_proportion_join_edges() {
    // Two squares side by side, whose common edge has the given weights in the second one.
    let points = |x: f64| {
        let at = |i: u32, j: u32| DVec3::new(x + f64::from(i) * 0.5, f64::from(j) * 0.5, 0.0);
        let all: Vec<DVec3> = (0..9).map(|k| at(k % 3, k / 3)).collect();
        all
    };
    let first = valid(RationalPatch::new(
        &points(0.0),
        &[1.0, 1.0, 2.0, 1.0, 1.0, 3.0, 1.0, 1.0, 5.0],
        2,
        2,
    ));
    let joined = |column: [f64; 3]| {
        let mut weights = vec![1.0; 9];
        (0..3).for_each(|row| weights[3 * row] = column[row]);
        let second = valid(RationalPatch::new(&points(1.0), &weights, 2, 2));
        valid(RationalSurface::from_patches(&[first.clone(), second]))
    };
    for factor in [1.0, 3.0, 0.1] {
        let surface = joined([2.0 * factor, 3.0 * factor, 5.0 * factor]);
        assert_eq!(surface.vertices().len(), 15);
        assert_eq!(surface.topology().shared.len(), 1, "{factor}");
        assert_eq!(surface.topology().components, [[0, 1]]);
        assert!(surface.weight_mismatches().is_empty());
        assert_eq!(
            surface.patch_weights(1).expect("two patches")[3],
            3.0 * factor
        );
        let mesh = valid(surface.tessellate(&TessellationOptions::tolerance(1e-3)));
        assert!(mesh.triangle_count() > 2);
    }
    for other in [[2.0, 3.0, 5.1], [1.0, 1.0, 1.0], [5.0, 4.0, 2.0]] {
        let surface = joined(other);
        let topology = surface.topology();
        assert_eq!((topology.shared.len(), topology.open.len()), (0, 8));
        let mismatches = surface.weight_mismatches();
        let sides: Vec<(usize, PatchEdge)> =
            mismatches[0].iter().map(|s| (s.patch, s.edge)).collect();
        assert_eq!(sides, [(0, PatchEdge::U1), (1, PatchEdge::U0)]);
        assert_eq!(mismatches.len(), 1);
    }
    // Reversed: the second patch turned by 180 degrees.
    let turned: Vec<DVec3> = points(1.0).into_iter().rev().collect();
    let weights = [1.0, 1.0, 5.0, 1.0, 1.0, 3.0, 1.0, 1.0, 2.0];
    let second = valid(RationalPatch::new(&turned, &weights, 2, 2));
    let surface = valid(RationalSurface::from_patches(&[first, second]));
    let shared = &surface.topology().shared[0];
    assert!(shared[1].reversed && !shared[0].reversed);
}

/// Edges with the same vertices and other weights: comparing each with all would take 10^10 comparisons.
#[test]
fn edges_of_many_weights_take_linear_time() {
    let count = 50_000;
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    let vertices: Vec<DVec3> = corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
    let indices: Vec<u32> = (0..count).flat_map(|_| 0..4).collect();
    // The last 100 patches repeat the weights of the first ones, times a number.
    let weights = (0..count).flat_map(|k| {
        let w = 1.0 + f64::from(k % (count - 100)) * 1e-6;
        [1.0, w, w * w, w.powi(4)].map(|x| x * f64::from(1 + k % 7))
    });
    let surface = valid(RationalSurface::new(
        vertices,
        indices,
        weights.collect(),
        1,
        1,
    ));
    // As curves all these edges are the same.
    let patches: Vec<RationalPatch> = surface.patches().collect();
    let joined = valid(RationalSurface::from_patches(&patches));
    assert!(joined.topology().open.len() < 4 * (50_000 - 200));
    let topology = surface.topology();
    assert_eq!(topology.shared.len(), 4 * 100);
    assert_eq!(topology.open.len(), 4 * (50_000 - 200));
    let mismatches = surface.weight_mismatches();
    assert_eq!(
        mismatches.iter().map(Vec::len).collect::<Vec<_>>(),
        [50_000 - 100; 4]
    );
}

#[test]
fn invalid_weights_are_named() {
    let square = cube();
    let degrees = vec![[1, 1]; square.patch_count()];
    let with = |weights: Vec<f64>| {
        let (vertices, indices) = (square.vertices().to_vec(), square.indices().to_vec());
        let surface = RationalSurface::with_degrees(vertices, indices, weights, &degrees);
        surface.map(|_| ()).expect_err("invalid").to_string()
    };
    let count = square.indices().len();
    assert_eq!(
        with(vec![1.0; count - 1]),
        "weights: expected a weight for each point, got 23"
    );
    let mut weights = vec![1.0; count];
    weights[5] = 0.0;
    assert_eq!(
        with(weights),
        "weights[5]: expected a number above 0, from 2^-500 to 2^500, got 0"
    );
    let mut weights = vec![1.0; count];
    weights[3] = 2.0_f64.powi(21);
    let (vertices, indices) = (square.vertices().to_vec(), square.indices().to_vec());
    let surface = valid(RationalSurface::with_degrees(
        vertices, indices, weights, &degrees,
    ));
    let error = surface
        .tessellate(&TessellationOptions::tolerance(0.1))
        .expect_err("weights that differ too much");
    assert_eq!(
        error.to_string(),
        "largest weight of a patch divided by its smallest one: expected at most 2^20 for a tolerance, got 2097152"
    );
    assert!(
        surface
            .tessellate(&TessellationOptions::segments(4))
            .is_ok()
    );
}

#[test]
fn areas_and_volumes_of_bodies() {
    let near = |value: f64, exact: f64, name: &str| {
        assert!(
            (value / exact - 1.0).abs() < 1e-10,
            "{name}: {value} for {exact}"
        );
    };
    let surface = |nurbs: Result<NurbsSurface, _>| valid(valid(nurbs).to_surface());
    let sphere = surface(NurbsSurface::sphere(CENTER, 1.5, axis()));
    near(sphere.area(), 4.0 * PI * 2.25, "sphere");
    near(
        sphere.volume().expect("closed"),
        4.0 / 3.0 * PI * 3.375,
        "sphere",
    );
    let torus = surface(NurbsSurface::torus(CENTER, 2.0, 0.5, axis()));
    near(torus.area(), 4.0 * PI * PI, "torus");
    near(torus.volume().expect("closed"), PI * PI, "torus");
    let cylinder = surface(NurbsSurface::cylinder(CENTER, 1.5, 2.0, axis()));
    near(cylinder.area(), TAU * 1.5 * 2.0, "cylinder");
    assert_eq!(cylinder.volume(), None);
    let cone = surface(NurbsSurface::cone(CENTER, 2.0, 1.0, axis()));
    near(cone.area(), PI * 2.0 * 5.0_f64.sqrt(), "cone");
    // Pappus: the area is the length of the profile times the way of its centroid, the volume likewise.
    let radius = axis().any_orthonormal_vector();
    let at = |r: f64, z: f64| CENTER + radius * r + axis() * z;
    let triangle = [at(1.0, 0.0), at(3.0, 0.5), at(2.0, 2.0), at(1.0, 0.0)];
    let knots = [0.0, 0.0, 1.0, 2.0, 3.0, 3.0];
    let profile = valid(NurbsCurve::new(1, &triangle, None, &knots, false));
    let ring = surface(NurbsSurface::revolve(&profile, CENTER, axis(), TAU));
    let sides: [(f64, f64); 3] = [(2.0, 0.5), (-1.0, 1.5), (-1.0, -2.0)];
    let middles = [2.0, 2.5, 1.5];
    let way: f64 = (0..3)
        .map(|k| sides[k].0.hypot(sides[k].1) * middles[k])
        .sum();
    near(ring.area(), TAU * way, "ring");
    // Twice the area of the triangle is 3.5.
    near(
        ring.volume().expect("closed").abs(),
        TAU * 2.0 * 1.75,
        "ring",
    );
    // A tip at the axis, whose side is curved, and a cap: a bell by Pappus from the areas of a quarter of a circle.
    let (x, z) = (radius, axis());
    let arc = valid(NurbsCurve::arc(CENTER, z * -1.0, x, 0.0, PI));
    let ball = surface(NurbsSurface::revolve(&arc, CENTER, axis(), TAU));
    near(ball.area(), 4.0 * PI, "ball");
    near(ball.volume().expect("closed").abs(), 4.0 / 3.0 * PI, "ball");
}

#[test]
fn other_parameters_change_no_measure() {
    let mut rng = Rng(21);
    for case in 0..cases(12, 200) {
        let surface = random_surface(&mut rng);
        let factors = [within(&mut rng, -2.0, 2.0), within(&mut rng, -2.0, 2.0)].map(f64::exp2);
        let rational = reparametrized(&surface, factors);
        // Folds limit the polynomial area to fewer digits.
        let (a, b) = (rational.area(), surface.area());
        assert!((a / b - 1.0).abs() < 1e-4, "{case}: {a} {b}");
        let [a, b] = [rational.bounds(), surface.bounds()].map(|b| b.expect("a patch"));
        assert!(
            distance(a.min, b.min) < 1e-13 && distance(a.max, b.max) < 1e-13,
            "{case}"
        );
        for _ in 0..4 {
            let p = random_point(&mut rng) * 2.0;
            let near = [valid(rational.nearest(p)), valid(surface.nearest(p))];
            let [a, b] = near.map(|near| near.expect("a patch"));
            assert!(
                (a.distance - b.distance).abs() < 1e-13,
                "{case}: {a:?} {b:?}"
            );
            assert!(distance(a.point, valid(rational.eval(0, a.u, a.v))) == 0.0);
            let direction = random_point(&mut rng) - p;
            let hits = [
                valid(rational.intersect_ray(p, direction)),
                valid(surface.intersect_ray(p, direction)),
            ];
            assert_eq!(hits[0].len(), hits[1].len(), "{case}");
            for (a, b) in hits[0].iter().zip(&hits[1]) {
                assert!(distance(a.point, b.point) < 1e-9, "{case}: {a:?} {b:?}");
            }
        }
    }
    let teapot = teapot();
    let rational = reparametrized(&teapot, [1.0, 1.0]);
    assert_eq!(rational, RationalSurface::from(&teapot));
    assert_eq!(rational.topology(), teapot.topology());
    let grids = [
        valid(rational.grid(Grid::from(5), true)),
        valid(teapot.grid(Grid::from(5), true)),
    ];
    assert_eq!(grids[0].indices, grids[1].indices);
    assert_eq!(grids[0].quads, grids[1].quads);
    for (a, b) in grids[0].positions.iter().zip(&grids[1].positions) {
        assert!((a - b).abs() <= f32::EPSILON * 4.0);
    }
    for (a, b) in grids[0].normals.iter().zip(&grids[1].normals) {
        assert!((a - b).abs() <= 2e-5);
    }
    let lines = [
        valid(rational.isocurves(3)).len(),
        valid(teapot.isocurves(3)).len(),
    ];
    assert_eq!(lines[0], lines[1]);
    let wires = [
        valid(rational.wireframe(&WireframeOptions::new())),
        valid(teapot.wireframe(&WireframeOptions::new())),
    ];
    assert!(wires[0].triangle_count() >= wires[1].triangle_count() / 2);
    let cube = cube();
    let volume = reparametrized(&cube, [1.0, 1.0]).volume();
    let exact = cube.volume().expect("closed");
    assert!((volume.expect("closed") / exact - 1.0).abs() < 1e-14);
}

#[test]
fn nearest_points_and_rays_of_bodies() {
    let mut rng = Rng(22);
    let sphere = valid(valid(NurbsSurface::sphere(CENTER, 1.5, axis())).to_surface());
    let torus = valid(valid(NurbsSurface::torus(CENTER, 2.0, 0.5, axis())).to_surface());
    let of_torus = |p: DVec3| {
        let height = (p - CENTER).dot(axis());
        let radius = (p - CENTER - axis() * height).length();
        ((radius - 2.0).hypot(height) - 0.5).abs()
    };
    let bounds = torus.bounds().expect("a patch");
    for k in 0..3 {
        // The highest point of the tube in a direction is that of its circle, and its radius.
        let extent = 2.0 * (1.0 - axis()[k] * axis()[k]).sqrt() + 0.5;
        assert!((bounds.max[k] - CENTER[k] - extent).abs() < 1e-14);
        assert!((bounds.min[k] - CENTER[k] + extent).abs() < 1e-14);
    }
    for case in 0..cases(40, 400) {
        let p = CENTER + random_point(&mut rng) * 3.0;
        let exact = ((p - CENTER).length() - 1.5).abs();
        let near = valid(sphere.nearest(p)).expect("patches");
        assert!(
            (near.distance - exact).abs() < 1e-14,
            "{case}: {near:?} {exact}"
        );
        let near = valid(torus.nearest(p)).expect("patches");
        let off = (near.distance - of_torus(p)).abs();
        assert!(off < 1e-14, "{case}: {near:?} {}", of_torus(p));
        // The hits on the sphere, from the quadratic equation.
        let direction = (CENTER + random_point(&mut rng) - p).normalize();
        let b = (CENTER - p).dot(direction);
        let root = b * b - (p - CENTER).length_squared() + 2.25;
        let exact = [b - root.sqrt(), b + root.sqrt()];
        let exact: Vec<f64> = exact.into_iter().filter(|&t| t > 0.0).collect();
        let hits = valid(sphere.intersect_ray(p, direction));
        assert_eq!(hits.len(), exact.len(), "{case}: {hits:?} {exact:?}");
        for (hit, t) in hits.iter().zip(exact) {
            assert!((hit.distance - t).abs() < 1e-12, "{case}");
        }
        for hit in valid(torus.intersect_ray(p, direction)) {
            assert!(of_torus(hit.point) < 1e-13);
            assert!((hit.point - p).cross(direction).length() < 1e-12);
        }
    }
    // At the center of the sphere all points are equally near, and a ray along the axis hits both poles once.
    let near = valid(sphere.nearest(CENTER)).expect("patches");
    assert!((near.distance - 1.5).abs() < 1e-14);
    let hits = valid(sphere.intersect_ray(CENTER - axis() * 4.0, axis()));
    let distances: Vec<f64> = hits.iter().map(|hit| hit.distance).collect();
    assert!(distances.len() == 2, "{hits:?}");
    assert!((distances[0] - 2.5).abs() < 1e-12 && (distances[1] - 5.5).abs() < 1e-12);
}

#[test]
fn nearest_points_of_random_patches_are_those_of_samples() {
    let mut rng = Rng(23);
    for case in 0..cases(20, 300) {
        let spread = within(&mut rng, 0.0, 10.0);
        let patch = super::surface::random_patch(&mut rng, spread);
        let surface = RationalSurface::from(&patch);
        let samples: Vec<DVec3> = (0..2500)
            .map(|k| patch.eval(f64::from(k % 50) / 49.0, f64::from(k / 50) / 49.0))
            .collect();
        for _ in 0..4 {
            let p = random_point(&mut rng);
            let near = valid(surface.nearest(p)).expect("a patch");
            let closest = samples
                .iter()
                .map(|q| distance(*q, p))
                .fold(f64::INFINITY, f64::min);
            assert!(
                near.distance <= closest + 1e-14,
                "{case}: {near:?} {closest}"
            );
            assert!((distance(near.point, p) - near.distance).abs() < 1e-15);
            // A point of the patch is found again.
            let q = patch.eval(rng.unit(), rng.unit());
            let near = valid(surface.nearest(q)).expect("a patch");
            assert!(near.distance < 1e-14, "{case}: {near:?}");
        }
    }
}

#[test]
fn nearest_points_beside_a_point_of_the_patch() {
    let mut rng = Rng(41);
    for case in 0..400 {
        // Large quotients of weights: the search has many parts.
        let net: Vec<DVec3> = (0..4).map(|_| random_point(&mut rng)).collect();
        let weights: Vec<f64> = (0..4)
            .map(|_| 10.0_f64.powf(within(&mut rng, -3.0, 3.0)))
            .collect();
        let patch = valid(RationalPatch::new(&net, &weights, 1, 1));
        let on_patch = patch.eval(rng.unit(), rng.unit());
        let distance = 10.0_f64.powf(within(&mut rng, -6.0, -2.0));
        let p = on_patch + random_point(&mut rng).normalize() * distance;
        let nearest = valid(RationalSurface::from(&patch).nearest(p)).expect("one patch");
        assert!(
            nearest.distance <= distance * (1.0 + 1e-9) + 1e-13,
            "{case}: {} for {distance}",
            nearest.distance
        );
    }
}

#[test]
fn affine_maps_and_moves_keep_weights() {
    let torus = valid(valid(NurbsSurface::torus(CENTER, 2.0, 0.5, axis())).to_surface());
    let moved = valid(torus.transform(&DAffine3::from_scale(DVec3::new(2.0, 1.0, 1.0))));
    assert_eq!(moved.weights(), torus.weights());
    let volume = moved.volume().expect("closed");
    assert!((volume / (2.0 * PI * PI) - 1.0).abs() < 1e-10);
    let mut bent = torus.clone();
    bent.move_point(0, DVec3::splat(4.0)).expect("a vertex");
    assert_eq!(bent.topology(), torus.topology());
    assert!(bent.volume().expect("closed") > 0.0);
}

#[test]
fn text_keeps_every_bit() {
    let torus = valid(valid(NurbsSurface::torus(CENTER, 2.0, 0.5, axis())).to_surface());
    let text = torus.to_text();
    assert_eq!(RationalSurface::parse(&text), Ok(torus));
    let teapot = teapot();
    let plain = RationalSurface::from(&teapot);
    assert_eq!(plain.to_text(), teapot.to_text());
    assert_eq!(RationalSurface::parse(&plain.to_text()), Ok(plain));
}

/// Every method on input at the limits: nothing panics, takes long or gives NaN.
#[test]
fn degenerate_surfaces_give_defined_results() {
    let mut rng = Rng(24);
    for case in 0..cases(24, 400) {
        let (m, n) = match case % 6 {
            0 => (1, 1),
            1 => (12, 1),
            _ => (1 + rng.below(3), 1 + rng.below(3)),
        };
        let count = (m + 1) * (n + 1);
        let size = [1.0, 1e-300, 1e-8, 1e30, 1e100, 1e150][rng.below(6)];
        let shape = rng.below(5);
        let from = if rng.chance(0.3) {
            random_point(&mut rng) * size
        } else {
            DVec3::ZERO
        };
        let along = random_point(&mut rng);
        let vertices: Vec<DVec3> = (0..count)
            .map(|k| match shape {
                0 => from,                                                             // a point
                1 => from + along * size * rng.unit(),                                 // a curve
                2 if k < m + 1 => from,                                                // a pole
                3 => from + random_point(&mut rng) * size * DVec3::new(1.0, 1.0, 0.0), // a plane
                _ => from + random_point(&mut rng) * size,
            })
            .collect();
        let spread = [0.0, 1.0, 10.0, 499.0][rng.below(4)];
        let weights: Vec<f64> = (0..count).map(|_| (rng.signed() * spread).exp2()).collect();
        let indices = (0..u32::try_from(count).expect("small")).collect();
        let surface = valid(RationalSurface::new(vertices, indices, weights, m, n));
        let is_number = |x: f64| assert!(!x.is_nan(), "case {case}");
        let mesh = |mesh: Result<casteljau::Mesh<f64>, _>| {
            if let Ok(mesh) = mesh {
                mesh.positions
                    .iter()
                    .chain(&mesh.normals)
                    .for_each(|&x| is_number(x));
            }
        };
        let bounds = surface.bounds().expect("a patch");
        let extent = (bounds.max - bounds.min).max_element();
        mesh(surface.tessellate_f64(&TessellationOptions::segments(3)));
        mesh(surface.tessellate_f64(&TessellationOptions::tolerance(extent / 30.0)));
        if let Ok(grid) = surface.grid(Grid::from(3), false) {
            grid.normals.iter().for_each(|&x| is_number(f64::from(x)));
        }
        is_number(surface.area());
        is_number(surface.volume().unwrap_or_default());
        let p = random_point(&mut rng) * size;
        let near = valid(surface.nearest(p)).expect("a patch");
        is_number(near.distance);
        if let Ok(hits) = surface.intersect_ray(p, DVec3::X) {
            hits.iter().for_each(|hit| is_number(hit.distance));
        }
        assert!(surface.isocurves(2).is_ok());
        let _ = surface.wireframe(&WireframeOptions::new());
        assert_eq!(RationalSurface::parse(&surface.to_text()), Ok(surface));
    }
    let empty = valid(RationalSurface::new(vec![], vec![], vec![], 3, 3));
    assert_eq!(
        (empty.bounds(), empty.area(), empty.volume()),
        (None, 0.0, None)
    );
    assert_eq!(valid(empty.nearest(DVec3::ZERO)), None);
    let mesh = valid(empty.tessellate(&TessellationOptions::tolerance(0.1)));
    assert_eq!(mesh.vertex_count(), 0);
}
