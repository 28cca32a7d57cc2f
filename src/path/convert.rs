//! Paths from curves, splines and text, and affine maps as factors.

use super::Path;
use crate::curve::Curve;
use crate::io::svg_error::SvgError;
use crate::spline::Spline;
use glam::{DAffine2, DVec2};
use std::fmt;
use std::ops::Mul;
use std::str::FromStr;

impl From<Spline<DVec2>> for Path {
    /// The path with this one subpath.
    fn from(spline: Spline<DVec2>) -> Self {
        Self::new(&[spline])
    }
}

impl From<Curve<DVec2>> for Path {
    /// The path with one open subpath of one segment.
    fn from(curve: Curve<DVec2>) -> Self {
        Self::from(Spline::from(curve))
    }
}

impl FromIterator<Spline<DVec2>> for Path {
    /// The path with these subpaths.
    fn from_iter<I: IntoIterator<Item = Spline<DVec2>>>(splines: I) -> Self {
        let mut path = Self::default();
        path.extend(splines);
        path
    }
}

impl Extend<Spline<DVec2>> for Path {
    /// Adds subpaths.
    fn extend<I: IntoIterator<Item = Spline<DVec2>>>(&mut self, splines: I) {
        for spline in splines {
            self.push(
                spline.control_points(),
                &spline.degrees(),
                spline.is_closed(),
            );
        }
    }
}

impl FromStr for Path {
    type Err = SvgError;

    /// Reads SVG path data; see [`Path::from_svg`].
    fn from_str(d: &str) -> Result<Self, SvgError> {
        Self::from_svg(d)
    }
}

impl fmt::Display for Path {
    /// Writes SVG path data, as [`Path::to_svg`] does without options; the precision of the format (`{:.2}`) is the number
    /// of digits after the point.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f
            .precision()
            .map(|digits| digits.try_into().unwrap_or(u8::MAX));
        f.write_str(&self.to_svg(digits, None).map_err(|_| fmt::Error)?)
    }
}

impl Mul<&Path> for DAffine2 {
    type Output = Path;

    /// The image of the path, as [`Path::transform`] gives it.
    fn mul(self, path: &Path) -> Path {
        path.transform(&self)
    }
}
