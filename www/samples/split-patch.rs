use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let patch = Surface::teapot(&TeapotOptions::default()).patch(4).unwrap();
    let (left, right) = patch.split_u(0.25);
    for (name, p) in [
        ("patch at (0.125, 0.5)", patch.eval(0.125, 0.5)),
        ("left part at (0.5, 0.5)", left.eval(0.5, 0.5)),
    ] {
        writeln!(out, "{name}: {:.6} {:.6} {:.6}", p.x, p.y, p.z);
    }
    let same = left.isocurve_at_u(1.0) == right.isocurve_at_u(0.0);
    writeln!(out, "the common side is the same: {same}");
}
