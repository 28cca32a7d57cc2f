//! Hostile numbers: no panic, no NaN, and termination in reasonable time.

use crate::intersect::generate::new;
use crate::intersect::spots;
use crate::support::Rng;
use casteljau::glam::DVec2;
use casteljau::{Curve, MAX_COORDINATE};

fn coordinate(rng: &mut Rng) -> f64 {
    let tiny = [0.0, -0.0, 5e-324, -1e-320, f64::MIN_POSITIVE];
    match rng.below(16) {
        0 => rng.pick(&tiny),
        1 => rng.pick(&[1e150, -1e150, MAX_COORDINATE]),
        2 | 3 => rng.signed() * rng.magnitude(-300.0, 150.0),
        4 | 5 => 1.0 + f64::EPSILON * rng.signed() * 8.0,
        6 | 7 => rng.signed() * 1e-9,
        _ => rng.pick(&[0.0, 1.0, 2.0, -1.0, 0.5]),
    }
}

fn adversarial(rng: &mut Rng) -> Curve<DVec2> {
    let low = rng.chance(0.95);
    let degree = if low {
        1 + rng.below(6)
    } else {
        7 + rng.below(58)
    };
    let mut point = || DVec2::new(coordinate(rng), coordinate(rng));
    let mut points: Vec<DVec2> = (0..=degree).map(|_| point()).collect();
    if rng.chance(0.2) {
        let (i, j) = (rng.below(degree + 1), rng.below(degree + 1));
        points[i] = points[j];
    }
    new(&points)
}

#[test]
fn any_numbers() {
    for seed in 0..2_000 {
        let mut rng = Rng(seed);
        let a = adversarial(&mut rng);
        let reversed = rng.chance(0.2);
        let b = if reversed {
            a.reverse()
        } else {
            adversarial(&mut rng)
        };
        for p in a.intersections(&b) {
            let inside = |t: f64| (0.0..=1.0).contains(&t);
            let inside = spots(&p).iter().all(|&(t, u)| inside(t) && inside(u));
            assert!(inside && p.point.is_finite(), "seed {seed}: {p:?}");
        }
        for p in a.self_intersections() {
            let inside = 0.0 <= p.t && p.t < p.u && p.u <= 1.0;
            assert!(inside && p.point.is_finite(), "seed {seed}: {p:?}");
        }
    }
}
