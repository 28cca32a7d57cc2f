//! Simplification: approximation of a path by fewer segments.

use super::Path;
use crate::geometry::error::Error;
use crate::spline::Spline;
use glam::DVec2;

impl Path {
    /// A path of fewer lines and cubics: each subpath is simplified as by [`Spline::simplify`].
    ///
    /// # Errors
    /// As [`Spline::simplify`], for the first subpath that has one.
    pub fn simplify(&self, tolerance: f64) -> Result<Self, Error> {
        self.map_subpaths(|spline| spline.simplify(tolerance))
    }

    /// [`simplify`](Self::simplify) with the smallest turn that is kept as a corner, as in [`Spline::simplify_with`].
    ///
    /// # Errors
    /// As [`Spline::simplify_with`], for the first subpath that has one.
    pub fn simplify_with(&self, tolerance: f64, corner_angle: f64) -> Result<Self, Error> {
        self.map_subpaths(|spline| spline.simplify_with(tolerance, corner_angle))
    }

    fn map_subpaths(
        &self,
        map: impl Fn(Spline<DVec2>) -> Result<Spline<DVec2>, Error>,
    ) -> Result<Self, Error> {
        let splines: Vec<_> = self.subpaths().map(map).collect::<Result<_, _>>()?;
        Ok(Self::new(&splines))
    }
}
