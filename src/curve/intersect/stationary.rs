//! Zeros of the derivative, and segments without reversals.

use super::constants::{DOUBLE_ROOT, NEVER_RATIO, VANISHING_RATIO};
use crate::bernstein::evaluate::evaluate;
use crate::bernstein::roots::roots_inside;
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars};
use crate::numeric::sort::sort_by;
use glam::DVec2;

/// The parameters inside (0, 1) where the derivative vanishes: cusps, and reversals of a straight curve.
pub(crate) fn derivative_zeros(points: &[DVec2]) -> Scalars {
    let mut found = Scalars::new();
    if is_monotone_along_chord(points) || has_no_derivative_zero(points) {
        return found;
    }
    let slopes: Points<DVec2> = points.windows(2).map(|p| p[1] - p[0]).collect();
    let max = VANISHING_RATIO * slopes.iter().fold(0.0, |m: f64, p| m.max(p.max_abs()));
    for axis in 0..2 {
        let row: Scalars = slopes.iter().map(|p| p.coordinate(axis)).collect();
        let still = |&t: &f64| evaluate(&slopes, t).max_abs() <= max;
        found.extend(roots_inside(&row).into_iter().filter(still));
    }
    sort_by(&mut found, f64::total_cmp);
    found.dedup_by(|next, last| *next - *last <= DOUBLE_ROOT);
    found
}

/// Whether the derivative of a quadratic or a cubic certainly vanishes nowhere: the resultant of its coordinates,
/// computed from cross products of the control edges, is not 0.
fn has_no_derivative_zero(points: &[DVec2]) -> bool {
    let edge = |i: usize| points[i + 1] - points[i];
    let (resultant, size) = match points.len() {
        3 => (edge(0).perp_dot(edge(1)), edge(0).perp_dot(edge(1).perp())),
        4 => {
            let (e, f, g) = (edge(0), edge(1), edge(2));
            let (ef, eg, fg) = (e.perp_dot(f), e.perp_dot(g), f.perp_dot(g));
            let product = 4.0 * ef * fg;
            let max = e.max_abs().max(f.max_abs()).max(g.max_abs());
            (eg * eg - product, max * max * max * max)
        }
        _ => return false,
    };
    resultant.abs() > NEVER_RATIO * size.abs()
}

/// Whether no control edge points against the chord; then the curve passes no point twice.
pub(crate) fn is_monotone_along_chord(points: &[DVec2]) -> bool {
    let chord = points[points.len() - 1] - points[0];
    chord != DVec2::ZERO && points.windows(2).all(|p| (p[1] - p[0]).dot(chord) >= 0.0)
}

/// The given parameters with 0 and 1 added: the ends of the segments between them.
pub(crate) fn with_ends(inside: &[f64]) -> Vec<f64> {
    let mut all = vec![0.0];
    all.extend(inside);
    all.push(1.0);
    all
}
