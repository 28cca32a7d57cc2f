use std::collections::HashMap;

use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Surface, TeapotOptions};

pub(crate) fn sample(out: &mut String) {
    let teapot = Surface::teapot(&TeapotOptions::default());
    let pieces = teapot.subdivide(0.02).unwrap();
    writeln!(out, "pieces of the recursion: {}", pieces.len());
    let mesh = teapot
        .tessellate(&TessellationOptions::tolerance(0.02).weld(Weld::Position))
        .unwrap();
    let indices: Vec<_> = mesh.indices.iter().collect();
    let mut sides = HashMap::new(); // how many triangles each edge has
    for corners in indices.chunks(3) {
        for (a, b) in [
            (corners[0], corners[1]),
            (corners[1], corners[2]),
            (corners[2], corners[0]),
        ] {
            *sides.entry((a.min(b), a.max(b))).or_insert(0) += 1;
        }
    }
    let counts = [1, 2, 3].map(|n| sides.values().filter(|&&count| count == n).count());
    writeln!(
        out,
        "edges with one triangle: {}, with two: {}, with three: {}",
        counts[0], counts[1], counts[2]
    );
    let topology = teapot.topology();
    writeln!(
        out,
        "sides: {} pairs, {} open, {} collapsed",
        topology.shared.len(),
        topology.open.len(),
        topology.collapsed.len()
    );
}
