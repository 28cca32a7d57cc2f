//! The teapot: figures known from other sources.

use crate::support::nets::{teapot, vectors};
use casteljau::glam::{DAffine3, DVec2, DVec3};
use casteljau::models::{Height, Up};
use casteljau::{Grid, Surface, TeapotOptions};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn counts() {
    let surface = teapot();
    assert_eq!(surface.patch_count(), 32);
    // The listing's 306 vertices, minus 4 that no patch uses and 12 that repeat the edge between body and bottom.
    assert_eq!(surface.vertices().len(), 290);
    assert!((0..290).all(|vertex| surface.indices().contains(&vertex)));
    let mesh = surface.grid(Grid::from(16), false).unwrap();
    let counts = [mesh.vertex_count(), mesh.triangle_count()];
    assert_eq!(counts, [9_248, 16_384]);
}

#[test]
fn parts_are_ranges_of_patches() {
    let whole: Vec<_> = teapot().patches().collect();
    let ranges = [0..4, 4..12, 12..16, 16..20, 20..28, 28..32, 0..0];
    for (k, range) in ranges.into_iter().enumerate() {
        let options = (TeapotOptions::new().rim(k == 0).body(k == 1))
            .handle(k == 2)
            .spout(k == 3)
            .lid(k == 4)
            .bottom(k == 5);
        let part = Surface::teapot(&options);
        assert_eq!(part.patches().collect::<Vec<_>>(), whole[range.clone()]);
        assert_eq!(part.vertices().is_empty(), range.is_empty());
    }
}

#[test]
fn heights_and_axes() {
    let of = |height, up| {
        let options = TeapotOptions::new().height(height).up(up);
        let bounds = Surface::teapot(&options).control_bounds().unwrap();
        [bounds.min, bounds.max].map(|p| p.to_array())
    };
    let squashed = of(Height::Squashed, Up::Z);
    assert_eq!(squashed, [[-3.0, -2.0, 0.0], [3.525, 2.0, 3.15]]);
    assert_eq!(of(Height::Original, Up::Z)[1][2], 4.2);
    let turned = of(Height::Original, Up::Y);
    assert_eq!(turned, [[-3.0, 0.0, -2.0], [3.525, 4.2, 2.0]]);
}

#[test]
fn up_is_a_turn_and_not_a_mirror_image() {
    let turn = DAffine3::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let turned = Surface::teapot(&TeapotOptions::new().up(Up::Y));
    let expected = teapot().transform(&turn).unwrap();
    let mut pairs = turned.patches().zip(expected.patches());
    assert!(pairs.all(|(a, b)| a.approx_eq(&b, 1e-15)));
}

#[test]
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

#[test]
fn normals_have_length_one_and_point_outwards() {
    let mesh = teapot().grid(Grid::from(16), false).unwrap();
    let vertices = vectors(&mesh.positions).zip(vectors(&mesh.normals));
    for ((p, normal), patch) in vertices.zip(&mesh.patch_ids) {
        assert!((normal.length() - 1.0).abs() < 3e-7);
        let outwards = match patch {
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

#[test]
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

#[test]
fn a_moved_vertex_moves_all_patches_that_share_it() {
    let surface = teapot();
    // The first corner of the rim's first patch is the last corner of its fourth patch.
    let vertex = surface.patch_indices(0).unwrap()[0] as usize;
    let mut moved = surface.clone();
    moved.move_point(vertex, DVec3::ONE).unwrap();
    assert_eq!(moved.patch(0).unwrap().eval(0.0, 0.0), DVec3::ONE);
    assert_eq!(moved.patch(3).unwrap().eval(1.0, 0.0), DVec3::ONE);
    assert_eq!(moved.patch(1), surface.patch(1));
    assert!(moved.move_point(290, DVec3::ONE).is_err());
    assert!(moved.move_point(0, DVec3::NAN).is_err());
}
