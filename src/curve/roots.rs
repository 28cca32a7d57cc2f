//! The real roots in (0, 1) of a polynomial in Bernstein form.
//!
//! A polynomial with the Bernstein coefficients b₀ … bₙ has at most as many roots in (0, 1) as the b change sign
//! (Descartes' rule in Bernstein form), and none if they do not. So: cut in half until a piece has one change, then
//! close in on that root. Source: Lane and Riesenfeld, "Bounds on a polynomial", BIT 21 (1981).

use super::{Scalars, evaluate_scalar};

/// Below this width an interval counts as one parameter: a root of even multiplicity, or several that rounding
/// cannot tell apart.
const SMALLEST_INTERVAL: f64 = f64::EPSILON;

/// The roots strictly inside (0, 1), sorted, each once. Of the zero polynomial: none.
pub(crate) fn roots_inside(coefficients: &[f64]) -> Scalars {
    let size = coefficients.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    let mut roots = Scalars::new();
    if size == 0.0 {
        return roots;
    }
    let scaled: Scalars = coefficients.iter().map(|c| c / size).collect();
    match *scaled {
        [a, b] => push_inside(&mut roots, a / (a - b)),
        [a, b, c] => quadratic(&mut roots, a, b, c),
        _ => isolate(&scaled, &scaled, 0.0, 1.0, &mut roots),
    }
    roots
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
fn discriminant(a: f64, b: f64, c: f64) -> f64 {
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

fn isolate(whole: &[f64], piece: &[f64], lo: f64, hi: f64, roots: &mut Scalars) {
    match sign_changes(piece) {
        0 => {}
        1 => push_inside(roots, refine(whole, lo, hi, first_sign(piece))),
        _ if hi - lo <= SMALLEST_INTERVAL => push_inside(roots, 0.5 * (lo + hi)),
        _ => {
            let (mut left, mut right) = (Scalars::from(piece), Scalars::from(piece));
            halve(piece, &mut left, &mut right);
            let mid = 0.5 * (lo + hi);
            isolate(whole, &left, lo, mid, roots);
            if right[0] == 0.0 {
                push_inside(roots, mid);
            }
            isolate(whole, &right, mid, hi, roots);
        }
    }
}

fn halve(piece: &[f64], left: &mut [f64], right: &mut [f64]) {
    for (level, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for i in 1..piece.len() - level {
            right[i - 1] = 0.5 * (right[i - 1] + right[i]);
        }
    }
}

/// The number of sign changes, zeros left out.
fn sign_changes(coefficients: &[f64]) -> usize {
    let signs: Scalars = coefficients
        .iter()
        .filter(|&&c| c != 0.0)
        .map(|c| c.signum())
        .collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

fn first_sign(coefficients: &[f64]) -> f64 {
    coefficients
        .iter()
        .find(|&&c| c != 0.0)
        .map_or(0.0, |c| c.signum())
}

/// The one root in (lo, hi), where the sign is `sign` before it: bisection, sped up by regula falsi (Illinois).
fn refine(whole: &[f64], mut lo: f64, mut hi: f64, sign: f64) -> f64 {
    let (mut f_lo, mut f_hi) = (
        sign * evaluate_scalar(whole, lo),
        sign * evaluate_scalar(whole, hi),
    );
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
        let f = sign * evaluate_scalar(whole, t);
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
