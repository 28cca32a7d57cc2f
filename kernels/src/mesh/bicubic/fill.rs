//! Filling a grid with the positions and normals of a bicubic patch.

use super::grid::BicubicGrid;
use super::{normals, positions};
use crate::numeric::order::larger;

impl BicubicGrid {
    /// Whether f32 can hold the coordinates and their sums.
    pub fn fits(net: &[[f64; 3]; 16]) -> bool {
        let numbers = net.as_flattened().iter();
        numbers.fold(0.0, |max, n| larger(max, n.abs())) < f64::from(f32::MAX / 16.0)
    }

    /// Positions and unit normals of the patch with the given net. Returns true if normals are missing; these are zero.
    ///
    /// Both lists hold one point for each sample, with u along the fast index. Positions are exact at corners and
    /// within 4 ulps of the largest coordinate elsewhere. On edges they are the f64 results, rounded: the sums run from
    /// both ends towards the middle, so that patches that share an edge get the same bits, in the same or in reversed
    /// direction. The net must [`fit`](Self::fits).
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
