//! Points and normals of one patch at many parameters.

use crate::geometry::point::Point;
use crate::numeric::list::Net;
use crate::patch::normal::NormalNet;
use crate::patch::tensor_product::{REGULAR_RATIO, directions};
use casteljau_kernels::mesh::row_sampler::RowSampler;
use glam::DVec3;

/// A patch with precomputed data for repeated evaluation.
pub(crate) struct Sampler {
    samples: RowSampler,
    /// Differences along u and v, each scaled to size 1.
    du: Net,
    dv: Net,
    degree_u: usize,
    limits: Option<NormalNet>,
}

impl Sampler {
    pub(crate) fn new(net: &[DVec3], columns: usize) -> Self {
        let (du, dv) = directions(net, columns);
        Self {
            samples: RowSampler::new(columns, [net, &du, &dv]),
            du,
            dv,
            degree_u: columns - 1,
            limits: None,
        }
    }

    /// Whether the patch has an area, and is not a curve or a point.
    pub(crate) fn has_area(&mut self) -> bool {
        // This suffices nearly always, since the middle is regular.
        is_regular(self.samples.sample(0.5, 0.5).1.into()) || !self.limits().vanishes()
    }

    /// The point and the unit normal at (u, v); the normal is a limit where the patch is not regular. Consecutive calls
    /// with the same v are cheaper.
    pub(crate) fn point_and_normal(&mut self, u: f64, v: f64) -> (DVec3, DVec3) {
        let (point, cross_product) = self.samples.sample(u, v);
        let cross_product = DVec3::from(cross_product);
        let normal = if is_regular(cross_product) {
            Point::unit(cross_product)
        } else {
            self.limits().limit(u, v)
        };
        (point.into(), normal)
    }

    fn limits(&mut self) -> &NormalNet {
        let (du, dv, m) = (&self.du, &self.dv, self.degree_u);
        self.limits
            .get_or_insert_with(|| NormalNet::new(du, dv, m, dv.len() / (m + 1)))
    }
}

fn is_regular(cross_product: DVec3) -> bool {
    cross_product.length_squared() > REGULAR_RATIO * REGULAR_RATIO
}
