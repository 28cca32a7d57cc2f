//! Bounding boxes and flattening of paths.

use super::{Path, PathTime};
use crate::curve::Curve;
use crate::curve::flatten::{MAX_VERTICES, Polyline, check_vertices, visit_vertices};
use crate::geometry::bounds::Bounds;
use crate::geometry::check::{check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use glam::{DVec2, DVec3};

impl Path {
    /// The tight bounding box of the path; `None` for the empty path.
    ///
    /// Exact up to rounding, as [`Curve::bounds`]. Extrema are computed only for segments with control points outside
    /// the box of all joints.
    #[doc(alias = "bounding_box")]
    pub fn bounds(&self) -> Option<Bounds<DVec2>> {
        let first = *self.points.first()?;
        let joints = self.segment_points().map(|points| points[points.len() - 1]);
        let joined = joints.fold(corners(first, first), Bounds::including);
        let segments = self.segment_points();
        Some(segments.fold(joined, |bounds, points| {
            let inside = |p: &DVec2| p.cmpge(bounds.min).all() && p.cmple(bounds.max).all();
            if points.iter().all(inside) {
                bounds
            } else {
                bounds.union(exact(points))
            }
        }))
    }

    /// The bounding box of the control points, which contains the path and is cheaper than [`bounds`](Self::bounds).
    pub fn control_bounds(&self) -> Option<Bounds<DVec2>> {
        (!self.points.is_empty()).then(|| Bounds::from_points(&self.points))
    }

    /// A polyline within `tolerance` of each subpath; every joint is a vertex, and the polyline of a closed subpath
    /// ends at its start.
    ///
    /// # Errors
    /// As [`Spline::flatten`](crate::Spline::flatten), with the limit of 2²⁴ vertices for all subpaths together.
    pub fn flatten(&self, tolerance: f64) -> Result<Vec<Polyline<DVec2>>, Error> {
        let mut lines = vec![Polyline::default(); self.subpath_count()];
        self.flatten_with(tolerance, |PathTime { subpath, t }, point| {
            lines[subpath].ts.push(t);
            lines[subpath].points.push(point);
        })?;
        Ok(lines)
    }

    /// Same as [`flatten`](Self::flatten), but passes each vertex to `vertex` instead of collecting them; a subpath
    /// starts with t = 0.
    ///
    /// # Errors
    /// As [`Curve::flatten_with`].
    pub fn flatten_with(
        &self,
        tolerance: f64,
        mut vertex: impl FnMut(PathTime, DVec2),
    ) -> Result<(), Error> {
        let size = self.max_abs();
        check_tolerance(tolerance, size)?;
        check_vertices(
            (self.points.len(), size),
            || self.segment_points().map(Curve::from_slice),
            tolerance,
            MAX_VERTICES,
        )?;
        for (subpath, part) in self.parts().enumerate() {
            for (k, points) in part.segments().enumerate() {
                let time = |t| PathTime::new(subpath, as_f64(k) + t);
                visit_vertices(points, k > 0, tolerance, |t, p| vertex(time(t), p));
            }
        }
        Ok(())
    }

    /// The control points of all segments.
    pub(crate) fn segment_points(&self) -> impl Iterator<Item = &[DVec2]> + Clone {
        self.parts().flat_map(|part| part.segments())
    }

    /// The largest absolute coordinate.
    pub(crate) fn max_abs(&self) -> f64 {
        max_abs(&self.points)
    }
}

fn corners(a: DVec2, b: DVec2) -> Bounds<DVec2> {
    Bounds { min: a, max: a }.including(b)
}

/// The tight box of one segment, computed in space, which reuses the code of all curves and takes no longer.
fn exact(points: &[DVec2]) -> Bounds<DVec2> {
    let points = points.iter().map(|p| p.to_3d()).collect();
    let Bounds { min, max } = Curve::<DVec3>::from_points(points).bounds();
    Bounds {
        min: min.to_2d(),
        max: max.to_2d(),
    }
}
