//! A bound of the distance between a cubic and one side of a stroke of varying radius.
//!
//! Take two pairs, each of a point of the cubic Q and a disc of the stroke, whose centre is on the curve B. Between them
//! let u run from 0 to 1 on the cubic, on the curve and along the radius r; B and r are replaced by cubics with the same
//! values and derivatives at the pairs. With E = Q − B, the distance of a point of the cubic from a disc is f = |E| − r. Where f
//! is stationary as a function of the disc, it is the distance from the side. With M = (E, r), W = (B′, −r′) and the product
//! ⟨a, b⟩ = a₁b₁ + a₂b₂ − a₃b₃ the polynomials
//!
//!   ⟨M, M⟩ = (|E| + r) f,   ⟨M, W⟩ = −|E| f′ − f r′,   ⟨W, W⟩ − ⟨M, W′⟩ = |E| f″ + f′ (f′ + 2 r′) + f r″
//!
//! (where f′ and f″ are derivatives with respect to the disc) lie between their least and their greatest Bernstein
//! coefficient. So f is bounded, and so is its difference from the stationary value (`difference_at_zero`), although these are
//! values for the pairs (u, u): with E₁ = Q(u) − B(t) the second derivative by t is
//!
//!   f″ = |B′ − (B′·e) e|²/|E₁| − e·B″ − r″, e = E₁/|E₁|
//!
//! and its gradient by Q is at most |B″|/|E₁| + 2|B′|²/|E₁|². Next to cusps of a side f″ is 0; while the stationary disc is
//! between the two pairs, its value differs by at most |f′|. That disc moves along with u from the first pair of the cubic to the last one,
//! so every point of the side is as near to the cubic.
//!
//! The idea of M is from Choi, Choi and Moon, "Mathematical theory of medial axis transform", Pacific J. Math. 181 (1997).

use crate::bernstein::vector_products::{
    cubic_by_linear, cubic_by_quadratic, cubic_square, quadratic_by_quadratic,
};
use crate::numeric::order::{larger, range, smaller};
use crate::numeric::zero::difference_at_zero;
use crate::spline::fit_run::Vector;
use glam::DVec3;

/// The bound between two pairs, for the Bernstein coefficients of M and of W; infinite or NaN if there is none.
///
/// `sign` is −1 where the side runs backwards; `rest` bounds the errors of the cubics for B and r together. A bound up to
/// the tolerance may be larger than necessary.
pub fn side_bound(m: &[DVec3; 4], w: &[DVec3; 3], sign: f64, rest: f64, tolerance: f64) -> f64 {
    let changes = [(w[1] - w[0]) * 2.0, (w[2] - w[1]) * 2.0];
    let largest = |values: &[DVec3]| {
        values
            .iter()
            .fold(0.0, |max: f64, v| larger(max, v.z.abs()))
    };
    let least_radius = larger(
        m.iter().fold(f64::INFINITY, |min, v| smaller(min, v.z)),
        0.0,
    );
    // f is between −r and |E|.
    let size = m
        .iter()
        .fold(largest(m), |max, v| larger(max, v.truncate().norm()));
    if size + rest <= tolerance {
        return size + rest;
    }
    let (min, max) = range(cubic_square(m, product).into_iter());
    let least = larger(least_radius * least_radius + min, 0.0).sqrt();
    let off = larger(max, -min) / (least_radius + least);
    let (min, max) = range(cubic_by_quadratic(m, w, product).into_iter());
    let f_rate = (larger(max, -min) + off * largest(w)) / least;
    let squares = quadratic_by_quadratic(w, w, product);
    let bends = cubic_by_linear(m, &changes, product);
    let (ahead, _) = range((0..5).map(|k| sign * (squares[k] - bends[k])));
    let curvature = ahead - f_rate * (2.0 * largest(w) + f_rate) - off * largest(&changes);
    let longest = |vectors: &[DVec3]| range(vectors.iter().map(|v| v.length_squared())).1.sqrt();
    let rates = [0, 1, 2].map(|k| ((m[k + 1] - m[k]) * 3.0 + w[k]).truncate().extend(0.0));
    // With |E| ≥ least / 2 at all pairs that matter: curvature/size divided by twice this change is less than a half of
    // least/|Q′|.
    let turn =
        2.0 * longest(&changes) + 8.0 * range(w.iter().map(|v| v.length_squared())).1 / least;
    let change = longest(&rates) * turn / least;
    let difference = difference_at_zero(f_rate, curvature / size, change);
    off + smaller(difference, f_rate) + rest
}

/// ⟨a, b⟩.
#[inline(always)]
fn product(a: DVec3, b: DVec3) -> f64 {
    a.x * b.x + a.y * b.y - a.z * b.z
}
