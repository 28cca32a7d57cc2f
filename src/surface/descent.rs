//! Newton's method for a minimum of a polynomial over a rectangle.

use super::piece::{Jet, PolynomialPiece};
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// The maximum number of Newton steps from one start; they double the digits, unless the minimum is flat.
const MAX_STEPS: usize = 32;

/// A step below this is the last: the remaining error is of the order of its square.
const LAST_STEP: f64 = 1e-9;

/// The maximum number of times that a step is shortened; only a useless start needs more.
const MAX_REDUCTIONS: usize = 8;

/// A step that does not descend is shortened by this factor. With [`MAX_REDUCTIONS`] it becomes 65,536 times shorter.
const STEP_REDUCTION: f64 = 0.25;

/// Below this determinant, relative to the product of the second derivatives, rounding decides the direction of the
/// Newton step: half of its digits are lost.
const MIN_DETERMINANT: f64 = 1.0 / 67_108_864.0;

/// Newton's method within a rectangle; each step is shortened until it descends. Returns the last point, its value, and
/// whether it converged.
pub(crate) fn descend(
    whole: &PolynomialPiece,
    within: &[[f64; 2]; 2],
    start: [f64; 2],
    work: &mut WorkLimit,
) -> ([f64; 2], f64, bool) {
    let mut at = start;
    let mut jet = whole.jet(0, at);
    for _ in 0..MAX_STEPS {
        let mut step = newton_step(&jet, at, within);
        let is_last = step.iter().all(|s| s.abs() < LAST_STEP);
        let mut reductions = 0;
        let (next, there) = loop {
            let next = clamped_step(at, step, within);
            let there = whole.jet(0, next);
            let may_go_on = work.spend(whole.jet_steps());
            // Rounding decides whether the last step descends, so it is taken in any case.
            if is_last || there.f <= jet.f || reductions == MAX_REDUCTIONS || !may_go_on {
                break (next, there);
            }
            reductions += 1;
            step = step.map(|s| STEP_REDUCTION * s);
        };
        if is_last {
            return (next, there.f, true);
        }
        if there.f > jet.f {
            break;
        }
        (at, jet) = (next, there);
    }
    (at, jet.f, false)
}

fn clamped_step(at: [f64; 2], step: [f64; 2], within: &[[f64; 2]; 2]) -> [f64; 2] {
    [0, 1].map(|k| (at[k] + step[k]).clamp(within[k][0], within[k][1]))
}

/// The Newton step; it runs along an edge of the rectangle only where the descent direction leads out of the rectangle.
fn newton_step(jet: &Jet, at: [f64; 2], within: &[[f64; 2]; 2]) -> [f64; 2] {
    let is_blocked = |k: usize, slope: f64| {
        (at[k] <= within[k][0] && slope >= 0.0) || (at[k] >= within[k][1] && slope <= 0.0)
    };
    // In one direction; where the second derivative is not that of a minimum, some step downhill.
    let uncoupled = |slope: f64, bend: f64| -slope / bend.max(slope.abs()).max(f64::MIN_POSITIVE);
    match (is_blocked(0, jet.u), is_blocked(1, jet.v)) {
        (true, true) => [0.0; 2],
        (true, false) => [0.0, uncoupled(jet.v, jet.vv)],
        (false, true) => [uncoupled(jet.u, jet.uu), 0.0],
        (false, false) => {
            // Where the Hessian matrix H is positive definite, −H⁻¹ ∇f by Cramer's rule.
            let det = jet.uu * jet.vv - jet.uv * jet.uv;
            if jet.uu > 0.0 && det > MIN_DETERMINANT * jet.uu * jet.vv.abs() {
                [
                    (jet.uv * jet.v - jet.vv * jet.u) / det,
                    (jet.uv * jet.u - jet.uu * jet.v) / det,
                ]
            } else {
                let bend = jet.uu.max(0.0) + jet.vv.max(0.0);
                [uncoupled(jet.u, bend), uncoupled(jet.v, bend)]
            }
        }
    }
}
