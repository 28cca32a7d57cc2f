use casteljau::Path;
use casteljau::path::{StrokeCap, StrokeOptions, WidthInterpolation, WidthProfile};
use std::f64::consts::PI;

pub(crate) fn sample(out: &mut String) {
    // A line of length 100. The radius grows from 10 to 40, so the width from 20 to 80.
    let line = Path::from_svg("M0 0H100").unwrap();
    let width = WidthProfile::new(&[(0.0, 20.0), (1.0, 80.0)]);
    let options = StrokeOptions::new().cap(StrokeCap::Round).tolerance(1e-6);
    let outline = line.stroke_with(&width, &options).unwrap();

    // Two discs and the two common tangents: the sides turn from the line by α, where sin α = 30 / 100.
    let angle = 0.3_f64.asin();
    let side = 100.0 * angle.cos();
    let large = 40.0 * 40.0 * (PI + 2.0 * angle);
    let small = 10.0 * 10.0 * (PI - 2.0 * angle);
    let exact = (10.0 + 40.0) * side + (large + small) / 2.0;
    writeln!(out, "area {:.3}, exactly {exact:.3}", outline.area());

    // A leaf: no width at the ends, 8 in between, without corners in the width.
    let curve = Path::from_svg("M8 30C20 0 40 50 52 12").unwrap();
    let width = WidthProfile::new(&[(0.0, 0.0), (0.4, 8.0), (1.0, 0.0)])
        .interpolation(WidthInterpolation::Smooth);
    let leaf = curve.stroke_with(&width, &StrokeOptions::new().tolerance(1e-4));
    writeln!(out, "leaf: area {:.1}", leaf.unwrap().area());
}
