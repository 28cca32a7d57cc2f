//! Strokes of points, and contours that are too thin to be kept.

use super::options::{Pen, StrokeCap};
use super::outline::{add_cap, push_closed};
use super::section::{Disc, RIGHT};
use crate::path::Path;
use crate::path::winding::FillRule;
use crate::spline::Spline;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// A part of the stroke thinner than this part of half the width is an error of approximation.
const THIN_PART: f64 = 0.25;

/// Appends the stroke of a point: two caps back to back.
pub(super) fn push_dot(path: &mut Path, center: DVec2, tangent: DVec2, pen: &Pen) {
    let disc = Disc {
        center,
        tangent,
        radius: pen.radius,
        slope: 0.0,
        speed: 0.0,
    };
    match pen.cap {
        StrokeCap::Butt => {}
        StrokeCap::Square => {
            let (ahead, aside) = (tangent * pen.radius, tangent.perp() * pen.radius);
            let corners = [ahead - aside, ahead + aside, aside - ahead, -ahead - aside];
            path.push(&corners.map(|by| center + by), [1; 4], true);
        }
        StrokeCap::Round => {
            let mut dot = SplineBuilder::default();
            dot.start(disc.point(RIGHT));
            for sign in [1.0, -1.0] {
                add_cap(&mut dot, disc, sign, pen.cap, pen);
            }
            push_closed(path, dot);
        }
    }
}

/// Appends a disk.
pub(super) fn push_disk(path: &mut Path, center: DVec2, pen: &Pen) {
    let round = Pen {
        cap: StrokeCap::Round,
        ..*pen
    };
    push_dot(path, center, DVec2::X, &round);
}

/// The contours of a region without those that are thinner than the tolerance.
///
/// The mean thickness of a contour is 2 A/L for an area A and a length L. A contour with a small mean can still be thick
/// somewhere: a disc of that thickness is searched that touches it from inside.
pub(super) fn without_thin(region: &Path, pen: &Pen) -> Path {
    let keeps = |contour: &Spline<DVec2>| {
        let area = contour.area();
        let thin = if area < 0.0 {
            pen.tolerance
        } else {
            pen.tolerance.min(THIN_PART * pen.radius)
        };
        2.0 * area.abs() > thin * contour.length()
            || contains_disc(contour, 0.5 * thin * area.signum())
    };
    region.subpaths().filter(keeps).collect()
}

/// Whether a disc that touches a contour at one of some points, on its left for a positive radius, is found to be inside.
fn contains_disc(contour: &Spline<DVec2>, radius: f64) -> bool {
    let step = contour.segment_count().div_ceil(MAX_TOUCHED);
    let inside = Path::from(contour.clone());
    contour.segments().step_by(step).any(|curve| {
        let center = curve.eval(0.5) + curve.normal(0.5) * radius;
        let nearest = contour.nearest(center).map_or(0.0, |found| found.distance);
        nearest >= (1.0 - DISC_ROUNDING) * radius.abs()
            && inside.contains(center, FillRule::NonZero)
    })
}

/// The maximum number of segments at which a disc is tried.
const MAX_TOUCHED: usize = 64;

/// The part of its radius by which a disc may be outside of the contour: rounding, and the curvature at the point.
const DISC_ROUNDING: f64 = 1e-3;
