use casteljau::{Curve, curve::bernstein, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(60.0, 400.0), (160.0, 40.0), (480.0, 40.0), (600.0, 400.0)].map(DVec2::from);
    let t = 0.25;

    let weights = bernstein(3, t).unwrap();
    let list: Vec<String> = weights.iter().map(f64::to_string).collect();
    writeln!(out, "weights: {}", list.join(", "));
    writeln!(out, "their sum: {}", weights.iter().sum::<f64>());

    // The weighted mean of the control points
    let mean: DVec2 = weights.iter().zip(points).map(|(w, p)| *w * p).sum();
    writeln!(out, "mean:  ({:.4}, {:.4})", mean.x, mean.y);

    // is the point of the curve.
    let p = Curve::new(&points).unwrap().eval(t);
    writeln!(out, "curve: ({:.4}, {:.4})", p.x, p.y);

    // At t = 1/2 the weights are the binomial coefficients, divided by 2 to the power of the degree.
    for degree in 1..=5_usize {
        let power = 2_f64.powf(degree as f64);
        let row: Vec<String> = bernstein(degree, 0.5)
            .unwrap()
            .iter()
            .map(|weight| (weight * power).to_string())
            .collect();
        writeln!(out, "degree {degree}: {}", row.join(" "));
    }
}
