//! Paths that are built command by command and read back as commands.

use casteljau::curve::PathSink;
use casteljau::glam::DVec2;
use casteljau::path::{PathBuilder, PathElement};
use casteljau::{Curve, Error, Path, Spline};

const TEXT: &str = "M0,0 L1,0.5 Q2,3 4,4 C5,4 6,3 6,2 Z L9,8 M1,1 M2,2 A3,1 30 1 0 4,4";

fn path(text: &str) -> Path {
    text.parse().expect("path data")
}

fn xy(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

#[test]
fn commands_build_what_path_data_says() {
    let mut builder = PathBuilder::new();
    builder.move_to(xy(0.0, 0.0));
    builder.line_to(xy(1.0, 0.5));
    builder.quad_to(xy(2.0, 3.0), xy(4.0, 4.0));
    builder.cubic_to(xy(5.0, 4.0), xy(6.0, 3.0), xy(6.0, 2.0));
    builder.close();
    assert_eq!(builder.current_point(), DVec2::ZERO);
    builder.line_to(xy(9.0, 8.0));
    builder.move_to(xy(1.0, 1.0));
    builder.move_to(xy(2.0, 2.0));
    let rotation = 30_f64.to_radians();
    builder.arc_to(xy(3.0, 1.0), rotation, true, false, xy(4.0, 4.0));
    let built = builder.build().expect("finite points");
    let read = path(TEXT);
    assert_eq!(built.subpath_count(), 3);
    assert!(built.approx_eq(&read, 1e-14), "{built}");
}

#[test]
fn elements_are_the_commands() {
    let read = path("M0,0 L1,0.5 Q2,3 4,4 C5,4 6,3 6,2 Z M1,1 L2,2");
    let elements: Vec<_> = read.elements(None).expect("no tolerance").collect();
    let expected = [
        PathElement::MoveTo(xy(0.0, 0.0)),
        PathElement::LineTo(xy(1.0, 0.5)),
        PathElement::QuadTo(xy(2.0, 3.0), xy(4.0, 4.0)),
        PathElement::CubicTo(xy(5.0, 4.0), xy(6.0, 3.0), xy(6.0, 2.0)),
        PathElement::LineTo(xy(0.0, 0.0)),
        PathElement::Close,
        PathElement::MoveTo(xy(1.0, 1.0)),
        PathElement::LineTo(xy(2.0, 2.0)),
    ];
    assert_eq!(elements, expected);
    let segments: Vec<_> = read.segments().collect();
    assert_eq!(segments.len(), read.segment_count());
    assert_eq!(segments[4], Curve::line(xy(1.0, 1.0), xy(2.0, 2.0)));
}

#[test]
fn a_builder_takes_what_a_path_sends() {
    let read = path(TEXT);
    let mut builder = PathBuilder::new();
    read.trace(&mut builder, None).expect("no tolerance");
    assert_eq!(builder.build(), Ok(read));
}

#[test]
fn high_degrees_become_cubics_within_the_tolerance() {
    let points = [
        (0.0, 0.0),
        (1.0, 9.0),
        (2.0, -9.0),
        (3.0, 9.0),
        (4.0, 0.0),
        (9.0, 1.0),
    ];
    let curve = Curve::new(&points.map(DVec2::from)).expect("a curve");
    let mut builder = PathBuilder::new();
    builder.curve_to(&curve.control_points()[1..]);
    let built = builder.build().expect("finite points");
    assert_eq!(built.subpath(0), Some(Spline::from(curve)));
    let count = |tolerance| {
        let elements = built.elements(Some(tolerance)).expect("a tolerance");
        let cubic = |e: &PathElement| matches!(e, PathElement::CubicTo(..));
        elements.filter(cubic).count()
    };
    assert!(count(1e-6) > count(1e-2) && count(1e-2) > 1);
    assert!(matches!(
        built.elements(Some(-1.0)).err(),
        Some(Error::Range { .. })
    ));
}

#[test]
fn the_first_wrong_argument_is_reported() {
    let mut builder = PathBuilder::new();
    builder.move_to(xy(1.0, 1.0));
    builder.line_to(xy(2.0, f64::NEG_INFINITY));
    builder.line_to(xy(f64::NAN, 1.0));
    builder.line_to(xy(2.0, 2.0));
    let error = builder.build().expect_err("an infinity");
    assert_eq!(
        error.to_string(),
        "points[0]: expected a finite number, got -inf"
    );
    let mut builder = PathBuilder::new();
    builder.curve_to(&[]);
    assert!(matches!(builder.build(), Err(Error::Count { got: 0, .. })));
    let mut builder = PathBuilder::new();
    builder.arc_to(xy(1.0, 1.0), f64::NAN, true, true, xy(2.0, 2.0));
    assert!(matches!(
        builder.build(),
        Err(Error::NotFinite {
            what: "x_rotation",
            ..
        })
    ));
}

#[test]
fn without_segments_the_path_is_empty() {
    let mut builder = PathBuilder::new();
    builder.move_to(xy(1.0, 1.0));
    assert_eq!(builder.build(), Ok(Path::default()));
    let mut builder = PathBuilder::default();
    builder.close();
    builder.close();
    assert_eq!(builder.build(), Ok(path("M0 0Z")));
}

#[test]
fn an_arc_without_an_extent_is_a_line_or_nothing() {
    let mut builder = PathBuilder::new();
    builder.arc_to(DVec2::ZERO, 0.0, false, false, xy(2.0, 0.0));
    builder.arc_to(DVec2::ONE, 0.0, false, false, xy(2.0, 0.0));
    assert_eq!(builder.build(), Ok(path("M0 0L2 0")));
}

/// The trait and the methods of the builder have the same effect.
#[test]
fn a_builder_is_a_sink() {
    fn draw(sink: &mut impl PathSink) {
        sink.move_to(xy(0.0, 0.0));
        sink.line_to(xy(1.0, 0.0));
        sink.quad_to(xy(2.0, 0.0), xy(2.0, 1.0));
        sink.cubic_to(xy(2.0, 2.0), xy(1.0, 2.0), xy(0.0, 1.0));
        sink.close();
    }
    let mut builder = PathBuilder::new();
    draw(&mut builder);
    assert_eq!(builder.build(), Ok(path("M0 0L1 0Q2 0 2 1C2 2 1 2 0 1Z")));
}
