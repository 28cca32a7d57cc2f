//! Crack-free tessellation of surfaces: by segments, tolerance or pixels.

use super::Mesh;
use super::buffers::to_f32;
use super::cut::{SurfaceCells, cut_finely};
use super::mesh_patch::PatchNetwork;
use super::options::{Detail, TessellationOptions};
use super::stitched_mesh::stitch;
use crate::geometry::check::{check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::patch::Patch;
use crate::surface::network::Surface;
use glam::DVec3;

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
    /// A mesh without cracks and T-junctions: every edge inside the surface belongs to exactly two triangles, by the
    /// positions of its ends. With [`Weld::Position`](super::Weld::Position) it does so by their indices, too; otherwise
    /// vertices at creases are separate.
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
    /// let teapot = Surface::teapot(&TeapotOptions::default());
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
        tessellate(self, options)
    }

    /// As [`tessellate`](Self::tessellate), with positions and normals in f64.
    ///
    /// # Errors
    /// As `tessellate`, with ulps of f64.
    pub fn tessellate_f64(&self, options: &TessellationOptions) -> Result<Mesh<f64>, Error> {
        tessellate_f64(self, options)
    }

    /// The largest absolute coordinate of the control points.
    fn max_abs(&self) -> f64 {
        self.control_bounds()
            .map_or(0.0, |b| max_abs(&[b.min, b.max]))
    }
}

/// A mesh of a surface of any kind; see [`Surface::tessellate`].
pub(crate) fn tessellate(
    surface: &impl PatchNetwork,
    options: &TessellationOptions,
) -> Result<Mesh, Error> {
    Ok(tessellate_with(surface, SINGLE, options)?.to_f32())
}

/// As [`tessellate`], with positions and normals in f64.
pub(crate) fn tessellate_f64(
    surface: &impl PatchNetwork,
    options: &TessellationOptions,
) -> Result<Mesh<f64>, Error> {
    tessellate_with(surface, DOUBLE, options)
}

fn tessellate_with(
    surface: &impl PatchNetwork,
    precision: Precision,
    options: &TessellationOptions,
) -> Result<Mesh<f64>, Error> {
    let cut = cut(surface, precision, &options.detail)?;
    let mut mesh = Mesh::default();
    stitch(surface, &cut, precision.round).weld(options.weld, &mut mesh);
    Ok(mesh)
}

/// The cells of all patches.
fn cut(
    surface: &impl PatchNetwork,
    precision: Precision,
    detail: &Detail,
) -> Result<SurfaceCells, Error> {
    let size = surface.network().max_abs();
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
        Detail::Segments(grid) => return surface.network().cut_evenly(*grid),
        Detail::Tolerance(tolerance) => check_min(*tolerance, MIN_ULPS * ulp)?,
        Detail::Pixels(view) => view.check()?,
    }
    cut_finely(surface, detail, MIN_ULPS * ulp, ulp)
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
