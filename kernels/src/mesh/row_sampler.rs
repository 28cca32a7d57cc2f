//! Evaluation of a patch at many parameters: points and normal vectors, row by row.

use crate::numeric::lanes::f64x2;
use crate::numeric::order::larger;
use glam::DVec3;

/// A point or a vector.
pub type Vector3 = [f64; 3];

/// The Bernstein weights of a degree and of the next lower degree at one parameter.
#[derive(Clone, Debug, Default)]
struct Weights {
    values: Vec<f64>,
    slopes: Vec<f64>,
}

/// A vector in homogeneous coordinates.
pub type Vector4 = [f64; 4];

/// A patch of vectors of D numbers for repeated evaluation; consecutive calls with the same v are cheaper.
#[derive(Clone, Debug)]
pub struct RowSampler<const D: usize> {
    columns: usize,
    /// The control points, and the differences along u (rows shorter by one) and along v (one row fewer).
    nets: [Vec<[f64; D]>; 3],
    v: f64,
    /// The rows of the nets, blended at v.
    row: [Vec<[f64; D]>; 3],
    across: Weights,
    along: Weights,
}

impl<const D: usize> RowSampler<D> {
    /// Expects a net with `columns` points in each row, and its differences along u and v.
    pub fn new(columns: usize, nets: [Vec<[f64; D]>; 3]) -> Self {
        Self {
            columns,
            v: f64::NAN,
            row: [columns, columns - 1, columns].map(|length| vec![[0.0; D]; length]),
            across: Weights::new(nets[0].len() / columns),
            along: Weights::new(columns),
            nets,
        }
    }

    /// Blends the rows at v.
    #[inline(always)]
    fn blend_at(&mut self, v: f64) {
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
    }
}

impl RowSampler<3> {
    /// The point and ∂u × ∂v, up to a factor, at (u, v).
    #[inline(never)]
    pub fn sample(&mut self, u: f64, v: f64) -> (Vector3, Vector3) {
        self.blend_at(v);
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

impl RowSampler<4> {
    /// The homogeneous point at (u, v), and the sums of the differences along u and along v.
    #[inline(never)]
    pub fn sample(&mut self, u: f64, v: f64) -> [Vector4; 3] {
        self.blend_at(v);
        self.along.set(u);
        let Weights { values, slopes } = &self.along;
        let [points, along_u, along_v] = &self.row;
        [
            blend_homogeneous(points, values),
            blend_homogeneous(along_u, slopes),
            blend_homogeneous(along_v, values),
        ]
    }

    /// The point at (u, v), and the [`directions`] there.
    #[inline(never)]
    pub fn point_and_directions(&mut self, u: f64, v: f64) -> (DVec3, [DVec3; 2]) {
        let [[x, y, z, weight], along_u, along_v] = self.sample(u, v);
        let point = DVec3::new(x, y, z) / weight;
        (point, directions(point, weight, [along_u, along_v], [u, v]))
    }
}

/// Directions of ∂u and ∂v at a point of a rational patch, from the sums of the homogeneous differences along u and v.
///
/// ∂u is m/w times Au − S wu, where Au and wu are sums of differences. With w₀ and w₁, the sums of the weights at the starts
/// and at the ends of these differences, it is divided by w₀ + w₁ instead of w, on which its rounding errors depend.
#[inline(always)]
pub fn directions(point: DVec3, weight: f64, sums: [Vector4; 2], at: [f64; 2]) -> [DVec3; 2] {
    let direction = |[x, y, z, change]: Vector4, t: f64| {
        (DVec3::new(x, y, z) - point * change) / (2.0 * weight + (1.0 - 2.0 * t) * change)
    };
    let [along_u, along_v] = sums;
    [direction(along_u, at[0]), direction(along_v, at[1])]
}

/// The unit vector of a × b; `None` if that is not longer than `min_length`.
#[inline(never)]
pub fn unit_normal([a, b]: [DVec3; 2], min_length: f64) -> Option<DVec3> {
    let cross_product = a.cross(b);
    if cross_product.length_squared() > min_length * min_length {
        let DVec3 { x, y, z } = cross_product.abs();
        let direction = cross_product / larger(larger(x, y), z);
        Some(direction / direction.dot(direction).sqrt())
    } else {
        None
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

/// Σ wᵢ Pᵢ of homogeneous vectors.
#[inline(always)]
fn blend_homogeneous(points: &[Vector4], weights: &[f64]) -> Vector4 {
    let (mut xy, mut zw) = (f64x2::splat(0.0), f64x2::splat(0.0));
    for (&[px, py, pz, pw], &weight) in points.iter().zip(weights) {
        let weight = f64x2::splat(weight);
        xy += f64x2::new([px, py]) * weight;
        zw += f64x2::new([pz, pw]) * weight;
    }
    let ([x, y], [z, w]) = (xy.to_array(), zw.to_array());
    [x, y, z, w]
}

/// Σ wⱼ Pᵢⱼ for each column i.
fn blend_rows<const D: usize>(
    net: &[[f64; D]],
    columns: usize,
    weights: &[f64],
    out: &mut [[f64; D]],
) {
    out.fill([0.0; D]);
    for (row, &weight) in net.chunks_exact(columns).zip(weights) {
        let numbers = out.as_flattened_mut().iter_mut();
        for (sum, x) in numbers.zip(row.as_flattened()) {
            *sum += x * weight;
        }
    }
}
