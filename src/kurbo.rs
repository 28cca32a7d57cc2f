//! Conversions from and to the types of the crate kurbo, behind the feature `kurbo`.

use crate::curve::trace::PathSink;
use crate::curve::{self, Curve};
use crate::geometry::error::Error;
use crate::path::Path;
use crate::path::builder::PathBuilder;
#[cfg(feature = "nurbs")]
use crate::rational::{NurbsCurve, RationalCurve};
use crate::spline::Spline;
use glam::DVec2;
use kurbo::{BezPath, CubicBez, Line, PathEl, PathSeg, Point, QuadBez, Shape};

fn from_kurbo(p: Point) -> DVec2 {
    DVec2::new(p.x, p.y)
}

fn to_kurbo(p: DVec2) -> Point {
    Point::new(p.x, p.y)
}

impl TryFrom<Line> for Curve<DVec2> {
    type Error = Error;

    /// Converts a line segment.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    fn try_from(line: Line) -> Result<Self, Error> {
        Self::new(&[line.p0, line.p1].map(from_kurbo))
    }
}

impl TryFrom<QuadBez> for Curve<DVec2> {
    type Error = Error;

    /// Converts a quadratic curve.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    fn try_from(quad: QuadBez) -> Result<Self, Error> {
        Self::new(&[quad.p0, quad.p1, quad.p2].map(from_kurbo))
    }
}

impl TryFrom<CubicBez> for Curve<DVec2> {
    type Error = Error;

    /// Converts a cubic curve.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    fn try_from(cubic: CubicBez) -> Result<Self, Error> {
        Self::new(&[cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(from_kurbo))
    }
}

/// Implements the conversions between the curves of fixed degrees of both libraries.
macro_rules! same_degree {
    ($($ours:ident, $theirs:ident($($p:ident),+);)+) => {$(
        impl TryFrom<$theirs> for curve::$ours<DVec2> {
            type Error = Error;

            /// The same curve.
            ///
            /// # Errors
            /// [`Error::NotFinite`] for a NaN or an infinity.
            fn try_from(curve: $theirs) -> Result<Self, Error> {
                Self::new($(from_kurbo(curve.$p)),+)
            }
        }

        impl From<curve::$ours<DVec2>> for $theirs {
            /// The same curve.
            fn from(curve: curve::$ours<DVec2>) -> Self {
                let [$($p),+] = curve.control_points().map(to_kurbo);
                Self::new($($p),+)
            }
        }
    )+};
}

same_degree! {
    Line, Line(p0, p1);
    Quad, QuadBez(p0, p1, p2);
    Cubic, CubicBez(p0, p1, p2, p3);
}

impl TryFrom<PathSeg> for Curve<DVec2> {
    type Error = Error;

    /// Converts a line, a quadratic or a cubic.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    fn try_from(segment: PathSeg) -> Result<Self, Error> {
        match segment {
            PathSeg::Line(line) => line.try_into(),
            PathSeg::Quad(quad) => quad.try_into(),
            PathSeg::Cubic(cubic) => cubic.try_into(),
        }
    }
}

impl TryFrom<&Curve<DVec2>> for PathSeg {
    type Error = Error;

    /// Converts a line, a quadratic or a cubic.
    ///
    /// # Errors
    /// [`Error::Range`] for a degree above 3, which kurbo does not support.
    fn try_from(curve: &Curve<DVec2>) -> Result<Self, Error> {
        match curve.degree() {
            1 => Line::try_from(curve).map(Self::from),
            2 => QuadBez::try_from(curve).map(Self::from),
            3 => CubicBez::try_from(curve).map(Self::from),
            degree => Err(Error::Range {
                what: "degree",
                expected: "1 to 3",
                got: degree as f64,
            }),
        }
    }
}

impl TryFrom<&BezPath> for Path {
    type Error = Error;

    /// Converts a path with all its subpaths. A `MoveTo` without a segment is omitted, as by [`PathBuilder`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    fn try_from(path: &BezPath) -> Result<Self, Error> {
        let mut builder = PathBuilder::new();
        for element in path.elements() {
            match *element {
                PathEl::MoveTo(p) => builder.move_to(from_kurbo(p)),
                PathEl::LineTo(p) => builder.line_to(from_kurbo(p)),
                PathEl::QuadTo(p1, p) => builder.quad_to(from_kurbo(p1), from_kurbo(p)),
                PathEl::CurveTo(p1, p2, p) => {
                    builder.cubic_to(from_kurbo(p1), from_kurbo(p2), from_kurbo(p))
                }
                PathEl::ClosePath => builder.close(),
            };
        }
        Ok(builder.build()?)
    }
}

/// A sink that appends commands to a `BezPath`.
struct BezPathSink(BezPath);

impl PathSink for BezPathSink {
    fn move_to(&mut self, p: DVec2) {
        self.0.move_to(to_kurbo(p));
    }
    fn line_to(&mut self, p: DVec2) {
        self.0.line_to(to_kurbo(p));
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.0.quad_to(to_kurbo(p1), to_kurbo(p));
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.0.curve_to(to_kurbo(p1), to_kurbo(p2), to_kurbo(p));
    }
    fn close(&mut self) {
        self.0.close_path();
    }
}

/// Implements the conversion to a `BezPath`, by value and by reference.
macro_rules! to_bez_path {
    ($($type:ty),+) => {$(
        impl From<&$type> for BezPath {
            /// Converts all commands. A degree above 3 is approximated by cubics, as by `trace`.
            fn from(shape: &$type) -> Self {
                let mut sink = BezPathSink(Self::new());
                shape.trace(&mut sink);
                sink.0
            }
        }

        impl From<$type> for BezPath {
            /// Converts all commands. A degree above 3 is approximated by cubics, as by `trace`.
            fn from(shape: $type) -> Self {
                Self::from(&shape)
            }
        }
    )+};
}

to_bez_path!(Curve<DVec2>, Spline<DVec2>, Path);

impl TryFrom<BezPath> for Path {
    type Error = Error;

    /// Converts a path with all its subpaths. A `MoveTo` without a segment is omitted, as by [`PathBuilder`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    fn try_from(path: BezPath) -> Result<Self, Error> {
        Self::try_from(&path)
    }
}

/// Implements the conversion of a curve to a curve of kurbo of one degree.
macro_rules! to_segment {
    ($($type:ident($($p:ident),+), $degree:literal;)+) => {$(
        impl TryFrom<&Curve<DVec2>> for $type {
            type Error = Error;

            /// Converts a curve of this degree.
            ///
            /// # Errors
            /// [`Error::Range`] for another degree.
            fn try_from(curve: &Curve<DVec2>) -> Result<Self, Error> {
                match *curve.control_points() {
                    [$($p),+] => Ok(Self::new($(to_kurbo($p)),+)),
                    ref points => Err(Error::Range {
                        what: "degree",
                        expected: $degree,
                        got: (points.len() - 1) as f64,
                    }),
                }
            }
        }
    )+};
}

to_segment! {
    Line(p0, p1), "1";
    QuadBez(p0, p1, p2), "2";
    CubicBez(p0, p1, p2, p3), "3";
}

impl Path {
    /// The outline of any shape of kurbo: a rectangle, a circle, a rounded rectangle …
    ///
    /// `tolerance` is passed to kurbo: the maximum distance between the shape and the outline.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    pub fn from_kurbo(shape: &impl Shape, tolerance: f64) -> Result<Self, Error> {
        Self::try_from(&shape.to_path(tolerance))
    }
}

#[cfg(feature = "nurbs")]
impl TryFrom<kurbo::Arc> for NurbsCurve<DVec2> {
    type Error = Error;

    /// The same arc, exactly: center + cos(θ) u + sin(θ) v with the radii rotated by `x_rotation`, over the domain [0, 1].
    ///
    /// # Errors
    /// As [`NurbsCurve::arc`].
    fn try_from(arc: kurbo::Arc) -> Result<Self, Error> {
        let axis = kurbo::Vec2::from_angle(arc.x_rotation);
        let (u, v) = (axis * arc.radii.x, axis.turn_90() * arc.radii.y);
        let [center, u, v] = [arc.center, u.to_point(), v.to_point()].map(from_kurbo);
        let end = arc.start_angle + arc.sweep_angle;
        Self::arc(center, u, v, arc.start_angle, end)
    }
}

#[cfg(feature = "nurbs")]
impl TryFrom<kurbo::Circle> for NurbsCurve<DVec2> {
    type Error = Error;

    /// The same circle, exactly.
    ///
    /// # Errors
    /// As [`NurbsCurve::circle`].
    fn try_from(circle: kurbo::Circle) -> Result<Self, Error> {
        Self::circle(from_kurbo(circle.center), circle.radius)
    }
}

#[cfg(feature = "nurbs")]
impl TryFrom<kurbo::Ellipse> for NurbsCurve<DVec2> {
    type Error = Error;

    /// The same ellipse, exactly.
    ///
    /// # Errors
    /// As [`NurbsCurve::ellipse`].
    fn try_from(ellipse: kurbo::Ellipse) -> Result<Self, Error> {
        let radii = ellipse.radii();
        let radii = DVec2::new(radii.x, radii.y);
        Self::ellipse(from_kurbo(ellipse.center()), radii, ellipse.rotation())
    }
}

#[cfg(feature = "nurbs")]
impl TryFrom<&RationalCurve<DVec2>> for kurbo::Arc {
    type Error = Error;

    /// The arc of a conic; see [`RationalCurve::to_elliptical_arc`].
    ///
    /// # Errors
    /// [`Error::Range`] for a curve that is not an arc of an ellipse.
    fn try_from(curve: &RationalCurve<DVec2>) -> Result<Self, Error> {
        let arc = curve.to_elliptical_arc().ok_or(Error::Range {
            what: "degree",
            expected: "an arc of an ellipse, of degree 2",
            got: curve.degree() as f64,
        })?;
        Ok(Self {
            center: to_kurbo(arc.center),
            radii: to_kurbo(arc.radii).to_vec2(),
            start_angle: arc.start_angle,
            sweep_angle: arc.sweep_angle,
            x_rotation: arc.rotation,
        })
    }
}
