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
//! coefficient. So f is bounded by `off`, |f′| by `slope`, and |f″| from below by `curvature`/max|E| =: F.
//!
//! The stationary value for Q(u) is at a disc t with t ≠ u, whereas these are bounds for the pairs (u, u). With q = Q(s) − B(t), and
//! s from t to u,
//!
//!   f″ = (|B′|² − q·B″)/|q| − (q·B′)²/|q|³ − r″
//!   df″/ds = (3 (q·B′)²/|q|² − |B′|² + q·B″) (q·Q′)/|q|³ − 2 (q·B′)(B′·Q′)/|q|³ − B″·Q′/|q|
//!
//! The terms with B″ are that of the component of Q′ perpendicular to q, at most |B″||Q′|/|q|. While |t − u| ≤ x, q differs from E by at most
//! |B′|x and |Q′|x, so
//!
//!   |q| ≥ |E| − |Q′|x,   |q·Q′| ≤ |E·Q′| + |B′||Q′|x,   |q·B′| ≤ |E|(|r′| + |f′|) + |B′||Q′|x,
//!
//! where E·Q′ = ⟨M, M⟩′/2 + ⟨M, W⟩ is as small as the deviation of the cubic. If df″/ds times x is at most F/2 for x = 2|f′|/F, then f′ has its
//! zero within x, and the value there differs by at most f′²/F. Next to cusps of a side F is 0; while the stationary disc is
//! between the two pairs, its value differs by at most |f′|. That disc moves along with u from the first pair of the cubic to the last one,
//! so every point of the side is as near to the cubic.
//!
//! The idea of M is from Choi, Choi and Moon, "Mathematical theory of medial axis transform", Pacific J. Math. 181 (1997).

use crate::bernstein::vector_products::{
    cubic_by_linear, cubic_by_quadratic, cubic_square, quadratic_by_quadratic,
};
use crate::numeric::order::{larger, range, smaller};
use crate::numeric::vector::Euclidean;
use glam::DVec3;

/// The bound between two pairs, for the Bernstein coefficients of M and of W; infinite or NaN if there is none.
///
/// `sign` is −1 where the side runs backwards; `rest` bounds the errors of the cubics for B and r together. Only the
/// comparison with the tolerance counts: a bound up to it may be larger than necessary.
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
    let square = cubic_square(m, product);
    let (min, max) = range(square.into_iter());
    // |E|² = ⟨M, M⟩ + r², and f = ⟨M, M⟩ / (|E| + r).
    let least = larger(least_radius * least_radius + min, 0.0).sqrt();
    let off = larger(max, -min) / (least_radius + least);
    let (min, max) = range(cubic_by_quadratic(m, w, product).into_iter());
    let (along, radius_slope) = (larger(max, -min), largest(w));
    // |E||f′| = |⟨M, W⟩ + f r′|.
    let slope = (along + off * radius_slope) / least;
    let squares = quadratic_by_quadratic(w, w, product);
    let bends = cubic_by_linear(m, &changes, product);
    let (ahead, _) = range((0..5).map(|k| sign * (squares[k] - bends[k])));
    // A lower bound of |E| f″ = ⟨W, W⟩ − ⟨M, W′⟩ − f′(f′ + 2r′) − f r″, times `sign`.
    let curvature = ahead - slope * (2.0 * radius_slope + slope) - off * largest(&changes);
    let reach = 2.0 * slope * size / curvature;
    // f′²/F is half of |f′| times `reach`.
    let (anywhere, near_zero) = (off + slope + rest, off + 0.5 * slope * reach + rest);
    if anywhere <= tolerance || !(curvature > 0.0 && near_zero <= tolerance) {
        return anywhere;
    }
    let longest = |vectors: &[DVec3]| {
        range(vectors.iter().map(|v| v.truncate().length_squared()))
            .1
            .sqrt()
    };
    let (speed, bend) = (longest(w), longest(&changes));
    let cubic_speed = longest(&[0, 1, 2].map(|k| (m[k + 1] - m[k]) * 3.0 + w[k]));
    let (min, max) = range(square.windows(2).map(|pair| pair[1] - pair[0]));
    // Half the derivative of ⟨M, M⟩, of degree 6, has the coefficients 3 (cₖ₊₁ − cₖ).
    let outwards = 3.0 * larger(max, -min) + along;
    let nearest = least - cubic_speed * reach;
    // df″/ds times |q|³.
    let change = 2.0
        * speed
        * (speed * outwards
            + cubic_speed * size * (radius_slope + slope)
            + speed * cubic_speed * reach * (speed + cubic_speed))
        + cubic_speed * bend * nearest * nearest;
    // `nearest` bounds |q| from below; df″/ds times `reach` is then at most F/2.
    let is_proved =
        nearest > 0.0 && 2.0 * size * reach * change <= curvature * nearest * nearest * nearest;
    if is_proved { near_zero } else { anywhere }
}

/// ⟨a, b⟩.
#[inline(always)]
fn product(a: DVec3, b: DVec3) -> f64 {
    a.x * b.x + a.y * b.y - a.z * b.z
}
