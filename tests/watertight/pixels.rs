//! Tolerances in pixels.

use super::checks::assert_watertight;
use super::distance::Tree;
use super::shapes::{meshed, teapot, tolerance};
use super::soup::{Soup, area};
use crate::support::nets::{net, samples, single};
use casteljau::Surface;
use casteljau::glam::{DMat4, DVec2, DVec3, DVec4};
use casteljau::mesh::{TessellationOptions, View, Weld};

const VIEWPORT: DVec2 = DVec2::new(1_280.0, 720.0);

/// A perspective camera; the field of view refers to the height. z is not used here.
fn camera(eye: DVec3, target: DVec3, field_of_view: f64) -> DMat4 {
    let back = (eye - target).normalize();
    let right = DVec3::Z.cross(back).normalize();
    let up = back.cross(right);
    let zoom = 1.0 / (field_of_view.to_radians() / 2.0).tan();
    let row = |axis: DVec3, scale: f64| (axis * scale).extend(-axis.dot(eye) * scale);
    let x = row(right, zoom * VIEWPORT.y / VIEWPORT.x);
    DMat4::from_rows(x, row(up, zoom), DVec4::W, row(-back, 1.0))
}

fn view(view_projection: DMat4, pixels: f64) -> TessellationOptions {
    let viewport = VIEWPORT;
    TessellationOptions::pixels(View {
        pixels,
        view_projection,
        viewport,
    })
}

/// The position of a point on the screen in pixels, and whether it is visible.
fn seen(matrix: &DMat4, p: DVec3) -> (DVec2, bool) {
    let clip = *matrix * p.extend(1.0);
    let location = DVec2::new(clip.x, clip.y) / clip.w;
    let is_visible = clip.w > 0.0 && location.abs().max_element() <= 1.0;
    (location * VIEWPORT / 2.0, is_visible)
}

/// The maximum distance on the screen between points of the surface and the nearest points of the mesh.
fn greatest(surface: &Surface, matrix: &DMat4, pixels: f64) -> (f64, usize) {
    let mesh = meshed(surface, view(*matrix, pixels), Weld::None);
    assert_watertight(surface, &mesh, 2);
    let tree = Tree::new(&Soup::new(&mesh));
    let (mut max, mut hint, mut count): (f64, usize, usize) = (0.0, 0, 0);
    for patch in surface.patches() {
        for (u, v) in samples(59) {
            let p = patch.eval(u, v);
            let (location, is_visible) = seen(matrix, p);
            if is_visible {
                count += 1;
                let q = tree.nearest(p, &mut hint).unwrap();
                max = max.max(location.distance(seen(matrix, q).0));
            }
        }
    }
    assert!(count > 1_000, "only {count} samples are seen");
    (max, mesh.triangle_count())
}

/// Checks the distances, and returns the numbers of triangles.
fn assert_within(surface: &Surface, matrix: &DMat4, all: &[f64]) -> Vec<usize> {
    let of = |&pixels: &f64| {
        let (max, triangles) = greatest(surface, matrix, pixels);
        println!("{pixels} px: {triangles} triangles, {max:.3} px at most");
        assert!(max <= pixels, "{max} for {pixels} px");
        triangles
    };
    all.iter().map(of).collect()
}

#[test]
fn no_farther_than_asked_for() {
    let middle = DVec3::new(0.0, 0.0, 1.5);
    let cameras = [
        camera(DVec3::new(9.0, 4.0, 5.0), middle, 40.0),
        camera(DVec3::new(4.0, 0.5, 3.0), middle, 60.0),
        camera(DVec3::new(-3.6, -0.6, 2.2), middle, 100.0),
        camera(DVec3::new(0.5, 0.5, 4.0), DVec3::new(3.0, 0.0, 2.0), 120.0),
    ];
    for matrix in &cameras {
        let triangles = assert_within(&teapot(), matrix, &[0.5, 2.0, 10.0]);
        assert!(triangles[0] > triangles[1] && triangles[1] > triangles[2]);
    }
}

/// Pieces that start close to the eye and end at a great distance.
#[test]
fn a_plain_with_waves() {
    let height = |i: f64, j: f64| 0.9 - 1.8 * ((i + j) % 2.0);
    let net = net(3, 3, |i, j| {
        DVec3::new(4.0 * i - 6.0, 5.0 * j, height(i, j))
    });
    let plain = single(&net, 3, 3);
    let matrix = camera(DVec3::new(0.0, -1.0, 1.2), DVec3::new(0.0, 9.0, 0.0), 90.0);
    assert_within(&plain, &matrix, &[1.0, 5.0, 10.0, 20.0, 40.0]);
}

#[test]
fn what_is_nearer_is_finer() {
    // Along the axis from the spout to the handle, at eye level.
    let eye = DVec3::new(5.0, 0.0, 2.0);
    let options = view(camera(eye, DVec3::new(0.0, 0.0, 1.5), 60.0), 0.5);
    let soup = Soup::new(&meshed(&teapot(), options, Weld::Position));
    let mean_area = |is_part: fn(f64) -> bool| {
        let part = soup.all_corners().filter(|[a, ..]| is_part(a.x));
        let areas: Vec<f64> = part.map(area).collect();
        areas.iter().sum::<f64>() / areas.len() as f64
    };
    let (near, far) = (mean_area(|x| x > 2.2), mean_area(|x| x < -2.2));
    assert!(2.0 * near < far, "{near} and {far}");
}

#[test]
fn a_pixel_of_an_orthographic_view_is_a_length() {
    let scale = DMat4::from_diagonal(DVec4::new(0.25, 1.0 / 2.25, 0.1, 1.0));
    let by_pixels = view(scale * DMat4::from_rotation_x(-1.2), 0.8);
    let by_length = tolerance(0.8 * 8.0 / 1_280.0);
    let counts =
        [by_pixels, by_length].map(|o| meshed(&teapot(), o, Weld::Normal).triangle_count());
    // 8 units are 1,280 pixels. Parts outside the viewport may be coarser.
    let share = counts[0] as f64 / counts[1] as f64;
    assert!(share <= 1.0 && share > 0.6, "{counts:?}");
}

#[test]
fn strange_cameras_neither_hang_nor_fail() {
    let inside = DVec3::new(0.1, 0.2, 1.2);
    let on_surface = teapot().patch(5).unwrap().eval(0.3, 0.4);
    let at_vertex = teapot().vertices()[17];
    let mut singular = DMat4::IDENTITY;
    singular.w_axis.w = 0.0;
    let cameras = [
        camera(inside, DVec3::new(3.0, 0.0, 1.2), 90.0),
        camera(on_surface, DVec3::new(0.0, 0.0, 1.0), 90.0),
        camera(at_vertex, DVec3::new(0.0, 0.0, 1.1), 60.0),
        camera(DVec3::new(1e6, 0.0, 0.0), inside, 40.0),
        camera(DVec3::new(9.0, 0.0, 1.0), DVec3::new(20.0, 0.0, 1.0), 40.0),
        camera(inside, DVec3::new(3.0, 0.0, 1.2), 179.9),
        DMat4::ZERO,
        DMat4::IDENTITY,
        -DMat4::IDENTITY,
        singular,
        DMat4::IDENTITY * 1e300,
        DMat4::IDENTITY * 1e-300,
        DMat4::from_cols_array(&[f64::MAX; 16]),
        DMat4::from_cols_array(&[f64::MIN_POSITIVE; 16]),
    ];
    for (k, matrix) in cameras.iter().enumerate() {
        for pixels in [1.0, 0.3, 1e300] {
            let options = view(*matrix, pixels).weld(Weld::None);
            let mesh = teapot().tessellate(&options);
            let sides = mesh.map(|mesh| assert_watertight(&teapot(), &mesh, 8));
            println!("camera {k}, {pixels:e} px: {sides:?} open edges");
        }
    }
}
