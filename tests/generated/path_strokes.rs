//! Checks of strokes, dashes, offsets and rounded corners of paths.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{OffsetOptions, StrokeCap, StrokeOptions};
use casteljau::spline::OffsetJoin;
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Path::stroke", stroke),
    ("Path::stroke_contains", stroke_contains),
    ("Path::dash", dash),
    ("Path::offset", offset),
    ("Path::round_corners", round_corners),
];

/// What may be refused: negative widths, and results that are too large or cannot be resolved.
const REFUSALS: [&str; 10] = [
    "width",
    "distance",
    "radius",
    "tolerance",
    "steps of an offset",
    "segments",
    "contacts",
    "dashes",
    "pattern",
    "sum of the pattern",
];

fn join(case: &Case) -> OffsetJoin {
    match word(case, "join") {
        "round" => OffsetJoin::Round,
        "miter" => OffsetJoin::Miter,
        _ => OffsetJoin::Bevel,
    }
}

/// Caps follow the joins, so that all kinds occur.
fn options(case: &Case, tolerance: Option<f64>) -> StrokeOptions {
    StrokeOptions {
        join: join(case),
        cap: match join(case) {
            OffsetJoin::Round => StrokeCap::Round,
            OffsetJoin::Miter => StrokeCap::Square,
            OffsetJoin::Bevel => StrokeCap::Butt,
        },
        tolerance,
        ..StrokeOptions::default()
    }
}

fn is_region(region: &Path) -> Checked {
    let closed = region.subpaths().all(|spline| spline.is_closed());
    ensure!(closed, "a contour is open");
    let finite = region
        .segments()
        .all(|curve| curve.control_points().iter().all(|p| p.is_finite()));
    ensure!(finite, "a point is not finite");
    Ok(())
}

fn stroke(case: &Case) -> Checked {
    let (path, width) = (path(case, "path"), number(case, "width"));
    let options = options(case, optional(case, "tolerance"));
    let region = answer!(case, path.stroke(width, &options), &REFUSALS);
    is_region(&region)?;
    let options = StrokeOptions {
        simple: false,
        ..options
    };
    let outlines = answer!(case, path.stroke(width, &options), &REFUSALS);
    is_region(&outlines)
}

/// A point on the path is in a stroke with round joins and caps.
fn stroke_contains(case: &Case) -> Checked {
    let (path, width) = (path(case, "path"), number(case, "width"));
    let p: DVec2 = point(case, "p");
    let options = options(case, None);
    let inside = answer!(case, path.stroke_contains(p, width, &options), &REFUSALS);
    let nearest = path.nearest(p).map_err(|error| error.to_string())?;
    let distance = nearest.map_or(f64::INFINITY, |nearest| nearest.distance);
    let clear = (distance - 0.5 * width).abs() > slack(case.size(), crate::path::DEGREE);
    ensure!(
        !clear || options.join != OffsetJoin::Round || inside == (distance < 0.5 * width),
        "inside: {inside} at the distance {distance:e}, width {width:e}"
    );
    Ok(())
}

fn dash(case: &Case) -> Checked {
    let path = path(case, "path");
    let pattern = [number(case, "s"), number(case, "width")];
    let dashes = answer!(case, path.dash(&pattern, number(case, "offset")), &REFUSALS);
    let sum = |path: &Path| path.length(None).map_err(|error| error.to_string());
    let (whole, of_dashes) = (sum(&path)?, sum(&dashes)?);
    ensure!(
        of_dashes <= whole * (1.0 + 1e-9) + slack(case.size(), crate::path::DEGREE),
        "dashes of the length {of_dashes:e} on a path of the length {whole:e}"
    );
    Ok(())
}

fn offset(case: &Case) -> Checked {
    let (path, distance) = (path(case, "path"), number(case, "distance"));
    let options = OffsetOptions {
        join: join(case),
        tolerance: optional(case, "tolerance"),
        ..OffsetOptions::default()
    };
    let region = answer!(case, path.offset(distance, &options), &REFUSALS);
    is_region(&region)
}

/// The number of subpaths stays; the points are in the box of a polygon's corners, or near that of curves.
fn round_corners(case: &Case) -> Checked {
    let (path, radius) = (path(case, "path"), number(case, "radius"));
    let rounded = answer!(case, path.round_corners(radius), &REFUSALS);
    ensure!(
        rounded.subpath_count() == path.subpath_count(),
        "{} subpaths",
        rounded.subpath_count()
    );
    let (Some(own), Some(bounds)) = (rounded.control_bounds(), path.control_bounds()) else {
        return Ok(());
    };
    // An arc between lines is in the corner. One between curves may leave their hull, but its circle touches them.
    let is_polygon = path.segments().all(|curve| curve.degree() == 1);
    let reach = if is_polygon { 0.0 } else { 2.5 * radius };
    let slack = reach + slack(case.size(), crate::path::DEGREE);
    ensure!(
        (bounds.min - own.min).max_element() <= slack
            && (own.max - bounds.max).max_element() <= slack,
        "{own:?} is not in {bounds:?}"
    );
    Ok(())
}
