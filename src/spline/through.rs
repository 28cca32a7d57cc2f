//! Cubic splines through points.

use super::Spline;
use super::joint::catmull_rom;
use crate::curve::{MAX_OUTPUT_F64, check_finite, max_abs};
use crate::error::Error;
use crate::point::Point;

/// Which smooth curve goes through the points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Through {
    /// The natural cubic spline: equal second derivatives at all joints, none at free ends. Each point has a say
    /// everywhere, a quarter as much from joint to joint.
    #[default]
    Natural,
    /// Catmull-Rom: the tangent at a point comes from it and its two neighbours; equal directions at joints, and where
    /// `alpha` is 0 equal derivatives.
    CatmullRom {
        /// How much the lengths of chords count, 0 (uniform) to 1 (chordal); ½ (centripetal) makes no cusps and no loops
        /// within a segment.
        alpha: f64,
    },
}

/// The pole of the filter that undoes (1, 4, 1): √3 − 2.
const POLE: f64 = -0.267_949_192_431_122_7;

/// After so many steps a power of the pole is below the rounding error of 1: 0.268³² = 5·10⁻¹⁹.
const RUN_IN: usize = 32;

/// Above this coordinates are computed at 2⁻¹⁰ of their size, so that no sum overflows.
const HUGE: f64 = 1e300;

impl<P: Point> Spline<P> {
    /// A cubic spline through points; its joints are the points, at t = 0, 1, 2, …
    ///
    /// Natural: with Dᵢ the derivative at Pᵢ, Dᵢ₋₁ + 4Dᵢ + Dᵢ₊₁ = 3(Pᵢ₊₁ − Pᵢ₋₁), and 2D₀ + D₁ = 3(P₁ − P₀) at a free end; the
    /// handles are Pᵢ ± Dᵢ/3. Catmull-Rom: with d₁ and d₂ the lengths of the chords at Pᵢ to the power alpha, T =
    /// (Pᵢ − Pᵢ₋₁)/d₁ − (Pᵢ₊₁ − Pᵢ₋₁)/(d₁ + d₂) + (Pᵢ₊₁ − Pᵢ)/d₂; the handles are Pᵢ − T d₁/3 and Pᵢ + T d₂/3, at a free end a third
    /// of the chord. A point that comes twice, one after the other, is a corner of a Catmull-Rom spline with alpha > 0:
    /// each side ends there as at a free end.
    ///
    /// Takes 2 points or more; two open ones make a straight line, two closed ones a line there and back.
    ///
    /// ```
    /// use casteljau::{Spline, spline::Through, glam::DVec2};
    ///
    /// let points = [(0.0, 0.0), (1.0, 1.0), (3.0, 1.0), (4.0, 0.0)].map(DVec2::from);
    /// let spline = Spline::through(&points, Through::Natural, false)?;
    /// assert_eq!(spline.eval(2.0), points[2]);
    /// assert!(spline.continuity(1, None)?.c2);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than 2 points, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Range`] for an
    /// alpha outside of 0 to 1, [`Error::TooMany`] above 1 GiB.
    ///
    /// Sources: Unser, "Splines: a perfect fit for signal and image processing", 1999 (the recursive filter); Yuksel,
    /// Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.
    pub fn through(points: &[P], kind: Through, closed: bool) -> Result<Self, Error> {
        match kind {
            Through::Natural => Self::natural(points, closed),
            Through::CatmullRom { alpha } => {
                if !(0.0..=1.0).contains(&alpha) {
                    return Err(Error::Range {
                        what: "alpha",
                        expected: "0 to 1",
                        got: alpha,
                    });
                }
                Self::catmull_rom(points, closed, |length| power(length, alpha))
            }
        }
    }

    /// The natural cubic spline.
    pub(crate) fn natural(points: &[P], closed: bool) -> Result<Self, Error> {
        with_handles(points, closed, |p| {
            derivatives(p, closed).into_iter().map(|d| (d, d)).collect()
        })
    }

    /// The Catmull-Rom spline, `step` being the step of the parameter by the length of a chord.
    pub(crate) fn catmull_rom(
        points: &[P],
        closed: bool,
        step: impl Fn(f64) -> f64,
    ) -> Result<Self, Error> {
        with_handles(points, closed, |p| {
            let last = p.len() - 1;
            let around = |i: usize| match i {
                0 if closed => [p[last], p[0], p[1]],
                0 => [p[0], p[0], p[1]],
                _ if i < last => [p[i - 1], p[i], p[i + 1]],
                _ if closed => [p[i - 1], p[i], p[0]],
                _ => [p[i - 1], p[i], p[i]],
            };
            let ends = |i: usize| !closed && (i == 0 || i == last);
            let derivative = |i: usize| {
                let [a, b, c] = around(i);
                if ends(i) {
                    return (c - a, c - a);
                }
                let (ahead, behind) =
                    catmull_rom([a, b, c], [step((b - a).norm()), step((c - b).norm())]);
                (behind, ahead)
            };
            (0..p.len()).map(derivative).collect()
        })
    }
}

/// The length to a power; the powers that have a name without a power function.
fn power(length: f64, alpha: f64) -> f64 {
    if alpha == 0.0 {
        1.0
    } else if alpha == 0.5 {
        length.sqrt()
    } else if alpha == 1.0 {
        length
    } else {
        length.powf(alpha)
    }
}

/// A spline by its derivatives: of the segment before each point, and of the one after it.
fn with_handles<P: Point>(
    points: &[P],
    closed: bool,
    derivatives: impl Fn(&[P]) -> Vec<(P, P)>,
) -> Result<Spline<P>, Error> {
    let count = points.len();
    if count < 2 {
        return Err(Error::Count {
            what: "points",
            expected: "at least 2 points",
            got: count,
        });
    }
    let limit = MAX_OUTPUT_F64 / (3 * P::DIMENSION);
    if count > limit {
        return Err(Error::TooMany {
            what: "points",
            limit,
            needed: count,
        });
    }
    check_finite("points", points)?;
    let unit = if max_abs(points) > HUGE {
        1.0 / 1024.0
    } else {
        1.0
    };
    let small: Vec<P> = points.iter().map(|&p| p * unit).collect();
    let derivatives = derivatives(&small);
    let handle = |i: usize, along: P| {
        let handle = (small[i] + along / 3.0) / unit;
        // Of points at the end of numbers, handles lie beyond: they stay at the point.
        if handle.is_finite() {
            handle
        } else {
            points[i]
        }
    };
    let segments = if closed { count } else { count - 1 };
    let mut all = Vec::with_capacity(3 * segments + 1);
    for i in 0..segments {
        let next = (i + 1) % count;
        all.extend([
            points[i],
            handle(i, derivatives[i].1),
            handle(next, -derivatives[next].0),
        ]);
    }
    if !closed {
        all.push(points[count - 1]);
    }
    Ok(Spline::from_parts(all, &vec![3; segments], closed))
}

/// The derivatives of the natural spline.
///
/// (1, 4, 1) is undone by a filter that runs forward and one that runs back, each of which needs no more than its last
/// value. Both begin some steps early, where their past has no weight any more: around the ring, or at a free end in the
/// mirror image beyond it (a natural spline goes on turned by 180° about its end, its derivatives mirrored).
fn derivatives<P: Point>(p: &[P], closed: bool) -> Vec<P> {
    let count = p.len();
    let right = |i: usize| {
        let (before, after) = match i {
            0 if closed => (p[count - 1], p[1]),
            0 => (p[0] * 2.0 - p[1], p[1]),
            _ if i < count - 1 => (p[i - 1], p[i + 1]),
            _ if closed => (p[i - 1], p[0]),
            _ => (p[i - 1], p[i] * 2.0 - p[i - 1]),
        };
        (after - before) * 3.0
    };
    let period = if closed { count } else { 2 * (count - 1) };
    // Index i of the ring, or of the row and its mirror images; counted from the run-in on.
    let at = |i: usize| {
        let i = i % period;
        if i < count { i } else { period - i }
    };
    let early = RUN_IN.div_ceil(period) * period - RUN_IN;
    let mut forward = P::default();
    (early..early + RUN_IN).for_each(|i| forward = right(at(i)) + forward * POLE);
    let mut found: Vec<P> = Vec::with_capacity(count + RUN_IN);
    for i in 0..count + RUN_IN {
        forward = right(at(i)) + forward * POLE;
        found.push(forward);
    }
    let mut back = P::default();
    for value in found.iter_mut().rev() {
        back = *value + back * POLE;
        *value = back * -POLE;
    }
    found.truncate(count);
    found
}
