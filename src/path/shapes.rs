//! Circles, ellipses, arcs, rectangles and polygons.
//!
//! Shapes are counter-clockwise for x right and y up (clockwise on a canvas). Round parts consist of cubics that join at
//! each quarter turn: by default 8 of them approximate a circle within 4.3e-6 of the radius. The largest distance of a
//! cubic over the angle θ is 2/27 sin⁶(θ/4) / cos²(θ/4) of the radius, so a tolerance of 2.73e-4 of the radius gives the
//! usual four cubics.

use super::Path;
use super::arc::Arc;
use super::builder::PathBuilder;
use crate::geometry::error::Error;
use crate::numeric::float::{as_f64, ratio};
use casteljau_kernels::numeric::trigonometry::{rotated, unit_vector_of_degrees};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A rounded angle may exceed a number of quarter turns by this part of a quarter turn.
const ANGLE_ROUNDING: f64 = 1e-12;

impl Path {
    /// A builder of an empty path; its methods can be chained.
    ///
    /// ```
    /// use casteljau::{Path, glam::dvec2};
    ///
    /// let path = Path::builder()
    ///     .move_to(dvec2(0.0, 0.0))
    ///     .line_to(dvec2(2.0, 0.0))
    ///     .line_to(dvec2(2.0, 1.0))
    ///     .close()
    ///     .circle(dvec2(5.0, 0.0), 1.0)
    ///     .build()?;
    /// assert_eq!(path.subpath_count(), 2);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn builder() -> PathBuilder {
        PathBuilder::new()
    }

    /// A circle from the point to the right of the centre; see [`PathBuilder::circle`].
    ///
    /// ```
    /// use casteljau::{Path, glam::DVec2};
    ///
    /// let circle = Path::circle(DVec2::ZERO, 2.0)?;
    /// assert_eq!(circle.segment_count(), 8);
    /// assert!((circle.area() - 4.0 * std::f64::consts::PI).abs() < 1e-4);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`PathBuilder::circle`].
    pub fn circle(center: DVec2, radius: f64) -> Result<Self, Error> {
        Ok(Self::builder().circle(center, radius).build()?)
    }

    /// An ellipse; see [`PathBuilder::ellipse`].
    ///
    /// # Errors
    /// As [`PathBuilder::circle`].
    pub fn ellipse(center: DVec2, radii: DVec2, rotation: f64) -> Result<Self, Error> {
        Ok(Self::builder().ellipse(center, radii, rotation).build()?)
    }

    /// An arc of a circle as an open subpath; see [`PathBuilder::arc`].
    ///
    /// # Errors
    /// As [`PathBuilder::arc`].
    pub fn arc(
        center: DVec2,
        radius: f64,
        start_angle: f64,
        end_angle: f64,
    ) -> Result<Self, Error> {
        let mut builder = Self::builder();
        Ok(builder
            .arc(center, radius, start_angle, end_angle)
            .build()?)
    }

    /// A rectangle from its corner with the smallest coordinates, its width and its height; see [`PathBuilder::rect`].
    ///
    /// # Errors
    /// As [`PathBuilder::rect`].
    pub fn rect(corner: DVec2, size: DVec2) -> Result<Self, Error> {
        Ok(Self::builder().rect(corner, size).build()?)
    }

    /// A rectangle with round corners; see [`PathBuilder::rounded_rect`].
    ///
    /// ```
    /// use casteljau::{Path, glam::DVec2};
    ///
    /// let tile = Path::rounded_rect(DVec2::ZERO, DVec2::new(4.0, 3.0), [0.5; 4])?;
    /// assert_eq!(tile.bounds().expect("not empty").max, DVec2::new(4.0, 3.0));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`PathBuilder::rect`].
    pub fn rounded_rect(corner: DVec2, size: DVec2, radii: [f64; 4]) -> Result<Self, Error> {
        Ok(Self::builder().rounded_rect(corner, size, radii).build()?)
    }

    /// A closed polygon with these corners; without corners, the empty path.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] as for [`Spline::new`](crate::Spline::new).
    pub fn polygon(corners: &[DVec2]) -> Result<Self, Error> {
        Ok(Self::builder().polygon(corners).build()?)
    }
}

/// Shapes are subpaths of their own; the next command starts where they start.
impl PathBuilder {
    /// Adds a circle, counter-clockwise (x right, y up) from the point to the right of the centre.
    ///
    /// A radius of 0 gives a closed subpath that is a point. [`build`](Self::build) reports a radius that is negative or
    /// not finite.
    pub fn circle(&mut self, center: DVec2, radius: f64) -> &mut Self {
        self.ellipse(center, DVec2::splat(radius), 0.0)
    }

    /// Adds an ellipse, counter-clockwise (x right, y up) from the end of its first semi-axis.
    ///
    /// `radii` are the lengths of its semi-axes, `rotation` is the angle from the x-axis to the first one, in radians.
    pub fn ellipse(&mut self, center: DVec2, radii: DVec2, rotation: f64) -> &mut Self {
        let fits = self.accept("center", &[center])
            && self.accept_size("radii", radii)
            && self.accept("rotation", &[DVec2::new(rotation, 0.0)]);
        if !fits {
            return self.counted();
        }
        let degrees = rotation.to_degrees();
        let axis = unit_vector_of_degrees(degrees);
        let at = |unit: DVec2| center + rotated(radii * unit, axis);
        self.begin(at(DVec2::X));
        for unit in [DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y, DVec2::X] {
            self.add_quarter(radii, degrees, true, at(unit));
        }
        self.end_closed();
        self.counted()
    }

    /// Adds an arc of a circle as an open subpath: counter-clockwise (x right, y up) if `end_angle` is greater than
    /// `start_angle`, otherwise clockwise. Angles are in radians, from the x-axis towards the y-axis.
    ///
    /// [`build`](Self::build) reports angles that are more than a full turn apart.
    pub fn arc(
        &mut self,
        center: DVec2,
        radius: f64,
        start_angle: f64,
        end_angle: f64,
    ) -> &mut Self {
        let turn = end_angle - start_angle;
        let fits = self.accept("center", &[center])
            && self.accept_size("radius", DVec2::splat(radius))
            && self.accept("angles", &[DVec2::new(start_angle, end_angle)])
            && self.check(turn.abs() <= TAU * (1.0 + f64::EPSILON), || Error::Range {
                what: "end_angle",
                expected: "at most a full turn (2π) from start_angle",
                got: end_angle,
            });
        if !fits {
            return self.counted();
        }
        let at = |angle: f64| center + unit_vector_of_degrees(angle.to_degrees()) * radius;
        self.begin(at(start_angle));
        let parts = whole_parts(turn.abs() / FRAC_PI_2 - ANGLE_ROUNDING);
        for k in 1..=parts {
            let end = if k == parts {
                end_angle
            } else {
                start_angle + turn * ratio(k, parts)
            };
            self.add_quarter(DVec2::splat(radius), 0.0, turn > 0.0, at(end));
        }
        self.counted()
    }

    /// Adds a rectangle with sides parallel to the axes, counter-clockwise (x right, y up) from the corner with the
    /// smallest coordinates.
    ///
    /// [`build`](Self::build) reports a width or a height that is negative or not finite.
    pub fn rect(&mut self, corner: DVec2, size: DVec2) -> &mut Self {
        self.rounded_rect(corner, size, [0.0; 4])
    }

    /// Adds a rectangle with round corners, as [`rect`](Self::rect) from the end of the first corner's arc.
    ///
    /// The radii are those of the corners in their order: (min x, min y), (max x, min y), (max x, max y), (min x,
    /// max y). Where the radii at a side exceed its length, all are reduced by the same factor, as in CSS.
    pub fn rounded_rect(&mut self, corner: DVec2, size: DVec2, radii: [f64; 4]) -> &mut Self {
        let fits = self.accept("corner", &[corner])
            && self.accept("corner + size", &[corner + size])
            && self.accept_size("size", size)
            && radii
                .iter()
                .all(|&radius| self.accept_size("radii", DVec2::splat(radius)));
        if !fits {
            return self.counted();
        }
        let sides = [size.x, size.y, size.x, size.y];
        let factor = (0..4).fold(1.0, |factor: f64, k| {
            let sum = radii[k] + radii[(k + 1) % 4];
            if sum > sides[k] {
                factor.min(sides[k] / sum)
            } else {
                factor
            }
        });
        let radii = radii.map(|radius| radius * factor);
        let far = corner + size;
        let corners = [
            corner,
            DVec2::new(far.x, corner.y),
            far,
            DVec2::new(corner.x, far.y),
        ];
        let along = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
        self.begin(corner + DVec2::new(radii[0], 0.0));
        for k in [1, 2, 3, 0] {
            self.add_line(corners[k] - along[(k + 3) % 4] * radii[k]);
            if radii[k] > 0.0 {
                let end = corners[k] + along[k] * radii[k];
                self.add_quarter(DVec2::splat(radii[k]), 0.0, true, end);
            }
        }
        self.end_closed();
        self.counted()
    }

    /// Adds a closed polygon with these corners; nothing without corners.
    pub fn polygon(&mut self, corners: &[DVec2]) -> &mut Self {
        if let [first, rest @ ..] = corners
            && self.accept("corners", corners)
        {
            self.begin(*first);
            rest.iter().for_each(|&corner| self.add_segment(&[corner]));
            self.end_closed();
        }
        self.counted()
    }

    /// Adds an arc of at most a quarter turn; a line of length 0 if its ends are equal.
    fn add_quarter(&mut self, radii: DVec2, degrees: f64, sweep: bool, to: DVec2) {
        let from = self.current_point();
        if from == to {
            return self.add_segment(&[to]);
        }
        self.add_arc(&Arc {
            from,
            to,
            radii,
            degrees,
            large: false,
            sweep,
        });
    }

    /// Adds a line, unless it would be a point but for rounding.
    fn add_line(&mut self, to: DVec2) {
        let from = self.current_point();
        let rounding = from.abs().max(to.abs()) * (4.0 * f64::EPSILON);
        if (to - from).abs().cmpgt(rounding).any() {
            self.add_segment(&[to]);
        }
    }

    /// Returns whether both numbers are finite and not negative; keeps the error otherwise.
    fn accept_size(&mut self, what: &'static str, size: DVec2) -> bool {
        self.accept(what, &[size])
            && self.check(size.min_element() >= 0.0, || Error::Range {
                what,
                expected: "numbers from 0",
                got: size.min_element(),
            })
    }
}

/// The next whole number, at least 1 and at most 4.
fn whole_parts(quarters: f64) -> usize {
    (1..4).find(|&n| quarters <= as_f64(n)).unwrap_or(4)
}
