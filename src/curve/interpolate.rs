//! Interpolation: the curve through given points.

use super::Curve;
use crate::geometry::check::{check_points, is_within_limit};
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::numeric::list::points_of;
use crate::numeric::list::{Points, Scalars};

/// Rounds of iterative refinement: the remaining differences between curve and points are interpolated and added.
const REFINEMENTS: usize = 2;

impl<P: Point> Curve<P> {
    /// The curve of degree n − 1 through n points at given parameters, P(tᵢ) = pᵢ.
    ///
    /// n is 2 to 65. Without given parameters, they are chord-length parameters from 0 to 1, or uniform if two
    /// neighbouring points coincide. Given parameters may have any value and order. Points at t = 0 and t = 1 are
    /// exact, as control points; the others are interpolated with an error of some ulps of the largest control point
    /// (checked up to 16 points). The control points are much larger than the points if many points are interpolated:
    /// above about ten, uniform parameters make the curve oscillate between the points (Runge's phenomenon), and an
    /// interpolating spline is the better choice. Parameters that are denser toward the ends, ½ − ½cos(πi/(n−1)), avoid
    /// this. Source: Newton's interpolation with the products in Bernstein form; Ainsworth and Sánchez, "Computing the
    /// Bézier control points of the Lagrangian interpolant in arbitrary dimension", SIAM J. Sci. Comput. 38 (2016).
    ///
    /// # Errors
    /// [`Error::Count`] unless there are 2 to 65 points and as many parameters, [`Error::NotFinite`] for a NaN or an
    /// infinity, [`Error::Range`] for equal parameters.
    pub fn interpolate(points: &[P], ts: Option<&[f64]>) -> Result<Self, Error> {
        check_points("points", points)?;
        let ts = ts.map_or_else(|| chord_lengths(points), Scalars::from);
        check_interpolation(points.len(), &ts)?;
        let mut curve = interpolate(points, &ts);
        for _ in 0..REFINEMENTS {
            let missing: Points<P> = points
                .iter()
                .zip(&ts)
                .map(|(&p, &t)| p - crate::bernstein::evaluate::evaluate(&curve, t))
                .collect();
            let repair = interpolate(&missing, &ts);
            let better: Points<P> = curve.iter().zip(&repair).map(|(&p, &q)| p + q).collect();
            if !better.iter().all(|&p| is_within_limit(p)) {
                break;
            }
            curve = better;
        }
        for (&t, &p) in ts.iter().zip(points) {
            let last = curve.len() - 1;
            if t == 0.0 {
                curve[0] = p;
            } else if t == 1.0 {
                curve[last] = p;
            }
        }
        match curve.iter().find(|&&p| !is_within_limit(p)) {
            Some(p) => Err(Error::Range {
                what: "ts",
                expected: "parameters so far apart that the control points stay below 2^500",
                got: p.max_abs(),
            }),
            None => Ok(Self::from_points(curve)),
        }
    }
}

fn check_interpolation(count: usize, ts: &[f64]) -> Result<(), Error> {
    if !(2..=MAX_DEGREE + 1).contains(&count) {
        return Err(Error::Count {
            what: "points",
            expected: "2 to 65 points",
            got: count,
        });
    }
    if ts.len() != count {
        return Err(Error::Count {
            what: "ts",
            expected: "a parameter for each point",
            got: ts.len(),
        });
    }
    Error::unless_finite("ts", ts)?;
    let twice = |i: usize| ts[..i].contains(&ts[i]);
    match (1..count).find(|&i| twice(i)) {
        Some(i) => Err(Error::Range {
            what: "ts",
            expected: "parameters that differ",
            got: ts[i],
        }),
        None => Ok(()),
    }
}

/// Chord-length parameters from 0 to 1; uniform ones if a chord has length 0.
fn chord_lengths<P: Point>(points: &[P]) -> Scalars {
    let quarter = |pair: &[P]| (pair[1] * 0.25 - pair[0] * 0.25).norm() / 128.0;
    let total: f64 = points.windows(2).map(quarter).sum();
    let last = points.len().saturating_sub(1);
    let mut sum = 0.0;
    let mut ts: Scalars = [0.0].into_iter().collect();
    ts.extend(points.windows(2).map(|pair| {
        sum += quarter(pair);
        sum / total
    }));
    ts[last] = 1.0;
    if ts.windows(2).all(|t| t[0] < t[1]) {
        return ts;
    }
    (0..=last).map(|i| ratio(i, last.max(1))).collect()
}

/// Newton interpolation: p(k) = p(k−1) + [p₀ … pₖ] (t − t₀) … (t − t(k−1)), with all polynomials in Bernstein form.
fn interpolate<P: Point>(points: &[P], ts: &[f64]) -> Points<P> {
    let mut divided: Points<P> = points_of(points);
    for level in 1..points.len() {
        for i in (level..points.len()).rev() {
            divided[i] = (divided[i] - divided[i - 1]) / (ts[i] - ts[i - level]);
        }
    }
    let mut sum: Points<P> = points_of(&divided[..1]);
    let mut product: Scalars = [1.0].into_iter().collect();
    for k in 1..points.len() {
        let (root, old) = (ts[k - 1], product);
        // (t − r) q has the coefficients i/k (1 − r) q(i−1) − (1 − i/k) r q(i).
        let mixed = |i: usize, low: &dyn Fn(usize) -> f64, a: f64, b: f64| {
            let part = ratio(i, k);
            let upper = if i > 0 { part * a * low(i - 1) } else { 0.0 };
            upper
                + if i < k {
                    (1.0 - part) * b * low(i)
                } else {
                    0.0
                }
        };
        product = (0..=k)
            .map(|i| mixed(i, &|j| old[j], 1.0 - root, -root))
            .collect();
        let raised = |i: usize| {
            let part = ratio(i, k);
            let upper = if i > 0 {
                sum[i - 1] * part
            } else {
                P::default()
            };
            let lower = if i < k {
                sum[i] * (1.0 - part)
            } else {
                P::default()
            };
            upper + lower
        };
        sum = (0..=k)
            .map(|i| raised(i) + divided[k] * product[i])
            .collect();
    }
    sum
}
