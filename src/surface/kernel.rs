//! The inner loop: positions and normals of one patch on a grid.
//!
//! For each v the rows of the net are blended into one curve in u, then that curve is evaluated along u, a few
//! samples at a time. The arithmetic is f64; only results are rounded to f32. Weights are built and summed so that t
//! and 1 − t exchange their roles exactly: two patches that share a side, in the same direction or reversed, get
//! bit-identical samples there.

use super::Grid;
use super::normal::{NormalNet, binomial};
use super::patch::{REGULAR_RATIO, directions};
use super::tessellate::to_f32;
use crate::curve::ratio;
use glam::DVec3;

/// Samples that are computed side by side.
const LANES: usize = 4;
type Lanes = [f64; LANES];
/// x, y, z of one sample after the other, as buffers hold them.
type Triples = [f32; 3 * LANES];

/// The numbers of a bicubic patch, which are known when compiling: its degree and the one of its derivatives.
const CUBIC: usize = 3;

/// Evaluates patches on one grid; weights and buffers are kept from patch to patch.
pub(super) struct Kernel {
    grid: Grid,
    /// Weights along u and along v, for the degree and for the derivative's.
    u: [Weights; 2],
    v: [Weights; 2],
    row: Row,
}

/// The Bernstein weights of one degree at k/n, k = 0 … n: for each group of lanes, `degree` + 1 of them.
struct Weights {
    degree: usize,
    groups: Vec<Lanes>,
}

/// The patch along one line of constant v: control points in u of the position and of both derivatives' directions.
#[derive(Default)]
struct Row {
    points: Vec<DVec3>,
    along_u: Vec<DVec3>,
    along_v: Vec<DVec3>,
}

impl Kernel {
    pub(super) fn new(grid: Grid) -> Self {
        Self {
            grid,
            u: Weights::pair(CUBIC, grid.segments_u),
            v: Weights::pair(CUBIC, grid.segments_v),
            row: Row::default(),
        }
    }

    /// Fills the buffers of one patch, each 3 × the number of the grid's vertices long.
    pub(super) fn fill(
        &mut self,
        net: &[DVec3],
        degree_u: usize,
        degree_v: usize,
        positions: &mut [f32],
        normals: &mut [f32],
    ) {
        if self.u[0].degree != degree_u {
            self.u = Weights::pair(degree_u, self.grid.segments_u);
        }
        if self.v[0].degree != degree_v {
            self.v = Weights::pair(degree_v, self.grid.segments_v);
        }
        let columns = degree_u + 1;
        let (du, dv) = directions(net, columns);
        let line = 3 * (self.grid.segments_u + 1);
        let lines = positions
            .chunks_exact_mut(line)
            .zip(normals.chunks_exact_mut(line));
        let mut limits = None;
        for (iv, (positions, normals)) in lines.enumerate() {
            let weights = &self.v;
            weights[0].blend_rows(iv, net, columns, &mut self.row.points);
            weights[0].blend_rows(iv, &du, columns - 1, &mut self.row.along_u);
            weights[1].blend_rows(iv, &dv, columns, &mut self.row.along_v);
            if self.fill_line(positions, normals) {
                let limits =
                    limits.get_or_insert_with(|| NormalNet::new(&du, &dv, degree_u, degree_v));
                self.repair(iv, limits, normals);
            }
        }
    }

    /// One line of samples. True if some normal is missing, which is then left at zero.
    fn fill_line(&self, positions: &mut [f32], normals: &mut [f32]) -> bool {
        let Row {
            points,
            along_u,
            along_v,
        } = &self.row;
        let groups = |k: usize| &self.u[k].groups[..];
        // Written twice so that the loops of the common case are unrolled.
        if let (Ok(points), Ok(along_u), Ok(along_v)) = (
            <&[DVec3; CUBIC + 1]>::try_from(&points[..]),
            <&[DVec3; CUBIC]>::try_from(&along_u[..]),
            <&[DVec3; CUBIC + 1]>::try_from(&along_v[..]),
        ) {
            let (values, slopes) = (groups(0).as_chunks().0, groups(1).as_chunks().0);
            fill_line(values, slopes, points, along_u, along_v, positions, normals)
        } else {
            let values = groups(0).chunks_exact(points.len());
            let slopes = groups(1).chunks_exact(along_u.len());
            fill_line_of(
                values.zip(slopes),
                points,
                along_u,
                along_v,
                positions,
                normals,
            )
        }
    }

    /// Puts limits where the line has no normal.
    #[cold]
    fn repair(&self, iv: usize, limits: &NormalNet, normals: &mut [f32]) {
        for (iu, normal) in normals.chunks_exact_mut(3).enumerate() {
            if normal == [0.0; 3] {
                let (u, v) = self.grid.uv(iu, iv);
                normal.copy_from_slice(&limits.limit(u, v).to_array().map(to_f32));
            }
        }
    }
}

/// The bicubic line: [`fill_line_of`] with all lengths known.
fn fill_line(
    values: &[[Lanes; CUBIC + 1]],
    slopes: &[[Lanes; CUBIC]],
    points: &[DVec3; CUBIC + 1],
    along_u: &[DVec3; CUBIC],
    along_v: &[DVec3; CUBIC + 1],
    positions: &mut [f32],
    normals: &mut [f32],
) -> bool {
    let weights = values.iter().zip(slopes).map(|(a, b)| (&a[..], &b[..]));
    fill_line_of(weights, points, along_u, along_v, positions, normals)
}

/// Evaluates one line, group by group; the last group may have room for fewer samples.
#[inline(always)]
fn fill_line_of<'a>(
    mut weights: impl Iterator<Item = (&'a [Lanes], &'a [Lanes])>,
    points: &[DVec3],
    along_u: &[DVec3],
    along_v: &[DVec3],
    positions: &mut [f32],
    normals: &mut [f32],
) -> bool {
    let net = [points, along_u, along_v];
    let mut missing = false;
    let (positions, last_positions) = positions.as_chunks_mut();
    let (normals, last_normals) = normals.as_chunks_mut();
    for ((position, normal), weights) in positions.iter_mut().zip(normals).zip(&mut weights) {
        let irregular;
        (*position, *normal, irregular) = group(weights, net);
        missing |= irregular;
    }
    if let Some(weights) = weights.next() {
        let (position, normal, irregular) = group(weights, net);
        last_positions.copy_from_slice(&position[..last_positions.len()]);
        last_normals.copy_from_slice(&normal[..last_normals.len()]);
        missing |= irregular;
    }
    missing
}

/// The samples of one group of lanes: positions, normals, and whether a normal is missing.
#[inline(always)]
fn group(
    (values, slopes): (&[Lanes], &[Lanes]),
    [points, along_u, along_v]: [&[DVec3]; 3],
) -> (Triples, Triples, bool) {
    let position = blend(values, points).map(|lanes| lanes.map(to_f32));
    let (unit, irregular) = normalise(cross(blend(slopes, along_u), blend(values, along_v)));
    (triples(position), triples(unit), irregular)
}

/// Σ wᵢ·Pᵢ in each lane, summed from both ends towards the middle, so that reversed weights and points give the same.
#[inline(always)]
fn blend(weights: &[Lanes], points: &[DVec3]) -> [Lanes; 3] {
    let mut sum = [[0.0; LANES]; 3];
    let count = points.len().min(weights.len());
    for i in 0..count / 2 {
        let (a, b) = (points[i].to_array(), points[count - 1 - i].to_array());
        let (wa, wb) = (&weights[i], &weights[count - 1 - i]);
        for axis in 0..3 {
            for lane in 0..LANES {
                sum[axis][lane] += wa[lane] * a[axis] + wb[lane] * b[axis];
            }
        }
    }
    if count % 2 == 1 {
        let (a, wa) = (points[count / 2].to_array(), &weights[count / 2]);
        for axis in 0..3 {
            for lane in 0..LANES {
                sum[axis][lane] += wa[lane] * a[axis];
            }
        }
    }
    sum
}

/// The cross product in each lane.
#[inline(always)]
fn cross([ax, ay, az]: [Lanes; 3], [bx, by, bz]: [Lanes; 3]) -> [Lanes; 3] {
    let mut product = [[0.0; LANES]; 3];
    for lane in 0..LANES {
        product[0][lane] = ay[lane] * bz[lane] - az[lane] * by[lane];
        product[1][lane] = az[lane] * bx[lane] - ax[lane] * bz[lane];
        product[2][lane] = ax[lane] * by[lane] - ay[lane] * bx[lane];
    }
    product
}

/// Unit vectors in f32, zero where the point is not regular, and whether there is such a point.
#[inline(always)]
fn normalise(cross: [Lanes; 3]) -> ([[f32; LANES]; 3], bool) {
    let least = to_f32(REGULAR_RATIO * REGULAR_RATIO);
    let [x, y, z] = cross.map(|lanes| lanes.map(to_f32));
    let mut factor = [0.0; LANES];
    let mut irregular = false;
    for lane in 0..LANES {
        let square = x[lane] * x[lane] + y[lane] * y[lane] + z[lane] * z[lane];
        let regular = square > least;
        irregular |= !regular;
        factor[lane] = if regular { 1.0 / square.sqrt() } else { 0.0 };
    }
    let scaled = |mut lanes: [f32; LANES]| {
        for lane in 0..LANES {
            lanes[lane] *= factor[lane];
        }
        lanes
    };
    ([scaled(x), scaled(y), scaled(z)], irregular)
}

/// x, y, z of one lane after the other.
#[inline(always)]
fn triples([x, y, z]: [[f32; LANES]; 3]) -> Triples {
    let mut triples = [0.0; 3 * LANES];
    for lane in 0..LANES {
        triples[3 * lane] = x[lane];
        triples[3 * lane + 1] = y[lane];
        triples[3 * lane + 2] = z[lane];
    }
    triples
}

impl Weights {
    /// The weights of a degree and of the one below.
    fn pair(degree: usize, segments: usize) -> [Self; 2] {
        [Self::new(degree, segments), Self::new(degree - 1, segments)]
    }

    fn new(degree: usize, segments: usize) -> Self {
        let count = (segments + 1).div_ceil(LANES);
        let mut groups = Vec::with_capacity(count * (degree + 1));
        for group in 0..count {
            for i in 0..=degree {
                // Lanes past the end repeat the last sample.
                groups.push(std::array::from_fn(|lane| {
                    weight(degree, i, (group * LANES + lane).min(segments), segments)
                }));
            }
        }
        Self { degree, groups }
    }

    /// Blends the rows of a net at sample k: one point per column, summed like [`blend`].
    fn blend_rows(&self, k: usize, net: &[DVec3], columns: usize, out: &mut Vec<DVec3>) {
        let weights = &self.groups[k / LANES * (self.degree + 1)..][..=self.degree];
        let lane = k % LANES;
        out.clear();
        out.resize(columns, DVec3::ZERO);
        let mut rows = net.chunks_exact(columns).zip(weights);
        while let (Some((a, wa)), last) = (rows.next(), rows.next_back()) {
            match last {
                Some((b, wb)) => {
                    for ((sum, &a), &b) in out.iter_mut().zip(a).zip(b) {
                        *sum += a * wa[lane] + b * wb[lane];
                    }
                }
                None => {
                    for (sum, &a) in out.iter_mut().zip(a) {
                        *sum += a * wa[lane];
                    }
                }
            }
        }
    }
}

/// C(d, i) sᵈ⁻ⁱ tⁱ with t = k/n and s = (n − k)/n, both divided: reversing i and k gives the same number.
fn weight(degree: usize, i: usize, k: usize, segments: usize) -> f64 {
    let (t, s) = (ratio(k, segments), ratio(segments - k, segments));
    power(s, degree - i) * power(t, i) * binomial(degree, i)
}

/// xᵉ by repeated multiplication.
fn power(x: f64, exponent: usize) -> f64 {
    (0..exponent).fold(1.0, |product, _| product * x)
}
