//! Drawing: degrees 1 to 3 are unchanged, higher degrees become cubics within the tolerance.

use crate::support::measure::from_segment;
use crate::support::{Rng, plane, real};
use casteljau::curve::PathSink;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Error};
use wasm_bindgen_test::wasm_bindgen_test;

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
    curve.trace(&mut notes, tolerance).expect("drawn");
    notes.0
}

#[wasm_bindgen_test(unsupported = test)]
fn low_degrees_go_out_as_they_are() {
    let [a, b, c, d] = [(0.0, 1.0), (2.0, 3.0), (4.0, 5.0), (6.0, 0.0)];
    let at = |(x, y): (f64, f64)| DVec2::new(x, y);
    let [p, q, r, s] = [a, b, c, d].map(at);
    assert_eq!(
        strokes(&plane(&[a, b]), None),
        [Stroke::Move(p), Stroke::Line(q)]
    );
    assert_eq!(
        strokes(&plane(&[a, b, c]), None),
        [Stroke::Move(p), Stroke::Quad(q, r)]
    );
    assert_eq!(
        strokes(&plane(&[a, b, c, d]), Some(1.0)),
        [Stroke::Move(p), Stroke::Cubic(q, r, s)]
    );
}

/// The distance of the drawn cubics from a fine polyline of the curve, and the reverse.
fn distance(curve: &Curve<DVec2>, drawn: &[Stroke]) -> f64 {
    let polyline = |curve: &Curve<DVec2>, n: usize| -> Vec<DVec3> {
        curve
            .sample(n)
            .expect("samples")
            .iter()
            .map(|p| p.extend(0.0))
            .collect()
    };
    let mut from = curve.start();
    let mut cubics = Vec::new();
    for stroke in &drawn[1..] {
        let Stroke::Cubic(p1, p2, p) = *stroke else {
            panic!("{stroke:?}")
        };
        cubics.extend(polyline(
            &Curve::new(&[from, p1, p2, p]).expect("finite"),
            40,
        ));
        from = p;
    }
    assert_eq!(from, curve.end());
    let fine = polyline(curve, 3000);
    let farthest = |a: &[DVec3], b: &[DVec3]| {
        let nearest = |p: &DVec3| {
            b.windows(2)
                .map(|w| from_segment(*p, w[0], w[1]))
                .fold(f64::MAX, f64::min)
        };
        a.iter().map(nearest).fold(0.0, f64::max)
    };
    let some: Vec<DVec3> = fine.iter().copied().step_by(30).collect();
    farthest(&cubics, &fine).max(farthest(&some, &cubics))
}

#[wasm_bindgen_test(unsupported = test)]
fn high_degrees_become_cubics_within_the_tolerance() {
    let mut rng = Rng(21);
    for degree in [4, 5, 6, 9] {
        let points: Vec<(f64, f64)> = (0..=degree).map(|_| (rng.signed(), rng.signed())).collect();
        let curve = plane(&points);
        for tolerance in [1.0, 1e-2, 1e-4] {
            let drawn = strokes(&curve, Some(tolerance));
            // The two fine polylines have small errors of their own.
            let found = distance(&curve, &drawn);
            assert!(
                found <= tolerance + 2e-5,
                "degree {degree}: {found} instead of {tolerance}"
            );
        }
        let default = strokes(&curve, None);
        assert!(distance(&curve, &default) <= 1e-4 * curve.control_bounds().diagonal() + 2e-5);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_elevated_cubic_is_drawn_as_that_cubic() {
    let cubic = plane(&[(0.0, 0.0), (4.0, 8.0), (8.0, 8.0), (12.0, 4.0)]);
    let raised = cubic.elevate().and_then(|c| c.elevate()).expect("degree 5");
    let drawn = strokes(&raised, Some(1e-9));
    let [Stroke::Move(start), Stroke::Cubic(p1, p2, end)] = drawn[..] else {
        panic!("{drawn:?}")
    };
    let expected = cubic.control_points();
    for (got, &p) in [start, p1, p2, end].into_iter().zip(expected) {
        assert!(
            (got - p).length() < 1e-13 * real(16),
            "{got} instead of {p}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn tolerances_are_checked_before_the_first_stroke() {
    let curve = plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (3.0, 1.0), (4.0, 0.0)]);
    for bad in [0.0, -1.0, f64::NAN, 1e-18] {
        let mut notes = Notes::default();
        let refused = curve.trace(&mut notes, Some(bad));
        assert!(
            matches!(refused, Err(Error::Range { .. } | Error::Tolerance { .. })),
            "{bad}"
        );
        assert_eq!(notes.0, []);
    }
}
