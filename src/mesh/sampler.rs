//! Second derivatives, points and normals of polynomial patches.

use super::buffers::to_f32;
use super::mesh_patch::{Bends, Frame, MeshPatch, PatchNetwork, PatchSampler, SpaceCurve};
use crate::bernstein::evaluate::evaluate;
use crate::curve::Curve;
use crate::curve::flatten::Polyline;
use crate::geometry::check::max_abs;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::list::{Net, Points};
use crate::patch::Patch;
use crate::patch::net::{differences_u, differences_v};
use crate::patch::normal::NormalNet;
use crate::patch::tensor_product::{REGULAR_RATIO, directions};
use crate::surface::network::Surface;
use crate::surface::topology::SideUse;
use casteljau_kernels::mesh::row_sampler::RowSampler;
use casteljau_kernels::mesh::second_differences::{BEND_SLACK, SecondDifferences};
use casteljau_kernels::numeric::order::larger;
use glam::DVec3;

impl PatchNetwork for Surface {
    type Patch = Patch;
    type Edge = Points<DVec3>;

    fn network(&self) -> &Surface {
        self
    }

    fn patch(&self, patch: usize) -> Option<Patch> {
        self.patch(patch)
    }

    fn side_uses(&self) -> Vec<SideUse> {
        self.side_uses()
    }

    fn edge(&self, number: usize) -> Points<DVec3> {
        let vertices = self.side(number);
        vertices.map(|v| self.vertices()[v as usize]).collect()
    }

    fn edge_point(edge: &Points<DVec3>, t: f64) -> DVec3 {
        evaluate(edge, t)
    }
}

impl MeshPatch for Patch {
    type Bends = [f64; 3];
    type Sampler = Sampler;
    type Isocurve = Curve<DVec3>;

    fn net(&self) -> &Patch {
        self
    }

    fn start(&self, has_position: bool, stack: &mut SecondDifferences) -> Frame {
        let columns = self.columns;
        // The second differences are f32, so they are those of the net scaled to a size of 1.
        let size = max_abs(&self.points).max(f64::MIN_POSITIVE);
        let (m, n) = (columns - 1, self.points.len() / columns - 1);
        let (a, b) = (m as f64, n as f64);
        let net: Vec<DVec3> = self.points.iter().map(|&p| p / size).collect();
        let (du, dv) = (differences_u(&net, columns), differences_v(&net, columns));
        // A direction of degree 1 has no second differences: its net is empty.
        let uu = if m > 1 {
            differences_u(&du, m)
        } else {
            Net::new()
        };
        let vv = if n > 1 {
            differences_v(&dv, columns)
        } else {
            Net::new()
        };
        let uv = differences_v(&du, m);
        let position = if has_position { &net[..] } else { &[] };
        let sizes = [
            (m - 1, n + 1),
            (m, n),
            (m + 1, n - 1),
            (columns, position.len() / columns),
        ];
        let nets = [
            (&uu[..], a * (a - 1.0)),
            (&uv, a * b),
            (&vv, b * (b - 1.0)),
            (position, 1.0),
        ];
        let vectors = nets.into_iter().flat_map(|(net, factor)| {
            net.iter()
                .map(move |&p| (p * factor).extend(0.0).to_array().map(to_f32))
        });
        stack.start(sizes, vectors);
        Frame {
            origin: DVec3::ZERO,
            size,
        }
    }

    fn sampler(&self) -> Sampler {
        Sampler::new(&self.points, self.columns)
    }

    fn isocurve(&self, constant_u: bool, at: f64) -> Curve<DVec3> {
        if constant_u {
            self.isocurve_at_u(at)
        } else {
            self.isocurve_at_v(at)
        }
    }

    fn normal(&self, u: f64, v: f64) -> DVec3 {
        self.normal(u, v)
    }
}

impl SpaceCurve for Curve<DVec3> {
    fn eval(&self, t: f64) -> DVec3 {
        self.eval(t)
    }

    fn tangent(&self, t: f64) -> DVec3 {
        self.tangent(t)
    }

    fn flatten(&self, tolerance: f64) -> Result<Polyline<DVec3>, Error> {
        self.flatten(tolerance)
    }

    fn weighted_points(&self) -> impl Iterator<Item = (DVec3, f64)> {
        self.control_points().iter().map(|&p| (p, 1.0))
    }
}

impl Bends for [f64; 3] {
    const MAX_EXCESS: f64 = 1.0;
    const SUFFICE_FOR_HALVES: bool = false;

    fn of_patch(stack: &mut SecondDifferences, frame: &Frame) -> Self {
        longest(stack, 0, frame)
    }

    fn of_halves(&self, stack: &mut SecondDifferences, frame: &Frame) -> [Self; 2] {
        [longest(stack, 1, frame), longest(stack, 0, frame)]
    }

    fn joined_distance([near, far]: &[Self; 2], stack: &SecondDifferences, sides: [f64; 2]) -> f64 {
        [0, 1, 2]
            .map(|k| larger(near[k], far[k]))
            .distance(stack, sides)
    }

    fn lengths(&self, _stack: &SecondDifferences) -> [f64; 3] {
        *self
    }

    fn distance(&self, _stack: &SecondDifferences, [h, k]: [f64; 2]) -> f64 {
        let [uu, uv, vv] = self;
        (h * h * uu + 2.0 * h * k * uv + k * k * vv) / 8.0
    }

    fn control_box(&self, stack: &SecondDifferences) -> [[f32; 3]; 2] {
        stack.control_box()
    }
}

/// The bounds for the piece that is `before` entries below the top of the stack.
fn longest(stack: &SecondDifferences, before: usize, frame: &Frame) -> [f64; 3] {
    let scale = frame.size * (1.0 + BEND_SLACK);
    stack
        .longest(before)
        .map(|length| f64::from(length) * scale)
}

/// A patch with precomputed data for repeated evaluation.
pub(crate) struct Sampler {
    samples: RowSampler<3>,
    /// Differences along u and v, each scaled to size 1.
    du: Net,
    dv: Net,
    degree_u: usize,
    limits: Option<NormalNet>,
}

impl Sampler {
    fn new(net: &[DVec3], columns: usize) -> Self {
        let (du, dv) = directions(net, columns);
        let nets = [net, &du, &dv].map(|net| net.iter().map(DVec3::to_array).collect());
        Self {
            samples: RowSampler::new(columns, nets),
            du,
            dv,
            degree_u: columns - 1,
            limits: None,
        }
    }

    fn limits(&mut self) -> &NormalNet {
        let (du, dv, m) = (&self.du, &self.dv, self.degree_u);
        self.limits
            .get_or_insert_with(|| NormalNet::new(du, dv, m, dv.len() / (m + 1)))
    }
}

impl PatchSampler for Sampler {
    fn has_area(&mut self) -> bool {
        // This suffices nearly always, since the middle is regular.
        is_regular(self.samples.sample(0.5, 0.5).1.into()) || !self.limits().vanishes()
    }

    fn point_and_normal(&mut self, u: f64, v: f64) -> (DVec3, DVec3) {
        let (point, cross_product) = self.samples.sample(u, v);
        let cross_product = DVec3::from(cross_product);
        let normal = if is_regular(cross_product) {
            Point::unit(cross_product)
        } else {
            self.limits().limit(u, v)
        };
        (point.into(), normal)
    }
}

fn is_regular(cross_product: DVec3) -> bool {
    cross_product.length_squared() > REGULAR_RATIO * REGULAR_RATIO
}
