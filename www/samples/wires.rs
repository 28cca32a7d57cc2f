use casteljau::mesh::{Wire, WireframeOptions};
use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    let tube = Wire::Tube {
        radius: 0.02,
        sides: 6,
    };
    let tubes = teapot
        .wireframe(&WireframeOptions::new().wire(tube))
        .unwrap();
    let ribbon = Wire::Ribbon { width: 0.05 };
    let ribbons = teapot
        .wireframe(&WireframeOptions::new().wire(ribbon))
        .unwrap();
    writeln!(out, "tubes: {} triangles", tubes.triangle_count());
    writeln!(out, "ribbons: {} triangles", ribbons.triangle_count());
}
