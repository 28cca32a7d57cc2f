//! Normals of shared vertices, and the part of the tolerance that rounding to f32 takes.

use super::checks::degrees_between;
use super::distance::greatest;
use super::shapes::{all, diagonal, meshed, segments, tolerance};
use super::soup::{Soup, vectors};
use crate::support::Rng;
use crate::support::nets::single;
use casteljau::glam::DVec3;
use casteljau::mesh::Weld;
use casteljau::{Mesh, Surface};

/// Corners whose normals differ by more than this do not share a vertex with weld "normal".
const CREASE_DEGREES: f64 = 0.1;

/// For each position the mean of the corners' normals, weighted by the angles of the triangles.
fn means(own: &Mesh, soup: &Soup) -> Vec<DVec3> {
    let normals: Vec<DVec3> = vectors(&own.normals).collect();
    let mut sums = vec![DVec3::ZERO; soup.points.len()];
    for (k, (locations, corners)) in soup.triangles.iter().zip(&soup.corners).enumerate() {
        let p = soup.corners_at(k);
        for i in 0..3 {
            let angle = (p[(i + 1) % 3] - p[i]).angle_between(p[(i + 2) % 3] - p[i]);
            sums[locations[i] as usize] += normals[corners[i]] * angle;
        }
    }
    sums
}

#[test]
fn normals_of_shared_vertices() {
    all()
        .iter()
        .for_each(|(name, surface)| check_normals(name, surface));
}

pub(crate) fn check_normals(name: &str, surface: &Surface) {
    for options in [segments(5, 5), tolerance(diagonal(surface) * 3e-3)] {
        let welds = [Weld::None, Weld::Normal, Weld::Position];
        let [own, normal, position] = welds.map(|weld| meshed(surface, options, weld));
        let soup = Soup::new(&own);
        let expected = means(&own, &soup);
        let welded = Soup::new(&position);
        // An edge of one of the teaspoon's patches passes through its own end: two points of the surface at one
        // position.
        let twice = position.vertex_count() - welded.points.len();
        let allowed = usize::from(name == "teaspoon");
        assert!(twice <= allowed, "{name}: {twice} points have two vertices");
        let mut vertices = vec![0; welded.points.len()];
        let locations = welded.position_of.iter();
        locations.for_each(|&location| vertices[location as usize] += 1);
        let normals: Vec<DVec3> = vectors(&position.normals).collect();
        let ours = welded.corners.as_flattened().iter();
        for (ours, theirs) in ours.zip(soup.triangles.as_flattened()) {
            let mean = expected[*theirs as usize];
            let single = vertices[welded.position_of[*ours] as usize] == 1;
            // Normals that almost cancel have no meaningful mean.
            let off = degrees_between(normals[*ours], mean.normalize_or_zero());
            let fits = off < 0.01 || mean.length() < 0.01 || !single;
            assert!(fits, "{name}: a mean normal off by {off}°");
        }
        assert_creases(name, &normal);
    }
}

/// Checks that vertices at the same position have different normals.
fn assert_creases(name: &str, mesh: &Mesh) {
    let soup = Soup::new(mesh);
    let mut at: Vec<Vec<DVec3>> = vec![Vec::new(); soup.points.len()];
    let mut alike = 0;
    for (location, normal) in soup.position_of.iter().zip(vectors(&mesh.normals)) {
        for &other in &at[*location as usize] {
            let apart = degrees_between(other, normal);
            alike += usize::from(apart < 0.999 * CREASE_DEGREES);
        }
        at[*location as usize].push(normal);
    }
    let allowed = usize::from(name == "teaspoon");
    assert!(alike <= allowed, "{name}: {alike} vertices too many");
}

/// An arch as high as the tolerance allows; rounding to f32 moves its ends down by half an ulp.
#[test]
fn rounding_has_its_share() {
    let ulp = (-12.0_f64).exp2();
    let base = 2048.0 + 0.49 * ulp;
    let allowed = 4.0 * f64::from(f32::EPSILON) * (base + 16.0 * ulp);
    let height = allowed * 0.97;
    // The middle of a parabola has half the height of its control point.
    let arch = [(0.0, 0.0), (0.5, 2.0 * height), (1.0, 0.0)];
    let row = |y: f64| arch.map(|(x, z)| DVec3::new(x, y, base + z));
    let surface = single([row(0.0), row(1.0)].as_flattened(), 2, 1);
    let mesh = meshed(&surface, tolerance(allowed), Weld::Position);
    let (max, _) = greatest(&surface, &Soup::new(&mesh), 10_000);
    assert!(max <= allowed, "{max} for {allowed}");
    assert!(mesh.triangle_count() < 16);
}

/// Every patch has a corner at the same point, where all patches share a vertex.
#[test]
fn thousands_of_patches_in_one_point() {
    let count = 40_000;
    let mut rng = Rng(7);
    let mut vertices = vec![DVec3::ZERO];
    vertices.extend((0..3 * count).map(|_| rng.point(3)));
    let indices = (0..count).flat_map(|k| [0, 3 * k + 1, 3 * k + 2, 3 * k + 3]);
    let indices = indices.map(|k| u32::try_from(k).unwrap()).collect();
    let surface = Surface::new(vertices, indices, 1, 1).unwrap();
    let mesh = meshed(&surface, segments(1, 1), Weld::Normal);
    assert_eq!(mesh.triangle_count(), 2 * count);
    let welded = meshed(&surface, segments(1, 1), Weld::Position);
    assert_eq!(welded.vertex_count(), 3 * count + 1);
}
