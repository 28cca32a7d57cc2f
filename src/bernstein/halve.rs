//! Subdivision of polynomials over the unit square in Bernstein form.
#![allow(
    unreachable_pub,
    reason = "the wasm build compiles this file in another crate, src/wasm/fast"
)]

/// Splits a net of coefficients at ½ by de Casteljau's algorithm, along u (the fast index) or along v.
///
/// `left` holds the net. Afterwards `left` is the half before ½ and `right`, of the same length, the half after it.
pub fn halve_coefficients(left: &mut [f64], right: &mut [f64], columns: usize, along_u: bool) {
    right.copy_from_slice(left);
    if along_u {
        let rows = left.chunks_exact_mut(columns);
        for (left, right) in rows.zip(right.chunks_exact_mut(columns)) {
            halve_row(left, right);
        }
        return;
    }
    let rows = left.len() / columns;
    for (level, first) in left.chunks_exact_mut(columns).enumerate() {
        first.copy_from_slice(&right[..columns]);
        for row in 1..rows - level {
            let (below, above) = right.split_at_mut(row * columns);
            let below = &mut below[(row - 1) * columns..];
            for (a, b) in below.iter_mut().zip(&above[..columns]) {
                *a = 0.5 * (*a + *b);
            }
        }
    }
}

fn halve_row(left: &mut [f64], right: &mut [f64]) {
    let mut count = right.len();
    for first in left {
        *first = right[0];
        count -= 1;
        for i in 0..count {
            right[i] = 0.5 * (right[i] + right[i + 1]);
        }
    }
}
