//! Flattening.
//!
//! On a part of the curve let A be its homogeneous control points with the origin c, ρ the largest distance of a control
//! point from c, and w the smallest weight. Linear interpolation of A between two parameters is projected onto the chord
//! between the two points. For a step h its distance from the curve is at most h² M/(8 w) with
//! M = n(n − 1)(max |Δ²(wᵢ(Pᵢ − c))| + ρ max |Δ²wᵢ|), as B₁ − B₂ = (A₁ − A₂ − (w₁ − w₂)B₂)/w₁ for two homogeneous points. So
//! √(M/(8 w · tolerance)) equal steps keep the tolerance. Source of the bound: Zheng and Sederberg, "Estimating tessellation
//! parameter intervals for rational curves and surfaces", ACM TOG 19 (2000).

use super::RationalCurve;
use crate::curve::Polyline;
use crate::curve::flatten::MAX_VERTICES;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;

/// A part is halved if its halves need less than this ratio of its steps.
const WORTH_HALVING: f64 = 0.9;

/// A part of fewer steps is not halved: that takes longer than the vertices that it may save.
const FEW_STEPS: usize = 8;

/// Halvings after which the bound is used as it is: a part of 2⁻⁴⁸ is a point up to rounding.
const PART_HALVINGS: u32 = f64::MANTISSA_DIGITS - 5;

impl<P: Point> RationalCurve<P> {
    /// A polyline whose distance from every point of the curve is at most `tolerance`, in the unit of the input.
    ///
    /// Parts of the curve have equal steps of t, whose number follows from a bound on the second differences of the
    /// homogeneous control points; nothing is sampled. The first and the last vertex are the end points.
    ///
    /// # Errors
    /// [`Error::Range`] for a tolerance that is not above 0, [`Error::Tolerance`] for one below 4 ulps of the largest
    /// coordinate, [`Error::TooMany`] for more than 2²⁴ vertices.
    ///
    /// Source: Zheng and Sederberg, ACM TOG 19 (2000), for the bound.
    pub fn flatten(&self, tolerance: f64) -> Result<Polyline<P>, Error> {
        let size = self.max_abs();
        check_tolerance(tolerance, size)?;
        let mut parts = Vec::new();
        // A part of the tolerance is for the rounding of vertices.
        let kept = tolerance - 2.0 * ulp(size);
        let steps = steps_for(self, kept);
        plan(self, steps, kept, [0.0, 1.0], PART_HALVINGS, &mut parts);
        let count = 1.0 + parts.iter().map(|part| part.steps).sum::<f64>();
        if count > MAX_VERTICES as f64 {
            return Err(Error::too_many(
                "vertices",
                MAX_VERTICES,
                MAX_VERTICES.saturating_add(1),
            ));
        }
        let mut ts = Vec::with_capacity(1 + FEW_STEPS * parts.len());
        ts.push(0.0);
        for part in parts {
            let mut k = 1.0;
            while k <= part.steps {
                ts.push(part.from + part.length * (k / part.steps));
                k += 1.0;
            }
        }
        Ok(Polyline {
            points: self.eval_at(&ts),
            ts,
        })
    }
}

/// A part of the curve and the number of equal steps in it, a whole number from 1.
struct Steps {
    from: f64,
    length: f64,
    steps: f64,
}

fn plan<P: Point>(
    part: &RationalCurve<P>,
    steps: f64,
    tolerance: f64,
    [from, length]: [f64; 2],
    halvings: u32,
    parts: &mut Vec<Steps>,
) {
    if steps >= FEW_STEPS as f64 && halvings > 0 {
        let (left, right) = part.halve();
        let [a, b] = [&left, &right].map(|part| steps_for(part, tolerance));
        if a + b < WORTH_HALVING * steps {
            let half = 0.5 * length;
            plan(&left, a, tolerance, [from, half], halvings - 1, parts);
            let range = [from + half, half];
            return plan(&right, b, tolerance, range, halvings - 1, parts);
        }
    }
    parts.push(Steps {
        from,
        length,
        steps,
    });
}

/// The number of equal steps that keep the tolerance.
fn steps_for<P: Point>(part: &RationalCurve<P>, tolerance: f64) -> f64 {
    let n = part.degree();
    if n == 1 {
        return 1.0;
    }
    let bounds = Bounds::from_points(&part.points);
    let center = bounds.min.lerp(bounds.max, 0.5);
    let points = part.homogeneous(center);
    let (mut bend, mut of_weights, mut min): (f64, f64, f64) = (0.0, 0.0, f64::INFINITY);
    for triple in points.windows(3) {
        let second = triple[0] - triple[1] - (triple[1] - triple[2]);
        bend = bend.max(second.vector.norm());
        of_weights = of_weights.max(second.weight.abs());
    }
    let mut radius: f64 = 0.0;
    for (p, q) in points.iter().zip(&part.points) {
        min = min.min(p.weight);
        radius = radius.max(q.distance(center));
    }
    let bound = (n * (n - 1)) as f64 * (bend + radius * of_weights) / min;
    (bound / (8.0 * tolerance)).sqrt().ceil().max(1.0)
}
