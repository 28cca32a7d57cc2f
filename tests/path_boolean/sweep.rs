//! All families, at three scales.

use crate::check::{faults, identity_error};
use crate::families::FAMILIES;
use crate::random::Random;
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::FillRule;

const SCALES: [f64; 3] = [1e-6, 1.0, 1e6];

#[test]
fn explore() {
    let count: usize = std::env::var("N").map_or(100, |n| n.parse().expect("a number"));
    for (name, family) in FAMILIES {
        if std::env::var("FAMILY").is_ok_and(|f| f != name) {
            continue;
        }
        let (mut wrong, mut worst, mut worst_seed) = (0, 0.0_f64, 0);
        let clock = std::time::Instant::now();
        for seed in 0..count {
            if std::env::var("SEED").is_ok_and(|f| f != seed.to_string()) {
                continue;
            }
            let mut random = Random::new(seed as u64);
            let (a, b) = family(&mut random);
            let scale = DAffine2::from_scale(DVec2::splat(SCALES[seed % 3]));
            let (a, b) = (a.transform(&scale), b.transform(&scale));
            let rule = if seed % 2 == 0 {
                FillRule::NonZero
            } else {
                FillRule::EvenOdd
            };
            let found = faults(&a, &b, rule, &mut random);
            let error = identity_error(&a, &b, rule);
            if error > worst {
                worst = error;
                worst_seed = seed;
            }
            if !found.is_empty() {
                wrong += 1;
                if wrong <= 3 {
                    println!("{name} {seed} {rule:?}: {} {}", found.len(), found[0]);
                }
            }
        }
        println!(
            "{name}: {wrong} of {count} wrong, identities {worst:e} (seed {worst_seed}) {:?}",
            clock.elapsed()
        );
    }
}
