//! Seeded random numbers.

use glam::DVec3;

/// SplitMix64 (Steele, Lea and Flood, 2014): the same numbers on every machine.
#[derive(Clone, Debug)]
pub struct Rng(pub u64);

impl Rng {
    /// A generator for one case: its state depends on the seed, the function's name and the number alone.
    pub fn for_case(seed: u64, name: &str, number: u64) -> Self {
        // FNV-1a of the name; SplitMix64 scrambles the sum.
        let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
        let mut rng = Self(hash ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let start = rng
            .next()
            .wrapping_add(number.wrapping_mul(0xd134_2543_de82_ef95));
        let mut rng = Self(start);
        rng.next();
        rng
    }

    /// 64 random bits.
    #[allow(
        clippy::should_implement_trait,
        reason = "the usual name; this is no iterator"
    )]
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number in [−1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A whole number below `n`.
    ///
    /// # Panics
    /// For `n` = 0.
    pub fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.next() % n as u64).expect("below n")
    }

    /// One of the items.
    pub fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    /// True with a probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// 1 or −1.
    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }

    /// 10 to a power between these, evenly distributed by the power.
    pub fn magnitude(&mut self, min: f64, max: f64) -> f64 {
        10_f64.powf(min + self.unit() * (max - min))
    }

    /// A point of the cube [−1, 1]³, or of the square where `dimension` is 2.
    pub fn point(&mut self, dimension: usize) -> DVec3 {
        let (x, y, z) = (self.signed(), self.signed(), self.signed());
        DVec3::new(x, y, if dimension == 3 { z } else { 0.0 })
    }

    /// 16 random bits.
    pub fn bits16(&mut self) -> u16 {
        let [low, high, ..] = self.next().to_le_bytes();
        u16::from_le_bytes([low, high])
    }

    /// Any character.
    pub fn character(&mut self) -> char {
        let last = u32::from(char::MAX) as usize;
        let code = u32::try_from(self.below(last + 1)).unwrap_or_default();
        char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER) // for surrogates
    }
}

/// A small whole number as f64.
pub fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).expect("a small number"))
}
