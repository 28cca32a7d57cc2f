//! Which point of the spline is nearest?

use super::Spline;
use crate::curve::nearest::{Nearest, nearest_on};
use crate::geometry::check::check_finite;
use crate::geometry::error::Error;
use crate::geometry::point::Point;

impl<P: Point> Spline<P> {
    /// The point of the spline that is nearest to p, with t from 0 to the number of segments.
    ///
    /// The least |B(t) − p| of all segments, each as [`Curve::nearest`](crate::Curve::nearest) finds it; of equally near points
    /// the one with the smallest t. Segments whose control points' box is farther away than what was found are left out:
    /// a long chain costs one look at each box and little more. The distance is in the unit of the points.
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
    pub fn nearest(&self, p: P) -> Result<Nearest<P>, Error> {
        check_finite("p", &[p])?;
        Ok(self.nearest_to(p))
    }

    /// [`nearest`](Self::nearest) to a point that is finite.
    pub(crate) fn nearest_to(&self, p: P) -> Nearest<P> {
        let bounds: Vec<f64> = (0..self.segment_count())
            .map(|k| self.lower_bound(k, p))
            .collect();
        // The most promising first, so that most others can be left out; then in order, so that of equal ones the first
        // is found.
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
            // The last segment of a closed spline.
            None => nearest_on(self.curve(k).control_points(), p),
        };
        Nearest {
            t: k as f64 + found.t,
            ..found
        }
    }

    /// The distance of p from the box of a segment's control points.
    fn lower_bound(&self, k: usize, p: P) -> f64 {
        let (from, to) = (self.starts[k], self.starts[k + 1]);
        let last = self.points[to % self.points.len()];
        let around = |(low, high): (P, P), &q: &P| (low.min(q), high.max(q));
        let (low, high) = self.points[from..to].iter().fold((last, last), around);
        // Halves: the difference of ±1e308 would overflow.
        let outside = (low * 0.5 - p * 0.5).max(p * 0.5 - high * 0.5);
        outside.max(P::default()).length() * 2.0
    }
}
