//! Lofts: surfaces through curves.

use super::{Direction, NurbsSurface};
use crate::geometry::error::Error;
use crate::numeric::float::as_f64;
use crate::patch::tensor_product::check_degree;
use crate::rational::nurbs::NurbsCurve;
use crate::rational::nurbs::interpolate::{centripetal, solved};
use crate::rational::weighted::{Homogeneous, WeightedPoint, transposed};
use glam::DVec3;

/// Knots over [0, 1] that are closer than this are one knot: the domains of curves are mapped with rounding.
const SAME_KNOT: f64 = 16.0 * f64::EPSILON;

/// Weights with this relative difference are equal.
const SAME_WEIGHT: f64 = 16.0 * f64::EPSILON;

impl NurbsSurface {
    /// The surface of a degree in v through curves, which are its isocurves at increasing v; u runs along them.
    ///
    /// The curves should run in the same direction; closed ones start at their seams, which should lie side by side. They are brought
    /// to one degree, the domain [0, 1], the same knots and a first weight of 1, which does not change them. The parameters in v are
    /// the means over all columns of control points of those of [`NurbsCurve::interpolate`], and each column is interpolated: the
    /// points alone if corresponding weights are equal, otherwise in homogeneous coordinates.
    ///
    /// # Errors
    /// [`Error::Range`] for a degree outside 1 to 64, and for curves of which some are closed and some open; [`Error::Count`] for fewer
    /// than degree + 1 curves; [`Error::Item`] for a curve that is equal to the one before, and for weights whose interpolation is
    /// not above 0; those of [`NurbsCurve::elevate`] and [`NurbsCurve::refine`] for large input.
    ///
    /// Source: Piegl and Tiller, *The NURBS Book*, §10.3.
    pub fn loft(curves: &[NurbsCurve<DVec3>], degree: usize) -> Result<Self, Error> {
        check_degree("degree", degree)?;
        if curves.len() < degree + 1 {
            return Err(Error::Count {
                what: "curves",
                expected: "at least degree + 1 curves",
                got: curves.len(),
            });
        }
        let is_closed = curves[0].is_closed();
        if let Some(index) = curves.iter().position(|c| c.is_closed() != is_closed) {
            return Err(Error::Range {
                what: "index of the first curve of another kind",
                expected: "either open or closed curves",
                got: as_f64(index),
            });
        }
        let united = united(&curves.iter().collect::<Vec<_>>())?;
        let columns = united[0].control_points().len();
        let rows: Vec<WeightedPoint<DVec3>> =
            united.iter().flat_map(NurbsCurve::weighted).collect();
        let across = transposed(&rows, columns);
        let count = united.len();
        let ts = mean_parameters(&across, count);
        if let Some(index) = (1..count).find(|&i| ts[i - 1] >= ts[i]) {
            return Err(Error::Item {
                what: "curves",
                index,
                expected: "a curve that differs from the one before",
                got: ts[index],
            });
        }
        let mut knots = vec![0.0; degree + 1];
        let inner = 1..count - degree;
        knots.extend(inner.map(|j| ts[j..j + degree].iter().sum::<f64>() / as_f64(degree)));
        knots.extend(std::iter::repeat_n(1.0, degree + 1));
        let solve = |points: &[DVec3]| solved(points, &ts, &knots, degree);
        let first = united[0].weights();
        let alike = |(i, part): (usize, &WeightedPoint<DVec3>)| {
            let weight = first[i % columns];
            (part.weight - weight).abs() <= SAME_WEIGHT * weight
        };
        let is_plain = rows.iter().enumerate().all(alike);
        let mut parts = Vec::with_capacity(across.len());
        for (column, row) in across.chunks(count).enumerate() {
            let list = |of: &dyn Fn(&WeightedPoint<DVec3>) -> DVec3| -> Vec<DVec3> {
                solve(&row.iter().map(of).collect::<Vec<_>>())
            };
            if is_plain {
                let weight = first[column];
                let points = list(&|part| part.point).into_iter();
                parts.extend(points.map(|point| WeightedPoint { point, weight }));
                continue;
            }
            let vectors = list(&|part| part.point * part.weight);
            let weights = list(&|part| DVec3::X * part.weight);
            for (index, (&vector, &DVec3 { x: weight, .. })) in
                vectors.iter().zip(&weights).enumerate()
            {
                if weight <= 0.0 {
                    return Err(Error::Item {
                        what: "weights in v",
                        index,
                        expected: "a number above 0 (the weights of the curves differ too much)",
                        got: weight,
                    });
                }
                let point = Homogeneous { vector, weight }.point();
                parts.push(WeightedPoint { point, weight });
            }
            // The first and the last curve keep their bits.
            let (from, to) = (parts.len() - count, parts.len() - 1);
            (parts[from], parts[to]) = (row[0], row[count - 1]);
        }
        let u = Direction::new(united[0].degree(), united[0].knots());
        Self::from_weighted(
            &transposed(&parts, count),
            u,
            Direction::new(degree, &knots),
        )
    }
}

/// The means of the centripetal parameters over all columns whose points differ.
fn mean_parameters(across: &[WeightedPoint<DVec3>], count: usize) -> Vec<f64> {
    let mut sums = vec![0.0; count];
    let mut columns = 0_usize;
    for column in across.chunks(count) {
        let points: Vec<DVec3> = column.iter().map(|part| part.point).collect();
        if points.iter().any(|&p| p != points[0]) {
            columns += 1;
            for (sum, t) in sums.iter_mut().zip(centripetal(&points)) {
                *sum += t;
            }
        }
    }
    sums.iter_mut()
        .for_each(|sum| *sum /= as_f64(columns.max(1)));
    sums
}

/// The same curves with one degree, the domain [0, 1], the same knots, and a first weight of 1.
pub(super) fn united(curves: &[&NurbsCurve<DVec3>]) -> Result<Vec<NurbsCurve<DVec3>>, Error> {
    let degree = curves.iter().map(|curve| curve.degree()).max().unwrap_or(1);
    let mut open = Vec::with_capacity(curves.len());
    for curve in curves {
        let mut curve = curve.subsegment(..)?;
        while curve.degree() < degree {
            curve = curve.elevate()?;
        }
        open.push(curve);
    }
    let unit_knots = |curve: &NurbsCurve<DVec3>| -> Vec<f64> {
        let [from, to] = curve.domain();
        let knots = curve.knots().iter();
        knots.map(|u| (u - from) / (to - from)).collect()
    };
    let mut all: Vec<f64> = open.iter().flat_map(unit_knots).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, before| *next - *before <= SAME_KNOT);
    // All knots of a group have the value of its first one, at the end 1.
    let value = |group: usize| {
        if group + 1 == all.len() {
            1.0
        } else {
            all[group]
        }
    };
    let group = |u: f64| all.partition_point(|&first| first <= u).saturating_sub(1);
    let mut counts = vec![0; all.len()];
    for curve in &mut open {
        let groups: Vec<usize> = unit_knots(curve).into_iter().map(group).collect();
        for (index, count) in counts.iter_mut().enumerate() {
            *count = groups.iter().filter(|&&g| g == index).count().max(*count);
        }
        let knots: Vec<f64> = groups.iter().map(|&g| value(g)).collect();
        let first = curve.weights()[0];
        let weights: Vec<f64> = curve.weights().iter().map(|w| w / first).collect();
        let points = curve.control_points();
        *curve = NurbsCurve::new(degree, points, Some(&weights), &knots, false)?;
    }
    let missing = |curve: &NurbsCurve<DVec3>| -> Vec<f64> {
        let present = |u: f64| curve.knots().iter().filter(|&&knot| knot == u).count();
        let groups = counts.iter().enumerate();
        groups
            .flat_map(|(g, &count)| std::iter::repeat_n(value(g), count - present(value(g))))
            .collect()
    };
    open.iter()
        .map(|curve| curve.refine(&missing(curve)))
        .collect()
}
