use casteljau::{Curve, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (0.0, 100.0), (200.0, 100.0), (200.0, 0.0)];
    let curve = Curve::new(&points.map(DVec2::from)).unwrap();
    let (left, _) = curve.split(0.5);
    let length = curve.length();
    let half_way = curve.time_at_length(length / 2.0);
    let highest = curve.bounds().max.y;
    writeln!(out, "half way: t = {half_way}");
    writeln!(out, "highest: y = {highest}");
    let numbers = left.control_points().iter().flat_map(|p| [p.x, p.y]);
    let words: Vec<String> = numbers.map(|x| x.to_string()).collect();
    writeln!(out, "first half: {}", words.join(" "));
}
