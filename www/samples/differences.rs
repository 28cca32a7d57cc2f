pub(crate) fn sample(out: &mut String) {
    let cubic = |t: f64| 3.0 * t * (1.0 - t).powi(2) + 6.0 * t.powi(2) * (1.0 - t); // heights 0, 1, 2, 0
    let n = 8;
    // The first four values give the first value and its differences.
    let start = [0, 1, 2, 3].map(|i| cubic(f64::from(i) / f64::from(n)));
    let [mut f, mut d1, mut d2, d3] = differences(start);
    for i in 0..=n {
        writeln!(out, "{i}: {f:.6} {:.6}", cubic(f64::from(i) / f64::from(n)));
        (f, d1, d2) = (f + d1, d1 + d2, d2 + d3); // three additions a step
    }
}

fn differences([a, b, c, d]: [f64; 4]) -> [f64; 4] {
    [a, b - a, c - 2.0 * b + a, d - 3.0 * c + 3.0 * b - a]
}
