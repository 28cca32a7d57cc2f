use casteljau::{Curve, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(60.0, 400.0), (160.0, 40.0), (480.0, 40.0), (600.0, 400.0)];
    let curve = Curve::new(&points.map(DVec2::from)).unwrap();

    // Ten segments, eleven points. i / 10 reaches 1; adding 0.1 ten times does not.
    let mut sum = 0.0;
    for i in 0..=10 {
        let t = f64::from(i) / 10.0;
        let p = curve.eval(t);
        writeln!(out, "t = {t:.1}  ({:.1}, {:.1})", p.x, p.y);
        if i < 10 {
            sum += 0.1;
        }
    }
    writeln!(out, "sum of ten tenths is 1: {}", sum == 1.0);

    // With twice as many segments, the missing length is about a quarter.
    for segments in [4, 8, 16, 32] {
        let points = curve.sample(segments).unwrap();
        let length: f64 = points
            .windows(2)
            .map(|pair| pair[0].distance(pair[1]))
            .sum();
        let missing = curve.length() - length;
        writeln!(out, "{segments} segments: {missing:.3} too short");
    }
}
