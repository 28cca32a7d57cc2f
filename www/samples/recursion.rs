use casteljau::{Curve, glam::DVec2};

/// Draws by halving: `line` receives the pieces that are straight enough.
fn draw(curve: &Curve<DVec2>, tolerance: f64, line: &mut impl FnMut(&Curve<DVec2>)) {
    let d1: f64 = curve
        .control_points()
        .windows(2)
        .map(|leg| leg[0].distance(leg[1]))
        .sum();
    let d2 = curve.start().distance(curve.end());
    if d1 - d2 < tolerance {
        return line(curve);
    }
    let (q, r) = curve.halve();
    draw(&q, tolerance, line);
    draw(&r, tolerance, line);
}

pub(crate) fn sample(out: &mut String) {
    let points = [(60.0, 400.0), (60.0, 20.0), (620.0, 20.0), (600.0, 400.0)];
    let curve = Curve::new(&points.map(DVec2::from)).unwrap();

    // D1 − D2 is not a distance. How far is the curve from the lines?
    for tolerance in [64.0, 8.0, 1.0, 0.125] {
        let mut pieces = 0;
        let mut error = 0_f64;
        draw(&curve, tolerance, &mut |piece| {
            pieces += 1;
            let chord = Curve::new(&[piece.start(), piece.end()]).unwrap();
            error = error.max(piece.hausdorff(&chord));
        });
        let needed = curve.flatten(error).unwrap().ts.len() - 1;
        writeln!(out, "tolerance {tolerance}: {pieces} pieces");
        writeln!(out, "  error {error:.3}; flatten() needs {needed}");
    }
}
