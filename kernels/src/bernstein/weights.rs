//! Bernstein weights of a grid.

/// The weights of one degree at t = k/n, k = 0 … n: `degree` + 1 of them for each k.
///
/// C(d, i) sᵈ⁻ⁱ tⁱ with t = k/n and s = (n − k)/n, both computed by division, so that reversing i and k gives the same
/// bits.
pub fn weights(degree: usize, segments: usize) -> Vec<f64> {
    let mut all = Vec::with_capacity((degree + 1) * (segments + 1));
    for k in 0..=segments {
        let (t, s) = parameters(k, segments);
        all.extend((0..=degree).map(|i| power(s, degree - i) * power(t, i) * binomial(degree, i)));
    }
    all
}

/// The weights of degree 3 at t = k/n.
pub fn cubic(k: usize, segments: usize) -> [f64; 4] {
    let (t, s) = parameters(k, segments);
    [0, 1, 2, 3].map(|i| power(s, 3 - i) * power(t, i) * [1.0, 3.0, 3.0, 1.0][i])
}

/// The weights of degree 5 at t = k/n.
pub fn quintic(k: usize, segments: usize) -> [f64; 6] {
    let (t, s) = parameters(k, segments);
    let share = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0];
    [0, 1, 2, 3, 4, 5].map(|i| power(s, 5 - i) * power(t, i) * share[i])
}

fn parameters(k: usize, segments: usize) -> (f64, f64) {
    let n = segments as f64;
    (k as f64 / n, (segments - k) as f64 / n)
}

/// xᵉ by repeated multiplication.
#[inline(always)]
fn power(x: f64, exponent: usize) -> f64 {
    (0..exponent).fold(1.0, |product, _| product * x)
}

/// C(n, k), with the same bits for k and n − k.
pub fn binomial(n: usize, k: usize) -> f64 {
    (0..k.min(n - k)).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}
