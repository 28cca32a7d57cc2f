use casteljau::glam::DVec3;
use casteljau::{NurbsCurve, NurbsSurface, TessellationOptions};
use std::f64::consts::{PI, TAU};

pub(crate) fn sample(out: &mut String) {
    let sphere = NurbsSurface::sphere(DVec3::ZERO, 1.0, DVec3::Z).unwrap();
    for v in [0.0, 0.1, 0.5] {
        let point = sphere.eval(0.3, v);
        let (height, distance) = (point.z, point.length());
        writeln!(
            out,
            "height {height:.4}, distance from the centre {distance:.12}"
        );
    }

    // Only its triangles have an error.
    for tolerance in [0.1, 0.01, 0.001] {
        let options = TessellationOptions::tolerance(tolerance);
        let mesh = sphere.to_surface().unwrap().tessellate(&options).unwrap();
        let triangles = mesh.indices.len() / 3;
        writeln!(out, "within {tolerance}: {triangles} triangles");
    }

    // A circle beside the axis, turned by half a turn: a torus with R = 2 and r = ½ has the area 4π²Rr.
    let (center, u, v) = (2.0 * DVec3::X, 0.5 * DVec3::X, 0.5 * DVec3::Y);
    let circle = NurbsCurve::arc(center, u, v, 0.0, TAU).unwrap();
    let half = NurbsSurface::revolve(&circle, DVec3::ZERO, DVec3::Y, PI).unwrap();
    let area = half.to_surface().unwrap().area();
    writeln!(
        out,
        "half a torus: {area:.6}, and 2π² = {:.6}",
        2.0 * PI.powi(2)
    );
}
