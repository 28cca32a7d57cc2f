//! Points, polylines, bounding boxes, and drawing of splines.

use crate::spline::{control, each_spline, random};
use crate::support::measure::{Reference, farthest};
use crate::support::{Rng, exact, near_at, real, refused, spline, xy};
use casteljau::Spline;
use casteljau::curve::PathSink;
use casteljau::glam::{DVec2, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn t_counts_the_segments() {
    each_spline(4, |spline, degrees| {
        let points = spline.control_points();
        for k in 0..degrees.len() {
            let segment = control(points, degrees, k);
            assert_eq!(spline.eval(real(k)), segment[0]);
            for rest in [0.25, 0.5, 0.875] {
                let (got, max) = (spline.eval(real(k) + rest), 1e-14 * real(degrees[k] + 1));
                near_at(got, exact::eval(&segment, rest), max, (degrees, k, rest));
            }
        }
        // Outside, the first and the last segment are continued; coordinates grow by (|t| + |1 − t|)ⁿ.
        let n = degrees.len();
        for (k, rest) in [(0, -0.5), (n - 1, 1.5)] {
            let segment = control(points, degrees, k);
            let growth = (0..degrees[k]).fold(1.0, |growth, _| 2.0 * growth);
            let (got, max) = (
                spline.eval(real(k) + rest),
                1e-14 * real(degrees[k] + 1) * growth,
            );
            near_at(got, exact::eval(&segment, rest), max, (degrees, k, rest));
        }
        let last = control(points, degrees, degrees.len() - 1);
        assert_eq!(spline.eval(real(degrees.len())), last[last.len() - 1]);
        let ts = [0.0, 0.3, 0.99];
        assert_eq!(spline.eval_at(&ts), ts.map(|t| spline.eval(t)));
    });
}

#[test]
fn polylines_keep_the_tolerance_and_have_a_vertex_at_each_joint() {
    let mut rng = Rng(6);
    for degrees in [&[3, 3, 3][..], &[2, 2], &[1, 2, 3, 4, 5]] {
        for tolerance in [0.3, 1e-2, 1e-4] {
            let spline = random::<DVec3>(&mut rng, degrees, true);
            let line = spline.flatten(tolerance).expect("flat");
            assert_eq!(line.ts.len(), line.points.len());
            assert!(line.ts.windows(2).all(|t| t[0] < t[1]));
            let at = |t: usize| line.ts.iter().position(|&s| s == real(t));
            for k in 0..degrees.len() {
                let (from, to) = (at(k).expect("a joint"), at(k + 1).expect("a joint"));
                let ts: Vec<f64> = line.ts[from..=to].iter().map(|t| t - real(k)).collect();
                let reference = Reference::new(&control(spline.control_points(), degrees, k));
                let vertices = reference.locations(&line.points[from..=to]);
                let max = reference.length(tolerance) * (1.0 + 1e-9);
                let off = farthest(&reference, &ts, &vertices, max);
                assert!(off <= max, "{degrees:?}, {tolerance}: {off}");
            }
        }
    }
    let line = spline("0 0, 1 1, 2 0", 1, false);
    assert_eq!(line.flatten(0.1).expect("flat").ts, [0.0, 1.0, 2.0]);
}

#[test]
fn boxes_are_those_of_all_segments() {
    let arcs = spline("0 0, 1 1, 2 0, 3 -1, 4 0", 2, false);
    let (exact, control) = (arcs.bounds(), arcs.control_bounds());
    assert_eq!([exact.min, exact.max].to_vec(), xy("0 -0.5, 4 0.5"));
    assert_eq!([control.min, control.max].to_vec(), xy("0 -1, 4 1"));
    // If the spline is closed, the last segment counts too.
    let closed = spline("0 0, 2 0, 2 2, -4 4", 2, true).bounds();
    assert!((closed.min.x + 4.0 / 3.0).abs() < 1.0 && closed.min.x < -1.0);
}

/// Notes a letter for each call, and the point at which the pen is after it.
#[derive(Default)]
struct Notes(String, Vec<DVec2>);

impl Notes {
    fn add(&mut self, letter: char, p: DVec2) {
        self.0.push(letter);
        self.1.push(p);
    }
}

impl PathSink for Notes {
    fn move_to(&mut self, p: DVec2) {
        self.add('M', p);
    }
    fn line_to(&mut self, p: DVec2) {
        self.add('L', p);
    }
    fn quad_to(&mut self, _: DVec2, p: DVec2) {
        self.add('Q', p);
    }
    fn cubic_to(&mut self, _: DVec2, _: DVec2, p: DVec2) {
        self.add('C', p);
    }
    fn close(&mut self) {
        self.0.push('Z');
    }
}

#[test]
fn drawing_moves_once_and_closes_closed_splines() {
    let points = xy("0 0, 1 1, 2 4, 3 9, 4 16, 5 25");
    for (degrees, closed, letters, ends) in [
        ([1, 2, 2], false, "MLQQ", "0 0, 1 1, 3 9, 5 25"),
        ([1, 2, 3], true, "MLQCZ", "0 0, 1 1, 3 9, 0 0"),
    ] {
        let spline = Spline::with_degrees(points.clone(), &degrees, closed).expect("a spline");
        let mut notes = Notes::default();
        spline.trace_within(&mut notes, 0.1).expect("drawn");
        assert_eq!((notes.0.as_str(), notes.1), (letters, xy(ends)));
        let mut nothing = Notes::default();
        refused(spline.trace_within(&mut nothing, -1.0), "Range tolerance");
        assert_eq!(nothing.0, "");
    }
}
