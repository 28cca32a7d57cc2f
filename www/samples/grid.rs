use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Grid, Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    for segments in [4, 8, 16] {
        let grid = teapot.grid(Grid::from(segments), false).unwrap();
        let cells = TessellationOptions::segments(Grid::from(segments));
        let mesh = teapot.tessellate(&cells.weld(Weld::Position)).unwrap();
        writeln!(
            out,
            "{segments}: {} vertices, welded {}, {} triangles",
            grid.vertex_count(),
            mesh.vertex_count(),
            mesh.triangle_count()
        );
    }
}
