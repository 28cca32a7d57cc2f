//! Evaluation of a patch at many parameters: points and normal vectors, row by row.

use crate::numeric::lanes::f64x2;
use glam::DVec3;

/// A point or a vector.
pub type Vector3 = [f64; 3];

/// The Bernstein weights of a degree and of the next lower degree at one parameter.
#[derive(Clone, Debug, Default)]
struct Weights {
    values: Vec<f64>,
    slopes: Vec<f64>,
}

/// A patch for repeated evaluation; consecutive calls with the same v are cheaper.
#[derive(Clone, Debug)]
pub struct RowSampler {
    columns: usize,
    /// The control points, and the differences along u (rows shorter by one) and along v (one row fewer).
    nets: [Vec<Vector3>; 3],
    v: f64,
    /// The rows of the nets, blended at v.
    row: [Vec<Vector3>; 3],
    across: Weights,
    along: Weights,
}

impl RowSampler {
    /// Expects a net with `columns` points in each row, and its differences along u and v.
    pub fn new(columns: usize, nets: [&[DVec3]; 3]) -> Self {
        Self {
            columns,
            v: f64::NAN,
            row: [columns, columns - 1, columns].map(|length| vec![[0.0; 3]; length]),
            across: Weights::new(nets[0].len() / columns),
            along: Weights::new(columns),
            nets: nets.map(|net| net.iter().map(DVec3::to_array).collect()),
        }
    }

    /// The point and ∂u × ∂v, up to a factor, at (u, v).
    #[inline(never)]
    pub fn sample(&mut self, u: f64, v: f64) -> (Vector3, Vector3) {
        if v != self.v {
            self.v = v;
            self.across.set(v);
            let Weights { values, slopes } = &self.across;
            let columns = self.columns;
            let [net, du, dv] = &self.nets;
            let [points, along_u, along_v] = &mut self.row;
            blend_rows(net, columns, values, points);
            blend_rows(du, columns - 1, values, along_u);
            blend_rows(dv, columns, slopes, along_v);
        }
        self.along.set(u);
        let Weights { values, slopes } = &self.along;
        let [points, along_u, along_v] = &self.row;
        let (a, b) = (blend(along_u, slopes), blend(along_v, values));
        let cross_product = [
            a[1] * b[2] - b[1] * a[2],
            a[2] * b[0] - b[2] * a[0],
            a[0] * b[1] - b[0] * a[1],
        ];
        (blend(points, values), cross_product)
    }
}

impl Weights {
    /// Expects a degree of `count` − 1, at least 1.
    fn new(count: usize) -> Self {
        Self {
            values: vec![0.0; count],
            slopes: vec![0.0; count - 1],
        }
    }

    /// Computes the weights at t, exactly 0 and 1 at the ends.
    fn set(&mut self, t: f64) {
        let s = 1.0 - t;
        if let ([a, b, c, d], [e, f, g]) = (&mut self.values[..], &mut self.slopes[..]) {
            (*e, *f, *g) = (s * s, 2.0 * s * t, t * t);
            (*a, *b, *c, *d) = (s * *e, 3.0 * t * *e, 3.0 * s * *g, t * *g);
            return;
        }
        // Row by row, as in Pascal's triangle.
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

/// Σ wᵢ Pᵢ.
#[inline(always)]
fn blend(points: &[Vector3], weights: &[f64]) -> Vector3 {
    let (mut xy, mut z) = (f64x2::splat(0.0), 0.0);
    for (&[px, py, pz], &weight) in points.iter().zip(weights) {
        xy += f64x2::new([px, py]) * f64x2::splat(weight);
        z += pz * weight;
    }
    let [x, y] = xy.to_array();
    [x, y, z]
}

/// Σ wⱼ Pᵢⱼ for each column i.
fn blend_rows(net: &[Vector3], columns: usize, weights: &[f64], out: &mut [Vector3]) {
    out.fill([0.0; 3]);
    for (row, &weight) in net.chunks_exact(columns).zip(weights) {
        let numbers = out.as_flattened_mut().iter_mut();
        for (sum, x) in numbers.zip(row.as_flattened()) {
            *sum += x * weight;
        }
    }
}
