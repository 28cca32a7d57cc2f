//! Points relative to an origin, scaled to a size of about 1, so that powers of coordinates stay in the range of f64.

use super::point::Point;
use crate::numeric::float::unit_scale;

/// Maps a point p to (p − origin) · scale. The scale is a power of two, so that only the difference is rounded.
#[derive(Clone, Copy)]
pub(crate) struct Normalized<P> {
    pub(crate) origin: P,
    pub(crate) scale: f64,
}

impl<P: Point> Normalized<P> {
    /// The map that makes vectors of this size 1 to 2 units long; vectors of size 0 keep their length.
    pub(crate) fn new(origin: P, size: f64) -> Self {
        Self {
            origin,
            scale: unit_scale(size),
        }
    }

    /// The map that gives the farthest of some points a largest coordinate of 1 to 2.
    pub(crate) fn around(origin: P, points: &[P]) -> Self {
        let farther = |max: f64, &p: &P| max.max((p - origin).max_abs());
        Self::new(origin, points.iter().fold(0.0, farther))
    }

    /// The images of points.
    pub(crate) fn points<L: FromIterator<P>>(&self, points: &[P]) -> L {
        let image = |&p: &P| (p - self.origin) * self.scale;
        points.iter().map(image).collect()
    }

    /// The point with a given image.
    pub(crate) fn inverse(&self, image: P) -> P {
        image / self.scale + self.origin
    }
}
