//! Newton's method for the common zeros of two polynomials, planes 0 and 1 of a piece ("the pair").

use super::piece::{Jet, PolynomialPiece};
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// Zeros nearer than this in u and v count as one: between two zeros at a distance s the pair rises to s²/4, which
/// rounding hides.
pub(crate) const SAME_ZERO: f64 = 1.0 / 8_388_608.0;

/// The maximum number of steps of Newton's method from one start.
const MAX_STEPS: usize = 16;

/// A step below this is the last: the remaining error is of the order of its square.
const LAST_STEP: f64 = 1e-9;

/// √(f² + g²), the distance of both values from zero.
pub(crate) fn distance_from_zero(whole: &PolynomialPiece, at: [f64; 2]) -> f64 {
    whole.jet(0, at).f.hypot(whole.jet(1, at).f)
}

/// The point of the unit square for a zero that Newton's method found, perhaps slightly outside the square. The zero is
/// clamped to the square; then a Gauss–Newton step along the edge brings the pair nearest to zero.
pub(crate) fn onto_square(whole: &PolynomialPiece, at: [f64; 2]) -> [f64; 2] {
    let mut inside = at.map(|t| t.clamp(0.0, 1.0));
    for k in 0..2 {
        // The other parameter was clamped, so the point moves along this edge: the step s that minimises
        // (a + s a′)² + (b + s b′)².
        if inside[1 - k] != at[1 - k] {
            let [a, b] = [0, 1].map(|plane| whole.jet(plane, inside));
            let [da, db] = if k == 0 { [a.u, b.u] } else { [a.v, b.v] };
            let next = inside[k] - (a.f * da + b.f * db) / (da * da + db * db);
            if next.is_finite() {
                inside[k] = next.clamp(0.0, 1.0);
            }
        }
    }
    inside
}

/// Newton's method from the middle of a piece, for a zero in the piece or directly beside it.
pub(crate) fn zero_near(
    piece: &PolynomialPiece,
    whole: &PolynomialPiece,
    work: &mut WorkLimit,
) -> Option<[f64; 2]> {
    let middle = piece.middle();
    let width = [piece.u, piece.v].map(|[from, to]| to - from);
    let is_within = |at: [f64; 2], share: f64| {
        (0..2).all(|k| (at[k] - middle[k]).abs() <= width[k] * (0.5 + share))
    };
    let mut at = middle;
    for _ in 0..MAX_STEPS {
        if !work.spend(2 * whole.jet_steps()) {
            return None;
        }
        let [a, b] = [0, 1].map(|k| whole.jet(k, at));
        let step = solve([a.u, a.v, a.f], [b.u, b.v, b.f]);
        at = [at[0] + step[0], at[1] + step[1]];
        if !is_within(at, 1.0) {
            return None;
        }
        if step.iter().all(|s| s.abs() < LAST_STEP) {
            return is_within(at, 1.0 / 64.0).then_some(at);
        }
    }
    None
}

/// A zero near a point at which the pair touches zero: the derivative is singular there, and the component of the pair
/// along the direction in which it is not singular is zero. Newton's method solves these two equations; `None` if it
/// diverges.
pub(crate) fn touching_zero(
    whole: &PolynomialPiece,
    from: [f64; 2],
    work: &mut WorkLimit,
) -> Option<[f64; 2]> {
    let mut at = from;
    for _ in 0..MAX_STEPS {
        if !work.spend(2 * whole.jet_steps()) {
            return None;
        }
        let [a, b] = [0, 1].map(|k| whole.jet(k, at));
        let step = solve(regular_component(&a, &b), jacobian_determinant(&a, &b));
        at = [at[0] + step[0], at[1] + step[1]];
        // When the search ends, the pieces around such a point are no wider than this. A step that is not finite also
        // fails this test.
        let is_near = (0..2).all(|k| (at[k] - from[k]).abs() < SAME_ZERO.sqrt());
        if !is_near {
            return None;
        }
        if step.iter().all(|s| s.abs() < LAST_STEP) {
            return Some(at);
        }
    }
    None
}

/// The nearest point where the component of the pair along its largest derivative is zero, by Newton's method.
pub(crate) fn project_to_zero_set(
    whole: &PolynomialPiece,
    mut at: [f64; 2],
    work: &mut WorkLimit,
) -> [f64; 2] {
    for _ in 0..4 {
        if !work.spend(2 * whole.jet_steps()) {
            break;
        }
        // One equation for two parameters: the shortest of its Newton steps runs along the gradient (u, v).
        let [u, v, value] = regular_component(&whole.jet(0, at), &whole.jet(1, at));
        let share = value / (u * u + v * v);
        if !share.is_finite() {
            break;
        }
        at = [at[0] - share * u, at[1] - share * v];
    }
    at
}

/// The component of the pair along its largest derivative: its derivatives in u and v, and its value.
fn regular_component(a: &Jet, b: &Jet) -> [f64; 3] {
    let [x, y] = longer([a.u, b.u], [a.v, b.v]);
    [x * a.u + y * b.u, x * a.v + y * b.v, x * a.f + y * b.f]
}

/// The determinant of the derivative: its derivatives in u and v, and its value.
fn jacobian_determinant(a: &Jet, b: &Jet) -> [f64; 3] {
    [
        a.uu * b.v + a.u * b.uv - a.uv * b.u - a.v * b.uu,
        a.uv * b.v + a.u * b.vv - a.vv * b.u - a.v * b.uv,
        a.u * b.v - a.v * b.u,
    ]
}

/// The Newton step for two equations, each given by its derivatives and its value, by Cramer's rule.
fn solve([au, av, a]: [f64; 3], [bu, bv, b]: [f64; 3]) -> [f64; 2] {
    let det = au * bv - av * bu;
    [(av * b - bv * a) / det, (bu * a - au * b) / det]
}

/// The longer of two vectors.
pub(crate) fn longer(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    if a[0].hypot(a[1]) >= b[0].hypot(b[1]) {
        a
    } else {
        b
    }
}
