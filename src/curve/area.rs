//! Signed area swept by a curve.

use super::Curve;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use glam::DVec2;

impl Curve<DVec2> {
    /// The signed area ½ ∫ (x dy − y dx) that the segment from the origin to B(t) sweeps.
    ///
    /// Counter-clockwise sweeps (x right, y up) count as positive. The result is exact up to rounding. The areas of
    /// consecutive curves add up; over a closed outline their sum is the enclosed area, whatever the origin. If the
    /// true value leaves the range of f64, the result is infinite or 0. Source: Green's theorem, with the integrals of
    /// products of Bernstein polynomials; Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD
    /// 29 (2012), §3.3.
    pub fn area(&self) -> f64 {
        self.area_xy()
    }
}

impl<P: Point> Curve<P> {
    /// [`area`](Curve::area) of the projection along z.
    pub(crate) fn area_xy(&self) -> f64 {
        let (start, end) = (self.start(), self.end());
        area_about(&self.points, start) + triangle_area(start, end)
    }
}

/// ½ a × b, the signed area of the triangle with the corners 0, a and b.
pub(crate) fn triangle_area<P: Point>(a: P, b: P) -> f64 {
    0.5 * a.to_2d().cross(b.to_2d())
}

/// The area that the segment from `centre` to B(t) sweeps.
///
/// Σ w (Pᵢ × Pⱼ) over i < j, with m = i + j and w = n (j − i) / (m (2n − m)) · C(n, i) C(n, j) / C(2n, m), which is ½ ∫
/// (Bᵢ Bⱼ′ − Bⱼ Bᵢ′) for Bernstein polynomials.
pub(crate) fn area_about<P: Point>(points: &[P], centre: P) -> f64 {
    let around: Points<DVec2> = points.iter().map(|&p| (p - centre).to_2d()).collect();
    let n = around.len() - 1;
    let known = WEIGHTS.get(n.wrapping_sub(1));
    let (mut sum, mut k) = (0.0, 0);
    for j in 1..=n {
        for i in 0..j {
            let weight = known.map_or_else(|| weight(n, i, j), |weights| weights[k]);
            sum += weight * around[i].cross(around[j]);
            k += 1;
        }
    }
    sum
}

/// The weights of lines, quadratics and cubics, in the order of [`area_about`].
const WEIGHTS: [&[f64]; 3] = [
    &[0.5],
    &[2.0 / 3.0 * 0.5, 1.0 / 6.0, 2.0 / 3.0 * 0.5],
    &[
        0.6 * 0.5,
        0.75 * 0.2,
        1.0 / 3.0 * 0.45,
        0.05,
        0.75 * 0.2,
        0.6 * 0.5,
    ],
];

/// The weight w of Pᵢ × Pⱼ for degree n.
fn weight(n: usize, i: usize, j: usize) -> f64 {
    let (m, binomial) = (i + j, crate::bernstein::weights::binomial);
    let share = binomial(n, i) * binomial(n, j) / binomial(2 * n, m);
    (n * (j - i)) as f64 / (m * (2 * n - m)) as f64 * share
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_weights_are_those_of_the_formula() {
        for (weights, n) in super::WEIGHTS.iter().zip(1..) {
            let pairs = (1..=n).flat_map(|j| (0..j).map(move |i| (i, j)));
            let expected: Vec<f64> = pairs.map(|(i, j)| super::weight(n, i, j)).collect();
            assert_eq!(*weights, expected, "degree {n}");
        }
    }
}
