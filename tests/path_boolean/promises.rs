//! What results promise: bits of what is not touched, starting points, scaling, symmetry, few segments.

use crate::path_boolean::check::{OPERATIONS, faults_beyond, path, valid};
use crate::path_boolean::families::FAMILIES;
use crate::support::{Rng, paths};
use casteljau::Path;
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::{FillRule, PathBuilder};

const RULE: FillRule = FillRule::NonZero;

fn bits(path: &Path) -> Vec<Vec<u64>> {
    let segments = path.segments();
    let bits = segments.map(|curve| paths::bits(curve.control_points()));
    bits.collect()
}

#[test]
fn outlines_that_nothing_touches_keep_their_bits_and_starts() {
    let a = path("M0.1 0.2C1.3 -0.7 2.1 0.3 1.7 1.9S-0.3 1.1 0.1 0.2Z");
    let b = path("M10.3 0.1L12.7 0.3L11.1 2.9Z");
    let union = valid(a.union(&b, RULE));
    assert_eq!(bits(&union), [bits(&a), bits(&b)].concat());
    let clockwise = a.reverse();
    assert_eq!(bits(&valid(clockwise.union(&b, RULE))), bits(&union));
}

#[test]
fn segments_away_from_the_crossings_keep_their_bits() {
    let a = path("M0.1 0.1C3.3 -0.7 6.1 0.3 9.7 1.9L9.9 9.7L0.3 9.3Z");
    let b = path("M9.1 4.3L20.3 4.1L20.7 6.9L9.3 6.7Z");
    let before = bits(&a);
    let after = bits(&valid(a.union(&b, RULE)));
    let kept = before.iter().filter(|curve| after.contains(curve)).count();
    assert_eq!(kept, before.len() - 1, "all but the right side");
    assert_eq!(after[0], before[0], "the contour starts where it started");
    assert_eq!(after.len(), 4 + 1 + 3, "the right side is in two parts");
}

/// One piece of an overlap continues the outline that it belongs to, so no point is added.
#[test]
fn shared_sides_add_no_points() {
    let a = path("M0 0H4V4H0Z");
    let b = path("M1 0H3V2H1Z");
    assert_eq!(valid(a.union(&b, RULE)), a);
    assert_eq!(valid(a.union(&a, RULE)), a);
    assert_eq!(valid(a.intersect(&b, RULE)), b);
}

#[test]
fn scaling_by_powers_of_two_scales_the_result() {
    for (name, family, _) in FAMILIES {
        for seed in 0..10 {
            let (a, b) = family(&mut Rng(seed));
            for scale in [2.0_f64.powi(-40), 4.0, 2.0_f64.powi(70)] {
                let map = DAffine2::from_scale(DVec2::splat(scale));
                for (operation, apply, _) in OPERATIONS {
                    let scaled = apply(&(map * &a), &(map * &b), RULE);
                    let expected = map * &apply(&a, &b, RULE);
                    let case = format!("{name} {seed} {operation} {scale}");
                    assert_eq!(bits(&scaled), bits(&expected), "{case}");
                }
            }
        }
    }
}

#[test]
fn unions_are_symmetric_and_their_own_regions() {
    for (name, family, coincident) in FAMILIES {
        // With the seeds 10 and 17, two results touch themselves up to rounding, and are cut there once more.
        for seed in 20..40 {
            let (a, b) = family(&mut Rng(seed));
            let [union, other] = [a.union(&b, RULE), b.union(&a, RULE)].map(valid);
            let difference = (union.area() - other.area()).abs();
            let max = if coincident { 1e-8 } else { 1e-11 };
            assert!(difference <= max, "{name} {seed}: {difference:e}");
            let again = valid(union.remove_overlaps(RULE));
            assert!(
                bits(&union) == bits(&again),
                "{name} {seed}\n{union}\n{again}"
            );
        }
    }
}

/// Outlines whose details are 10⁻⁶ of the size, where rounding makes every attempt at a planar map contradict itself:
/// polygons within 2⁻¹⁸ of the size replace them.
#[test]
fn outlines_whose_map_contradicts_itself_become_polygons() {
    let a = lists(&[
        &[
            (-0.25988807931765523, -0.6418478245814827),
            (0.01028011939888629, -0.07333533711048466),
            (0.097687883859868, 0.06627358059096974),
            (0.05835508014199729, -0.07189714039126116),
            (-0.05169842567801842, -0.33672356897131905),
            (-0.1764527675234717, -0.5770817740633456),
            (-0.25988807931765523, -0.6418478245814827),
        ],
        &[
            (-0.25988807931765523, -0.6418478245814827),
            (-0.34332339111183874, -0.7066138750996198),
            (71512.25896079636, 61031.99217517648),
            (26804.913211901607, 22819.816704441142),
            (16.90132624395799, -142.2395757171635),
            (53.9720298490699, -193.62650656113527),
            (9.430642287900309, -186.82230960415615),
        ],
        &[
            (9.430642287900309, -186.82230960415615),
            (9.430597746512747, -186.82230279995917),
            (9.376712421662328, -187.06515000709308),
            (9.48148976593245, -186.77456100050802),
            (9.58053571041687, -186.41063064644905),
            (9.603680566581755, -186.12435753833756),
            (-0.25988807931765523, -0.6418478245814827),
        ],
    ]);
    let b = lists(&[&[
        (0.2999494558194822, -0.7313501907876014),
        (-0.4104222111265489, -0.6252700946864438),
        (-0.21587126962412162, -0.4459343231889944),
        (0.8836022803267636, -0.19334287629525315),
    ]]);
    let rule = FillRule::EvenOdd;
    let segments = valid(a.exclude(&b, rule)).segment_count();
    assert!(segments > 500, "{segments} segments: not polygons");
    let faults = faults_beyond(4e-6, &a, &b, rule, &mut Rng(5));
    assert!(faults.is_empty(), "{faults:?}");
}

/// A path of one subpath with the given control points of its segments.
fn lists(segments: &[&[(f64, f64)]]) -> Path {
    let mut builder = PathBuilder::new();
    builder.move_to(segments[0][0].into());
    for points in segments {
        let points: Vec<DVec2> = points[1..].iter().map(|&p| p.into()).collect();
        builder.curve_to(&points);
    }
    builder.build().expect("finite points")
}
