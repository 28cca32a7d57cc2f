//! The source curve of an offset.

use crate::bernstein::de_casteljau::{keep_after, levels};
use glam::DVec2;

/// Maximum number of control points of a curve.
pub(super) const MAX_POINTS: usize = 65;

/// A curve prepared for evaluation of points and derivatives. Points are relative to its start.
pub struct Source {
    /// The control points, and the differences of neighbours, for a degree above 3.
    points: Vec<DVec2>,
    differences: Vec<DVec2>,
    count: usize,
    /// For a degree of at most 3, the Taylor coefficients at t = 0 in t, and at t = 1 in 1 − t: next to an end only the
    /// expansion at that end keeps the digits of short handles.
    powers: [[DVec2; 4]; 2],
    /// For a degree of at most 3, the control points of B′ as a quadratic.
    slopes: [DVec2; 3],
    /// A bound on the fourth derivative: 0 up to degree 3.
    fourth: f64,
    /// A bound on the length of the third derivative.
    third: f64,
    /// The largest |B′| of the hodograph's control points.
    speed: f64,
}

/// A sample of the curve: the parameter, the point, the first two derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub struct OffsetSample {
    pub t: f64,
    pub point: DVec2,
    /// B′.
    pub first: DVec2,
    /// B″.
    pub second: DVec2,
}

impl Source {
    /// Expects 2 to 65 control points of a size of about 1.
    pub fn new(control_points: &[DVec2]) -> Self {
        let count = control_points.len().clamp(1, MAX_POINTS);
        let mut all = [DVec2::default(); MAX_POINTS];
        for (p, &point) in all.iter_mut().zip(control_points) {
            *p = point;
        }
        let all = &all[..count];
        let difference = |i: usize| all[i + 1] - all[i];
        let n = count - 1;
        let square = (0..n).fold(0.0, |m: f64, i| m.max(difference(i).length_squared()));
        let mut source = Self {
            points: Vec::new(),
            differences: Vec::new(),
            count,
            powers: Default::default(),
            slopes: Default::default(),
            third: third_bound(all),
            fourth: fourth_bound(all),
            speed: n as f64 * square.sqrt(),
        };
        if count > 4 {
            source.points.extend(all.iter().map(|&p| p - all[0]));
            source.differences.extend((0..n).map(difference));
        } else if n > 0 {
            let mut e = [DVec2::default(); 3];
            e[..n]
                .iter_mut()
                .enumerate()
                .for_each(|(i, e)| *e = difference(i));
            let end = all[n] - all[0];
            source.powers = [
                powers(e, n, DVec2::default()),
                powers(reversed(e, n), n, end),
            ];
            // The control vectors n (Pᵢ₊₁ − Pᵢ), elevated to degree 2.
            source.slopes = match n {
                1 => [e[0]; 3],
                2 => [e[0] * 2.0, e[0] + e[1], e[1] * 2.0],
                _ => e.map(|e| e * 3.0),
            };
        }
        source
    }

    /// The largest |B′| that the control points allow.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// A bound on the length of the third derivative.
    pub fn third(&self) -> f64 {
        self.third
    }

    /// A bound on the length of the fourth derivative.
    pub fn fourth(&self) -> f64 {
        self.fourth
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.count - 1
    }

    /// The differences of neighbouring control points, for degrees above 3.
    pub fn differences(&self) -> &[DVec2] {
        &self.differences
    }

    /// The control points of B′ as a quadratic, up to degree 3.
    pub fn first_vectors(&self) -> [DVec2; 3] {
        self.slopes
    }

    /// The sample at t.
    #[inline]
    pub fn at(&self, t: f64) -> OffsetSample {
        if self.count > 4 {
            return self.at_by_casteljau(t);
        }
        // With respect to 1 − t, the first derivative has the opposite sign and the second one the same.
        let (side, sign, s) = if t <= 0.5 {
            (0, 1.0, t)
        } else {
            (1, -1.0, 1.0 - t)
        };
        let [c0, c1, c2, c3] = self.powers[side];
        let (d2, d3) = (c2 * 2.0, c3 * 3.0);
        OffsetSample {
            t,
            point: c0 + (c1 + (c2 + c3 * s) * s) * s,
            first: (c1 + (d2 + d3 * s) * s) * sign,
            second: d2 + d3 * (2.0 * s),
        }
    }

    /// The sample by de Casteljau's algorithm. Derivatives are computed from the differences, so that they keep their
    /// digits next to zero-length handles.
    fn at_by_casteljau(&self, t: f64) -> OffsetSample {
        let mut row = [DVec2::default(); MAX_POINTS];
        let mut slopes = row;
        row[..self.count].copy_from_slice(&self.points);
        slopes[..self.degree()].copy_from_slice(&self.differences);
        let s = 1.0 - t;
        let n = self.degree();
        keep_after(&mut row[..=n], t);
        // Two vectors remain: B′ is their interpolant, B″ their difference.
        levels(&mut slopes[..n], n - 2, t);
        let n = n as f64;
        OffsetSample {
            t,
            point: row[0],
            first: (slopes[0] * s + slopes[1] * t) * n,
            second: (slopes[1] - slopes[0]) * (n * (n - 1.0)),
        }
    }
}

/// The Taylor coefficients of a curve, computed from its start and the differences of its n + 1 control points.
fn powers(e: [DVec2; 3], n: usize, start: DVec2) -> [DVec2; 4] {
    // The binomial coefficients C(n, 2) and C(n, 3), times the second and the third difference.
    let second = (e[1] - e[0]) * [0.0, 0.0, 1.0, 3.0][n];
    let third = ((e[2] - e[1]) - (e[1] - e[0])) * if n == 3 { 1.0 } else { 0.0 };
    [start, e[0] * n as f64, second, third]
}

/// The differences of the reversed curve.
fn reversed(mut e: [DVec2; 3], n: usize) -> [DVec2; 3] {
    e[..n].reverse();
    e.map(|e| -e)
}

/// n(n−1)(n−2)(n−3) times the longest fourth difference.
pub fn fourth_bound(points: &[DVec2]) -> f64 {
    if points.len() < 5 {
        return 0.0;
    }
    let n = (points.len() - 1) as f64;
    let max = points.windows(5).fold(0.0, |m: f64, p| {
        m.max((p[0] + p[4] - (p[1] + p[3]) * 4.0 + p[2] * 6.0).length_squared())
    });
    n * (n - 1.0) * (n - 2.0) * (n - 3.0) * max.sqrt()
}

/// n(n−1)(n−2) times the longest third difference.
fn third_bound(points: &[DVec2]) -> f64 {
    if points.len() < 4 {
        return 0.0;
    }
    let n = (points.len() - 1) as f64;
    let max = points.windows(4).fold(0.0, |m: f64, p| {
        m.max(((p[3] - p[0]) + (p[1] - p[2]) * 3.0).length_squared())
    });
    n * (n - 1.0) * (n - 2.0) * max.sqrt()
}
