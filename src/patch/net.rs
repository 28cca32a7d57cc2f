//! Control nets as slices: u is the fast index, and `columns` is the length of a row.

use crate::bernstein::evaluate::evaluate;
use crate::numeric::list::Points;
use glam::DVec3;

pub(crate) use crate::numeric::list::Net;

/// The point of the tensor product: each row is evaluated at u, then the curve of these points at v.
pub(crate) fn evaluate_net(net: &[DVec3], columns: usize, u: f64, v: f64) -> DVec3 {
    evaluate(&curve_at_u(net, columns, u), v)
}

/// The control points of the curve u = constant.
pub(crate) fn curve_at_u(net: &[DVec3], columns: usize, u: f64) -> Points<DVec3> {
    net.chunks(columns).map(|row| evaluate(row, u)).collect()
}

/// The net with u and v exchanged.
pub(crate) fn transpose(net: &[DVec3], columns: usize) -> Net {
    (0..columns)
        .flat_map(|i| net.iter().skip(i).step_by(columns).copied())
        .collect()
}

/// The differences of neighbouring points along u, which have one column fewer; zeros for a single column.
pub(crate) fn differences_u(net: &[DVec3], columns: usize) -> Net {
    if columns < 2 {
        return std::iter::repeat_n(DVec3::ZERO, net.len()).collect::<Net>();
    }
    let mut differences = Net::with_capacity(net.len());
    for row in net.chunks(columns) {
        differences.extend(row.iter().zip(&row[1..]).map(|(&a, &b)| b - a));
    }
    differences
}

/// The differences of neighbouring points along v, which have one row fewer; zeros for a single row.
pub(crate) fn differences_v(net: &[DVec3], columns: usize) -> Net {
    if net.len() <= columns {
        return std::iter::repeat_n(DVec3::ZERO, net.len()).collect::<Net>();
    }
    net.iter()
        .zip(&net[columns..])
        .map(|(&a, &b)| b - a)
        .collect()
}

/// Scales differences so that their largest coordinate is ±1, so that their products neither overflow nor vanish.
/// Differences that are all zero stay zero.
pub(crate) fn unit_size(differences: &mut [DVec3]) {
    let size = crate::geometry::check::max_abs(differences);
    // Below this size the reciprocal is not finite; a shape of that size counts as a point.
    let factor = if size < f64::MIN_POSITIVE * 8.0 {
        0.0
    } else {
        1.0 / size
    };
    for d in differences {
        *d *= factor;
    }
}
