//! Area and moments of the region inside a path.

use super::{Path, Subpath};
use crate::curve::area::area_about;
use crate::curve::moments::{Moments, moments};
use glam::DVec2;

impl Path {
    /// The signed area inside: ½ ∫ (x dy − y dx), positive for subpaths that run counter-clockwise (x right, y up).
    ///
    /// Open subpaths are closed by a line. Each region counts with its winding number, so a hole that runs in the
    /// opposite direction is subtracted. Exact up to rounding, also far from the origin; infinite if the value
    /// overflows f64. The empty path has area 0.
    pub fn area(&self) -> f64 {
        let areas = self.parts().flat_map(|part| {
            let start = part.points[0]; // relative to the start, the closing line sweeps no area
            part.segments().map(move |points| area_about(points, start))
        });
        areas.fold(0.0, |sum, area| sum + area)
    }

    /// The integrals of 1, x, y, x², xy and y² over the inside, counted as in [`area`](Self::area).
    ///
    /// The centre of mass is (x, y) / area; x², xy and y² give the moments of inertia about the origin. Exact up to
    /// rounding; infinite if a value overflows f64. Source: as [`Curve::moments`](crate::Curve::moments).
    pub fn moments(&self) -> Moments {
        let unit = self.max_abs();
        let mut sum = Moments::default();
        if unit > 0.0 {
            self.parts()
                .for_each(|part| sum += moments_of_subpath(part, unit));
        }
        sum.enlarged(unit)
    }
}

/// The moments of one subpath in units of `unit`: first about its start, to avoid cancellation, then about the origin.
fn moments_of_subpath(part: Subpath<'_>, unit: f64) -> Moments {
    let start = part.points[0] / unit;
    let mut m = Moments::default();
    let mut around = Vec::new();
    for points in part.segments() {
        around.clear();
        around.extend(points.iter().map(|&p| p / unit - start));
        m += moments(&around);
    }
    let DVec2 { x, y } = start;
    Moments {
        area: m.area,
        x: m.x + x * m.area,
        y: m.y + y * m.area,
        xx: m.xx + x * (2.0 * m.x + x * m.area),
        xy: m.xy + x * m.y + y * (m.x + x * m.area),
        yy: m.yy + y * (2.0 * m.y + y * m.area),
    }
}
