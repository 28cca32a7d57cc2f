//! Two pieces that meet at most once, and where.

use super::piece::{Piece, Row};
use super::solver::{ClippingSolver, Contact};

pub(super) enum Crossing {
    /// They meet once, here.
    Found(Contact),
    /// They meet once or not at all, and it is not clear yet.
    Unclear,
    /// They may meet more than once.
    Many,
}

/// Newton's method doubles the digits with each step; what takes longer is not where it is looked for.
const NEWTON_STEPS: usize = 8;

/// A step so small, in parameters of the piece, is followed by one of its square, and that is the last one.
const NEARLY: f64 = 1e-4;

/// So far out of its piece, in parameters of the piece, a search is given up.
const ASTRAY: f64 = 0.5;

/// The last step, on the whole curves, is shorter.
const NEARBY: f64 = 1e-8;

/// Crossings at a flatter angle are looked at again.
const FLAT: f64 = 1e-5;

#[inline(always)]
pub(super) fn cross([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    ax * by - ay * bx
}

/// Whether A′ × B′ keeps its sign for all pairs of parameters: its Bernstein coefficients are the cross products of the
/// control edges. Then A(t) − B(u) = 0 has at most one solution, for between two of them A and B would have to
/// advance by the same vector.
#[inline(always)]
fn turns_to_one_side<R: Row>(a: &Piece<R>, b: &Piece<R>) -> bool {
    let (mut left, mut right) = (false, false);
    for i in 0..a.last() {
        let edge = a.edge(i);
        for j in 0..b.last() {
            let turn = cross(edge, b.edge(j));
            left |= turn > 0.0;
            right |= turn < 0.0;
        }
    }
    left != right
}

impl<R: Row> ClippingSolver<R> {
    #[inline(always)]
    pub(super) fn crossing(&self, a: &Piece<R>, b: &Piece<R>) -> Crossing {
        if !turns_to_one_side(a, b) {
            return Crossing::Many;
        }
        self.newton(a, b, 0.5, 0.5)
            .map_or(Crossing::Unclear, Crossing::Found)
    }

    /// The crossing of two pieces that meet at most once, where Newton's method finds it.
    #[inline(always)]
    pub(super) fn newton(&self, a: &Piece<R>, b: &Piece<R>, s: f64, r: f64) -> Option<Contact> {
        let (mut s, mut r) = (s, r);
        for _ in 0..NEWTON_STEPS {
            let (step_s, step_r) = step(a, b, s, r)?;
            (s, r) = (s + step_s, r + step_r);
            if !(s > -ASTRAY && s < 1.0 + ASTRAY && r > -ASTRAY && r < 1.0 + ASTRAY) {
                return None;
            }
            if step_s.abs() + step_r.abs() < NEARLY {
                return self.converged(a, b, s, r);
            }
        }
        None
    }

    /// A solution that Newton's method has found is one where it is in both pieces, but for rounding.
    #[inline(always)]
    fn converged(&self, a: &Piece<R>, b: &Piece<R>, s: f64, r: f64) -> Option<Contact> {
        let (mut t, mut u) = (a.at(s.clamp(0.0, 1.0)), b.at(r.clamp(0.0, 1.0)));
        let [whole_a, whole_b] = &self.whole;
        let ((a, da), (b, db)) = (whole_a.taylor(t), whole_b.taylor(u));
        let gap = [b[0] - a[0], b[1] - a[1]];
        let turn = cross(da, db);
        // The numbers of the whole curve have not been rounded as often.
        let (finer_t, finer_u) = (t + cross(gap, db) / turn, u + cross(gap, da) / turn);
        let fits = |x: f64, from: f64| (x - from).abs() < NEARBY && (0.0..=1.0).contains(&x);
        if fits(finer_t, t) && fits(finer_u, u) {
            (t, u) = (finer_t, finer_u);
        } else if gap[0].abs().max(gap[1].abs()) > self.slack {
            return None;
        }
        let sizes = (da[0].abs() + da[1].abs()) * (db[0].abs() + db[1].abs());
        Some(Contact {
            t: [t, t],
            u: [u, u],
            crossing: turn.abs() > FLAT * sizes,
        })
    }
}

/// The step of Newton's method for A(s) = B(r).
#[inline(always)]
pub(super) fn step<R: Row>(a: &Piece<R>, b: &Piece<R>, s: f64, r: f64) -> Option<(f64, f64)> {
    let ([ax, ay], da) = a.taylor(s);
    let ([bx, by], db) = b.taylor(r);
    let turn = cross(da, db);
    let gap = [bx - ax, by - ay];
    let steps = (cross(gap, db) / turn, cross(gap, da) / turn);
    (steps.0.is_finite() && steps.1.is_finite()).then_some(steps)
}
