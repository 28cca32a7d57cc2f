//! Checks of paths: subpaths, measures, queries, regions, strokes.

use crate::check::*;
use crate::curves::are_moments;
use crate::geometry::*;
use crate::lines::{are_contacts, compares, follows};
use crate::shared::*;
use casteljau::curve::{Intersection, Moments};
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::*;
use casteljau::spline::Join;
use casteljau::{Error, Path, Spline};

/// The slack for points of splines of the largest degree that is generated.
fn slack_of() -> f64 {
    slack(size(), 12)
}

fn splines(path: &Path) -> Vec<Spline<DVec2>> {
    path.subpaths().collect()
}

fn diagonal(path: &Path) -> f64 {
    path.control_bounds().map_or(0.0, |all| all.diagonal())
}

/// A path of one subpath.
fn single(spline: &Spline<DVec2>) -> Path {
    Path::from(spline.clone())
}

pub(crate) fn accessors(path: Path) -> Checked {
    let (subpaths, segments) = call(|| (splines(&path), path.segments().collect::<Vec<_>>()))?;
    let curves: Vec<_> = subpaths.iter().flat_map(|spline| spline.curves()).collect();
    same(path.subpath_count(), subpaths.len(), "the subpaths")?;
    same(path.segment_count(), curves.len(), "the number of segments")?;
    same(segments, curves, "the segments")?;
    same(path.is_empty(), subpaths.is_empty(), "empty")?;
    same(Path::new(&subpaths), path, "the path of its subpaths")
}

pub(crate) fn subpath(path: Path, k: usize) -> Checked {
    let subpath = call(|| path.subpath(k))?;
    same(subpath.as_ref(), splines(&path).get(k), "the subpath")
}

pub(crate) fn approx_eq(path: Path, tolerance: f64) -> Checked {
    compares(Path::approx_eq, (&path, &path.reverse()), tolerance)
}

pub(crate) fn bounds(path: Path) -> Checked {
    let bounds = value!(path.bounds());
    same(bounds.is_some(), !path.is_empty(), "a box")?;
    for spline in path.subpaths() {
        for t in parameters(10 * spline.segment_count(), spline.last()) {
            let inside = bounds.is_some_and(|all| holds(&all, spline.eval(t), slack_of()));
            ensure!(inside, "the point at {t} is outside");
        }
    }
    let boxes = path.subpaths().map(|spline| spline.bounds());
    let corners = boxes.flat_map(|all| [all.min, all.max]);
    same(bounds, box_of(corners), "the box")
}

pub(crate) fn control_bounds(path: Path) -> Checked {
    let bounds = call(|| path.control_bounds())?;
    let splines = path.subpaths();
    let points = splines.flat_map(|spline| spline.control_points().to_vec());
    same(bounds, box_of(points), "the box of the control points")
}

pub(crate) fn length(path: Path, tolerance: Option<f64>) -> Checked {
    let length = match tolerance {
        None => value!(path.length()),
        Some(tolerance) => answer!(path.length_within(tolerance), "tolerance"),
    };
    let sum: f64 = path.subpaths().map(|spline| spline.length()).sum();
    let slack = 1e-11 * sum + slack_of() + tolerance.unwrap_or(0.0);
    near(length, sum, slack, "the sum of the subpaths")
}

pub(crate) fn time_at_length(path: Path, s: f64, tolerance: Option<f64>) -> Checked {
    let found = match tolerance {
        None => value!(path.time_at_length(s)),
        Some(tolerance) => answer!(path.time_at_length_within(s, tolerance), "tolerance"),
    };
    same(found.is_some(), !path.is_empty(), "a place")?;
    let Some(PathTime { subpath, t }) = found else {
        return Ok(());
    };
    let spline = path.subpath(subpath).ok_or("no such subpath")?;
    if s.is_nan() {
        return holds!(t.is_nan(), "t = {t} for NaN");
    }
    holds!((0.0..=spline.last()).contains(&t), "t = {t}")
}

pub(crate) fn equidistant_times(path: Path, segments: usize) -> Checked {
    let places = answer!(path.equidistant_times(segments), "segments");
    let expected = if path.is_empty() { 0 } else { segments + 1 };
    same(places.len(), expected, "the number of places")?;
    let places = places.iter().map(|place| (place.subpath, place.t));
    holds!(places.is_sorted(), "the places do not ascend")
}

pub(crate) fn area(path: Path) -> Checked {
    let area = value!(path.area());
    let slack = 64.0 * slack_of() * size();
    near(area, -path.reverse().area(), slack, "backwards")?;
    let sum: f64 = path.subpaths().map(|spline| single(&spline).area()).sum();
    let count = real(path.segment_count() + 1);
    near(area, sum, slack * count, "the sum of the subpaths")
}

pub(crate) fn moments(path: Path) -> Checked {
    let (moments, size) = (value!(path.moments()), size());
    let slack = 64.0 * slack_of() * size;
    near(moments.area, path.area(), slack, "the area")?;
    let mut sum = Moments::default();
    for spline in path.subpaths() {
        sum += single(&spline).moments();
    }
    are_moments(moments, sum, slack * real(path.segment_count() + 1), size)
}

pub(crate) fn flatten(path: Path, tolerance: f64) -> Checked {
    let lines = answer!(path.flatten(tolerance), "tolerance");
    same(lines.len(), path.subpath_count(), "the polylines")?;
    for (line, spline) in lines.iter().zip(path.subpaths()) {
        follows(&spline, (&line.ts, &line.points), tolerance)?;
    }
    Ok(())
}

pub(crate) fn simplify(path: Path, tolerance: f64) -> Checked {
    let simple = answer!(path.simplify(tolerance), "tolerance");
    let expected = path.subpaths().map(|spline| spline.simplify(tolerance));
    let expected = expected.collect::<Result<Vec<_>, _>>()?;
    same(splines(&simple), expected, "the subpaths")
}

pub(crate) fn transform(path: Path, map: DAffine2) -> Checked {
    let image = answer!(path.transform(&map), "image");
    let images = path.subpaths().map(|spline| spline.transform(&map));
    let images = images.collect::<Result<Vec<_>, _>>()?;
    same(splines(&image), images, "the images of the subpaths")
}

pub(crate) fn reverse(path: Path) -> Checked {
    let reversed = call(|| path.reverse())?;
    same(&reversed.reverse(), &path, "twice backwards")?;
    for (back, spline) in reversed.subpaths().zip(path.subpaths()) {
        let curves = spline.curves().into_iter().rev();
        let curves: Vec<_> = curves.map(|curve| curve.reverse()).collect();
        // A closed subpath starts where it ends.
        same(back.curves(), curves, "the segments backwards")?;
    }
    Ok(())
}

pub(crate) fn nearest(path: Path, p: DVec2) -> Checked {
    let nearest = answer!(path.nearest(p));
    same(nearest.is_some(), !path.is_empty(), "a place")?;
    let Some(nearest) = nearest else {
        return Ok(());
    };
    let slack = 16.0 * slack_of();
    let distance = nearest.point.distance(p);
    near(distance, nearest.distance, slack, "the distance")?;
    for (k, spline) in path.subpaths().enumerate() {
        let other = spline.nearest(p)?.distance;
        at_most(nearest.distance, other + slack, "another subpath is nearer")?;
        if k == nearest.subpath {
            near(spline.eval(nearest.t), nearest.point, slack, "at t")?;
        }
    }
    Ok(())
}

pub(crate) fn winding_number(path: Path, p: DVec2) -> Checked {
    let winding = value!(path.winding_number(p));
    let bounds = path.control_bounds();
    let outside = bounds.is_none_or(|bounds| !holds(&bounds, p, 0.0));
    ensure!(!outside || winding == 0, "{winding} outside of the box");
    // Reversing the path changes the sign of the winding number, unless the point is on the boundary.
    let away = path.nearest(p)?.map_or(1.0, |nearest| nearest.distance);
    let closed = path.subpaths().all(|spline| spline.is_closed());
    let back = path.reverse().winding_number(p);
    let unclear = !closed || away <= slack_of();
    holds!(unclear || back == -winding, "{winding}, back {back}")
}

pub(crate) fn contains(path: Path, p: DVec2, rule: FillRule) -> Checked {
    let inside = value!(path.contains(p, rule));
    let winding = path.winding_number(p);
    let modulus = if rule == FillRule::EvenOdd {
        2
    } else {
        i32::MAX
    };
    same(inside, winding % modulus != 0, "inside")
}

pub(crate) fn intersections(path: Path, other: Path) -> Checked {
    let found = value!(path.intersections(&other));
    have_contacts(&found, [&path, &other])
}

pub(crate) fn self_intersections(path: Path) -> Checked {
    let found = value!(path.self_intersections());
    have_contacts(&found, [&path, &path])
}

fn have_contacts(found: &[PathIntersection], paths: [&Path; 2]) -> Checked {
    let [subpaths, others] = paths.map(splines);
    for &PathIntersection {
        subpath,
        other_subpath,
        t,
        u,
        point,
        kind,
    } in found
    {
        let contact = Intersection { t, u, point, kind };
        are_contacts(&[contact], &subpaths[subpath], &others[other_subpath])?;
    }
    Ok(())
}

/// Checks that the contours are closed, and that the ends of all segments are within the box of the paths, widened by ε.
fn is_region(region: &Path, paths: &[&Path]) -> Checked {
    is_closed(region)?;
    is_within(region, paths)
}

pub(crate) fn is_closed(region: &Path) -> Checked {
    let closed = region.subpaths().all(|spline| spline.is_closed());
    holds!(closed, "a contour is open")
}

fn is_within(result: &Path, paths: &[&Path]) -> Checked {
    let boxes = paths.iter().filter_map(|path| path.control_bounds());
    let Some(all) = boxes.reduce(|a, b| a.union(b)) else {
        return same(result.is_empty(), true, "a region of nothing");
    };
    let margin = 4e-9 * largest(&[all.min, all.max]) + f64::MIN_POSITIVE;
    let mut ends = result.segments().map(|curve| curve.start());
    let inside = !margin.is_finite() || ends.all(|p| holds(&all, p, margin));
    holds!(inside, "a point outside of the box")
}

type Operation = fn(&Path, &Path, FillRule) -> Result<Path, Error>;

fn operation(paths: [&Path; 2], rule: FillRule, apply: Operation) -> Checked {
    let region = answer!(apply(paths[0], paths[1], rule));
    is_region(&region, &paths)
}

/// Defines checks of the operations of two regions.
macro_rules! operations {
    ($($name:ident)*) => {$(
        pub(crate) fn $name(path: Path, other: Path, rule: FillRule) -> Checked {
            operation([&path, &other], rule, Path::$name)
        }
    )*};
}

operations! { union intersect subtract exclude }

pub(crate) fn combine(path: Path, other: Path, rule: FillRule) -> Checked {
    let (paths, exclude) = ([&path, &other, &path], BooleanOperation::Exclude);
    let combined = answer!(Path::combine(paths, exclude, rule));
    is_region(&combined, &paths)
}

pub(crate) fn remove_overlaps(path: Path, rule: FillRule) -> Checked {
    let region = answer!(path.remove_overlaps(rule));
    is_region(&region, &[&path])
}

pub(crate) fn faces(path: Path, other: Path, rule: FillRule) -> Checked {
    for face in answer!(Path::faces([&path, &other], rule)) {
        same(face.inside.len(), 2, "the answers for each path")?;
        is_region(&face.path, &[&path, &other])?;
    }
    Ok(())
}

pub(crate) fn divide(path: Path, other: Path, rule: FillRule) -> Checked {
    let mut parts = answer!(path.divide(&other, rule)).into_iter();
    parts.try_for_each(|part| is_region(&part, &[&path, &other]))
}

pub(crate) fn clip(path: Path, other: Path, rule: FillRule) -> Checked {
    let clipped = answer!(path.clip(&other, rule));
    // The ends of parts are those of vertices, whose distances depend on the size of both paths.
    is_within(&clipped, &[&path, &other])
}

pub(crate) fn filled_area(path: Path, rule: FillRule) -> Checked {
    let area = answer!(path.filled_area(rule));
    ensure!(area >= 0.0, "the area {area} is negative");
    // The contours may cross by rounding.
    let signed = path.remove_overlaps(rule)?.area();
    at_most(-signed, 1e-9 * diagonal(&path).powi(2), "the signed area")
}

pub(crate) fn filled_moments(path: Path, rule: FillRule) -> Checked {
    let moments = answer!(path.filled_moments(rule));
    let (across, apart) = (diagonal(&path), moments.area - path.filled_area(rule)?);
    let slack = across * (1e-12 * across + 1e-14 * size());
    holds!(apart.is_nan() || apart.abs() <= slack, "{apart:e} apart")
}

/// What errors of strokes may name: negative widths, and results that are too large or cannot be resolved.
pub(crate) const REFUSALS: &str = "width|widths|left|right|distance|radius|tolerance|steps of an offset|steps of a stroke|segments|contacts|dashes|pattern|sum of the pattern";

/// The options of a stroke; caps follow the joins, so that all kinds occur.
fn options(join: Join, tolerance: Option<f64>) -> StrokeOptions {
    let cap = match join {
        Join::Round => StrokeCap::Round,
        Join::Miter => StrokeCap::Square,
        Join::Bevel => StrokeCap::Butt,
    };
    let mut options = StrokeOptions::new().join(join).cap(cap);
    options.tolerance = tolerance;
    options
}

/// Checks that contours are closed; `call` checks that their points are finite.
pub(crate) fn stroke(path: Path, width: f64, join: Join, tolerance: Option<f64>) -> Checked {
    let mut options = options(join, tolerance);
    let region = answer!(path.stroke(width, &options), REFUSALS);
    is_closed(&region)?;
    options.simple = false;
    let outlines = answer!(path.stroke(width, &options), REFUSALS);
    is_closed(&outlines)?;
    // Both kinds of positions occur, with different joins.
    let at = match join {
        Join::Miter => WidthPosition::Length,
        _ => WidthPosition::T,
    };
    let stops = [(0.0, 0.0), (0.4, width), (0.7, 0.2 * width), (1.0, width)];
    let interpolation = match join {
        Join::Bevel => WidthInterpolation::Smooth,
        _ => WidthInterpolation::Linear,
    };
    let profile = WidthProfile::new(&stops)
        .at(at)
        .interpolation(interpolation);
    is_closed(&answer!(path.stroke_with(&profile, &options), REFUSALS))
}

pub(crate) fn stroke_sides(
    path: Path,
    left: f64,
    right: f64,
    join: Join,
    tolerance: Option<f64>,
) -> Checked {
    let mut options = options(join, tolerance);
    let region = answer!(path.stroke_sides(left, right, &options), REFUSALS);
    is_closed(&region)?;
    options.simple = false;
    is_closed(&answer!(path.stroke_sides(left, right, &options), REFUSALS))
}

/// Checks that a stroke with round joins and caps contains the points near the path, and no others.
pub(crate) fn stroke_contains(path: Path, p: DVec2, width: f64, join: Join) -> Checked {
    let options = options(join, None);
    let inside = answer!(path.stroke_contains(p, width, &options), REFUSALS);
    let nearest = path.nearest(p)?;
    let distance = nearest.map_or(f64::INFINITY, |nearest| nearest.distance);
    let clear = (distance - 0.5 * width).abs() > slack_of();
    let fits = !clear || join != Join::Round || inside == (distance < 0.5 * width);
    holds!(fits, "{inside} at {distance:e}, width {width:e}")
}

pub(crate) fn dash(path: Path, s: f64, width: f64, offset: f64) -> Checked {
    let dashes = answer!(path.dash(&[s, width], offset), REFUSALS);
    let whole = path.length() * (1.0 + 1e-9) + slack_of();
    at_most(dashes.length(), whole, "the length of the dashes")
}

pub(crate) fn offset(path: Path, distance: f64, join: Join, tolerance: Option<f64>) -> Checked {
    let default = OffsetOptions::default();
    let mut options = default.join(join);
    options.tolerance = tolerance;
    let region = answer!(path.offset(distance, &options), REFUSALS);
    is_closed(&region)
}

/// Checks that the arcs join, end where the subpaths do, and are near them.
pub(crate) fn to_arcs(path: Path, tolerance: f64) -> Checked {
    let subpaths = answer!(path.to_arcs(tolerance), "tolerance");
    same(subpaths.len(), path.subpath_count(), "the lists")?;
    for (arcs, spline) in subpaths.iter().zip(path.subpaths()) {
        let ends = [arcs[0].start, arcs[arcs.len() - 1].end];
        same(
            ends,
            [spline.eval(0.0), spline.eval(spline.last())],
            "the ends",
        )?;
        for pair in arcs.windows(2) {
            let gap = pair[0].end.distance(pair[1].start);
            ensure!(gap <= slack_of(), "a gap of {gap}");
        }
        for arc in arcs.iter().step_by(1 + arcs.len() / 20) {
            let Some(center) = arc.center else {
                continue;
            };
            let angle = 0.5 * (arc.start_angle + arc.end_angle);
            let middle = center + DVec2::from_angle(angle) * arc.radius;
            let distance = spline.nearest(middle).map_or(0.0, |found| found.distance);
            let allowed = tolerance + slack_of() + 1e-12 * arc.radius;
            ensure!(distance <= allowed, "{distance} from the curve");
        }
    }
    Ok(())
}

/// Checks that the points are in the box of a polygon's corners, or near that of curves.
pub(crate) fn round_corners(path: Path, radius: f64) -> Checked {
    let rounded = answer!(path.round_corners(radius), REFUSALS);
    is_rounded(&path, &rounded, radius)
}

/// Radii from 0 to the size of the given one.
pub(crate) fn round_corners_by(path: Path, radius: f64) -> Checked {
    let (radius, mut corners) = (radius.abs(), Vec::new());
    let part = |corner: PathTime| {
        corners.push(corner);
        radius * (0.25 * corner.t).fract()
    };
    let rounded = answer!(path.round_corners_by(part, &CornerOptions::new()), REFUSALS);
    let places = corners.iter().map(|corner| (corner.subpath, corner.t));
    holds!(places.is_sorted(), "the corners are not in order")?;
    // A negative radius is refused where there is a corner.
    is_rounded(&path, &rounded, radius.abs())
}

fn is_rounded(path: &Path, rounded: &Path, radius: f64) -> Checked {
    same(rounded.subpath_count(), path.subpath_count(), "subpaths")?;
    let (Some(own), Some(bounds)) = (rounded.control_bounds(), path.control_bounds()) else {
        return Ok(());
    };
    // An arc between lines is in the corner. One between curves may leave their hull, but its circle touches them.
    let is_polygon = path.segments().all(|curve| curve.degree() == 1);
    let slack = slack_of() + if is_polygon { 0.0 } else { 2.5 * radius };
    let inside = holds(&bounds, own.min, slack) && holds(&bounds, own.max, slack);
    holds!(inside, "{own:?} is not in {bounds:?}")
}
