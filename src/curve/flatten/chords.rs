//! The chords of a curve: each is nearly as long as the tolerance allows.

use super::deviation::{Deviation, Fraction, fourth_root};
use super::vertex_limit::{TARGET_USE, VertexLimit};
use crate::geometry::error::Error;

/// A chord is accepted if its squared deviation, as a part of the squared tolerance, is at least this. Chords grow with
/// the square root of the deviation, so there are at most 0.72^-¼ = 1.086 times as many as necessary.
const LEAST_USE: f64 = 0.72;

/// Maximum number of corrections of one chord, of which one or two are usual; after them the longest safe step is taken.
const MAX_CORRECTIONS: usize = 8;

/// The extrapolated ratio of two steps is limited to this range. It only affects the first try of a step: next to a cusp
/// the ratio of two steps says nothing about the third.
const MIN_GROWTH: f64 = 0.6;
const MAX_GROWTH: f64 = 1.6;

/// A correction makes a step at most this many times longer, as [`fourth_root`] also limits it.
const MAX_LENGTHENING: f64 = 4.0;

/// Advances from vertex to vertex until t = 1.
pub(super) fn walk_chords(
    deviation: &mut impl Deviation,
    limit: &mut VertexLimit,
    vertex: &mut impl FnMut(f64),
) -> Result<(), Error> {
    let mut t = 0.0;
    deviation.start_at(t);
    let (mut previous, mut step): (f64, f64) = (f64::INFINITY, 0.0);
    loop {
        limit.spend()?;
        let rest = 1.0 - t;
        // Extrapolate the ratio of the last two steps, within limits.
        let expected = step * (step / previous).clamp(MIN_GROWTH, MAX_GROWTH);
        previous = step;
        step = longest_step(deviation, deviation.guess(expected), rest);
        if step >= rest {
            vertex(1.0);
            return Ok(());
        }
        let next = t + step;
        t = if next > t { next } else { t.next_up() };
        vertex(t);
        deviation.start_at(t);
    }
}

/// A step that respects the tolerance and uses most of it, or the whole rest.
#[inline]
fn longest_step(deviation: &mut impl Deviation, guess: f64, rest: f64) -> f64 {
    let h = deviation.first_try(guess, rest);
    let squared = deviation.squared(h);
    if squared.bounded_by(1.0) && (h >= rest || !squared.bounded_by(LEAST_USE)) {
        return h;
    }
    corrected_step(deviation, h, squared, rest)
}

/// [`longest_step`] after a first step `h` that was too long or too short.
fn corrected_step(
    deviation: &mut impl Deviation,
    mut h: f64,
    mut squared: Fraction,
    rest: f64,
) -> f64 {
    let (mut safe, mut unsafe_from) = (0.0, f64::INFINITY);
    for correction in 0.. {
        if squared.bounded_by(1.0) {
            if h >= rest || !squared.bounded_by(LEAST_USE) {
                return h;
            }
            safe = h;
        } else {
            unsafe_from = h;
        }
        if (correction >= MAX_CORRECTIONS && safe > 0.0) || h < f64::EPSILON * f64::EPSILON {
            break;
        }
        let next = h * fourth_root(TARGET_USE * squared.under, squared.over);
        let between = next > safe && next < unsafe_from;
        h = if between {
            next
        } else {
            0.5 * (safe + unsafe_from.min(MAX_LENGTHENING * h))
        }
        .min(rest);
        squared = deviation.squared(h);
    }
    safe
}
