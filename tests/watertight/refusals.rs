//! Invalid input: rejected with the figures, before anything is allocated; surfaces without area give an empty mesh.

use super::checks::assert_layout;
use super::shapes::{diagonal, largest, meshed, scaled, segments, teapot, tolerance};
use crate::support::allocations::allocated_by;
use crate::support::nets::{as_surface, graph, net, nothing, points, single};
use casteljau::glam::{DMat4, DVec2, DVec3};
use casteljau::mesh::{TessellationOptions, View, Weld};
use casteljau::{Error, Mesh, Surface};

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

#[track_caller]
fn assert_message(error: &Error, start: &str) {
    assert!(error.to_string().starts_with(start), "{error}");
}

fn precise(
    surface: &Surface,
    options: TessellationOptions,
    weld: Weld,
) -> Result<Mesh<f64>, Error> {
    surface.tessellate_f64(&options.weld(weld))
}

#[test]
fn counts_of_segments() {
    for (u, v) in [(0, 1), (1, 0), (0, 0)] {
        let error = refused(&teapot(), segments(u, v));
        assert_message(&error, "segments: expected a whole number from 1, got 0");
    }
    let (million, max) = (1_000_000, usize::MAX);
    for (u, v) in [
        (million, million),
        (million, 1),
        (3, million),
        (max, 1),
        (max, max),
    ] {
        let error = refused(&teapot(), segments(u, v));
        let Error::TooMany { limit, needed, .. } = error else {
            panic!("{error}")
        };
        assert!(limit < 1_000_000 && needed == u.max(v) as u64, "{error}");
        assert!(error.to_string().contains(&format!("at most {limit}, ")));
        assert!(u == max || error.to_string().contains("1000000"), "{error}");
    }
}

#[test]
fn tolerances() {
    for bad in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = refused(&teapot(), tolerance(bad));
        assert_message(&error, "tolerance: expected a finite number above 0");
        assert!(precise(&teapot(), tolerance(bad), Weld::None).is_err());
    }
    let min = largest(&teapot()) * (-21.0_f64).exp2();
    let error = refused(&teapot(), tolerance(min * 0.999));
    assert_message(&error, &format!("tolerance: expected at least {min:?} "));
    // A plane square, so that the mesh stays small.
    let flat = as_surface(&graph(1, 1, &[]));
    let min = (-21.0_f64).exp2();
    assert!(flat.tessellate(&tolerance(min * 0.9)).is_err());
    assert_layout(
        &precise(&flat, tolerance(min * 0.9), Weld::None).unwrap(),
        1,
    );
    let min = 4.0 * f64::EPSILON;
    let error = precise(&flat, tolerance(min * 0.9), Weld::None).unwrap_err();
    assert_message(&error, &format!("tolerance: expected at least {min:?} "));
}

#[test]
fn far_too_fine_is_refused_before_tessellation() {
    let surface = teapot();
    for relative in [1e-9, 1e-12, 1e-15] {
        let options = tolerance(diagonal(&surface) * relative);
        let error = refused_early(|| precise(&surface, options, Weld::None).unwrap_err());
        let Error::TooMany { limit, needed, .. } = error else {
            panic!("{error}")
        };
        assert!(needed > limit);
    }
    // The smallest tolerance for f32 gives slightly too many triangles for a whole teapot.
    let min = largest(&surface) * (-21.0_f64).exp2();
    let error = refused(&surface, tolerance(min));
    assert!(matches!(error, Error::TooMany { .. }), "{error}");
}

/// A curved strip needs subdivision in one direction only: far fewer cells than the square of their number.
#[test]
fn a_cylinder_may_be_fine() {
    let net = points("0 0 0  0.5 0 1  1 0 0  0 1 0  0.5 1 1  1 1 0");
    let strip = single(&net, 2, 1);
    // n segments of a parabola with |second derivative| 4 are off by 4 / (8n²).
    let mesh = precise(&strip, tolerance(1e-11), Weld::None).unwrap();
    let (segments, triangles) = ((0.5 / 1e-11_f64).sqrt(), mesh.triangle_count());
    assert!((triangles as f64) < 4.1 * segments, "{triangles}");
}

#[test]
fn views() {
    let refused = |pixels, viewport: [f64; 2], view_projection| {
        let viewport = DVec2::from(viewport);
        let view = View {
            pixels,
            view_projection,
            viewport,
        };
        refused(&teapot(), TessellationOptions::pixels(view))
    };
    let (good, unit) = ([640.0, 480.0], DMat4::IDENTITY);
    let sizes = [0.0, f64::NAN, -1.0, f64::INFINITY].map(|pixels| (pixels, good));
    let viewports = [[0.0, 480.0], [640.0, f64::NAN]].map(|viewport| (1.0, viewport));
    for (pixels, viewport) in sizes.into_iter().chain(viewports) {
        let error = refused(pixels, viewport, unit);
        assert!(matches!(error, Error::Range { .. }), "{error}");
    }
    let mut matrix = unit;
    matrix.y_axis.z = f64::NAN;
    let error = refused(1.0, good, matrix);
    assert_message(&error, "view_projection[6]: expected a finite number");
}

#[test]
fn nothing_gives_an_empty_mesh() {
    let unused = Surface::new(vec![DVec3::ONE; 7], Vec::new(), 3, 3).unwrap();
    let point = single(&[DVec3::new(0.1, -0.2, 0.3); 16], 3, 3);
    let one_vertex = Surface::new(vec![DVec3::ZERO], vec![0; 32], 3, 3).unwrap();
    let curve = single(&net(3, 3, |i, _| DVec3::X * i), 3, 3);
    let all = [
        (nothing(), 0),
        (unused, 0),
        (point, 1),
        (one_vertex, 2),
        (curve, 1),
    ];
    for (surface, patches) in all {
        for weld in WELDS {
            for options in [segments(3, 2), tolerance(0.01)] {
                let mesh = meshed(&surface, options, weld);
                assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (0, 0));
                assert_layout(&mesh, patches);
                assert_layout(&precise(&surface, options, weld).unwrap(), patches);
            }
        }
        let topology = surface.topology();
        let joined = topology.shared.iter().chain(&topology.non_manifold);
        let joined: usize = joined.map(Vec::len).sum();
        let alone = topology.open.len() + topology.collapsed.len();
        assert_eq!(alone + joined, 4 * patches);
    }
}

#[test]
fn huge_and_tiny_coordinates() {
    let of = |factor: f64, options, weld| precise(&scaled(&teapot(), factor), options, weld);
    let mesh = of(1.0, tolerance(0.05), Weld::Normal).unwrap();
    let expected = mesh.triangle_count();
    for factor in [1e149, 1e140, 1e-150, 1e-290] {
        let options = tolerance(0.05 * factor);
        for weld in WELDS {
            let mesh = of(factor, options, weld).unwrap();
            assert_layout(&mesh, 32);
            let count = mesh.triangle_count();
            let near = count.abs_diff(expected) * 50 <= expected;
            assert!(near, "{factor:e}: {count} for {expected}");
            assert_layout(&of(factor, segments(4, 4), weld).unwrap(), 32);
        }
        let in_f32 = scaled(&teapot(), factor).tessellate(&options.weld(Weld::Normal));
        assert!(in_f32.is_err(), "{factor:e} in f32");
    }
    let error = refused(&scaled(&teapot(), 1e149), segments(4, 4)).to_string();
    assert!(error.contains("f32"), "{error}");
    // Below the range of f32 all positions coincide.
    let mesh = meshed(&scaled(&teapot(), 1e-300), segments(4, 4), Weld::Normal);
    assert_eq!(mesh.triangle_count(), 0);
    // At the limits of the range of f64: a mesh or an error, but without NaN.
    for factor in [1e149, 1e-305, 1e-315, 5e-324] {
        for options in [segments(2, 3), tolerance(0.05 * factor)] {
            if let Ok(mesh) = of(factor, options, Weld::Position) {
                let mut numbers = mesh.positions.iter().chain(&mesh.normals);
                assert!(numbers.all(|x| x.is_finite()), "{factor:e}");
            }
        }
    }
}
