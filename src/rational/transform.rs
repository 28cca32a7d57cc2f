//! Affine and projective maps.

use super::RationalCurve;
use crate::geometry::check::{check_points, images};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::unit_scale;
use crate::numeric::list::points_of;

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
        let (points, weights) = projected(&self.points, &self.weights, matrix)?;
        Ok(Self {
            points: points_of(&points),
            weights: points_of(&weights),
        })
    }
}

/// The images of control points with weights under a projective map, and their weights; see [`RationalCurve::project`].
pub(super) fn projected<P: Point>(
    points: &[P],
    weights: &[f64],
    matrix: &P::Projective,
) -> Result<(Vec<P>, Vec<f64>), Error> {
    let sign = if points[0].project(matrix).1 < 0.0 {
        -1.0
    } else {
        1.0
    };
    let scale = unit_scale(weights.iter().copied().fold(0.0, f64::max));
    let mut images = (
        Vec::with_capacity(points.len()),
        Vec::with_capacity(points.len()),
    );
    for (index, (&p, w)) in points.iter().zip(weights).enumerate() {
        let (numerator, v) = p.project(matrix);
        let weight = w * scale * v * sign;
        if !(weight > 0.0 && weight < f64::INFINITY) {
            return Err(Error::Item {
                what: "projected weights",
                index,
                expected: "a number above 0 (split the curve where the map sends it to infinity)",
                got: weight,
            });
        }
        images.0.push(numerator / v);
        images.1.push(weight);
    }
    check_points("image", &images.0)?;
    super::check_weights(&images.1, points.len())?;
    Ok(images)
}
