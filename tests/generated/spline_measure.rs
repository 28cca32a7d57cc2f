//! Checks of splines: evaluation, measurements, queries.

use crate::arguments::*;
use crate::check::*;
use crate::curve_measure::{frames_hold, holds};
use crate::runner::Row;
use casteljau::Spline;
use casteljau::glam::{DVec2, DVec3};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Spline::eval", both!(eval)),
    ("Spline::eval_at", both!(eval_at)),
    ("Spline::sample", both!(sample)),
    ("Spline::frames", frames),
    ("Spline::frames_at", frames_at),
    ("Spline::length", both!(length)),
    ("Spline::cumulative_lengths", both!(cumulative_lengths)),
    ("Spline::time_at_length", both!(time_at_length)),
    ("Spline::equidistant_times", both!(equidistant_times)),
    ("Spline::area", area),
    ("Spline::bounds", both!(bounds)),
    ("Spline::control_bounds", both!(control_bounds)),
];

fn degree<P: Space>(spline: &Spline<P>) -> usize {
    spline.degrees().into_iter().max().unwrap_or(1)
}

/// The slack at a parameter; outside the spline the first or the last segment is extrapolated.
pub(crate) fn slack_at<P: Space>(case: &Case, spline: &Spline<P>, t: f64) -> f64 {
    let end = real(spline.segment_count());
    let beyond = if t < 0.0 { t } else { (t - end).max(0.0) + 1.0 };
    let growth = if (0.0..=end).contains(&t) {
        1.0
    } else {
        growth(beyond, degree(spline))
    };
    4.0 * slack(case.size(), degree(spline)) * growth
}

/// The point at t, evaluated on its segment.
fn by_segment<P: Space>(spline: &Spline<P>, t: f64) -> P {
    let last = spline.segment_count() - 1;
    let k = (0..last).find(|&k| t < real(k + 1)).unwrap_or(last);
    de_casteljau(
        spline.segments().collect::<Vec<_>>()[k].control_points(),
        t - real(k),
    )
}

fn eval<P: Space>(case: &Case) -> Checked {
    let (spline, t) = (spline::<P>(case, "spline"), number(case, "t"));
    let point = value!(case, spline.eval(t));
    let gap = distance(point, by_segment(&spline, t));
    ensure!(
        gap <= slack_at(case, &spline, t),
        "{gap:e} away from de Casteljau's algorithm"
    );
    Ok(())
}

fn eval_at<P: Space>(case: &Case) -> Checked {
    let (spline, ts) = (spline::<P>(case, "spline"), numbers(case, "ts"));
    let points = value!(case, spline.eval_at(ts));
    ensure!(points.len() == ts.len(), "{} points", points.len());
    for (&t, &point) in ts.iter().zip(&points) {
        ensure!(
            distance(point, spline.eval(t)) <= slack_at(case, &spline, t),
            "differs from eval at {t}"
        );
    }
    Ok(())
}

fn sample<P: Space>(case: &Case) -> Checked {
    let (spline, per_curve) = (spline::<P>(case, "spline"), count(case, "segments"));
    let points = answer!(
        case,
        spline.sample(per_curve),
        &["segments", "segments_per_curve", "per_curve"]
    );
    ensure!(
        points.len() == per_curve * spline.segment_count() + 1,
        "{} points",
        points.len()
    );
    for (k, &point) in points.iter().enumerate() {
        let t = real(k) / real(per_curve);
        ensure!(
            distance(point, spline.eval(t)) <= slack_at(case, &spline, 0.0),
            "differs from eval at {t}"
        );
    }
    Ok(())
}

fn frames(case: &Case) -> Checked {
    let (spline, per_curve) = (spline::<DVec3>(case, "spline"), count(case, "segments"));
    let frames = answer!(
        case,
        spline.frames(per_curve),
        &["segments", "segments_per_curve", "per_curve"]
    );
    let ts: Vec<f64> = frames.iter().map(|frame| frame.t).collect();
    ensure!(
        ts.len() == per_curve * spline.segment_count() + 1,
        "{} frames",
        ts.len()
    );
    frames_hold(&frames, &ts, |t| {
        (spline.eval(t), slack_at(case, &spline, t))
    })
}

fn frames_at(case: &Case) -> Checked {
    let (spline, ts) = (spline::<DVec3>(case, "spline"), numbers(case, "ts"));
    let frames = answer!(case, spline.frames_at(ts, optional_point(case, "normal")));
    frames_hold(&frames, ts, |t| {
        (spline.eval(t), slack_at(case, &spline, t))
    })
}

fn length<P: Space>(case: &Case) -> Checked {
    let (spline, tolerance) = (spline::<P>(case, "spline"), optional(case, "tolerance"));
    let length = answer!(case, spline.length(tolerance), &["tolerance"]);
    let lengths = spline
        .segments()
        .collect::<Vec<_>>()
        .iter()
        .map(|curve| curve.length(None))
        .sum::<Result<f64, _>>();
    let sum = lengths.map_err(|error| error.to_string())?;
    let slack = 1e-11 * sum + slack_at(case, &spline, 0.0) + tolerance.unwrap_or(0.0);
    ensure!(
        (length - sum).abs() <= slack,
        "{length:e}, but the segments have {sum:e}"
    );
    Ok(())
}

fn cumulative_lengths<P: Space>(case: &Case) -> Checked {
    let spline = spline::<P>(case, "spline");
    let ends = call(case, || spline.cumulative_lengths())?;
    ensure!(
        ends.len() == spline.segment_count() + 1 && ends[0] == 0.0,
        "{} lengths, the first {:?}",
        ends.len(),
        ends.first()
    );
    ensure!(
        ends.windows(2).all(|pair| pair[0] <= pair[1]),
        "decreasing lengths"
    );
    let whole = spline.length(None).map_err(|error| error.to_string())?;
    ensure!(
        ends.last() == Some(&whole),
        "{:?} is not the length {whole:e}",
        ends.last()
    );
    Ok(())
}

fn time_at_length<P: Space>(case: &Case) -> Checked {
    let (spline, s, tolerance) = (
        spline::<P>(case, "spline"),
        number(case, "s"),
        optional(case, "tolerance"),
    );
    let t = answer!(
        case,
        spline.time_at_length(s, tolerance),
        &["tolerance", "s"]
    );
    let end = real(spline.segment_count());
    ensure!((0.0..=end).contains(&t), "t = {t}");
    ensure!(s > 0.0 || t == 0.0, "t = {t} for the length {s}");
    Ok(())
}

fn equidistant_times<P: Space>(case: &Case) -> Checked {
    let (spline, segments) = (spline::<P>(case, "spline"), count(case, "segments"));
    let ts = answer!(case, spline.equidistant_times(segments), &["segments"]);
    ensure!(ts.len() == segments + 1, "{} parameters", ts.len());
    ensure!(
        ts[0] == 0.0 && ts[segments] == real(spline.segment_count()),
        "the ends are {} and {}",
        ts[0],
        ts[segments]
    );
    ensure!(
        ts.windows(2).all(|w| w[0] <= w[1]),
        "the parameters do not ascend"
    );
    Ok(())
}

fn area(case: &Case) -> Checked {
    let spline = spline::<DVec2>(case, "spline");
    let area = value!(case, spline.area());
    let sum: f64 = spline
        .segments()
        .collect::<Vec<_>>()
        .iter()
        .map(|curve| curve.area())
        .sum();
    let slack = 64.0 * slack_at(case, &spline, 0.0) * case.size();
    ensure!(
        (area - sum).abs() <= slack,
        "{area:e}, but the segments have {sum:e}"
    );
    Ok(())
}

fn bounds<P: Space>(case: &Case) -> Checked {
    let spline = spline::<P>(case, "spline");
    let bounds = value!(case, spline.bounds());
    let slack = slack_at(case, &spline, 0.0);
    for t in parameters(10 * spline.segment_count(), real(spline.segment_count())) {
        ensure!(
            holds(&bounds, spline.eval(t), slack),
            "the point at {t} lies outside"
        );
    }
    let boxes: Vec<_> = spline
        .segments()
        .collect::<Vec<_>>()
        .iter()
        .map(|curve| curve.bounds())
        .collect();
    for axis in 0..P::DIMENSION {
        let min = boxes
            .iter()
            .map(|b| b.min.coordinate(axis))
            .fold(f64::INFINITY, f64::min);
        let max = boxes
            .iter()
            .map(|b| b.max.coordinate(axis))
            .fold(f64::NEG_INFINITY, f64::max);
        let off = (bounds.min.coordinate(axis) - min)
            .abs()
            .max((bounds.max.coordinate(axis) - max).abs());
        ensure!(
            off <= slack,
            "a side of axis {axis} is {off:e} off those of the segments"
        );
    }
    Ok(())
}

fn control_bounds<P: Space>(case: &Case) -> Checked {
    let spline = spline::<P>(case, "spline");
    let bounds = call(case, || spline.control_bounds())?;
    ensure!(
        spline
            .control_points()
            .iter()
            .all(|&p| holds(&bounds, p, 0.0)),
        "a control point lies outside"
    );
    Ok(())
}
