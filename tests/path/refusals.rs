//! What shapes, positions, maps and arcs refuse. Path data: svg.rs; commands of builders: builder.rs.

use crate::support::all_refused;
use crate::support::paths::path;
use casteljau::Path;
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::PathTime;

#[test]
fn shapes() {
    all_refused([
        (
            Path::circle(DVec2::ZERO, -1.0).err(),
            "radii: expected numbers from 0, got -1",
        ),
        (
            Path::circle(DVec2::NAN, 1.0).err(),
            "center[0]: expected a finite number",
        ),
        (
            Path::circle(DVec2::ZERO, 1e200).err(),
            "radii[0]: expected ",
        ),
        (
            Path::rect(DVec2::ZERO, DVec2::new(1.0, -2.0)).err(),
            "size: expected numbers from 0, got -2",
        ),
        (
            Path::arc(DVec2::ZERO, 1.0, 0.0, 7.0).err(),
            "end_angle: expected at most a full turn (2π) from start_angle, got 7",
        ),
    ]);
    let second = Path::builder()
        .circle(DVec2::ZERO, 1.0)
        .rect(DVec2::ZERO, DVec2::NEG_ONE)
        .build();
    assert_eq!(second.map_err(|error| error.command), Err(1));
}

#[test]
fn positions() {
    let (one, none) = (path("M0 0H4"), Path::default());
    let missing = PathTime::new(1, 0.0);
    let expected = "subpath: expected an index from 0 to 0, got 1";
    all_refused([
        (one.eval(missing).err(), expected),
        (one.subsegment(missing..).err(), expected),
        (one.split_at(&[missing]).err(), expected),
        (
            none.tangent(PathTime::new(0, 0.0)).err(),
            "Count subpaths 0",
        ),
    ]);
    assert_eq!(none.subsegment(..), Ok(Path::default()));
}

#[test]
fn maps_beyond_the_limit() {
    let path = path("M1 2C3 4 5 6 7 8L9 9");
    let cubic = path.segments().next().expect("a cubic");
    let curve = cubic.elevate().expect("degree 4");
    let spline = path.subpath(0).expect("a spline");
    for scale in [1e151, 1e308, f64::INFINITY, f64::NAN] {
        let map = DAffine2::from_scale(DVec2::splat(scale));
        all_refused([
            (path.transform(&map).err(), "image[0]: expected "),
            (curve.transform(&map).err(), "image[0]: expected "),
            (spline.transform(&map).err(), "image[0]: expected "),
        ]);
    }
}

#[test]
fn tolerances() {
    let wave = path("M0 0C30 40 60 -40 90 20");
    for tolerance in [0.0, -1.0, 1e-16, f64::NAN, f64::INFINITY] {
        all_refused([(wave.to_arcs(tolerance).err(), "tolerance: expected ")]);
    }
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let elements = wave.elements_within(tolerance).map(Iterator::count);
        all_refused([(elements.err(), "tolerance: expected a finite number")]);
    }
}
