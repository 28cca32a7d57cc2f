//! Fat-line clipping: removal of the parts of a curve that cannot intersect another one.

use super::constants::WORTH_CLIPPING;
use super::piece::{Coefficients, Piece, Weights};
use crate::numeric::order::range;

/// Removes from `b` what is outside the fat line of `a`, the strip parallel to its chord that contains `a`. Returns the
/// remaining part, 1 for all; `None` if nothing remains.
#[inline(always)]
pub(super) fn clip<C: Coefficients, W: Weights<C>>(
    a: &Piece<C, W>,
    b: &mut Piece<C, W>,
    slack: f64,
) -> Option<f64> {
    let n = a.last();
    let [x0, y0] = a.point(0);
    let [mut dx, mut dy] = a.chord();
    if dx == 0.0 && dy == 0.0 {
        // A closed segment: any direction is valid; that of the first edge is likely to be a good one.
        [dx, dy] = a.edge(0);
        if dx == 0.0 && dy == 0.0 {
            dx = 1.0;
        }
    }
    // The signed distance from the line through point 0 along (dx, dy), times the length of (dx, dy).
    let side = |[x, y]: [f64; 2]| dx * (y - y0) - dy * (x - x0);
    let (min, max) = range((1..n + 1).map(|i| side(a.point(i))));
    let (min, max) = (min.min(0.0), max.max(0.0));
    // A change of both coordinates by the slack changes the side by at most this.
    let margin = slack * (dx.abs() + dy.abs());
    let mut sides = b.x.clone();
    let (bx, by) = (b.x.get(), b.y.get());
    // The side is linear in the point, so these are the Bernstein coefficients of the side of B(s).
    for (i, s) in sides.get_mut().iter_mut().enumerate() {
        *s = side([bx[i], by[i]]);
    }
    let strip = (min - margin, max + margin);
    let (lo, hi) = inside(sides.get(), &b.weights, strip)?;
    let remaining = hi - lo;
    if remaining <= WORTH_CLIPPING {
        let (lo, hi) = b.weights.widened(lo, hi);
        *b = b.between(lo, hi);
    }
    Some(remaining)
}

/// The part of [0, 1] where the convex hull of the points (i/n, rowᵢ) is between two heights. With weights, the part where
/// the hulls of the points (i/n, (rowᵢ − height) wᵢ) are above 0 for the lower and below 0 for the upper height.
#[inline(always)]
fn inside<C>(
    row: &[f64],
    weights: &impl Weights<C>,
    (low, high): (f64, f64),
) -> Option<(f64, f64)> {
    let (min, max) = range(row.iter().copied());
    if max < low || min > high {
        return None;
    }
    let n = row.len() - 1;
    let (mut lo, mut hi) = (0.0, 1.0);
    // For an end outside the strip: the boundary to reach and a sign. Multiplied by the sign, the end lies below it.
    let below = |end: f64| {
        if end < low {
            Some((1.0, low))
        } else if end > high {
            Some((-1.0, -high))
        } else {
            None
        }
    };
    if let Some((sign, height)) = below(row[0]) {
        lo = entry(n, |i| (sign * row[i] - height) * weights.weight(i));
    }
    if let Some((sign, height)) = below(row[n]) {
        hi = 1.0 - entry(n, |i| (sign * row[n - i] - height) * weights.weight(n - i));
    }
    // Rounding may swap the ends of an interval that is a single parameter.
    Some((lo, if hi < lo { lo } else { hi }))
}

/// The first parameter where the upper hull of points reaches 0. The first point is below 0, and at least one is not.
///
/// The hull goes from each of its points to the one in the steepest direction.
#[inline(always)]
fn entry(n: usize, height: impl Fn(usize) -> f64) -> f64 {
    if n == 3 {
        return entry_of_cubic([height(0), height(1), height(2), height(3)]);
    }
    // Gift wrapping from point 0; `low` is the height of point i.
    let (mut i, mut low) = (0, height(0));
    loop {
        let (mut next, mut high, mut rise) = (n, low, f64::NEG_INFINITY);
        for j in i + 1..n + 1 {
            let here = height(j);
            let slope = (here - low) / (j - i) as f64;
            if slope > rise {
                (next, high, rise) = (j, here, slope);
            }
        }
        if high >= 0.0 || next == n {
            let steps = if high > low { low / (low - high) } else { 1.0 };
            return (i as f64 + (next - i) as f64 * steps) / n as f64;
        }
        (i, low) = (next, high);
    }
}

/// [`entry`] for degree 3, unrolled.
#[inline(always)]
fn entry_of_cubic([a, b, c, d]: [f64; 4]) -> f64 {
    let third = 1.0 / 3.0;
    let rise = |from: f64, to: f64| {
        if to > from {
            (from / (from - to)).min(1.0)
        } else {
            1.0
        }
    };
    let (to_b, to_c, to_d) = (b - a, 0.5 * (c - a), third * (d - a));
    if to_b >= to_c && to_b >= to_d {
        // The hull starts with the edge from a to b.
        if b >= 0.0 {
            return third * rise(a, b);
        }
        // It goes on from b to d if d is in a steeper direction than c.
        if c - b < 0.5 * (d - b) {
            return third + 2.0 * third * rise(b, d);
        }
        if c >= 0.0 {
            return third + third * rise(b, c);
        }
    } else if to_c < to_d {
        // The hull is the edge from a to d.
        return rise(a, d);
    } else if c >= 0.0 {
        // The hull starts with the edge from a to c.
        return 2.0 * third * rise(a, c);
    }
    // The hull reaches 0 on its last edge, from c to d.
    2.0 * third + third * rise(c, d)
}
