//! Control nets for the tests of surfaces: random nets, and nets of known polynomials.

use super::Rng;
use casteljau::{Patch, glam::DVec3};

/// Random control nets; coordinates are in −1 … 1, often on a coarse grid, so that coincident and collinear points occur.
pub(crate) trait RandomNet {
    fn coordinate(&mut self) -> f64;
    fn grid_point(&mut self) -> DVec3;
    fn net(&mut self, degree_u: usize, degree_v: usize) -> Vec<DVec3>;
    fn patch(&mut self, degree_u: usize, degree_v: usize) -> Patch;
}

impl RandomNet for Rng {
    fn coordinate(&mut self) -> f64 {
        let x = self.signed();
        if self.next().is_multiple_of(4) {
            x.round()
        } else {
            x
        }
    }

    fn grid_point(&mut self) -> DVec3 {
        DVec3::new(self.coordinate(), self.coordinate(), self.coordinate())
    }

    fn net(&mut self, degree_u: usize, degree_v: usize) -> Vec<DVec3> {
        let count = (degree_u + 1) * (degree_v + 1);
        (0..count).map(|_| self.grid_point()).collect()
    }

    fn patch(&mut self, degree_u: usize, degree_v: usize) -> Patch {
        Patch::new(&self.net(degree_u, degree_v), degree_u, degree_v).unwrap()
    }
}

/// C(n, k).
pub(crate) fn choose(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, i| c * (n - i.min(n)) as f64 / (i + 1) as f64)
}

/// The patch (u, v, f) where f is a sum of monomials c·uᵃ·vᵇ: the Bernstein coefficient i of tᵃ is C(i, a) / C(n, a).
pub(crate) fn graph(degree_u: usize, degree_v: usize, monomials: &[(f64, usize, usize)]) -> Patch {
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
pub(crate) fn assert_near(a: DVec3, b: DVec3, tolerance: f64) {
    let distance = (a - b).length();
    assert!(distance <= tolerance, "{a} and {b} are {distance:e} apart");
}
