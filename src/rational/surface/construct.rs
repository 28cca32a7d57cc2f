//! Planes, surfaces of revolution, ruled and extruded surfaces.

use super::loft::united;
use super::{Direction, NurbsSurface};
use crate::bernstein::evaluate::evaluate_scalar;
use crate::bernstein::roots::contacts;
use crate::geometry::check::{check_points, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::rational::nurbs::NurbsCurve;
use crate::rational::weighted::WeightedPoint;
use glam::{DAffine3, DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Distances below this many ulps of the largest coordinate are 0.
const TOUCHING: f64 = 4.0;

/// A zero of even order is exact to the square root of rounding only.
const NEAR_END: f64 = 1e-7;

impl NurbsSurface {
    /// The parallelogram origin + u·U + v·V over [0, 1] in both directions, where the vectors U and V are its sides.
    ///
    /// # Errors
    /// As [`new`](Self::new) for the corners.
    pub fn plane(origin: DVec3, u: DVec3, v: DVec3) -> Result<Self, Error> {
        let net = [origin, origin + u, origin + v, origin + u + v];
        let knots = [0.0, 0.0, 1.0, 1.0];
        Self::new(1, 1, &net, None, &knots, &knots)
    }

    /// The side of a cylinder: u runs once around the axis, v from the base, whose center is given, to the height.
    ///
    /// The normals point outwards for a positive height. There are no caps. The length of `axis` does not matter.
    ///
    /// # Errors
    /// [`Error::Range`] for a negative radius and for an axis of length 0, [`Error::NotFinite`] for a NaN or an infinity,
    /// [`Error::Item`] for a coordinate beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn cylinder(center: DVec3, radius: f64, height: f64, axis: DVec3) -> Result<Self, Error> {
        check_radius("radius", radius)?;
        Error::unless_finite("height", &[height])?;
        let side = [DVec2::new(radius, 0.0), DVec2::new(radius, height)];
        Self::turned(center, axis, &line(&side)?)
    }

    /// The side of a cone: u runs once around the axis, v from the base, whose center is given, to the tip at the height.
    ///
    /// # Errors
    /// As [`cylinder`](Self::cylinder).
    pub fn cone(center: DVec3, radius: f64, height: f64, axis: DVec3) -> Result<Self, Error> {
        check_radius("radius", radius)?;
        Error::unless_finite("height", &[height])?;
        let side = [DVec2::new(radius, 0.0), DVec2::new(0.0, height)];
        Self::turned(center, axis, &line(&side)?)
    }

    /// A sphere: u runs once around the axis, v from the pole against the axis to the pole along it, and the normals point
    /// outwards.
    ///
    /// It has eight patches of degree 2 × 2. Each pole is an edge of four patches.
    ///
    /// # Errors
    /// As [`cylinder`](Self::cylinder).
    pub fn sphere(center: DVec3, radius: f64, axis: DVec3) -> Result<Self, Error> {
        check_radius("radius", radius)?;
        let (down, out) = (DVec2::new(0.0, -radius), DVec2::new(radius, 0.0));
        Self::turned(
            center,
            axis,
            &NurbsCurve::arc(DVec2::ZERO, down, out, 0.0, PI)?,
        )
    }

    /// A torus: u runs once around the axis, v once around the tube, from the outermost circle towards the axis direction, and the
    /// normals point outwards.
    ///
    /// `major_radius` is the distance of the middle of the tube from the axis, `minor_radius` the radius of the tube. It has 16 patches of
    /// degree 2 × 2.
    ///
    /// # Errors
    /// [`Error::Range`] unless `major_radius` is above `minor_radius`; otherwise as [`cylinder`](Self::cylinder).
    pub fn torus(
        center: DVec3,
        major_radius: f64,
        minor_radius: f64,
        axis: DVec3,
    ) -> Result<Self, Error> {
        check_radius("minor_radius", minor_radius)?;
        Error::unless_finite("major_radius", &[major_radius])?;
        if major_radius <= minor_radius {
            return Err(Error::Range {
                what: "major_radius",
                expected: "a number above the minor radius",
                got: major_radius,
            });
        }
        let (out, up) = (DVec2::new(minor_radius, 0.0), DVec2::new(0.0, minor_radius));
        let tube = NurbsCurve::arc(DVec2::new(major_radius, 0.0), out, up, 0.0, TAU)?;
        Self::turned(center, axis, &tube)
    }

    /// The surface of the lines between points of two curves at equal parameters: a at v = 0 and b at v = 1.
    ///
    /// The curves are brought to one degree, the domain [0, 1] and the same knots, which does not change them; a closed one is
    /// opened at its start. u runs along them.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::elevate`] and [`NurbsCurve::refine`] for large input.
    pub fn ruled(a: &NurbsCurve<DVec3>, b: &NurbsCurve<DVec3>) -> Result<Self, Error> {
        let curves = united(&[a, b])?;
        let u = Direction::new(curves[0].degree(), curves[0].knots());
        let parts = [curves[0].weighted(), curves[1].weighted()].concat();
        Self::from_weighted(&parts, u, Direction::new(1, &[0.0, 0.0, 1.0, 1.0]))
    }

    /// The surface that a curve sweeps over when it is moved by a vector: u runs along the curve, v along the vector.
    ///
    /// # Errors
    /// As [`NurbsCurve::transform`], and as [`ruled`](Self::ruled).
    pub fn extrude(curve: &NurbsCurve<DVec3>, vector: DVec3) -> Result<Self, Error> {
        let moved = curve.transform(&DAffine3::from_translation(vector))?;
        Self::ruled(curve, &moved)
    }

    /// The surface that a profile sweeps over when it turns around an axis through `origin`, by an angle in radians.
    ///
    /// u runs around the axis over [0, 1], from the profile in the direction of a right-handed turn (the other way for a negative
    /// angle), with a span for each quarter turn or less; v runs along the profile, with its degree, knots and domain. A full turn
    /// ends with a copy of its start. Control points within 4 ulps of the largest coordinate from the axis are moved to
    /// it, so that a profile that ends on the axis has a pole there.
    ///
    /// # Errors
    /// [`Error::Range`] for an axis of length 0, an angle above a full turn, and a profile that meets the axis elsewhere than at its
    /// ends; [`Error::NotFinite`] for a NaN or an infinity; [`Error::Item`] for a coordinate beyond
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    ///
    /// Source: Piegl and Tiller, *The NURBS Book*, §8.5.
    pub fn revolve(
        profile: &NurbsCurve<DVec3>,
        origin: DVec3,
        axis: DVec3,
        angle: f64,
    ) -> Result<Self, Error> {
        Turning::new(profile, origin, axis)?.surface(angle)
    }

    /// A full turn of a profile in the half-plane of the distances from an axis (x) and the heights along it (y).
    fn turned(center: DVec3, axis: DVec3, profile: &NurbsCurve<DVec2>) -> Result<Self, Error> {
        check_points("center", &[center])?;
        let axis = unit_axis(axis)?;
        let (x, y) = axis.any_orthonormal_pair();
        let turns = profile.weighted().into_iter().map(|part| {
            let (radius, height) = (part.point.x, part.point.y);
            Arc {
                center: center + axis * height,
                x: x * radius,
                y: y * radius,
                weight: part.weight,
            }
        });
        let along = Direction::new(profile.degree(), profile.knots());
        Self::of_arcs(turns, TAU, along)
    }

    /// The surface whose rows are arcs.
    fn of_arcs(
        arcs: impl Iterator<Item = Arc>,
        angle: f64,
        along: Direction,
    ) -> Result<Self, Error> {
        let (mut parts, mut around) = (Vec::new(), Direction::default());
        for arc in arcs {
            let row = arc.turned(angle)?;
            parts.extend(row.weighted().into_iter().map(|part| WeightedPoint {
                weight: part.weight * arc.weight,
                ..part
            }));
            around = Direction::new(row.degree(), row.knots());
        }
        Self::from_weighted(&parts, around, along)
    }
}

/// The arc of a control point: its center, two conjugate radii, and a factor of the weights.
#[derive(Clone, Copy)]
pub(in crate::rational) struct Arc {
    pub(in crate::rational) center: DVec3,
    pub(in crate::rational) x: DVec3,
    y: DVec3,
    weight: f64,
}

impl Arc {
    pub(in crate::rational) fn turned(&self, angle: f64) -> Result<NurbsCurve<DVec3>, Error> {
        NurbsCurve::arc(self.center, self.x, self.y, 0.0, angle)
    }
}

/// A profile that turns around an axis.
pub(in crate::rational) struct Turning {
    /// Opened at its start if it is closed.
    pub(in crate::rational) profile: NurbsCurve<DVec3>,
    pub(in crate::rational) origin: DVec3,
    /// Of length 1.
    pub(in crate::rational) axis: DVec3,
    /// The largest distance from the axis that counts as 0.
    pub(in crate::rational) near: f64,
    /// The arcs of the control points.
    pub(in crate::rational) arcs: Vec<Arc>,
}

impl Turning {
    pub(in crate::rational) fn new(
        profile: &NurbsCurve<DVec3>,
        origin: DVec3,
        axis: DVec3,
    ) -> Result<Self, Error> {
        check_points("origin", &[origin])?;
        let axis = unit_axis(axis)?;
        let profile = if profile.is_closed() {
            profile.subsegment(..)?
        } else {
            profile.clone()
        };
        let largest = max_abs(profile.control_points()).max(origin.abs().max_element());
        let mut turning = Self {
            near: TOUCHING * ulp(largest),
            arcs: Vec::new(),
            profile,
            origin,
            axis,
        };
        check_profile(&turning.profile, axis, turning.near, |p| {
            turning.arc(p, 1.0).x
        })?;
        let parts = turning.profile.weighted().into_iter();
        turning.arcs = parts
            .map(|part| turning.arc(part.point, part.weight))
            .collect();
        Ok(turning)
    }

    /// The arc of a point that turns around the axis.
    pub(in crate::rational) fn arc(&self, p: DVec3, weight: f64) -> Arc {
        let center = self.origin + self.axis * (p - self.origin).dot(self.axis);
        let radius = p - center;
        let is_near = Point::norm(radius) <= self.near;
        let x = if is_near { DVec3::ZERO } else { radius };
        Arc {
            center,
            x,
            y: self.axis.cross(x),
            weight,
        }
    }

    pub(in crate::rational) fn surface(&self, angle: f64) -> Result<NurbsSurface, Error> {
        Error::unless_finite("angle", &[angle])?;
        if angle.abs() > TAU {
            return Err(Error::Range {
                what: "angle",
                expected: "at most a full turn, 2π",
                got: angle,
            });
        }
        let along = Direction::new(self.profile.degree(), self.profile.knots());
        NurbsSurface::of_arcs(self.arcs.iter().copied(), angle, along)
    }
}

fn line(ends: &[DVec2]) -> Result<NurbsCurve<DVec2>, Error> {
    NurbsCurve::new(1, ends, None, &[0.0, 0.0, 1.0, 1.0], false)
}

fn check_radius(what: &'static str, radius: f64) -> Result<(), Error> {
    Error::unless_finite(what, &[radius])?;
    if radius >= 0.0 {
        return Ok(());
    }
    Err(Error::Range {
        what,
        expected: "a number from 0",
        got: radius,
    })
}

fn unit_axis(axis: DVec3) -> Result<DVec3, Error> {
    check_points("axis", &[axis])?;
    if axis == DVec3::ZERO {
        return Err(Error::Range {
            what: "axis",
            expected: "a vector that is not 0",
            got: 0.0,
        });
    }
    Ok(Point::unit(axis))
}

/// Returns an error for a profile that meets the axis inside its domain.
///
/// The radii of a segment, multiplied by their weights, are the control points of a polynomial curve around the axis. It is at
/// the axis where its coordinates along the longest radius and across it are both 0.
fn check_profile(
    profile: &NurbsCurve<DVec3>,
    axis: DVec3,
    near: f64,
    radius: impl Fn(DVec3) -> DVec3,
) -> Result<(), Error> {
    let count = profile.segments().len();
    for (k, segment) in profile.segments().iter().enumerate() {
        let parts = segment.weighted();
        let heaviest = parts
            .iter()
            .fold(0.0, |max: f64, part| max.max(part.weight));
        let radii: Vec<DVec3> = parts
            .iter()
            .map(|part| radius(part.point) * (part.weight / heaviest))
            .collect();
        let longest = radii
            .iter()
            .copied()
            .max_by(|a, b| Point::norm(*a).total_cmp(&Point::norm(*b)));
        let along = Point::unit(longest.unwrap_or_default());
        let across = axis.cross(along);
        let coordinates =
            |direction: DVec3| -> Vec<f64> { radii.iter().map(|r| r.dot(direction)).collect() };
        let (x, y) = (coordinates(along), coordinates(across));
        // All of it is on the axis if there are no single contacts.
        let met = contacts(&x, near).map_or(Some(0.5), |ts| {
            ts.iter().copied().find(|&t| {
                let at_start = k == 0 && t <= NEAR_END && radii[0] == DVec3::ZERO;
                let at_end =
                    k + 1 == count && t >= 1.0 - NEAR_END && radii[x.len() - 1] == DVec3::ZERO;
                evaluate_scalar(&y, t).abs() <= TOUCHING * near && !at_start && !at_end
            })
        });
        if let Some(t) = met {
            let joints = profile.joints();
            return Err(Error::Range {
                what: "t where the profile meets the axis",
                expected: "an end of the profile",
                got: joints[k] + t * (joints[k + 1] - joints[k]),
            });
        }
    }
    Ok(())
}
