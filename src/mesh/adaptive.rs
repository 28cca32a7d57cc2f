//! Crack-free tessellation of surfaces: by segments, tolerance or pixels.

use super::Mesh;
use super::buffers::to_f32;
use super::grid::Grid;
use super::options::{Detail, TessellationOptions};
use super::stitched_mesh::{SurfaceCells, stitch};
use super::subdivider::{
    AdaptiveSubdivider, CLOSE_FORECAST_DEPTHS, DYADIC, FORECAST_DEPTHS, cell_limit,
};
use crate::geometry::check::{check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::mesh::cell_triangulator::Cell;
use crate::mesh::second_differences::SecondDifferences;
use crate::numeric::order::to_u32;
use crate::patch::Patch;
use crate::surface::network::Surface;
use glam::DVec3;

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

/// A forecast of too many cells is accepted if this fraction of it exceeds the limit and if it is at least this
/// fraction of the previous forecast.
const CLOSE_SHARE: f64 = 7.0 / 8.0;

/// The smallest tolerance, in ulps of the largest coordinate.
const MIN_ULPS: f64 = 4.0;

/// The properties of a mesh's number type.
#[derive(Clone, Copy)]
struct Precision {
    /// The distance from 1 to the next larger number (`ulp`) and the smallest number above 0 (`tiny`).
    ulp: f64,
    tiny: f64,
    /// The largest number.
    max: f64,
    round: fn(DVec3) -> DVec3,
}

const SINGLE: Precision = Precision {
    ulp: f32::EPSILON as f64,
    tiny: f32::MIN_POSITIVE as f64 * f32::EPSILON as f64,
    max: f32::MAX as f64,
    round: |point| DVec3::from(point.to_array().map(|x| f64::from(to_f32(x)))),
};

const DOUBLE: Precision = Precision {
    ulp: f64::EPSILON,
    tiny: f64::MIN_POSITIVE * f64::EPSILON,
    max: f64::MAX,
    round: |point| point,
};

impl Surface {
    /// A mesh without cracks and T-junctions: every edge inside the surface belongs to exactly two triangles.
    ///
    /// With [`Detail::Tolerance`] no point of the surface is farther from the mesh than that distance: each patch is
    /// subdivided according to its second derivatives, and the error of rounding to f32 is subtracted from the
    /// tolerance first. Patches that share an edge share its vertices, even if they are subdivided differently. Normals
    /// are those of the patches, and limits at collapsed edges. Triangles with two coincident corners are omitted; a
    /// patch that is a curve or a point gives no triangles.
    ///
    /// Source of the bound: Filip, Magedson and Markot, CAGD 3 (1986).
    ///
    /// ```
    /// use casteljau::mesh::TessellationOptions;
    /// use casteljau::{Surface, TeapotOptions};
    ///
    /// let teapot = Surface::teapot(TeapotOptions::default());
    /// let mesh = teapot.tessellate(&TessellationOptions::tolerance(0.01))?;
    /// assert!(mesh.triangle_count() < 10_000);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, and for a tolerance or a number of pixels that is not above 0;
    /// [`Error::Tolerance`] for a tolerance below 4 ulps (of f32) of the largest coordinate; [`Error::NotFinite`] for a
    /// matrix with a NaN or an infinity; [`Error::TooMany`] when the mesh would take more than 1 GiB (half of that with
    /// 32-bit addresses, as in WebAssembly). By tolerance or pixels, the limit for a surface with patches of high
    /// degrees m and n may be lower: 2³¹ / ((m − 1)(n + 1) + mn + (m + 1)(n − 1)) triangles, about 1.2 million at
    /// degree 24, which take seconds. Most meshes that are too large are rejected by an estimate, before cells are
    /// made.
    pub fn tessellate(&self, options: &TessellationOptions) -> Result<Mesh, Error> {
        let mut mesh = Mesh::default();
        self.tessellate_with(SINGLE, options, &mut mesh)?;
        Ok(mesh.to_f32())
    }

    /// As [`tessellate`](Self::tessellate), with positions and normals in f64.
    ///
    /// # Errors
    /// As `tessellate`, with ulps of f64.
    pub fn tessellate_f64(&self, options: &TessellationOptions) -> Result<Mesh<f64>, Error> {
        let mut mesh = Mesh::default();
        self.tessellate_with(DOUBLE, options, &mut mesh)?;
        Ok(mesh)
    }

    fn tessellate_with(
        &self,
        precision: Precision,
        options: &TessellationOptions,
        mesh: &mut Mesh<f64>,
    ) -> Result<(), Error> {
        let cut = self.cut(precision, &options.detail)?;
        stitch(self, &cut, precision.round).weld(options.weld, mesh);
        Ok(())
    }

    /// The cells of all patches.
    fn cut(&self, precision: Precision, detail: &Detail) -> Result<SurfaceCells, Error> {
        let size = self.max_abs();
        if size > precision.max {
            return Err(Error::Range {
                what: "vertices",
                expected: "coordinates that f32 can hold, or the precision f64",
                got: size,
            });
        }
        // Rounding moves a vertex by half an ulp along each axis: by less than one ulp in total.
        let ulp = (precision.ulp * size).max(precision.tiny);
        match detail {
            Detail::Segments(grid) => return self.cut_evenly(*grid),
            Detail::Tolerance(tolerance) => check_min(*tolerance, MIN_ULPS * ulp)?,
            Detail::Pixels(view) => view.check()?,
        }
        self.cut_finely(detail, ulp)
    }

    fn cut_finely(&self, detail: &Detail, ulp: f64) -> Result<SurfaceCells, Error> {
        let mut subdivider = AdaptiveSubdivider {
            detail,
            min: MIN_ULPS * ulp,
            rounding: ulp,
            limit: self.max_cells(),
            forecast: None,
            expected: 0.0,
            expected_max: 0.0,
            cells: Vec::new(),
            second_differences: SecondDifferences::default(),
            size: 0.0,
        };
        self.foresee(&mut subdivider)?;
        let mut ends = Vec::with_capacity(self.patch_count());
        for patch in self.patches() {
            subdivider.cut(&patch.points, patch.columns)?;
            ends.push(subdivider.cells.len());
        }
        Ok(SurfaceCells {
            cells: subdivider.cells,
            ends,
            full: DYADIC,
            has_tolerance: true,
        })
    }

    /// Returns an error if more cells than the limit are expected, before any are made.
    fn foresee(&self, subdivider: &mut AdaptiveSubdivider) -> Result<(), Error> {
        let limit = subdivider.limit as f64;
        for depth in FORECAST_DEPTHS {
            self.forecast(subdivider, depth)?;
            if subdivider.expected <= limit {
                break;
            }
        }
        if subdivider.expected > limit {
            return Err(subdivider.too_many());
        }
        // Halvings do not end exactly at the tolerance, so there will be more cells than the minimum.
        let mut before = f64::INFINITY;
        for depth in CLOSE_FORECAST_DEPTHS {
            if subdivider.expected_max <= limit {
                break;
            }
            before = subdivider.expected_max;
            self.forecast(subdivider, depth)?;
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
    fn forecast(&self, subdivider: &mut AdaptiveSubdivider, depth: u32) -> Result<(), Error> {
        subdivider.forecast = Some(depth);
        (subdivider.expected, subdivider.expected_max) = (0.0, 0.0);
        for patch in self.patches() {
            subdivider.cut(&patch.points, patch.columns)?;
        }
        Ok(())
    }

    /// The maximum number of cells of a mesh by tolerance: fewer for degrees at which the subdivision would take long.
    fn max_cells(&self) -> usize {
        (0..self.patch_count())
            .filter_map(|patch| self.degrees(patch))
            .map(|[m, n]| cell_limit(m, n))
            .fold(MAX_CUT_CELLS, usize::min)
    }

    /// Cells of equal size; an edge between patches with different numbers of segments gets the samples of both.
    fn cut_evenly(&self, grid: Grid) -> Result<SurfaceCells, Error> {
        grid.check(self.patch_count())?;
        let per_patch = grid.segments_u * grid.segments_v;
        let count = self.patch_count() * per_patch;
        if count > MAX_CELLS {
            return Err(Error::TooMany {
                what: "triangles",
                limit: 2 * MAX_CELLS,
                needed: 2 * count,
            });
        }
        let (segments_u, segments_v) = (to_u32(grid.segments_u), to_u32(grid.segments_v));
        // This does not overflow u32, since the number of vertices of the grid is limited.
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

    /// The largest absolute coordinate of the control points.
    fn max_abs(&self) -> f64 {
        self.control_bounds()
            .map_or(0.0, |b| max_abs(&[b.min, b.max]))
    }
}

impl Patch {
    /// A mesh of the patch; see [`Surface::tessellate`].
    ///
    /// # Errors
    /// As [`Surface::tessellate`].
    pub fn tessellate(&self, options: &TessellationOptions) -> Result<Mesh, Error> {
        self.as_surface().tessellate(options)
    }

    /// As [`tessellate`](Self::tessellate), with positions and normals in f64.
    ///
    /// # Errors
    /// As [`Surface::tessellate_f64`].
    pub fn tessellate_f64(&self, options: &TessellationOptions) -> Result<Mesh<f64>, Error> {
        self.as_surface().tessellate_f64(options)
    }
}

/// Returns an error for a tolerance that is not above 0 or below the precision of the mesh's number type.
fn check_min(tolerance: f64, min: f64) -> Result<(), Error> {
    check_tolerance(tolerance, 0.0)?;
    if tolerance < min {
        return Err(Error::Tolerance {
            min,
            got: tolerance,
        });
    }
    Ok(())
}

/// The greatest common divisor (Euclidean algorithm).
fn divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { divisor(b, a % b) }
}
