//! Moments of the region swept by a plane curve: area, centre of mass, inertia.

use super::Curve;
use crate::bernstein::evaluate::evaluate;
use crate::geometry::check::max_abs;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use casteljau_kernels::numeric::gauss::{GAUSS_8, GAUSS_16, GAUSS_32};
use casteljau_kernels::numeric::trigonometry::cos_sin;
use glam::DVec2;
use std::f64::consts::PI;

/// Integrals over the region that the segment from the origin to B(t) sweeps as t goes from 0 to 1. Counter-clockwise
/// sweeps (x right, y up) count as positive.
///
/// The moments of consecutive curves add up; over a closed outline the sum is the integral over the enclosed region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Moments {
    /// ∬ 1, the area.
    pub area: f64,
    /// ∬ x; divided by the area it is the x of the centre of mass.
    pub x: f64,
    /// ∬ y.
    pub y: f64,
    /// ∬ x².
    pub xx: f64,
    /// ∬ xy.
    pub xy: f64,
    /// ∬ y².
    pub yy: f64,
}

impl Moments {
    /// The moments of the region scaled by a factor.
    pub(crate) fn enlarged(self, factor: f64) -> Self {
        // One multiplication after the other, because the power may overflow: each factor is finite, and 0 stays 0.
        let scaled =
            |value: f64, power: usize| (0..power).fold(value, |product, _| product * factor);
        Self {
            area: scaled(self.area, 2),
            x: scaled(self.x, 3),
            y: scaled(self.y, 3),
            xx: scaled(self.xx, 4),
            xy: scaled(self.xy, 4),
            yy: scaled(self.yy, 4),
        }
    }
}

impl std::ops::AddAssign for Moments {
    fn add_assign(&mut self, other: Self) {
        self.area += other.area;
        self.x += other.x;
        self.y += other.y;
        self.xx += other.xx;
        self.xy += other.xy;
        self.yy += other.yy;
    }
}

impl Curve<DVec2> {
    /// Area, first and second moments of the region that the segment from the origin to B(t) sweeps.
    ///
    /// See [`Moments`]. Exact up to rounding at any degree; zero for a point, and for a line through the origin.
    /// Source: Green's theorem for homogeneous functions f of degree k: ∬ f = 1/(k + 2) ∫ f(B) (x dy − y dx).
    pub fn moments(&self) -> Moments {
        moments(&self.points)
    }
}

/// The moments of one curve with the given control points (at least two).
///
/// By Green's theorem ∬ f = 1/(k + 2) ∫ f(B) (x dy − y dx) for a homogeneous f of degree k. The integrand is a
/// polynomial of degree 4n − 2, for which a Gauss–Legendre rule of 2n points is exact. Results beyond the range of f64
/// are infinite or zero.
pub(crate) fn moments(points: &[DVec2]) -> Moments {
    let size = max_abs(points);
    if size == 0.0 {
        return Moments::default();
    }
    let unit: Points<DVec2> = points.iter().map(|&p| p / size).collect();
    let slopes: Points<DVec2> = unit.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut sum = Moments::default();
    let degree = slopes.len() as f64;
    for_each_node(2 * slopes.len(), |t, weight| {
        let p = evaluate(&unit, t);
        let swept = p.cross(evaluate(&slopes, t)) * (degree * weight);
        sum += Moments {
            area: swept / 2.0,
            x: swept * p.x / 3.0,
            y: swept * p.y / 3.0,
            xx: swept * p.x * p.x / 4.0,
            xy: swept * p.x * p.y / 4.0,
            yy: swept * p.y * p.y / 4.0,
        };
    });
    sum.enlarged(size)
}

/// Visits the nodes and weights on [0, 1] of a Gauss–Legendre rule of at least `count` points.
fn for_each_node(count: usize, mut visit: impl FnMut(f64, f64)) {
    let mut pairs = |nodes: &[f64], weights: &[f64]| {
        for (z, weight) in nodes.iter().zip(weights) {
            visit(0.5 - 0.5 * z, 0.5 * weight);
            visit(0.5 + 0.5 * z, 0.5 * weight);
        }
    };
    match count {
        0..=8 => pairs(&GAUSS_8.nodes, &GAUSS_8.weights),
        9..=16 => pairs(&GAUSS_16.nodes, &GAUSS_16.weights),
        17..=32 => pairs(&GAUSS_32.nodes, &GAUSS_32.weights),
        _ => {
            let (nodes, weights) = computed_rule(count);
            pairs(&nodes, &weights);
        }
    }
}

/// The positive half of a Gauss–Legendre rule of even count: Newton's method on the Legendre polynomial, started from
/// Tricomi's approximation.
fn computed_rule(count: usize) -> (Vec<f64>, Vec<f64>) {
    let n = count as f64;
    (1..=count / 2)
        .map(|i| {
            let (mut z, _) = cos_sin(PI * (i as f64 - 0.25) / (n + 0.5));
            let mut slope = 1.0;
            for _ in 0..6 {
                let (value, derivative) = legendre(count, z);
                slope = derivative;
                z -= value / derivative;
            }
            (z, 2.0 / ((1.0 - z * z) * slope * slope))
        })
        .unzip()
}

/// Pₙ(z) and Pₙ′(z) by the three-term recurrence.
fn legendre(n: usize, z: f64) -> (f64, f64) {
    let (mut before, mut last) = (1.0, z);
    for k in 2..=n {
        let k = k as f64;
        (before, last) = (last, ((2.0 * k - 1.0) * z * last - (k - 1.0) * before) / k);
    }
    (last, n as f64 * (z * last - before) / (z * z - 1.0))
}
