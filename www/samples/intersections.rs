use casteljau::{Curve, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from);
    let arch = Curve::new(&points).unwrap();
    let line = Curve::line(DVec2::new(-0.5, 0.5), DVec2::new(2.5, 1.2));
    for x in arch.intersections(&line) {
        let place = format!("({:.3}, {:.3})", x.point.x, x.point.y);
        let kind = format!("{:?}", x.kind).to_lowercase();
        writeln!(out, "t = {:.4}, u = {:.4}: {place}, {kind}", x.t, x.u);
    }

    // Two cubics can meet in nine points: x = T(y) and y = T(x).
    let wave = [-1.0, 5.0, -5.0, 1.0];
    let even = [-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0];
    let cubic = |x: [f64; 4], y: [f64; 4]| {
        let points: Vec<DVec2> = x.iter().zip(y).map(|(&x, y)| DVec2::new(x, y)).collect();
        Curve::new(&points).unwrap()
    };
    let (across, along) = (cubic(wave, even), cubic(even, wave));
    writeln!(out, "{} intersections", across.intersections(&along).len());
}
