//! Grid evaluation of patches of any degrees, by either method.
//!
//! For each v the rows of the net are blended into one curve in u, then that curve is evaluated along u. Weights are
//! computed once per grid. All arithmetic is in f64; only results are rounded to f32. Weights are computed and summed
//! so that t and 1 − t are exactly symmetric: two patches that share an edge, in the same direction or reversed, get
//! bit-identical samples there.

use super::buffers::to_f32;
use super::forward::Stepper;
use super::grid::{Grid, GridMethod};
use crate::geometry::check::max_abs;
use crate::patch::tensor_product::{REGULAR_RATIO, directions};
use casteljau_kernels::bernstein::weights::weights;
use casteljau_kernels::numeric::vector::Vector;
use glam::DVec3;
use std::ops::AddAssign;

/// The square of the length of ∂u × ∂v below which a point is not regular.
const MIN_SQUARE: f32 = to_f32(REGULAR_RATIO * REGULAR_RATIO);

/// From this coordinate on, differences might overflow; such coordinates exceed the range of f32 anyway.
const TOO_LARGE_TO_STEP: f64 = 1e39;

/// Evaluates patches on one grid; reuses the weights while the degrees stay the same.
pub(crate) struct GenericGridEvaluator {
    grid: Grid,
    method: GridMethod,
    /// Weights along u and along v, each for the degree and for the degree of the derivative.
    u: [GridWeights; 2],
    v: [GridWeights; 2],
    row: Row,
}

/// The Bernstein weights of one degree at k/n for k = 0 … n: `degree` + 1 weights for each k.
#[derive(Default)]
pub(crate) struct GridWeights {
    degree: usize,
    values: Vec<f64>,
}

/// The patch along one line of constant v: control points in u of the position and of the directions of both
/// derivatives.
#[derive(Default)]
struct Row {
    points: Vec<DVec3>,
    along_u: Vec<DVec3>,
    along_v: Vec<DVec3>,
}

impl GenericGridEvaluator {
    pub(crate) fn new(grid: Grid, method: GridMethod) -> Self {
        Self {
            grid,
            method,
            u: Default::default(),
            v: Default::default(),
            row: Row::default(),
        }
    }

    /// Computes positions and normals of one patch. Returns `true` if some normal is missing; such a normal is zero.
    pub(crate) fn fill(
        &mut self,
        net: &[DVec3],
        degree_u: usize,
        degree_v: usize,
        positions: &mut [[f32; 3]],
        normals: &mut [[f32; 3]],
    ) -> bool {
        prepare(&mut self.u, degree_u, self.grid.segments_u);
        prepare(&mut self.v, degree_v, self.grid.segments_v);
        let columns = degree_u + 1;
        let (du, dv) = directions(net, columns);
        let step = self.method == GridMethod::ForwardDifference && max_abs(net) < TOO_LARGE_TO_STEP;
        let line = self.grid.segments_u + 1;
        let lines = positions
            .chunks_exact_mut(line)
            .zip(normals.chunks_exact_mut(line));
        let mut missing = false;
        for (iv, (positions, normals)) in lines.enumerate() {
            let weights = &self.v;
            weights[0].blend_rows(iv, net, columns, &mut self.row.points);
            weights[0].blend_rows(iv, &du, columns - 1, &mut self.row.along_u);
            weights[1].blend_rows(iv, &dv, columns, &mut self.row.along_v);
            if step {
                self.step_along(positions, normals);
            } else {
                self.evaluate_along(positions, normals);
            }
            missing |= make_unit(normals);
        }
        missing
    }

    /// One line of positions and of ∂u × ∂v.
    fn evaluate_along(&self, positions: &mut [[f32; 3]], cross_products: &mut [[f32; 3]]) {
        let row = &self.row;
        let weights = self.u[0].values.chunks_exact(row.points.len());
        let weights = weights.zip(self.u[1].values.chunks_exact(row.along_u.len()));
        let samples = positions.iter_mut().zip(cross_products);
        for ((values, slopes), (position, cross_product)) in weights.zip(samples) {
            let along_u = blend(slopes, &row.along_u);
            *position = round(blend(values, &row.points));
            *cross_product = round(along_u.cross(blend(values, &row.along_v)));
        }
    }

    /// As `evaluate_along`, by forward differences; the last sample is the end point of the line.
    fn step_along(&self, positions: &mut [[f32; 3]], cross_products: &mut [[f32; 3]]) {
        let curves = [&self.row.points, &self.row.along_u, &self.row.along_v];
        let mut steppers = curves.map(|points| Stepper::new(points, self.grid.segments_u));
        let mut write = |at: usize, [point, along_u, along_v]: [DVec3; 3]| {
            positions[at] = round(point);
            cross_products[at] = round(along_u.cross(along_v));
        };
        for at in 0..self.grid.segments_u {
            write(at, steppers.each_mut().map(Stepper::next));
        }
        let ends = curves.map(|points| points.last().copied().unwrap_or_default());
        write(self.grid.segments_u, ends);
    }
}

/// Normalizes the vectors ∂u × ∂v. Returns `true` if one of them is not regular; it becomes zero.
fn make_unit(cross_products: &mut [[f32; 3]]) -> bool {
    let mut missing = false;
    for cross_product in cross_products {
        let normal = unit(*cross_product);
        missing |= normal.is_none();
        *cross_product = normal.unwrap_or_default();
    }
    missing
}

/// The nearest f32, with 0 for −0, since neighbouring patches may compute zeros of different sign.
pub(crate) fn round(p: DVec3) -> [f32; 3] {
    p.to_array().map(|x| to_f32(x) + 0.0)
}

/// The unit vector; `None` where the point is not regular.
fn unit([x, y, z]: [f32; 3]) -> Option<[f32; 3]> {
    let square = x * x + y * y + z * z;
    let factor = 1.0 / square.sqrt();
    (square > MIN_SQUARE).then_some([x * factor, y * factor, z * factor])
}

/// Σ wᵢ·Pᵢ, summed from both ends towards the middle, so that reversed weights and points give the same bits.
pub(crate) fn blend<V: Vector + AddAssign>(weights: &[f64], points: &[V]) -> V {
    let mut sum = V::default();
    let mut terms = weights.iter().zip(points).map(|(&w, &p)| p * w);
    while let (Some(first), last) = (terms.next(), terms.next_back()) {
        sum += last.map_or(first, |last| first + last);
    }
    sum
}

/// Recomputes the weights of a degree and of the degree below if the degree has changed.
pub(crate) fn prepare(pair: &mut [GridWeights; 2], degree: usize, segments: usize) {
    if pair[0].degree != degree {
        *pair = [degree, degree - 1].map(|degree| GridWeights {
            degree,
            values: weights(degree, segments),
        });
    }
}

impl GridWeights {
    /// The weights at sample k.
    pub(crate) fn at(&self, k: usize) -> &[f64] {
        &self.values[k * (self.degree + 1)..][..=self.degree]
    }

    /// Blends the rows of a net at sample k: one point per column, summed in the same order as in [`blend`].
    pub(crate) fn blend_rows<V: Vector + AddAssign>(
        &self,
        k: usize,
        net: &[V],
        columns: usize,
        out: &mut Vec<V>,
    ) {
        let weights = self.at(k);
        out.clear();
        out.resize(columns, V::default());
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
