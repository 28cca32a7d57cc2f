//! Bounding boxes of a curve.

use super::Curve;
use crate::bernstein::evaluate::evaluate_scalar;
use crate::bernstein::roots::roots_inside;
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use crate::numeric::list::Scalars;

impl<P: Point> Curve<P> {
    /// The smallest box that contains the curve, computed from its end points and its extrema.
    ///
    /// Exact up to rounding: an extremum is a root of one coordinate of B′, so an error of the root changes the
    /// coordinate only to second order.
    #[doc(alias = "bounding_box")]
    pub fn bounds(&self) -> Bounds<P> {
        let mut bounds = Bounds {
            min: self.start(),
            max: self.start(),
        }
        .including(self.end());
        for axis in 0..P::DIMENSION {
            if self.is_monotone(axis) {
                continue;
            }
            for t in self.extrema_on(axis) {
                bounds = bounds.including(self.only_axis(axis, t, bounds.min));
            }
        }
        bounds
    }

    /// The box of the control points, which contains the curve and is cheaper than [`bounds`](Self::bounds).
    pub fn control_bounds(&self) -> Bounds<P> {
        Bounds::from_points(&self.points)
    }

    /// The parameters inside (0, 1) where one coordinate of B′ vanishes, in ascending order.
    pub(crate) fn extrema_on(&self, axis: usize) -> Scalars {
        let step = |pair: &[P]| pair[1].coordinate(axis) - pair[0].coordinate(axis);
        let slopes: Scalars = self.points.windows(2).map(step).collect();
        roots_inside(&slopes)
    }

    /// Whether the control points are monotone along an axis, so that the curve has no extremum inside.
    fn is_monotone(&self, axis: usize) -> bool {
        let mut pairs = self
            .points
            .windows(2)
            .map(|pair| (pair[0].coordinate(axis), pair[1].coordinate(axis)));
        pairs.clone().all(|(a, b)| a <= b) || pairs.all(|(a, b)| a >= b)
    }

    /// The point `inside` with one coordinate replaced by that of B(t).
    fn only_axis(&self, axis: usize, t: f64, inside: P) -> P {
        let values: Scalars = self.points.iter().map(|p| p.coordinate(axis)).collect();
        inside.with_coordinate(axis, evaluate_scalar(&values, t))
    }
}
