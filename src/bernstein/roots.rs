//! The real roots in (0, 1) of a polynomial in Bernstein form.
//!
//! A polynomial with the Bernstein coefficients b₀ … bₙ has at most as many roots in (0, 1) as the b change sign
//! (Descartes' rule in Bernstein form), and none if they do not. So: cut in half until a piece has one change and is
//! monotone, then close in on that root. Halving never adds changes, and ends at the spacing of numbers near 1, so at most
//! n · 52 pieces are looked at, whatever the coefficients. Source: Lane and Riesenfeld, "Bounds on a polynomial", BIT 21
//! (1981).
//!
//! That finds every change of sign. Where a polynomial only touches zero, or all but touches it, the answer lies in the
//! rounding of its coefficients; what counts as zero is then the caller's to say, as a height below which values are
//! `slack`. Between two neighbours among the ends and the extrema a polynomial is monotone, so their heights tell all
//! ([`contacts`], [`crossings`]).

use crate::numeric::float::ratio;
use crate::numeric::list::Scalars;
use casteljau_kernels::WorkLimit;

/// Below this width an interval counts as one parameter: a root of even multiplicity, or several that rounding
/// cannot tell apart.
const SMALLEST_INTERVAL: f64 = f64::EPSILON;

/// The roots strictly inside (0, 1), sorted, each once. Of the zero polynomial: none.
///
/// Each change of sign is there; a touch of zero is there where the coefficients show it. Use [`crossings`] or
/// [`contacts`] where that makes a difference.
pub(crate) fn roots_inside(coefficients: &[f64]) -> Scalars {
    let mut roots = Scalars::new();
    let Some((scaled, _)) = scaled(coefficients) else {
        return roots;
    };
    match *scaled {
        [_] => {}
        [a, b] => push_inside(&mut roots, a / (a - b)),
        [a, b, c] => quadratic(&mut roots, a, b, c),
        _ => isolate(&scaled, &mut roots),
    }
    roots
}

/// The coefficients with the largest made ±1, and what it was; `None` if all are zero.
fn scaled(coefficients: &[f64]) -> Option<(Scalars, f64)> {
    let size = coefficients.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    (size > 0.0).then(|| (coefficients.iter().map(|c| c / size).collect(), size))
}

/// The parameters inside (0, 1) where the sign changes from beyond ±`slack` to beyond the other, sorted.
pub(crate) fn crossings(coefficients: &[f64], slack: f64) -> Scalars {
    let mut roots = Scalars::new();
    walk(coefficients, slack, |crossing| {
        // A root next to an end may round to it.
        if let ZeroCrossing::Cross(t) = crossing
            && t > 0.0
            && t < 1.0
        {
            roots.push(t);
        }
    });
    roots
}

/// All parameters in [0, 1] where the polynomial is zero or comes within `slack` of it, sorted: changes of sign, touches
/// once each, ends. `None` where it is within `slack` everywhere.
pub(crate) fn contacts(coefficients: &[f64], slack: f64) -> Option<Scalars> {
    let mut roots = Scalars::new();
    let mut everywhere = false;
    walk(coefficients, slack, |crossing| match crossing {
        ZeroCrossing::Cross(t) | ZeroCrossing::Touch(t) => roots.push(t),
        ZeroCrossing::Everywhere => everywhere = true,
    });
    (!everywhere).then_some(roots)
}

/// How a polynomial meets zero.
enum ZeroCrossing {
    /// It changes its sign, inside (0, 1).
    Cross(f64),
    /// It comes to zero and turns back, or begins or ends there.
    Touch(f64),
    /// It never leaves zero.
    Everywhere,
}

/// Goes through the ends and the extrema; between them the polynomial is monotone.
fn walk(coefficients: &[f64], slack: f64, mut report: impl FnMut(ZeroCrossing)) {
    let Some((coefficients, size)) = scaled(coefficients) else {
        return report(ZeroCrossing::Everywhere);
    };
    let (polynomial, slack) = (Polynomial::new(&coefficients), slack / size);
    let slopes: Scalars = coefficients.windows(2).map(|p| p[1] - p[0]).collect();
    let mut stops = roots_inside(&slopes);
    stops.push(1.0);
    // The last stop off zero, with its height; the lowest stop at zero since then, with its height.
    let (mut off, mut at) = (None, None);
    let mut stop = |t: f64, height: f64| {
        if height.abs() <= slack {
            let lowest = at.get_or_insert((t, height));
            if height.abs() < lowest.1.abs() {
                *lowest = (t, height);
            }
            return;
        }
        match (off, at) {
            (Some((before, old)), _) if (old < 0.0) != (height < 0.0) => {
                report(ZeroCrossing::Cross(polynomial.close_in(before, t, old)));
            }
            (Some(_), Some((lowest, _))) => report(ZeroCrossing::Touch(lowest)),
            (None, Some(_)) => report(ZeroCrossing::Touch(0.0)),
            _ => {}
        }
        (off, at) = (Some((t, height)), None);
    };
    stop(0.0, coefficients[0]);
    for t in stops {
        stop(t, polynomial.at(t));
    }
    match (off, at) {
        (Some(_), Some(_)) => report(ZeroCrossing::Touch(1.0)),
        (None, _) => report(ZeroCrossing::Everywhere),
        _ => {}
    }
}

fn push_inside(roots: &mut Scalars, t: f64) {
    if t > 0.0 && t < 1.0 && roots.last().is_none_or(|&last| last < t) {
        roots.push(t);
    }
}

/// a(1−t)² + 2b(1−t)t + ct²: with r = t/(1−t) it is a + 2br + cr², solved without cancellation.
fn quadratic(roots: &mut Scalars, a: f64, b: f64, c: f64) {
    let discriminant = discriminant(a, b, c);
    if discriminant < 0.0 {
        return;
    }
    let q = -(b + discriminant.sqrt().copysign(b));
    // r₁ = q/c and r₂ = a/q, as t = r/(1+r).
    let (t1, t2) = if q == 0.0 {
        (f64::NAN, f64::NAN)
    } else {
        (q / (c + q), a / (q + a))
    };
    push_inside(roots, t1.min(t2));
    push_inside(roots, t1.max(t2));
}

/// b² − ac with the rounding errors of both products, after Kahan.
pub(crate) fn discriminant(a: f64, b: f64, c: f64) -> f64 {
    let (square, product) = (b * b, a * c);
    square - product + (error_of_product(b, b, square) - error_of_product(a, c, product))
}

/// The rounding error a·b − fl(a·b), exactly, by splitting the factors (Dekker); wasm has no fused multiply-add.
fn error_of_product(a: f64, b: f64, product: f64) -> f64 {
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2
}

/// The upper and the lower 26 bits.
fn halves(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a; // 2²⁷ + 1
    let upper = c - (c - a);
    (upper, a - upper)
}

/// Halves pieces until each has no change of sign, or one and is monotone. The pieces still to do lie one after the other in a list,
/// the leftmost last.
fn isolate(coefficients: &[f64], roots: &mut Scalars) {
    let polynomial = Polynomial::new(coefficients);
    let count = coefficients.len();
    let mut pieces = coefficients.to_vec();
    let mut spans = vec![(0.0, 1.0)];
    // At most one piece for each change of sign is halved, at each of 53 widths.
    let mut work = WorkLimit::new(2 * 53 * count);
    while let Some((lo, hi)) = spans.pop() {
        let from = pieces.len() - count;
        let piece = &pieces[from..];
        if piece[0] == 0.0 {
            push_inside(roots, lo);
        }
        let (changes, sign) = sign_changes(piece);
        // Where the piece is monotone too, rounding can mislead about the sign only at the root itself.
        let plain = changes == 0 || changes == 1 && monotone(piece);
        if !work.spend(1) || plain || hi - lo <= SMALLEST_INTERVAL {
            if changes == 1 {
                push_inside(roots, polynomial.close_in(lo, hi, sign));
            } else if changes > 1 {
                push_inside(roots, 0.5 * (lo + hi));
            }
            pieces.truncate(from);
            continue;
        }
        pieces.extend_from_within(from..);
        let (right, left) = pieces[from..].split_at_mut(count);
        halve(left, right);
        let mid = 0.5 * (lo + hi);
        spans.extend([(mid, hi), (lo, mid)]);
    }
}

fn monotone(coefficients: &[f64]) -> bool {
    let mut pairs = coefficients.windows(2);
    pairs.clone().all(|p| p[0] <= p[1]) || pairs.all(|p| p[0] >= p[1])
}

/// The halves of a piece, which `right` holds before.
fn halve(left: &mut [f64], right: &mut [f64]) {
    for last in (0..right.len()).rev() {
        left[right.len() - 1 - last] = right[0];
        for i in 0..last {
            right[i] = 0.5 * (right[i] + right[i + 1]);
        }
    }
}

/// The number of changes of sign, zeros left out, and the first sign.
pub(crate) fn sign_changes(coefficients: &[f64]) -> (usize, f64) {
    let (mut changes, mut first, mut last) = (0, 0.0, 0.0);
    for &c in coefficients.iter().filter(|&&c| c != 0.0) {
        if first == 0.0 {
            first = c;
        }
        changes += usize::from(last != 0.0 && (c < 0.0) != (last < 0.0));
        last = c;
    }
    (changes, first)
}

/// Σ C(n, i) bᵢ tⁱ (1 − t)ⁿ⁻ⁱ with the binomials multiplied in, which is evaluated in n steps.
struct Polynomial(Scalars);

impl Polynomial {
    fn new(coefficients: &[f64]) -> Self {
        let n = coefficients.len() - 1;
        let mut binomial = 1.0;
        let weigh = |(i, b): (usize, &f64)| {
            let weighted = b * binomial;
            binomial *= ratio(n - i, i + 1);
            weighted
        };
        Self(coefficients.iter().enumerate().map(weigh).collect())
    }

    /// The value at t, by Horner's rule in t/(1 − t) or its inverse, whichever is at most 1: as exact as de Casteljau's
    /// algorithm. Source: Schumaker and Volk, "Efficient evaluation of multivariate polynomials", CAGD 3 (1986).
    fn at(&self, t: f64) -> f64 {
        let s = 1.0 - t;
        let (large, ratio) = if s < t { (t, s / t) } else { (s, t / s) };
        let step = |sum: f64, c: &f64| sum * ratio + c;
        let sum = if s < t {
            self.0.iter().fold(0.0, step)
        } else {
            self.0.iter().rev().fold(0.0, step)
        };
        (1..self.0.len()).fold(sum, |value, _| value * large)
    }

    /// The one root in (lo, hi), where the sign is that of `before` at lo: bisection, sped up by regula falsi (Illinois).
    fn close_in(&self, mut lo: f64, mut hi: f64, before: f64) -> f64 {
        let sign = 1.0_f64.copysign(before);
        let (mut f_lo, mut f_hi) = (sign * self.at(lo), sign * self.at(hi));
        let mut side = 0;
        for step in 0..200 {
            let mid = 0.5 * (lo + hi);
            if mid <= lo || mid >= hi {
                break;
            }
            // Every third step bisects, so that the interval is sure to shrink.
            let secant = lo + (hi - lo) * f_lo / (f_lo - f_hi);
            let t = if step % 3 == 2 || !(secant > lo && secant < hi) {
                mid
            } else {
                secant
            };
            let f = sign * self.at(t);
            if f == 0.0 {
                return t;
            }
            if f > 0.0 {
                (lo, f_lo) = (t, f);
                f_hi *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (hi, f_hi) = (t, f);
                f_lo *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        0.5 * (lo + hi)
    }
}
