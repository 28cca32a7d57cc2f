//! Drawing: degrees 1 to 3 are unchanged, higher degrees become cubics within the tolerance.

use crate::support::measure::from_polyline;
use crate::support::{Rng, all_near, bezier, random_points, refused};
use casteljau::Curve;
use casteljau::curve::PathSink;
use casteljau::glam::DVec2;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[derive(Debug, PartialEq)]
enum Stroke {
    Move(DVec2),
    Line(DVec2),
    Quad(DVec2, DVec2),
    Cubic(DVec2, DVec2, DVec2),
    Close,
}

#[derive(Default)]
struct Notes(Vec<Stroke>);

impl PathSink for Notes {
    fn move_to(&mut self, p: DVec2) {
        self.0.push(Stroke::Move(p));
    }
    fn line_to(&mut self, p: DVec2) {
        self.0.push(Stroke::Line(p));
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.0.push(Stroke::Quad(p1, p));
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.0.push(Stroke::Cubic(p1, p2, p));
    }
    fn close(&mut self) {
        self.0.push(Stroke::Close);
    }
}

fn strokes(curve: &Curve<DVec2>, tolerance: Option<f64>) -> Vec<Stroke> {
    let mut notes = Notes::default();
    match tolerance {
        None => curve.trace(&mut notes),
        Some(tolerance) => curve.trace_within(&mut notes, tolerance).expect("drawn"),
    }
    notes.0
}

#[test]
fn a_sink_may_be_a_trait_object() {
    let mut notes = Notes::default();
    let sink: &mut dyn PathSink = &mut notes;
    bezier("0 0, 1 1").trace(sink);
    assert_eq!(notes.0.len(), 2);
}

#[test]
fn low_degrees_go_out_as_they_are() {
    let [p, q, r, s] = [(0.0, 1.0), (2.0, 3.0), (4.0, 5.0), (6.0, 0.0)].map(DVec2::from);
    for (curve, tolerance, expected) in [
        (Curve::line(p, q), None, Stroke::Line(q)),
        (Curve::quad(p, q, r), None, Stroke::Quad(q, r)),
        (Curve::cubic(p, q, r, s), Some(1.0), Stroke::Cubic(q, r, s)),
    ] {
        assert_eq!(strokes(&curve, tolerance), [Stroke::Move(p), expected]);
    }
}

/// The distance of the drawn cubics from a fine polyline of the curve, and the reverse.
fn distance(curve: &Curve<DVec2>, drawn: &[Stroke]) -> f64 {
    let polyline = |curve: &Curve<DVec2>, n: usize| curve.sample(n).expect("samples");
    let mut from = curve.start();
    let mut cubics = Vec::new();
    for stroke in &drawn[1..] {
        let Stroke::Cubic(p1, p2, p) = *stroke else {
            panic!("{drawn:?}")
        };
        cubics.extend(polyline(&Curve::cubic(from, p1, p2, p), 40));
        from = p;
    }
    assert_eq!(from, curve.end());
    let fine = polyline(curve, 3000);
    let some: Vec<DVec2> = fine.iter().copied().step_by(30).collect();
    let farthest = |points: &[DVec2], line: &[DVec2]| {
        let distances = points.iter().map(|&p| from_polyline(p, line));
        distances.fold(0.0, f64::max)
    };
    farthest(&cubics, &fine).max(farthest(&some, &cubics))
}

#[test]
fn high_degrees_become_cubics_within_the_tolerance() {
    let mut rng = Rng(21);
    for degree in [4, 5, 6, 9] {
        let curve = Curve::new(&random_points::<DVec2>(&mut rng, degree + 1)).expect("finite");
        let default = 1e-4 * curve.control_bounds().diagonal();
        for tolerance in [Some(1.0), Some(1e-2), Some(1e-4), None] {
            // The two fine polylines have small errors of their own.
            let max = tolerance.unwrap_or(default) + 2e-5;
            let found = distance(&curve, &strokes(&curve, tolerance));
            assert!(found <= max, "degree {degree}: {found} instead of {max}");
        }
    }
}

/// At degree 64 the error of a cubic is large until the halves are short.
#[test]
fn the_finest_tolerance_is_kept_at_degree_64() {
    let points: Vec<DVec2> = (0..=64)
        .map(|i| {
            let y = if i % 2 == 0 || i == 1 { 1.0 } else { -1.0 };
            DVec2::new(f64::from(i) / 64.0, y)
        })
        .collect();
    let curve = Curve::new(&points).expect("finite");
    let drawn = strokes(&curve, Some(1e-12));
    let mut from = curve.start();
    for (k, stroke) in drawn[1..].iter().enumerate() {
        let Stroke::Cubic(p1, p2, p) = *stroke else {
            panic!("{stroke:?}")
        };
        if k % 50 == 0 {
            let middle = Curve::cubic(from, p1, p2, p).eval(0.5);
            let distance = curve.nearest(middle).expect("finite").distance;
            assert!(distance < 1e-12, "cubic {k} of {}: {distance}", drawn.len());
        }
        from = p;
    }
}

#[test]
fn an_elevated_cubic_is_drawn_as_that_cubic() {
    let cubic = bezier("0 0, 4 8, 8 8, 12 4");
    let raised = cubic.elevate().and_then(|c| c.elevate()).expect("degree 5");
    let drawn = strokes(&raised, Some(1e-9));
    let [Stroke::Move(start), Stroke::Cubic(p1, p2, end)] = drawn[..] else {
        panic!("{drawn:?}")
    };
    all_near(&[start, p1, p2, end], cubic.control_points(), 16e-13);
}

#[test]
fn tolerances_are_checked_before_the_first_stroke() {
    let curve = bezier("0 0, 1 1, 2 0, 3 1, 4 0");
    for (bad, expected) in [
        (0.0, "Range tolerance"),
        (-1.0, "Range tolerance"),
        (f64::NAN, "Range tolerance"),
        (1e-18, "Tolerance"),
    ] {
        let mut notes = Notes::default();
        refused(curve.trace_within(&mut notes, bad), expected);
        assert_eq!(notes.0, []);
    }
}
