//! Ed Catmull's Gumbo, the most difficult model: parts overlap, many corners and edges are collapsed. Its data are not part
//! of the project; without them these tests are reported as skipped.

use crate::support::Rng;
use crate::support::near;
use crate::support::nets::{RandomNet, part};
use crate::support::surfaces::gumbo;
use crate::support::wires::{check_ribbons, euler, ribbons, tubes};
use crate::watertight::shapes::{diagonal, meshed, tolerance};
use crate::watertight::soup::Soup;
use crate::watertight::{figures, known, limits, metamorphic, weld};
use casteljau::Surface;
use casteljau::glam::DVec3;
use casteljau::mesh::Weld;

/// The volume and the area that are known from another source.
const VOLUME: f64 = 2_556.773_7;
const AREA: f64 = 1_725.974_79;

/// The largest closed part.
fn body(surface: &Surface) -> Surface {
    let parts = surface.topology().components.into_iter();
    let parts = parts.map(|patches| part(surface, &patches));
    let closed = parts.filter(|part| part.topology().open.is_empty());
    closed.max_by_key(Surface::patch_count).unwrap()
}

#[test]
fn edges_normals_and_lines() {
    let Some(surface) = gumbo() else { return };
    assert_eq!(figures::counts(&surface), [247, 8, 10]);
    figures::check_sides(&surface);
    // At degenerate corners and edges.
    assert_eq!(limits::compare(&surface, 1e-3), 315);
    let curves = 128 * 2 * 5 - 247 - 10;
    assert_eq!(surface.isocurves(4).unwrap().len(), curves);
    let mesh = tubes(&surface, 4, 0.05, 6);
    assert!(euler(&mesh) >= 2 * isize::try_from(curves).unwrap());
    let bands = ribbons(&surface, 4, 0.1);
    assert!(bands.vertex_count() >= 4 * curves);
    check_ribbons(&bands);
    assert_eq!(Surface::parse(&surface.to_text()), Ok(surface));
}

#[test]
fn area_and_volume() {
    let Some(surface) = gumbo() else { return };
    near(surface.area(), AREA, 1.5e-8 * AREA);
    assert_eq!(surface.volume(), None);
    near(body(&surface).volume().unwrap(), VOLUME, 5e-5);
}

/// A ray that enters the closed body leaves it again: by the normals, a ray enters as often as it leaves.
#[test]
fn rays_go_in_and_out_of_the_body() {
    let Some(surface) = gumbo() else { return };
    let body = body(&surface);
    let bounds = body.bounds().unwrap();
    let mut random = Rng(1);
    let mut hits = 0;
    for _ in 0..1000 {
        let share = DVec3::new(random.unit(), random.unit(), random.unit());
        let inside = bounds.min + (bounds.max - bounds.min) * share;
        let along = random.grid_point().normalize_or(DVec3::X);
        let found = body.intersect_ray(inside - along * 100.0, along).unwrap();
        assert_eq!(found.len() % 2, 0, "{found:?}");
        let depth = found.iter().fold(0.0, |depth, hit| {
            let normal = body.patch(hit.patch).unwrap().normal(hit.u, hit.v);
            depth - normal.dot(along).signum()
        });
        assert_eq!(depth, 0.0, "{found:?}");
        hits += found.len();
    }
    assert!(hits > 1500, "{hits}");
}

#[test]
fn meshes_are_watertight() {
    let Some(surface) = gumbo() else { return };
    known::check_tolerances("gumbo", &surface);
    known::check_segments("gumbo", &surface);
    weld::check_normals("gumbo", &surface);
    let triangles = figures::fine_triangles(&surface);
    println!("gumbo: {triangles}");
    near(triangles as f64 / 25_444.0, 1.0, 0.2);
}

#[test]
fn meshes_follow_the_surface() {
    let Some(surface) = gumbo() else { return };
    metamorphic::check_changes("gumbo", &surface, 1e-2);
    metamorphic::check_powers_of_two("gumbo", &surface);
}

#[test]
fn the_volume_of_finer_meshes_comes_nearer() {
    let Some(surface) = gumbo() else { return };
    let body = body(&surface);
    let mut last = f64::INFINITY;
    for relative in [1e-2, 1e-3, 1e-4] {
        let options = tolerance(diagonal(&surface) * relative);
        let soup = Soup::new(&meshed(&body, options, Weld::None));
        assert!(soup.boundary(1).is_empty(), "an open edge");
        let off = (soup.volume() - VOLUME).abs() / VOLUME;
        println!("{relative:e}: volume off by {off:.1e}");
        // The volume between the body and the mesh is at most the tolerance times the area of the whole.
        assert!(off < diagonal(&surface) * relative * AREA / VOLUME && off < last);
        last = off;
    }
    assert!(last < 3e-4);
}
