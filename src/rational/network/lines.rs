//! Isocurves of surfaces of rational patches.

use super::RationalSurface;
use crate::curve::flatten::Polyline;
use crate::curve::trace::PathSink;
use crate::geometry::error::Error;
use crate::mesh::isocurves::{isocurves, trace_projected};
use crate::mesh::mesh_patch::SpaceCurve;
use crate::mesh::wireframe::wireframe;
use crate::mesh::{Mesh, WireframeOptions};
use crate::rational::RationalCurve;
use glam::{DMat4, DVec3};

impl RationalSurface {
    /// The isocurves that divide every patch into `lines` strips in each direction; see
    /// [`Surface::isocurves`](crate::Surface::isocurves).
    ///
    /// # Errors
    /// As there.
    pub fn isocurves(&self, lines: usize) -> Result<Vec<RationalCurve<DVec3>>, Error> {
        isocurves(self, lines)
    }

    /// Draws the [`isocurves`](Self::isocurves), projected to a canvas by `matrix`; see
    /// [`Surface::trace_projected`](crate::Surface::trace_projected).
    ///
    /// Curves with different weights are replaced by cubics within `tolerance` pixels. Where weights differ, parts that are
    /// nearer to the eye than a thousandth of the farthest depth may be drawn, too.
    ///
    /// # Errors
    /// As there.
    pub fn trace_projected(
        &self,
        sink: &mut (impl PathSink + ?Sized),
        matrix: &DMat4,
        lines: usize,
        tolerance: Option<f64>,
    ) -> Result<(), Error> {
        trace_projected(self, sink, matrix, lines, tolerance)
    }

    /// A mesh of the [`isocurves`](Self::isocurves): tubes, or ribbons that lie in the surface; see
    /// [`Surface::wireframe`](crate::Surface::wireframe).
    ///
    /// # Errors
    /// As there.
    pub fn wireframe(&self, options: &WireframeOptions) -> Result<Mesh, Error> {
        wireframe(self, options)
    }
}

impl SpaceCurve for RationalCurve<DVec3> {
    fn eval(&self, t: f64) -> DVec3 {
        self.eval(t)
    }

    fn tangent(&self, t: f64) -> DVec3 {
        self.tangent(t)
    }

    fn flatten(&self, tolerance: f64) -> Result<Polyline<DVec3>, Error> {
        self.flatten(tolerance)
    }

    fn weighted_points(&self) -> impl Iterator<Item = (DVec3, f64)> {
        let min = self.weights().iter().copied().fold(f64::INFINITY, f64::min);
        let parts = self.control_points().iter().zip(self.weights());
        parts.map(move |(&p, w)| (p, w / min))
    }
}
