use casteljau::{Curve, curve::Basis, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [
        (120.0, 360.0),
        (200.0, 120.0),
        (470.0, 120.0),
        (550.0, 360.0),
    ]
    .map(DVec2::from);

    // The same four points in three bases. Where does each curve start and end?
    for (name, basis) in [
        ("bezier", Basis::Bezier),
        ("b-spline", Basis::BSpline),
        ("catmull-rom", Basis::CatmullRom),
    ] {
        let curve = Curve::from_basis(basis, points).unwrap();
        let (a, b) = (curve.start(), curve.end());
        writeln!(out, "{name}: {a:.1} to {b:.1}");
    }

    // The Hermite form has two ends and the velocities there: three times the legs.
    let bezier = Curve::new(&points).unwrap();
    let ends_and_speeds = [
        (120.0, 360.0),
        (550.0, 360.0),
        (240.0, -720.0),
        (240.0, 720.0),
    ]
    .map(DVec2::from);
    let hermite = Curve::from_basis(Basis::Hermite, ends_and_speeds).unwrap();
    writeln!(out, "the same curve: {}", hermite.approx_eq(&bezier, 1e-9));

    // Any other matrix: this one gives the line from the first point to the last.
    #[rustfmt::skip]
    let matrix = [
        0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0,
        -1.0, 0.0, 0.0, 1.0,
        1.0, 0.0, 0.0, 0.0,
    ];
    let middle = Curve::from_basis(Basis::Matrix(matrix), points)
        .unwrap()
        .eval(0.5);
    writeln!(out, "middle of the line: {middle:.1}");
}
