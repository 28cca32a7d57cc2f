//! Nearest point on a path.

use super::{Path, PathTime};
use crate::curve::nearest::{BOX_ROUNDING, Nearest, nearest_of_curves, nearest_on};
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::list::Points;
use glam::{DVec2, DVec3};

/// A point of a path and its distance from the query point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PathPoint {
    /// The index of the subpath.
    pub subpath: usize,
    /// The parameter on it, from 0 to its number of segments.
    pub t: f64,
    /// The point at t.
    pub point: DVec2,
    /// The distance from the query point.
    pub distance: f64,
}

impl PathPoint {
    /// The position of the point on the path.
    pub const fn time(&self) -> PathTime {
        PathTime::new(self.subpath, self.t)
    }
}

impl Path {
    /// The point of the path nearest to p, the first of equally near ones; `None` for the empty path.
    ///
    /// The minimum of [`Curve::nearest`](crate::Curve::nearest) over the segments; segments whose control-point box is
    /// farther away than the best point so far are skipped.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    #[doc(alias = "closest")]
    pub fn nearest(&self, p: DVec2) -> Result<Option<PathPoint>, Error> {
        check_points("p", &[p])?;
        let found = nearest_of_curves(self.segment_points(), p, nearest_on_segment);
        Ok(found.map(|(k, Nearest { t, point, distance })| {
            let subpath = self.subpaths.partition_point(|part| part.segments <= k);
            let first = self.segments_before(subpath);
            PathPoint {
                subpath,
                t: as_f64(k - first) + t,
                point,
                distance,
            }
        }))
    }

    /// The path of several that is nearest to p, for hit testing: its index and its nearest point. The first of equally
    /// near ones; `None` if all are farther than `max_distance`, and for empty paths.
    ///
    /// Paths whose control-point box is farther away than the best point so far are skipped.
    ///
    /// ```
    /// use casteljau::{Path, glam::dvec2};
    ///
    /// let paths = [0.0, 5.0].map(|x| Path::rect(dvec2(x, 0.0), dvec2(3.0, 3.0)).expect("finite"));
    /// let hit = Path::nearest_of(&paths, dvec2(4.5, 1.0), 1.0)?.expect("near");
    /// assert_eq!((hit.0, hit.1.distance), (1, 0.5));
    /// assert_eq!(Path::nearest_of(&paths, dvec2(40.0, 1.0), 1.0)?, None);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity in p, [`Error::Range`] for a distance that is negative or NaN.
    pub fn nearest_of<'a>(
        paths: impl IntoIterator<Item = &'a Self>,
        p: DVec2,
        max_distance: f64,
    ) -> Result<Option<(usize, PathPoint)>, Error> {
        check_points("p", &[p])?;
        if max_distance.is_nan() || max_distance < 0.0 {
            return Err(Error::Range {
                what: "max_distance",
                expected: "a number from 0",
                got: max_distance,
            });
        }
        let mut best: Option<(usize, PathPoint)> = None;
        for (index, path) in paths.into_iter().enumerate() {
            let limit = best.map_or(max_distance, |(_, found)| found.distance);
            let is_near = |bounds: Bounds<DVec2>| bounds.distance(p) * BOX_ROUNDING <= limit;
            if !path.control_bounds().is_some_and(is_near) {
                continue;
            }
            let is_nearer = |distance: f64| distance < limit || best.is_none() && distance == limit;
            best = match path.nearest(p)? {
                Some(found) if is_nearer(found.distance) => Some((index, found)),
                _ => best,
            };
        }
        Ok(best)
    }
}

/// The nearest point of one segment; without the feature `fast` it is computed in space, which reuses the code of all
/// curves and takes 1.2 to 1.7 times as long.
fn nearest_on_segment(points: &[DVec2], p: DVec2) -> Nearest<DVec2> {
    if cfg!(feature = "fast") {
        return nearest_on(points, p);
    }
    let points: Points<DVec3> = points.iter().map(|q| q.to_3d()).collect();
    let Nearest { t, point, distance } = nearest_on(&points, p.to_3d());
    Nearest {
        t,
        point: point.to_2d(),
        distance,
    }
}
