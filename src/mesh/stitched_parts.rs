//! Stitching on all cores: the patches in several parts, whose nodes, corners and triangles are then renumbered as if
//! the patches had been added one after the other.

use super::edge_samples::EdgeSamples;
use super::stitched_mesh::{Corner, NONE, PatchEnd, StitchedMesh, Stitcher};
use crate::numeric::order::to_u32;
use rayon::prelude::*;

/// The number of parts for each core: more of them divide the work more evenly, and need more memory.
const PARTS_PER_CORE: usize = 4;

/// The mesh of all patches; `start` makes a stitcher without patches.
pub(super) fn stitch_on_all_cores<'a>(
    edges: &EdgeSamples,
    patches: usize,
    start: impl Fn() -> Stitcher<'a> + Sync,
) -> StitchedMesh {
    let length = patches
        .div_ceil(PARTS_PER_CORE * rayon::current_num_threads())
        .max(1);
    let parts: Vec<Stitcher> = (0..patches.div_ceil(length))
        .into_par_iter()
        .map(|k| {
            let mut part = start();
            part.add_patches(k * length..((k + 1) * length).min(patches));
            part
        })
        .collect();
    let mut whole = start();
    whole.out.nodes.clone_from(&edges.points);
    reserve(&mut whole.out, &parts);
    for part in parts {
        append(&mut whole, part, edges.points.len());
    }
    whole.out
}

/// Room for all parts at once, so that nothing is copied again when a list grows.
fn reserve(out: &mut StitchedMesh, parts: &[Stitcher]) {
    let total =
        |length: fn(&StitchedMesh) -> usize| parts.iter().map(|part| length(&part.out)).sum();
    out.nodes.reserve(total(|part| part.nodes.len()));
    out.corners.reserve(total(|part| part.corners.len()));
    out.triangles.reserve(total(|part| part.triangles.len()));
}

/// Appends a part whose own nodes begin at number `shared`. A vertex that an earlier part has as a node keeps it.
fn append(whole: &mut Stitcher, part: Stitcher, shared: usize) {
    let nodes = renumber(whole, &part, shared);
    let out = &mut whole.out;
    let (corners, triangles) = (out.corners.len(), out.triangles.len());
    out.corners.extend(part.out.corners.iter().map(|corner| {
        let own = (corner.node as usize).checked_sub(shared);
        Corner {
            node: own.map_or(corner.node, |own| nodes[own]),
            ..*corner
        }
    }));
    let first = to_u32(corners);
    let moved = part.out.triangles.iter().map(|t| t.map(|k| k + first));
    out.triangles.extend(moved);
    out.ends.extend(part.out.ends.iter().map(|end| PatchEnd {
        corners: corners + end.corners,
        triangles: triangles + end.triangles,
    }));
}

/// The number in the whole of each own node of a part; new nodes are appended.
fn renumber(whole: &mut Stitcher, part: &Stitcher, shared: usize) -> Vec<u32> {
    let mut vertex_of = vec![NONE; part.out.nodes.len()];
    for (vertex, &node) in (0..).zip(&part.node_of_vertex) {
        if node != NONE {
            vertex_of[node as usize - shared] = vertex;
        }
    }
    let mut number = |(&point, vertex): (_, u32)| {
        let known = whole.node_of_vertex.get_mut(vertex as usize);
        if let Some(&mut node) = known
            && node != NONE
        {
            return node;
        }
        whole.out.nodes.push(point);
        let node = to_u32(whole.out.nodes.len() - 1);
        if let Some(entry) = known {
            *entry = node;
        }
        node
    };
    part.out
        .nodes
        .iter()
        .zip(vertex_of)
        .map(&mut number)
        .collect()
}
