//! Polynomials over the unit square in Bernstein form: halving, and multiplication.

/// Halves a net of coefficients at ½ by de Casteljau's algorithm, along u (the fast index) or along v.
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

/// Adds to `product`, whose rows have `2 * columns − 1` numbers, the product of two nets that hold coefficients times
/// their binomials: such products add up where their indices do.
pub fn add_product(product: &mut [f64], left: &[f64], right: &[f64], columns: usize) {
    let wide = 2 * columns - 1;
    for (j, left) in left.chunks_exact(columns).enumerate() {
        for (l, right) in right.chunks_exact(columns).enumerate() {
            let row = &mut product[(j + l) * wide..][..wide];
            for (i, a) in left.iter().enumerate() {
                for (sum, b) in row[i..i + columns].iter_mut().zip(right) {
                    *sum += a * b;
                }
            }
        }
    }
}

/// Value, first and second derivative along each row of a net, given the Bernstein weights of the row's degree n and of
/// the degrees n − 1 and n − 2 at the parameter. Rows have at least three coefficients.
pub fn blend_row(row: &[f64], weights: [&[f64]; 3]) -> [f64; 3] {
    let n = (row.len() - 1) as f64;
    let [of_value, of_slope, of_bend] = weights;
    let value = row.iter().zip(of_value).map(|(c, w)| c * w).sum();
    let slope: f64 = row
        .windows(2)
        .zip(of_slope)
        .map(|(c, w)| (c[1] - c[0]) * w)
        .sum();
    let bend: f64 = row
        .windows(3)
        .zip(of_bend)
        .map(|(c, w)| (c[2] - c[1] - (c[1] - c[0])) * w)
        .sum();
    [value, n * slope, n * (n - 1.0) * bend]
}
