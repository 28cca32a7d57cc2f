//! What the tests of curves and splines share: random numbers, hostile curves, exact arithmetic to judge by.
#![allow(dead_code, reason = "each test binary uses a part of it")]

pub(crate) mod exact;
pub(crate) mod integral;
pub(crate) mod measure;
pub(crate) mod threads;
pub(crate) mod wild;

use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Point};

/// The plane or space, made from three coordinates.
pub(crate) trait Space: Point {
    fn of(p: DVec3) -> Self;
}

impl Space for DVec2 {
    fn of(p: DVec3) -> Self {
        p.truncate()
    }
}

impl Space for DVec3 {
    fn of(p: DVec3) -> Self {
        p
    }
}

pub(crate) fn curve<P: Space>(points: &[DVec3]) -> Curve<P> {
    let points: Vec<P> = points.iter().map(|&p| P::of(p)).collect();
    Curve::new(&points).expect("finite points")
}

/// A plane curve from pairs.
pub(crate) fn plane(points: &[(f64, f64)]) -> Curve<DVec2> {
    let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    Curve::new(&points).expect("finite points")
}

pub(crate) fn in_space<P: Point>(points: &[P]) -> Vec<DVec3> {
    points.iter().map(|p| p.in_space()).collect()
}

pub(crate) fn largest<P: Point>(points: &[P]) -> f64 {
    points.iter().map(|p| p.max_abs()).fold(0.0, f64::max)
}

/// The distance from |x| to the next larger number.
pub(crate) fn ulp(x: f64) -> f64 {
    let x = x.abs().min(f64::MAX.next_down());
    x.next_up() - x
}

/// The greatest difference of a coordinate.
pub(crate) fn apart<P: Point>(a: P, b: P) -> f64 {
    (a - b).max_abs()
}

pub(crate) fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).expect("a small number"))
}

/// The parameters that tests look at: even steps, the ends, and neighbours of the ends.
pub(crate) fn parameters(steps: usize) -> impl Iterator<Item = f64> {
    let even = (0..=steps).map(move |i| real(i) / real(steps));
    even.chain([1e-300, f64::EPSILON, 1e-9, 1.0 - 1e-9, 1.0_f64.next_down()])
}

/// SplitMix64 (Steele, Lea and Flood, 2014): the same numbers on every machine.
#[derive(Clone)]
pub(crate) struct Rng(pub(crate) u64);

impl Rng {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In [−1, 1).
    pub(crate) fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.next() % n as u64).expect("below n")
    }

    pub(crate) fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    pub(crate) fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// 10 to a power between these, evenly by the power.
    pub(crate) fn magnitude(&mut self, least: f64, most: f64) -> f64 {
        10_f64.powf(least + self.unit() * (most - least))
    }

    /// A point of the cube [−1, 1]³, or of the square where `dimension` is 2.
    pub(crate) fn point(&mut self, dimension: usize) -> DVec3 {
        let (x, y, z) = (self.signed(), self.signed(), self.signed());
        DVec3::new(x, y, if dimension == 3 { z } else { 0.0 })
    }
}
