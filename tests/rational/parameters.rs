//! Surfaces of patches whose common edges are the same curve with other parameters.

use super::mesh::deviation;
use super::within;
use crate::support::nets::{triangles, vectors};
use crate::support::{Rng, cases};
use casteljau::glam::DVec3;
use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Mesh, NurbsSurface, RationalPatch, RationalSurface};
use std::collections::{HashMap, HashSet};
use std::f64::consts::PI;

fn valid<T>(result: Result<T, casteljau::Error>) -> T {
    result.expect("valid")
}

fn random_point(rng: &mut Rng) -> DVec3 {
    DVec3::new(rng.signed(), rng.signed(), rng.signed())
}

fn power(x: f64, n: usize) -> f64 {
    x.powi(i32::try_from(n).expect("small"))
}

/// A patch of random points, with random weights from 1/2 to 2.
fn random_patch(rng: &mut Rng, [m, n]: [usize; 2]) -> RationalPatch {
    let count = (m + 1) * (n + 1);
    let net: Vec<DVec3> = (0..count).map(|_| random_point(rng)).collect();
    let weights: Vec<f64> = (0..count).map(|_| within(rng, -1.0, 1.0).exp2()).collect();
    valid(RationalPatch::new(&net, &weights, m, n))
}

/// The same points with other parameters: t/(1 − t) is divided by a factor in each direction.
fn with_factors(patch: &RationalPatch, [r, s]: [f64; 2]) -> RationalPatch {
    let (m, n) = (patch.degree_u(), patch.degree_v());
    let weights = patch.weights().iter().enumerate();
    let weights: Vec<f64> = weights
        .map(|(k, w)| w * power(r, k % (m + 1)) * power(s, k / (m + 1)))
        .collect();
    valid(RationalPatch::new(patch.control_points(), &weights, m, n))
}

/// One of the eight patches with the same points that differ in the order of their parameters.
fn arranged(patch: &RationalPatch, kind: usize) -> RationalPatch {
    let (m, n) = (patch.degree_u(), patch.degree_v());
    let (rows, columns) = if kind < 4 { (n, m) } else { (m, n) };
    let order = (0..=rows).flat_map(|j| (0..=columns).map(move |i| (i, j)));
    let order = order.map(|(i, j)| {
        let i = if kind % 2 == 1 { columns - i } else { i };
        let j = if kind % 4 > 1 { rows - j } else { j };
        let (i, j) = if kind < 4 { (i, j) } else { (j, i) };
        j * (m + 1) + i
    });
    let order: Vec<usize> = order.collect();
    let points: Vec<DVec3> = order.iter().map(|&k| patch.control_points()[k]).collect();
    let weights: Vec<f64> = order.iter().map(|&k| patch.weights()[k]).collect();
    valid(RationalPatch::new(&points, &weights, columns, rows))
}

/// Asserts that both patches have the same points: the quotients of their weights are c·rⁱ·sʲ.
fn assert_same_points(a: &RationalPatch, b: &RationalPatch, name: &str) {
    assert_eq!(a.control_points(), b.control_points(), "{name}");
    let columns = a.degree_u() + 1;
    let quotient = |k: usize| a.weights()[k] / b.weights()[k];
    let [r, s] = [1, columns].map(|k| quotient(k) / quotient(0));
    for k in 0..a.weights().len() {
        let expected = quotient(0) * power(r, k % columns) * power(s, k / columns);
        assert!((quotient(k) / expected - 1.0).abs() < 1e-13, "{name}");
    }
    for (u, v) in [(0.3, 0.6), (0.5, 0.0), (1.0, 0.8)] {
        let parameter = |t: f64, factor: f64| t * factor / (1.0 - t + t * factor);
        let off = (a.eval(u, v) - b.eval(parameter(u, r), parameter(v, s))).length();
        assert!(off < 1e-12, "{name}: {off}");
    }
}

/// The number of edges with one triangle, and the Euler characteristic. Patches may disagree on the side of the normals.
fn open_edges_and_euler(mesh: &Mesh<f64>) -> (usize, i64) {
    let mut uses: HashMap<[usize; 2], u32> = HashMap::new();
    for triangle in triangles(mesh) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            *uses.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    assert!(uses.values().all(|&count| count <= 2));
    let vertices: HashSet<usize> = triangles(mesh).into_iter().flatten().collect();
    let count = |n: usize| i64::try_from(n).expect("few");
    let euler = count(vertices.len()) - count(uses.len()) + count(mesh.triangle_count());
    let open = uses.values().filter(|&&count| count == 1).count();
    (open, euler)
}

/// Asserts that edges of a mesh and the distances of a mesh from the surface are right.
fn assert_mesh(surface: &RationalSurface, is_closed: bool, euler: i64, name: &str) {
    assert!(surface.weight_mismatches().is_empty(), "{name}");
    for tolerance in [0.1, 0.02] {
        let options = TessellationOptions::tolerance(tolerance);
        let mesh = valid(surface.tessellate_f64(&options.weld(Weld::Position)));
        let (open, got) = open_edges_and_euler(&mesh);
        assert_eq!((open == 0, got), (is_closed, euler), "{name}");
        let own = valid(surface.tessellate_f64(&options.weld(Weld::None)));
        let off = deviation(surface, &own);
        assert!(off <= tolerance, "{name} at {tolerance}: {off}");
    }
}

#[test]
fn edges_with_other_parameters_are_joined() {
    let mut rng = Rng(41);
    for degree in 1..=4 {
        for rho in [1e-3, 0.04, 0.5, 3.0, 1e3] {
            for kind in 0..8 {
                let name = format!("degree {degree}, {rho}, {kind}");
                let other_degree = 1 + rng.below(4);
                let whole = random_patch(&mut rng, [other_degree, degree]);
                let (a, b) = valid(whole.split_u(within(&mut rng, 0.2, 0.8)));
                let first = arranged(&a, rng.below(8));
                let across = within(&mut rng, -1.0, 1.0).exp2();
                let second = arranged(&with_factors(&b, [across, rho]), kind);
                let surface = valid(RationalSurface::from_patches(&[
                    first.clone(),
                    second.clone(),
                ]));
                assert_eq!(surface.topology().shared.len(), 1, "{name}");
                assert_eq!(surface.patch(0), Some(first), "{name}");
                let changed = surface.patch(1).expect("two patches");
                assert_same_points(&changed, &second, &name);
                assert_mesh(&surface, false, 1, &name);
            }
        }
    }
}

/// Patches between curves with random weights, each with other parameters, one after the other.
fn strip(rng: &mut Rng, degree: usize, count: usize, is_ring: bool) -> Vec<RationalPatch> {
    let mut curves: Vec<Vec<(DVec3, f64)>> = (0..=count)
        .map(|_| {
            let part = |_| (random_point(rng), within(rng, -1.0, 1.0).exp2());
            (0..=degree).map(part).collect()
        })
        .collect();
    if is_ring {
        curves[count] = curves[0].clone();
    }
    let patches = patches_between(&curves).into_iter().map(|patch| {
        let factors = [2.0, 3.5].map(|exponent| within(rng, -exponent, exponent).exp2());
        arranged(&with_factors(&patch, factors), rng.below(8))
    });
    patches.collect()
}

#[test]
fn chains_and_rings_are_joined() {
    let mut rng = Rng(42);
    for case in 0..cases(4, 60) {
        let degree = 1 + case % 4;
        for is_ring in [false, true] {
            let name = format!("{case}, ring: {is_ring}");
            let count = [3, 4, 200][case % 3];
            let mut patches = strip(&mut rng, degree, count, is_ring);
            for k in (1..count).rev() {
                patches.swap(k, rng.below(k + 1));
            }
            let surface = valid(RationalSurface::from_patches(&patches));
            let expected = if is_ring { count } else { count - 1 };
            assert_eq!(surface.topology().shared.len(), expected, "{name}");
            for (changed, patch) in surface.patches().zip(&patches) {
                assert_same_points(&changed, patch, &name);
            }
            assert_eq!(surface.patch(0).as_ref(), patches.first(), "{name}");
            assert_mesh(&surface, false, i64::from(!is_ring), &name);
            // Nothing is left to do.
            let patches: Vec<RationalPatch> = surface.patches().collect();
            assert!(
                RationalSurface::from_patches(&patches) == Ok(surface),
                "{name}"
            );
        }
    }
}

#[test]
fn a_sphere_of_octants_with_other_parameters_is_watertight() {
    let mut rng = Rng(43);
    let center = DVec3::new(0.3, -0.2, 0.5);
    let sphere = valid(NurbsSurface::sphere(center, 1.5, DVec3::new(1.0, 2.0, 3.0)));
    for case in 0..cases(6, 60) {
        let patches = sphere.patches().iter().map(|patch| {
            let factors = [0, 1].map(|_| within(&mut rng, -3.0, 3.0).exp2());
            arranged(&with_factors(patch, factors), rng.below(8))
        });
        let surface = valid(RationalSurface::from_patches(&patches.collect::<Vec<_>>()));
        let topology = surface.topology();
        assert_eq!((topology.shared.len(), topology.collapsed.len()), (12, 8));
        assert!(topology.open.is_empty() && surface.weight_mismatches().is_empty());
        for tolerance in [0.1, 0.01, 0.001] {
            let options = TessellationOptions::tolerance(tolerance).weld(Weld::Position);
            let mesh = valid(surface.tessellate_f64(&options));
            assert_eq!(open_edges_and_euler(&mesh), (0, 2), "{case}");
            let points: Vec<DVec3> = vectors(&mesh.positions).collect();
            for triangle in triangles(&mesh) {
                let [a, b, c] = triangle.map(|k| points[k]);
                for p in [(a + b + c) / 3.0, (a + b) / 2.0, (b + c) / 2.0] {
                    let off = ((p - center).length() - 1.5).abs();
                    assert!(off <= tolerance, "{case} at {tolerance}: {off}");
                }
            }
        }
        let volume = 4.5 * PI;
        // Octants may look inwards.
        assert!((surface.volume().expect("closed").abs() / volume - 1.0).abs() < 1e-9);
    }
}

#[test]
fn three_patches_along_an_edge_have_one_line() {
    let mut rng = Rng(44);
    let first = random_patch(&mut rng, [2, 3]);
    let mut with_parameters = |rho: f64| {
        let other = random_patch(&mut rng, [2, 3]);
        let (mut points, mut weights) = (other.control_points().to_vec(), other.weights().to_vec());
        for k in (0..points.len()).step_by(3) {
            points[k] = first.control_points()[k];
            weights[k] = first.weights()[k];
        }
        let patch = valid(RationalPatch::new(&points, &weights, 2, 3));
        with_factors(&patch, [1.0, rho])
    };
    let patches = [1.0, 8.0, 0.2].map(&mut with_parameters);
    let surface = valid(RationalSurface::from_patches(&patches));
    assert_eq!(surface.topology().non_manifold[0].len(), 3);
    assert!(surface.weight_mismatches().is_empty());
    // Two pairs that are already joined stay pairs.
    let patches = [1.0, 8.0, 8.0, 1.0].map(&mut with_parameters);
    let surface = valid(RationalSurface::from_patches(&patches));
    assert_eq!(surface.topology().shared.len(), 2);
    assert!(surface.patches().eq(patches));
}

/// Patches of degree 1 along u between curves, given by their points and weights.
fn patches_between(curves: &[Vec<(DVec3, f64)>]) -> Vec<RationalPatch> {
    let patches = curves.windows(2).map(|pair| {
        let parts = (0..pair[0].len()).flat_map(|i| [pair[0][i], pair[1][i]]);
        let (points, weights): (Vec<DVec3>, Vec<f64>) = parts.unzip();
        valid(RationalPatch::new(&points, &weights, 1, pair[0].len() - 1))
    });
    patches.collect()
}

#[test]
fn a_ring_that_needs_two_factors_keeps_an_open_edge() {
    let mut rng = Rng(45);
    let count = 5;
    for degree in 1..=4 {
        let mut curve = |_| {
            (0..=degree)
                .map(|_| (random_point(&mut rng), 1.0))
                .collect()
        };
        let mut curves: Vec<Vec<(DVec3, f64)>> = (0..=count).map(&mut curve).collect();
        curves[count] = (0..=degree)
            .map(|i| (curves[0][i].0, power(2.0, i)))
            .collect();
        let patches = patches_between(&curves);
        let surface = valid(RationalSurface::from_patches(&patches));
        let topology = surface.topology();
        let found = (topology.shared.len(), topology.open.len());
        assert_eq!(found, (count - 1, 2 * count + 2), "{degree}");
        let mismatches = surface.weight_mismatches();
        assert_eq!((mismatches.len(), mismatches[0].len()), (1, 2));
        for (changed, patch) in surface.patches().zip(&patches) {
            assert_same_points(&changed, patch, "a ring");
        }
    }
}

#[test]
fn weights_that_would_differ_too_much_stay() {
    let column = |x: f64, weights: [f64; 2]| {
        [0.0, 1.0]
            .into_iter()
            .zip(weights.map(f64::exp2))
            .map(|(y, w)| (DVec3::new(x, y, 0.0), w))
            .collect::<Vec<_>>()
    };
    // The exponents of the weights: of the first patch, and of the second one, whose first edge is shared.
    let is_joined = |first: [[f64; 2]; 2], second: [[f64; 2]; 2]| {
        let patch = |x: f64, weights: [[f64; 2]; 2]| {
            let ends = [column(x, weights[0]), column(x + 1.0, weights[1])];
            patches_between(&ends).remove(0)
        };
        let patches = [patch(0.0, first), patch(1.0, second)];
        let surface = valid(RationalSurface::from_patches(&patches));
        let is_joined = surface.weight_mismatches().is_empty();
        assert_eq!(surface.topology().open.len(), if is_joined { 6 } else { 8 });
        assert_eq!(!is_joined, surface.patches().eq(patches));
        is_joined
    };
    // The weights of the second patch are multiplied by 2⁻¹⁵.
    assert!(is_joined(
        [[0.0; 2], [0.0, -10.0]],
        [[0.0, 5.0], [0.0, -5.0]]
    ));
    assert!(!is_joined(
        [[0.0; 2], [0.0, -10.0]],
        [[0.0, 5.0], [0.0, -6.0]]
    ));
    // They differed as much before.
    assert!(is_joined([[0.0; 2], [0.0, 0.0]], [[0.0, 30.0], [0.0, 0.0]]));
    // Multiplied by 2⁵.
    assert!(is_joined([[0.0; 2]; 2], [[490.0, 485.0], [490.0; 2]]));
    assert!(!is_joined([[0.0; 2]; 2], [[498.0, 493.0], [498.0; 2]]));
    // Degree 64, and the largest quotients.
    let curve = |rho: f64| -> Vec<(DVec3, f64)> {
        let part = |i: u8| {
            (
                DVec3::new(1.0, f64::from(i), 0.0),
                power(rho, usize::from(i)),
            )
        };
        (0..=64).map(part).collect()
    };
    let line = |x: f64| -> Vec<(DVec3, f64)> {
        let part = |i: u8| (DVec3::new(x, f64::from(i), 0.0), 1.0);
        (0..=64).map(part).collect()
    };
    for exponent in [0.3, -0.3, 7.8, -7.8] {
        let mut patches = patches_between(&[line(0.0), line(1.0)]);
        patches.extend(patches_between(&[curve(f64::exp2(exponent)), line(2.0)]));
        let surface = valid(RationalSurface::from_patches(&patches));
        assert_eq!(surface.topology().collapsed.len(), 0);
        assert!(exponent.abs() > 1.0 || surface.weight_mismatches().is_empty());
    }
}
