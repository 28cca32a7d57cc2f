//! Slow integrals along curves, by halving until nothing changes, with a quadrature rule computed here.

use casteljau::glam::DVec3;

/// Rounding of the derivative, relative to its largest control vector.
const ROUNDING: f64 = 1e-14;

/// ∫ f(t, |B′(t)|) dt over [lo, hi].
pub(crate) struct Along<'a> {
    /// Pᵢ₊₁ − Pᵢ.
    slopes: Vec<DVec3>,
    rule: Vec<(f64, f64)>,
    times: &'a dyn Fn(f64) -> f64,
    /// Differences of integrals below this are rounding errors.
    min: f64,
}

/// The arc length between two parameters.
pub(crate) fn length(points: &[DVec3], lo: f64, hi: f64) -> f64 {
    integral(points, (lo, hi), &|_| 1.0)
}

/// ∫ f(t) |B′(t)| dt.
pub(crate) fn integral(points: &[DVec3], (lo, hi): (f64, f64), times: &dyn Fn(f64) -> f64) -> f64 {
    let slopes: Vec<DVec3> = points.windows(2).map(|p| p[1] - p[0]).collect();
    let size = super::largest(&slopes);
    if size == 0.0 {
        return 0.0;
    }
    let slopes: Vec<DVec3> = slopes.iter().map(|&p| p / size).collect();
    let n = super::real(slopes.len());
    let mut along = Along {
        slopes,
        rule: rule(10),
        times,
        min: 0.0,
    };
    // A sum over equal steps gives the scale for negligible differences.
    let rough: f64 = (0..64)
        .map(|i| along.speed((super::real(i) + 0.5) / 64.0))
        .sum();
    along.min = rough / 64.0 * 1e-17;
    let whole = along.once(lo, hi);
    along.halved(lo, hi, whole, 0) * n * size
}

impl Along<'_> {
    fn speed(&self, t: f64) -> f64 {
        super::de_casteljau(&self.slopes, t).length()
    }

    fn once(&self, lo: f64, hi: f64) -> f64 {
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let value = |z: f64| {
            let t = middle + half * z;
            self.speed(t) * (self.times)(t)
        };
        half * self
            .rule
            .iter()
            .map(|&(z, w)| w * (value(z) + value(-z)))
            .sum::<f64>()
    }

    fn halved(&self, lo: f64, hi: f64, whole: f64, depth: usize) -> f64 {
        let middle = 0.5 * (lo + hi);
        let (left, right) = (self.once(lo, middle), self.once(middle, hi));
        let off = (left + right - whole).abs();
        let unseen = off <= self.min + if depth >= 8 { 1e-15 * whole.abs() } else { 0.0 };
        if depth >= 3 && (unseen && self.straight_enough(lo, hi) || depth >= 50) {
            return left + right;
        }
        let near_cusp = (depth >= 3).then(|| self.near_cusp(lo, hi)).flatten();
        let (cut, left, right) = near_cusp.map_or((middle, left, right), |cut| {
            (cut, self.once(lo, cut), self.once(cut, hi))
        });
        self.halved(lo, cut, left, depth + 1) + self.halved(cut, hi, right, depth + 1)
    }

    /// The parameter of the smallest of 16 speeds inside, improved by golden sections, if the speed is much larger at both
    /// ends: no rule converges quickly across a near-cusp.
    fn near_cusp(&self, lo: f64, hi: f64) -> Option<f64> {
        let at = |i: usize| lo + (hi - lo) * super::real(i) / 16.0;
        let speeds: Vec<f64> = (0..=16).map(|i| self.speed(at(i))).collect();
        let min = (1..16).min_by(|&i, &k| speeds[i].total_cmp(&speeds[k]))?;
        let slow = speeds[min] < 0.1 * speeds[0].min(speeds[16]);
        slow.then(|| self.minimum(at(min - 1), at(min + 1)))
    }

    /// The parameter of the minimum of the speed, by golden sections.
    fn minimum(&self, mut lo: f64, mut hi: f64) -> f64 {
        for _ in 0..90 {
            let (left, right) = (hi - 0.618 * (hi - lo), lo + 0.618 * (hi - lo));
            if self.speed(left) < self.speed(right) {
                hi = right;
            } else {
                lo = left;
            }
        }
        0.5 * (lo + hi)
    }

    /// The control vectors of the derivative between two parameters.
    fn part(&self, lo: f64, hi: f64) -> Vec<DVec3> {
        let mut row = self.slopes.clone();
        let n = row.len();
        for level in 1..n {
            for k in (level..n).rev() {
                row[k] = row[k - 1] * (1.0 - hi) + row[k] * hi;
            }
        }
        let from = if hi > 0.0 { lo / hi } else { 0.0 };
        for last in (1..n).rev() {
            for i in 0..last {
                row[i] = row[i] * (1.0 - from) + row[i + 1] * from;
            }
        }
        row
    }

    /// Whether no cusp and no turn is inside: the derivative's control vectors are in one half-space, up to rounding.
    fn straight_enough(&self, lo: f64, hi: f64) -> bool {
        let slopes = self.part(lo, hi);
        let largest = super::largest(&slopes);
        let sum: DVec3 = slopes.iter().sum();
        let direction = sum.normalize_or_zero();
        largest * (hi - lo) <= self.min || slopes.iter().all(|s| s.dot(direction) > -ROUNDING)
    }
}

/// The positive nodes and the weights of a Gauss–Legendre rule, by bisection of the Legendre polynomial.
fn rule(n: usize) -> Vec<(f64, f64)> {
    let legendre = |z: f64| {
        let (mut before, mut last) = (1.0, z);
        for k in 2..=n {
            let k = super::real(k);
            (before, last) = (last, ((2.0 * k - 1.0) * z * last - (k - 1.0) * before) / k);
        }
        (last, super::real(n) * (z * last - before) / (z * z - 1.0))
    };
    let steps = 1000;
    let mut pairs = Vec::new();
    for i in 0..steps {
        let (mut lo, mut hi) = (super::real(i) / 1000.0, super::real(i + 1) / 1000.0);
        let sign = legendre(lo).0;
        if hi < 1.0 && sign * legendre(hi).0 > 0.0 {
            continue;
        }
        if hi == 1.0 {
            break;
        }
        for _ in 0..60 {
            let middle = 0.5 * (lo + hi);
            if sign * legendre(middle).0 > 0.0 {
                lo = middle;
            } else {
                hi = middle;
            }
        }
        let slope = legendre(lo).1;
        pairs.push((lo, 2.0 / ((1.0 - lo * lo) * slope * slope)));
    }
    assert_eq!(pairs.len(), n / 2);
    pairs
}
