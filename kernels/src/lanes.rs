//! Four samples at a time: rounding to f32 and storing.

use wide::f32x4;

/// How many samples are evaluated together.
pub(crate) const LANES: usize = 4;

/// The nearest f32, 0 for −0: neighbours may come to a zero from different sides.
#[inline(always)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounding to f32 is what meshes are made of"
)]
pub(crate) fn round(number: f64) -> f32 {
    number as f32 + 0.0
}

/// Stores four points in a line from `at` on, and four in reverse as far from its end.
#[inline(always)]
pub(crate) fn store(near: [f32x4; 3], far: [f32x4; 3], at: usize, line: &mut [[f32; 3]]) {
    if let Some(out) = line.get_mut(at..at + LANES) {
        store_four(points(near), out);
    }
    let end = line.len() - at;
    if let Some(out) = line.get_mut(end.wrapping_sub(LANES)..end) {
        let [a, b, c, d] = points(far);
        store_four([d, c, b, a], out);
    }
}

/// Stores the first three lanes of each. The fourth one of a whole store is overwritten by the next.
#[inline(always)]
fn store_four(points: [[f32; 4]; LANES], out: &mut [[f32; 3]]) {
    if let Ok(out) = <&mut [f32; 3 * LANES]>::try_from(out.as_flattened_mut()) {
        out[..4].copy_from_slice(&points[0]);
        out[3..7].copy_from_slice(&points[1]);
        out[6..10].copy_from_slice(&points[2]);
        out[9..].copy_from_slice(&points[3][..3]);
    }
}

/// Four points from their coordinates; the fourth lane means nothing.
#[inline(always)]
fn points([x, y, z]: [f32x4; 3]) -> [[f32; 4]; LANES] {
    f32x4::transpose([x, y, z, z]).map(f32x4::to_array)
}

/// Runs `fill` on the line, or on a longer one where it has no room for as many points as are stored together.
#[inline(always)]
pub(crate) fn with_room<R>(line: &mut [[f32; 3]], fill: impl Fn(&mut [[f32; 3]]) -> R) -> R {
    if line.len() > LANES {
        return fill(line);
    }
    // Those from the end on lie behind the few that are wanted.
    let mut room = [[0.0; 3]; 2 * LANES];
    let result = fill(&mut room);
    for (to, from) in line.iter_mut().zip(room) {
        *to = from;
    }
    result
}
