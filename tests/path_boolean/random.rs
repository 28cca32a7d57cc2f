//! A generator of random numbers.

use casteljau::glam::DVec2;

/// The generator xorshift64*. Source: Vigna, "An experimental exploration of Marsaglia's xorshift generators" (2016).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number from 0 to 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// An integer below n.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.bits() >> 33).expect("31 bits") % n
    }

    /// An integer below n.
    pub(crate) fn integer(&mut self, n: i32) -> i32 {
        i32::try_from(self.below(usize::try_from(n).expect("not negative"))).expect("below n")
    }

    pub(crate) fn point(&mut self, size: f64) -> DVec2 {
        DVec2::new(self.between(-size, size), self.between(-size, size))
    }
}
