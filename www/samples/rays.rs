use casteljau::glam::DVec3;
use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    let hits = teapot
        .intersect_ray(DVec3::new(-5.0, 0.1, 1.2), DVec3::X)
        .unwrap();
    for hit in hits {
        writeln!(out, "patch {} at distance {:.4}", hit.patch, hit.distance);
    }
    let near = teapot.nearest(DVec3::new(2.0, 1.0, 3.0)).unwrap().unwrap();
    writeln!(
        out,
        "nearest: patch {}, u = {:.3}, v = {:.3}, {:.4} away",
        near.patch, near.u, near.v, near.distance
    );
}
