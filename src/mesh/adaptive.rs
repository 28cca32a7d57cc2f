//! Meshes without cracks, as fine as asked for.

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
use crate::patch::Patch;
use crate::surface::network::Surface;
use casteljau_kernels::{Cell, SecondDifferences};
use glam::DVec3;

/// The most cells of one mesh: each makes two triangles of three indices and, nearly, one vertex of nine numbers, in
/// 1 GiB. Half as many where addresses have 32 bits: while it is made, a mesh takes some 350 bytes a cell.
const MAX_CELLS: usize =
    (1 << if cfg!(target_pointer_width = "32") {
        29
    } else {
        30
    }) / ((6 + 9) * 4);

/// The most cells of a mesh by tolerance or pixels. On thin patches nearly every cell has vertices of its own, and a mesh in the
/// making takes some 3 kB a cell, of the 4 GiB that addresses of 32 bits allow.
const MAX_CUT_CELLS: usize = if cfg!(target_pointer_width = "32") {
    1 << 20
} else {
    MAX_CELLS
};

/// A forecast of too many cells is believed if this share of it is too many, and if it is no less than this share of the
/// forecast before.
const CLOSE_SHARE: f64 = 7.0 / 8.0;

/// The least tolerance is four ulps of the largest coordinate.
const MIN_ULPS: f64 = 4.0;

/// A mesh's type of numbers.
#[derive(Clone, Copy)]
struct Precision {
    /// The distance of 1 from the next larger number, and the least number above 0.
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
    /// A mesh without cracks and T-junctions: every edge inside of the surface has exactly two triangles.
    ///
    /// With [`Detail::Tolerance`] no point of the surface is farther from the mesh than that distance: each patch is cut
    /// where its second derivatives say so, and rounding to f32 takes its share first. Patches that share a side share
    /// its vertices, whatever each needs. Normals are those of the patches, limits where a side has collapsed. Triangles
    /// with two corners at one place are left out; a patch that is a curve or a point gives none.
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
    /// [`Error::Range`] for 0 segments, a tolerance or a number of pixels that is not above 0; [`Error::Tolerance`] for
    /// one below 4 ulps (of f32) of the largest coordinate; [`Error::NotFinite`] for a matrix; [`Error::TooMany`] when the
    /// mesh would take more than 1 GiB (half of that where addresses have 32 bits, as in WebAssembly). By tolerance or
    /// pixels, a surface with patches of high degrees m and n may have fewer triangles: 2³¹ / ((m − 1)(n + 1) + mn +
    /// (m + 1)(n − 1)), some 1.2 million at degree 24, which take seconds. Most meshes that are too large are refused
    /// by an estimate, before cells are made.
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
        // Half an ulp along each axis is what rounding moves a vertex: less than one ulp in all.
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

    /// Refuses more cells than the limit before any are made.
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
        // Halvings do not end exactly at the tolerance, so there will be more cells than are needed at least.
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

    /// Counts the cells that pieces of this depth let expect.
    fn forecast(&self, subdivider: &mut AdaptiveSubdivider, depth: u32) -> Result<(), Error> {
        subdivider.forecast = Some(depth);
        (subdivider.expected, subdivider.expected_max) = (0.0, 0.0);
        for patch in self.patches() {
            subdivider.cut(&patch.points, patch.columns)?;
        }
        Ok(())
    }

    /// The most cells of a mesh by tolerance: fewer at degrees at which cutting would take long.
    fn max_cells(&self) -> usize {
        (0..self.patch_count())
            .filter_map(|patch| self.degrees(patch))
            .map(|[m, n]| cell_limit(m, n))
            .fold(MAX_CUT_CELLS, usize::min)
    }

    /// Cells of the same size; where a side with more segments meets one with fewer, it gets the samples of both.
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
        let common = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        let (segments_u, segments_v) = (common(grid.segments_u), common(grid.segments_v));
        // Within u32: the grid's vertices were counted.
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
    /// As there.
    pub fn tessellate(&self, options: &TessellationOptions) -> Result<Mesh, Error> {
        self.as_surface().tessellate(options)
    }

    /// As [`tessellate`](Self::tessellate), with positions and normals in f64.
    ///
    /// # Errors
    /// As there.
    pub fn tessellate_f64(&self, options: &TessellationOptions) -> Result<Mesh<f64>, Error> {
        self.as_surface().tessellate_f64(options)
    }
}

/// Refuses a tolerance that is not above 0, or that the mesh's numbers cannot keep.
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

/// The greatest common divisor (Euclid).
fn divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { divisor(b, a % b) }
}
