//! Wireframe meshes: tubes or ribbons along the isocurves of a surface.

use super::isocurves::each_isocurve;
use super::mesh_patch::PatchNetwork;
use super::sweep::{CrossSection, Sweep};
use super::tracer::Tracer;
use super::wire::{Wire, WireframeOptions};
use super::{Indices, Mesh, PatchRange};
use crate::geometry::error::Error;
use crate::numeric::float::as_f64;
use crate::surface::network::Surface;

/// The maximum number of vertices in 1 GiB: each has three position and three normal coordinates and almost two
/// triangles of three indices, four bytes each.
const MAX_VERTICES: u32 = (1 << 30) / ((3 + 3 + 6) * 4);

impl Surface {
    /// A mesh of the [`isocurves`](Self::isocurves): tubes, or ribbons that lie in the surface.
    ///
    /// The mesh follows a line as closely as a tube's cross-section approximates its circle: within r (1 − cos(π /
    /// sides)), and with at most 2π / sides of turning between two samples. (A ribbon follows it as closely as a tube
    /// with eight sides and a radius of half the ribbon's width.) Where a line turns back within that distance, at a
    /// cusp, it ends and starts again. Tubes are closed bodies with hemispherical ends, so that they join where lines
    /// cross and patches end; their cross-sections do not twist about the line (rotation-minimizing frames by double
    /// reflection). Ribbons have the surface's normals and are one-sided, on the side of ∂u × ∂v. A line that is a
    /// point is omitted. `uvs` and `patch_ids` are empty; `patch_ranges` contains the range of each patch.
    ///
    /// Source of the frames: Wang, Jüttler, Zheng and Liu, "Computation of rotation minimizing frames", ACM
    /// Transactions on Graphics 27 (2008).
    ///
    /// ```
    /// use casteljau::mesh::{Wire, WireframeOptions};
    /// use casteljau::{Surface, TeapotOptions};
    ///
    /// let teapot = Surface::teapot(&TeapotOptions::default());
    /// let wire = Wire::Ribbon { width: 0.05 };
    /// let mesh = teapot.wireframe(&WireframeOptions::new().wire(wire))?;
    /// assert!(mesh.triangle_count() > 2 * 260);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for 0 lines, fewer than 3 sides, and a radius or a width that is not above 0;
    /// [`Error::TooSmall`] for a radius or a width too small for the precision of f32; [`Error::TooMany`] above 1 GiB.
    pub fn wireframe(&self, options: &WireframeOptions) -> Result<Mesh, Error> {
        wireframe(self, options)
    }

    /// Returns an error if the minimum number of vertices is above the limit, without examining the lines.
    fn check_min_count(&self, lines: usize, section: &CrossSection) -> Result<(), Error> {
        let inside = lines
            .saturating_sub(1)
            .saturating_mul(2 * self.patch_count());
        let needed = inside.saturating_mul(section.min_vertices());
        if needed > MAX_VERTICES as usize {
            Err(too_many(needed))
        } else {
            Ok(())
        }
    }
}

/// A mesh of isocurves; see [`Surface::wireframe`].
pub(crate) fn wireframe(
    surface: &impl PatchNetwork,
    options: &WireframeOptions,
) -> Result<Mesh, Error> {
    let section = options.wire.section()?;
    let tracer = Tracer::new(surface.network(), &options.wire)?;
    surface.network().check_min_count(options.lines, &section)?;
    // Vertices are counted first, so that nothing is allocated for a mesh that is too large.
    let mut sweep = Sweep::new(&section);
    let mut patch_ranges = vec![PatchRange::default(); surface.network().patch_count()];
    draw_wires(
        surface,
        options.lines,
        &tracer,
        &mut sweep,
        &mut patch_ranges,
    )?;
    let count = sweep.vertices as usize;
    if sweep.vertices > MAX_VERTICES {
        return Err(too_many(count));
    }
    let mut sweep = Sweep::writing(&section, count);
    draw_wires(
        surface,
        options.lines,
        &tracer,
        &mut sweep,
        &mut patch_ranges,
    )?;
    Ok(Mesh {
        positions: sweep.positions,
        normals: sweep.normals,
        indices: Indices::smallest(sweep.indices, count),
        patch_ranges,
        ..Mesh::default()
    })
}

fn draw_wires<S: PatchNetwork>(
    surface: &S,
    lines: usize,
    tracer: &Tracer,
    sweep: &mut Sweep<'_>,
    ranges: &mut [PatchRange],
) -> Result<(), Error> {
    ranges.fill(PatchRange::default());
    let mut outcome = Ok(());
    each_isocurve(surface, lines, &mut |line| {
        if outcome.is_ok() && sweep.vertices <= MAX_VERTICES {
            let (first_vertex, first_index) = (sweep.vertices, sweep.first_index());
            outcome = tracer.sweep_line(&line, sweep);
            let range = &mut ranges[line.patch_number];
            if range.vertices == 0 {
                (range.first_vertex, range.first_index) = (first_vertex, first_index);
            }
            range.vertices = sweep.vertices - range.first_vertex;
            range.indices = sweep.first_index() - range.first_index;
        }
    })?;
    outcome
}

fn too_many(needed: usize) -> Error {
    Error::too_many("vertices", MAX_VERTICES as usize, needed)
}

impl Wire {
    fn section(&self) -> Result<CrossSection, Error> {
        let (what, size) = self.size();
        if !(size > 0.0 && size < f64::INFINITY) {
            return Err(Error::Range {
                what,
                expected: "a finite number above 0",
                got: size,
            });
        }
        match *self {
            Self::Tube { sides, .. } if sides < 3 => Err(Error::Range {
                what: "sides",
                expected: "a whole number from 3",
                got: as_f64(sides),
            }),
            Self::Tube { sides, .. } if sides > MAX_VERTICES as usize => Err(too_many(sides)),
            Self::Tube { radius, sides } => Ok(CrossSection::tube(radius, sides)),
            Self::Ribbon { width } => Ok(CrossSection::ribbon(width)),
        }
    }

    /// The size and its name.
    pub(crate) fn size(&self) -> (&'static str, f64) {
        match *self {
            Self::Tube { radius, .. } => ("radius", radius),
            Self::Ribbon { width } => ("width", width),
        }
    }
}
