//! Figures known from other sources: numbers of edges of the teapot, the teacup and Gumbo, of vertices and triangles,
//! distances, volumes.

use super::distance::greatest;
use super::shapes::{diagonal, gumbo, is_point, lines, part, segments, side_points, teapot};
use super::soup::{Soup, vectors};
use crate::support::surfaces::listing;
use casteljau::Surface;
use casteljau::glam::DVec3;
use casteljau::mesh::{Indices, TessellationOptions, Weld};
use casteljau::models::Up;
use casteljau::surface::{EdgeUse, Topology};

#[test]
fn sides_of_the_known_surfaces() {
    let counts = |surface: &Surface| {
        let t = surface.topology();
        assert!(t.non_manifold.is_empty());
        [t.shared.len(), t.open.len(), t.collapsed.len()]
    };
    assert_eq!(counts(&teapot()), [52, 16, 8]);
    let parts: Vec<usize> = teapot()
        .topology()
        .components
        .iter()
        .map(Vec::len)
        .collect();
    assert_eq!(parts, [16, 4, 4, 8]);
    assert_eq!(counts(&Surface::teacup(Up::Z))[..2], [46, 12]);
    assert_eq!(counts(&Surface::teaspoon(Up::Z))[..2], [28, 8]);
    for (name, expected) in [
        ("teapot", [52, 16]),
        ("teacup", [46, 12]),
        ("teaspoon", [28, 8]),
    ] {
        assert_eq!(counts(&listing(name))[..2], expected, "{name}");
    }
    if let Some(surface) = gumbo() {
        assert_eq!(counts(&surface), [247, 8, 10]);
    }
}

/// Compares each edge with each other edge.
#[test]
fn sides_are_joined_where_their_points_are() {
    for surface in [
        Some(teapot()),
        Some(Surface::teacup(Up::Y)),
        Some(listing("teaspoon")),
        gumbo(),
    ]
    .into_iter()
    .flatten()
    {
        let topology = surface.topology();
        let mut expected = Topology {
            components: topology.components.clone(),
            ..Topology::default()
        };
        for uses in lines(&surface) {
            let EdgeUse {
                patch, edge: side, ..
            } = uses[0];
            let point = is_point(&side_points(&surface.patch(patch).unwrap(), side));
            match uses.len() {
                1 if point => expected.collapsed.extend(uses),
                1 => expected.open.extend(uses),
                2 => expected.shared.push(uses),
                _ => expected.non_manifold.push(uses),
            }
        }
        // A collapsed edge is equal in both directions.
        assert_eq!(topology, expected);
    }
}

#[test]
fn vertices_and_triangles_of_even_segments() {
    for n in [1, 2, 3, 16, 21] {
        let count = |weld| {
            teapot()
                .tessellate(&segments(n, n).weld(weld))
                .unwrap()
                .vertex_count()
        };
        assert_eq!(count(Weld::Position), 32 * n * n + 4 * n + 1);
        assert_eq!(count(Weld::None), 32 * (n + 1) * (n + 1));
    }
    let mesh = teapot()
        .tessellate(&segments(16, 16).weld(Weld::Position))
        .unwrap();
    assert_eq!(mesh.vertex_count(), 8_257);
    assert_eq!(mesh.triangle_count(), 16_256);
    assert_eq!(Soup::new(&mesh).boundary(1).len(), 256);
    let bits = |n| {
        teapot()
            .tessellate(&segments(n, n).weld(Weld::Position))
            .unwrap()
            .indices
    };
    assert!(matches!(bits(45), Indices::U16(_)));
    assert!(matches!(bits(46), Indices::U32(_)));
}

/// Samples find slightly less than the maximum distance.
#[test]
fn distance_of_even_segments() {
    for (n, expected) in [(4, 0.0949), (8, 0.0250), (16, 0.00626), (32, 0.00157)] {
        let mesh = teapot()
            .tessellate(&segments(n, n).weld(Weld::Position))
            .unwrap();
        let soup = Soup::new(&mesh);
        let (_, patch) = greatest(&teapot(), &soup, 32 * 64 * 64);
        let (max, _) = greatest(&part(&teapot(), &[patch]), &soup, 600 * 600);
        assert!(
            max > 0.98 * expected && max < 1.004 * expected,
            "{n}: {max} for {expected}"
        );
    }
}

#[test]
fn normals_of_knob_and_bottom() {
    for weld in [Weld::Position, Weld::Normal, Weld::None] {
        let mesh = teapot().tessellate(&segments(5, 5).weld(weld)).unwrap();
        let mut seen = 0;
        for (p, normal) in vectors(&mesh.positions).zip(vectors(&mesh.normals)) {
            let at = |z: f64| (p - DVec3::new(0.0, 0.0, z)).length() < 1e-6;
            for (z, expected) in [(3.15, DVec3::Z), (0.0, DVec3::NEG_Z)] {
                if at(z) {
                    assert!((normal - expected).length() < 1e-6, "{normal} at {p}");
                    seen += 1;
                }
            }
        }
        // Four patches meet at each of these points; with separate vertices each patch has six vertices there.
        assert_eq!(seen, if weld == Weld::None { 48 } else { 2 });
    }
}

#[test]
fn triangles_at_a_thousandth_of_the_diagonal() {
    let count = |surface: &Surface| {
        let tolerance = TessellationOptions::tolerance(diagonal(surface) * 1e-3);
        surface
            .tessellate(&tolerance.weld(Weld::Normal))
            .unwrap()
            .triangle_count()
    };
    let triangles = count(&teapot());
    println!("teapot: {triangles}");
    assert!(triangles <= 13_500, "{triangles}");
    if let Some(surface) = gumbo() {
        let triangles = count(&surface);
        println!("gumbo: {triangles}");
        assert!(
            (triangles as f64 / 25_444.0 - 1.0).abs() <= 0.2,
            "{triangles}"
        );
    }
}

#[test]
fn closed_body_of_gumbo() {
    let Some(surface) = gumbo() else { return };
    let components = surface.topology().components;
    let open: Vec<usize> = surface
        .topology()
        .open
        .iter()
        .map(|side| side.patch)
        .collect();
    let closed = components
        .iter()
        .filter(|patches| !patches.iter().any(|k| open.contains(k)));
    let body = closed.max_by_key(|patches| patches.len()).unwrap();
    let body = part(&surface, body);
    let mut last = f64::INFINITY;
    for relative in [1e-2, 1e-3, 1e-4] {
        let options = TessellationOptions::tolerance(diagonal(&surface) * relative);
        let soup = Soup::new(&body.tessellate(&options.weld(Weld::None)).unwrap());
        assert!(soup.boundary(1).is_empty(), "an open edge");
        let off = (soup.volume() - 2556.7737).abs() / 2556.7737;
        println!("{relative:e}: volume off by {off:.1e}");
        // The volume between the body and the mesh is at most the tolerance times the area, 1726 in total.
        assert!(off < diagonal(&surface) * relative * 1726.0 / 2556.0 && off < last);
        last = off;
    }
    assert!(last < 3e-4);
}

#[test]
fn area_of_the_teacup() {
    let cup = Surface::teacup(Up::Z);
    let mesh = cup
        .tessellate(&TessellationOptions::tolerance(diagonal(&cup) * 1e-5).weld(Weld::Normal))
        .unwrap();
    let area = Soup::new(&mesh).area();
    assert!((area / 9.981_697_616 - 1.0).abs() < 2e-4, "{area}");
}
