//! The decimal grid on which the control points of a simplified spline lie.

use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;

/// The points whose coordinates have a number of decimals.
#[derive(Clone, Copy)]
pub(crate) struct DecimalGrid {
    /// The number of steps per unit, 10 to the power of the decimals.
    steps: f64,
    /// The largest distance by which a point is moved.
    pub(crate) radius: f64,
}

/// The most decimals to which coordinates can be rounded.
const MAX_DECIMALS: u8 = 15;

/// The largest part of the tolerance by which a point may be moved.
const MAX_PART: f64 = 0.96;

/// Beyond this number of steps from 0 each f64 is on the grid.
const MAX_STEPS: f64 = (1_u64 << 52) as f64;

impl DecimalGrid {
    /// The grid, if it moves the points by at most 0.96 of the tolerance.
    pub(crate) fn new<P: Point>(decimals: u8, points: &[P], tolerance: f64) -> Result<Self, Error> {
        let steps = 10_f64.powi(i32::from(decimals));
        // A plane z = 0 stays.
        let moves = |axis: &usize| points.iter().any(|p| p.coordinate(*axis) != 0.0);
        let dimension = (0..P::DIMENSION).filter(moves).count();
        // Each coordinate moves by at most half a step.
        let radius = 0.5 * (dimension as f64).sqrt() / steps;
        let grid = Self { steps, radius };
        let fault = if decimals > MAX_DECIMALS {
            "at most 15 decimals"
        } else if radius > MAX_PART * tolerance {
            "decimals that round a point by at most 0.96 of the tolerance"
        } else {
            return Ok(grid);
        };
        Err(Error::Range {
            what: "precision",
            expected: fault,
            got: f64::from(decimals),
        })
    }

    /// The point of the grid next to a point.
    pub(crate) fn nearest<P: Point>(self, mut point: P) -> P {
        for axis in 0..P::DIMENSION {
            let steps = point.coordinate(axis) * self.steps;
            if steps.abs() < MAX_STEPS {
                // Adding 0 makes -0 positive.
                point = point.with_coordinate(axis, steps.round() / self.steps + 0.0);
            }
        }
        point
    }
}

/// A grid under a normalization.
#[derive(Clone, Copy)]
pub(crate) struct NormalizedGrid<P> {
    pub(crate) grid: DecimalGrid,
    pub(crate) normalized: Normalized<P>,
}

impl<P: Point> NormalizedGrid<P> {
    /// The image of the point of the grid next to the point with an image.
    pub(crate) fn nearest(self, image: P) -> P {
        let Normalized { origin, scale } = self.normalized;
        (self.grid.nearest(self.normalized.inverse(image)) - origin) * scale
    }
}
