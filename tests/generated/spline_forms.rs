//! Checks of splines: other forms of the same curve, drawing, offset curves.

use crate::arguments::*;
use crate::check::*;
use crate::curve_drawing::{OFFSET_REFUSALS, Recorder, default_tolerance, is_offset, near_drawn};
use crate::runner::Row;
use casteljau::glam::DVec2;
use casteljau::spline::{Interpolation, OffsetJoin};
use casteljau::{Path, Spline};
use casteljau_generator::{Case, Mode};

pub(crate) const ROWS: &[Row] = &[
    ("Spline::from_bspline", both!(from_bspline)),
    ("Spline::to_bspline", both!(to_bspline)),
    ("Spline::interpolate", both!(interpolate)),
    ("Spline::fit", both!(fit)),
    ("Spline::reverse", both!(reverse)),
    ("Spline::transform", both!(transform)),
    ("Spline::simplify", both!(simplify)),
    ("Spline::offset", offset),
    ("Spline::trace", trace),
    ("Spline::to_svg", to_svg),
];

fn from_bspline<P: Space>(case: &Case) -> Checked {
    let (points, degree) = (points::<P>(case, "points"), count(case, "degree"));
    let (knots, closed) = (optional_numbers(case, "knots"), flag(case, "closed"));
    let spline = answer!(
        case,
        Spline::from_bspline(&points, degree, knots, closed),
        &["points", "knots", "degree"]
    );
    ensure!(
        spline.degrees().iter().all(|&known| known == degree),
        "other degrees"
    );
    // Each control point is a mean of the control points of the B-spline.
    let largest = spline
        .control_points()
        .iter()
        .map(|p| p.max_abs())
        .fold(0.0, f64::max);
    ensure!(
        largest <= case.size() + slack(case.size(), 4 * degree),
        "outside of the control points' hull"
    );
    Ok(())
}

fn to_bspline<P: Space>(case: &Case) -> Checked {
    let spline = spline::<P>(case, "spline");
    let form = answer!(case, spline.to_bspline(), &["degrees", "segments"]);
    let back = Spline::from_bspline(&form.points, form.degree, Some(&form.knots), form.closed);
    ensure!(
        back.as_ref() == Ok(&spline),
        "another spline is made of the B-spline"
    );
    Ok(())
}

fn interpolate<P: Space>(case: &Case) -> Checked {
    let (points, closed) = (points::<P>(case, "points"), flag(case, "closed"));
    let kind = match word(case, "kind") {
        "natural" => Interpolation::Natural,
        _ => Interpolation::CatmullRom {
            alpha: number(case, "alpha"),
        },
    };
    let spline = answer!(case, Spline::interpolate(&points, kind, closed));
    ensure!(
        spline.is_closed() == closed,
        "closed: {}",
        spline.is_closed()
    );
    for (k, &p) in points.iter().enumerate() {
        ensure!(
            distance(spline.eval(real(k)), p) <= slack(case.size(), 3),
            "misses points[{k}]"
        );
    }
    Ok(())
}

fn fit<P: Space>(case: &Case) -> Checked {
    let (points, tolerance) = (points::<P>(case, "points"), number(case, "tolerance"));
    let spline = answer!(
        case,
        Spline::fit(
            &points,
            tolerance,
            optional(case, "corner_angle"),
            flag(case, "closed")
        ),
        &["tolerance", "corner_angle"]
    );
    let slack = 16.0 * slack(case.size(), 3);
    for (k, &p) in points.iter().enumerate() {
        let gap = spline
            .nearest(p)
            .map_err(|error| error.to_string())?
            .distance;
        ensure!(
            gap <= tolerance + slack,
            "points[{k}] is {gap:e} away, the tolerance is {tolerance:e}"
        );
    }
    Ok(())
}

fn reverse<P: Space>(case: &Case) -> Checked {
    let spline = spline::<P>(case, "spline");
    let reversed = call(case, || spline.reverse())?;
    ensure!(
        reversed.reverse() == spline,
        "twice backwards is not the same"
    );
    Ok(())
}

fn transform<P: Space>(case: &Case) -> Checked {
    let (spline, map) = (spline::<P>(case, "spline"), affine::<P>(case, "map"));
    let image = answer!(case, spline.transform(&map), &["image"]);
    let images = spline.control_points().iter().map(|p| p.transform(&map));
    ensure!(
        images.eq(image.control_points().iter().copied()),
        "not the mapped control points"
    );
    Ok(())
}

fn simplify<P: Space>(case: &Case) -> Checked {
    let (spline, tolerance) = (spline::<P>(case, "spline"), number(case, "tolerance"));
    let simple = answer!(case, spline.simplify(tolerance), &["tolerance"]);
    let slack = 16.0 * slack(case.size(), 12);
    for (from, to) in [(&spline, &simple), (&simple, &spline)] {
        for t in parameters(12, real(from.segment_count())) {
            let gap = to
                .nearest(from.eval(t))
                .map_err(|error| error.to_string())?
                .distance;
            ensure!(
                gap <= tolerance + slack,
                "{gap:e} apart at {t}, the tolerance is {tolerance:e}"
            );
        }
    }
    Ok(())
}

fn offset(case: &Case) -> Checked {
    let (spline, d, tolerance) = (
        spline::<DVec2>(case, "spline"),
        number(case, "distance"),
        optional(case, "tolerance"),
    );
    let join = match word(case, "join") {
        "round" => OffsetJoin::Round,
        "miter" => OffsetJoin::Miter,
        _ => OffsetJoin::Bevel,
    };
    let offset = answer!(case, spline.offset(d, tolerance, join), &OFFSET_REFUSALS);
    let diagonal = spline.control_bounds().diagonal();
    let tolerance = tolerance.unwrap_or_else(|| default_tolerance(case, diagonal, d));
    let is_point = spline
        .control_points()
        .iter()
        .all(|p| *p == spline.control_points()[0]);
    if case.mode == Mode::MixedScale || is_point || spline.segment_count() > 1 {
        return Ok(());
    }
    // The tip of a miter at the joint of a closed spline is up to four times the distance away.
    let farthest = if spline.is_closed() { 4.0 } else { 1.0 } * d.abs();
    is_offset(
        case,
        &spline.segments().collect::<Vec<_>>()[0],
        &offset,
        d,
        tolerance,
        farthest,
    )
}

fn trace(case: &Case) -> Checked {
    let (spline, tolerance) = (spline::<DVec2>(case, "spline"), optional(case, "tolerance"));
    let mut pen = Recorder::default();
    answer!(case, spline.trace(&mut pen, tolerance), &["tolerance"]);
    ensure!(
        pen.is_fine() && pen.subpaths.len() == 1,
        "not one subpath of finite numbers"
    );
    ensure!(
        pen.subpaths[0].1 == spline.is_closed(),
        "closed: {}",
        pen.subpaths[0].1
    );
    // The default tolerance depends on the bounding box of the whole spline or of the segment; this requires the larger
    // one.
    let tolerance = tolerance.unwrap_or(1e-4 * spline.control_bounds().diagonal());
    spline
        .segments()
        .collect::<Vec<_>>()
        .iter()
        .try_for_each(|curve| near_drawn(case, curve, &pen.subpaths[0].0, Some(tolerance)))
}

fn to_svg(case: &Case) -> Checked {
    let (spline, tolerance) = (spline::<DVec2>(case, "spline"), optional(case, "tolerance"));
    let precision =
        optional_count(case, "precision").map(|digits| u8::try_from(digits).expect("few digits"));
    let text = answer!(
        case,
        spline.to_svg(precision, tolerance),
        &["tolerance", "precision"]
    );
    let path = Path::from_svg(&text).map_err(|error| error.to_string())?;
    let low = spline.degrees().iter().all(|&degree| degree <= 3);
    if precision.is_none() && low {
        ensure!(
            path == Path::from(spline),
            "another path is read back from {text}"
        );
    }
    Ok(())
}
