//! Ratios of integers and the spacing of f64.

/// i / n as f64; both are small counts.
#[inline]
pub(crate) fn ratio(i: usize, n: usize) -> f64 {
    i as f64 / n as f64
}

/// The distance from |x| to the next larger number; 0 for 0.
pub(crate) fn ulp(x: f64) -> f64 {
    let x = x.abs();
    if x == 0.0 {
        0.0
    } else {
        (x.next_up() - x)
            .min(x - x.next_down())
            .max(f64::MIN_POSITIVE * f64::EPSILON)
    }
}
