//! The teapot: its data, and figures known from other sources.

use casteljau::glam::{DAffine3, DVec2, DVec3};
use casteljau::models::{Height, Up};
use casteljau::{Grid, Mesh, Surface, TeapotOptions};
use wasm_bindgen_test::wasm_bindgen_test;

fn teapot() -> Surface {
    Surface::teapot(TeapotOptions::default())
}

/// All parts off; tests switch parts on.
const NOTHING: TeapotOptions = TeapotOptions {
    rim: false,
    body: false,
    handle: false,
    spout: false,
    lid: false,
    bottom: false,
    height: Height::Squashed,
    up: Up::Z,
};

#[cfg(not(target_family = "wasm"))]
#[test]
fn data_are_those_of_the_usual_listing_bit_for_bit() {
    let data = crate::support::golden::golden("teapot");
    let vertex = |index: &serde_json::Value| {
        let vertex = &data["vertices"][usize::try_from(index.as_u64().unwrap()).unwrap()];
        [0, 1, 2].map(|axis| vertex[axis].as_f64().unwrap().to_bits())
    };
    let patches = data["patches"].as_array().unwrap();
    assert_eq!(patches.len(), 32);
    for (patch, indices) in teapot().patches().zip(patches) {
        let listed: Vec<_> = indices.as_array().unwrap().iter().map(vertex).collect();
        let points = patch.control_points().iter();
        let ours: Vec<_> = points.map(|p| p.to_array().map(f64::to_bits)).collect();
        assert_eq!(ours, listed);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn counts() {
    let surface = teapot();
    assert_eq!(surface.patch_count(), 32);
    // The listing's 306 vertices, minus 4 that no patch uses and 12 that repeat the edge between body and bottom.
    assert_eq!(surface.vertices().len(), 290);
    let mut used = vec![false; 290];
    for &index in surface.indices() {
        used[index as usize] = true;
    }
    assert!(used.iter().all(|&used| used));
    let mesh = surface.grid(Grid::from(16), false).unwrap();
    assert_eq!(mesh.vertex_count(), 9_248);
    assert_eq!(mesh.triangle_count(), 16_384);
}

#[wasm_bindgen_test(unsupported = test)]
fn parts_are_ranges_of_patches() {
    let whole: Vec<_> = teapot().patches().collect();
    let only = |options: TeapotOptions| Surface::teapot(options).patches().collect::<Vec<_>>();
    let rim = TeapotOptions {
        rim: true,
        ..NOTHING
    };
    let body = TeapotOptions {
        body: true,
        ..NOTHING
    };
    let handle = TeapotOptions {
        handle: true,
        ..NOTHING
    };
    let spout = TeapotOptions {
        spout: true,
        ..NOTHING
    };
    let lid = TeapotOptions {
        lid: true,
        ..NOTHING
    };
    let bottom = TeapotOptions {
        bottom: true,
        ..NOTHING
    };
    assert_eq!(only(rim), whole[0..4]);
    assert_eq!(only(body), whole[4..12]);
    assert_eq!(only(handle), whole[12..16]);
    assert_eq!(only(spout), whole[16..20]);
    assert_eq!(only(lid), whole[20..28]);
    assert_eq!(only(bottom), whole[28..32]);
    assert!(only(NOTHING).is_empty());
    assert!(Surface::teapot(NOTHING).vertices().is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn heights_and_axes() {
    let of = |height, up| {
        let surface = Surface::teapot(TeapotOptions {
            height,
            up,
            ..TeapotOptions::default()
        });
        surface.control_bounds().unwrap()
    };
    let squashed = of(Height::Squashed, Up::Z);
    assert_eq!(squashed.min, DVec3::new(-3.0, -2.0, 0.0));
    assert_eq!(squashed.max, DVec3::new(3.525, 2.0, 3.15));
    assert_eq!(of(Height::Original, Up::Z).max.z, 4.2);
    let turned = of(Height::Original, Up::Y);
    assert_eq!(turned.min, DVec3::new(-3.0, 0.0, -2.0));
    assert_eq!(turned.max, DVec3::new(3.525, 4.2, 2.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn up_is_a_turn_and_not_a_mirror_image() {
    let turn = DAffine3::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let options = TeapotOptions {
        up: Up::Y,
        ..TeapotOptions::default()
    };
    let (turned, expected) = (
        Surface::teapot(options),
        teapot().transform(&turn).expect("a finite image"),
    );
    for (a, b) in turned.patches().zip(expected.patches()) {
        assert!(a.approx_eq(&b, 1e-15));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn limit_normals_at_the_poles() {
    let surface = teapot();
    for (patches, expected) in [(20..24, DVec3::Z), (28..32, -DVec3::Z)] {
        for index in patches {
            let patch = surface.patch(index).unwrap();
            for u in [0.0, 0.1, 0.5, 1.0] {
                let normal = patch.normal(u, 0.0);
                assert!((normal - expected).length() < 1e-15, "{index}: {normal}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn normals_have_length_one_and_point_outwards() {
    let grid = Grid::from(16);
    let mesh = teapot().grid(grid, false).unwrap();
    for vertex in 0..mesh.vertex_count() {
        let vector = |list: &[f32]| {
            let [x, y, z] = [0, 1, 2].map(|axis| f64::from(list[3 * vertex + axis]));
            DVec3::new(x, y, z)
        };
        let (p, normal) = (vector(&mesh.positions), vector(&mesh.normals));
        assert!((normal.length() - 1.0).abs() < 3e-7);
        let outwards = match mesh.patch_ids[vertex] {
            // Pointing away from the axis.
            4..12 => DVec3::new(p.x, p.y, 0.0),
            // Pointing away from the plane of symmetry: the handle, and the spout up to its lip.
            12..18 => DVec3::new(0.0, p.y, 0.0),
            // The lid's underside turns inwards below the knob.
            24..28 => DVec3::Z,
            28..32 => -DVec3::Z,
            _ => continue,
        };
        assert!(normal.dot(outwards) > -1e-6, "{p} {normal}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn all_joints_of_the_listing_are_shared() {
    // Of 128 edges 52 pairs are shared, 16 are open, 8 are collapsed: so open edges occur once by their vertices.
    let surface = teapot();
    let mut names = Vec::new();
    for index in 0..32 {
        let net = surface.patch_indices(index).unwrap();
        let column = |i: usize| [net[i], net[i + 4], net[i + 8], net[i + 12]];
        let row = |j: usize| [net[4 * j], net[4 * j + 1], net[4 * j + 2], net[4 * j + 3]];
        for side in [column(0), column(3), row(0), row(3)] {
            let mut backwards = side;
            backwards.reverse();
            names.push(side.min(backwards));
        }
    }
    let count = |name: &[u32; 4]| names.iter().filter(|&other| other == name).count();
    let collapsed = names.iter().filter(|name| name[0] == name[3]).count();
    let open = names.iter().filter(|name| count(name) == 1).count();
    let paired = names.iter().filter(|name| count(name) == 2).count();
    assert_eq!((collapsed, open, paired), (8, 16, 104));
}

#[wasm_bindgen_test(unsupported = test)]
fn greatest_distance_of_the_grids() {
    // Measured independently: dense samples of the surface, compared with the mesh.
    let figures = [
        (4, 12, 0.0949),
        (8, 8, 0.0250),
        (16, 6, 0.00626),
        (32, 4, 0.00157),
    ];
    for (n, samples, expected) in figures {
        let greatest = greatest_distance(&teapot(), n, samples);
        let error = (greatest - expected).abs() / expected;
        assert!(error < 0.01, "n = {n}: {greatest}");
    }
}

/// The patches that are not rotated copies of another by a quarter turn.
const UNLIKE: [usize; 14] = [0, 4, 8, 12, 13, 14, 15, 16, 17, 18, 19, 20, 24, 28];

/// The maximum distance of surface points from the triangles of their own cell and its neighbours.
fn greatest_distance(surface: &Surface, n: usize, samples: usize) -> f64 {
    let grid = Grid::from(n);
    let mesh = surface.grid(grid, false).unwrap();
    let mut greatest: f64 = 0.0;
    for index in UNLIKE {
        let patch = surface.patch(index).unwrap();
        for cell in 0..n * n {
            let (iu, iv) = (cell % n, cell / n);
            for sample in 0..samples * samples {
                let at = |i: usize, k: usize| (i as f64 + k as f64 / samples as f64) / n as f64;
                let (u, v) = (at(iu, sample % samples), at(iv, sample / samples));
                let p = patch.eval(u, v);
                let near = |i: usize| i.saturating_sub(1)..(i + 2).min(n);
                let cells = near(iv).flat_map(|jv| near(iu).map(move |ju| (ju, jv)));
                let distance = cells
                    .flat_map(|(ju, jv)| triangles(&mesh, grid, index, ju, jv))
                    .map(|triangle| distance_to(p, triangle))
                    .fold(f64::INFINITY, f64::min);
                greatest = greatest.max(distance);
            }
        }
    }
    greatest
}

fn triangles(mesh: &Mesh, grid: Grid, patch: usize, iu: usize, iv: usize) -> [[DVec3; 3]; 2] {
    let [a, b, c, d] = grid.quad(iu, iv).map(|vertex| {
        let first = 3 * (patch * grid.vertex_count() + vertex);
        let [x, y, z] = [0, 1, 2].map(|axis| f64::from(mesh.positions[first + axis]));
        DVec3::new(x, y, z)
    });
    [[a, b, c], [a, c, d]]
}

/// The distance of a point from a triangle, which may be degenerate.
fn distance_to(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let inside = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) >= 0.0;
    if normal.length() > 1e-12 && inside(a, b) && inside(b, c) && inside(c, a) {
        return ((p - a).dot(normal) / normal.length()).abs();
    }
    let to_segment = |from: DVec3, to: DVec3| {
        let along = to - from;
        let t = (p - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
        (p - from - along * t.clamp(0.0, 1.0)).length()
    };
    to_segment(a, b).min(to_segment(b, c)).min(to_segment(c, a))
}

#[wasm_bindgen_test(unsupported = test)]
fn profile_is_the_listing_s() {
    // The widest ring of the body has the radius 2 at the height 0.9 and consists of four quarters.
    let surface = teapot();
    for patch in 4..8 {
        let rim = surface.patch(patch).unwrap().isocurve_at_v(1.0);
        for t in [0.0, 0.3, 0.5, 1.0] {
            let p = rim.eval(t);
            let radius = DVec2::new(p.x, p.y).length();
            assert!((radius - 2.0).abs() < 0.02 && (p.z - 0.9).abs() < 1e-15);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_moved_vertex_moves_all_patches_that_share_it() {
    let surface = teapot();
    // The first corner of the rim's first patch is the last corner of its fourth patch.
    let vertex = surface.patch_indices(0).unwrap()[0] as usize;
    let moved = surface.move_point(vertex, DVec3::ONE).unwrap();
    assert_eq!(moved.patch(0).unwrap().eval(0.0, 0.0), DVec3::ONE);
    assert_eq!(moved.patch(3).unwrap().eval(1.0, 0.0), DVec3::ONE);
    assert_eq!(moved.patch(1), surface.patch(1));
    assert!(surface.move_point(290, DVec3::ONE).is_err());
    assert!(surface.move_point(0, DVec3::NAN).is_err());
}
