//! Simplification: approximation of a path by fewer segments.

use super::Path;
use crate::geometry::error::Error;
use crate::spline::SimplifyOptions;

impl Path {
    /// A path of fewer lines and cubics: each subpath is simplified as by [`Spline::simplify`](crate::Spline::simplify).
    ///
    /// See [`simplify_with`](Self::simplify_with) for joints at extrema and for rounded control points.
    ///
    /// # Errors
    /// As [`Spline::simplify`](crate::Spline::simplify), for the first subpath that has one.
    pub fn simplify(&self, tolerance: f64) -> Result<Self, Error> {
        self.simplify_with(&SimplifyOptions::new(tolerance))
    }

    /// [`simplify`](Self::simplify) with all options.
    ///
    /// # Errors
    /// As [`Spline::simplify_with`](crate::Spline::simplify_with), for the first subpath that has one.
    pub fn simplify_with(&self, options: &SimplifyOptions) -> Result<Self, Error> {
        let simple = self.subpaths().map(|spline| spline.simplify_with(options));
        Ok(Self::new(&simple.collect::<Result<Vec<_>, _>>()?))
    }
}
