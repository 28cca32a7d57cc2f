//! Second differences of the parts of a patch, under repeated halving.
//!
//! Bounds need few digits, so the vectors are f32, one vector in each group of lanes; the fourth lane is 0, or the weight of a
//! homogeneous vector. Each halving rounds twice; after
//! 60 halvings a length is off by less than 60 · 2 · 2⁻²⁴, which [`BEND_SLACK`] covers.

use crate::bernstein::de_casteljau::{split_net_with, split_with};
use crate::numeric::lanes::f32x4;
use crate::numeric::order::larger;

/// The relative amount by which lengths may be too small.
pub const BEND_SLACK: f64 = 1e-5;

/// Bounds for a part with a larger quotient of two weights are so much larger than the distances that weights decide where it is halved.
const MAX_QUOTIENT: f32 = 4.0;

/// Shorter vectors have no direction, since their squares may underflow.
const SHORT: f32 = 1e-15;

/// Columns and rows of the nets of a part: second differences along u, along both, along v; control points (or none).
pub type Sizes = [(usize, usize); 4];

/// What bounds the second derivatives of a part of a rational patch A/w; the origin of A is the middle of a box around the part.
///
/// Linear interpolation of (A, w) over a triangle is off by (ΔA + Δw (Q − c))/w, where Q is a point of the box and c its middle.
/// ΔA is the sum of three terms, of which the mixed one is often across the others, as on a sphere. So its parts along an axis
/// and across it are added up apart.
#[derive(Clone, Copy, Debug)]
pub struct RationalBends {
    /// The bounding box of the control points, and the smallest and the largest weight.
    low: f32x4,
    high: f32x4,
    /// The maximum length of the vectors in each net of second differences of A, along the axis and across it. The fourth lanes
    /// repeat the first ones.
    along: f32x4,
    across: f32x4,
    /// The maximum size of the second differences of w.
    weights: f32x4,
    /// The largest distance of a control point from the origin of A.
    radius: f32,
    /// The direction of the mixed second differences, or zero: the axis for the halves.
    axis: [f32; 3],
}

impl RationalBends {
    /// The bounding box of the control points.
    pub fn control_box(&self) -> [[f32; 3]; 2] {
        [self.low, self.high].map(|corner| {
            let [x, y, z, _] = corner.to_array();
            [x, y, z]
        })
    }

    /// The bounds (|ΔA| + ρ|Δw|)/min w along u, mixed and along v.
    #[inline(never)]
    pub fn lengths(&self) -> [f64; 3] {
        let scale = self.scale();
        let (along, across) = (self.along.to_array(), self.across.to_array());
        let weights = self.weights.to_array();
        let length = |k: usize| {
            let (along, across) = (f64::from(along[k]), f64::from(across[k]));
            (f64::sqrt(along * along + across * across) + self.of_weights(weights[k])) * scale
        };
        [length(0), length(1), length(2)]
    }

    /// A bound for the distance of triangles over a part with these sides.
    #[inline(never)]
    pub fn distance(&self, [h, k]: [f64; 2]) -> f64 {
        let sum = |uu: f64, uv: f64, vv: f64| h * h * uu + 2.0 * h * k * uv + k * k * vv;
        let sum_of = |lanes: f32x4| {
            let [uu, uv, vv, _] = lanes.to_array();
            sum(uu.into(), uv.into(), vv.into())
        };
        let (along, across) = (sum_of(self.along), sum_of(self.across));
        let [uu, uv, vv, _] = self
            .weights
            .to_array()
            .map(|weight| self.of_weights(weight));
        let weights = sum(uu, uv, vv);
        (f64::sqrt(along * along + across * across) + weights) * self.scale() / 8.0
    }

    /// The bounds for a part from those for its halves, which have the same axis.
    #[inline(always)]
    fn of_halves(near: &Self, far: &Self) -> Self {
        let (low, high) = (near.low.fast_min(far.low), near.high.fast_max(far.high));
        let off = |half: &Self| distance(center(low, high), center(half.low, half.high));
        Self {
            low,
            high,
            along: near.along.fast_max(far.along),
            across: near.across.fast_max(far.across),
            weights: near.weights.fast_max(far.weights),
            // Moving the origin by a vector adds Δw times that vector to ΔA.
            radius: 0.5 * distance(low, high) + larger(off(near), off(far)),
            axis: near.axis,
        }
    }

    /// ρ|Δw| for the maximum size of Δw, where rounding errors of A are relative to the patch's size, which is 1.
    #[inline(always)]
    fn of_weights(&self, weight: f32) -> f64 {
        (f64::from(self.radius) + 4.0 * BEND_SLACK) * f64::from(weight)
    }

    #[inline(always)]
    fn scale(&self) -> f64 {
        (1.0 + 4.0 * BEND_SLACK) / f64::from(self.low.to_array()[3])
    }
}

/// The vectors of a stack of parts, all with nets of the same sizes.
#[derive(Clone, Debug, Default)]
pub struct SecondDifferences {
    sizes: Sizes,
    /// Number of vectors of one part.
    count: usize,
    vectors: Vec<f32x4>,
    /// The bounds for each part, if they are homogeneous and [`bound`](Self::bound) was called.
    bends: Vec<RationalBends>,
}

impl SecondDifferences {
    /// Replaces the stack by one part, whose vectors are given net by net.
    pub fn start(&mut self, sizes: Sizes, vectors: impl Iterator<Item = [f32; 4]>) {
        // A net without rows has no columns either.
        self.sizes = sizes.map(|(columns, rows)| if rows == 0 { (0, 0) } else { (columns, rows) });
        self.count = sizes.iter().map(|(columns, rows)| columns * rows).sum();
        self.vectors.clear();
        self.bends.clear();
        self.vectors.extend(vectors.map(f32x4::new));
    }

    /// Replaces the last part by its two halves along u or v; the far half is then the last one.
    #[inline(never)]
    pub fn halve(&mut self, along_u: bool) {
        let from = self.vectors.len() - self.count;
        self.vectors.extend_from_within(from..);
        let (near, far) = self.vectors[from..].split_at_mut(self.count);
        let mut start = 0;
        for (columns, rows) in self.sizes {
            let end = start + columns * rows;
            let (near, far) = (&mut near[start..end], &mut far[start..end]);
            // The sizes of bicubic patches, unrolled.
            match (columns, rows) {
                (2, 4) => halve_net::<2, 4>(near, far, along_u),
                (3, 3) => halve_net::<3, 3>(near, far, along_u),
                (4, 2) => halve_net::<4, 2>(near, far, along_u),
                _ if columns == 0 => {}
                _ => split_net_with(near, far, columns, along_u, middle),
            }
            start = end;
        }
    }

    /// Removes the last part.
    pub fn pop(&mut self) {
        self.vectors.truncate(self.vectors.len() - self.count);
        self.bends.pop();
    }

    /// Computes [`RationalBends`] of the only part, whose vectors are homogeneous.
    pub fn bound(&mut self) {
        self.bends.push(self.rational_bends(0, None));
    }

    /// Replaces the last [`RationalBends`], those of the part that was halved, by those of both halves.
    #[inline(never)]
    pub fn bound_halves(&mut self) {
        let whole = self.bends.pop();
        let near = self.rational_bends(1, whole.as_ref());
        let far = self.rational_bends(0, whole.as_ref());
        self.bends.extend([near, far]);
    }

    /// Those of the last part.
    pub fn last_bends(&self) -> &RationalBends {
        &self.bends[self.bends.len() - 1]
    }

    /// Whether the weights of the last part, which has [`RationalBends`], differ more along u than along v; `None` if they differ
    /// little, or equally.
    #[inline(never)]
    pub fn is_steeper_along_u(&self) -> Option<bool> {
        let bends = self.last_bends();
        let ([.., low], [.., high]) = (bends.low.to_array(), bends.high.to_array());
        if high <= MAX_QUOTIENT * low {
            return None;
        }
        let (columns, rows) = self.sizes[3];
        let net = &self.vectors[self.vectors.len() - columns * rows..];
        let largest_quotient = |lines: usize, step: usize, across: usize| {
            (0..lines).fold(1.0, |max, line| {
                let line = net[line * across..].iter().step_by(step);
                let (low, high) =
                    line.take(net.len() / lines)
                        .fold((f32::MAX, f32::MIN), |(low, high), v| {
                            let [.., weight] = v.to_array();
                            (low.min(weight), high.max(weight))
                        });
                larger(max, high / low)
            })
        };
        let along_u = largest_quotient(rows, 1, columns);
        let along_v = largest_quotient(columns, columns, 1);
        (along_u != along_v).then_some(along_u > along_v)
    }

    /// [`RationalBends::distance`] for the part whose halves are the last two parts.
    #[inline(never)]
    pub fn joined_distance(&self, sides: [f64; 2]) -> f64 {
        let [.., near, far] = &self.bends[..] else {
            return f64::INFINITY;
        };
        RationalBends::of_halves(near, far).distance(sides)
    }

    /// The maximum length of the vectors in each net of second differences, of the part that is `before` positions
    /// below the last one.
    #[inline(never)]
    pub fn longest(&self, before: usize) -> [f32; 3] {
        let mut rest = &self.vectors[self.vectors.len() - (before + 1) * self.count..];
        let [uu, uv, vv, _] = self.sizes;
        [uu, uv, vv].map(|(columns, rows)| {
            let (net, others) = rest.split_at(columns * rows);
            rest = others;
            let mut max = f32x4::ZERO;
            let (fours, others) = net.as_chunks();
            for &four in fours {
                let [x, y, z, _] = f32x4::transpose(four);
                max = max.fast_max(x * x + y * y + z * z);
            }
            for &v in others {
                let [x, y, z, _] = (v * v).to_array();
                max = max.fast_max(f32x4::splat(x + y + z));
            }
            let [a, b, c, d] = max.to_array();
            let max = larger(larger(a, b), larger(c, d));
            f32::sqrt(max)
        })
    }

    /// [`RationalBends`] of the part that is `before` positions below the last one, whose vectors are homogeneous, with the axis
    /// of the part of which it is a half.
    #[inline(never)]
    fn rational_bends(&self, before: usize, whole: Option<&RationalBends>) -> RationalBends {
        let end = self.vectors.len() - before * self.count;
        let part = &self.vectors[end - self.count..end];
        let [uu, uv, vv, _] = self.sizes;
        let (nets, points) = part.split_at(uu.0 * uu.1 + uv.0 * uv.1 + vv.0 * vv.1);
        let (uu, nets) = nets.split_at(uu.0 * uu.1);
        let (uv, vv) = nets.split_at(uv.0 * uv.1);
        let (low, high) = projected_box(points);
        let [x, y, z, _] = center(low, high).to_array();
        let origin = (f32x4::splat(x), f32x4::splat(y), f32x4::splat(z));
        let [ax, ay, az] = whole.map_or([0.0; 3], |whole| whole.axis);
        let axis = (f32x4::splat(ax), f32x4::splat(ay), f32x4::splat(az));
        let mixed = uv.iter().fold(f32x4::ZERO, |sum, &v| sum + v);
        let uu = longest_about(uu, origin, axis);
        let uv = longest_about(uv, origin, axis);
        let vv = longest_about(vv, origin, axis);
        let [dx, dy, dz, weight] = mixed.to_array();
        RationalBends {
            low,
            high,
            along: largest([uu.0, uv.0, vv.0]).sqrt(),
            across: largest([uu.1, uv.1, vv.1]).sqrt(),
            weights: largest([uu.2, uv.2, vv.2]),
            radius: 0.5 * distance(low, high),
            axis: unit([dx - weight * x, dy - weight * y, dz - weight * z]),
        }
    }

    /// The bounding box of the control points of the last part.
    pub fn control_box(&self) -> [[f32; 3]; 2] {
        let (columns, rows) = self.sizes[3];
        let net = &self.vectors[self.vectors.len() - columns * rows..];
        let low = net
            .iter()
            .fold(f32x4::splat(f32::MAX), |low, &v| low.fast_min(v));
        let high = net
            .iter()
            .fold(f32x4::splat(f32::MIN), |high, &v| high.fast_max(v));
        [low, high].map(|corner| {
            let [x, y, z, _] = corner.to_array();
            [x, y, z]
        })
    }
}

/// The bounding box of the projections of homogeneous points, and of their weights in the fourth lane.
#[inline(always)]
fn projected_box(net: &[f32x4]) -> (f32x4, f32x4) {
    let first = (f32x4::splat(f32::MAX), f32x4::splat(f32::MIN));
    net.iter().fold(first, |(low, high), &v| {
        let [x, y, z, w] = v.to_array();
        let point = f32x4::new([x, y, z, w * w]) / f32x4::splat(w);
        (low.fast_min(point), high.fast_max(point))
    })
}

/// The middle of a box.
#[inline(always)]
fn center(low: f32x4, high: f32x4) -> f32x4 {
    (low + high) * f32x4::splat(0.5)
}

/// The distance of two points; the fourth lanes are ignored.
#[inline(always)]
fn distance(a: f32x4, b: f32x4) -> f32 {
    let off = a - b;
    let [x, y, z, _] = (off * off).to_array();
    f32::sqrt(x + y + z)
}

/// The unit vector, or zero for one that is short.
#[inline(always)]
fn unit([x, y, z]: [f32; 3]) -> [f32; 3] {
    let length = f32::sqrt(x * x + y * y + z * z);
    if length > SHORT {
        [x / length, y / length, z / length]
    } else {
        [0.0; 3]
    }
}

/// The largest number of each of three vectors; the fourth lane repeats the first one.
#[inline(always)]
fn largest([a, b, c]: [f32x4; 3]) -> f32x4 {
    let [x, y, z, w] = f32x4::transpose([a, b, c, a]);
    x.fast_max(y).fast_max(z.fast_max(w))
}

/// The maxima in each lane of the squared lengths of A − wc of homogeneous vectors (A, w), along a unit vector and across it,
/// and of |w|.
#[inline(always)]
fn longest_about(
    net: &[f32x4],
    (cx, cy, cz): (f32x4, f32x4, f32x4),
    (ax, ay, az): (f32x4, f32x4, f32x4),
) -> (f32x4, f32x4, f32x4) {
    let (mut along, mut across, mut weight) = (f32x4::ZERO, f32x4::ZERO, f32x4::ZERO);
    let mut add = |four: [f32x4; 4]| {
        let [x, y, z, w] = f32x4::transpose(four);
        let (x, y, z) = (x - w * cx, y - w * cy, z - w * cz);
        let part = x * ax + y * ay + z * az;
        let (x, y, z) = (x - part * ax, y - part * ay, z - part * az);
        along = along.fast_max(part * part);
        across = across.fast_max(x * x + y * y + z * z);
        weight = weight.fast_max(w.abs());
    };
    let (fours, others) = net.as_chunks();
    fours.iter().for_each(|&four| add(four));
    if let Some(&first) = others.first() {
        let at = |k: usize| others.get(k).copied().unwrap_or(first);
        add([first, at(1), at(2), first]);
    }
    (along, across, weight)
}

/// [`split_net_with`] for a size that is known at compile time.
#[inline(always)]
fn halve_net<const COLUMNS: usize, const ROWS: usize>(
    near: &mut [f32x4],
    far: &mut [f32x4],
    along_u: bool,
) {
    let (near, far) = (
        near.as_chunks_mut::<COLUMNS>().0,
        far.as_chunks_mut::<COLUMNS>().0,
    );
    let (Ok(near), Ok(far)) = (
        <&mut [[f32x4; COLUMNS]; ROWS]>::try_from(near),
        <&mut [[f32x4; COLUMNS]; ROWS]>::try_from(far),
    ) else {
        return;
    };
    if along_u {
        for (near, far) in near.iter_mut().zip(far) {
            split_with(near, far, middle);
        }
    } else {
        split_with(near, far, |a, b| {
            std::array::from_fn(|column| middle(a[column], b[column]))
        });
    }
}

#[inline(always)]
fn middle(a: f32x4, b: f32x4) -> f32x4 {
    (a + b) * f32x4::splat(0.5)
}
