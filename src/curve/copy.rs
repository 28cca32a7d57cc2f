//! Lines, quadratics and cubics as values that are `Copy`.
//!
//! [`Curve`] has any degree, which is known only at run time. Where the degree is known, these types need no branch for
//! it, and they are as large as their control points. Every method has the result of the same method of `Curve`.

use super::Curve;
use super::arc_length::point_at_length::PointAtLength;
use super::intersect::intersection::{Intersection, SelfIntersection};
use super::moments::Moments;
use super::nearest::{Nearest, nearest_on};
use super::trace::PathSink;
use crate::bernstein::evaluate::{weigh3, weigh4};
use crate::curve::flatten::Polyline;
use crate::curve::split::ends_of;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::{check_points, clamp_to_limit};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::spline::Spline;
use casteljau_kernels::bernstein::de_casteljau::split_cubic_with;
use glam::DVec2;
use std::ops::RangeBounds;

/// The line segment from one point to another.
///
/// ```
/// use casteljau::{curve::Line, glam::dvec2};
///
/// let line = Line::new(dvec2(0.0, 0.0), dvec2(3.0, 4.0))?;
/// assert_eq!((line.length(), line.eval(0.5)), (5.0, dvec2(1.5, 2.0)));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<P: Point> {
    points: [P; 2],
}

/// A quadratic Bézier curve.
///
/// ```
/// use casteljau::{curve::Quad, glam::dvec2};
///
/// let arch = Quad::new(dvec2(0.0, 0.0), dvec2(1.0, 2.0), dvec2(2.0, 0.0))?;
/// assert_eq!(arch.bounds().max, dvec2(2.0, 1.0));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad<P: Point> {
    points: [P; 3],
}

/// A cubic Bézier curve.
///
/// ```
/// use casteljau::{Curve, curve::Cubic, glam::dvec2};
///
/// let arch = Cubic::new(dvec2(0.0, 0.0), dvec2(0.0, 2.0), dvec2(2.0, 2.0), dvec2(2.0, 0.0))?;
/// let (left, right) = arch.split(0.5);
/// assert_eq!((left.end(), right.start()), (dvec2(1.0, 1.5), dvec2(1.0, 1.5)));
/// assert_eq!(Cubic::try_from(&Curve::from(arch)), Ok(arch));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubic<P: Point> {
    points: [P; 4],
}

/// Methods that are those of the same curve as [`Curve`].
macro_rules! as_curve {
    ($($(#[$meta:meta])* fn $name:ident($($arg:ident: $type:ty),*) -> $result:ty;)*) => {
        $(
            $(#[$meta])*
            pub fn $name(&self, $($arg: $type),*) -> $result {
                self.curve().$name($($arg),*)
            }
        )*
    };
}

/// Implements what the three types have in common.
macro_rules! copy_curve {
    ($type:ident, $degree:literal, [$($p:ident),+], $split:expr) => {
        impl<P: Point> $type<P> {
            /// The curve with these control points.
            ///
            /// # Errors
            /// [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a coordinate beyond
            /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
            pub fn new($($p: P),+) -> Result<Self, Error> {
                Self::from_points([$($p),+])
            }

            fn from_points(points: [P; $degree + 1]) -> Result<Self, Error> {
                check_points("points", &points)?;
                Ok(Self { points })
            }

            /// The control points.
            #[inline]
            pub fn control_points(&self) -> [P; $degree + 1] {
                self.points
            }

            /// The first control point.
            #[inline]
            pub fn start(&self) -> P {
                self.points[0]
            }

            /// The last control point.
            #[inline]
            pub fn end(&self) -> P {
                self.points[$degree]
            }

            /// The two parts at t, see [`Curve::split`].
            #[inline]
            pub fn split(&self, t: f64) -> (Self, Self) {
                let (before, after) = $split(self.points, t);
                if (0.0..=1.0).contains(&t) {
                    return (Self { points: before }, Self { points: after });
                }
                // An extrapolation may leave the range of coordinates.
                let [before, after] = [before, after].map(|points| points.map(clamp_to_limit));
                (Self { points: before }, Self { points: after })
            }

            /// The two halves at t = ½.
            #[inline]
            pub fn halve(&self) -> (Self, Self) {
                self.split(0.5)
            }

            /// The segment in a range of parameters, see [`Curve::subsegment`].
            #[must_use]
            pub fn subsegment(&self, range: impl RangeBounds<f64>) -> Self {
                let [from, to] = ends_of(&range, 1.0);
                let part = self.curve().part(from, to);
                let mut points = self.points;
                points.copy_from_slice(part.control_points());
                Self { points }
            }

            /// The same curve with the opposite direction.
            #[must_use]
            pub fn reverse(&self) -> Self {
                let mut points = self.points;
                points.reverse();
                Self { points }
            }

            /// The image under an affine map.
            ///
            /// # Errors
            /// As [`Curve::transform`].
            pub fn transform(&self, map: &P::Affine) -> Result<Self, Error> {
                let points = self.points.map(|p| p.transform(map));
                check_points("image", &points)?;
                Ok(Self { points })
            }

            as_curve! {
                /// The unit tangent at t, see [`Curve::tangent`].
                fn tangent(t: f64) -> P;

                /// The unit normal at t, see [`Curve::normal`].
                fn normal(t: f64) -> P;

                /// The curvature at t, see [`Curve::curvature`].
                fn curvature(t: f64) -> f64;

                /// The k-th derivative at t, see [`Curve::derivative_at`].
                fn derivative_at(t: f64, k: usize) -> P;

                /// The tight bounding box, see [`Curve::bounds`].
                #[doc(alias = "bounding_box")]
                fn bounds() -> Bounds<P>;

                /// The bounding box of the control points.
                fn control_bounds() -> Bounds<P>;

                /// The parameters where a coordinate is extremal, see [`Curve::extrema`].
                ///
                /// # Errors
                /// As [`Curve::extrema`].
                fn extrema(axis: usize) -> Result<Vec<f64>, Error>;

                /// The parameters where a coordinate has a value, see [`Curve::times_at_coordinate`].
                ///
                /// # Errors
                /// As [`Curve::times_at_coordinate`].
                fn times_at_coordinate(axis: usize, value: f64) -> Result<Vec<f64>, Error>;

                /// The arc length, see [`Curve::length`].
                #[doc(alias = "arclen")]
                fn length() -> f64;

                /// The arc length within a tolerance, see [`Curve::length_within`].
                ///
                /// # Errors
                /// As [`Curve::length_within`].
                fn length_within(tolerance: f64) -> Result<f64, Error>;

                /// The parameter at an arc length, see [`Curve::time_at_length`].
                #[doc(alias = "inv_arclen")]
                fn time_at_length(s: f64) -> f64;

                /// The point at an arc length with its directions, see [`Curve::point_at_length`].
                fn point_at_length(s: f64) -> PointAtLength<P>;

                /// Parameters of points that cut the curve into arcs of the same length, see [`Curve::equidistant_times`].
                ///
                /// # Errors
                /// As [`Curve::equidistant_times`].
                fn equidistant_times(segments: usize) -> Result<Vec<f64>, Error>;

                /// Points at equal steps of the parameter, see [`Curve::sample`].
                ///
                /// # Errors
                /// As [`Curve::sample`].
                fn sample(segments: usize) -> Result<Vec<P>, Error>;

                /// A polyline within a tolerance, see [`Curve::flatten`].
                ///
                /// # Errors
                /// As [`Curve::flatten`].
                fn flatten(tolerance: f64) -> Result<Polyline<P>, Error>;
            }

            /// The nearest point, see [`Curve::nearest`].
            ///
            /// # Errors
            /// [`Error::NotFinite`] for a NaN or an infinity.
            pub fn nearest(&self, p: P) -> Result<Nearest<P>, Error> {
                check_points("p", &[p])?;
                Ok(nearest_on(&self.points, p))
            }

            /// [`flatten`](Self::flatten) that passes each vertex to `vertex`, see [`Curve::flatten_with`].
            ///
            /// # Errors
            /// As [`Curve::flatten_with`].
            pub fn flatten_with(
                &self,
                tolerance: f64,
                vertex: impl FnMut(f64, P),
            ) -> Result<(), Error> {
                self.curve().flatten_with(tolerance, vertex)
            }

            #[inline]
            fn curve(&self) -> Curve<P> {
                Curve::from_slice(&self.points)
            }
        }

        impl $type<DVec2> {
            as_curve! {
                /// The signed area between the curve and its chord, see [`Curve::area`].
                fn area() -> f64;

                /// The moments of the region between the curve and the origin, see [`Curve::moments`].
                fn moments() -> Moments;

                /// The points that the curve passes twice, see [`Curve::self_intersections`].
                fn self_intersections() -> Vec<SelfIntersection>;

                /// A curve at a distance, see [`Curve::offset`].
                ///
                /// # Errors
                /// As [`Curve::offset`].
                fn offset(distance: f64) -> Result<Spline<DVec2>, Error>;

                /// A curve at a distance within a tolerance, see [`Curve::offset_within`].
                ///
                /// # Errors
                /// As [`Curve::offset_within`].
                fn offset_within(distance: f64, tolerance: f64) -> Result<Spline<DVec2>, Error>;

                /// The curve as SVG path data, see [`Curve::to_svg`].
                #[cfg(feature = "io")]
                fn to_svg() -> String;
            }

            /// Sends the curve to a sink, see [`Curve::trace`].
            pub fn trace(&self, sink: &mut (impl PathSink + ?Sized)) {
                self.curve().trace(sink);
            }

            /// All intersections with a curve of any type, see [`Curve::intersections`].
            pub fn intersections(&self, other: impl Into<Curve<DVec2>>) -> Vec<Intersection> {
                self.curve().intersections(&other.into())
            }
        }

        impl<P: Point> From<$type<P>> for Curve<P> {
            /// The same curve.
            fn from(curve: $type<P>) -> Self {
                curve.curve()
            }
        }

        impl<P: Point> TryFrom<&Curve<P>> for $type<P> {
            type Error = Error;

            /// The same curve, if it has this degree.
            ///
            /// # Errors
            /// [`Error::Count`] for another degree.
            fn try_from(curve: &Curve<P>) -> Result<Self, Error> {
                match *curve.control_points() {
                    [$($p),+] => Ok(Self { points: [$($p),+] }),
                    ref points => Err(Error::Count {
                        what: "points",
                        expected: concat!("those of a curve of degree ", $degree),
                        got: points.len(),
                    }),
                }
            }
        }

        impl<P: Point> TryFrom<Curve<P>> for $type<P> {
            type Error = Error;

            /// As for a reference.
            fn try_from(curve: Curve<P>) -> Result<Self, Error> {
                Self::try_from(&curve)
            }
        }

        impl<P: Point> TryFrom<[P; $degree + 1]> for $type<P> {
            type Error = Error;

            /// The same as `new`.
            fn try_from(points: [P; $degree + 1]) -> Result<Self, Error> {
                Self::from_points(points)
            }
        }
    };
}

copy_curve!(Line, 1, [p0, p1], |[a, b]: [P; 2], t| {
    let p = a.lerp(b, t);
    ([a, p], [p, b])
});
copy_curve!(Quad, 2, [p0, p1, p2], |[a, b, c]: [P; 3], t| {
    let (ab, bc) = (a.lerp(b, t), b.lerp(c, t));
    let p = ab.lerp(bc, t);
    ([a, ab, p], [p, bc, c])
});
copy_curve!(Cubic, 3, [p0, p1, p2, p3], |points: [P; 4], t| {
    split_cubic_with(points, |a, b| a.lerp(b, t))
});

impl<P: Point> Line<P> {
    /// The point at t, see [`Curve::eval`].
    #[inline]
    pub fn eval(&self, t: f64) -> P {
        self.points[0].lerp(self.points[1], t)
    }

    /// The derivative, which is constant: the vector from the start to the end.
    #[inline]
    pub fn derivative(&self) -> P {
        clamp_to_limit(self.points[1] - self.points[0])
    }
}

impl<P: Point> Quad<P> {
    /// The point at t, see [`Curve::eval`].
    #[inline]
    pub fn eval(&self, t: f64) -> P {
        weigh3(self.points, t)
    }

    /// The derivative, see [`Curve::derivative`].
    pub fn derivative(&self) -> Line<P> {
        let [a, b, c] = self.points;
        let points = [b - a, c - b].map(|step| clamp_to_limit(step * 2.0));
        Line { points }
    }

    /// The same curve as a cubic.
    pub fn elevate(&self) -> Cubic<P> {
        let [a, b, c] = self.points;
        let points = [a, b.lerp(a, 1.0 / 3.0), c.lerp(b, 2.0 / 3.0), c];
        Cubic { points }
    }
}

impl<P: Point> Cubic<P> {
    /// The point at t, see [`Curve::eval`].
    #[inline]
    pub fn eval(&self, t: f64) -> P {
        weigh4(self.points, t)
    }

    /// The derivative, see [`Curve::derivative`].
    pub fn derivative(&self) -> Quad<P> {
        let [a, b, c, d] = self.points;
        let points = [b - a, c - b, d - c].map(|step| clamp_to_limit(step * 3.0));
        Quad { points }
    }
}
