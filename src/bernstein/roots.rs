//! Real roots in (0, 1) of a polynomial in Bernstein form.
//!
//! A polynomial with the Bernstein coefficients b₀ … bₙ has at most as many roots in (0, 1) as the bᵢ have sign changes
//! (Descartes' rule in Bernstein form), and none if there are no sign changes. The interval is halved until a part has
//! one sign change and is monotone; then the root is bracketed and refined. Halving never adds sign changes and ends at
//! the spacing of numbers near 1, so at most n · 52 intervals are processed, whatever the coefficients. Source: Lane
//! and Riesenfeld, "Bounds on a polynomial", BIT 21 (1981).
//!
//! This finds every sign change. Where a polynomial touches zero, or nearly does, the result depends on the rounding of
//! its coefficients. The caller then decides what counts as zero: values of at most `slack`. Between neighbouring
//! parameters among the ends and the extrema a polynomial is monotone, so the values at these parameters determine all
//! contacts ([`contacts`], [`crossings`]).

use crate::numeric::float::{ratio, unit_scale};
use crate::numeric::list::Scalars;
use casteljau_kernels::bernstein::de_casteljau::halve;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use casteljau_kernels::numeric::zero::regula_falsi;

/// An interval below this width counts as one parameter: it contains a root of even multiplicity, or several roots that
/// rounding cannot separate.
const SMALLEST_INTERVAL: f64 = f64::EPSILON;

/// The accuracy of a double root, about the square root of the rounding error: parameters closer than this are one root.
pub(crate) const DOUBLE_ROOT: f64 = 1e-7;

/// The roots strictly inside (0, 1), in ascending order, each once. The zero polynomial gives none.
///
/// Every sign change is included; a double root is included only if the coefficients show it. Use [`crossings`] or
/// [`contacts`] where that matters.
pub(crate) fn roots_inside(coefficients: &[f64]) -> Scalars {
    let mut roots = Scalars::new();
    match *coefficients {
        [_] => {}
        // t = a/(a − b), with halves so that the difference does not overflow.
        [a, b] => push_inside(&mut roots, 0.5 * a / (0.5 * a - 0.5 * b)),
        [a, b, c] => {
            for t in quadratic_roots([a, b, c]) {
                push_inside(&mut roots, t);
            }
        }
        _ => {
            if let Some((scaled, _)) = scaled(coefficients) {
                isolate(&scaled, &mut roots);
            }
        }
    }
    roots
}

/// The coefficients divided by the largest absolute value, and that value; `None` if all are zero.
fn scaled(coefficients: &[f64]) -> Option<(Scalars, f64)> {
    let size = max_of(coefficients);
    (size > 0.0).then(|| (coefficients.iter().map(|c| c / size).collect(), size))
}

/// The largest absolute value.
// Without inlining, bounds of cubics take 14 % longer.
#[cfg_attr(feature = "fast", inline)]
pub(crate) fn max_of(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |m: f64, c| m.max(c.abs()))
}

/// The parameters inside (0, 1) where the value changes from below −`slack` to above `slack` or the reverse, in
/// ascending order.
pub(crate) fn crossings(coefficients: &[f64], slack: f64) -> Scalars {
    if let [a, b, c] = *coefficients {
        return crossings_of_quadratic([a, b, c], slack);
    }
    let mut roots = Scalars::new();
    // The polynomial lies between its smallest and its largest coefficient.
    if coefficients.iter().all(|&c| c > slack) || coefficients.iter().all(|&c| c < -slack) {
        return roots;
    }
    visit_zeros(coefficients, slack, |crossing| {
        // A root next to an end may be rounded to it.
        if let ZeroCrossing::Cross(t) = crossing
            && t > 0.0
            && t < 1.0
        {
            roots.push(t);
        }
    });
    roots
}

/// All parameters in [0, 1] where the polynomial is zero or comes within `slack` of it, in ascending order: sign
/// changes, touches once each, ends. `None` if it is within `slack` everywhere.
pub(crate) fn contacts(coefficients: &[f64], slack: f64) -> Option<Scalars> {
    let mut roots = Scalars::new();
    let mut everywhere = false;
    visit_zeros(coefficients, slack, |crossing| match crossing {
        ZeroCrossing::Cross(t) | ZeroCrossing::Touch(t) => roots.push(t),
        ZeroCrossing::Everywhere => everywhere = true,
    });
    (!everywhere).then_some(roots)
}

/// A contact of a polynomial with zero.
enum ZeroCrossing {
    /// The sign changes, inside (0, 1).
    Cross(f64),
    /// The polynomial reaches zero and turns back, or begins or ends at zero.
    Touch(f64),
    /// The polynomial is zero everywhere.
    Everywhere,
}

/// Reports the zeros in order. Visits the ends and the extrema; between them the polynomial is monotone.
fn visit_zeros(coefficients: &[f64], slack: f64, mut report: impl FnMut(ZeroCrossing)) {
    let Some((coefficients, size)) = scaled(coefficients) else {
        return report(ZeroCrossing::Everywhere);
    };
    let (polynomial, slack) = (Polynomial::new(&coefficients), slack / size);
    let slopes: Scalars = coefficients.windows(2).map(|p| p[1] - p[0]).collect();
    let mut extrema = roots_inside(&slopes);
    extrema.push(1.0);
    // The last visited parameter with a non-zero value, and the value; the parameter with the smallest value since then
    // that counts as zero, and the value.
    let (mut last_nonzero, mut smallest) = (None, None);
    let mut visit = |t: f64, height: f64| {
        if height.abs() <= slack {
            let lowest = smallest.get_or_insert((t, height));
            if height.abs() < lowest.1.abs() {
                *lowest = (t, height);
            }
            return;
        }
        match (last_nonzero, smallest) {
            // Values between these two that count as zero belong to the crossing.
            (Some((before, old)), _) if (old < 0.0) != (height < 0.0) => {
                report(ZeroCrossing::Cross(polynomial.refine_root(before, t, old)));
            }
            (Some(_), Some((lowest, _))) => report(ZeroCrossing::Touch(lowest)),
            // All values since t = 0 count as zero: the contact is the end.
            (None, Some(_)) => report(ZeroCrossing::Touch(0.0)),
            _ => {}
        }
        (last_nonzero, smallest) = (Some((t, height)), None);
    };
    visit(0.0, coefficients[0]);
    for t in extrema {
        visit(t, polynomial.at(t));
    }
    match (last_nonzero, smallest) {
        (Some(_), Some(_)) => report(ZeroCrossing::Touch(1.0)),
        (None, _) => report(ZeroCrossing::Everywhere),
        _ => {}
    }
}

fn push_inside(roots: &mut Scalars, t: f64) {
    // NaN fails the comparisons; equal roots are added once.
    if t > 0.0 && t < 1.0 && roots.last().is_none_or(|&last| last < t) {
        roots.push(t);
    }
}

/// [`crossings`] of a polynomial of degree 2: between its ends and its extremum it is monotone.
pub(crate) fn crossings_of_quadratic(coefficients: [f64; 3], slack: f64) -> Scalars {
    let mut crossings = Scalars::new();
    let [a, b, c] = coefficients;
    // The polynomial lies between its smallest and its largest coefficient.
    if a.min(b).min(c) > slack || a.max(b).max(c) < -slack {
        return crossings;
    }
    let scale = unit_scale(max_of(&coefficients));
    let [a, b, c] = coefficients.map(|x| x * scale);
    // The root of (b − a)(1 − t) + (c − b)t; it is infinite or NaN for a linear polynomial or a constant.
    let extremum = (a - b) / ((a - b) + (c - b));
    // Without an extremum the start is visited twice, which changes nothing.
    let mut visited = [[0.0, a], [0.0, a], [1.0, c]];
    if extremum > 0.0 && extremum < 1.0 {
        // There both steps of de Casteljau's algorithm give the same value.
        visited[1] = [extremum, a + (b - a) * extremum];
    }
    let mut nonzero = visited
        .into_iter()
        .filter(|[_, value]| value.abs() > slack * scale);
    let Some(mut before) = nonzero.next() else {
        return crossings;
    };
    let polynomial = || Polynomial([a, 2.0 * b, c].into_iter().collect());
    let roots = quadratic_roots([a, b, c]);
    for [t, value] in nonzero {
        let [from, old] = before;
        if (value < 0.0) != (old < 0.0) {
            let root = roots.into_iter().find(|root| (from..=t).contains(root));
            // Rounding may move the root of the formula out of its bracket.
            let root = root.unwrap_or_else(|| polynomial().refine_root(from, t, old));
            push_inside(&mut crossings, root);
        }
        before = [t, value];
    }
    crossings
}

/// The roots of a(1−t)² + 2b(1−t)t + ct² in ascending order, also those outside (0, 1); NaN where there is none.
///
/// With r = t/(1−t) it is proportional to a + 2br + cr², which is solved without cancellation.
// Without inlining, inflections of cubics take 11 % longer, but one copy is less code.
#[cfg_attr(feature = "fast", inline)]
#[cfg_attr(not(feature = "fast"), inline(never))]
pub(crate) fn quadratic_roots(coefficients: [f64; 3]) -> [f64; 2] {
    // Squares must not underflow.
    let scale = unit_scale(max_of(&coefficients));
    let [a, b, c] = coefficients.map(|x| x * scale);
    let discriminant = discriminant(a, b, c);
    let q = -(b + discriminant.sqrt().copysign(b));
    // r₁ = q/c and r₂ = a/q; converted by t = r/(1+r).
    let (t1, t2) = (q / (c + q), a / (q + a));
    // NaN compares as false.
    if t2 < t1 { [t2, t1] } else { [t1, t2] }
}

/// b² − ac, corrected by the rounding errors of both products (Kahan).
pub(crate) fn discriminant(a: f64, b: f64, c: f64) -> f64 {
    let (square, product) = (b * b, a * c);
    if product <= 0.0 {
        return square - product; // nothing cancels
    }
    square - product + (error_of_product(b, b, square) - error_of_product(a, c, product))
}

/// The exact rounding error a·b − fl(a·b), by splitting the factors (Dekker); wasm has no fused multiply-add.
fn error_of_product(a: f64, b: f64, product: f64) -> f64 {
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2
}

/// The upper and the lower 26 bits of the significand.
fn halves(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a; // 2²⁷ + 1
    let upper = c - (c - a);
    (upper, a - upper)
}

/// Halves intervals until each has no sign change, or one and is monotone. The pending intervals are stored one after
/// the other in a list, the leftmost last.
fn isolate(coefficients: &[f64], roots: &mut Scalars) {
    let polynomial = Polynomial::new(coefficients);
    let count = coefficients.len();
    let mut pieces = coefficients.to_vec();
    let mut spans = vec![(0.0, 1.0)];
    // For each sign change at most one interval is halved at each width down to an ulp of 1.
    let mut work = WorkLimit::new(2 * f64::MANTISSA_DIGITS as usize * count);
    while let Some((lo, hi)) = spans.pop() {
        let from = pieces.len() - count;
        let piece = &pieces[from..];
        // A root at a cut belongs to the interval that starts there; one at 0 is not inside.
        if piece[0] == 0.0 {
            push_inside(roots, lo);
        }
        let (changes, sign) = sign_changes(piece);
        // On a monotone interval, rounding can falsify the sign only at the root itself.
        let plain = changes == 0 || changes == 1 && is_monotone(piece);
        if !work.spend(1) || plain || hi - lo <= SMALLEST_INTERVAL {
            if changes == 1 {
                push_inside(roots, polynomial.refine_root(lo, hi, sign));
            } else if changes > 1 {
                push_inside(roots, 0.5 * (lo + hi));
            }
            pieces.truncate(from);
            continue;
        }
        // The right half replaces the whole, and the left half follows it, so that it is processed first.
        pieces.extend_from_within(from..);
        let (right, left) = pieces[from..].split_at_mut(count);
        halve(left, right);
        let mid = 0.5 * (lo + hi);
        spans.extend([(mid, hi), (lo, mid)]);
    }
}

fn is_monotone(coefficients: &[f64]) -> bool {
    let mut pairs = coefficients.windows(2);
    pairs.clone().all(|p| p[0] <= p[1]) || pairs.all(|p| p[0] >= p[1])
}

/// The number of sign changes, ignoring zeros, and the first non-zero coefficient.
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

/// Σ C(n, i) bᵢ tⁱ (1 − t)ⁿ⁻ⁱ with premultiplied binomial coefficients; an evaluation takes n steps.
struct Polynomial(Scalars);

impl Polynomial {
    fn new(coefficients: &[f64]) -> Self {
        let n = coefficients.len() - 1;
        let mut binomial = 1.0;
        let weigh = |(i, b): (usize, &f64)| {
            let weighted = b * binomial;
            // C(n, i + 1) = C(n, i) · (n − i)/(i + 1).
            binomial *= ratio(n - i, i + 1);
            weighted
        };
        Self(coefficients.iter().enumerate().map(weigh).collect())
    }

    /// The value at t, by Horner's rule in t/(1 − t) or its inverse, whichever is at most 1. It is as accurate as de
    /// Casteljau's algorithm. Source: Schumaker and Volk, "Efficient evaluation of multivariate polynomials", CAGD 3
    /// (1986).
    fn at(&self, t: f64) -> f64 {
        let s = 1.0 - t;
        let (large, ratio) = if s < t { (t, s / t) } else { (s, t / s) };
        let step = |sum: f64, c: &f64| sum * ratio + c;
        let sum = if s < t {
            self.0.iter().fold(0.0, step)
        } else {
            self.0.iter().rev().fold(0.0, step)
        };
        // The common factor tⁿ or (1 − t)ⁿ.
        (1..self.0.len()).fold(sum, |value, _| value * large)
    }

    /// The only root in (lo, hi), where the sign at lo is that of `before`.
    fn refine_root(&self, lo: f64, hi: f64, before: f64) -> f64 {
        if let [a, b, c] = *self.0 {
            // The middle coefficient contains the binomial coefficient 2.
            let mut roots = quadratic_roots([a, 0.5 * b, c]).into_iter();
            if let Some(root) = roots.find(|&t| lo <= t && t <= hi) {
                return root;
            }
        }
        // `regula_falsi` expects a positive value at lo.
        let sign = 1.0_f64.copysign(before);
        let value = |t: f64| sign * self.at(t);
        regula_falsi([lo, hi], [value(lo), value(hi)], 0.0, value)
    }
}
