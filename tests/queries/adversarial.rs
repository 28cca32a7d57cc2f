//! Queries on patches with any finite coordinates: results are finite numbers, with bounded work.

use crate::support::nets::{RandomNet, patch, samples};
use crate::support::{Rng, real};
use casteljau::Patch;
use casteljau::glam::DVec3;

/// A coordinate that is often 0, repeated, huge or tiny.
fn coordinate(rng: &mut Rng) -> f64 {
    match rng.below(7) {
        0 => 0.0,
        1 => 1.0,
        2 => rng.signed(),
        3 => 1e150 * rng.signed(),
        4 => 1e-300 * rng.signed(),
        5 => casteljau::MAX_COORDINATE,
        _ => f64::MIN_POSITIVE,
    }
}

fn point(rng: &mut Rng) -> DVec3 {
    DVec3::from([0; 3].map(|_| coordinate(rng)))
}

/// A patch with degrees from 1 to `degree`.
fn random_patch(rng: &mut Rng, degree: usize, point: impl Fn(&mut Rng) -> DVec3) -> Patch {
    let (m, n) = (1 + rng.below(degree), 1 + rng.below(degree));
    let net: Vec<DVec3> = (0..(m + 1) * (n + 1)).map(|_| point(rng)).collect();
    patch(&net, m, n)
}

/// A patch with few different coordinates, so that it has many coincident, collinear and coplanar points.
fn coarse_patch(rng: &mut Rng) -> Patch {
    let whole = |rng: &mut Rng, first: f64, count| first + real(rng.below(count));
    random_patch(rng, 3, |rng| {
        DVec3::new(whole(rng, -1.0, 3), whole(rng, -1.0, 3), whole(rng, 0.0, 2))
    })
}

#[test]
fn answers_are_numbers() {
    let mut rng = Rng(1975);
    for case in 0..64 {
        let patch = random_patch(&mut rng, 4, point);
        let (p, d) = (point(&mut rng), point(&mut rng));
        let (u, v) = (rng.unit(), rng.unit());
        let bounds = patch.bounds();
        let finite = bounds.min.is_finite() && bounds.max.is_finite();
        assert!(finite && bounds.min.cmple(bounds.max).all(), "case {case}");
        let nearest = patch.nearest(p).unwrap();
        assert!(
            nearest.point.is_finite() && !nearest.distance.is_nan(),
            "case {case}"
        );
        for hit in patch.intersect_ray(p, d + DVec3::X * 1e-300).unwrap() {
            assert!(
                hit.point.is_finite() && hit.distance >= 0.0,
                "case {case}: {hit:?}"
            );
        }
        let c = patch.curvature(u, v);
        let numbers = [
            c.gaussian,
            c.mean,
            c.k1,
            c.k2,
            patch.area(),
            patch.flatness(),
        ];
        assert!(
            numbers.iter().all(|k| !k.is_nan()),
            "case {case}: {numbers:?}"
        );
    }
}

#[test]
fn coarse_nets() {
    let mut rng = Rng(1975);
    for case in 0..64 {
        let patch = coarse_patch(&mut rng);
        let p = DVec3::from([0; 3].map(|_| real(rng.below(5)) - 2.0)) * 0.5;
        let [u, v] = [0; 2].map(|_| real(rng.below(5)) / 4.0);
        let aim = patch.eval(u, v);
        let nearest = patch.nearest(p).unwrap();
        assert!(
            nearest.distance <= aim.distance(p) + 1e-14,
            "case {case}: {nearest:?}"
        );
        assert!(patch.nearest(aim).unwrap().distance < 1e-7, "case {case}");
        if aim.distance(p) > 1e-3 {
            let hits = patch.intersect_ray(p, aim - p).unwrap();
            assert!(!hits.is_empty(), "case {case}: no hit at {aim}");
            for hit in hits {
                let off = (hit.point - p).cross((aim - p).normalize()).length();
                assert!(off < 1e-6, "case {case}: {off} {hit:?}");
            }
        }
        let bounds = patch.bounds();
        let slack = DVec3::splat(1e-15);
        let inside = aim.cmpge(bounds.min - slack) & aim.cmple(bounds.max + slack);
        assert!(inside.all(), "case {case}: {aim}");
        assert!(patch.area().is_finite(), "case {case}");
    }
}

#[test]
fn points_and_normals_are_numbers() {
    let mut rng = Rng(1975);
    for case in 0..256 {
        let patch = random_patch(&mut rng, 5, point);
        let (u, v) = (rng.unit(), rng.unit());
        assert!(patch.eval(u, v).is_finite(), "case {case}");
        let normal = patch.normal(u, v);
        let length = normal.length();
        let unit_or_zero = length == 0.0 || (length - 1.0).abs() < 1e-14;
        assert!(unit_or_zero, "case {case}: {normal}");
        for piece in patch.split(u, v) {
            let finite = piece.control_points().iter().all(|p| p.is_finite());
            assert!(finite, "case {case}");
        }
    }
}

/// The highest degrees, with curvature in every direction: the work is limited.
#[test]
fn the_highest_degrees() {
    let patch = Rng(3).patch(64, 64);
    let p = DVec3::new(0.3, 0.2, 0.1);
    let nearest = patch.nearest(p).unwrap();
    let bounds = patch.bounds();
    for (u, v) in samples(30) {
        let sample = patch.eval(u, v);
        assert!(sample.cmpge(bounds.min).all() && sample.cmple(bounds.max).all());
        assert!(nearest.distance <= sample.distance(p));
    }
    let hits = patch.intersect_ray(p, nearest.point - p).unwrap();
    let mut distances = hits.iter().map(|hit| hit.point.distance(nearest.point));
    assert!(distances.any(|distance| distance < 1e-9));
    assert!(patch.area() > 0.0);
}
