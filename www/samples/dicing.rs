use casteljau::{Patch, Surface, TeapotOptions};

const MAX_GRID: f64 = 16.0;

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    for pixels in [50, 100, 200] {
        let max_edge = 4.0 / f64::from(pixels); // edges of at most 4 pixels
        let count: f64 = (0..teapot.patch_count())
            .map(|k| micropolygons(&teapot.patch(k).unwrap(), max_edge))
            .sum();
        writeln!(out, "{pixels} pixels for each unit: {count} micropolygons");
    }
}

/// Splits a patch until its grid is small enough, and counts the micropolygons.
fn micropolygons(patch: &Patch, max_edge: f64) -> f64 {
    let points = patch.control_points();
    let (mut u, mut v) = (0.0_f64, 0.0_f64); // the longest legs of the net
    for k in 0..16 {
        if k % 4 < 3 {
            u = u.max(points[k].distance(points[k + 1]));
        }
        if k < 12 {
            v = v.max(points[k].distance(points[k + 4]));
        }
    }
    let [count_u, count_v] = [u, v].map(|leg| (3.0 * leg / max_edge).ceil().max(1.0));
    if count_u.max(count_v) <= MAX_GRID {
        return count_u * count_v;
    }
    let (a, b) = if count_u >= count_v {
        patch.split_u(0.5)
    } else {
        patch.split_v(0.5)
    };
    micropolygons(&a, max_edge) + micropolygons(&b, max_edge)
}
