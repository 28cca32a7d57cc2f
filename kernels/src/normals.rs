//! Unit normals of a bicubic patch on a grid.
//!
//! N = ∂u × ∂v is itself a Bézier patch, of degrees 5 and 5. Its control vectors, the normal net, are computed in f64.
//! They are as exact near a collapsed side as anywhere else, where the derivatives would have to be subtracted.

use crate::bicubic::{BicubicGrid, LANES, round, store};
use crate::weights::quintic;
use wide::{f32x4, f64x2};

/// |N| below which a point is not regular, for differences of the size 1. Their rounding noise is some 2⁻⁵²; a normal
/// within 0.001° (1.7e-5 rad) needs a product that is 10⁵ times as long.
const REGULAR: f64 = 1e-10;

/// Where |N| is below this part of what its terms may add up to, f32 is not enough: the terms and their sums are off by
/// up to 10·2⁻²⁴ of that, which leaves 1e-5 rad.
const MOSTLY_CANCELLED: f32 = 1.0 / 16.0;

/// The control vectors of N, in f64.
type Net = [[[f64; 3]; 6]; 6];
/// One row of it in f32: 18 numbers and two that are not used.
type Row = [f32x4; 5];

/// The normal net, prepared for evaluation.
struct Facing {
    net: Net,
    rows: [Row; 6],
    /// The length of the longest vector in each row.
    longest: [f32; 6],
    /// The first and the last row and column that are not zero.
    used_rows: [usize; 2],
    used_columns: [usize; 2],
}

/// The curve of N at one v.
struct Line {
    coefficients: Row,
    /// The square of the length below which N is not known well enough.
    least_square: f32,
    /// On a side that has collapsed: this row stands for the one that is zero.
    stand_in: bool,
}

/// All normals, line by line. True if some are missing.
pub(crate) fn fill(grid: &BicubicGrid, net: &[[f64; 3]; 16], out: &mut [[f32; 3]]) -> bool {
    let columns = grid.segments_u + 1;
    let Some(facing) = Facing::new(net) else {
        out.fill([0.0; 3]);
        return true;
    };
    let mut missing = false;
    for (iv, line) in out.chunks_exact_mut(columns).enumerate() {
        let curve = facing.line(iv, grid);
        if !fill_line(grid, facing.used_columns, &curve, line) {
            missing |= curve.stand_in || facing.repair(grid, iv, line);
        }
    }
    missing
}

/// One line; normals that are not known well enough become zero. True if there are none.
#[inline(always)]
fn fill_line(grid: &BicubicGrid, used: [usize; 2], curve: &Line, line: &mut [[f32; 3]]) -> bool {
    let numbers: [f32; 20] = bytemuck::cast(curve.coefficients);
    let least = f32x4::splat(curve.least_square);
    let c: [f32x4; 18] = std::array::from_fn(|i| f32x4::splat(numbers[i]));
    let mut regular = f32x4::splat(1.0).simd_gt(f32x4::ZERO);
    for (out, lanes) in line.chunks_mut(LANES).zip(&grid.lanes) {
        let w = lanes.facings;
        let sum = |axis: usize| {
            let outer = w[0] * c[axis] + w[5] * c[15 + axis];
            let middle = w[1] * c[3 + axis] + w[4] * c[12 + axis];
            outer + middle + (w[2] * c[6 + axis] + w[3] * c[9 + axis])
        };
        let [x, y, z] = [sum(0), sum(1), sum(2)];
        let square = x * x + y * y + z * z;
        let known = square.simd_gt(least);
        regular &= known;
        let factor = known & (f32x4::splat(1.0) / square.sqrt());
        store([x * factor, y * factor, z * factor], out);
    }
    let end = |column: usize| {
        // On two collapsed sides at once this corner is left to those who know more.
        let unclear = curve.stand_in && column % 5 != 0;
        let vector = [0, 1, 2].map(|axis| numbers[3 * column + axis]);
        unit(vector, curve.least_square).filter(|_| !unclear)
    };
    let mut complete = regular.all();
    if let ([first, .., last], [from, to]) = (line, used) {
        let ends = [(from != 0).then(|| end(from)), Some(end(to))];
        for (normal, found) in [first, last].into_iter().zip(ends) {
            if let Some(found) = found {
                complete &= found.is_some();
                *normal = found.unwrap_or_default();
            }
        }
    }
    complete
}

impl Facing {
    /// None if N is nowhere long enough.
    fn new(points: &[[f64; 3]; 16]) -> Option<Self> {
        let net = normal_net(points);
        let mut rows = [Row::default(); 6];
        let mut longest = [0.0; 6];
        let mut used = [[false; 6]; 2];
        for (l, row) in net.iter().enumerate() {
            let mut numbers = [0.0; 20];
            let mut greatest: f64 = 0.0;
            for (k, vector) in row.iter().enumerate() {
                let square = vector.iter().map(|n| n * n).sum::<f64>();
                numbers[3 * k..3 * k + 3].copy_from_slice(&vector.map(round));
                greatest = greatest.max(square);
                used[0][l] |= *vector != [0.0; 3];
                used[1][k] |= *vector != [0.0; 3];
            }
            rows[l] = bytemuck::cast(numbers);
            longest[l] = round(greatest.sqrt());
        }
        let most = longest.iter().fold(0.0, |most: f32, &n| most.max(n));
        let ends = |used: [bool; 6]| {
            let first = used.iter().position(|&used| used).unwrap_or(0);
            [first, used.iter().rposition(|&used| used).unwrap_or(5)]
        };
        (f64::from(most) > REGULAR).then(|| Self {
            net,
            rows,
            longest,
            used_rows: ends(used[0]),
            used_columns: ends(used[1]),
        })
    }

    /// The curve at line `iv`.
    #[inline(always)]
    fn line(&self, iv: usize, grid: &BicubicGrid) -> Line {
        let [from, to] = self.used_rows;
        let stand_in = if iv == 0 && from != 0 {
            Some(from)
        } else if iv == grid.segments_v && to != 5 {
            Some(to)
        } else {
            None
        };
        let mut w = [0.0; 6];
        match stand_in {
            Some(row) => w[row] = 1.0,
            None => w = grid.facings_v[iv],
        }
        let coefficients = std::array::from_fn(|i| {
            let term = |l: usize| f32x4::splat(w[l]) * self.rows[l][i];
            (term(0) + term(5)) + (term(1) + term(4)) + (term(2) + term(3))
        });
        let longest: f32 = w.iter().zip(&self.longest).map(|(w, n)| w * n).sum();
        let least = (MOSTLY_CANCELLED * longest).max(round(REGULAR));
        Line {
            coefficients,
            least_square: least * least,
            stand_in: stand_in.is_some(),
        }
    }

    /// Computes the normals of a line that are zero in f64. True if some stay zero.
    #[cold]
    #[inline(never)]
    fn repair(&self, grid: &BicubicGrid, iv: usize, line: &mut [[f32; 3]]) -> bool {
        let v = quintic(iv, grid.segments_v);
        let [from, to] = self.used_columns;
        let mut missing = false;
        for (iu, normal) in line.iter_mut().enumerate() {
            if *normal != [0.0; 3] {
                continue;
            }
            let mut u = quintic(iu, grid.segments_u);
            if iu == 0 {
                u = [0, 1, 2, 3, 4, 5].map(|k| if k == from { 1.0 } else { 0.0 });
            } else if iu == grid.segments_u {
                u = [0, 1, 2, 3, 4, 5].map(|k| if k == to { 1.0 } else { 0.0 });
            }
            let mut sum = [0.0; 3];
            for (row, v) in self.net.iter().zip(v) {
                for (vector, u) in row.iter().zip(u) {
                    for axis in 0..3 {
                        sum[axis] += v * u * vector[axis];
                    }
                }
            }
            let length = sum.iter().map(|n| n * n).sum::<f64>().sqrt();
            if length > REGULAR {
                *normal = sum.map(|n| round(n / length));
            } else {
                missing = true;
            }
        }
        missing
    }
}

/// The unit vector, if its square is greater than `least`.
fn unit(vector: [f32; 3], least: f32) -> Option<[f32; 3]> {
    let square: f32 = vector.iter().map(|n| n * n).sum();
    let factor = 1.0 / square.sqrt();
    (square > least).then(|| vector.map(|n| n * factor))
}

/// N_kl = Σ C(2,i) C(3,j) C(3,i′) C(2,j′) / (C(5,k) C(5,l)) Δu_ij × Δv_i′j′ over i + i′ = k, j + j′ = l, for differences
/// of the size 1.
fn normal_net(points: &[[f64; 3]; 16]) -> Net {
    let (du, dv) = differences(points);
    let mut net = [[[0.0; 3]; 6]; 6];
    for (j, row) in du.iter().enumerate() {
        for (i, &[ux, uy, uz]) in row.iter().enumerate() {
            let [ux, uy, uz] = [ux, uy, uz].map(f64x2::splat);
            for (jj, pairs) in dv.iter().enumerate() {
                for (half, &[vx, vy, vz]) in pairs.iter().enumerate() {
                    let cross = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
                    let cross = cross.map(f64x2::to_array);
                    for axis in 0..3 {
                        net[j + jj][i + 2 * half][axis] += cross[axis][0];
                        net[j + jj][i + 2 * half + 1][axis] += cross[axis][1];
                    }
                }
            }
        }
    }
    const SHARE: [f64; 6] = [1.0, 1.0 / 5.0, 1.0 / 10.0, 1.0 / 10.0, 1.0 / 5.0, 1.0];
    for (row, share_v) in net.iter_mut().zip(SHARE) {
        for (vector, share_u) in row.iter_mut().zip(SHARE) {
            *vector = vector.map(|n| n * share_u * share_v);
        }
    }
    net
}

/// Differences along u, and along v with two neighbours in each vector, each brought to the size 1 and times its
/// binomials.
#[allow(clippy::type_complexity, reason = "two small nets")]
fn differences(points: &[[f64; 3]; 16]) -> ([[[f64; 3]; 3]; 4], [[[f64x2; 3]; 2]; 3]) {
    let between = |a: usize, b: usize| -> [f64; 3] {
        std::array::from_fn(|axis| points[b][axis] - points[a][axis])
    };
    let mut du: [[[f64; 3]; 3]; 4] =
        std::array::from_fn(|j| std::array::from_fn(|i| between(4 * j + i, 4 * j + i + 1)));
    let mut dv: [[[f64; 3]; 4]; 3] =
        std::array::from_fn(|j| std::array::from_fn(|i| between(4 * j + i, 4 * j + i + 4)));
    let (size_u, size_v) = (reciprocal_size(&du), reciprocal_size(&dv));
    const OF_TWO: [f64; 3] = [1.0, 2.0, 1.0];
    const OF_THREE: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
    for (row, share) in du.iter_mut().zip(OF_THREE) {
        for (vector, other) in row.iter_mut().zip(OF_TWO) {
            *vector = vector.map(|n| n * size_u * (share * other));
        }
    }
    for (row, share) in dv.iter_mut().zip(OF_TWO) {
        for (vector, other) in row.iter_mut().zip(OF_THREE) {
            *vector = vector.map(|n| n * size_v * (share * other));
        }
    }
    let pairs = dv.map(|[a, b, c, d]| {
        let pair =
            |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|axis| f64x2::new([a[axis], b[axis]]));
        [pair(a, b), pair(c, d)]
    });
    (du, pairs)
}

/// The reciprocal of the largest coordinate; 0 where it would not be finite: a shape of that size is a point.
fn reciprocal_size<const N: usize, const M: usize>(differences: &[[[f64; 3]; N]; M]) -> f64 {
    let numbers = differences.as_flattened().as_flattened().iter();
    let size = numbers.fold(0.0, |size: f64, n| size.max(n.abs()));
    if size < f64::MIN_POSITIVE * 8.0 {
        0.0
    } else {
        1.0 / size
    }
}
