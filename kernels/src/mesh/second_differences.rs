//! Second differences of the parts of a patch, under repeated halving.
//!
//! Bounds need few digits, so the vectors are f32, one vector in each group of lanes. Each halving rounds twice; after
//! 60 halvings a length is off by less than 60 · 2 · 2⁻²⁴, which [`BEND_SLACK`] covers.

use crate::bernstein::de_casteljau::{split_net_with, split_with};
use crate::numeric::lanes::f32x4;
use crate::numeric::order::larger;

/// The relative amount by which lengths may be too small.
pub const BEND_SLACK: f64 = 1e-5;

/// Columns and rows of the nets of a part: second differences along u, along both, along v; control points (or none).
pub type Sizes = [(usize, usize); 4];

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
    pub fn start(&mut self, sizes: Sizes, vectors: impl Iterator<Item = [f32; 3]>) {
        // A net without rows has no columns either.
        self.sizes = sizes.map(|(columns, rows)| if rows == 0 { (0, 0) } else { (columns, rows) });
        self.count = sizes.iter().map(|(columns, rows)| columns * rows).sum();
        self.vectors.clear();
        self.vectors
            .extend(vectors.map(|[x, y, z]| f32x4::new([x, y, z, 0.0])));
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
