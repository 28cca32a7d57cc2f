use casteljau::Patch;
use casteljau::glam::DVec3;

pub(crate) fn sample(out: &mut String) {
    // Four rows of four points: u runs along a row, v from row to row.
    let rows = [
        [0.0, 1.0, 1.0, 0.0],
        [1.0, 3.0, 3.0, 1.0],
        [1.0, 3.0, 3.0, 1.0],
        [0.0, 1.0, 1.0, 0.0],
    ];
    let mut net = Vec::new();
    for (y, row) in (0..).zip(rows) {
        net.extend(
            (0..)
                .zip(row)
                .map(|(x, z)| DVec3::new(f64::from(x), f64::from(y), z)),
        );
    }
    let patch = Patch::new(&net, 3, 3).unwrap();
    for [u, v] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5]] {
        let p = patch.eval(u, v);
        writeln!(out, "S({u}, {v}) = ({}, {}, {})", p.x, p.y, p.z);
    }
}
