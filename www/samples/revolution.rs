use casteljau::glam::{DVec2, DVec3};
use casteljau::{Patch, Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    // The profile of the teapot's rim, as pairs (r, z), and a quarter of the unit circle.
    let profile = [(1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4)];
    let quarter = [(1.0, 0.0), (1.0, -0.56), (0.56, -1.0), (0.0, -1.0)].map(DVec2::from);
    let row = |(r, z): (f64, f64)| quarter.map(|p| (r * p).extend(z));
    let net: Vec<DVec3> = profile.map(row).concat();
    let rim = Surface::teapot(&TeapotOptions::default()).patch(0).unwrap();
    let pairs = net.iter().zip(rim.control_points());
    let largest = pairs
        .map(|(&p, &q)| (p - q).abs().max_element())
        .fold(0.0, f64::max);
    writeln!(out, "difference from the teapot's points: {largest:.6}");
    let patch = Patch::new(&net, 3, 3).unwrap();
    for u in [0.0, 0.25, 0.5] {
        let radius = patch.eval(u, 0.0).truncate().length() / 1.4;
        writeln!(out, "radius at u = {u}: {radius:.5}");
    }
}
