use casteljau::path::{Join, StrokeOptions};
use casteljau::{Curve, Path, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from);
    let curve = Curve::new(&points).unwrap();
    // One cubic becomes several: the smaller the tolerance, the more.
    for tolerance in [0.01, 0.0001, 0.00001] {
        let offset = curve.offset_within(0.3, tolerance).unwrap();
        let (count, length) = (offset.segment_count(), offset.length());
        writeln!(
            out,
            "tolerance {tolerance}, cubics: {count}, length {length:.3}"
        );
    }

    // The outline of a stroke: offsets on both sides, a join, two caps.
    let line = Path::from_svg("M0 0H10V10").unwrap();
    for (name, join) in [
        ("miter", Join::Miter),
        ("round", Join::Round),
        ("bevel", Join::Bevel),
    ] {
        let options = StrokeOptions::new().join(join);
        let outline = line.stroke(2.0, &options).unwrap();
        writeln!(out, "{name}: area {:.3}", outline.area());
    }
}
