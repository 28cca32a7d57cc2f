//! Comparisons of numbers, and counts as u32.

/// The larger of two numbers; `f64::max` is a function call where NaN must be handled.
#[inline(always)]
pub fn larger<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The smaller of two numbers; the second one if one is NaN.
#[inline(always)]
pub fn smaller<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// The minimum and the maximum; NaN is ignored.
#[inline(always)]
pub fn range(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    numbers.fold(start, |(min, max), v| {
        (if v < min { v } else { min }, if v > max { v } else { max })
    })
}

/// A count or an index that the limits keep below 2³².
#[inline(always)]
pub fn to_u32(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
