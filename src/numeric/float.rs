//! Counts and ratios of integers as f64, the spacing of f64, and scaling without rounding.

/// A count as f64; it is below 2⁵³.
#[inline]
pub(crate) fn as_f64(count: usize) -> f64 {
    count as f64
}

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

/// The power of two 2ᵏ for which |x|·2ᵏ is in [1, 2); multiplying by it does not round. 1 for 0.
///
/// k is limited so that 2ᵏ and 2⁻ᵏ are normal numbers: the product is below 4 for the largest numbers, and below 1 for
/// numbers that are not normal.
pub(crate) fn unit_scale(x: f64) -> f64 {
    if x == 0.0 {
        return 1.0;
    }
    let exponent = (x.abs().to_bits() >> 52).clamp(1, 2045);
    f64::from_bits((2046 - exponent) << 52)
}

/// The exponent e of a normal number x: |x| is from 2ᵉ to below 2ᵉ⁺¹.
#[cfg(feature = "nurbs")]
pub(crate) fn exponent(x: f64) -> i32 {
    i32::from((x.abs().to_bits() >> 52) as u16) - 1023
}

/// The whole part of t, at most `last` and at least 0, and the rest; NaN gives 0 and NaN.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "not negative, and clamped"
)]
pub(crate) fn whole_and_rest(t: f64, last: usize) -> (usize, f64) {
    let k = (t.floor().max(0.0) as usize).min(last);
    (k, t - k as f64)
}
