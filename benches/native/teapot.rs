//! The grid of the teapot, written to a reused mesh.

use casteljau::{Grid, Mesh, Surface, TeapotOptions};
use criterion::Criterion;
use std::hint::black_box;

/// Tolerance of the comparison: positions are f32, and the teapot is 3.15 units high.
const TOLERANCE: f64 = 1e-6;

pub(crate) fn bench(criterion: &mut Criterion) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    for segments in [16, 64] {
        let grid = Grid::from(segments);
        let mut mesh = teapot.grid(grid, false).expect("a small grid");
        check(&teapot, grid, &mesh);
        let mut group = criterion.benchmark_group(format!("teapot-{segments}"));
        group.bench_function("casteljau", |b| {
            b.iter(|| {
                teapot
                    .grid_into(grid, false, &mut mesh)
                    .expect("a small grid");
                black_box(&mesh);
            });
        });
        group.finish();
    }
}

/// Checks that every position equals the point of the patch at its (u, v).
fn check(teapot: &Surface, grid: Grid, mesh: &Mesh) {
    let mut positions = mesh.positions.chunks_exact(3);
    for patch in teapot.patches() {
        for iv in 0..=grid.segments_v {
            for iu in 0..=grid.segments_u {
                let (u, v) = grid.uv(iu, iv);
                let theirs = patch.eval(u, v).to_array();
                let ours = positions.next().expect("a position for each vertex");
                let apart = |(a, &b): (f64, &f32)| (a - f64::from(b)).abs();
                let worst = theirs.into_iter().zip(ours).map(apart).fold(0.0, f64::max);
                assert!(worst <= TOLERANCE, "({u}, {v}): {worst}");
            }
        }
    }
    assert!(positions.next().is_none());
}
