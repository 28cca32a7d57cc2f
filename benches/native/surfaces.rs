//! Meshes of surfaces with weights beside those of surfaces without: the same nets, time for each triangle.

use casteljau::glam::DVec3;
use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Mesh, NurbsSurface, RationalSurface, Surface};
use criterion::{Criterion, Throughput};
use std::hint::black_box;

pub(crate) fn bench(criterion: &mut Criterion) {
    let (center, axis) = (DVec3::new(0.3, -0.2, 0.5), DVec3::new(1.0, 2.0, 3.0));
    let shapes = [
        ("sphere", NurbsSurface::sphere(center, 1.0, axis)),
        ("torus", NurbsSurface::torus(center, 2.0, 0.5, axis)),
    ];
    for (name, shape) in shapes {
        let rational = shape.and_then(|shape| shape.to_surface()).expect("valid");
        let polynomial = without_weights(&rational);
        let kinds = [
            ("segments", TessellationOptions::segments(32)),
            ("tolerance", TessellationOptions::tolerance(1e-3)),
        ];
        for (kind, options) in kinds {
            let options = options.weld(Weld::Position);
            let mut group = criterion.benchmark_group(format!("{name}-by-{kind}"));
            let mut row = |name: &str, mesh: &dyn Fn() -> Mesh| {
                let triangles = mesh().triangle_count();
                check_closed(&mesh());
                group.throughput(Throughput::Elements(triangles as u64));
                group.bench_function(name, |b| b.iter(|| black_box(mesh())));
            };
            row("polynomial", &|| {
                polynomial.tessellate(&options).expect("few")
            });
            row("rational", &|| rational.tessellate(&options).expect("few"));
            group.finish();
        }
    }
}

/// The polynomial surface of the same nets.
fn without_weights(surface: &RationalSurface) -> Surface {
    let degrees: Vec<[usize; 2]> = (0..surface.patch_count())
        .filter_map(|patch| surface.degrees(patch))
        .collect();
    let (vertices, indices) = (surface.vertices().to_vec(), surface.indices().to_vec());
    Surface::with_degrees(vertices, indices, &degrees).expect("valid")
}

/// The Euler characteristic of a closed mesh, with three edges for two triangles, is 2 for a sphere and 0 for a torus.
fn check_closed(mesh: &Mesh) {
    let (vertices, triangles) = (2 * mesh.vertex_count(), mesh.triangle_count());
    assert!(vertices == triangles + 4 || vertices == triangles);
}
