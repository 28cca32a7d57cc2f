//! Meshes of surfaces of rational patches.
//!
//! A piece S = A/w and a flat triangle with its corners on the piece are within (M₁ + 2M₂ + M₃)/(8 min w) of each other, where
//! M₁ = m(m − 1)(max |Δuu A| + ρ max |Δuu w|), and M₂ and M₃ likewise. The origin of A is a point near the piece, and ρ the largest distance
//! of its control points from that point: linear interpolation of (A, w) projects onto the flat triangle. Source: Zheng and
//! Sederberg, "Estimating tessellation parameter intervals for rational curves and surfaces", ACM TOG 19 (2000). The parts of
//! the three terms along any axis and across it can be bounded apart, as lengths of the two legs of a right triangle.

use super::RationalSurface;
use crate::geometry::check::max_abs;
use crate::geometry::error::Error;
use crate::mesh::Mesh;
use crate::mesh::adaptive::{tessellate, tessellate_f64};
use crate::mesh::buffers::to_f32;
use crate::mesh::mesh_patch::{Bends, Frame, MeshPatch, PatchNetwork, PatchSampler};
use crate::mesh::options::{Detail, TessellationOptions};
use crate::numeric::float::as_f64;
use crate::patch::Patch;
use crate::patch::normal::NormalNet;
use crate::patch::tensor_product::REGULAR_RATIO;
use crate::rational::RationalCurve;
use crate::rational::patch::{NOISE, RationalPatch};
use crate::rational::weighted::Homogeneous;
use crate::surface::network::Surface;
use crate::surface::scaling::Scaling;
use crate::surface::topology::SideUse;
use casteljau_kernels::mesh::row_sampler::{RowSampler, unit_normal};
use casteljau_kernels::mesh::second_differences::SecondDifferences;
use casteljau_kernels::numeric::vector::Vector;
use glam::DVec3;

/// The largest quotient of two weights of a patch for which tolerances hold.
pub(super) const MAX_QUOTIENT: f64 = 1_048_576.0;

impl RationalSurface {
    /// A mesh without cracks and T-junctions; see [`Surface::tessellate`], whose promises hold.
    ///
    /// # Errors
    /// As there; [`Error::Range`] by tolerance or pixels for a patch whose largest weight is more than 2²⁰ times its smallest
    /// one.
    ///
    /// Source of the bound: Zheng and Sederberg, ACM TOG 19 (2000).
    pub fn tessellate(&self, options: &TessellationOptions) -> Result<Mesh, Error> {
        self.check_quotients(&options.detail)?;
        tessellate(self, options)
    }

    /// As [`tessellate`](Self::tessellate), with positions and normals in f64.
    ///
    /// # Errors
    /// As `tessellate`, with ulps of f64.
    pub fn tessellate_f64(&self, options: &TessellationOptions) -> Result<Mesh<f64>, Error> {
        self.check_quotients(&options.detail)?;
        tessellate_f64(self, options)
    }

    /// Returns an error for a patch whose weights differ too much for a tolerance.
    fn check_quotients(&self, detail: &Detail) -> Result<(), Error> {
        if matches!(detail, Detail::Segments(_)) {
            return Ok(());
        }
        for patch in 0..self.patch_count() {
            let quotient = quotient(self.patch_weights(patch).unwrap_or_default());
            if quotient > MAX_QUOTIENT {
                return Err(Error::Range {
                    what: "largest weight of a patch divided by its smallest one",
                    expected: "at most 2^20 for a tolerance",
                    got: quotient,
                });
            }
        }
        Ok(())
    }
}

/// The largest of some weights divided by the smallest one.
pub(super) fn quotient(weights: &[f64]) -> f64 {
    let [min, max] = weights
        .iter()
        .fold([f64::INFINITY, 0.0], |[min, max]: [f64; 2], &w| {
            [min.min(w), max.max(w)]
        });
    max / min
}

impl PatchNetwork for RationalSurface {
    type Patch = RationalPatch;
    type Edge = RationalCurve<DVec3>;

    fn network(&self) -> &Surface {
        &self.network
    }

    fn patch(&self, patch: usize) -> Option<RationalPatch> {
        self.patch(patch)
    }

    fn side_uses(&self) -> Vec<SideUse> {
        self.line_uses()
    }

    fn edge(&self, number: usize) -> RationalCurve<DVec3> {
        let vertices = self.network.side(number);
        let points = vertices.map(|v| self.vertices()[v as usize]);
        RationalCurve::from_valid(points.zip(self.side_weights(number)))
    }

    fn edge_point(edge: &RationalCurve<DVec3>, t: f64) -> DVec3 {
        edge.eval(t)
    }
}

impl MeshPatch for RationalPatch {
    type Bends = PieceBends;
    type Sampler = RationalSampler;
    type Isocurve = RationalCurve<DVec3>;

    fn net(&self) -> &Patch {
        self.net()
    }

    fn start(&self, _has_position: bool, stack: &mut SecondDifferences) -> Frame {
        let frame = Scaling::around(self.control_bounds());
        let (m, n) = (self.degree_u(), self.degree_v());
        let (a, b) = (m as f64, n as f64);
        let net = self.scaled(&frame);
        let (du, dv) = (differences_u(&net, m + 1), differences_v(&net, m + 1));
        let nets = [
            (&differences_u(&du, m), a * (a - 1.0)),
            (&differences_v(&du, m), a * b),
            (&differences_v(&dv, m + 1), b * (b - 1.0)),
            (&net, 1.0),
        ];
        let vectors = nets.into_iter().flat_map(|(net, factor)| {
            net.iter().map(move |&p| {
                let Homogeneous { vector, weight } = p * factor;
                vector.extend(weight).to_array().map(to_f32)
            })
        });
        let sizes = [(m - 1, n + 1), (m, n), (m + 1, n - 1), (m + 1, n + 1)];
        stack.start(sizes, vectors);
        Frame {
            origin: frame.centre,
            size: frame.size,
        }
    }

    fn sampler(&self) -> RationalSampler {
        RationalSampler::new(self.clone())
    }

    fn isocurve(&self, constant_u: bool, at: f64) -> RationalCurve<DVec3> {
        if constant_u {
            self.curve_at_u(at)
        } else {
            self.curve_at_v(at)
        }
    }

    fn normal(&self, u: f64, v: f64) -> DVec3 {
        self.normal(u, v)
    }
}

impl RationalPatch {
    /// The homogeneous control points (A, w) in scaled coordinates, with a largest weight of 1 to 2.
    pub(super) fn scaled(&self, frame: &Scaling) -> Vec<Homogeneous<DVec3>> {
        let mut net = self.homogeneous(frame.centre);
        for part in &mut net {
            part.vector /= frame.size;
        }
        net
    }
}

/// The size of the patch, by which the bounds on the stack are multiplied. They stay there, because a piece is copied several times.
#[derive(Clone, Copy)]
pub(crate) struct PieceBends {
    size: f64,
}

impl Bends for PieceBends {
    /// √a² + b² is at least (a + b)/√2.
    const MAX_EXCESS: f64 = std::f64::consts::SQRT_2;
    /// They take most of the time of a cut.
    const SUFFICE_FOR_HALVES: bool = true;

    fn of_patch(stack: &mut SecondDifferences, frame: &Frame) -> Self {
        stack.bound();
        Self { size: frame.size }
    }

    fn of_halves(&self, stack: &mut SecondDifferences, _frame: &Frame) -> [Self; 2] {
        stack.bound_halves();
        [*self; 2]
    }

    fn joined_distance([half, _]: &[Self; 2], stack: &SecondDifferences, sides: [f64; 2]) -> f64 {
        stack.joined_distance(sides) * half.size
    }

    fn lengths(&self, stack: &SecondDifferences) -> [f64; 3] {
        let lengths = stack.last_bends().lengths();
        lengths.map(|length| length * self.size)
    }

    fn cut_by_weights(stack: &SecondDifferences) -> Option<bool> {
        stack.is_steeper_along_u()
    }

    fn distance(&self, stack: &SecondDifferences, sides: [f64; 2]) -> f64 {
        stack.last_bends().distance(sides) * self.size
    }

    fn control_box(&self, stack: &SecondDifferences) -> [[f32; 3]; 2] {
        stack.last_bends().control_box()
    }
}

/// A rational patch with precomputed data for repeated evaluation, in scaled coordinates.
pub(crate) struct RationalSampler {
    samples: RowSampler<4>,
    normals: Normals,
}

impl RationalSampler {
    pub(super) fn new(patch: RationalPatch) -> Self {
        let normals = Normals::new(patch);
        let columns = normals.patch.degree_u() + 1;
        let net = normals.patch.scaled(&normals.frame);
        let (du, dv) = (differences_u(&net, columns), differences_v(&net, columns));
        let numbers = |part: &Homogeneous<DVec3>| part.vector.extend(part.weight).to_array();
        let nets = [net, du, dv].map(|net| net.iter().map(numbers).collect());
        Self {
            samples: RowSampler::new(columns, nets),
            normals,
        }
    }

    /// The homogeneous point at (u, v) in scaled coordinates, and the sums of the differences along u and v.
    fn homogeneous(&mut self, u: f64, v: f64) -> [Homogeneous<DVec3>; 3] {
        self.samples
            .sample(u, v)
            .map(|[x, y, z, weight]| Homogeneous {
                vector: DVec3::new(x, y, z),
                weight,
            })
    }

    /// The point at (u, v), and ∂S/∂u and ∂S/∂v there, in scaled coordinates.
    pub(super) fn derivatives(&mut self, u: f64, v: f64) -> [DVec3; 3] {
        let [point, along_u, along_v] = self.homogeneous(u, v);
        let local = point.vector / point.weight;
        let patch = &self.normals.patch;
        let derivative = |along: Homogeneous<DVec3>, degree: usize| {
            (along.vector - local * along.weight) * (as_f64(degree) / point.weight)
        };
        [
            local,
            derivative(along_u, patch.degree_u()),
            derivative(along_v, patch.degree_v()),
        ]
    }
}

/// Normals of a rational patch at many parameters.
pub(super) struct Normals {
    pub(super) patch: RationalPatch,
    pub(super) frame: Scaling,
    /// The length of ∂u × ∂v, as of `directions` of the kernels, above which it exceeds rounding noise.
    min_length: f64,
    /// The last normal net, and the point that is its origin.
    limits: Option<(DVec3, NormalNet)>,
}

impl Normals {
    pub(super) fn new(patch: RationalPatch) -> Self {
        let frame = Scaling::around(patch.control_bounds());
        let columns = patch.degree_u() + 1;
        let points: Vec<DVec3> = patch
            .control_points()
            .iter()
            .map(|&p| frame.local_point(p))
            .collect();
        let [u, v] = [
            differences_u(&points, columns),
            differences_v(&points, columns),
        ]
        .map(|net| max_abs(&net));
        Self {
            min_length: (REGULAR_RATIO * u * v).max(NOISE * u.max(v)),
            frame,
            patch,
            limits: None,
        }
    }

    /// The unit normal at (u, v), where ∂u and ∂v have the given directions.
    pub(super) fn normal(&mut self, along: [DVec3; 2], [u, v]: [f64; 2]) -> DVec3 {
        match unit_normal(along, self.min_length) {
            Some(normal) => normal,
            // All points of an edge that is a pole are equal, so that they have one net.
            None => self.limits(u, v).limit(u, v),
        }
    }

    /// The normal net with the point at (u, v) as origin.
    fn limits(&mut self, u: f64, v: f64) -> &NormalNet {
        let point = self.patch.eval(u, v);
        if self
            .limits
            .as_ref()
            .is_none_or(|(origin, _)| *origin != point)
        {
            self.limits = None;
        }
        let patch = &self.patch;
        let limits = self
            .limits
            .get_or_insert_with(|| (point, patch.normal_net(point)));
        &limits.1
    }
}

impl PatchSampler for RationalSampler {
    fn has_area(&mut self) -> bool {
        let (_, along) = self.samples.point_and_directions(0.5, 0.5);
        let normals = &mut self.normals;
        unit_normal(along, normals.min_length).is_some() || !normals.limits(0.5, 0.5).vanishes()
    }

    fn point_and_normal(&mut self, u: f64, v: f64) -> (DVec3, DVec3) {
        let (local, along) = self.samples.point_and_directions(u, v);
        let frame = &self.normals.frame;
        let point = local * frame.size + frame.centre;
        (point, self.normals.normal(along, [u, v]))
    }
}

/// The differences of neighbouring vectors along u, which have one column fewer.
pub(super) fn differences_u<V: Vector>(net: &[V], columns: usize) -> Vec<V> {
    let rows = net.chunks(columns);
    rows.flat_map(|row| row.windows(2).map(|pair| pair[1] - pair[0]))
        .collect()
}

/// The differences of neighbouring vectors along v, which have one row fewer.
pub(super) fn differences_v<V: Vector>(net: &[V], columns: usize) -> Vec<V> {
    let next = net.iter().skip(columns);
    net.iter().zip(next).map(|(&a, &b)| b - a).collect()
}
