//! Points, samples, polylines, bounding boxes, and drawing of splines.

use crate::spline::{STRUCTURES, control, plane, random};
use crate::support::measure::{Reference, farthest};
use crate::support::{Rng, exact, real};
use casteljau::Error;
use casteljau::curve::PathSink;
use casteljau::glam::{DAffine3, DMat3, DVec2, DVec3};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn t_counts_the_segments() {
    let mut rng = Rng(4);
    for degrees in STRUCTURES {
        for closed in [false, true] {
            let spline = random(&mut rng, degrees, closed);
            let points = spline.control_points();
            for k in 0..degrees.len() {
                let segment = control(points, degrees, k);
                assert_eq!(spline.eval(real(k)), segment[0]);
                for rest in [0.25, 0.5, 0.875] {
                    let off = (spline.eval(real(k) + rest) - exact::eval(&segment, rest)).length();
                    assert!(
                        off < 1e-14 * real(degrees[k] + 1),
                        "{degrees:?} at {k} + {rest}"
                    );
                }
            }
            let end = control(points, degrees, degrees.len() - 1)[degrees[degrees.len() - 1]];
            assert_eq!(spline.eval(real(degrees.len())), end);
            assert!(!closed || end == points[0]);
            let ts = [0.0, 0.3, 0.99];
            assert_eq!(spline.eval_at(&ts), ts.map(|t| spline.eval(t)));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn values_outside_extrapolate_the_first_and_the_last_segment() {
    let spline = plane(&[(0.0, 0.0), (1.0, 2.0), (3.0, 3.0)], 1, false);
    assert_eq!(spline.eval(-1.0), DVec2::new(-1.0, -2.0));
    assert_eq!(spline.eval(4.0), DVec2::new(7.0, 5.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn samples_take_even_steps_on_each_segment() {
    let mut rng = Rng(5);
    for degrees in STRUCTURES {
        let spline = random(&mut rng, degrees, true);
        for steps in [1, 3, 10] {
            let samples = spline.sample(steps).expect("samples");
            assert_eq!(samples.len(), steps * degrees.len() + 1);
            for (i, &p) in samples.iter().enumerate() {
                let off = (p - spline.eval(real(i) / real(steps))).length();
                assert!(
                    off < 1e-14 * 66.0,
                    "{degrees:?}: sample {i} of {steps} is {off} off"
                );
            }
        }
    }
    let line = plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)], 1, false);
    assert!(matches!(
        line.sample(0),
        Err(Error::Range {
            what: "segments",
            ..
        })
    ));
    assert!(matches!(
        line.sample(1 << 25),
        Err(Error::TooMany {
            what: "segments",
            ..
        })
    ));
    assert!(matches!(
        line.sample(usize::MAX),
        Err(Error::TooMany {
            what: "segments",
            ..
        })
    ));
}

#[wasm_bindgen_test(unsupported = test)]
fn polylines_keep_the_tolerance_and_have_a_vertex_at_each_joint() {
    let mut rng = Rng(6);
    for degrees in [&[3, 3, 3][..], &[2, 2], &[1, 2, 3, 4, 5]] {
        for tolerance in [0.3, 1e-2, 1e-4] {
            let spline = random(&mut rng, degrees, true);
            let line = spline.flatten(tolerance).expect("flat");
            assert_eq!(line.ts.len(), line.points.len());
            assert!(line.ts.windows(2).all(|t| t[0] < t[1]));
            for k in 0..degrees.len() {
                let at = |t: usize| {
                    line.ts
                        .iter()
                        .position(|&s| s == real(t))
                        .expect("a vertex at each joint")
                };
                let (from, to) = (at(k), at(k + 1));
                let ts: Vec<f64> = line.ts[from..=to].iter().map(|t| t - real(k)).collect();
                let reference = Reference::new(&control(spline.control_points(), degrees, k));
                let vertices: Vec<DVec3> = line.points[from..=to]
                    .iter()
                    .map(|&p| reference.location(p))
                    .collect();
                let max = reference.length(tolerance) * (1.0 + 1e-9);
                assert!(
                    farthest(&reference, &ts, &vertices, max) <= max,
                    "{degrees:?}, {tolerance}"
                );
            }
        }
    }
    let line = plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)], 1, false);
    assert_eq!(line.flatten(0.1).expect("flat").ts, [0.0, 1.0, 2.0]);
    assert!(matches!(
        line.flatten(0.0),
        Err(Error::Range {
            what: "tolerance",
            ..
        })
    ));
    assert!(matches!(line.flatten(1e-16), Err(Error::Tolerance { .. })));
}

#[wasm_bindgen_test(unsupported = test)]
fn boxes_are_those_of_all_segments() {
    let spline = plane(
        &[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (3.0, -1.0), (4.0, 0.0)],
        2,
        false,
    );
    let (exact, control) = (spline.bounds(), spline.control_bounds());
    assert_eq!(
        (exact.min, exact.max),
        (DVec2::new(0.0, -0.5), DVec2::new(4.0, 0.5))
    );
    assert_eq!(
        (control.min, control.max),
        (DVec2::new(0.0, -1.0), DVec2::new(4.0, 1.0))
    );
    // If the spline is closed, the last segment counts too.
    let closed = plane(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (-4.0, 4.0)], 2, true).bounds();
    assert!((closed.min.x + 4.0 / 3.0 * 1.0).abs() < 1.0 && closed.min.x < -1.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn reversed_and_mapped_splines() {
    let mut rng = Rng(7);
    for degrees in STRUCTURES {
        for closed in [false, true] {
            let spline = random(&mut rng, degrees, closed);
            let back = spline.reverse();
            assert_eq!(
                back.degrees(),
                degrees.iter().rev().copied().collect::<Vec<usize>>()
            );
            assert_eq!(back.reverse(), spline);
            let map = DAffine3::from_mat3_translation(
                DMat3::from_diagonal(DVec3::new(2.0, -4.0, 0.5)),
                DVec3::ONE,
            );
            let mapped = spline.transform(&map).expect("a finite image");
            assert_eq!(mapped.degrees(), degrees);
            for i in 0..=8 * degrees.len() {
                let t = real(i) / 8.0;
                let off = (back.eval(real(degrees.len()) - t) - spline.eval(t)).length();
                assert!(off < 1e-14 * 66.0, "{degrees:?} at {t}: {off}");
                assert!(
                    (mapped.eval(t) - map.transform_point3(spline.eval(t))).length() < 1e-13 * 66.0
                );
            }
        }
    }
}

/// Counts what is drawn: moves, segments by degree, closings.
#[derive(Default, Debug, PartialEq)]
struct Counts([usize; 5], Vec<DVec2>);

impl PathSink for Counts {
    fn move_to(&mut self, p: DVec2) {
        self.0[0] += 1;
        self.1.push(p);
    }
    fn line_to(&mut self, p: DVec2) {
        self.0[1] += 1;
        self.1.push(p);
    }
    fn quad_to(&mut self, _: DVec2, p: DVec2) {
        self.0[2] += 1;
        self.1.push(p);
    }
    fn cubic_to(&mut self, _: DVec2, _: DVec2, p: DVec2) {
        self.0[3] += 1;
        self.1.push(p);
    }
    fn close(&mut self) {
        self.0[4] += 1;
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn drawing_moves_once_and_closes_closed_splines() {
    let points: Vec<DVec2> = (0..6).map(|i| DVec2::new(real(i), real(i * i))).collect();
    let spline = |closed: bool| {
        let degrees = if closed { [1, 2, 3] } else { [1, 2, 2] };
        casteljau::Spline::with_degrees(points.clone(), &degrees, closed).expect("a spline")
    };
    let mut open = Counts::default();
    spline(false).trace(&mut open, None).expect("drawn");
    assert_eq!(
        open,
        Counts(
            [1, 1, 2, 0, 0],
            vec![points[0], points[1], points[3], points[5]]
        )
    );
    let mut closed = Counts::default();
    spline(true).trace(&mut closed, Some(0.1)).expect("drawn");
    assert_eq!(
        closed,
        Counts(
            [1, 1, 1, 1, 1],
            vec![points[0], points[1], points[3], points[0]]
        )
    );
    let mut nothing = Counts::default();
    assert!(spline(true).trace(&mut nothing, Some(-1.0)).is_err());
    assert_eq!(nothing, Counts::default());
}
