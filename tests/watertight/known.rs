//! Teapot, teacup and teaspoon at twelve tolerances and several numbers of segments.

use super::checks::{
    Three, assert_normals_of_patches, assert_on_surface, assert_watertight, tolerances,
};
use super::distance::greatest;
use super::shapes::{all, diagonal, segments, tolerance};
use super::soup::Soup;
use crate::support::{cases, deep};
use casteljau::Surface;

/// The number of tolerances from 0.1 to 1e-5 of the diagonal.
const TOLERANCES: i32 = 12;

/// The number of these tolerances by default; the finer ones take long.
const QUICK_TOLERANCES: i32 = 6;

/// Above this fraction of the diagonal half a handle may be a single flat piece.
const COARSE: f64 = 0.02;

#[test]
fn within_every_tolerance() {
    all()
        .iter()
        .for_each(|(name, surface)| check_tolerances(name, surface));
}

pub(crate) fn check_tolerances(name: &str, surface: &Surface) {
    let count = if deep() { TOLERANCES } else { QUICK_TOLERANCES };
    for allowed in tolerances(surface, count) {
        let three = Three::new(surface, &tolerance(allowed));
        let relative = allowed / diagonal(surface);
        let sheets = if relative > COARSE { 2 } else { 1 };
        check(name, surface, &three, sheets, f64::from);
        let soup = Soup::new(&three.position);
        let samples = cases(20_000, 4 * soup.triangles.len());
        let (max, patch) = greatest(surface, &soup, samples);
        let (share, count) = (max / allowed, soup.triangles.len());
        println!("{name} {relative:.1e}: {count} triangles, {share:.2} of the tolerance");
        assert!(max <= allowed, "{name}, patch {patch}: {max} for {allowed}");
    }
}

#[test]
fn any_number_of_segments() {
    all()
        .iter()
        .for_each(|(name, surface)| check_segments(name, surface));
}

pub(crate) fn check_segments(name: &str, surface: &Surface) {
    let counts = ([1, 2, 3, 7, 16, 1, 6, 9, 3], [1, 2, 3, 7, 16, 5, 4, 2, 14]);
    for (u, v) in counts.0.into_iter().zip(counts.1) {
        let three = Three::new(surface, &segments(u, v));
        // Samples of both directions are joined on edges: parameters are multiples of 1 / (u·v).
        let full = (u * v) as f64;
        let parameter = |t| (f64::from(t) * full).round() / full;
        let sheets = if u.min(v) == 1 { 2 } else { 1 };
        check(name, surface, &three, sheets, parameter);
    }
}

fn check<F>(name: &str, surface: &Surface, three: &Three, sheets: u32, parameter: F)
where
    F: Fn(f32) -> f64,
{
    three.assert_alike(surface.patch_count());
    let open = assert_watertight(surface, &three.own, sheets);
    assert_eq!(open == 0, surface.topology().open.is_empty(), "{name}");
    assert_on_surface(surface, &three.own, parameter);
    assert_normals_of_patches(three);
}
