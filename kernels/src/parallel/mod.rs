//! Parallel curves: cubics within a tolerance of B(t) + d·N(t), N being the unit normal.
//!
//! A piece is replaced by one cubic with its exact ends and end tangents, so two numbers are left to choose: the
//! lengths of the handles. The first guess adds the handles of the source's piece to those of the circular arc that the
//! normal describes; a few steps of least squares on the distances at three places improve it (`fit`). Then the
//! distance is bounded, not sampled (`bound`). Where the bound fails the piece is cut, at cusps of the parallel first.
//! Idea: Levien, "Parallel curves of cubic Béziers" (2022).

mod bound;
mod breaks;
mod fit;
mod source;
mod vector;

pub use source::Source;
pub use vector::Plane;

use crate::cos_sin;
use source::Place;

/// How often a piece may be cut in two.
const MOST_CUTS: usize = 48;

/// A piece whose own length and way around the normal are this part of the tolerance needs no bound.
const TINY_PART: f64 = 0.25;

/// A piece this short, in t, is a point as far as numbers tell.
const SHORTEST: f64 = 1e-12;

/// Arcs about a point are cut into pieces of at most 22.5°, each off by 5·10⁻⁸ of the radius.
const SIXTEENTHS_OF_A_TURN: f64 = 8.0 / std::f64::consts::PI;

/// Below this part of the largest speed a derivative is only rounding.
pub(crate) const VANISHING_SPEED: f64 = 1e-15;

/// An end of a piece: the place, the unit tangent as seen from inside the piece, and the way the parallel goes there:
/// 1 along the tangent, −1 against it (where it has passed its cusp).
#[derive(Clone, Copy, Debug)]
struct End {
    place: Place,
    tangent: Plane,
    sign: f64,
}

/// A parallel of a curve.
pub struct Parallel<'a> {
    source: &'a Source,
    distance: f64,
    tolerance: f64,
}

impl<'a> Parallel<'a> {
    /// At a distance along the normal, which is the tangent turned by +90°.
    pub fn new(source: &'a Source, distance: f64, tolerance: f64) -> Self {
        Self {
            source,
            distance,
            tolerance,
        }
    }

    /// The end of a piece at t.
    fn end(&self, t: f64) -> End {
        let place = self.source.at(t);
        let sign = if self.forwardness(&place) < 0.0 {
            -1.0
        } else {
            1.0
        };
        End {
            place,
            tangent: place.v.unit(),
            sign,
        }
    }

    /// |B′|³(1 − κd): positive where the parallel goes along the tangent.
    #[inline]
    fn forwardness(&self, at: &Place) -> f64 {
        let square = at.v.square();
        square * square.sqrt() - self.distance * at.v.cross(at.a)
    }

    /// The point of the parallel at an end.
    #[inline]
    fn point(&self, end: &End) -> Plane {
        end.place.b + end.tangent.turned() * self.distance
    }

    /// Appends three control points for each cubic from one end to the other, without looking for cusps before.
    fn cover(&self, from: &End, to: &End, out: &mut Vec<Plane>) {
        self.cover_deep(from, to, MOST_CUTS, out);
    }

    fn cover_deep(&self, from: &End, to: &End, cuts: usize, out: &mut Vec<Plane>) {
        if from.sign != to.sign
            && let Some((before, after)) = self.cusp(from, to)
        {
            self.cover_deep(from, &before, cuts, out);
            self.cover_deep(&after, to, cuts, out);
            return;
        }
        if let Some(cubic) = self.fit(from, to) {
            out.extend_from_slice(&cubic[1..]);
            return;
        }
        if cuts == 0 || to.place.t - from.place.t <= SHORTEST || self.tiny(from, to) {
            self.arc(from, to, out);
            return;
        }
        let mut middle = self.cut(from, to);
        if middle.place.v.length() <= VANISHING_SPEED * self.source.speed() {
            middle.tangent = (from.tangent + to.tangent).unit();
        }
        self.cover_deep(from, &middle, cuts - 1, out);
        self.cover_deep(&middle, to, cuts - 1, out);
    }

    /// Whether a piece of the source is nothing to the tolerance.
    fn tiny(&self, from: &End, to: &End) -> bool {
        let (a, b) = (&from.place, &to.place);
        let way = (b.b - a.b).length() + (b.t - a.t) * (a.v.length() + b.v.length());
        let turn = (to.tangent - from.tangent).length() * self.distance.abs();
        way + turn <= TINY_PART * self.tolerance
    }

    /// What is next to a point on the source: arcs about it.
    fn arc(&self, from: &End, to: &End, out: &mut Vec<Plane>) {
        let (cos, sin) = (from.tangent.dot(to.tangent), from.tangent.cross(to.tangent));
        let angle = sin.atan2(cos);
        let pieces = (angle.abs() * SIXTEENTHS_OF_A_TURN).ceil().max(1.0);
        let (mut last, mut k) = (*from, 1.0);
        while k <= pieces {
            let next = if k == pieces {
                *to
            } else {
                let (cos, sin) = cos_sin(angle * k / pieces);
                let tangent = from.tangent * cos + from.tangent.turned() * sin;
                End { tangent, ..*from }
            };
            out.extend_from_slice(&self.first_cubic(&last, &next)[1..]);
            (last, k) = (next, k + 1.0);
        }
    }

    /// The cusp of the parallel between two ends that differ in their signs.
    fn cusp(&self, from: &End, to: &End) -> Option<(End, End)> {
        let (t0, t1) = (from.place.t, to.place.t);
        let t = self.zero(t0, t1, from.sign, |place| self.forwardness(place))?;
        let before = End {
            sign: from.sign,
            ..self.end(t)
        };
        let after = End {
            sign: to.sign,
            ..before
        };
        Some((before, after))
    }

    /// Where to cut: at an inflection, or where the tangent has turned half the way, or amid the parameters.
    fn cut(&self, from: &End, to: &End) -> End {
        let (t0, t1) = (from.place.t, to.place.t);
        let bend = |place: &Place| place.v.cross(place.a);
        let (b0, b1) = (bend(&from.place), bend(&to.place));
        let half = from.tangent + to.tangent;
        let side = from.tangent.cross(half);
        let t = if b0 * b1 < 0.0 {
            self.zero(t0, t1, b0.signum(), bend)
        } else if side.abs() > LEAST_TURN {
            self.zero(t0, t1, 1.0, |place| half.cross(place.v) * -side.signum())
        } else {
            None
        };
        let inside = |t: &f64| (*t - t0).min(t1 - *t) > LEAST_PART * (t1 - t0);
        let t = t.filter(inside);
        self.end(t.unwrap_or(0.5 * (t0 + t1)))
    }

    /// A zero strictly between two parameters of a function with the sign `sign` at the first and the other one at the second: bisection,
    /// sped up by regula falsi (Illinois).
    fn zero(&self, t0: f64, t1: f64, sign: f64, f: impl Fn(&Place) -> f64) -> Option<f64> {
        let (mut lo, mut hi) = (t0, t1);
        let value = |t: f64| sign * f(&self.source.at(t));
        let (mut f_lo, mut f_hi) = (value(lo).max(0.0), value(hi).min(0.0));
        let mut side = 0;
        for step in 0..100 {
            let secant = lo + (hi - lo) * (f_lo / (f_lo - f_hi));
            let middle = 0.5 * (lo + hi);
            let t = if step % 3 == 2 || !(secant > lo && secant < hi) {
                middle
            } else {
                secant
            };
            if hi - lo <= ROOT_WIDTH * hi || t <= lo || t >= hi {
                break;
            }
            let now = value(t);
            if now > 0.0 {
                (lo, f_lo) = (t, now);
                f_hi *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (hi, f_hi) = (t, now);
                f_lo *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        let t = 0.5 * (lo + hi);
        (t > t0 && t < t1).then_some(t)
    }
}

/// Turns below this (as a sine) are too small to halve by direction.
const LEAST_TURN: f64 = 0.05;

/// A cut this near to an end, as a part of the piece, would not be one.
const LEAST_PART: f64 = 1e-3;

/// A root is known when its interval is this part of it.
const ROOT_WIDTH: f64 = 1e-13;
