//! Contacts of two segments with about the same direction, compared as graphs over that direction.
//!
//! Let x be the coordinate along the direction and y the coordinate across it, and let both segments span the same x.
//! At equal parameters s, the curve B is ahead of A by B_x − A_x, and its slope is between those of its control edges,
//! so the height of A over B at the x of A(s) is (A_y − B_y) − slope · (A_x − B_x). With a mean slope this is a
//! polynomial in s (or a rational function), bounded by its Bernstein coefficients; the remainder is half the range of
//! slopes times |A_x − B_x|. Both shrink as the segments get shorter. If the whole height is below rounding, the segments
//! are in contact. Two curves with a common segment are detected immediately, since their parameters correspond.

use super::constants::CONTACT;
use super::crossing::cross_product;
use super::piece::{Coefficients, Piece, Weights};
use super::solver::{ClippingSolver, Contact};
use crate::numeric::order::range;

impl<C: Coefficients, W: Weights<C>> ClippingSolver<C, W> {
    /// Finds the contacts if the segments have about the same direction (or the opposite one); otherwise returns false.
    pub(super) fn intersect_as_graphs(&mut self, a: &Piece<C, W>, b: &Piece<C, W>) -> bool {
        let Some((direction, forwards)) = common_direction(a, b, self.slack) else {
            return false;
        };
        let b = if forwards { b.clone() } else { b.reversed() };
        let (a, b) = (a.turned(direction), b.turned(direction));
        // Now no edge points against x (up to the slack), so x is monotone along both segments.
        let n = a.last();
        let from = a.x.get()[0].max(b.x.get()[0]);
        let to = a.x.get()[n].min(b.x.get()[n]);
        if to < from - self.slack {
            return true;
        }
        // The ranges of x may miss each other by rounding.
        let to = to.max(from);
        let common = |p: &Piece<C, W>| p.between(p.time_at(from), p.time_at(to));
        self.compare(&common(&a), &common(&b));
        true
    }

    /// Finds the contacts of two segments that span the same x.
    fn compare(&mut self, a: &Piece<C, W>, b: &Piece<C, W>) {
        if !self.work.spend(1) || W::is_indivisible(a) || W::is_indivisible(b) {
            return self.record_contact(a, b);
        }
        let (slopes_a, slopes_b) = (slopes(a), slopes(b));
        let heights = heights(a, b, slopes_a, slopes_b);
        let (min, max) = (heights.min, heights.max);
        if min > self.slack || max < -self.slack {
            return;
        }
        let contact = CONTACT * self.slack;
        if max <= contact && min >= -contact {
            return self.record_contact(a, b);
        }
        // If one graph is steeper than the other everywhere, their height difference is monotone.
        let one_crossing = slopes_a.0 > slopes_b.1 || slopes_a.1 < slopes_b.0;
        if one_crossing && self.meet_once(a, b, &heights) {
            return;
        }
        // Both are cut at the same x, so that the halves span the same x again.
        let (before_a, after_a) = a.split(a.weights.middle());
        let x = after_a.x.get()[0];
        let (before_b, after_b) = b.split(b.time_at(x));
        self.compare(&before_a, &before_b);
        self.compare(&after_a, &after_b);
    }

    /// Handles two segments whose height difference is monotone; returns false if the result is unclear.
    fn meet_once(&mut self, a: &Piece<C, W>, b: &Piece<C, W>, heights: &Heights) -> bool {
        let (start, end) = (heights.start, heights.end);
        if start * end < 0.0 {
            // Newton's method starts where a linear height difference would be 0.
            let s = start / (start - end);
            let found = self.newton(a, b, s, s);
            found.is_some_and(|contact| {
                self.found.push(contact);
                true
            })
        } else {
            // Without a change of sign, a monotone height is nearest to 0 at one of the ends.
            if start.abs().min(end.abs()) <= self.slack {
                let s = if start.abs() <= end.abs() { 0.0 } else { 1.0 };
                let (t, u) = (a.at(s), b.at(s));
                self.found.push(Contact {
                    t: [t, t],
                    u: [u, u],
                    crossing: false,
                });
            }
            true
        }
    }
}

/// A unit vector from which no control edge of either segment deviates by more than 45°; the edges of `b` are reversed
/// if the second value is false.
fn common_direction<C: Coefficients, W: Weights<C>>(
    a: &Piece<C, W>,
    b: &Piece<C, W>,
    slack: f64,
) -> Option<([f64; 2], bool)> {
    let (direction_a, direction_b) = (normalized(a.chord())?, normalized(b.chord())?);
    let forwards = direction_a[0] * direction_b[0] + direction_a[1] * direction_b[1] >= 0.0;
    let sign = if forwards { 1.0 } else { -1.0 };
    let direction = normalized([
        direction_a[0] + sign * direction_b[0],
        direction_a[1] + sign * direction_b[1],
    ])?;
    let keeps = |p: &Piece<C, W>, sign: f64| {
        (0..p.last()).all(|i| {
            let [x, y] = p.edge(i);
            let forward = sign * (x * direction[0] + y * direction[1]);
            // Rounding determines the direction of an edge below the slack.
            forward >= cross_product(direction, [x, y]).abs() || x.abs().max(y.abs()) <= slack
        })
    };
    (keeps(a, 1.0) && keeps(b, sign)).then_some((direction, forwards))
}

fn normalized([x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let length = (x * x + y * y).sqrt();
    (length > 0.0).then(|| [x / length, y / length])
}

/// The smallest and the largest slope of the control edges, which bound the slopes of the curve.
#[inline(always)]
fn slopes<C: Coefficients, W: Weights<C>>(p: &Piece<C, W>) -> (f64, f64) {
    // dy/dx is a weighted mean of the slopes of the edges; the weights, Bᵢ(s) times the x of edge i, are not negative.
    let edges = (0..p.last()).map(|i| p.edge(i));
    let (min, max) = range(edges.filter(|e| e[0] > 0.0).map(|[x, y]| y / x));
    // All edges have zero extent: treat the segment as level.
    if min > max { (0.0, 0.0) } else { (min, max) }
}

/// The height of one segment over the other: bounds, and the values at the two ends.
struct Heights {
    min: f64,
    max: f64,
    start: f64,
    end: f64,
}

#[inline(always)]
fn heights<C: Coefficients, W: Weights<C>>(
    a: &Piece<C, W>,
    b: &Piece<C, W>,
    sa: (f64, f64),
    sb: (f64, f64),
) -> Heights {
    // The slopes of either curve may be used; those of the straighter one give a tighter bound.
    let (low, high) = if sa.1 - sa.0 < sb.1 - sb.0 { sa } else { sb };
    let (mean, spread) = (0.5 * (low + high), 0.5 * (high - low));
    let mut ahead = 0.0;
    let (last, difference) = W::differences(a, b);
    let height = |i: usize| {
        let [x, y] = difference(i);
        y - mean * x
    };
    // |A_x − B_x| is at most its largest Bernstein coefficient.
    for i in 0..=last {
        let x = difference(i)[0].abs();
        if x > ahead {
            ahead = x;
        }
    }
    let (min, max) = range((0..=last).map(height));
    let margin = spread * ahead;
    Heights {
        min: min - margin,
        max: max + margin,
        start: height(0),
        end: height(last),
    }
}
