use casteljau::{Curve, glam::DVec2};

/// De Casteljau's algorithm for any degree: interpolate on every leg until one point is left.
fn casteljau(points: &[DVec2], t: f64) -> DVec2 {
    if let [only] = points {
        return *only;
    }
    let next: Vec<DVec2> = points
        .windows(2)
        .map(|leg| (1.0 - t) * leg[0] + t * leg[1])
        .collect();
    casteljau(&next, t)
}

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (0.0, 8.0), (8.0, 8.0), (8.0, 0.0)].map(DVec2::from);
    let p = casteljau(&points, 0.25);
    writeln!(out, "by hand: ({}, {})", p.x, p.y);

    // The library returns the points of all rounds: four, three, two, one.
    for level in Curve::new(&points).unwrap().de_casteljau(0.25) {
        let pairs: Vec<String> = level
            .iter()
            .map(|p| format!("({}, {})", p.x, p.y))
            .collect();
        writeln!(out, "{}", pairs.join(" "));
    }
}
