//! The cells of all patches of a surface: of equal size, or by a tolerance or pixels.

use super::grid::Grid;
use super::mesh_patch::{Frame, PatchNetwork};
use super::options::Detail;
use super::subdivider::{
    AdaptiveSubdivider, CLOSE_FORECAST_DEPTHS, DYADIC, FORECAST_DEPTHS, cell_limit,
};
use crate::geometry::error::Error;
use crate::surface::network::Surface;
use casteljau_kernels::mesh::cell_triangulator::Cell;
use casteljau_kernels::mesh::second_differences::SecondDifferences;
use casteljau_kernels::numeric::order::to_u32;
#[cfg(feature = "rayon")]
use {
    crate::parallel::{PATCHES_AT_ONCE, has_cores, map_patches},
    std::sync::atomic::{AtomicUsize, Ordering::Relaxed},
};

/// The maximum number of cells of one mesh in 1 GiB: each cell makes two triangles of three indices and almost one
/// vertex of nine numbers. With 32-bit addresses half of it: during construction a mesh takes about 350 bytes per cell.
const MAX_CELLS: usize =
    (1 << if cfg!(target_pointer_width = "32") {
        29
    } else {
        30
    }) / ((6 + 9) * 4);

/// The maximum number of cells of a mesh by tolerance or pixels. With 32-bit addresses it is lower: on thin patches
/// nearly every cell has its own vertices, and during construction a mesh takes about 3 kB per cell of the 4 GiB
/// address space.
const MAX_CUT_CELLS: usize = if cfg!(target_pointer_width = "32") {
    1 << 20
} else {
    MAX_CELLS
};

/// The surface is refused if this fraction of an estimate of the number of cells exceeds the limit and the last two
/// estimates agree to this fraction.
const CLOSE_SHARE: f64 = 7.0 / 8.0;

/// The cells of all patches.
pub(crate) struct SurfaceCells {
    pub(crate) cells: Vec<Cell>,
    /// The end of each patch's cells in `cells`.
    pub(crate) ends: Vec<usize>,
    /// The integer that represents the parameter 1.
    pub(crate) full: u32,
    /// Whether corners may be added inside cells to keep a tolerance.
    pub(crate) has_tolerance: bool,
}

impl SurfaceCells {
    pub(crate) fn of_patch(&self, patch: usize) -> &[Cell] {
        let from = if patch == 0 { 0 } else { self.ends[patch - 1] };
        &self.cells[from..self.ends[patch]]
    }
}

/// The cells of all patches by a tolerance or pixels. The tolerance is at least `min`, and `rounding` is subtracted.
pub(crate) fn cut_finely<S: PatchNetwork>(
    surface: &S,
    detail: &Detail,
    min: f64,
    rounding: f64,
) -> Result<SurfaceCells, Error> {
    let mut subdivider = AdaptiveSubdivider {
        detail,
        min,
        rounding,
        limit: surface.network().max_cells(),
        forecast: None,
        expected: 0.0,
        expected_max: 0.0,
        cells: Vec::new(),
        second_differences: SecondDifferences::default(),
        frame: Frame::default(),
    };
    check_cell_limit(surface, &mut subdivider)?;
    let ends = cut_patches(surface, &mut subdivider)?;
    Ok(SurfaceCells {
        cells: subdivider.cells,
        ends,
        full: DYADIC,
        has_tolerance: true,
    })
}

/// Appends the cells of all patches; returns where those of each patch end.
fn cut_patches<S: PatchNetwork>(
    surface: &S,
    subdivider: &mut AdaptiveSubdivider,
) -> Result<Vec<usize>, Error> {
    #[cfg(feature = "rayon")]
    if has_cores() {
        return cut_on_all_cores(surface, subdivider);
    }
    let mut ends = Vec::with_capacity(surface.network().patch_count());
    for patch in surface.patches() {
        subdivider.cut(&patch)?;
        ends.push(subdivider.cells.len());
    }
    Ok(ends)
}

/// Some patches at a time, each with a subdivider of its own; no more patches once the limit is exceeded.
#[cfg(feature = "rayon")]
fn cut_on_all_cores<S: PatchNetwork>(
    surface: &S,
    subdivider: &mut AdaptiveSubdivider,
) -> Result<Vec<usize>, Error> {
    let patches: Vec<S::Patch> = surface.patches().collect();
    let total = AtomicUsize::new(0);
    let mut ends = Vec::with_capacity(patches.len());
    for batch in patches.chunks(PATCHES_AT_ONCE) {
        // Each part may have as many cells as all parts together; the sum is checked before each part and after the
        // batch.
        let empty = &*subdivider;
        let parts = map_patches(batch.len(), |k| {
            if total.load(Relaxed) > empty.limit {
                return Err(empty.too_many());
            }
            let mut part = empty.without_cells();
            part.cut(&batch[k])?;
            total.fetch_add(part.cells.len(), Relaxed);
            Ok(part.cells)
        });
        for cells in parts {
            subdivider.cells.extend(cells?);
            ends.push(subdivider.cells.len());
        }
        if subdivider.cells.len() > subdivider.limit {
            return Err(subdivider.too_many());
        }
    }
    Ok(ends)
}

/// Returns an error if more cells than the limit are expected, before any are made.
fn check_cell_limit<S: PatchNetwork>(
    surface: &S,
    subdivider: &mut AdaptiveSubdivider,
) -> Result<(), Error> {
    let limit = subdivider.limit as f64;
    for depth in FORECAST_DEPTHS {
        forecast(surface, subdivider, depth)?;
        if subdivider.expected <= limit {
            break;
        }
    }
    if subdivider.expected > limit {
        return Err(subdivider.too_many());
    }
    // Halvings do not end exactly at the tolerance, so there will be more cells than the minimum. `expected_max`
    // falls with the depth, because the second derivatives have smaller maxima on smaller pieces.
    let mut before = f64::INFINITY;
    for depth in CLOSE_FORECAST_DEPTHS {
        if subdivider.expected_max <= limit {
            break;
        }
        before = subdivider.expected_max;
        forecast(surface, subdivider, depth)?;
    }
    let [cells, before] = [subdivider.expected_max, before].map(|cells| cells * CLOSE_SHARE);
    if cells > limit && cells >= before * CLOSE_SHARE {
        subdivider.expected = subdivider.expected_max;
        return Err(subdivider.too_many());
    }
    subdivider.forecast = None;
    Ok(())
}

/// Counts the cells that are expected from the pieces of this depth.
fn forecast<S: PatchNetwork>(
    surface: &S,
    subdivider: &mut AdaptiveSubdivider,
    depth: u32,
) -> Result<(), Error> {
    subdivider.forecast = Some(depth);
    (subdivider.expected, subdivider.expected_max) = (0.0, 0.0);
    for patch in surface.patches() {
        subdivider.cut(&patch)?;
    }
    Ok(())
}

impl Surface {
    /// The maximum number of cells of a mesh by tolerance: fewer for degrees at which the subdivision would take long.
    fn max_cells(&self) -> usize {
        (0..self.patch_count())
            .filter_map(|patch| self.degrees(patch))
            .map(|[m, n]| cell_limit(m, n))
            .fold(MAX_CUT_CELLS, usize::min)
    }

    /// Cells of equal size; an edge between patches with different numbers of segments gets the samples of both.
    pub(crate) fn cut_evenly(&self, grid: Grid) -> Result<SurfaceCells, Error> {
        grid.check(self.patch_count())?;
        let per_patch = grid.segments_u * grid.segments_v;
        let count = self.patch_count() * per_patch;
        if count > MAX_CELLS {
            return Err(Error::too_many("triangles", 2 * MAX_CELLS, 2 * count));
        }
        let (segments_u, segments_v) = (to_u32(grid.segments_u), to_u32(grid.segments_v));
        // The least common multiple, of which both numbers are factors. It does not overflow u32, since the number of
        // vertices of the grid is limited.
        let full = segments_u / divisor(segments_u, segments_v) * segments_v;
        let (du, dv) = (full / segments_u, full / segments_v);
        let grid_cells = || {
            (0..segments_v).flat_map(move |iv| {
                let cell = move |iu| Cell {
                    u: iu * du,
                    v: iv * dv,
                    du,
                    dv,
                };
                (0..segments_u).map(cell)
            })
        };
        let cells: Vec<Cell> = (0..self.patch_count()).flat_map(|_| grid_cells()).collect();
        Ok(SurfaceCells {
            cells,
            ends: (1..=self.patch_count()).map(|k| k * per_patch).collect(),
            full,
            has_tolerance: false,
        })
    }
}

/// The greatest common divisor (Euclidean algorithm).
fn divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { divisor(b, a % b) }
}
