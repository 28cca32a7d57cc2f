//! Point and normal of one patch at many parameters.

use super::net::Net;
use super::normal::NormalNet;
use super::patch::{REGULAR_RATIO, directions};
use crate::point::Point;
use glam::DVec3;

/// A patch with what evaluating it over and over needs.
pub(super) struct Sampler {
    net: Net,
    columns: usize,
    /// Differences along u and v, each brought to the size 1.
    du: Net,
    dv: Net,
    limits: Option<NormalNet>,
    u: Weights,
    v: Weights,
}

/// The Bernstein weights of a degree and of the degree below at one parameter.
struct Weights {
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Sampler {
    pub(super) fn new(net: Net, columns: usize) -> Self {
        let (du, dv) = directions(&net, columns);
        let rows = net.len() / columns;
        Self {
            du,
            dv,
            limits: None,
            u: Weights::new(columns),
            v: Weights::new(rows),
            net,
            columns,
        }
    }

    /// Whether the patch has an inside: it is no curve and no point.
    pub(super) fn has_area(&mut self) -> bool {
        // Nearly always the middle is regular.
        self.set(0.5, 0.5);
        let facing = self.facing();
        facing.length_squared() > REGULAR_RATIO * REGULAR_RATIO || !self.limits().vanishes()
    }

    /// The point and the unit normal at (u, v), its limit where the patch is not regular.
    pub(super) fn point_and_normal(&mut self, u: f64, v: f64) -> (DVec3, DVec3) {
        self.set(u, v);
        let facing = self.facing();
        let normal = if facing.length_squared() > REGULAR_RATIO * REGULAR_RATIO {
            facing.unit()
        } else {
            self.limits().limit(u, v)
        };
        let point = blend(&self.net, self.columns, &self.u.values, &self.v.values);
        (point, normal)
    }

    fn set(&mut self, u: f64, v: f64) {
        self.u.set(u);
        self.v.set(v);
    }

    /// ∂u × ∂v, up to a factor.
    fn facing(&self) -> DVec3 {
        let along_u = blend(&self.du, self.columns - 1, &self.u.slopes, &self.v.values);
        let along_v = blend(&self.dv, self.columns, &self.u.values, &self.v.slopes);
        along_u.cross(along_v)
    }

    fn limits(&mut self) -> &NormalNet {
        let (m, n) = (self.columns - 1, self.net.len() / self.columns - 1);
        let (du, dv) = (&self.du, &self.dv);
        self.limits
            .get_or_insert_with(|| NormalNet::new(du, dv, m, n))
    }
}

/// Σ Σ wᵢ wⱼ Pᵢⱼ.
fn blend(net: &[DVec3], columns: usize, u: &[f64], v: &[f64]) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for (row, &weight) in net.chunks_exact(columns).zip(v) {
        let mut along = DVec3::ZERO;
        for (&point, &weight) in row.iter().zip(u) {
            along += point * weight;
        }
        sum += along * weight;
    }
    sum
}

impl Weights {
    fn new(count: usize) -> Self {
        Self {
            values: vec![0.0; count],
            slopes: vec![0.0; count - 1],
        }
    }

    /// Row by row as in `bernstein`; exactly 0 and 1 at the ends.
    fn set(&mut self, t: f64) {
        let s = 1.0 - t;
        let last = self.slopes.len();
        self.values[0] = 1.0;
        for row in 1..=last {
            if row == last {
                self.slopes.copy_from_slice(&self.values[..last]);
            }
            let mut carry = 0.0;
            for weight in &mut self.values[..row] {
                let product = *weight;
                *weight = carry + s * product;
                carry = t * product;
            }
            self.values[row] = carry;
        }
    }
}
