//! Checks of drawings: what curves, splines and paths draw and write, and offset curves.

use crate::check::*;
use crate::geometry::*;
use crate::recorder::Recorder;
use crate::shared::*;
use casteljau::glam::DVec2;
use casteljau::path::{PathBuilder, PathElement, SvgOptions};
use casteljau::spline::Join;
use casteljau::{Curve, Error, Path, Point, Spline};
use casteljau_generator::Mode;

/// Checks that subpaths of finite numbers are drawn, near the curves.
pub(crate) fn trace<D: Drawing>(drawing: D, tolerance: Option<f64>) -> Checked {
    let mut pen = Recorder::default();
    match tolerance {
        None => value!(drawing.trace(&mut pen)),
        Some(tolerance) => answer!(drawing.trace_within(&mut pen, tolerance), "tolerance"),
    }
    let path: Path = drawing.into();
    ensure!(!pen.is_bad, "numbers that are not finite");
    same(pen.subpaths.len(), path.subpath_count(), "the subpaths")?;
    // The default tolerance depends on the box of the whole drawing or of a segment; this requires the larger one.
    let diagonal = path.control_bounds().map_or(0.0, |all| all.diagonal());
    for (spline, (drawn, closed)) in path.subpaths().zip(&pen.subpaths) {
        same(*closed, spline.is_closed(), "closed")?;
        // The nearest points of all drawn curves take long for large paths.
        let checked = if path.segment_count() > 100 { 0 } else { 20 };
        for curve in spline.curves().iter().take(checked) {
            is_drawn(curve, drawn, tolerance.unwrap_or(1e-4 * diagonal))?;
        }
    }
    Ok(())
}

/// Checks that points of the curve lie within the tolerance of what was drawn; low degrees are drawn exactly.
fn is_drawn(curve: &Curve<DVec2>, drawn: &[Curve<DVec2>], tolerance: f64) -> Checked {
    let slack = 4.0 * curve.slack();
    let room = slack + if curve.degree() <= 3 { 0.0 } else { tolerance };
    for t in parameters(6, 1.0) {
        let nearest = |piece: &Curve<DVec2>| piece.nearest(curve.eval(t)).ok();
        let found = drawn.iter().filter_map(nearest);
        at_most(min(found.map(|found| found.distance)), room, t)?;
    }
    Ok(())
}

/// Checks that the output of `elements` is what `trace` draws.
pub(crate) fn elements(path: Path, tolerance: Option<f64>) -> Checked {
    let elements: Vec<PathElement> = match tolerance {
        None => value!(path.elements().collect()),
        Some(tolerance) => {
            let elements = || path.elements_within(tolerance).map(Iterator::collect);
            answer!(elements(), "tolerance")
        }
    };
    let mut traced = PathBuilder::new();
    match tolerance {
        None => path.trace(&mut traced),
        Some(tolerance) => path.trace_within(&mut traced, tolerance)?,
    }
    let built = Path::from_elements(elements);
    same(
        built,
        traced.build().map_err(Error::from),
        "the commands of trace",
    )
}

/// Checks that the text is read back as the same path, unless it was rounded or curves were approximated.
pub(crate) fn to_svg<D: Drawing>(
    drawing: D,
    precision: Option<u8>,
    tolerance: Option<f64>,
) -> Checked {
    let mut options = SvgOptions::new();
    (options.precision, options.tolerance) = (precision, tolerance);
    let text = answer!(drawing.to_svg_with(&options), "tolerance|precision");
    let (back, path): (_, Path) = (Path::from_svg(&text)?, drawing.into());
    let exact = precision.is_none() && path.segments().all(|curve| curve.degree() <= 3);
    holds!(
        !exact || is_read_back(&back, &path, &text),
        "another path from {text}"
    )
}

/// What errors of an offset may name.
const OFFSET_REFUSALS: &str = "tolerance|distance|steps of an offset";

pub(crate) fn curve_offset(curve: Curve<DVec2>, distance: f64, tolerance: Option<f64>) -> Checked {
    let offset = || match tolerance {
        None => curve.offset(distance),
        Some(tolerance) => curve.offset_within(distance, tolerance),
    };
    let spline = answer!(offset(), OFFSET_REFUSALS);
    is_offset(&curve, &spline, (distance, tolerance), distance.abs())
}

pub(crate) fn spline_offset(
    spline: Spline<DVec2>,
    distance: f64,
    tolerance: Option<f64>,
    join: Join,
) -> Checked {
    let offset = || match tolerance {
        None => spline.offset(distance, join),
        Some(tolerance) => spline.offset_within(distance, join, tolerance),
    };
    let offset = answer!(offset(), OFFSET_REFUSALS);
    let curves = spline.curves();
    let [curve] = curves.as_slice() else {
        return Ok(());
    };
    // The tip of a miter at the joint of a closed spline is up to four times the distance away.
    let farthest = if spline.is_closed() { 4.0 } else { 1.0 } * distance.abs();
    is_offset(curve, &offset, (distance, tolerance), farthest)
}

/// Checks that points of O(t) = B(t) + d·N(t) lie within the tolerance of the offset, and that the points of the offset
/// are at most `farthest` plus the tolerance from the curve.
fn is_offset(
    curve: &Curve<DVec2>,
    offset: &Spline<DVec2>,
    (d, tolerance): (f64, Option<f64>),
    farthest: f64,
) -> Checked {
    let is_point = curve.control_points().iter().all(|&p| p == curve.start());
    if mode() == Mode::MixedScale || is_point {
        return Ok(());
    }
    // The documented default.
    let default = 1e-4 * curve.control_bounds().diagonal();
    let tolerance = tolerance.unwrap_or(default.max(1e-12 * (size() + d.abs())));
    let slack = 16.0 * slack(size() + d.abs(), curve.degree());
    let speed = largest(curve.derivative().control_points());
    for t in parameters(7, 1.0) {
        // Where the speed is almost zero, rounding decides the normal.
        if curve.derivative_at(t, 1).max_abs() > 1e-6 * speed {
            let o = curve.eval(t) + curve.normal(t) * d;
            at_most(
                offset.nearest(o)?.distance,
                tolerance * (1.0 + 1e-9) + slack,
                t,
            )?;
        }
        let away = curve.nearest(offset.eval(t * offset.last()))?.distance;
        at_most(away, farthest + tolerance + slack, "far from the curve")?;
    }
    Ok(())
}
