//! What flattening asks of a curve: how far a piece deviates from its chord.

/// What the walk asks of a curve.
pub(crate) trait Deviation {
    /// Prepares for chords that start at `t`.
    fn start_at(&mut self, t: f64);
    /// (greatest distance of the piece from its chord / tolerance)², or a close upper bound, for a step `h`.
    fn squared(&mut self, h: f64) -> Fraction;
    /// About how long a step may be, a first idea being given (0 at the start).
    fn guess(&self, last: f64) -> f64;
    /// The first step to try where one of about `guess` is expected. It may be longer: a curve may bend away and come
    /// back to a chord that is much longer than the longest one that fails.
    fn first_try(&mut self, guess: f64, rest: f64) -> f64;
}

/// A number not yet divided: most chords are kept without its value.
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

/// (a/b)^¼, since the squared deviation grows with h⁴: near 1 its Padé approximant, else within reason. NaN, of an
/// overflow, shrinks.
#[inline]
pub(crate) fn fourth_root(a: f64, b: f64) -> f64 {
    if b > 0.25 * a && b < 4.0 * a {
        return (5.0 * a + 3.0 * b) / (3.0 * a + 5.0 * b);
    }
    let root = (a / b).sqrt().sqrt();
    if root > 0.01 { root.min(4.0) } else { 0.01 }
}
