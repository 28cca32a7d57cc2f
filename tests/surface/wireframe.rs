//! Isocurves of surfaces, and their projected drawing.

use crate::support::measure::from_polyline;
use crate::support::measure::from_segment;
use crate::support::nets::{RandomNet, assert_near, single, teapot};
use crate::support::{Rng, assert_refused};
use casteljau::curve::PathSink;
use casteljau::glam::{DMat4, DVec2, DVec3, dvec4};
use casteljau::{Curve, Point, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// A recorded drawing: a list of strokes, each a list of joined curves.
#[derive(Default)]
struct Record(Vec<Vec<Curve<DVec2>>>, DVec2);

impl Record {
    fn add(&mut self, points: &[DVec2]) {
        self.1 = points[points.len() - 1];
        let curve = Curve::new(points).unwrap();
        self.0.last_mut().unwrap().push(curve);
    }
}

impl PathSink for Record {
    fn move_to(&mut self, p: DVec2) {
        self.0.push(Vec::new());
        self.1 = p;
    }
    fn line_to(&mut self, p: DVec2) {
        self.add(&[self.1, p]);
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.add(&[self.1, p1, p]);
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.add(&[self.1, p1, p2, p]);
    }
    fn close(&mut self) {
        unreachable!("isocurves are open");
    }
}

fn draw(surface: &Surface, matrix: &DMat4, lines: usize, tolerance: f64) -> Record {
    let mut record = Record::default();
    let drawn = surface.trace_projected(&mut record, matrix, lines, Some(tolerance));
    drawn.unwrap();
    record
}

fn project(matrix: &DMat4, p: DVec3) -> DVec2 {
    let q = *matrix * p.extend(1.0);
    DVec2::new(q.x / q.w, q.y / q.w)
}

/// A projection to a canvas of 800 × 800 from an eye at (0, −`distance`, 1.5) that looks along +y.
fn perspective(distance: f64) -> DMat4 {
    let zoom = 900.0;
    // X = 400·w + zoom·x, Y = 400·w − zoom·(z − 1.5), w = y + distance.
    DMat4::from_cols(
        dvec4(zoom, 0.0, 0.0, 0.0),
        dvec4(400.0, 400.0, 0.0, 1.0),
        dvec4(0.0, -zoom, 0.0, 0.0),
        dvec4(400.0, 400.0, 0.0, 1.0) * distance + dvec4(0.0, 1.5 * zoom, 0.0, 0.0),
    )
}

#[test]
fn each_line_once() {
    // 32 patches with lines + 1 curves in each direction, minus 52 shared edges and 8 collapsed ones.
    for lines in [1, 2, 5] {
        let curves = teapot().isocurves(lines).unwrap();
        assert_eq!(curves.len(), 32 * 2 * (lines + 1) - 52 - 8);
        for (k, curve) in curves.iter().enumerate() {
            let backwards = curve.reverse();
            let same = |other: &Curve<DVec3>| other == curve || *other == backwards;
            assert!(!curves[k + 1..].iter().any(same));
        }
    }
}

#[test]
fn lines_are_isocurves_of_the_patch() {
    let net = Rng(1).net(2, 4);
    let surface = single(&net, 2, 4);
    let patch = surface.patch(0).unwrap();
    let curves = surface.isocurves(4).unwrap();
    assert_eq!(curves.len(), 10);
    for (k, curve) in curves.iter().enumerate() {
        for t in [0.0, 0.3, 1.0] {
            let fixed = (k % 5) as f64 / 4.0;
            let (u, v) = if k < 5 { (fixed, t) } else { (t, fixed) };
            assert_near(curve.eval(t), patch.eval(u, v), 1e-14);
        }
    }
}

#[test]
fn affine_maps_draw_the_mapped_control_points() {
    let matrix = DMat4::from_cols(
        dvec4(30.0, 7.0, 1.0, 0.0),
        dvec4(-5.0, 40.0, 2.0, 0.0),
        dvec4(9.0, -11.0, 3.0, 0.0),
        dvec4(400.0, 300.0, 0.0, 2.0),
    );
    let curves = teapot().isocurves(3).unwrap();
    let drawn = draw(&teapot(), &matrix, 3, 0.1);
    assert_eq!(drawn.0.len(), curves.len());
    for (stroke, curve) in drawn.0.iter().zip(&curves) {
        let points = curve.control_points().iter();
        let expected: Vec<DVec2> = points.map(|&p| project(&matrix, p)).collect();
        assert_eq!(stroke.len(), 1);
        for (&a, &b) in stroke[0].control_points().iter().zip(&expected) {
            assert!((a - b).length() <= 1e-12, "{a} {b}");
        }
    }
}

#[test]
fn perspective_keeps_the_tolerance() {
    let mut random = Rng(2);
    let mut surfaces = vec![teapot()];
    for (m, n) in [(1, 1), (2, 3), (5, 6)] {
        let net: Vec<DVec3> = random.net(m, n).iter().map(|&p| 2.0 * p).collect();
        surfaces.push(single(&net, m, n));
    }
    for surface in &surfaces {
        let curves = surface.isocurves(2).unwrap();
        for (distance, tolerance) in [(12.0, 0.1), (12.0, 1e-3), (3.6, 1.0), (3.6, 0.01)] {
            let matrix = perspective(distance);
            let drawn = draw(surface, &matrix, 2, tolerance);
            assert_eq!(drawn.0.len(), curves.len());
            for (stroke, curve) in drawn.0.iter().zip(&curves) {
                check_stroke(stroke, curve, &matrix, tolerance);
            }
        }
    }
}

/// Asserts that every drawn point is near the true projection, measured with a dense polyline, and the reverse.
fn check_stroke(stroke: &[Curve<DVec2>], curve: &Curve<DVec3>, matrix: &DMat4, tolerance: f64) {
    const DENSE: usize = 2000;
    let at = |k: usize| project(matrix, curve.eval(k as f64 / DENSE as f64));
    let reference: Vec<DVec2> = (0..=DENSE).map(at).collect();
    let per_piece = (DENSE / stroke.len()).max(8);
    let drawn = samples(stroke, per_piece);
    // An estimate of the distance of a polyline of samples from its curve: a quarter of the error of omitting every
    // other sample.
    let sag = |line: &[DVec2]| {
        let off = |p: &[DVec2]| from_segment(p[1], p[0], p[2]);
        line.windows(3).map(off).fold(0.0, f64::max)
    };
    let slack = 1e-9 + 0.5 * sag(&reference).max(sag(&drawn));
    assert!(slack < 0.5 * tolerance, "too few samples: {slack}");
    for (line, other) in [(&reference, &drawn), (&drawn, &reference)] {
        for &p in line.iter().step_by(97) {
            let distance = from_polyline(p, other);
            assert!(distance <= tolerance + slack, "{distance} > {tolerance}");
        }
    }
    assert!((reference[0] - drawn[0]).length() < 1e-9);
    assert!((reference[DENSE] - drawn[drawn.len() - 1]).length() < 1e-9);
}

fn samples<P: Point>(curves: &[Curve<P>], count: usize) -> Vec<P> {
    let samples = curves.iter().map(|curve| curve.sample(count).unwrap());
    samples.flatten().collect()
}

#[test]
fn what_lies_behind_the_eye_is_left_out() {
    // The eye is inside the teapot, on its axis.
    let matrix = perspective(0.0);
    let far = teapot().vertices().iter().map(|p| p.y).fold(0.0, f64::max);
    let drawn = draw(&teapot(), &matrix, 4, 0.1);
    assert!(!drawn.0.is_empty());
    let mut before = samples(&teapot().isocurves(4).unwrap(), 400);
    before.retain(|p| p.y > 0.05 * far);
    let lines: Vec<Vec<DVec2>> = drawn.0.iter().map(|stroke| samples(stroke, 32)).collect();
    for p in before.iter().step_by(331).map(|&p| project(&matrix, p)) {
        let distances = lines.iter().map(|line| from_polyline(p, line));
        let distance = distances.fold(f64::INFINITY, f64::min);
        assert!(distance < 2.0, "{p} is {distance} px from all lines");
    }
    // From behind, nothing is drawn.
    assert!(draw(&teapot(), &perspective(-10.0), 4, 0.1).0.is_empty());
}

#[test]
fn extreme_surfaces_draw_numbers_or_nothing() {
    for size in [1e-300, 1e149] {
        let net: Vec<DVec3> = Rng(3).net(3, 3).iter().map(|&p| p * size).collect();
        let surface = single(&net, 3, 3);
        for matrix in [DMat4::IDENTITY, perspective(5.0), DMat4::ZERO] {
            for stroke in draw(&surface, &matrix, 2, 0.1).0 {
                for piece in stroke {
                    assert!(piece.control_points().iter().all(|p| p.is_finite()));
                }
            }
        }
    }
    let point = single(&[DVec3::ONE; 16], 3, 3);
    assert!(draw(&point, &DMat4::IDENTITY, 2, 0.1).0.len() <= 6);
}

#[test]
fn refusals() {
    let lines = "lines: expected a whole number from 1, got 0";
    assert_refused(teapot().isocurves(0), lines);
    assert_refused(teapot().isocurves(usize::MAX), "lines: expected at most ");
    let (mut pen, mut matrix) = (Record::default(), DMat4::IDENTITY);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let drawn = teapot().trace_projected(&mut pen, &matrix, 4, Some(tolerance));
        assert_refused(drawn, "tolerance: expected ");
    }
    matrix.z_axis.y = f64::NAN;
    let drawn = teapot().trace_projected(&mut pen, &matrix, 4, None);
    assert_refused(drawn, "matrix[9]: expected a finite number, got NaN");
    assert!(pen.0.is_empty());
}
