//! The interface between flattening and the deviation of a curve from its chords.

/// The deviation of a segment of a curve from its chord.
pub(crate) trait Deviation {
    /// Prepares for chords that start at `t`.
    fn start_at(&mut self, t: f64);
    /// (maximum distance of the segment from its chord / tolerance)², or a close upper bound, for a step `h`.
    fn squared(&mut self, h: f64) -> Fraction;
    /// An estimate of the step length, from a first guess (0 at the start).
    fn guess(&self, last: f64) -> f64;
    /// The first step to try if a step of about `guess` is expected. It may be longer, because the error is not monotone
    /// in h: a curve may bend away and return, so that a long chord fits where shorter ones fail.
    fn first_try(&mut self, guess: f64, rest: f64) -> f64;
}

/// An undivided fraction: for most chords the comparison needs no division.
#[derive(Clone, Copy)]
pub(crate) struct Fraction {
    pub(crate) over: f64,
    pub(crate) under: f64,
}

impl Fraction {
    #[inline]
    pub(crate) fn bounded_by(self, bound: f64) -> bool {
        self.over <= bound * self.under
    }
}

/// (a/b)^¼, because the squared deviation grows with h⁴: near 1 by its Padé approximant, otherwise clamped to [0.01,
/// 4]. NaN, after an overflow, gives 0.01.
#[inline]
pub(crate) fn fourth_root(a: f64, b: f64) -> f64 {
    if b > 0.25 * a && b < 4.0 * a {
        return (5.0 * a + 3.0 * b) / (3.0 * a + 5.0 * b);
    }
    let root = (a / b).sqrt().sqrt();
    if root > 0.01 { root.min(4.0) } else { 0.01 }
}
