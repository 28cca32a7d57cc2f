//! The limit of the number of vertices, and its check before any is made.

use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::float::as_f64;
use crate::numeric::list::Points;
use crate::numeric::work_limit::WorkLimit;

/// A corrected chord aims at this part of the squared tolerance, slightly below it.
pub(super) const TARGET_USE: f64 = 0.92;

/// Maximum number of vertices that flattening returns.
pub(crate) const MAX_VERTICES: usize = 1 << 24;

/// Steps of the midpoint rule that estimates the number of chords: 16 for each control point at the highest degree, 64.
const FORECAST_STEPS: usize = 1024;

/// The number of vertices that flattening may still make; each of them counts as a step.
pub(crate) struct VertexLimit {
    pub(super) max: usize,
    work: WorkLimit,
}

impl VertexLimit {
    pub(crate) fn new(max: usize) -> Self {
        Self {
            max,
            work: WorkLimit::new(max),
        }
    }

    /// Counts a vertex; returns an error beyond the limit.
    #[inline]
    pub(super) fn spend(&mut self) -> Result<(), Error> {
        if self.work.spend(1) {
            Ok(())
        } else {
            Err(too_many(self.max))
        }
    }
}

fn too_many(limit: usize) -> Error {
    Error::too_many("vertices", limit, limit.saturating_add(1))
}

/// Returns an error if flattening all curves is expected to give more vertices than the limit.
pub(crate) fn check_vertices<P: Point, I: Iterator<Item = Curve<P>>>(
    curves: impl Fn() -> I,
    tolerance: f64,
) -> Result<(), Error> {
    check_vertices_within(curves, tolerance, MAX_VERTICES)
}

pub(super) fn check_vertices_within<P: Point, I: Iterator<Item = Curve<P>>>(
    curves: impl Fn() -> I,
    tolerance: f64,
    limit: usize,
) -> Result<(), Error> {
    // √(n(n−1)/8 · |Δ²P| / tolerance) equal steps are sufficient (Wang, 1984), and |Δ²P| ≤ 4√3 size; this is often a
    // large overestimate.
    let enough = |c: Curve<P>| match c.degree() {
        1 => 1.0,
        n => as_f64(n) * (c.max_abs() / tolerance).sqrt(),
    };
    let max = limit as f64;
    if curves().map(enough).sum::<f64>() <= max
        || curves().map(|c| c.expected_chords(tolerance)).sum::<f64>() < max
    {
        return Ok(());
    }
    Err(too_many(limit))
}

impl<P: Point> Curve<P> {
    /// Estimate of the number of chords at a fine tolerance: ∫ √(|B′ × B″| / |B′|) dt / √(8 tolerance), by the midpoint
    /// rule; accurate to some per cent.
    fn expected_chords(&self, tolerance: f64) -> f64 {
        let size = self.max_abs();
        let scaled: Points<P> = self.points.iter().map(|&p| p / size).collect();
        let first = Self { points: scaled }.derivative();
        let second = first.derivative();
        let density = |k: usize| {
            let t = (k as f64 + 0.5) / FORECAST_STEPS as f64;
            let (v, a) = (first.eval(t), second.eval(t));
            let speed = v.length();
            if speed > 0.0 {
                (v.cross(a).size_squared().sqrt() / speed).sqrt()
            } else {
                0.0
            }
        };
        let mut work = WorkLimit::new(FORECAST_STEPS);
        let _counted = work.spend(FORECAST_STEPS);
        let mean = (0..FORECAST_STEPS).map(density).sum::<f64>() / FORECAST_STEPS as f64;
        mean / (8.0 * TARGET_USE.sqrt() * (tolerance / size)).sqrt()
    }
}
