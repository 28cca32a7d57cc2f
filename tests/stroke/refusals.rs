//! What strokes, dashes, rounded corners and ink refuse.

use crate::support::paths::path;
use crate::support::{all_refused, assert_refused};
use casteljau::glam::DVec2;
use casteljau::path::{
    CornerOptions, InkOptions, InkSample, InkStroke, PathTime, StrokeOptions, WidthProfile,
};

#[test]
fn strokes() {
    let (line, usual) = (path("M0 0H10"), StrokeOptions::default());
    for wrong in [-1.0, f64::NAN, f64::INFINITY] {
        let number = "expected a finite number, at least 0";
        all_refused([
            (
                line.stroke(wrong, &usual).err(),
                &format!("width: {number}"),
            ),
            (
                line.stroke_sides(wrong, 1.0, &usual).err(),
                &format!("left: {number}"),
            ),
            (
                line.stroke_sides(1.0, wrong, &usual).err(),
                &format!("right: {number}"),
            ),
            (line.round_corners(wrong).err(), "radius: expected "),
        ]);
    }
    let stroke = |change: fn(&mut StrokeOptions)| {
        let mut options = StrokeOptions::default();
        change(&mut options);
        line.stroke(1.0, &options).err()
    };
    all_refused([
        (stroke(|o| o.miter_limit = 0.5), "miter_limit: expected "),
        (
            stroke(|o| o.tolerance = Some(0.0)),
            "tolerance: expected a ",
        ),
        (
            stroke(|o| o.tolerance = Some(1e-30)),
            "tolerance: expected at least ",
        ),
        (
            stroke(|o| o.dash = vec![0.0]),
            "sum of the pattern: expected ",
        ),
        (
            stroke(|o| o.dash = vec![1.0, -1.0]),
            "pattern[1]: expected ",
        ),
    ]);
    let varying = |stops: &[(f64, f64)]| line.stroke_with(&WidthProfile::new(stops), &usual).err();
    let position = "stops[1]: expected a position from 0 to 1, greater than the one before, got ";
    let width = "widths[0]: expected a finite number, at least 0, got ";
    all_refused([
        (varying(&[]), "stops: expected at least 1, got 0"),
        (
            varying(&[(0.5, 1.0), (0.2, 1.0)]),
            &format!("{position}0.2"),
        ),
        (
            varying(&[(0.0, 1.0), (f64::NAN, 1.0)]),
            &format!("{position}NaN"),
        ),
        (varying(&[(0.0, -1.0)]), &format!("{width}-1")),
        (varying(&[(0.0, f64::NAN)]), &format!("{width}NaN")),
    ]);
}

#[test]
fn dashes() {
    let dash = |pattern: &[f64], offset| path("M0 0H4").dash(pattern, offset).err();
    all_refused([
        (dash(&[1.0, -1.0], 0.0), "pattern[1]: expected "),
        (dash(&[f64::NAN], 0.0), "pattern[0]: expected "),
        (dash(&[0.0, 0.0], 0.0), "sum of the pattern: expected "),
        (dash(&[1e308, 1e308], 0.0), "sum of the pattern: expected "),
        (dash(&[1.0], f64::INFINITY), "offset: expected "),
        (dash(&[1e-9], 0.0), "dashes: expected at most "),
    ]);
}

#[test]
fn rounded_corners() {
    let square = path("M0 0H10V10H0Z M20 0H30V10");
    let corners = |subpath, t| {
        let options = CornerOptions::new().corners(&[PathTime::new(subpath, t)]);
        square.round_corners_with(2.0, &options).err()
    };
    let rough = CornerOptions::new().tolerance(0.0);
    all_refused([
        (corners(0, 0.5), "corners: expected the t of a joint"),
        (corners(0, -1.0), "corners: expected the t of a joint"),
        (corners(0, 5.0), "corners: expected the t of a joint"),
        (corners(0, f64::NAN), "corners: expected the t of a joint"),
        (corners(2, 0.0), "subpath: expected an index"),
        (
            square.round_corners_with(1.0, &rough).err(),
            "tolerance: expected ",
        ),
    ]);
    for wrong in [-1.0, f64::NAN, f64::INFINITY] {
        let mut calls = 0;
        let radius = |_| {
            calls += 1;
            if calls == 3 { wrong } else { 1.0 }
        };
        let refused = square.round_corners_by(radius, &CornerOptions::new());
        assert_refused(refused, "radius[2]: expected a finite number, at least 0");
    }
}

#[test]
fn ink() {
    let usual = InkOptions::new(1.0);
    let size = "size: expected a number above 0 and at most 2^500, got ";
    for (options, message) in [
        (InkOptions::new(0.0), format!("{size}0")),
        (InkOptions::new(f64::NAN), format!("{size}NaN")),
        (
            usual.thinning(1.5),
            "thinning: expected a number from -1 to 1, got 1.5".to_owned(),
        ),
        (
            usual.taper(0.0, f64::INFINITY),
            "taper: expected a number from 0 to 2^500, got inf".to_owned(),
        ),
        (
            usual.smoothing(-1.0),
            "smoothing: expected a number from 0 to 1, got -1".to_owned(),
        ),
        (
            usual.tolerance(0.0),
            "tolerance: expected a number above 0 and at most 2^500, got 0".to_owned(),
        ),
    ] {
        assert_refused(InkStroke::new(&options).map(|_| ()), &message);
    }
    let mut ink = InkStroke::new(&usual).unwrap();
    let mut append = |x: f64, pressure: Option<f64>, time: Option<f64>| {
        ink.append(DVec2::new(x, 0.0), InkSample { pressure, time })
    };
    assert_eq!(append(1.0, None, None), Ok(()));
    let pressure = "pressure: expected a number from 0 to 1, got 1.5";
    assert_refused(append(f64::NAN, None, None), "position");
    assert_refused(append(2.0, Some(1.5), None), pressure);
    assert_refused(append(2.0, None, Some(f64::NAN)), "time");
    assert_refused(append(1e15, None, None), "tolerance");
    assert_eq!(append(2.0, None, None), Ok(()));
    assert_eq!(ink.spline().unwrap().length(), 1.0);
}
