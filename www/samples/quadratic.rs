use casteljau::{Curve, glam::DVec2};

fn lerp(a: DVec2, b: DVec2, t: f64) -> DVec2 {
    (1.0 - t) * a + t * b
}

pub(crate) fn sample(out: &mut String) {
    let [p0, p1, p2] = [(80.0, 400.0), (240.0, 60.0), (600.0, 320.0)].map(DVec2::from);
    let t = 0.75;

    let p01 = lerp(p0, p1, t);
    let p12 = lerp(p1, p2, t);
    let p = lerp(p01, p12, t);
    writeln!(out, "p01 = ({}, {})", p01.x, p01.y);
    writeln!(out, "p12 = ({}, {})", p12.x, p12.y);
    writeln!(out, "P   = ({}, {})", p.x, p.y);

    let there = Curve::new(&[p0, p1, p2]).unwrap().eval(t);
    writeln!(out, "the curve there: ({}, {})", there.x, there.y);
}
