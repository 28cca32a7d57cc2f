//! Checks of paths.

use crate::arguments::*;
use crate::check::*;
use crate::curve_drawing::Recorder;
use crate::curve_measure::holds;
use crate::runner::Row;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{PathBuilder, PathElement};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Path::new", accessors),
    ("Path::subpath_count", accessors),
    ("Path::segment_count", accessors),
    ("Path::is_empty", accessors),
    ("Path::subpaths", accessors),
    ("Path::segments", accessors),
    ("Path::elements", elements),
    ("Path::subpath", subpath),
    ("Path::approx_eq", approx_eq),
    ("Path::bounds", bounds),
    ("Path::control_bounds", control_bounds),
    ("Path::length", length),
    ("Path::time_at_length", time_at_length),
    ("Path::equidistant_times", equidistant_times),
    ("Path::area", area),
    ("Path::moments", moments),
    ("Path::flatten", flatten),
    ("Path::transform", transform),
    ("Path::reverse", reverse),
    ("Path::trace", trace),
    ("Path::to_svg", to_svg),
];

/// The maximum degree of the segments of generated splines.
pub(crate) const DEGREE: usize = 12;

fn accessors(case: &Case) -> Checked {
    let path = call(case, || path(case, "path"))?;
    let subpaths = call(case, || path.subpaths().collect::<Vec<_>>())?;
    ensure!(
        path.subpath_count() == subpaths.len(),
        "{} subpaths",
        path.subpath_count()
    );
    let segments: usize = subpaths.iter().map(|spline| spline.segment_count()).sum();
    ensure!(
        path.segment_count() == segments,
        "{} segments",
        path.segment_count()
    );
    let curves = call(case, || path.segments().collect::<Vec<_>>())?;
    ensure!(
        subpaths
            .iter()
            .flat_map(|spline| spline.segments())
            .eq(curves),
        "not the segments of the subpaths"
    );
    ensure!(
        path.is_empty() == subpaths.is_empty(),
        "empty: {}",
        path.is_empty()
    );
    ensure!(
        Path::new(&subpaths) == path,
        "another path is made of the subpaths"
    );
    Ok(())
}

fn subpath(case: &Case) -> Checked {
    let (path, k) = (path(case, "path"), count(case, "k"));
    let subpath = call(case, || path.subpath(k))?;
    ensure!(
        subpath.as_ref() == path.subpaths().collect::<Vec<_>>().get(k),
        "not subpath {k}"
    );
    Ok(())
}

fn approx_eq(case: &Case) -> Checked {
    let (path, tolerance) = (path(case, "path"), number(case, "tolerance"));
    let same = call(case, || path.approx_eq(&path.reverse(), tolerance))?;
    ensure!(
        same == path.reverse().approx_eq(&path, tolerance),
        "not symmetric"
    );
    ensure!(path.approx_eq(&path, 0.0), "not equal to itself");
    Ok(())
}

fn bounds(case: &Case) -> Checked {
    let path = path(case, "path");
    let bounds = value!(case, path.bounds());
    ensure!(
        bounds.is_some() != path.is_empty(),
        "no box of a path, or a box of none"
    );
    for spline in path.subpaths() {
        for t in parameters(10 * spline.segment_count(), real(spline.segment_count())) {
            let inside = bounds
                .is_some_and(|bounds| holds(&bounds, spline.eval(t), slack(case.size(), DEGREE)));
            ensure!(inside, "the point at {t} lies outside");
        }
    }
    Ok(())
}

fn control_bounds(case: &Case) -> Checked {
    let path = path(case, "path");
    let bounds = call(case, || path.control_bounds())?;
    let points = path.subpaths().collect::<Vec<_>>();
    let mut points = points.iter().flat_map(|spline| spline.control_points());
    ensure!(
        points.all(|&p| bounds.is_some_and(|bounds| holds(&bounds, p, 0.0))),
        "a control point lies outside"
    );
    Ok(())
}

fn length(case: &Case) -> Checked {
    let (path, tolerance) = (path(case, "path"), optional(case, "tolerance"));
    let length = answer!(case, path.length(tolerance), &["tolerance"]);
    let lengths = path
        .subpaths()
        .collect::<Vec<_>>()
        .iter()
        .map(|spline| spline.length(None))
        .sum::<Result<f64, _>>();
    let sum = lengths.map_err(|error| error.to_string())?;
    let slack = 1e-11 * sum + slack(case.size(), DEGREE) + tolerance.unwrap_or(0.0);
    ensure!(
        (length - sum).abs() <= slack,
        "{length:e}, but the subpaths have {sum:e}"
    );
    Ok(())
}

fn time_at_length(case: &Case) -> Checked {
    let (path, s, tolerance) = (
        path(case, "path"),
        number(case, "s"),
        optional(case, "tolerance"),
    );
    let location = answer!(case, path.time_at_length(s, tolerance), &["tolerance", "s"]);
    ensure!(
        location.is_some() != path.is_empty(),
        "no place on a path, or one on none"
    );
    if let Some(location) = location {
        let spline = path.subpath(location.subpath).ok_or("no such subpath")?;
        ensure!(
            (0.0..=real(spline.segment_count())).contains(&location.t),
            "t = {}",
            location.t
        );
    }
    Ok(())
}

fn equidistant_times(case: &Case) -> Checked {
    let (path, segments) = (path(case, "path"), count(case, "segments"));
    let locations = answer!(case, path.equidistant_times(segments), &["segments"]);
    let expected = if path.is_empty() { 0 } else { segments + 1 };
    ensure!(locations.len() == expected, "{} places", locations.len());
    let ascend = locations
        .windows(2)
        .all(|w| (w[0].subpath, w[0].t) <= (w[1].subpath, w[1].t));
    ensure!(ascend, "the places do not ascend");
    Ok(())
}

fn area(case: &Case) -> Checked {
    let path = path(case, "path");
    let area = value!(case, path.area());
    let slack = 64.0 * slack(case.size(), DEGREE) * case.size();
    let back = path.reverse().area();
    ensure!(
        (area + back).abs() <= slack,
        "{area:e}, and backwards {back:e}"
    );
    Ok(())
}

fn moments(case: &Case) -> Checked {
    let path = path(case, "path");
    let moments = value!(case, path.moments());
    let slack = 64.0 * slack(case.size(), DEGREE) * case.size();
    ensure!((moments.area - path.area()).abs() <= slack, "another area");
    Ok(())
}

fn flatten(case: &Case) -> Checked {
    let (path, tolerance) = (path(case, "path"), number(case, "tolerance"));
    let lines = answer!(case, path.flatten(tolerance), &["tolerance"]);
    let subpaths = path.subpaths().collect::<Vec<_>>();
    ensure!(lines.len() == subpaths.len(), "{} polylines", lines.len());
    for (line, spline) in lines.iter().zip(&subpaths) {
        ensure!(
            ascends(&line.ts, 0.0, real(spline.segment_count())),
            "the parameters do not ascend"
        );
        for k in (0..line.points.len() - 1).step_by(line.points.len().div_ceil(20)) {
            let p = spline.eval(0.5 * (line.ts[k] + line.ts[k + 1]));
            let gap = from_segment(p, line.points[k], line.points[k + 1]);
            ensure!(
                gap <= tolerance + 4.0 * slack(case.size(), DEGREE),
                "{gap:e} from the polyline"
            );
        }
    }
    Ok(())
}

fn transform(case: &Case) -> Checked {
    let (path, map) = (path(case, "path"), affine::<DVec2>(case, "map"));
    let image = answer!(case, path.transform(&map), &["image"]);
    let images: Vec<_> = path
        .subpaths()
        .collect::<Vec<_>>()
        .iter()
        .map(|spline| spline.transform(&map).expect("a finite image"))
        .collect();
    ensure!(
        image == Path::new(&images),
        "not the images of the subpaths"
    );
    Ok(())
}

fn reverse(case: &Case) -> Checked {
    let path = path(case, "path");
    let reversed = call(case, || path.reverse())?;
    ensure!(
        reversed.reverse() == path,
        "twice backwards is not the same"
    );
    Ok(())
}

fn trace(case: &Case) -> Checked {
    let (path, tolerance) = (path(case, "path"), optional(case, "tolerance"));
    let mut pen = Recorder::default();
    answer!(case, path.trace(&mut pen, tolerance), &["tolerance"]);
    ensure!(
        pen.is_fine() && pen.subpaths.len() == path.subpath_count(),
        "not a subpath for each of the path's"
    );
    Ok(())
}

/// Checks that the drawing commands of `trace` and the output of `elements` agree.
fn elements(case: &Case) -> Checked {
    let (path, tolerance) = (path(case, "path"), optional(case, "tolerance"));
    let elements = || path.elements(tolerance).map(Iterator::collect::<Vec<_>>);
    let elements: Vec<PathElement> = answer!(case, elements(), &["tolerance"]);
    let mut traced = PathBuilder::new();
    _ = path.trace(&mut traced, tolerance);
    let mut built = PathBuilder::new();
    for element in elements {
        match element {
            PathElement::MoveTo(p) => built.move_to(p),
            PathElement::LineTo(p) => built.line_to(p),
            PathElement::QuadTo(p1, p) => built.quad_to(p1, p),
            PathElement::CubicTo(p1, p2, p) => built.cubic_to(p1, p2, p),
            PathElement::Close => built.close(),
        }
    }
    ensure!(
        built.build() == traced.build(),
        "other commands than those of trace"
    );
    Ok(())
}

fn to_svg(case: &Case) -> Checked {
    let (path, tolerance) = (path(case, "path"), optional(case, "tolerance"));
    let precision =
        optional_count(case, "precision").map(|digits| u8::try_from(digits).expect("few digits"));
    let text = answer!(
        case,
        path.to_svg(precision, tolerance),
        &["tolerance", "precision"]
    );
    let back = Path::from_svg(&text).map_err(|error| error.to_string())?;
    let low = path
        .subpaths()
        .collect::<Vec<_>>()
        .iter()
        .all(|spline| spline.degrees().iter().all(|&degree| degree <= 3));
    ensure!(
        precision.is_some() || !low || back == path,
        "another path is read back from {text}"
    );
    Ok(())
}
