//! Layout of a grid of samples: its vertices and faces, without points.

use crate::geometry::error::Error;
use crate::numeric::float::ratio;

/// A grid over a patch: `segments_u` × `segments_v` cells with their corners at equal steps of u and v.
///
/// There are (segments_u + 1)·(segments_v + 1) vertices; the vertex at (iu, iv) has the index iv·(segments_u + 1) + iu.
/// Each cell has two triangles. Faces are counter-clockwise as seen from the side to which ∂u × ∂v points. Counts and
/// indices beyond `usize::MAX` are reported as `usize::MAX`; no mesh has as many (see [`check`](Self::check)).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Grid {
    /// The number of cells along u, at least 1.
    pub segments_u: usize,
    /// The number of cells along v, at least 1.
    pub segments_v: usize,
}

/// The method by which the samples of a grid are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum GridMethod {
    /// By Bernstein polynomials: exact at corners, identical along shared edges.
    #[default]
    Bernstein,
    /// By forward differences along u: for a curve of degree m with n steps, m additions per coordinate and step and no
    /// multiplication. For comparison and teaching.
    ///
    /// The value at 0 and its m differences for the step 1/n are computed once per line; each step then adds every
    /// difference to that of the next lower order. Rounding errors accumulate: in f64 to about n·3ᵐ·2⁻⁵³ of the largest
    /// coordinate, which is invisible in f32 up to a degree of about 10. The last sample of a line is its control
    /// point. Source: Wallis, "Tutorial on forward differencing", Graphics Gems (1990), 594–603.
    ForwardDifference,
}

/// The maximum number of bytes of one mesh: 1 GiB.
const MAX_MESH_BYTES: u64 = 1 << 30;
/// Three position and three normal coordinates, two parameters and a patch index, four bytes each.
const VERTEX_BYTES: u64 = 9 * 4;
/// The indices of two triangles and a quad per cell, four bytes each; a grid has fewer cells than vertices.
const CELL_BYTES: u64 = (6 + 4) * 4;

impl From<usize> for Grid {
    /// The same number of segments in both directions.
    fn from(segments: usize) -> Self {
        Self {
            segments_u: segments,
            segments_v: segments,
        }
    }
}

impl Grid {
    /// The number of vertices, (segments_u + 1)·(segments_v + 1).
    pub fn vertex_count(&self) -> usize {
        let points = |segments: usize| segments.saturating_add(1);
        points(self.segments_u).saturating_mul(points(self.segments_v))
    }

    /// The number of triangles, two per cell.
    pub fn triangle_count(&self) -> usize {
        self.segments_u
            .saturating_mul(self.segments_v)
            .saturating_mul(2)
    }

    /// The index of the vertex at (iu, iv).
    pub fn vertex(&self, iu: usize, iv: usize) -> usize {
        iv.saturating_mul(self.segments_u.saturating_add(1))
            .saturating_add(iu)
    }

    /// (u, v) of the vertex at (iu, iv): (iu / segments_u, iv / segments_v).
    pub fn uv(&self, iu: usize, iv: usize) -> (f64, f64) {
        (ratio(iu, self.segments_u), ratio(iv, self.segments_v))
    }

    /// The corners of the cell at (iu, iv), counter-clockwise from the vertex (iu, iv).
    pub fn quad(&self, iu: usize, iv: usize) -> [usize; 4] {
        let [near, far] = [iv, iv.saturating_add(1)].map(|iv| self.vertex(iu, iv));
        [near, near.saturating_add(1), far.saturating_add(1), far]
    }

    /// The corners of all cells, row by row.
    pub fn quads(&self) -> impl Iterator<Item = [usize; 4]> {
        let grid = *self;
        (0..grid.segments_v)
            .flat_map(move |iv| (0..grid.segments_u).map(move |iu| grid.quad(iu, iv)))
    }

    /// The triangles of all cells: a cell with the quad a b c d gives a b c and a c d.
    pub fn triangles(&self) -> impl Iterator<Item = [usize; 3]> {
        self.quads().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
    }

    /// Returns an error for 0 segments, and for grids whose mesh of `patches` patches would take more than 1 GiB.
    ///
    /// The limit in the error applies to the larger number of segments, given the smaller one.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] above the limit.
    pub fn check(&self, patches: usize) -> Result<(), Error> {
        let (min, max) = if self.segments_u < self.segments_v {
            (self.segments_u, self.segments_v)
        } else {
            (self.segments_v, self.segments_u)
        };
        if min == 0 {
            return Err(Error::Range {
                what: "segments",
                expected: "a whole number from 1",
                got: 0.0,
            });
        }
        let vertices = MAX_MESH_BYTES / (VERTEX_BYTES + CELL_BYTES) / (patches.max(1) as u64);
        let per_line = if min == max {
            vertices.isqrt()
        } else {
            vertices / (min as u64).saturating_add(1)
        };
        let limit = usize::try_from(per_line.saturating_sub(1)).unwrap_or(usize::MAX);
        if max > limit {
            Err(Error::too_many("segments", limit, max))
        } else {
            Ok(())
        }
    }
}
