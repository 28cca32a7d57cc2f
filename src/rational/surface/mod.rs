//! NURBS surfaces: rational B-splines in two parameters.
//!
//! Every nonempty rectangle of knots is a rational patch. The patches are computed when the surface is made and answer
//! queries; operations on knots work row by row, on the rows and columns of the net as NURBS curves.

mod construct;
mod edit;
mod loft;

pub(super) use construct::Turning;

use super::check_weights;
use super::nurbs::{NurbsCurve, locate};
use super::patch::{RationalPatch, bounds_of};
use super::weighted::{WeightedPoint, are_close, transposed};
use crate::curve::eval::MAX_OUTPUT_F64;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::patch::tensor_product::check_degree;
use crate::patch::{Curvature, Partials};
use glam::DVec3;

/// A NURBS surface: a non-uniform rational B-spline of degrees 1 to 64 in u and in v, in space.
///
/// S(u, v) = Σ wᵢⱼ Nᵢ(u) Nⱼ(v) Pᵢⱼ / Σ wᵢⱼ Nᵢ(u) Nⱼ(v), where the N are the B-splines over the knots of each direction, with a
/// weight above 0 for each control point. u runs along the fast index of the net. Each row of the net is an open [`NurbsCurve`] in u,
/// and each column one in v: the rules for knots, multiplicities and the domain are those of such a curve. Parameters outside
/// the domain extrapolate the patches at its boundary.
///
/// Source: Piegl and Tiller, *The NURBS Book*, §4.4.
///
/// ```
/// use casteljau::{NurbsSurface, glam::DVec3};
///
/// let sphere = NurbsSurface::sphere(DVec3::ZERO, 2.0, DVec3::Z)?;
/// assert!((sphere.eval(0.3, 0.7).length() - 2.0).abs() < 1e-14);
/// assert!((sphere.curvature(0.3, 0.7).gaussian - 0.25).abs() < 1e-13);
/// assert_eq!(sphere.normal(0.3, 1.0), DVec3::Z); // the pole
/// assert_eq!(sphere.patches().len(), 8);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct NurbsSurface {
    points: Vec<DVec3>,
    weights: Vec<f64>,
    u: Direction,
    v: Direction,
    /// The patches over the rectangles between joints, u along the fast index.
    patches: Vec<RationalPatch>,
}

/// The degree and the knots in one direction.
#[derive(Clone, Debug, Default, PartialEq)]
struct Direction {
    degree: usize,
    knots: Vec<f64>,
    /// The knots between the patches, and the ends of the domain.
    joints: Vec<f64>,
}

impl Direction {
    fn new(degree: usize, knots: &[f64]) -> Self {
        Self {
            degree,
            knots: knots.to_vec(),
            joints: Vec::new(),
        }
    }

    /// The number of control points.
    fn count(&self) -> usize {
        self.knots.len() - self.degree - 1
    }
}

impl NurbsSurface {
    /// Makes a surface from a net with u along the fast index; without weights all are 1.
    ///
    /// The net has a control point for each pair of (knots in u − `degree_u` − 1) and (knots in v − `degree_v` − 1).
    ///
    /// # Errors
    /// [`Error::Range`] unless both degrees are 1 to 64; [`Error::Count`] for fewer than 2·(degree + 1) knots, and for a wrong
    /// number of points or weights; [`Error::NotFinite`] for a NaN or an infinity; [`Error::Item`] for a coordinate, a weight or a
    /// knot that [`NurbsCurve::new`] refuses; [`Error::TooMany`] above 1 GiB of patches.
    pub fn new(
        degree_u: usize,
        degree_v: usize,
        net: &[DVec3],
        weights: Option<&[f64]>,
        knots_u: &[f64],
        knots_v: &[f64],
    ) -> Result<Self, Error> {
        check_degree("degree_u", degree_u)?;
        check_degree("degree_v", degree_v)?;
        let directions = [
            ("knots_u", degree_u, knots_u),
            ("knots_v", degree_v, knots_v),
        ];
        for (what, degree, knots) in directions {
            if knots.len() < 2 * (degree + 1) {
                return Err(Error::Count {
                    what,
                    expected: "at least 2·(degree + 1) knots (rhino3dm leaves out the first and the last one)",
                    got: knots.len(),
                });
            }
        }
        let [u, v] = directions.map(|(_, degree, knots)| Direction::new(degree, knots));
        if net.len() != u.count() * v.count() {
            return Err(Error::Count {
                what: "net",
                expected: "(knots_u − degree_u − 1)·(knots_v − degree_v − 1) control points (rhino3dm leaves out the first and the last knot)",
                got: net.len(),
            });
        }
        check_points("net", net)?;
        if let Some(weights) = weights {
            check_weights(weights, net.len())?;
        }
        for (what, degree, knots) in directions {
            // The first points are valid, so that this can refuse only knots.
            let first = &net[..knots.len() - degree - 1];
            if let Err(error) = NurbsCurve::new(degree, first, None, knots, false) {
                return Err(of_argument(error, what));
            }
        }
        let part = |(i, &point): (usize, &DVec3)| WeightedPoint {
            point,
            weight: weights.map_or(1.0, |weights| weights[i]),
        };
        let parts: Vec<WeightedPoint<DVec3>> = net.iter().enumerate().map(part).collect();
        Self::from_weighted(&parts, u, v)
    }

    /// The surface of control points with weights.
    fn from_weighted(
        parts: &[WeightedPoint<DVec3>],
        mut u: Direction,
        mut v: Direction,
    ) -> Result<Self, Error> {
        let (m, n) = (u.degree, v.degree);
        let (count, limit) = (
            u.spans() * v.spans(),
            MAX_OUTPUT_F64 / 4 / ((m + 1) * (n + 1)),
        );
        if count > limit {
            return Err(Error::too_many("patches", limit, count));
        }
        let (wide, joints_u) = bezier_form(parts, &u)?;
        let width = wide.len() / v.count();
        let (across, joints_v) = bezier_form(&transposed(&wide, width), &v)?;
        (u.joints, v.joints) = (joints_u, joints_v);
        let height = across.len() / width;
        let all = transposed(&across, height);
        let patch = |column: usize, row: usize| {
            let rows = (row * n..=(row + 1) * n).map(|row| row * width + column * m);
            let net: Vec<WeightedPoint<DVec3>> = rows
                .flat_map(|from| all[from..=from + m].iter().copied())
                .collect();
            RationalPatch::from_weighted(&net, m + 1)
        };
        let patches = (1..v.joints.len())
            .flat_map(|row| (1..u.joints.len()).map(move |column| (column - 1, row - 1)))
            .map(|(column, row)| patch(column, row))
            .collect();
        Ok(Self {
            points: parts.iter().map(|part| part.point).collect(),
            weights: parts.iter().map(|part| part.weight).collect(),
            u,
            v,
            patches,
        })
    }

    /// The degree in u.
    pub fn degree_u(&self) -> usize {
        self.u.degree
    }

    /// The degree in v.
    pub fn degree_v(&self) -> usize {
        self.v.degree
    }

    /// The control points, u along the fast index.
    pub fn control_points(&self) -> &[DVec3] {
        &self.points
    }

    /// The weight of each control point.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The knots in u, in ascending order.
    pub fn knots_u(&self) -> &[f64] {
        &self.u.knots
    }

    /// The knots in v, in ascending order.
    pub fn knots_v(&self) -> &[f64] {
        &self.v.knots
    }

    /// The ends of the range of u; [0, 1] for the constructors of shapes.
    pub fn domain_u(&self) -> [f64; 2] {
        self.u.domain()
    }

    /// The ends of the range of v; [0, 1] for the constructors of shapes.
    pub fn domain_v(&self) -> [f64; 2] {
        self.v.domain()
    }

    /// The rational patches over the nonempty rectangles of knots, u along the fast index.
    ///
    /// Patch i + j·k, where k is one less than the number of [`joints_u`](Self::joints_u), is the surface over the range from
    /// joint i to i + 1 in u and from joint j to j + 1 in v. Adjacent patches have the same control points and weights along
    /// their common edge, bit for bit.
    pub fn patches(&self) -> &[RationalPatch] {
        &self.patches
    }

    /// The values of u at the edges of the patches: one more than patches in this direction.
    pub fn joints_u(&self) -> &[f64] {
        &self.u.joints
    }

    /// The values of v at the edges of the patches.
    pub fn joints_v(&self) -> &[f64] {
        &self.v.joints
    }

    /// The point S(u, v), by the patch that contains it; see [`RationalPatch::eval`].
    pub fn eval(&self, u: f64, v: f64) -> DVec3 {
        let (patch, [u, v], _) = self.patch_at(u, v);
        patch.eval(u, v)
    }

    /// The partial derivatives of first and second order at (u, v), in units of length per unit of u and v.
    ///
    /// At a joint they are those of the patch that starts there. See [`RationalPatch::partials`].
    pub fn partials(&self, u: f64, v: f64) -> Partials {
        let (patch, [u, v], [width, height]) = self.patch_at(u, v);
        let local = patch.partials(u, v);
        Partials {
            u: local.u / width,
            v: local.v / height,
            uu: local.uu / width / width,
            uv: local.uv / width / height,
            vv: local.vv / height / height,
        }
    }

    /// The unit normal at (u, v), also at poles; see [`RationalPatch::normal`].
    pub fn normal(&self, u: f64, v: f64) -> DVec3 {
        let (patch, [u, v], _) = self.patch_at(u, v);
        patch.normal(u, v)
    }

    /// The Gaussian, mean and principal curvatures at (u, v); see [`RationalPatch::curvature`].
    pub fn curvature(&self, u: f64, v: f64) -> Curvature {
        let (patch, [u, v], _) = self.patch_at(u, v);
        patch.curvature(u, v)
    }

    /// The box of the control points, which contains the surface and is cheaper than [`bounds`](Self::bounds).
    pub fn control_bounds(&self) -> Bounds<DVec3> {
        Bounds::from_points(&self.points)
    }

    /// The smallest box that contains the surface: that of all patches; see [`RationalPatch::bounds`].
    pub fn bounds(&self) -> Bounds<DVec3> {
        bounds_of(self.patches.iter()).unwrap_or_else(|| self.control_bounds())
    }

    /// Whether both surfaces have the same degrees and numbers of knots, every control point lies within `tolerance` of its
    /// counterpart, and weights and knots are equal within `tolerance` times the largest one.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        let close = |(&a, &b): (&DVec3, &DVec3)| a == b || a.distance(b) <= tolerance;
        let along = |a: &Direction, b: &Direction| {
            a.degree == b.degree && are_close(&a.knots, &b.knots, tolerance)
        };
        along(&self.u, &other.u)
            && along(&self.v, &other.v)
            && self.points.iter().zip(&other.points).all(close)
            && are_close(&self.weights, &other.weights, tolerance)
    }

    /// The patch that contains (u, v), the parameters on it, and its extent in u and v.
    fn patch_at(&self, u: f64, v: f64) -> (&RationalPatch, [f64; 2], [f64; 2]) {
        let ((column, s), (row, t)) = (locate(&self.u.joints, u), locate(&self.v.joints, v));
        let length = |joints: &[f64], k: usize| joints[k + 1] - joints[k];
        (
            &self.patches[row * (self.u.joints.len() - 1) + column],
            [s, t],
            [length(&self.u.joints, column), length(&self.v.joints, row)],
        )
    }

    /// The control points with their weights.
    fn weighted(&self) -> Vec<WeightedPoint<DVec3>> {
        let parts = self.points.iter().zip(&self.weights);
        parts
            .map(|(&point, &weight)| WeightedPoint { point, weight })
            .collect()
    }
}

impl Direction {
    /// The number of nonempty knot spans.
    fn spans(&self) -> usize {
        let inside = &self.knots[self.degree..=self.count()];
        inside.windows(2).filter(|pair| pair[0] < pair[1]).count()
    }

    fn domain(&self) -> [f64; 2] {
        [self.joints[0], self.joints[self.joints.len() - 1]]
    }

    /// The curve of a row or a column of the net.
    fn curve(&self, parts: &[WeightedPoint<DVec3>]) -> Result<NurbsCurve<DVec3>, Error> {
        let (points, weights): (Vec<DVec3>, Vec<f64>) =
            parts.iter().map(|part| (part.point, part.weight)).unzip();
        NurbsCurve::new(self.degree, &points, Some(&weights), &self.knots, false)
    }
}

/// The rows of a net as Bézier curves that share their ends, and the joints between them.
fn bezier_form(
    parts: &[WeightedPoint<DVec3>],
    along: &Direction,
) -> Result<(Vec<WeightedPoint<DVec3>>, Vec<f64>), Error> {
    let (mut all, mut joints) = (Vec::new(), Vec::new());
    for row in parts.chunks(along.count()) {
        let curve = along.curve(row)?;
        joints = curve.joints().to_vec();
        for (k, segment) in curve.segments().iter().enumerate() {
            // The first point is the last one of the segment before.
            all.extend_from_slice(&segment.weighted()[usize::from(k > 0)..]);
        }
    }
    Ok((all, joints))
}

/// The error with the name of another argument.
fn of_argument(mut error: Error, name: &'static str) -> Error {
    match &mut error {
        Error::Count { what, .. } | Error::NotFinite { what, .. } | Error::Item { what, .. } => {
            *what = name;
        }
        _ => {}
    }
    error
}
