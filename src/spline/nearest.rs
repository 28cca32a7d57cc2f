//! Nearest point on a spline.

use super::Spline;
use crate::curve::nearest::{Nearest, nearest_of_curves, nearest_on};
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;

impl<P: Point> Spline<P> {
    /// The point of the spline nearest to p, with t from 0 to the number of segments.
    ///
    /// The minimum of |B(t) − p| over all segments, each computed by [`Curve::nearest`](crate::Curve::nearest); of
    /// equally near points the one with the smallest t. Segments whose control-point box is farther away than the best
    /// point so far are skipped, so a long spline costs little more than one distance per box. The distance is in the
    /// unit of the points.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    ///
    /// Source: Roussopoulos, Kelley and Vincent, "Nearest neighbor queries", SIGMOD 1995, for the bounds.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let path = Spline::new(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)].map(DVec2::from), 1, false)?;
    /// let nearest = path.nearest(DVec2::new(3.0, 1.0))?;
    /// assert_eq!((nearest.t, nearest.distance), (1.5, 1.0));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    #[doc(alias = "closest")]
    pub fn nearest(&self, p: P) -> Result<Nearest<P>, Error> {
        check_points("p", &[p])?;
        Ok(self.nearest_to(p))
    }

    /// [`nearest`](Self::nearest) for a point that is known to be finite.
    pub(crate) fn nearest_to(&self, p: P) -> Nearest<P> {
        let segments = (0..self.segment_count()).map(|k| self.segment_points(k));
        let found = nearest_of_curves(segments, p, nearest_on);
        // A spline has at least one segment, so the fallback is never used.
        let (k, found) = found.unwrap_or_else(|| (0, nearest_on(&self.points, p)));
        Nearest {
            t: as_f64(k) + found.t,
            ..found
        }
    }
}
