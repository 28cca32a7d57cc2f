/// De Casteljau's algorithm with 32-bit numbers.
fn by_means(values: &[f32], t: f32) -> f32 {
    let s = 1.0 - t;
    let mut row = values.to_vec();
    while row.len() > 1 {
        row = row.windows(2).map(|w| s * w[0] + t * w[1]).collect();
    }
    row[0]
}

/// The coefficients of the powers of t: repeated differences times binomial coefficients.
fn powers(values: &[f32]) -> Vec<f32> {
    let degree = values.len() - 1;
    let mut row = values.to_vec();
    let mut binomial = 1;
    (0..=degree)
        .map(|i| {
            let coefficient = binomial as f32 * row[0];
            row = row.windows(2).map(|w| w[1] - w[0]).collect();
            binomial = binomial * (degree - i) / (i + 1);
            coefficient
        })
        .collect()
}

fn by_powers(values: &[f32], t: f32) -> f32 {
    let coefficients = powers(values);
    coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c)
}

pub(crate) fn sample(out: &mut String) {
    // All control values lie between 0 and 1, so the result must, too.
    for degree in [3_u8, 8, 16] {
        let values: Vec<f32> = (0..=degree).map(|i| f32::from(i % 2)).collect();
        let (a, b) = (by_means(&values, 0.9), by_powers(&values, 0.9));
        writeln!(out, "degree {degree}: means {a:.5}, powers {b:.5}");
    }
}
