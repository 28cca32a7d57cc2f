use casteljau::glam::DVec3;
use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    for row in 0..16 {
        let mut line = String::new();
        for column in 0..54 {
            let (x, z) = (-3.1 + 0.125 * f64::from(column), 3.1 - 0.2 * f64::from(row));
            let origin = DVec3::new(x, -10.0, z);
            let hits = teapot.intersect_ray(origin, DVec3::Y).unwrap();
            line.push(match hits.first() {
                Some(hit) => shade(teapot.patch(hit.patch).unwrap().normal(hit.u, hit.v)),
                None => ' ',
            });
        }
        writeln!(out, "{}", line.trim_end());
    }
}

/// A character for the angle between the normal and the light.
fn shade(n: DVec3) -> char {
    let cosine = n.dot(DVec3::new(-0.48, -0.6, 0.64)).max(0.0);
    let level = (1..9).filter(|&k| 9.0 * cosine >= f64::from(k)).count();
    char::from(b".:-=+*#%@"[level])
}
