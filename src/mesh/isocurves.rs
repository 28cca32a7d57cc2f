//! Isocurves of a surface: curves of constant u and of constant v.

use super::mesh_patch::{MeshPatch, PatchNetwork};
use super::projected::Projection;
use crate::curve::Curve;
use crate::curve::eval::MAX_OUTPUT_F64;
use crate::curve::trace::PathSink;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::numeric::float::ratio;
use crate::surface::network::Surface;
use crate::surface::topology::SIDES;
use glam::{DMat4, DVec3};

/// The default tolerance of drawn lines in pixels, below what a screen shows.
const TOLERANCE_PX: f64 = 0.1;

/// An isocurve of a patch.
pub(crate) struct Isocurve<'a, P: MeshPatch> {
    pub(crate) patch_number: usize,
    pub(crate) patch: &'a P,
    /// Whether u is constant along the curve; otherwise v is.
    pub(crate) constant_u: bool,
    /// The constant parameter.
    pub(crate) at: f64,
    pub(crate) curve: P::Isocurve,
}

impl Surface {
    /// The isocurves that divide every patch into `lines` strips in each direction: at u and v = k / `lines`, edges
    /// included.
    ///
    /// An edge that patches share is included once; an edge that is a point is omitted (see
    /// [`topology`](Self::topology)). Each patch contributes first its curves of constant u, then those of constant v.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 lines, [`Error::TooMany`] above 1 GiB of numbers.
    pub fn isocurves(&self, lines: usize) -> Result<Vec<Curve<DVec3>>, Error> {
        isocurves(self, lines)
    }

    /// Draws the [`isocurves`](Self::isocurves), projected to a canvas by `matrix`.
    ///
    /// `matrix` maps (x, y, z, 1) to (X, Y, ·, W), which is drawn at (X/W, Y/W) in pixels. Where W is constant along a
    /// curve, as under every affine matrix, curves of degree 1 to 3 are drawn unchanged. Other curves are replaced by
    /// cubics within `tolerance` pixels (0.1 by default). The parts behind the eye, or nearer to it than a thousandth
    /// of the farthest vertex's W, are omitted, to within 1/4096 of a curve. The function only adds path segments; the
    /// caller strokes the path.
    ///
    /// # Errors
    /// As `isocurves`; [`Error::NotFinite`] for the matrix, [`Error::Range`] for the tolerance.
    pub fn trace_projected(
        &self,
        sink: &mut (impl PathSink + ?Sized),
        matrix: &DMat4,
        lines: usize,
        tolerance: Option<f64>,
    ) -> Result<(), Error> {
        trace_projected(self, sink, matrix, lines, tolerance)
    }

    /// Returns an error for 0 lines, and for more lines than the output limit allows.
    fn check_lines(&self, lines: usize) -> Result<(), Error> {
        if lines < 1 {
            return Err(Error::Range {
                what: "lines",
                expected: "a whole number from 1",
                got: 0.0,
            });
        }
        let per_line: usize = (0..self.patch_count())
            .filter_map(|patch| self.degrees(patch))
            .map(|[degree_u, degree_v]| 3 * (degree_u + degree_v + 2))
            .sum();
        let limit = (MAX_OUTPUT_F64 / per_line.max(1)).saturating_sub(1);
        if lines > limit {
            return Err(Error::too_many("lines", limit, lines));
        }
        Ok(())
    }
}

/// The isocurves of a surface; see [`Surface::isocurves`].
pub(crate) fn isocurves<S: PatchNetwork>(
    surface: &S,
    lines: usize,
) -> Result<Vec<<S::Patch as MeshPatch>::Isocurve>, Error> {
    let mut curves = Vec::new();
    each_isocurve(surface, lines, &mut |line| curves.push(line.curve))?;
    Ok(curves)
}

/// Draws isocurves, projected to a canvas; see [`Surface::trace_projected`].
pub(crate) fn trace_projected(
    surface: &impl PatchNetwork,
    sink: &mut (impl PathSink + ?Sized),
    matrix: &DMat4,
    lines: usize,
    tolerance: Option<f64>,
) -> Result<(), Error> {
    if let Some(tolerance) = tolerance {
        check_tolerance(tolerance, 0.0)?;
    }
    Error::unless_finite("matrix", &matrix.to_cols_array())?;
    let tolerance = tolerance.unwrap_or(TOLERANCE_PX);
    let projection = Projection::new(matrix, surface.network().vertices(), tolerance);
    each_isocurve(surface, lines, &mut |line| {
        projection.draw(&line.curve, sink)
    })
}

/// Passes each isocurve to `draw`. The closure is a trait object, so that the loop is compiled once.
pub(crate) fn each_isocurve<S: PatchNetwork>(
    surface: &S,
    lines: usize,
    draw: &mut dyn FnMut(Isocurve<'_, S::Patch>),
) -> Result<(), Error> {
    surface.network().check_lines(lines)?;
    let uses = surface.side_uses();
    for (patch_number, patch) in surface.patches().enumerate() {
        // An edge that is a point, or that an earlier patch has drawn, is omitted.
        let [u0, u1, v0, v1] = [0, 1, 2, 3].map(|side| {
            let number = SIDES * patch_number + side;
            uses[number].first == number && !uses[number].collapsed
        });
        let wanted = |k: usize, first: bool, last: bool| (k > 0 || first) && (k < lines || last);
        for (constant_u, first, last) in [(true, u0, u1), (false, v0, v1)] {
            for k in (0..=lines).filter(|&k| wanted(k, first, last)) {
                let at = ratio(k, lines);
                let curve = patch.isocurve(constant_u, at);
                draw(Isocurve {
                    patch_number,
                    patch: &patch,
                    constant_u,
                    at,
                    curve,
                });
            }
        }
    }
    Ok(())
}
