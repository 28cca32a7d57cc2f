use casteljau::{Curve, curve::bernstein, glam::DVec2};

fn show(curve: &Curve<DVec2>) -> String {
    let pairs: Vec<String> = curve
        .control_points()
        .iter()
        .map(|p| format!("({:.2}, {:.2})", p.x, p.y))
        .collect();
    pairs.join(" ")
}

pub(crate) fn sample(out: &mut String) {
    // The same curve with more and more points.
    let mut curve = Curve::new(&[(0.0, 0.0), (3.0, 6.0), (6.0, 0.0)].map(DVec2::from)).unwrap();
    for _ in 2..=5 {
        writeln!(out, "degree {}: {}", curve.degree(), show(&curve));
        curve = curve.elevate().unwrap();
    }

    // Reducing the degree. If a curve needs its degree, there is an error.
    let lower = curve.reduce();
    let (from, to) = (curve.degree(), lower.curve.degree());
    let exact = lower.error < 1e-12;
    writeln!(out, "{from} to {to}: error below 1e-12: {exact}");
    let cubic = [(0.0, 0.0), (0.0, 3.0), (6.0, 3.0), (6.0, 6.0)].map(DVec2::from);
    let error = Curve::new(&cubic).unwrap().reduce().error;
    writeln!(out, "a real cubic: error {error:.3}");

    // One of eleven points moves by 100. How far does the curve move?
    let moves =
        [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| format!("{:.1}", 100.0 * bernstein(10, t).unwrap()[5]));
    writeln!(out, "degree 10, P5 moved by 100: {}", moves.join(" "));
}
