//! Nearest point on a spline.

use super::Spline;
use crate::curve::nearest::{Nearest, nearest_on};
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::point::Point;

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
    /// Source: Roussopoulos, Kelley and Vincent, "Nearest neighbor queries", SIGMOD 1995, for the order of the visits.
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
        let bounds: Vec<f64> = (0..self.segment_count())
            .map(|k| self.lower_bound(k, p))
            .collect();
        // Start with the segment of the smallest lower bound, so that most others can be skipped. Visit the others in
        // order, so that of equally near points the first one is found.
        let promising = (0..bounds.len()).fold(0, |a, b| if bounds[b] < bounds[a] { b } else { a });
        let mut best = self.nearest_on_segment(promising, p);
        for k in (0..bounds.len()).filter(|&k| k != promising) {
            if bounds[k] <= best.distance {
                let found = self.nearest_on_segment(k, p);
                let first = found.distance == best.distance && found.t < best.t;
                if found.distance < best.distance || first {
                    best = found;
                }
            }
        }
        best
    }

    fn nearest_on_segment(&self, k: usize, p: P) -> Nearest<P> {
        let (from, to) = (self.starts[k], self.starts[k + 1]);
        let found = match self.points.get(from..=to) {
            Some(points) => nearest_on(points, p),
            // The last segment of a closed spline, whose end is the first point of the list.
            None => nearest_on(self.curve(k).control_points(), p),
        };
        Nearest {
            t: k as f64 + found.t,
            ..found
        }
    }

    /// The distance from p to the bounding box of a segment's control points.
    fn lower_bound(&self, k: usize, p: P) -> f64 {
        let (from, to) = (self.starts[k], self.starts[k + 1]);
        let last = self.points[to % self.points.len()];
        let bounds = Bounds::from_points(&self.points[from..to]);
        bounds.including(last).distance(p)
    }
}
