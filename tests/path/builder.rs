//! Paths that are built command by command and read back as commands.

use crate::support::assert_refused;
use crate::support::paths::{path, points};
use casteljau::curve::PathSink;
use casteljau::glam::DVec2;
use casteljau::path::PathElement;
use casteljau::{Curve, Error, Path, Spline};

fn xy(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// The trait and the methods of the builder have the same effect.
fn draw(sink: &mut impl PathSink) {
    sink.move_to(xy(0.0, 0.0));
    sink.line_to(xy(1.0, 0.5));
    sink.quad_to(xy(2.0, 3.0), xy(4.0, 4.0));
    sink.cubic_to(xy(5.0, 4.0), xy(6.0, 3.0), xy(6.0, 2.0));
    sink.close();
}

#[test]
fn commands_build_what_path_data_says() {
    let read = path("M0,0 L1,0.5 Q2,3 4,4 C5,4 6,3 6,2 Z L9,8 M1,1 M2,2 A3,1 30 1 0 4,4");
    let mut builder = Path::builder();
    builder
        .move_to(xy(0.0, 0.0))
        .line_to(xy(1.0, 0.5))
        .quad_to(xy(2.0, 3.0), xy(4.0, 4.0))
        .cubic_to(xy(5.0, 4.0), xy(6.0, 3.0), xy(6.0, 2.0))
        .close();
    assert_eq!(builder.current_point(), DVec2::ZERO);
    let rotation = 30_f64.to_radians();
    builder
        .line_to(xy(9.0, 8.0))
        .move_to(xy(1.0, 1.0))
        .move_to(xy(2.0, 2.0))
        .arc_to(xy(3.0, 1.0), rotation, true, false, xy(4.0, 4.0));
    let built = builder.build().expect("finite points");
    assert_eq!(built.subpath_count(), 3);
    assert!(built.approx_eq(&read, 1e-14), "{built}");
    assert_eq!(builder.build(), Ok(Path::default()));
    draw(&mut builder);
    let drawn = builder.build().expect("finite");
    assert_eq!(drawn.subpath(0), read.subpath(0));
    read.trace(&mut builder);
    assert_eq!(builder.build(), Ok(read));
}

#[test]
fn elements_are_the_commands() {
    let read = path("M0,0 L1,0.5 Q2,3 4,4 C5,4 6,3 6,2 Z M1,1 L2,2");
    let elements: Vec<_> = read.elements().collect();
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
    assert_eq!(Path::from_elements(elements), Ok(read.clone()));
    let segments: Vec<_> = read.segments().collect();
    assert_eq!(segments.len(), read.segment_count());
    assert_eq!(segments[4], Curve::line(xy(1.0, 1.0), xy(2.0, 2.0)));
}

#[test]
fn high_degrees_become_cubics_within_the_tolerance() {
    let curve = Curve::new(&points("0 0  1 9  2 -9  3 9  4 0  9 1")).expect("a curve");
    let built = Path::builder()
        .curve_to(&curve.control_points()[1..])
        .build();
    let path = built.expect("finite points");
    assert_eq!(path.subpath(0), Some(Spline::from(curve)));
    let count = |tolerance| {
        let elements = path.elements_within(tolerance).expect("a tolerance");
        let cubic = |e: &PathElement| matches!(e, PathElement::CubicTo(..));
        elements.filter(cubic).count()
    };
    assert!(count(1e-6) > count(1e-2) && count(1e-2) > 1);
}

#[test]
fn the_first_wrong_argument_is_reported() {
    let mut builder = Path::builder();
    let lines = builder
        .move_to(xy(1.0, 1.0))
        .line_to(xy(2.0, f64::NEG_INFINITY))
        .line_to(xy(f64::NAN, 1.0))
        .line_to(xy(2.0, 2.0))
        .build();
    let text = "command 1: points[0]: expected a finite number, got -inf";
    assert_eq!(
        lines.map_err(|error| error.to_string()),
        Err(text.to_owned())
    );
    let nothing = builder.curve_to(&[]).build().map_err(Error::from);
    assert!(matches!(nothing, Err(Error::Count { got: 0, .. })));
    let arc = builder
        .arc_to(DVec2::ONE, f64::NAN, true, true, DVec2::X)
        .build()
        .map_err(Error::from);
    assert_refused(arc, "x_rotation[0]: expected a finite number");
}

#[test]
fn without_extent_there_is_a_line_or_nothing() {
    let mut builder = Path::builder();
    let start = builder.move_to(xy(1.0, 1.0)).build();
    assert_eq!(start, Ok(Path::default()));
    let closed = builder.close().close().build();
    assert_eq!(closed, Ok(path("M0 0Z")));
    let arcs = builder
        .arc_to(DVec2::ZERO, 0.0, false, false, xy(2.0, 0.0))
        .arc_to(DVec2::ONE, 0.0, false, false, xy(2.0, 0.0))
        .build();
    assert_eq!(arcs, Ok(path("M0 0L2 0")));
}
