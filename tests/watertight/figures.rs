//! Figures known from other sources: numbers of edges of the tea set, of vertices and triangles, distances.

use super::distance::greatest;
use super::shapes::{diagonal, is_point, lines, meshed, part, segments, side_points};
use super::shapes::{teapot, tolerance};
use super::soup::{Soup, vectors};
use crate::support::near;
use crate::support::surfaces::listing;
use casteljau::glam::DVec3;
use casteljau::mesh::{Indices, Weld};
use casteljau::models::Up;
use casteljau::surface::Topology;
use casteljau::{Grid, Mesh, Surface};

/// The numbers of shared, open and collapsed edges.
pub(crate) fn counts(surface: &Surface) -> [usize; 3] {
    let t = surface.topology();
    assert!(t.non_manifold.is_empty());
    [t.shared.len(), t.open.len(), t.collapsed.len()]
}

#[test]
fn sides_of_the_known_surfaces() {
    assert_eq!(counts(&teapot()), [52, 16, 8]);
    let parts = teapot().topology().components;
    assert!(parts.iter().map(Vec::len).eq([16, 4, 4, 8]));
    let [cup, spoon] = [Surface::teacup(Up::Z), Surface::teaspoon(Up::Z)];
    for (surface, expected) in [
        (cup, [46, 12]),
        (spoon, [28, 8]),
        (listing("teapot"), [52, 16]),
        (listing("teacup"), [46, 12]),
        (listing("teaspoon"), [28, 8]),
    ] {
        assert_eq!(counts(&surface)[..2], expected);
    }
}

#[test]
fn sides_are_joined_where_their_points_are() {
    let surfaces = [teapot(), Surface::teacup(Up::Y), listing("teaspoon")];
    surfaces.iter().for_each(check_sides);
}

/// Compares each edge with each other edge.
pub(crate) fn check_sides(surface: &Surface) {
    let topology = surface.topology();
    let components = topology.components.clone();
    let mut expected = Topology {
        components,
        ..Topology::default()
    };
    for uses in lines(surface) {
        let patch = surface.patch(uses[0].patch).unwrap();
        match uses.len() {
            1 if is_point(&side_points(&patch, uses[0].edge)) => expected.collapsed.extend(uses),
            1 => expected.open.extend(uses),
            2 => expected.shared.push(uses),
            _ => expected.non_manifold.push(uses),
        }
    }
    // A collapsed edge is equal in both directions.
    assert_eq!(topology, expected);
}

fn even(n: usize, weld: Weld) -> Mesh {
    meshed(&teapot(), segments(n, n), weld)
}

#[test]
fn vertices_and_triangles_of_even_segments() {
    for n in [1, 2, 3, 16, 21] {
        let counts = [Weld::Position, Weld::None].map(|weld| even(n, weld).vertex_count());
        assert_eq!(counts, [32 * n * n + 4 * n + 1, 32 * (n + 1) * (n + 1)]);
    }
    let mesh = even(16, Weld::Position);
    let counts = [mesh.vertex_count(), mesh.triangle_count()];
    assert_eq!(counts, [8_257, 16_256]);
    assert_eq!(Soup::new(&mesh).boundary(1).len(), 256);
    assert!(matches!(even(45, Weld::Position).indices, Indices::U16(_)));
    assert!(matches!(even(46, Weld::Position).indices, Indices::U32(_)));
}

/// Of tessellations and of grids. Samples find slightly less than the maximum distance.
#[test]
fn distance_of_even_segments() {
    for (n, expected) in [(4, 0.0949), (8, 0.0250), (16, 0.00626), (32, 0.00157)] {
        let grid = teapot().grid(Grid::from(n), false).unwrap();
        for mesh in [even(n, Weld::Position), grid] {
            let soup = Soup::new(&mesh);
            let (_, patch) = greatest(&teapot(), &soup, 32 * 64 * 64);
            let (max, _) = greatest(&part(&teapot(), &[patch]), &soup, 600 * 600);
            let share = max / expected;
            assert!(share > 0.98 && share < 1.004, "{n}: {max} for {expected}");
        }
    }
}

#[test]
fn normals_of_knob_and_bottom() {
    for weld in [Weld::Position, Weld::Normal, Weld::None] {
        let mesh = even(5, weld);
        let mut seen = 0;
        for (p, normal) in vectors(&mesh.positions).zip(vectors(&mesh.normals)) {
            for (z, expected) in [(3.15, DVec3::Z), (0.0, DVec3::NEG_Z)] {
                if p.distance(DVec3::Z * z) < 1e-6 {
                    assert!(normal.distance(expected) < 1e-6, "{normal} at {p}");
                    seen += 1;
                }
            }
        }
        // Four patches meet at each of these points; with separate vertices each patch has six vertices there.
        assert_eq!(seen, if weld == Weld::None { 48 } else { 2 });
    }
}

/// The number of triangles at a thousandth of the diagonal.
pub(crate) fn fine_triangles(surface: &Surface) -> usize {
    let options = tolerance(diagonal(surface) * 1e-3);
    meshed(surface, options, Weld::Normal).triangle_count()
}

#[test]
fn triangles_at_a_thousandth_of_the_diagonal() {
    let triangles = fine_triangles(&teapot());
    println!("teapot: {triangles}");
    assert!(triangles <= 13_500, "{triangles}");
}

#[test]
fn area_of_the_teacup() {
    let cup = Surface::teacup(Up::Z);
    let mesh = meshed(&cup, tolerance(diagonal(&cup) * 1e-5), Weld::Normal);
    near(Soup::new(&mesh).area() / 9.981_697_616, 1.0, 2e-4);
}
