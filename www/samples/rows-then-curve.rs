use casteljau::{Curve, Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let patch = Surface::teapot(&TeapotOptions::default()).patch(4).unwrap();
    let (u, v) = (0.25, 0.75);
    let rows = patch.control_points().chunks(4);
    let amid: Vec<_> = rows // one point on each row
        .map(|row| Curve::new(row).unwrap().eval(u))
        .collect();
    let point = Curve::new(&amid).unwrap().eval(v); // and they control one more curve
    let p = patch.eval(u, v);
    writeln!(out, "{:.6} {:.6} {:.6}", point.x, point.y, point.z);
    writeln!(out, "{:.6} {:.6} {:.6}", p.x, p.y, p.z);
}
