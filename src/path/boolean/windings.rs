//! The winding numbers of all paths in all faces: the faces are visited from the outside, across one edge at a time.

use super::edges::Edges;
use super::faces::Faces;
use super::segments::{Role, Segments};
use crate::path::winding::FillRule;

/// The winding numbers of the paths in one face.
pub(super) struct Windings {
    numbers: Vec<i32>,
    rule: FillRule,
    /// The number of paths that contain the face.
    pub(super) inside_count: usize,
}

impl Windings {
    /// Whether a path contains the face.
    pub(super) fn is_inside(&self, path: usize) -> bool {
        self.rule.is_inside(self.numbers[path])
    }

    /// Moves from the face on the left of a half-edge to that on the right, or back.
    fn cross(&mut self, segments: &Segments, edges: &Edges, half_edge: usize, back: bool) {
        for (path, number) in winding_changes(segments, edges, half_edge) {
            let before = usize::from(self.is_inside(path));
            self.numbers[path] += if back { number } else { -number };
            self.inside_count = self.inside_count + usize::from(self.is_inside(path)) - before;
        }
    }
}

/// The changes of winding numbers across a half-edge, with the index of the path: for each sub-segment of a path with an
/// interior, 1 if it runs in the direction of the half-edge and −1 otherwise.
fn winding_changes<'a>(
    segments: &'a Segments,
    edges: &'a Edges,
    half_edge: usize,
) -> impl Iterator<Item = (usize, i32)> + 'a {
    let members = edges.members(half_edge / 2).iter();
    members.filter_map(move |member| {
        let path = segments.list[member.sub_segment.segment].path;
        let along = member.forward == half_edge.is_multiple_of(2);
        (segments.roles[path] == Role::Region).then_some((path, if along { 1 } else { -1 }))
    })
}

/// Calls `enter` for each face with its winding numbers. Returns the edges beside which these contradict each other.
pub(super) fn visit_faces(
    segments: &Segments,
    edges: &Edges,
    faces: &Faces,
    rule: FillRule,
    mut enter: impl FnMut(usize, &Windings),
) -> Vec<usize> {
    let (starts, around) = half_edges_of_faces(faces);
    let mut windings = Windings {
        numbers: vec![0; segments.path_count],
        rule,
        inside_count: 0,
    };
    let mut sums: Vec<Option<u64>> = vec![None; faces.count];
    sums[faces.outside] = Some(0);
    enter(faces.outside, &windings);
    // A depth-first search without recursion. For each face on the stack, the next of its half-edges and the half-edge
    // across which it was entered.
    let mut stack = vec![(faces.outside, starts[faces.outside], None)];
    while let Some((face, next, from)) = stack.pop() {
        // All neighbours are visited: back across the half-edge by which the face was entered.
        if next == starts[face + 1] {
            if let Some(h) = from {
                windings.cross(segments, edges, h, true);
            }
            continue;
        }
        stack.push((face, next + 1, from));
        let h = around[next];
        let beyond = faces.left[h ^ 1];
        if sums[beyond].is_none() {
            windings.cross(segments, edges, h, false);
            let change = checksum(segments, edges, h);
            sums[beyond] = sums[face].map(|sum| sum.wrapping_sub(change));
            enter(beyond, &windings);
            stack.push((beyond, starts[beyond], Some(h)));
        }
    }
    // The search crosses only some edges; at each of the others the sums on both sides have to differ by its change, too.
    let contradicts = |e: &usize| {
        let [left, right] = [2 * e, 2 * e + 1].map(|h| sums[faces.left[h]].unwrap_or(0));
        left.wrapping_sub(right) != checksum(segments, edges, 2 * e)
    };
    (0..edges.list.len()).filter(contradicts).collect()
}

/// The half-edges of face f on whose left it lies are those from `starts[f]` to `starts[f + 1]`.
fn half_edges_of_faces(faces: &Faces) -> (Vec<usize>, Vec<usize>) {
    let mut starts = vec![0; faces.count + 1];
    for &face in &faces.left {
        starts[face + 1] += 1;
    }
    for face in 0..faces.count {
        starts[face + 1] += starts[face];
    }
    let mut next = starts.clone();
    let mut around = vec![0; faces.left.len()];
    for (h, &face) in faces.left.iter().enumerate() {
        around[next[face]] = h;
        next[face] += 1;
    }
    (starts, around)
}

/// A linear function of the changes of all winding numbers across a half-edge, different for different changes with
/// overwhelming probability: each path has a large odd factor.
fn checksum(segments: &Segments, edges: &Edges, half_edge: usize) -> u64 {
    winding_changes(segments, edges, half_edge).fold(0, |sum: u64, (path, number)| {
        let factor = split_mix(path as u64) | 1;
        sum.wrapping_add(factor.wrapping_mul(number as i64 as u64))
    })
}

/// The output function of the generator SplitMix64. Source: Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators" (2014).
fn split_mix(k: u64) -> u64 {
    let mut z = k.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}
