//! The inner loop: positions and normals of one patch on a grid.
//!
//! For each v the rows of the net are blended into one curve in u, then that curve is evaluated along u. Weights are
//! computed once per grid. The arithmetic is f64; only results are rounded to f32. Weights are built and summed so
//! that t and 1 − t exchange their roles exactly: two patches that share a side, in the same direction or reversed,
//! get bit-identical samples there. Bicubic lines, the common ones, go through a crate of their own, two samples at a time.

use super::Grid;
use super::normal::{NormalNet, binomial};
use super::patch::{REGULAR_RATIO, directions};
use super::tessellate::to_f32;
use crate::curve::ratio;
use casteljau_kernels::BicubicLine;
use glam::DVec3;

/// The square of the length below which a normal is not regular.
const LEAST_SQUARE: f32 = to_f32(REGULAR_RATIO * REGULAR_RATIO);

/// The degree to prepare for; another one costs a second preparation.
const CUBIC: usize = 3;

/// Evaluates patches on one grid; weights and buffers are kept from patch to patch.
pub(super) struct Kernel {
    grid: Grid,
    /// Weights along u and along v, for the degree and for the derivative's.
    u: [Weights; 2],
    v: [Weights; 2],
    row: Row,
}

/// The Bernstein weights of one degree at k/n, k = 0 … n: `degree` + 1 of them for each k.
struct Weights {
    degree: usize,
    values: Vec<f64>,
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
        let (values, slopes) = (&self.u[0].values[..], &self.u[1].values[..]);
        let (positions, normals) = (positions.as_chunks_mut().0, normals.as_chunks_mut().0);
        if let (Ok(points), Ok(along_u), Ok(along_v)) = (
            bytemuck::cast_slice(points).try_into(),
            bytemuck::cast_slice(along_u).try_into(),
            bytemuck::cast_slice(along_v).try_into(),
        ) {
            let (values, slopes) = (values.as_chunks().0, slopes.as_chunks().0);
            BicubicLine {
                points,
                along_u,
                along_v,
                values,
                slopes,
            }
            .fill(positions, normals);
        } else {
            let weights = values
                .chunks_exact(points.len())
                .zip(slopes.chunks_exact(along_u.len()));
            for ((values, slopes), (position, facing)) in
                weights.zip(positions.iter_mut().zip(normals.iter_mut()))
            {
                *position = round(blend(values, points));
                *facing = round(blend(slopes, along_u).cross(blend(values, along_v)));
            }
        }
        make_unit(normals)
    }

    /// Puts limits where the line has no normal.
    #[cold]
    fn repair(&self, iv: usize, limits: &NormalNet, normals: &mut [f32]) {
        if limits.vanishes() {
            return;
        }
        for (iu, normal) in normals.chunks_exact_mut(3).enumerate() {
            if normal == [0.0; 3] {
                let (u, v) = self.grid.uv(iu, iv);
                normal.copy_from_slice(&limits.limit(u, v).to_array().map(to_f32));
            }
        }
    }
}

/// Makes the vectors ∂u × ∂v unit normals. True if one is not regular, which becomes zero.
fn make_unit(facings: &mut [[f32; 3]]) -> bool {
    let mut missing = false;
    for facing in facings {
        let normal = unit(*facing);
        missing |= normal.is_none();
        *facing = normal.unwrap_or_default();
    }
    missing
}

#[inline(always)]
fn round(p: DVec3) -> [f32; 3] {
    [to_f32(p.x), to_f32(p.y), to_f32(p.z)]
}

/// The unit vector; none where the point is not regular.
#[inline(always)]
fn unit([x, y, z]: [f32; 3]) -> Option<[f32; 3]> {
    let square = x * x + y * y + z * z;
    let factor = 1.0 / square.sqrt();
    (square > LEAST_SQUARE).then_some([x * factor, y * factor, z * factor])
}

/// Σ wᵢ·Pᵢ, summed from both ends towards the middle, so that reversed weights and points give the same.
fn blend(weights: &[f64], points: &[DVec3]) -> DVec3 {
    let mut sum = DVec3::ZERO;
    let mut terms = weights.iter().zip(points).map(|(&w, &p)| p * w);
    while let (Some(first), last) = (terms.next(), terms.next_back()) {
        sum += last.map_or(first, |last| first + last);
    }
    sum
}

impl Weights {
    /// The weights of a degree and of the one below.
    fn pair(degree: usize, segments: usize) -> [Self; 2] {
        [Self::new(degree, segments), Self::new(degree - 1, segments)]
    }

    fn new(degree: usize, segments: usize) -> Self {
        let at = |k| (0..=degree).map(move |i| weight(degree, i, k, segments));
        Self {
            degree,
            values: (0..=segments).flat_map(at).collect(),
        }
    }

    /// Blends the rows of a net at sample k: one point per column, summed like [`blend`].
    fn blend_rows(&self, k: usize, net: &[DVec3], columns: usize, out: &mut Vec<DVec3>) {
        let weights = &self.values[k * (self.degree + 1)..][..=self.degree];
        out.clear();
        out.resize(columns, DVec3::ZERO);
        let mut rows = net.chunks_exact(columns).zip(weights);
        while let (Some((a, wa)), last) = (rows.next(), rows.next_back()) {
            match last {
                Some((b, wb)) => {
                    for ((sum, &a), &b) in out.iter_mut().zip(a).zip(b) {
                        *sum += a * *wa + b * *wb;
                    }
                }
                None => {
                    for (sum, &a) in out.iter_mut().zip(a) {
                        *sum += a * *wa;
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
