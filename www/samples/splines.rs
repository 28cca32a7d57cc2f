use casteljau::{Spline, glam::DVec2, spline::Interpolation};

pub(crate) fn sample(out: &mut String) {
    let points = [
        (60.0, 380.0),
        (170.0, 110.0),
        (300.0, 330.0),
        (420.0, 90.0),
        (610.0, 300.0),
    ]
    .map(DVec2::from);
    let catmull_rom = Interpolation::CatmullRom { alpha: 0.5 };
    let kinds = [
        (
            "natural",
            Spline::interpolate(&points, Interpolation::Natural, false).unwrap(),
        ),
        (
            "Catmull-Rom",
            Spline::interpolate(&points, catmull_rom, false).unwrap(),
        ),
        (
            "B-spline",
            Spline::from_bspline(&points, 3, None, false).unwrap(),
        ),
    ];

    // How smooth is the first joint, and how far is the spline from P1?
    for (name, spline) in &kinds {
        let joint = spline.continuity(1).unwrap();
        let smooth = if joint.c2 {
            "C2"
        } else if joint.c1 {
            "C1"
        } else {
            "G1"
        };
        let off = spline.nearest(points[1]).unwrap().distance;
        writeln!(out, "{name}: {smooth}, {off:.1} from P1");
    }

    // Move the first point by 50. How far does the other end move?
    let mut shifted = points;
    shifted[0].y -= 50.0;
    for (name, kind) in [
        ("natural", Interpolation::Natural),
        ("catmull-rom", catmull_rom),
    ] {
        let before = Spline::interpolate(&points, kind, false).unwrap().eval(3.5);
        let after = Spline::interpolate(&shifted, kind, false)
            .unwrap()
            .eval(3.5);
        let moved = before.distance(after);
        writeln!(out, "{name}: the other end moves by {moved:.3}");
    }
}
