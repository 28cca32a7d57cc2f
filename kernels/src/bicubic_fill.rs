//! Filling a grid with the positions and normals of a bicubic patch.

use crate::bicubic::BicubicGrid;
use crate::normals::larger;
use crate::{normals, positions};

impl BicubicGrid {
    /// Whether f32 holds the coordinates and their sums.
    pub fn fits(net: &[[f64; 3]; 16]) -> bool {
        let numbers = net.as_flattened().iter();
        numbers.fold(0.0, |max, n| larger(max, n.abs())) < f64::from(f32::MAX / 16.0)
    }

    /// Positions and unit normals of the patch with this net, u along the fast index. True if normals are missing:
    /// those are left at zero.
    ///
    /// Both lists hold a point for each sample, u along the fast index. Positions are exact at corners, within 4 ulps
    /// of the largest coordinate elsewhere, and on sides they are what f64 gives, rounded: the sums run from both ends
    /// towards the middle, so that patches which share a side get the same bits, in the same direction or reversed.
    /// For nets that [`fit`](Self::fits).
    pub fn fill(
        &self,
        net: &[[f64; 3]; 16],
        positions: &mut [[f32; 3]],
        normals: &mut [[f32; 3]],
    ) -> bool {
        let samples = (self.segments_u + 1) * (self.segments_v + 1);
        let (Some(positions), Some(normals)) =
            (positions.get_mut(..samples), normals.get_mut(..samples))
        else {
            return false;
        };
        positions::fill(self, net, positions);
        normals::fill(self, net, normals)
    }
}
