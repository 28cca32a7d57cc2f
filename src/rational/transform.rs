//! Affine and projective maps.

use super::RationalCurve;
use crate::geometry::check::{check_points, images};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars, points_of};

impl<P: Point> RationalCurve<P> {
    /// The image of the curve under an affine map, which is the curve of the mapped control points with the same weights.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn transform(&self, map: &P::Affine) -> Result<Self, Error> {
        let points = points_of(&images(&self.points, map)?);
        let weights = self.weights.clone();
        Ok(Self { points, weights })
    }

    /// The image of the curve under a projective map, a matrix of 3 × 3 numbers in the plane and 4 × 4 in space.
    ///
    /// (P, 1) is mapped to (Q, v), the point Q/v; the new weight is wᵢvᵢ, so the image is exact. A matrix and its multiples
    /// are the same map.
    ///
    /// # Errors
    /// [`Error::Item`] for the first weight that would not have the sign of the others: the line (or plane) that
    /// the map sends to infinity passes between the control points. Split the curve and map the parts; a part that does not
    /// meet that line has positive weights once it is short enough. Otherwise as [`transform`](Self::transform).
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §13.2.
    pub fn project(&self, matrix: &P::Projective) -> Result<Self, Error> {
        let images: Points<(P, f64)> = self.points.iter().map(|p| p.project(matrix)).collect();
        let sign = if images[0].1 < 0.0 { -1.0 } else { 1.0 };
        let scale = self.weight_scale();
        let mut weights = Scalars::new();
        let mut points = Points::new();
        for (index, (&(numerator, v), w)) in images.iter().zip(&self.weights).enumerate() {
            let weight = w * scale * v * sign;
            if !(weight > 0.0 && weight < f64::INFINITY) {
                return Err(Error::Item {
                    what: "projected weights",
                    index,
                    expected: "a number above 0 (split the curve where the map sends it to infinity)",
                    got: weight,
                });
            }
            points.push(numerator / v);
            weights.push(weight);
        }
        check_points("image", &points)?;
        super::check_weights(&weights, points.len())?;
        Ok(Self { points, weights })
    }
}
