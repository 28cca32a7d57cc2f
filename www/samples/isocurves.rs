use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    let curve = teapot.patch(16).unwrap().isocurve_at_u(0.5); // along the spout
    writeln!(
        out,
        "degree {}, length {:.4}",
        curve.degree(),
        curve.length()
    );
    let lines = teapot.isocurves(4).unwrap();
    writeln!(out, "{} curves divide the teapot into strips", lines.len());
}
