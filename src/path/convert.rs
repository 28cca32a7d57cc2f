//! Conversion of curves and splines to paths, and multiplication of affine maps by paths.

use super::{Path, Subpaths};
use crate::curve::Curve;
use crate::geometry::check::expect_image;
use crate::spline::Spline;
use glam::{DAffine2, DVec2};
use std::ops::Mul;

impl From<Spline<DVec2>> for Path {
    /// A path with one subpath.
    fn from(spline: Spline<DVec2>) -> Self {
        Self::new(&[spline])
    }
}

impl From<Curve<DVec2>> for Path {
    /// A path with one open subpath of one segment.
    fn from(curve: Curve<DVec2>) -> Self {
        Self::from(Spline::from(curve))
    }
}

impl FromIterator<Spline<DVec2>> for Path {
    /// A path with these subpaths.
    fn from_iter<I: IntoIterator<Item = Spline<DVec2>>>(splines: I) -> Self {
        let mut path = Self::default();
        path.extend(splines);
        path
    }
}

impl<'a> IntoIterator for &'a Path {
    type Item = Spline<DVec2>;
    type IntoIter = Subpaths<'a>;

    /// The subpaths, as [`Path::subpaths`].
    fn into_iter(self) -> Self::IntoIter {
        self.subpaths()
    }
}

impl Extend<Spline<DVec2>> for Path {
    /// Adds subpaths.
    fn extend<I: IntoIterator<Item = Spline<DVec2>>>(&mut self, splines: I) {
        for spline in splines {
            self.push_spline(&spline);
        }
    }
}

impl Mul<Path> for DAffine2 {
    type Output = Path;

    /// The image of the path under the map, as [`Path::transform`] computes it.
    ///
    /// # Panics
    /// If the image is not finite, because an operator cannot return an error.
    #[track_caller]
    fn mul(self, path: Path) -> Path {
        self * &path
    }
}

impl Mul<&Path> for DAffine2 {
    type Output = Path;

    /// The image of the path under the map, as [`Path::transform`] computes it.
    ///
    /// # Panics
    /// If the image is not finite, because an operator cannot return an error.
    #[track_caller]
    fn mul(self, path: &Path) -> Path {
        expect_image(path.transform(&self))
    }
}
