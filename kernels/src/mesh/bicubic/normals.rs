//! Unit normals of a bicubic patch on a grid.
//!
//! N = ∂u × ∂v is itself a Bézier patch, of degrees 5 and 5. Its control vectors, the normal net, are computed in f64.
//! They are as accurate near a collapsed edge as elsewhere; evaluating the derivatives themselves would need
//! subtractions.

use super::grid::{BicubicGrid, Lanes};
use super::lanes::{LANES, round, store, with_room};
use crate::bernstein::weights::quintic;
use crate::numeric::lanes::{f32x4, f64x2, if_greater};
use crate::numeric::order::larger;

/// The value of |N| below which a point is not regular, for differences of size 1. The rounding noise of the
/// differences is some 2⁻⁵²; a normal accurate to 0.001° (1.7e-5 rad) needs a product that is 10⁵ times as long.
const REGULAR: f64 = 1e-10;

/// [`REGULAR`] for f32.
const MIN_SIZE: f32 = 1e-10;

/// If |N| is below this part of the possible sum of its terms, f32 is not sufficient: the terms and their sums are off
/// by up to 10·2⁻²⁴ of that sum, which leaves 1e-5 rad.
const MOSTLY_CANCELLED: f32 = 1.0 / 16.0;

/// The control vectors of N in f64: N_kl in the first half of `net[l][k]`, N_(5−k)l in the second.
type Net = [[[f64x2; 3]; 3]; 6];
/// One row Nₖ of the net as f32, or the curve of N at one v: Nₖ + N₅₋ₖ for k = 0, 1, 2, then Nₖ − N₅₋ₖ, in the order
/// that `Lanes` expects; then the length of its longest vector, or an upper bound of it.
type NormalRow = [f32x4; 5];

/// The index of this length in a [`NormalRow`].
const LONGEST: usize = 18;

/// The normal net, prepared for evaluation.
struct BicubicNormalNet {
    net: Net,
    rows: [NormalRow; 6],
    /// The first and the last row and column that are not zero.
    used_rows: [usize; 2],
    used_columns: [usize; 2],
}

/// Fills all normals, line by line. Returns true if some are missing.
#[inline(never)]
pub(crate) fn fill(grid: &BicubicGrid, net: &[[f64; 3]; 16], out: &mut [[f32; 3]]) -> bool {
    let columns = grid.segments_u + 1;
    let Some(net_of_normals) = BicubicNormalNet::new(net) else {
        out.fill([0.0; 3]);
        return true;
    };
    let mut missing = false;
    for (iv, (line, weights)) in out
        .chunks_exact_mut(columns)
        .zip(&grid.normal_weights_v)
        .enumerate()
    {
        let complete = fill_line(
            &grid.lanes,
            net_of_normals.curve(weights),
            net_of_normals.used_columns,
            line,
        );
        if !complete {
            missing |= net_of_normals.repair(grid, iv, line);
        }
    }
    missing
}

/// Fills one line; normals that are not accurate enough are set to zero. Returns true if all normals are accurate enough.
#[inline(always)]
fn fill_line(lanes: &[Lanes], curve: NormalRow, used: [usize; 2], line: &mut [[f32; 3]]) -> bool {
    let mut numbers = [0.0; 20];
    for (four, lanes) in numbers.as_chunks_mut::<4>().0.iter_mut().zip(curve) {
        *four = lanes.to_array();
    }
    let enough = MOSTLY_CANCELLED * numbers[LONGEST];
    let min = if enough > MIN_SIZE { enough } else { MIN_SIZE };
    let min_square = min * min;
    let mut complete = with_room(line, |line| fill_lanes(lanes, &numbers, min_square, line));
    let end = |column: usize| -> [f32; 3] {
        let (source_column, sign) = if column < 3 {
            (column, 1.0)
        } else {
            (5 - column, -1.0)
        };
        std::array::from_fn(|axis| {
            numbers[3 * source_column + axis] + sign * numbers[9 + 3 * source_column + axis]
        })
    };
    if let [first, .., last] = line {
        for (normal, column) in [(first, used[0]), (last, used[1])] {
            // The sums are twice the vectors.
            *normal = unit(end(column), 4.0 * min_square);
            complete &= *normal != [0.0; 3];
        }
    }
    complete
}

/// Fills the line except its ends.
#[inline(never)]
fn fill_lanes(lanes: &[Lanes], numbers: &[f32; 20], min: f32, line: &mut [[f32; 3]]) -> bool {
    let c: [f32x4; LONGEST] = std::array::from_fn(|i| f32x4::splat(numbers[i]));
    let mut smallest = f32x4::splat(f32::INFINITY);
    let limit = f32x4::splat(min);
    for (k, lanes) in lanes.iter().enumerate() {
        let [w, skew] = lanes.normals;
        let even = |axis: usize| w[0] * c[axis] + w[1] * c[3 + axis] + w[2] * c[6 + axis];
        let odd =
            |axis: usize| skew[0] * c[9 + axis] + skew[1] * c[12 + axis] + skew[2] * c[15 + axis];
        let (even, odd) = ([0, 1, 2].map(even), [0, 1, 2].map(odd));
        let near = units([0, 1, 2].map(|axis| even[axis] + odd[axis]), limit);
        let far = units([0, 1, 2].map(|axis| even[axis] - odd[axis]), limit);
        smallest = smallest.fast_min(near.1).fast_min(far.1);
        store(near.0, far.0, 1 + k * LANES, line);
    }
    smallest.to_array().into_iter().all(|square| square > min)
}

/// Four unit vectors, zero where the squared length is not greater than `min`, and the squared lengths.
#[inline(always)]
fn units([x, y, z]: [f32x4; 3], min: f32x4) -> ([f32x4; 3], f32x4) {
    let square = x * x + y * y + z * z;
    let factor = if_greater(square, min, f32x4::splat(1.0) / square.sqrt(), f32x4::ZERO);
    ([x * factor, y * factor, z * factor], square)
}

/// The unit vector, or zero if its squared length is not greater than `min`.
#[inline(always)]
fn unit([x, y, z]: [f32; 3], min: f32) -> [f32; 3] {
    let square = x * x + y * y + z * z;
    let factor = if square > min {
        1.0 / square.sqrt()
    } else {
        0.0
    };
    [x * factor, y * factor, z * factor]
}

impl BicubicNormalNet {
    /// `None` if N is too short everywhere.
    fn new(points: &[[f64; 3]; 16]) -> Option<Self> {
        let net = normal_net(points);
        let mut rows = [[f32x4::ZERO; 5]; 6];
        let mut greatest = [0.0; 6];
        let mut columns = [f64x2::ZERO; 3];
        for (l, row) in net.iter().enumerate() {
            let mut numbers = [0.0; 20];
            let mut max = f64x2::ZERO;
            for (k, &[x, y, z]) in row.iter().enumerate() {
                for (axis, pair) in [x, y, z].into_iter().enumerate() {
                    let [a, b] = pair.to_array();
                    numbers[3 * k + axis] = round(a + b);
                    numbers[9 + 3 * k + axis] = round(a - b);
                }
                let square = x * x + y * y + z * z;
                max = max.fast_max(square);
                columns[k] += square;
            }
            let [a, b] = max.to_array();
            greatest[l] = larger(a, b);
            numbers[LONGEST] = round(greatest[l].sqrt());
            for (lanes, four) in rows[l].iter_mut().zip(numbers.as_chunks().0) {
                *lanes = f32x4::new(*four);
            }
        }
        let max = greatest
            .iter()
            .fold(0.0, |max, &square| larger(max, square));
        let [[a, f], [b, e], [c, d]] = columns.map(f64x2::to_array);
        (max > REGULAR * REGULAR).then(|| Self {
            net,
            rows,
            used_rows: used(greatest),
            used_columns: used([a, b, c, d, e, f]),
        })
    }

    /// The curve of N at one v.
    #[inline(always)]
    fn curve(&self, weights: &[f32; 6]) -> NormalRow {
        let w = weights.map(f32x4::splat);
        let rows = &self.rows;
        std::array::from_fn(|i| {
            let term = |l: usize| w[l] * rows[l][i];
            (term(0) + term(5)) + (term(1) + term(4)) + (term(2) + term(3))
        })
    }

    /// Computes the normals of a line that are zero: on a collapsed edge from the nearest row of the net that is not
    /// zero, elsewhere in f64. Returns true if some stay zero.
    #[cold]
    #[inline(never)]
    fn repair(&self, grid: &BicubicGrid, iv: usize, line: &mut [[f32; 3]]) -> bool {
        let [first, last] = self.used_rows;
        if (iv == 0 && first != 0) || (iv == grid.segments_v && last != 5) {
            let curve = self.rows[if iv == 0 { first } else { last }];
            return !fill_line(&grid.lanes, curve, [0, 5], line);
        }
        let v = quintic(iv, grid.segments_v);
        let [first, last] = self.used_columns;
        let only = |column: usize| std::array::from_fn(|k| if k == column { 1.0 } else { 0.0 });
        let mut missing = false;
        for (iu, normal) in line.iter_mut().enumerate() {
            if *normal == [0.0; 3] {
                let u = if iu == 0 {
                    only(first)
                } else if iu == grid.segments_u {
                    only(last)
                } else {
                    quintic(iu, grid.segments_u)
                };
                *normal = self.normal_in_f64(u, v);
                missing |= *normal == [0.0; 3];
            }
        }
        missing
    }

    /// The direction of N in f64; zero where N vanishes.
    fn normal_in_f64(&self, u: [f64; 6], v: [f64; 6]) -> [f32; 3] {
        let mut sums = [f64x2::ZERO; 3];
        for (row, v) in self.net.iter().zip(v) {
            for (k, vector) in row.iter().enumerate() {
                let weight = f64x2::new([v * u[k], v * u[5 - k]]);
                for (sum, &number) in sums.iter_mut().zip(vector) {
                    *sum += weight * number;
                }
            }
        }
        let sum = sums.map(f64x2::to_array).map(|[a, b]| a + b);
        let length = sum.iter().map(|n| n * n).sum::<f64>().sqrt();
        if length > REGULAR {
            sum.map(|n| round(n / length))
        } else {
            [0.0; 3]
        }
    }
}

/// The indices of the first and the last number that is not zero.
fn used(squares: [f64; 6]) -> [usize; 2] {
    let first = squares.iter().position(|&square| square != 0.0);
    let last = squares.iter().rposition(|&square| square != 0.0);
    [first.unwrap_or(0), last.unwrap_or(5)]
}

/// N_kl = Σ C(2,i) C(3,j) C(3,i′) C(2,j′) / (C(5,k) C(5,l)) Δu_ij × Δv_i′j′ over i + i′ = k, j + j′ = l, for
/// differences of size 1.
///
/// The second half of each pair is computed with u reversed, which gives N_(5−k)l.
fn normal_net(points: &[[f64; 3]; 16]) -> Net {
    let (du, dv) = differences(points);
    // The reciprocals of the binomial coefficients C(5, k).
    const RECIPROCAL_BINOMIALS: [f64; 6] = [1.0, 1.0 / 5.0, 1.0 / 10.0, 1.0 / 10.0, 1.0 / 5.0, 1.0];
    let mut net: Net = [[[f64x2::ZERO; 3]; 3]; 6];
    for (j, u) in du.iter().enumerate() {
        for (row, v) in net[j..].iter_mut().zip(&dv) {
            let [c0, c1, c2] = row;
            add_cross(c0, u[0], v[0]);
            add_cross(c1, u[0], v[1]);
            add_cross(c1, u[1], v[0]);
            add_cross(c2, u[0], v[2]);
            add_cross(c2, u[1], v[1]);
            add_cross(c2, u[2], v[0]);
        }
    }
    for (row, share) in net.iter_mut().zip(RECIPROCAL_BINOMIALS) {
        for (vector, other) in row.iter_mut().zip(RECIPROCAL_BINOMIALS) {
            *vector = vector.map(|axis| axis * f64x2::splat(share * other));
        }
    }
    net
}

#[inline(always)]
fn add_cross(sum: &mut [f64x2; 3], [ux, uy, uz]: [f64x2; 3], [vx, vy, vz]: [f64x2; 3]) {
    sum[0] += uy * vz - uz * vy;
    sum[1] += uz * vx - ux * vz;
    sum[2] += ux * vy - uy * vx;
}

/// The differences along u and along v, each scaled to size 1 and multiplied by its binomial coefficients; the second
/// half of each pair is computed with u reversed.
#[allow(clippy::type_complexity, reason = "two small nets")]
fn differences(points: &[[f64; 3]; 16]) -> ([[[f64x2; 3]; 3]; 4], [[[f64x2; 3]; 3]; 3]) {
    let pairs: [[[f64x2; 3]; 4]; 4] = std::array::from_fn(|j| {
        std::array::from_fn(|i| {
            let (a, b) = (points[4 * j + i], points[4 * j + 3 - i]);
            std::array::from_fn(|axis| f64x2::new([a[axis], b[axis]]))
        })
    });
    let mut du: [[[f64x2; 3]; 3]; 4] = std::array::from_fn(|j| {
        std::array::from_fn(|i| {
            std::array::from_fn(|axis| pairs[j][i + 1][axis] - pairs[j][i][axis])
        })
    });
    let mut dv: [[[f64x2; 3]; 3]; 3] = std::array::from_fn(|j| {
        std::array::from_fn(|i| {
            std::array::from_fn(|axis| pairs[j + 1][i][axis] - pairs[j][i][axis])
        })
    });
    let (size_u, size_v) = (reciprocal_size(&du), reciprocal_size(&dv));
    // The binomial coefficients C(2, i) and C(3, i).
    const BINOMIALS_2: [f64; 3] = [1.0, 2.0, 1.0];
    const BINOMIALS_3: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
    for j in 0..4 {
        for i in 0..3 {
            // With u reversed, differences along u change their signs.
            let scale = size_u * (BINOMIALS_3[j] * BINOMIALS_2[i]);
            du[j][i] = du[j][i].map(|axis| axis * f64x2::new([scale, -scale]));
        }
    }
    for j in 0..3 {
        for i in 0..3 {
            let scale = f64x2::splat(size_v * (BINOMIALS_2[j] * BINOMIALS_3[i]));
            dv[j][i] = dv[j][i].map(|axis| axis * scale);
        }
    }
    (du, dv)
}

/// The reciprocal of the largest coordinate; 0 if it would not be finite, because a shape of that size is a point.
fn reciprocal_size<const N: usize>(differences: &[[[f64x2; 3]; 3]; N]) -> f64 {
    let pairs = differences.as_flattened().as_flattened().iter();
    let [a, b] = pairs
        .fold(f64x2::ZERO, |max, pair| max.fast_max(pair.abs()))
        .to_array();
    let size = larger(a, b);
    if size < f64::MIN_POSITIVE * 8.0 {
        0.0
    } else {
        1.0 / size
    }
}
