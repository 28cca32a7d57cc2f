//! Grid data that depend only on the counts: parameters, patch numbers, indices.

use glam::DVec3;

/// The repetitions of an index pattern: each level repeats everything before it `.0` times, with the vertex step `.1`.
pub type Repeats = [(usize, usize); 3];

/// (u, v) of each sample of a patch, repeated for every patch that `uvs` has room for.
pub fn fill_uvs(segments_u: usize, segments_v: usize, uvs: &mut [f32]) {
    let numbers = 2 * (segments_u + 1) * (segments_v + 1);
    let mut parts = uvs.chunks_exact_mut(numbers);
    let Some(first) = parts.next() else { return };
    for (iv, line) in first.chunks_exact_mut(2 * (segments_u + 1)).enumerate() {
        let v = parameter(iv, segments_v);
        for (iu, pair) in line.chunks_exact_mut(2).enumerate() {
            pair.copy_from_slice(&[parameter(iu, segments_u), v]);
        }
    }
    for part in parts {
        part.copy_from_slice(first);
    }
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "meshes have f32 coordinates"
)]
fn parameter(k: usize, segments: usize) -> f32 {
    (k as f64 / segments as f64) as f32
}

/// The patch number of each vertex, counted from `first`.
pub fn fill_patch_ids(first: u32, vertices: usize, ids: &mut [u32]) {
    for (id, part) in (first..).zip(ids.chunks_exact_mut(vertices)) {
        part.fill(id);
    }
}

macro_rules! fill_indices {
    ($name:ident, $T:ty) => {
        /// Repeats the pattern of length `cell` at the start of the list, level by level: the indices of each copy are
        /// larger by the step than those of the previous copy.
        pub fn $name(list: &mut [$T], cell: usize, repeats: Repeats) {
            let mut count = cell;
            for (times, step) in repeats {
                // Steps are below the number of vertices, for which the type was chosen.
                let step = <$T>::try_from(step).unwrap_or(0);
                for copy in 1..times {
                    let Some(two) = list.get_mut((copy - 1) * count..(copy + 1) * count) else {
                        return;
                    };
                    let (from, to) = two.split_at_mut(count);
                    for (to, from) in to.iter_mut().zip(from) {
                        *to = from.wrapping_add(step);
                    }
                }
                count *= times;
            }
        }
    };
}

fill_indices!(fill_indices_u16, u16);
fill_indices!(fill_indices_u32, u32);

/// Appends the coordinates of a vector.
#[inline(never)]
pub fn push_vector(numbers: &mut Vec<f64>, vector: DVec3) {
    numbers.extend_from_slice(&vector.to_array());
}

/// The nearest f32 of each number.
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounding to f32 is intended"
)]
#[inline(never)]
pub fn rounded(numbers: &[f64]) -> Vec<f32> {
    numbers.iter().map(|&number| number as f32).collect()
}

/// The lower 16 bits of each number.
#[allow(
    clippy::cast_possible_truncation,
    reason = "only the lower half is needed"
)]
#[inline(never)]
pub fn lower_halves(numbers: &[u32]) -> Vec<u16> {
    numbers.iter().map(|&number| number as u16).collect()
}

/// Copies the vertices with the given indices; an index out of range leaves its entry unchanged.
pub fn collect_points(vertices: &[DVec3], indices: &[u32], out: &mut [DVec3]) {
    for (out, &index) in out.iter_mut().zip(indices) {
        if let Some(vertex) = vertices.get(index as usize) {
            *out = *vertex;
        }
    }
}
