//! Hostile numbers: no panic, no NaN, and termination in reasonable time.

use crate::intersect::generate::new;
use crate::support::Rng;
use casteljau::Curve;
use casteljau::curve::IntersectionKind;
use casteljau::glam::DVec2;

fn coordinate(rng: &mut Rng) -> f64 {
    match rng.below(8) {
        0 => rng.pick(&[
            0.0,
            -0.0,
            5e-324,
            -1e-320,
            1e150,
            -1e150,
            casteljau::MAX_COORDINATE,
            f64::MIN_POSITIVE,
        ]),
        1 => rng.signed() * rng.magnitude(-300.0, 150.0),
        2 => 1.0 + f64::EPSILON * rng.signed() * 8.0,
        3 => rng.signed() * 1e-9,
        _ => rng.pick(&[0.0, 1.0, 2.0, -1.0, 0.5]),
    }
}

fn adversarial(rng: &mut Rng) -> Curve<DVec2> {
    let degree = if rng.chance(0.95) {
        1 + rng.below(6)
    } else {
        7 + rng.below(58)
    };
    let mut points: Vec<DVec2> = (0..=degree)
        .map(|_| DVec2::new(coordinate(rng), coordinate(rng)))
        .collect();
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
        let b = if rng.chance(0.2) {
            a.reverse()
        } else {
            adversarial(&mut rng)
        };
        for location in a.intersections(&b) {
            let inside = |t: f64| (0.0..=1.0).contains(&t);
            let ends = match location.kind {
                IntersectionKind::Overlap { t_end, u_end } => inside(t_end) && inside(u_end),
                _ => true,
            };
            assert!(
                inside(location.t) && inside(location.u) && ends && location.point.is_finite(),
                "seed {seed}: {location:?}"
            );
        }
        for location in a.self_intersections() {
            assert!(
                0.0 <= location.t
                    && location.t < location.u
                    && location.u <= 1.0
                    && location.point.is_finite(),
                "seed {seed}: {location:?}"
            );
        }
    }
}
