//! Groups of four samples: rounding to f32 and storing.

use crate::numeric::lanes::f32x4;

/// Number of samples that are evaluated together.
pub(crate) const LANES: usize = 4;

/// The nearest f32, and 0 for −0, because adjacent patches may compute zeros with different signs.
#[inline(always)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "meshes have f32 coordinates"
)]
pub(crate) fn round(number: f64) -> f32 {
    number as f32 + 0.0
}

/// Stores four points at index `at`, and four in reversed order at the same distance from the end of the line.
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

/// Stores the first three lanes of each point. The fourth lane is overwritten by the next point.
#[inline(always)]
fn store_four(points: [[f32; 4]; LANES], out: &mut [[f32; 3]]) {
    if let Ok(out) = <&mut [f32; 3 * LANES]>::try_from(out.as_flattened_mut()) {
        out[..4].copy_from_slice(&points[0]);
        out[3..7].copy_from_slice(&points[1]);
        out[6..10].copy_from_slice(&points[2]);
        out[9..].copy_from_slice(&points[3][..3]);
    }
}

/// Four points from their coordinates; the fourth lane is unused.
#[inline(always)]
fn points([x, y, z]: [f32x4; 3]) -> [[f32; 4]; LANES] {
    f32x4::transpose([x, y, z, z]).map(f32x4::to_array)
}

/// Calls `fill` with the line, or with a longer buffer if the line has fewer points than are stored together.
#[inline(always)]
pub(crate) fn with_room<R>(line: &mut [[f32; 3]], fill: impl Fn(&mut [[f32; 3]]) -> R) -> R {
    if line.len() > LANES {
        return fill(line);
    }
    // The points that are stored from the end lie behind the few that are needed.
    let mut room = [[0.0; 3]; 2 * LANES];
    let result = fill(&mut room);
    for (to, from) in line.iter_mut().zip(room) {
        *to = from;
    }
    result
}
