//! Tolerances in pixels.

use super::checks::assert_watertight;
use super::distance::Tree;
use super::shapes::teapot;
use super::soup::Soup;
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
    let [x, y, w] = [
        row(right, zoom * VIEWPORT.y / VIEWPORT.x),
        row(up, zoom),
        row(-back, 1.0),
    ];
    DMat4::from_rows(x, y, DVec4::W, w)
}

fn view(view_projection: DMat4, pixels: f64) -> TessellationOptions {
    TessellationOptions::pixels(View {
        pixels,
        view_projection,
        viewport: VIEWPORT,
    })
}

/// The position of a point on the screen in pixels; `None` if it is not visible.
fn seen(matrix: &DMat4, p: DVec3) -> Option<DVec2> {
    let clip = *matrix * p.extend(1.0);
    let location = DVec2::new(clip.x, clip.y) / clip.w;
    (clip.w > 0.0 && location.abs().max_element() <= 1.0).then(|| location * VIEWPORT / 2.0)
}

/// The maximum distance on the screen between points of the surface and the nearest points of the mesh.
fn greatest(surface: &Surface, matrix: &DMat4, pixels: f64) -> (f64, usize) {
    let mesh = surface
        .tessellate(&view(*matrix, pixels).weld(Weld::None))
        .unwrap();
    assert_watertight(surface, &mesh, 2);
    let tree = Tree::new(&Soup::new(&mesh));
    let (mut max, mut hint, mut count): (f64, usize, usize) = (0.0, 0, 0);
    for patch in surface.patches() {
        for k in 0..60 * 60 {
            let p = patch.eval(f64::from(k % 60) / 59.0, f64::from(k / 60) / 59.0);
            let Some(location) = seen(matrix, p) else {
                continue;
            };
            count += 1;
            let q = tree.nearest(p, &mut hint).unwrap();
            let clip = *matrix * q.extend(1.0);
            let near = DVec2::new(clip.x, clip.y) / clip.w * VIEWPORT / 2.0;
            max = max.max((location - near).length());
        }
    }
    assert!(count > 1_000, "only {count} samples are seen");
    (max, mesh.triangle_count())
}

#[test]
fn no_farther_than_asked_for() {
    let surface = teapot();
    let middle = DVec3::new(0.0, 0.0, 1.5);
    let cameras = [
        camera(DVec3::new(9.0, 4.0, 5.0), middle, 40.0),
        camera(DVec3::new(4.0, 0.5, 3.0), middle, 60.0),
        camera(DVec3::new(-3.6, -0.6, 2.2), middle, 100.0),
        camera(DVec3::new(0.5, 0.5, 4.0), DVec3::new(3.0, 0.0, 2.0), 120.0),
    ];
    for matrix in &cameras {
        let mut fewest = usize::MAX;
        for pixels in [0.5, 2.0, 10.0] {
            let (max, triangles) = greatest(&surface, matrix, pixels);
            println!("{pixels} px: {triangles} triangles, {max:.3} px at most");
            assert!(max <= pixels, "{max} for {pixels} px");
            assert!(triangles < fewest);
            fewest = triangles;
        }
    }
}

/// Pieces that start close to the eye and end at a great distance.
#[test]
fn a_plain_with_waves() {
    let net: Vec<DVec3> = (0..16)
        .map(|k| {
            let (i, j) = (f64::from(k % 4), f64::from(k / 4));
            DVec3::new(
                4.0 * i - 6.0,
                5.0 * j,
                if (i + j) % 2.0 == 0.0 { 0.9 } else { -0.9 },
            )
        })
        .collect();
    let plain = Surface::new(net, (0..16).collect(), 3, 3).unwrap();
    let matrix = camera(DVec3::new(0.0, -1.0, 1.2), DVec3::new(0.0, 9.0, 0.0), 90.0);
    for pixels in [1.0, 5.0, 10.0, 20.0, 40.0] {
        let (max, triangles) = greatest(&plain, &matrix, pixels);
        println!("{pixels} px: {triangles} triangles, {max:.3} px at most");
        assert!(max <= pixels, "{max} for {pixels} px");
    }
}

#[test]
fn what_is_nearer_is_finer() {
    let surface = teapot();
    // Along the axis from the spout to the handle, at eye level.
    let eye = DVec3::new(5.0, 0.0, 2.0);
    let options = view(camera(eye, DVec3::new(0.0, 0.0, 1.5), 60.0), 0.5);
    let soup = Soup::new(&surface.tessellate(&options.weld(Weld::Position)).unwrap());
    let mean_area = |near: bool| {
        let all = (0..soup.triangles.len()).map(|k| soup.corners_at(k));
        let some = all.filter(|[a, ..]| if near { a.x > 2.2 } else { a.x < -2.2 });
        let areas: Vec<f64> = some
            .map(|[a, b, c]| (b - a).cross(c - a).length())
            .collect();
        areas.iter().sum::<f64>() / areas.len() as f64
    };
    assert!(
        2.0 * mean_area(true) < mean_area(false),
        "{} and {}",
        mean_area(true),
        mean_area(false)
    );
}

#[test]
fn a_pixel_of_an_orthographic_view_is_a_length() {
    let surface = teapot();
    let matrix =
        DMat4::from_diagonal(DVec4::new(0.25, 1.0 / 2.25, 0.1, 1.0)) * DMat4::from_rotation_x(-1.2);
    let count = |options: &TessellationOptions| {
        surface
            .tessellate(&options.weld(Weld::Normal))
            .unwrap()
            .triangle_count() as f64
    };
    // 8 units are 1,280 pixels. Parts outside the viewport may be coarser.
    let (by_pixels, by_length) = (
        count(&view(matrix, 0.8)),
        count(&TessellationOptions::tolerance(0.8 * 8.0 / 1_280.0)),
    );
    assert!(
        by_pixels <= by_length && by_pixels > 0.6 * by_length,
        "{by_pixels} and {by_length}"
    );
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
            let triangles = teapot()
                .tessellate(&view(*matrix, pixels).weld(Weld::None))
                .map(|mesh| {
                    assert_watertight(&teapot(), &mesh, 8);
                    mesh.triangle_count()
                });
            println!("camera {k}, {pixels:e} px: {triangles:?}");
        }
    }
}
