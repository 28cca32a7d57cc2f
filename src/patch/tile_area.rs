//! The area of a tile of a Bézier patch.

use crate::numeric::float::as_f64;
use casteljau_kernels::numeric::gauss::GAUSS_8;

/// The nodes of the rule with 8 points.
const NODES: usize = 8;

/// One value for each node along u.
type Lanes = [f64; NODES];

/// Integrates |∂u × ∂v| over tiles by Gauss–Legendre quadrature with 8 × 8 points.
///
/// Consecutive tiles with the same range of u, or of v, share a part of the work.
pub(crate) struct TileArea {
    points: Vec<[f64; 3]>,
    columns: usize,
    of_u: QuadratureWeights,
    of_v: QuadratureWeights,
    /// ∂S/∂u divided by m at the nodes along u: a curve in v for each node, three coordinates for each control point.
    slopes: Vec<[Lanes; 3]>,
    /// The differences of the control points of the curves in v at the nodes along u.
    differences: Vec<[Lanes; 3]>,
}

/// Bernstein weights at the nodes in a range.
struct QuadratureWeights {
    range: [f64; 2],
    /// The weights of the degree; `lower` holds the weights of the degree below.
    weights: Vec<Lanes>,
    lower: Vec<Lanes>,
}

impl TileArea {
    /// For a patch whose rows (in u) have `columns` control points.
    pub(crate) fn new(points: Vec<[f64; 3]>, columns: usize) -> Self {
        let rows = points.len() / columns;
        Self {
            columns,
            of_u: QuadratureWeights::new(columns),
            of_v: QuadratureWeights::new(rows),
            slopes: vec![[[0.0; NODES]; 3]; rows],
            differences: vec![[[0.0; NODES]; 3]; rows],
            points,
        }
    }

    /// The number of steps for the area of one tile, about one for each two multiplications; `is_new` tells whether the
    /// range of u differs from the previous tile's.
    pub(crate) fn steps(&self, is_new: bool) -> usize {
        let (columns, rows) = (self.columns, self.points.len() / self.columns);
        let of_rows = columns * columns * 4 + self.points.len() * 12;
        96 * (rows + 1) + rows * rows * 2 + if is_new { of_rows } else { 0 }
    }

    /// The area of the tile.
    pub(crate) fn area(&mut self, u: [f64; 2], v: [f64; 2]) -> f64 {
        if u != self.of_u.range {
            self.of_u.move_to(u);
            self.blend_rows();
        }
        if v != self.of_v.range {
            self.of_v.move_to(v);
        }
        let rows = self.slopes.len();
        let factor = as_f64((self.columns - 1) * (rows - 1));
        let mut sum = [0.0; NODES];
        for k in 0..NODES {
            let du = blend(&self.slopes, &self.of_v.weights, k);
            let dv = blend(&self.differences, &self.of_v.lower, k);
            let lengths = cross_lengths(&du, &dv);
            (0..NODES).for_each(|i| sum[i] += lengths[i] * GAUSS_8.weights[k / 2]);
        }
        let sum: f64 = (0..NODES).map(|i| sum[i] * GAUSS_8.weights[i / 2]).sum();
        let half = [u, v].map(|[from, to]| 0.5 * (to - from));
        sum * factor * half[0] * half[1]
    }

    /// Blends each row at the nodes along u.
    fn blend_rows(&mut self) {
        let mut before = [[0.0; NODES]; 3];
        for (j, row) in self.points.chunks_exact(self.columns).enumerate() {
            let (mut point, mut slope) = ([[0.0; NODES]; 3], [[0.0; NODES]; 3]);
            for (p, w) in row.iter().zip(&self.of_u.weights) {
                (0..3).for_each(|axis| add(&mut point[axis], p[axis], w));
            }
            for (pair, w) in row.windows(2).zip(&self.of_u.lower) {
                (0..3).for_each(|axis| add(&mut slope[axis], pair[1][axis] - pair[0][axis], w));
            }
            self.slopes[j] = slope;
            if j > 0 {
                let lane = |axis: usize, i: usize| point[axis][i] - before[axis][i];
                self.differences[j - 1] =
                    [0, 1, 2].map(|axis| std::array::from_fn(|i| lane(axis, i)));
            }
            before = point;
        }
    }
}

impl QuadratureWeights {
    fn new(count: usize) -> Self {
        Self {
            range: [f64::NAN; 2],
            weights: vec![[0.0; NODES]; count],
            lower: vec![[0.0; NODES]; count - 1],
        }
    }

    fn move_to(&mut self, range: [f64; 2]) {
        self.range = range;
        let t = nodes(range);
        let count = self.weights.len();
        self.weights[0] = [1.0; NODES];
        for row in 1..count {
            if row == count - 1 {
                self.lower.copy_from_slice(&self.weights[..row]);
            }
            let mut carry = [0.0; NODES];
            for weight in &mut self.weights[..row] {
                for i in 0..NODES {
                    let product = weight[i];
                    weight[i] = carry[i] + (1.0 - t[i]) * product;
                    carry[i] = t[i] * product;
                }
            }
            self.weights[row] = carry;
        }
    }
}

/// The nodes of the rule in an interval.
fn nodes([from, to]: [f64; 2]) -> Lanes {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    std::array::from_fn(|k| {
        let off = half * GAUSS_8.nodes[k / 2];
        if k % 2 == 0 {
            middle + off
        } else {
            middle - off
        }
    })
}

fn add(sum: &mut Lanes, factor: f64, values: &Lanes) {
    for (sum, value) in sum.iter_mut().zip(values) {
        *sum += factor * value;
    }
}

fn blend(points: &[[Lanes; 3]], weights: &[Lanes], node: usize) -> [Lanes; 3] {
    let mut sum = [[0.0; NODES]; 3];
    for (point, w) in points.iter().zip(weights) {
        (0..3).for_each(|axis| add(&mut sum[axis], w[node], &point[axis]));
    }
    sum
}

fn cross_lengths([ax, ay, az]: &[Lanes; 3], [bx, by, bz]: &[Lanes; 3]) -> Lanes {
    std::array::from_fn(|i| {
        let x = ay[i] * bz[i] - az[i] * by[i];
        let y = az[i] * bx[i] - ax[i] * bz[i];
        let z = ax[i] * by[i] - ay[i] * bx[i];
        (x * x + y * y + z * z).sqrt()
    })
}
