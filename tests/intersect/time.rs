//! No pair of low degree takes long, however it lies.

use crate::common::plane;
use casteljau::Curve;
use casteljau::glam::{DAffine2, DVec2};
use std::time::Instant;

/// Milliseconds; what the requirements ask of any pair of degree up to 3.
const MOST_MS: f64 = 5.0;

fn shapes() -> Vec<Curve<DVec2>> {
    vec![
        plane(&[(0.0, 0.0), (3.0, 2.0), (-2.0, 2.0), (1.0, 0.0)]),
        plane(&[(0.0, 0.0), (1.0, 3.0), (2.0, -3.0), (3.0, 1.0)]),
        plane(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]),
        plane(&[(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)]),
        plane(&[(0.0, 0.0), (3.0, 3.0), (-1.0, -1.0), (2.0, 2.0)]),
        plane(&[(0.0, 0.0), (1.0, 2.0), (2.0, 0.0)]),
        plane(&[(0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (1.0, 1.0)]),
        plane(&[(1.0, 1.0), (1.0, 1.0)]),
    ]
}

/// A curve and others that nearly or wholly cover it.
fn neighbours(c: &Curve<DVec2>) -> Vec<Curve<DVec2>> {
    let mut all = vec![
        c.clone(),
        c.reverse(),
        c.subsegment(0.2, 0.8),
        c.subsegment(1.0, 0.3),
    ];
    for k in 0..17 {
        let e = 10_f64.powi(-k);
        let along = c.tangent(0.3) * e;
        all.push(c.transform(&DAffine2::from_translation(along)));
        all.push(c.transform(&DAffine2::from_translation(along.perp())));
        all.push(c.transform(&DAffine2::from_angle(e)));
        all.push(c.transform(&DAffine2::from_scale(DVec2::new(1.0 + e, 1.0))));
        let noisy: Vec<DVec2> = c
            .control_points()
            .iter()
            .enumerate()
            .map(|(i, p)| *p + DVec2::from_angle(7.0 * i as f64) * e)
            .collect();
        all.push(Curve::new(&noisy).expect("finite"));
    }
    all
}

#[test]
fn worst_case() {
    let mut worst = (0.0, String::new());
    for a in shapes() {
        for b in neighbours(&a).into_iter().chain(shapes()) {
            // The least of three: the machine has other things to do.
            let took = (0..3).map(|_| {
                let start = Instant::now();
                std::hint::black_box(a.intersect(&b));
                start.elapsed().as_secs_f64() * 1e3
            });
            let took = took.fold(f64::INFINITY, f64::min);
            if took > worst.0 {
                worst = (
                    took,
                    format!("{:?} {:?}", a.control_points(), b.control_points()),
                );
            }
        }
    }
    println!("the longest: {} ms", worst.0);
    assert!(worst.0 <= MOST_MS, "{} ms: {}", worst.0, worst.1);
}

/// Written down, not judged: how the time grows with the degree.
#[test]
fn growth_with_the_degree() {
    for degree in [3, 6, 12, 24, 48, 64_usize] {
        let wave = |x: f64, y: f64| {
            let points: Vec<DVec2> = (0..=degree)
                .map(|i| {
                    DVec2::new(
                        i as f64 * x + (i % 2) as f64 * y,
                        i as f64 * y + (i % 2) as f64 * x,
                    )
                })
                .collect();
            Curve::new(&points).expect("finite")
        };
        let (a, b) = (wave(1.0, 0.1), wave(1.0, 0.12));
        let shifted = a.transform(&DAffine2::from_translation(DVec2::new(1e-9, 1e-9)));
        let time = |b: &Curve<DVec2>| {
            let start = Instant::now();
            let found = a.intersect(b).len();
            (found, start.elapsed().as_secs_f64() * 1e6)
        };
        println!(
            "degree {degree}: crossing {:?}, equal {:?}, shifted {:?} (places, µs)",
            time(&b),
            time(&a),
            time(&shifted)
        );
    }
}
