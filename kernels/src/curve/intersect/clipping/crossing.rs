//! Crossings of two segments that intersect at most once.

use super::constants::{
    MAX_LAST_STEP, MAX_OVERSHOOT, MIN_CROSSING_SINE, NEWTON_STEPS, QUADRATIC_STEP,
};
use super::piece::{Coefficients, Piece, Weights};
use super::solver::{ClippingSolver, Contact};

pub(super) enum Crossing {
    /// The segments intersect once, at this contact.
    Found(Contact),
    /// The segments intersect at most once, but it is not yet clear whether they do.
    Unclear,
    /// The segments may intersect more than once.
    Many,
}

/// The step (δt, δu) of Newton's method for A(t) = B(u), and its determinant A′ × B′; `gap` is B − A. The cross products of
/// A + δt A′ = B + δu B′ with B′ and with A′ give both.
#[inline(always)]
pub fn crossing_step(gap: [f64; 2], da: [f64; 2], db: [f64; 2]) -> ([f64; 2], f64) {
    let determinant = cross_product(da, db);
    let step = [
        cross_product(gap, db) / determinant,
        cross_product(gap, da) / determinant,
    ];
    (step, determinant)
}

#[inline(always)]
pub(super) fn cross_product([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    ax * by - ay * bx
}

/// Whether A′ × B′ has the same sign for all pairs of parameters: its Bernstein coefficients are the cross products of
/// the control edges, or sums of these with positive factors. Then A(t) − B(u) = 0 has at most one solution, because between two solutions A and B would have
/// to advance by the same vector.
#[inline(always)]
fn turns_to_one_side<C: Coefficients, W: Weights<C>>(a: &Piece<C, W>, b: &Piece<C, W>) -> bool {
    let (mut counter_clockwise, mut clockwise) = (false, false);
    for i in 0..a.last() {
        let edge = a.edge(i);
        for j in 0..b.last() {
            let product = cross_product(edge, b.edge(j));
            counter_clockwise |= product > 0.0;
            clockwise |= product < 0.0;
        }
    }
    // Products of 0 are allowed: if the others have one sign, A′ × B′ has this sign inside the segments.
    counter_clockwise != clockwise
}

impl<C: Coefficients, W: Weights<C>> ClippingSolver<C, W> {
    #[inline(always)]
    pub(super) fn crossing(&self, a: &Piece<C, W>, b: &Piece<C, W>) -> Crossing {
        if !turns_to_one_side(a, b) {
            return Crossing::Many;
        }
        self.newton(a, b, 0.5, 0.5)
            .map_or(Crossing::Unclear, Crossing::Found)
    }

    /// The crossing of two segments that intersect at most once, if Newton's method finds it.
    #[inline(always)]
    pub(super) fn newton(
        &self,
        a: &Piece<C, W>,
        b: &Piece<C, W>,
        s: f64,
        r: f64,
    ) -> Option<Contact> {
        let (mut s, mut r) = (s, r);
        for _ in 0..NEWTON_STEPS {
            let (step_s, step_r) = step(a, b, s, r)?;
            (s, r) = (s + step_s, r + step_r);
            if !(s > -MAX_OVERSHOOT
                && s < 1.0 + MAX_OVERSHOOT
                && r > -MAX_OVERSHOOT
                && r < 1.0 + MAX_OVERSHOOT)
            {
                return None;
            }
            // `converged` does the last step, on the whole curves.
            if step_s.abs() + step_r.abs() < QUADRATIC_STEP {
                return self.converged(a, b, s, r);
            }
        }
        None
    }

    /// Accepts a solution of Newton's method if it lies in both segments, up to rounding.
    #[inline(always)]
    fn converged(&self, a: &Piece<C, W>, b: &Piece<C, W>, s: f64, r: f64) -> Option<Contact> {
        let (mut t, mut u) = (a.at(s.clamp(0.0, 1.0)), b.at(r.clamp(0.0, 1.0)));
        let [whole_a, whole_b] = &self.whole;
        let ((a, da), (b, db)) = (whole_a.taylor(t), whole_b.taylor(u));
        let gap = [b[0] - a[0], b[1] - a[1]];
        // The control points of the whole curves have smaller rounding errors.
        let ([step_t, step_u], determinant) = crossing_step(gap, da, db);
        let (finer_t, finer_u) = (t + step_t, u + step_u);
        let fits = |x: f64, from: f64| (x - from).abs() < MAX_LAST_STEP && (0.0..=1.0).contains(&x);
        if fits(finer_t, t) && fits(finer_u, u) {
            (t, u) = (finer_t, finer_u);
        } else if gap[0].abs().max(gap[1].abs()) > self.slack {
            return None;
        }
        let sizes = (da[0].abs() + da[1].abs()) * (db[0].abs() + db[1].abs());
        Some(Contact {
            t: [t, t],
            u: [u, u],
            crossing: determinant.abs() > MIN_CROSSING_SINE * sizes,
        })
    }
}

/// The step of Newton's method for A(s) = B(r).
#[inline(always)]
pub(super) fn step<C: Coefficients, W: Weights<C>>(
    a: &Piece<C, W>,
    b: &Piece<C, W>,
    s: f64,
    r: f64,
) -> Option<(f64, f64)> {
    let ([ax, ay], da) = a.taylor(s);
    let ([bx, by], db) = b.taylor(r);
    let ([step_s, step_r], _) = crossing_step([bx - ax, by - ay], da, db);
    (step_s.is_finite() && step_r.is_finite()).then_some((step_s, step_r))
}
