//! Classification of a curve: line, quadratic, arch, serpentine, loop, cusp, twisted.

use super::Curve;
use super::curvature_numerator::curvature_numerator;
use super::elevate::unelevated;
use super::hodograph::Hodograph;
use super::inflections::inflections_of;
use crate::bernstein::roots::discriminant;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::list::Points;
use glam::{DVec2, DVec3};

/// The shape of a curve, as far as affine maps preserve it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum CurveKind {
    /// All control points coincide.
    Point,
    /// All control points lie on a line; the curve may reverse its direction.
    Line,
    /// A parabola, whatever the degree of the control polygon.
    Quadratic,
    /// The curve bends to one side only and has no self-intersection.
    Arch,
    /// The curve has an inflection.
    Serpentine,
    /// The curve crosses or touches itself.
    Loop,
    /// The curve has a cusp: it stops and reverses its direction.
    Cusp,
    /// The curve lies in no plane.
    Twisted,
}

impl<P: Point> Curve<P> {
    /// The kind of the curve for t from 0 to 1.
    ///
    /// Points, lines, parabolas (also of elevated degree) and, in space, curves that lie in no plane are recognised
    /// first. All other curves are classified in their plane: [`CurveKind::Cusp`] if the curve has a cusp inside,
    /// [`CurveKind::Loop`] if it intersects itself, [`CurveKind::Serpentine`] if it has an inflection inside, else
    /// [`CurveKind::Arch`]. For a cubic these exclude each other; they correspond to the sign of the discriminant of
    /// B′×B″. For higher degrees the result is the first that holds, in this order. The only thresholds are multiples
    /// of the rounding of the control points, so the result does not depend on the size.
    ///
    /// Source: Stone and DeRose, "A geometric characterization of parametric cubic curves", ACM TOG 8 (1989); Loop and
    /// Blinn, "Resolution independent curve rendering", SIGGRAPH 2005.
    ///
    /// ```
    /// use casteljau::{Curve, curve::CurveKind, glam::DVec2};
    ///
    /// let of = |points: [(f64, f64); 4]| Curve::new(&points.map(DVec2::from)).map(|curve| curve.classify());
    /// assert_eq!(of([(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)])?, CurveKind::Arch);
    /// assert_eq!(of([(0.0, 0.0), (4.0, 2.0), (-2.0, 2.0), (2.0, 0.0)])?, CurveKind::Loop);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn classify(&self) -> CurveKind {
        let unit = Hodograph::of(&self.points).unit;
        let rounding = ulp(self.max_abs());
        if unit <= 2.0 * rounding {
            return CurveKind::Point;
        }
        let normalized = Normalized::new(self.start(), unit);
        let vectors: Points<P> = normalized.points(&self.points);
        let rounding = rounding * normalized.scale;
        match in_its_plane(&vectors, 4.0 * vectors.len() as f64 * rounding) {
            AffineHull::Line => CurveKind::Line,
            AffineHull::Space => CurveKind::Twisted,
            AffineHull::Plane(points) => {
                class_in_plane(&at_lowest_degree(points, rounding), rounding)
            }
        }
    }
}

/// The control points of the curve at the lowest degree that represents it up to rounding.
fn at_lowest_degree<P: Point>(mut points: Points<P>, rounding: f64) -> Points<P> {
    while points.len() > 2 {
        let slack = 4.0 * rounding * points.len() as f64;
        let lower = Curve::from_points(unelevated(&points));
        if !lower
            .elevated()
            .approx_eq(&Curve::from_slice(&points), slack)
        {
            break;
        }
        points = lower.points;
    }
    points
}

/// Rounding error of the arithmetic of `in_its_plane`, as a part of the longest vector; it adds to the rounding of the
/// points. With u = ε/2, a normalized vector is off by 4.5 u. A distance from the line is off by 4.5 u from the vector,
/// 7.5 u from the scalar product and u from the last product: 13 u. A distance from the plane is off by 13 u because of
/// the direction `across`, 4.5 u because of `along`, 2.5 u by the cross product and 3 u by the scalar product: 23 u in
/// total.
const FLATNESS_ROUNDING: f64 = 12.0 * f64::EPSILON;

/// The affine hull of a control polygon.
enum AffineHull {
    Line,
    /// The points with one coordinate dropped; this affine map preserves the kind.
    Plane(Points<DVec3>),
    Space,
}

/// The plane or line of `vectors`, which begin at the origin. `slack` is the distance by which rounding may move a
/// point.
fn in_its_plane<P: Point>(vectors: &[P], slack: f64) -> AffineHull {
    let vectors: Points<DVec3> = vectors.iter().map(|vector| vector.to_3d()).collect();
    let longest = |a: DVec3, b: DVec3| if b.dot(b) > a.dot(a) { b } else { a };
    let farthest = vectors.iter().copied().fold(DVec3::ZERO, longest);
    let slack = slack + FLATNESS_ROUNDING * Point::norm(farthest);
    let along = Point::unit(farthest);
    let across = vectors
        .iter()
        .map(|&vector| vector - along * vector.dot(along));
    let across = across.fold(DVec3::ZERO, longest);
    if Point::norm(across) <= slack {
        return AffineHull::Line;
    }
    let normal = along.cross(Point::unit(across));
    if vectors
        .iter()
        .any(|vector| vector.dot(normal).abs() > slack)
    {
        return AffineHull::Space;
    }
    let size = normal.abs();
    let flat = |vector: &DVec3| {
        if size.z >= size.x.max(size.y) {
            DVec3::new(vector.x, vector.y, 0.0)
        } else if size.x >= size.y {
            DVec3::new(vector.y, vector.z, 0.0)
        } else {
            DVec3::new(vector.z, vector.x, 0.0)
        }
    };
    AffineHull::Plane(vectors.iter().map(flat).collect())
}

/// The kind of a plane curve (z = 0) of its lowest degree.
fn class_in_plane(points: &[DVec3], rounding: f64) -> CurveKind {
    if points.len() == 3 {
        CurveKind::Quadratic
    } else if !Hodograph::of(points).cusps(rounding).is_empty() {
        CurveKind::Cusp
    } else if meets_itself(points) {
        CurveKind::Loop
    } else if !inflections_of(points, rounding).is_empty() {
        CurveKind::Serpentine
    } else {
        CurveKind::Arch
    }
}

/// Whether the curve has a double point inside. For a cubic its two parameters are −B/A ± √(−3 (B² − aA)) / A, where
/// B′×B″ = a + 2Bt + At². Coincident end points count as a double point.
fn meets_itself(points: &[DVec3]) -> bool {
    let (turning, _) = curvature_numerator(&Hodograph::of(points).vectors, 0.0);
    let [a, b, c] = *turning else {
        let plane: Points<DVec2> = points.iter().map(|p| p.to_2d()).collect();
        let closed = points[0] == points[points.len() - 1];
        return closed || !Curve::from_points(plane).self_intersections().is_empty();
    };
    let (discriminant, lead) = (discriminant(a, b, c), a - 2.0 * b + c);
    let (middle, reach) = ((a - b) / lead, (-3.0 * discriminant).sqrt() / lead.abs());
    let inside = middle - reach >= 0.0 && middle + reach <= 1.0;
    discriminant < 0.0 && (inside || points[0] == points[3])
}
