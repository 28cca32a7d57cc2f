//! Axis-aligned bounding boxes.

use super::point::Point;

/// An axis-aligned box: all points p with min ≤ p ≤ max in each coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Bounds<P> {
    /// The smallest coordinates.
    pub min: P,
    /// The largest coordinates.
    pub max: P,
}

impl<P: Point> Bounds<P> {
    /// The smallest box that contains the points, of which there must be one.
    #[inline]
    pub(crate) fn from_points(points: &[P]) -> Self {
        let start = Self {
            min: points[0],
            max: points[0],
        };
        points[1..].iter().fold(start, |all, &p| all.including(p))
    }

    /// For each coordinate, how far the point is outside the box; 0 inside.
    #[inline]
    pub(crate) fn outside(self, p: P) -> P {
        (self.min - p).max(p - self.max).max(P::default())
    }

    /// The distance from the point to the box; 0 inside.
    #[inline]
    pub(crate) fn distance(self, p: P) -> f64 {
        self.outside(p).norm()
    }

    /// The box enlarged on each side by a margin for each coordinate.
    pub(crate) fn enlarged(self, margin: P) -> Self {
        Self {
            min: self.min - margin,
            max: self.max + margin,
        }
    }

    /// The smallest box that contains this one and a point.
    #[must_use]
    pub(crate) fn including(self, p: P) -> Self {
        Self {
            min: self.min.min(p),
            max: self.max.max(p),
        }
    }

    /// The smallest box that contains both boxes.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The box of the points that both boxes contain; `None` if there are none. Boxes that touch share a box of zero
    /// width.
    pub fn intersection(self, other: Self) -> Option<Self> {
        let (min, max) = (self.min.max(other.min), self.max.min(other.max));
        (0..P::DIMENSION)
            .all(|axis| min.coordinate(axis) <= max.coordinate(axis))
            .then_some(Self { min, max })
    }

    /// Whether the point lies inside the box or on its boundary.
    pub fn contains(self, p: P) -> bool {
        self.min.min(p) == self.min && self.max.max(p) == self.max
    }

    /// The point in the middle of the box.
    pub fn center(&self) -> P {
        (self.min + self.max) * 0.5
    }

    /// The extent along x.
    pub fn width(&self) -> f64 {
        self.max.coordinate(0) - self.min.coordinate(0)
    }

    /// The extent along y.
    pub fn height(&self) -> f64 {
        self.max.coordinate(1) - self.min.coordinate(1)
    }

    /// The length of the diagonal.
    pub fn diagonal(&self) -> f64 {
        (self.max - self.min).norm()
    }
}
