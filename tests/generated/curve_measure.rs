//! Checks of curves: arc lengths, areas, bounding boxes, frames.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::Curve;
use casteljau::curve::{Bounds, Frame};
use casteljau::glam::{DVec2, DVec3};
use casteljau_generator::{Case, Mode};

pub(crate) const ROWS: &[Row] = &[
    ("Curve::length", both!(length)),
    ("Curve::time_at_length", both!(time_at_length)),
    ("Curve::equidistant_times", both!(equidistant_times)),
    ("Curve::area", area),
    ("Curve::moments", moments),
    ("Curve::bounds", both!(bounds)),
    ("Curve::control_bounds", both!(control_bounds)),
    ("Curve::hull", hull),
    ("Curve::frames", frames),
    ("Curve::frames_at", frames_at),
];

/// The relative slack of arc lengths: one length is accurate to 1e-12, and three of them are compared.
const LENGTH_SLACK: f64 = 1e-11;

fn length<P: Space>(case: &Case) -> Checked {
    let (curve, tolerance) = (curve::<P>(case, "curve"), optional(case, "tolerance"));
    let length = answer!(case, curve.length(tolerance), &["tolerance"]);
    let polygon: f64 = curve
        .control_points()
        .windows(2)
        .map(|w| distance(w[0], w[1]))
        .sum();
    let chord = distance(curve.start(), curve.end());
    let slack = LENGTH_SLACK * polygon + slack(case.size(), curve.degree());
    ensure!(
        length >= chord - slack,
        "{length:e} is less than the chord, {chord:e}"
    );
    ensure!(
        length <= polygon + slack,
        "{length:e} is more than the polygon, {polygon:e}"
    );
    let (left, right) = curve.split(0.375);
    let sum = left
        .length(None)
        .and_then(|a| Ok(a + right.length(None)?))
        .map_err(|error| error.to_string())?;
    ensure!(
        (length - sum).abs() <= 4.0 * slack,
        "{length:e}, but the pieces have {sum:e}"
    );
    Ok(())
}

fn time_at_length<P: Space>(case: &Case) -> Checked {
    let (curve, s, tolerance) = (
        curve::<P>(case, "curve"),
        number(case, "s"),
        optional(case, "tolerance"),
    );
    let t = answer!(
        case,
        curve.time_at_length(s, tolerance),
        &["tolerance", "s"]
    );
    ensure!((0.0..=1.0).contains(&t), "t = {t}");
    let whole = curve.length(None).map_err(|error| error.to_string())?;
    let (piece, _) = curve.split(t);
    let got = piece.length(None).map_err(|error| error.to_string())?;
    let slack =
        LENGTH_SLACK * whole + 4.0 * slack(case.size(), curve.degree()) + tolerance.unwrap_or(0.0);
    // A parameter is an f64: where the speed is large, the arc length jumps from one parameter to the next.
    let step = 4.0 * f64::EPSILON * t * curve.derivative_at(t, 1).length();
    ensure!(
        (got - s.clamp(0.0, whole)).abs() <= slack + step,
        "{got:e} of {whole:e} lies behind t = {t}, not {s:e}"
    );
    Ok(())
}

fn equidistant_times<P: Space>(case: &Case) -> Checked {
    let (curve, segments) = (curve::<P>(case, "curve"), count(case, "segments"));
    let ts = answer!(case, curve.equidistant_times(segments), &["segments"]);
    ensure!(ts.len() == segments + 1, "{} parameters", ts.len());
    ensure!(
        ts[0] == 0.0 && ts[segments] == 1.0,
        "the ends are {} and {}",
        ts[0],
        ts[segments]
    );
    ensure!(
        ts.windows(2).all(|w| w[0] <= w[1]),
        "the parameters do not ascend"
    );
    let whole = curve.length(None).map_err(|error| error.to_string())?;
    let k = segments / 2;
    let before = curve
        .split(ts[k])
        .0
        .length(None)
        .map_err(|error| error.to_string())?;
    let step = 4.0 * f64::EPSILON * ts[k] * curve.derivative_at(ts[k], 1).length();
    let slack = LENGTH_SLACK * whole + 4.0 * slack(case.size(), curve.degree()) + step;
    let expected = whole * real(k) / real(segments);
    // For a curve that is a point the result is equal steps of t.
    ensure!(
        (before - expected).abs() <= slack,
        "{before:e} lies behind parameter {k}, not {expected:e}"
    );
    Ok(())
}

fn area(case: &Case) -> Checked {
    let curve = curve::<DVec2>(case, "curve");
    let area = value!(case, curve.area());
    let (left, right) = curve.split(0.375);
    let size = case.size();
    let slack = 8.0 * slack(size, curve.degree()) * size;
    let sum = left.area() + right.area();
    ensure!(
        (area - sum).abs() <= slack,
        "{area:e}, but the pieces have {sum:e}"
    );
    ensure!(
        (area + curve.reverse().area()).abs() <= slack,
        "backwards not the opposite"
    );
    Ok(())
}

fn moments(case: &Case) -> Checked {
    let curve = curve::<DVec2>(case, "curve");
    let moments = value!(case, curve.moments());
    let size = case.size();
    let slack = 64.0 * slack(size, curve.degree()) * size;
    ensure!((moments.area - curve.area()).abs() <= slack, "another area");
    let (left, right) = curve.split(0.375);
    let (left, right) = (left.moments(), right.moments());
    for (whole, sum) in [(moments.x, left.x + right.x), (moments.y, left.y + right.y)] {
        ensure!(
            (whole - sum).abs() <= slack * size,
            "{whole:e}, but the pieces have {sum:e}"
        );
    }
    for (whole, sum) in [
        (moments.xx, left.xx + right.xx),
        (moments.xy, left.xy + right.xy),
        (moments.yy, left.yy + right.yy),
    ] {
        ensure!(
            (whole - sum).abs() <= slack * size * size,
            "{whole:e}, but the pieces have {sum:e}"
        );
    }
    Ok(())
}

/// Whether a bounding box contains a point within a slack.
pub(crate) fn holds<P: Space>(bounds: &Bounds<P>, p: P, slack: f64) -> bool {
    (0..P::DIMENSION).all(|axis| {
        let x = p.coordinate(axis);
        x >= bounds.min.coordinate(axis) - slack && x <= bounds.max.coordinate(axis) + slack
    })
}

fn bounds<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let bounds = value!(case, curve.bounds());
    let slack = slack(case.size(), curve.degree());
    for t in parameters(40, 1.0) {
        ensure!(holds(&bounds, curve.eval(t), slack), "B({t}) lies outside");
    }
    for axis in 0..P::DIMENSION {
        let extrema = curve.extrema(axis).map_err(|error| error.to_string())?;
        let values = extrema
            .into_iter()
            .chain([0.0, 1.0])
            .map(|t| curve.eval(t).coordinate(axis));
        let (smallest, largest) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
            (a.min(x), b.max(x))
        });
        let (min, max) = (bounds.min.coordinate(axis), bounds.max.coordinate(axis));
        ensure!(
            (min - smallest).abs() <= slack && (max - largest).abs() <= slack,
            "a side of axis {axis} is not touched"
        );
    }
    Ok(())
}

fn control_bounds<P: Space>(case: &Case) -> Checked {
    let curve = curve::<P>(case, "curve");
    let bounds = call(case, || curve.control_bounds())?;
    ensure!(
        curve
            .control_points()
            .iter()
            .all(|&p| holds(&bounds, p, 0.0)),
        "a control point lies outside"
    );
    ensure!(
        bounds.diagonal() >= 0.0,
        "a diagonal of {}",
        bounds.diagonal()
    );
    Ok(())
}

fn hull(case: &Case) -> Checked {
    let curve = curve::<DVec2>(case, "curve");
    let hull = call(case, || curve.hull())?;
    let points = curve.control_points();
    ensure!(
        !hull.is_empty() && hull.iter().all(|p| points.contains(p)),
        "a corner that is no control point"
    );
    if case.mode == Mode::Extreme || hull.len() < 3 {
        return Ok(());
    }
    // In every direction the hull extends as far as the points. Its signed area is not negative, except for rounding.
    let slack = slack(case.size(), 2);
    for k in 0..32 {
        let direction = DVec2::from_angle(real(k) * std::f64::consts::TAU / 32.0);
        let reach = |points: &[DVec2]| {
            points
                .iter()
                .map(|p| p.dot(direction))
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let short = reach(points) - reach(&hull);
        ensure!(short <= slack, "a point lies {short:e} outside of the hull");
    }
    let next = hull.iter().cycle().skip(1);
    let area: f64 = hull
        .iter()
        .zip(next)
        .map(|(&a, &b)| (a - hull[0]).perp_dot(b - hull[0]))
        .sum();
    ensure!(
        area >= -slack * case.size(),
        "clockwise, with the area {area:e}"
    );
    Ok(())
}

/// Checks that frames are orthonormal and at points of the curve.
pub(crate) fn frames_hold(
    frames: &[Frame],
    ts: &[f64],
    at: impl Fn(f64) -> (DVec3, f64),
) -> Checked {
    ensure!(
        frames.len() == ts.len(),
        "{} frames for {} parameters",
        frames.len(),
        ts.len()
    );
    for (frame, &t) in frames.iter().zip(ts) {
        let Frame {
            tangent,
            normal,
            binormal,
            point,
            ..
        } = *frame;
        let (expected, slack) = at(t);
        ensure!(
            frame.t == t && distance(point, expected) <= slack,
            "a frame off the curve at {t}"
        );
        if tangent == DVec3::ZERO {
            continue;
        }
        let lengths = [tangent, normal, binormal].map(|v| (v.length() - 1.0).abs());
        ensure!(
            lengths.iter().all(|&off| off <= 1e-9),
            "directions that are no unit vectors at {t}"
        );
        ensure!(tangent.dot(normal).abs() <= 1e-9, "no right angle at {t}");
        ensure!(
            distance(tangent.cross(normal), binormal) <= 1e-9,
            "not a right-handed frame at {t}"
        );
    }
    Ok(())
}

fn on(case: &Case, curve: &Curve<DVec3>) -> impl Fn(f64) -> (DVec3, f64) {
    move |t| {
        (
            curve.eval(t),
            slack(case.size(), curve.degree()) * growth(t, curve.degree()),
        )
    }
}

fn frames(case: &Case) -> Checked {
    let (curve, segments) = (curve::<DVec3>(case, "curve"), count(case, "segments"));
    let frames = answer!(case, curve.frames(segments), &["segments"]);
    let ts: Vec<f64> = parameters(segments, 1.0).collect();
    frames_hold(&frames, &ts, on(case, &curve))
}

fn frames_at(case: &Case) -> Checked {
    let (curve, ts) = (curve::<DVec3>(case, "curve"), numbers(case, "ts"));
    let frames = answer!(case, curve.frames_at(ts, optional_point(case, "normal")));
    frames_hold(&frames, ts, on(case, &curve))
}
