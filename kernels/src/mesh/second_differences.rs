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

/// Columns and rows of the nets of a part: second differences along u, along both, along v; control points (or none).
pub type Sizes = [(usize, usize); 4];

/// What bounds the second derivatives of a part of a rational patch A/w; the origin of A is the middle of the box.
#[derive(Clone, Copy, Debug)]
pub struct RationalBends {
    /// The bounding box of the control points.
    pub control_box: [[f32; 3]; 2],
    /// The smallest weight.
    pub min_weight: f32,
    /// The maximum length of the vectors in each net of second differences of A.
    pub points: [f32; 3],
    /// The maximum size of the second differences of w.
    pub weights: [f32; 3],
}

/// The vectors of a stack of parts, all with nets of the same sizes.
#[derive(Clone, Debug, Default)]
pub struct SecondDifferences {
    sizes: Sizes,
    /// Number of vectors of one part.
    count: usize,
    vectors: Vec<f32x4>,
}

impl SecondDifferences {
    /// Replaces the stack by one part, whose vectors are given net by net.
    pub fn start(&mut self, sizes: Sizes, vectors: impl Iterator<Item = [f32; 4]>) {
        // A net without rows has no columns either.
        self.sizes = sizes.map(|(columns, rows)| if rows == 0 { (0, 0) } else { (columns, rows) });
        self.count = sizes.iter().map(|(columns, rows)| columns * rows).sum();
        self.vectors.clear();
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

    /// [`RationalBends`] of the part that is `before` positions below the last one, whose vectors are homogeneous.
    #[inline(never)]
    pub fn rational_bends(&self, before: usize) -> RationalBends {
        let end = self.vectors.len() - before * self.count;
        let part = &self.vectors[end - self.count..end];
        let [uu, uv, vv, points] = self.sizes;
        let (low, high) = projected_box(&part[self.count - points.0 * points.1..]);
        let middle = (low + high) * f32x4::splat(0.5);
        let [x, y, z, _] = middle.to_array();
        let origin = [x, y, z].map(f32x4::splat);
        let mut rest = part;
        let longest = [uu, uv, vv].map(|(columns, rows)| {
            let (net, others) = rest.split_at(columns * rows);
            rest = others;
            longest_about(net, origin)
        });
        let [low, high] = [low, high].map(f32x4::to_array);
        RationalBends {
            control_box: [low, high].map(|[x, y, z, _]| [x, y, z]),
            min_weight: low[3],
            points: longest.map(|[length, _]| length),
            weights: longest.map(|[_, weight]| weight),
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

/// The maximum length of A − wc and the maximum |w| of homogeneous vectors (A, w).
#[inline(always)]
fn longest_about(net: &[f32x4], [cx, cy, cz]: [f32x4; 3]) -> [f32; 2] {
    let (mut length, mut weight) = (f32x4::ZERO, f32x4::ZERO);
    let mut add = |four: [f32x4; 4]| {
        let [x, y, z, w] = f32x4::transpose(four);
        let (x, y, z) = (x - w * cx, y - w * cy, z - w * cz);
        length = length.fast_max(x * x + y * y + z * z);
        weight = weight.fast_max(w * w);
    };
    let (fours, others) = net.as_chunks();
    fours.iter().for_each(|&four| add(four));
    let mut four = [f32x4::ZERO; 4];
    four[..others.len()].copy_from_slice(others);
    add(four);
    [length, weight].map(|max| {
        let [a, b, c, d] = max.to_array();
        f32::sqrt(larger(larger(a, b), larger(c, d)))
    })
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
