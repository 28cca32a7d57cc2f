//! Control nets for the tests of surfaces: random nets, and nets of known polynomials.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test file compiles this module for itself and uses a part of it"
)]

use casteljau::{Patch, glam::DVec3};

/// A small random number generator (splitmix64), so that the same tests run natively and in wasm.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In −1 … 1, often on a coarse grid, so that coincident and collinear points occur.
    pub fn coordinate(&mut self) -> f64 {
        let x = 2.0 * self.unit() - 1.0;
        if self.bits().is_multiple_of(4) {
            x.round()
        } else {
            x
        }
    }

    pub fn point(&mut self) -> DVec3 {
        DVec3::new(self.coordinate(), self.coordinate(), self.coordinate())
    }

    pub fn net(&mut self, degree_u: usize, degree_v: usize) -> Vec<DVec3> {
        (0..(degree_u + 1) * (degree_v + 1))
            .map(|_| self.point())
            .collect()
    }

    pub fn patch(&mut self, degree_u: usize, degree_v: usize) -> Patch {
        Patch::new(&self.net(degree_u, degree_v), degree_u, degree_v).unwrap()
    }
}

/// C(n, k).
pub fn choose(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, i| c * (n - i.min(n)) as f64 / (i + 1) as f64)
}

/// The patch (u, v, f) where f is a sum of monomials c·uᵃ·vᵇ: the Bernstein coefficient i of tᵃ is C(i, a) / C(n, a).
pub fn graph(degree_u: usize, degree_v: usize, monomials: &[(f64, usize, usize)]) -> Patch {
    let coefficient = |n: usize, i: usize, a: usize| choose(i, a) / choose(n, a);
    let mut net = Vec::new();
    for j in 0..=degree_v {
        for i in 0..=degree_u {
            let height = monomials
                .iter()
                .map(|&(c, a, b)| c * coefficient(degree_u, i, a) * coefficient(degree_v, j, b));
            net.push(DVec3::new(
                i as f64 / degree_u as f64,
                j as f64 / degree_v as f64,
                height.sum(),
            ));
        }
    }
    Patch::new(&net, degree_u, degree_v).unwrap()
}

/// Asserts that two points are within `tolerance` of each other.
#[track_caller]
pub fn assert_near(a: DVec3, b: DVec3, tolerance: f64) {
    let distance = (a - b).length();
    assert!(distance <= tolerance, "{a} and {b} are {distance:e} apart");
}
