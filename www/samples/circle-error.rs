use casteljau::Curve;
use casteljau::glam::DVec2;

pub(crate) fn sample(out: &mut String) {
    let handle = 4.0 / 3.0 * (std::f64::consts::SQRT_2 - 1.0); // the usual cubic for a quarter of a circle
    let quarter = Curve::new(&[
        DVec2::new(1.0, 0.0),
        DVec2::new(1.0, handle),
        DVec2::new(handle, 1.0),
        DVec2::new(0.0, 1.0),
    ])
    .unwrap();
    let error = (0..=1000)
        .map(|k| (quarter.eval(f64::from(k) / 1000.0).length() - 1.0).abs())
        .fold(0.0, f64::max);
    writeln!(out, "largest error of the radius: {error:.6}");
}
