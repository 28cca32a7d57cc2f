use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Grid, Indices, Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    let points = teapot.vertices().len() * 3 * 4; // three numbers of four bytes each
    let indices = 32 * 16 * 2;
    writeln!(out, "patches: {} bytes", points + indices);
    for segments in [4, 16, 32] {
        let cells = TessellationOptions::segments(Grid::from(segments));
        let mesh = teapot.tessellate(&cells.weld(Weld::Position)).unwrap();
        let indices = match &mesh.indices {
            Indices::U16(indices) => size_of_val(&indices[..]),
            Indices::U32(indices) => size_of_val(&indices[..]),
        };
        let bytes = size_of_val(&mesh.positions[..]) + size_of_val(&mesh.normals[..]) + indices;
        writeln!(out, "mesh of {segments} × {segments}: {bytes} bytes");
    }
}
