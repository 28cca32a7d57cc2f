//! Tight bounding boxes of patches and surfaces.

use super::minimum::{Objective, minimise};
use super::network::Surface;
use super::piece::PolynomialPiece;
use super::scaling::{Scaling, box_of};
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use crate::patch::Patch;
use glam::DVec3;

/// Smallest size of a scaling, as a fraction of a coordinate. A search distinguishes values that differ by 64 units of
/// rounding of its scaling's size; in a scaling of this size that is one unit of rounding of the coordinate.
const ROUNDING_SHARE: f64 = 1.0 / 64.0;

impl Patch {
    /// The smallest axis-aligned box that contains the patch.
    ///
    /// It is exact to rounding, about 1e-15 of the size along each axis. Each of its six faces is at the minimum or
    /// maximum of one coordinate, which is a polynomial over the unit square, found by branch and bound on its
    /// Bernstein coefficients. [`control_bounds`](Self::control_bounds) is cheaper and larger. For a patch that is a
    /// point, both corners are that point.
    ///
    /// Each face takes at most 2²³ steps (2²⁶ above degree 24), about one for each multiplication. If the search
    /// reaches this limit, the face is at the best local extremum found so far.
    pub fn bounds(&self) -> Bounds<DVec3> {
        bounds(std::slice::from_ref(self)).unwrap_or_else(|| self.control_bounds())
    }
}

impl Surface {
    /// The smallest axis-aligned box that contains the surface; `None` without patches. See [`Patch::bounds`].
    pub fn bounds(&self) -> Option<Bounds<DVec3>> {
        let patches: Vec<Patch> = self.patches().collect();
        bounds(&patches)
    }
}

fn bounds(patches: &[Patch]) -> Option<Bounds<DVec3>> {
    let control = box_of(patches)?;
    let mut bounds = control;
    for axis in 0..3 {
        let scaling = scaling_along(axis, control);
        let face = |sign: f64| {
            let wholes: Vec<PolynomialPiece> = (0..)
                .zip(patches)
                .map(|(k, patch)| coordinate(k, patch, &scaling, axis, sign))
                .collect();
            let coordinate = Coordinate {
                patches,
                axis,
                sign,
            };
            minimise(&wholes, &coordinate).map(|(min, _)| sign * min.value)
        };
        bounds.min = bounds.min.with_coordinate(axis, face(1.0)?);
        bounds.max = bounds.max.with_coordinate(axis, face(-1.0)?);
    }
    // Evaluation rounds; the box of the control points is exact.
    Some(Bounds {
        min: Point::max(bounds.min, control.min),
        max: Point::min(bounds.max, control.max),
    })
}

/// The scaling for one coordinate. Its size is that of the box along this axis, whatever the box's size along the other
/// axes, unless the coordinates have larger rounding errors than such a scaling resolves.
fn scaling_along(axis: usize, control: Bounds<DVec3>) -> Scaling {
    let scaling = Scaling::around(control);
    let [min, max, center] = [control.min, control.max, scaling.centre].map(|p| p.coordinate(axis));
    let size = (0.5 * (max - min)).max(center.abs() * ROUNDING_SHARE);
    // Below the lower limit the reciprocal is not finite.
    Scaling {
        size: size.max(f64::MIN_POSITIVE * 8.0).min(scaling.size),
        ..scaling
    }
}

/// One coordinate of patches, multiplied by the sign 1 or −1.
struct Coordinate<'a> {
    patches: &'a [Patch],
    axis: usize,
    sign: f64,
}

impl Objective for Coordinate<'_> {
    fn value(&self, index: usize, [u, v]: [f64; 2]) -> f64 {
        self.sign * self.patches[index].eval(u, v).coordinate(self.axis)
    }
}

/// The Bernstein coefficients of one coordinate of a patch, multiplied by the sign 1 or −1.
fn coordinate(
    index: usize,
    patch: &Patch,
    scaling: &Scaling,
    axis: usize,
    sign: f64,
) -> PolynomialPiece {
    let coefficients = patch
        .points
        .iter()
        .map(|&p| sign * scaling.local_point(p).coordinate(axis))
        .collect();
    PolynomialPiece::whole(index, patch.columns, patch.rows(), coefficients)
}
