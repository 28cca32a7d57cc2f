//! Checks of the regions of paths: Boolean operations, faces, cuts.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::path::{BooleanOperation, FillRule};
use casteljau::{Error, Path};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Path::union", |case| operation(case, Path::union)),
    ("Path::intersect", |case| operation(case, Path::intersect)),
    ("Path::subtract", |case| operation(case, Path::subtract)),
    ("Path::exclude", |case| operation(case, Path::exclude)),
    ("Path::combine", combine),
    ("Path::remove_overlaps", remove_overlaps),
    ("Path::faces", faces),
    ("Path::divide", divide),
    ("Path::clip", clip),
    ("Path::filled_area", filled_area),
    ("Path::filled_moments", filled_moments),
];

fn rule(case: &Case) -> FillRule {
    match word(case, "rule") {
        "evenodd" => FillRule::EvenOdd,
        _ => FillRule::NonZero,
    }
}

/// A region has closed contours within the box of its paths.
fn is_region(region: &Path, paths: &[&Path]) -> Checked {
    let closed = region.subpaths().all(|spline| spline.is_closed());
    ensure!(closed, "a contour is open");
    is_within(region, paths)
}

/// All control points of joints are within the box of the paths, widened by ε.
fn is_within(result: &Path, paths: &[&Path]) -> Checked {
    let boxes = paths.iter().filter_map(|path| path.control_bounds());
    let Some(all) = boxes.reduce(|a, b| a.union(b)) else {
        ensure!(result.is_empty(), "a region of nothing");
        return Ok(());
    };
    let largest = all.min.abs().max(all.max.abs()).max_element();
    let margin = 4e-9 * largest + f64::MIN_POSITIVE;
    let ends = result.segments().map(|curve| curve.start());
    let is_inside = |p: casteljau::glam::DVec2| {
        (p - (all.min - margin)).min_element() >= 0.0
            && ((all.max + margin) - p).min_element() >= 0.0
    };
    ensure!(
        !margin.is_finite() || ends.clone().all(is_inside),
        "a point outside of the box"
    );
    Ok(())
}

fn operation(case: &Case, apply: fn(&Path, &Path, FillRule) -> Result<Path, Error>) -> Checked {
    let (a, b) = (path(case, "path"), path(case, "other"));
    let region = answer!(case, apply(&a, &b, rule(case)));
    is_region(&region, &[&a, &b])
}

fn combine(case: &Case) -> Checked {
    let (a, b) = (path(case, "path"), path(case, "other"));
    let paths = [&a, &b, &a];
    let combined = answer!(
        case,
        Path::combine(paths, BooleanOperation::Exclude, rule(case))
    );
    is_region(&combined, &paths)
}

fn remove_overlaps(case: &Case) -> Checked {
    let path = path(case, "path");
    let region = answer!(case, path.remove_overlaps(rule(case)));
    is_region(&region, &[&path])
}

fn faces(case: &Case) -> Checked {
    let paths = [path(case, "path"), path(case, "other")];
    let faces = answer!(case, Path::faces(&paths, rule(case)));
    for face in &faces {
        ensure!(face.inside.len() == 2, "not one answer for each path");
        is_region(&face.path, &[&paths[0], &paths[1]])?;
    }
    Ok(())
}

fn divide(case: &Case) -> Checked {
    let (a, b) = (path(case, "path"), path(case, "other"));
    for part in answer!(case, a.divide(&b, rule(case))) {
        is_region(&part, &[&a, &b])?;
    }
    Ok(())
}

fn clip(case: &Case) -> Checked {
    let (a, b) = (path(case, "path"), path(case, "other"));
    let clipped = answer!(case, a.clip(&b, rule(case)));
    // The ends of parts are those of vertices, whose distances depend on the size of both paths.
    is_within(&clipped, &[&a, &b])
}

fn filled_area(case: &Case) -> Checked {
    let path = path(case, "path");
    let area = answer!(case, path.filled_area(rule(case)));
    let size = path
        .control_bounds()
        .map_or(0.0, |bounds| bounds.diagonal());
    ensure!(area >= 0.0, "the area {area} is negative");
    let region = path
        .remove_overlaps(rule(case))
        .map_err(|error| error.to_string())?;
    // The contours may cross by rounding.
    let signed = region.area();
    ensure!(
        signed >= -1e-9 * size * size,
        "the signed area {signed} is negative"
    );
    Ok(())
}

fn filled_moments(case: &Case) -> Checked {
    let path = path(case, "path");
    let moments = answer!(case, path.filled_moments(rule(case)));
    let area = path
        .filled_area(rule(case))
        .map_err(|error| error.to_string())?;
    let size = path
        .control_bounds()
        .map_or(0.0, |bounds| bounds.diagonal());
    let apart = (moments.area - area).abs();
    ensure!(
        apart.is_nan() || apart <= size * (1e-12 * size + 1e-14 * case.size()),
        "the areas differ by {apart:e}"
    );
    Ok(())
}
