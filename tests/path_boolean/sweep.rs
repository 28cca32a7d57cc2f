//! All families at three scales and with both fill rules: 2,000 pairs × 4 operations; 100,000 with `CASTELJAU_DEEP=1`.

use crate::path_boolean::check::{OPERATIONS, faults, identity_error};
use crate::path_boolean::families::{FAMILIES, Family, mixed_scales};
use crate::support::{Rng, cases};
use casteljau::Curve;
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::{FillRule, take_replaced_segments};

const SCALES: [f64; 3] = [1e-6, 1.0, 1e6];

/// The largest error of an identity of areas, relative to the square of the size.
const EXACT: f64 = 1e-12;
/// The same where outlines nearly coincide: within ε, one counts as the other.
const NEARLY_COINCIDENT: f64 = 1e-9;

fn pairs_of_each_family() -> usize {
    let given = std::env::var("CASTELJAU_CASES").ok();
    let usual = cases(2_000, 100_000) / FAMILIES.len() + 1;
    given.map_or(usual, |count| count.parse().expect("a number"))
}

fn check(name: &str) {
    let family = FAMILIES.iter().find(|family| family.0 == name);
    let &(_, family, coincident) = family.expect("a family");
    let seed = std::env::var("CASTELJAU_SEED").ok();
    let only: Option<usize> = seed.and_then(|seed| seed.parse().ok());
    let mut pairs_with_lines = 0;
    for seed in only.map_or(0..pairs_of_each_family(), |seed| seed..seed + 1) {
        take_replaced_segments();
        check_pair(name, seed, family, coincident);
        pairs_with_lines += usize::from(take_replaced_segments() > 0);
    }
    assert_eq!(pairs_with_lines, 0, "lines replace segments");
}

fn check_pair(name: &str, seed: usize, family: Family, coincident: bool) {
    let mut random = Rng(seed as u64);
    let scale = DAffine2::from_scale(DVec2::splat(SCALES[seed % 3]));
    let (a, b) = family(&mut random);
    let (a, b) = (scale * &a, scale * &b);
    let rule = [FillRule::NonZero, FillRule::EvenOdd][seed % 2];
    let found = faults(&a, &b, rule, &mut random);
    let case = format!("{name} {seed} {rule:?}");
    assert!(found.is_empty(), "{case}: {found:#?}\n{a}\n{b}");
    let error = identity_error(&a, &b, rule);
    let max = if coincident { NEARLY_COINCIDENT } else { EXACT };
    assert!(error <= max, "{case}: areas differ by {error:e}\n{a}\n{b}");
}

macro_rules! families {
    ($($test:ident $name:literal)*) => {
        $(#[test]
        fn $test() {
            check($name);
        })*

        #[test]
        fn every_family_is_tested() {
            assert_eq!([$($name),*], FAMILIES.map(|family| family.0));
        }
    };
}

families! {
    blobs "blobs"
    scribbles "scribbles"
    turned "turned"
    moved "moved"
    shared_segments "shared segments"
    partial_overlap "partial overlap"
    tangent_circles "tangent circles"
    touching "touching"
    nested "nested"
    grids "grids"
    glyphs "glyphs"
    lattice "lattice"
    stars "stars"
    slivers "slivers"
    cusps "cusps"
    high_degrees "high degrees"
}

#[test]
fn mixed_scales_give_finite_regions() {
    let mut random = Rng(7);
    for case in 0..pairs_of_each_family() {
        let [a, b] = [(); 2].map(|()| mixed_scales(&mut random));
        for (name, apply, _) in OPERATIONS {
            let result = apply(&a, &b, [FillRule::NonZero, FillRule::EvenOdd][case % 2]);
            let is_finite =
                |curve: Curve<DVec2>| curve.control_points().iter().all(|p| p.is_finite());
            assert!(
                result.segments().all(is_finite),
                "{name} {case}: {result}\n{a}\n{b}"
            );
        }
    }
}
