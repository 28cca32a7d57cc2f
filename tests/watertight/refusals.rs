//! Invalid input: rejected with the figures, before anything is allocated; surfaces without area give an empty mesh.

use super::checks::assert_layout;
use super::shapes::{diagonal, largest, segments, teapot};
use crate::support::allocations::allocated_by;
use casteljau::glam::{DAffine3, DMat3, DMat4, DVec2, DVec3};
use casteljau::mesh::{TessellationOptions, View, Weld};
use casteljau::{Error, Patch, Surface};

/// An error must be returned before the mesh is made; the meshes that are rejected here would take a gigabyte or more.
const MAX_BYTES: usize = 1 << 20;

const WELDS: [Weld; 3] = [Weld::Position, Weld::Normal, Weld::None];

#[track_caller]
fn refused(surface: &Surface, options: TessellationOptions) -> Error {
    refused_early(|| surface.tessellate(&options.weld(Weld::Normal)).unwrap_err())
}

#[track_caller]
fn refused_early(call: impl FnOnce() -> Error) -> Error {
    let (error, bytes) = allocated_by(call);
    assert!(bytes <= MAX_BYTES, "{error}: {bytes} bytes before it");
    error
}

fn scaled(factor: f64) -> Surface {
    teapot()
        .transform(&DAffine3::from_mat3(DMat3::from_diagonal(DVec3::splat(
            factor,
        ))))
        .expect("a finite image")
}

#[test]
fn counts_of_segments() {
    for (u, v) in [(0, 1), (1, 0), (0, 0)] {
        let error = refused(&teapot(), segments(u, v));
        assert!(
            matches!(
                error,
                Error::Range {
                    what: "segments",
                    got: 0.0,
                    ..
                }
            ),
            "{error}"
        );
    }
    for (u, v) in [
        (1_000_000, 1_000_000),
        (1_000_000, 1),
        (3, 1_000_000),
        (usize::MAX, 1),
        (usize::MAX, usize::MAX),
    ] {
        let error = refused(&teapot(), segments(u, v));
        let Error::TooMany { limit, needed, .. } = error else {
            panic!("{error}")
        };
        assert!(limit < 1_000_000 && needed == u.max(v) as u64, "{error}");
        let message = error.to_string();
        assert!(message.contains(&limit.to_string()), "{message}");
    }
    let message = refused(&teapot(), segments(1_000_000, 1_000_000)).to_string();
    assert!(message.contains("1000000"), "{message}");
}

#[test]
fn tolerances() {
    for tolerance in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = refused(&teapot(), TessellationOptions::tolerance(tolerance));
        assert!(
            matches!(
                error,
                Error::Range {
                    what: "tolerance",
                    ..
                }
            ),
            "{error}"
        );
        assert!(
            teapot()
                .tessellate_f64(&TessellationOptions::tolerance(tolerance).weld(Weld::None))
                .is_err()
        );
    }
    let min = largest(&teapot()) * (-21.0_f64).exp2();
    let error = refused(&teapot(), TessellationOptions::tolerance(min * 0.999));
    assert!(
        matches!(error, Error::Tolerance { min: named, .. } if named == min),
        "{error}"
    );
    assert!(error.to_string().contains(&format!("{min:?}")));
    // A smaller part of the same viewport, so that the mesh stays small.
    let flat = Patch::new(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE], 1, 1).unwrap();
    let min = (-21.0_f64).exp2();
    assert!(
        flat.tessellate(&TessellationOptions::tolerance(min * 0.9).weld(Weld::None))
            .is_err()
    );
    let fine = flat
        .tessellate_f64(&TessellationOptions::tolerance(min * 0.9).weld(Weld::None))
        .unwrap();
    assert_layout(&fine, 1);
    let min = 4.0 * f64::EPSILON;
    let error = flat
        .tessellate_f64(&TessellationOptions::tolerance(min * 0.9).weld(Weld::None))
        .unwrap_err();
    assert!(
        matches!(error, Error::Tolerance { min: named, .. } if named == min),
        "{error}"
    );
}

#[test]
fn far_too_fine_is_refused_before_tessellation() {
    let surface = teapot();
    for relative in [1e-9, 1e-12, 1e-15] {
        let options = TessellationOptions::tolerance(diagonal(&surface) * relative);
        let error = refused_early(|| {
            surface
                .tessellate_f64(&options.weld(Weld::None))
                .unwrap_err()
        });
        let Error::TooMany { limit, needed, .. } = error else {
            panic!("{error}")
        };
        assert!(needed > limit);
    }
    // The smallest tolerance for f32 gives slightly too many triangles for a whole teapot.
    let min = largest(&surface) * (-21.0_f64).exp2();
    let error = refused(&surface, TessellationOptions::tolerance(min));
    assert!(matches!(error, Error::TooMany { .. }), "{error}");
}

/// A curved strip needs subdivision in one direction only: far fewer cells than the square of their number.
#[test]
fn a_cylinder_may_be_fine() {
    let arch = [DVec3::ZERO, DVec3::new(0.5, 0.0, 1.0), DVec3::X];
    let net: Vec<DVec3> = arch.into_iter().chain(arch.map(|p| p + DVec3::Y)).collect();
    let strip = Patch::new(&net, 2, 1).unwrap();
    // n segments of a parabola with |second derivative| 4 are off by 4 / (8n²).
    let mesh = strip
        .tessellate_f64(&TessellationOptions::tolerance(1e-11).weld(Weld::None))
        .unwrap();
    let segments = (0.5 / 1e-11_f64).sqrt();
    assert!(
        (mesh.triangle_count() as f64) < 4.1 * segments,
        "{}",
        mesh.triangle_count()
    );
}

#[test]
fn views() {
    let good = View {
        pixels: 1.0,
        view_projection: DMat4::IDENTITY,
        viewport: DVec2::new(640.0, 480.0),
    };
    let bad = [
        View {
            pixels: 0.0,
            ..good
        },
        View {
            pixels: f64::NAN,
            ..good
        },
        View {
            pixels: -1.0,
            ..good
        },
        View {
            pixels: f64::INFINITY,
            ..good
        },
        View {
            viewport: DVec2::new(0.0, 480.0),
            ..good
        },
        View {
            viewport: DVec2::new(640.0, f64::NAN),
            ..good
        },
    ];
    for view in bad {
        let error = refused(&teapot(), TessellationOptions::pixels(view));
        assert!(matches!(error, Error::Range { .. }), "{error}");
    }
    let mut matrix = DMat4::IDENTITY;
    matrix.y_axis.z = f64::NAN;
    let error = refused(
        &teapot(),
        TessellationOptions::pixels(View {
            view_projection: matrix,
            ..good
        }),
    );
    assert!(
        matches!(error, Error::NotFinite { index: 6, .. }),
        "{error}"
    );
}

#[test]
fn nothing_gives_an_empty_mesh() {
    let empty = Surface::new(Vec::new(), Vec::new(), 3, 3).unwrap();
    let unused = Surface::new(vec![DVec3::ONE; 7], Vec::new(), 3, 3).unwrap();
    let point = Surface::new(
        vec![DVec3::new(0.1, -0.2, 0.3); 16],
        (0..16).collect(),
        3,
        3,
    )
    .unwrap();
    let one_vertex = Surface::new(vec![DVec3::ZERO], vec![0; 32], 3, 3).unwrap();
    let line: Vec<DVec3> = (0..16).map(|k| DVec3::X * f64::from(k % 4)).collect();
    let curve = Surface::new(line, (0..16).collect(), 3, 3).unwrap();
    for (surface, patches) in [
        (empty, 0),
        (unused, 0),
        (point, 1),
        (one_vertex, 2),
        (curve, 1),
    ] {
        for weld in WELDS {
            for options in [segments(3, 2), TessellationOptions::tolerance(0.01)] {
                let mesh = surface.tessellate(&options.weld(weld)).unwrap();
                assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (0, 0));
                assert_layout(&mesh, patches);
                assert_layout(
                    &surface.tessellate_f64(&options.weld(weld)).unwrap(),
                    patches,
                );
            }
        }
        let topology = surface.topology();
        let sides = [&topology.open, &topology.collapsed]
            .map(Vec::len)
            .iter()
            .sum::<usize>();
        let joined: usize = [&topology.shared, &topology.non_manifold]
            .into_iter()
            .flatten()
            .map(Vec::len)
            .sum();
        assert_eq!(sides + joined, 4 * patches);
    }
}

#[test]
fn huge_and_tiny_coordinates() {
    let expected = teapot()
        .tessellate_f64(&TessellationOptions::tolerance(0.05).weld(Weld::Normal))
        .unwrap()
        .triangle_count();
    for factor in [1e149, 1e140, 1e-150, 1e-290] {
        let surface = scaled(factor);
        for weld in WELDS {
            let mesh = surface
                .tessellate_f64(&TessellationOptions::tolerance(0.05 * factor).weld(weld))
                .unwrap();
            assert_layout(&mesh, 32);
            let count = mesh.triangle_count();
            assert!(
                count.abs_diff(expected) * 50 <= expected,
                "{factor:e}: {count} for {expected}"
            );
            assert_layout(
                &surface.tessellate_f64(&segments(4, 4).weld(weld)).unwrap(),
                32,
            );
        }
        let error =
            surface.tessellate(&TessellationOptions::tolerance(0.05 * factor).weld(Weld::Normal));
        assert!(error.is_err(), "{factor:e} in f32");
    }
    let error = refused(&scaled(1e149), segments(4, 4)).to_string();
    assert!(error.contains("f32"), "{error}");
    // Below the range of f32 all positions coincide.
    let mesh = scaled(1e-300)
        .tessellate(&segments(4, 4).weld(Weld::Normal))
        .unwrap();
    assert_eq!(mesh.triangle_count(), 0);
    // At the limits of the range of f64: a mesh or an error, but without NaN.
    for factor in [1e149, 1e-305, 1e-315, 5e-324] {
        for options in [
            segments(2, 3),
            TessellationOptions::tolerance(0.05 * factor),
        ] {
            if let Ok(mesh) = scaled(factor).tessellate_f64(&options.weld(Weld::Position)) {
                assert!(
                    mesh.positions
                        .iter()
                        .chain(&mesh.normals)
                        .all(|x| x.is_finite()),
                    "{factor:e}"
                );
            }
        }
    }
}
