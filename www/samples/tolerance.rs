use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    for tolerance in [0.1, 0.01, 0.001] {
        let mesh = teapot
            .tessellate(&TessellationOptions::tolerance(tolerance).weld(Weld::Normal))
            .unwrap();
        writeln!(
            out,
            "within {tolerance}: {} triangles",
            mesh.triangle_count()
        );
    }
}
