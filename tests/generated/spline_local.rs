//! Checks of splines: derivatives, tangents, normals, curvature, and parts.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use crate::spline_measure::slack_at;
use casteljau::glam::DVec3;
use casteljau::{Curve, Spline};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Spline::derivative_at", both!(derivative_at)),
    ("Spline::tangent", both!(tangent)),
    ("Spline::normal", both!(normal)),
    ("Spline::curvature", both!(curvature)),
    ("Spline::torsion", torsion),
    ("Spline::split", both!(split)),
    ("Spline::subsegment", both!(subsegment)),
];

/// The segment at t and the parameter on it.
fn segment_at<P: Space>(spline: &Spline<P>, t: f64) -> (Curve<P>, f64) {
    let last = spline.segment_count() - 1;
    let k = (0..last).find(|&k| t < real(k + 1)).unwrap_or(last);
    (spline.segment(k).expect("a segment"), t - real(k))
}

/// Checks that the answer of a spline is that of the segment of t.
fn is_of_segment<T: PartialEq>(answer: T, of_segment: T) -> Checked {
    ensure!(answer == of_segment, "not the answer of the segment");
    Ok(())
}

fn derivative_at<P: Space>(case: &Case) -> Checked {
    let (spline, t) = (spline::<P>(case, "spline"), number(case, "t"));
    let k = count(case, "k");
    let (segment, rest) = segment_at(&spline, t);
    let derivative = call_unbounded(case, || spline.derivative_at(t, k))?;
    is_of_segment(derivative, segment.derivative_at(rest, k))
}

fn tangent<P: Space>(case: &Case) -> Checked {
    let (spline, t) = (spline::<P>(case, "spline"), number(case, "t"));
    let (segment, rest) = segment_at(&spline, t);
    is_of_segment(call(case, || spline.tangent(t))?, segment.tangent(rest))
}

fn normal<P: Space>(case: &Case) -> Checked {
    let (spline, t) = (spline::<P>(case, "spline"), number(case, "t"));
    let (segment, rest) = segment_at(&spline, t);
    is_of_segment(call(case, || spline.normal(t))?, segment.normal(rest))
}

fn curvature<P: Space>(case: &Case) -> Checked {
    let (spline, t) = (spline::<P>(case, "spline"), number(case, "t"));
    let (segment, rest) = segment_at(&spline, t);
    let curvature = call_unbounded(case, || spline.curvature(t))?;
    is_of_segment(curvature, segment.curvature(rest))
}

fn torsion(case: &Case) -> Checked {
    let (spline, t) = (spline::<DVec3>(case, "spline"), number(case, "t"));
    let (segment, rest) = segment_at(&spline, t);
    let torsion = call_unbounded(case, || spline.torsion(t))?;
    is_of_segment(torsion, segment.torsion(rest))
}

/// Checks that a part has the points of the spline from t₀ on, at equal parameters after its first segment.
fn has_points_of<P: Space>(case: &Case, spline: &Spline<P>, part: &Spline<P>, t: f64) -> Checked {
    let (whole, count) = (spline.segment_count(), part.segment_count());
    let slack = slack_at(case, spline, t);
    for k in 1..count {
        // The joints of a part that starts in segment j are the joints of the spline from j + 1 on.
        let joint = (1..=whole).find(|&j| real(j) > t).unwrap_or(whole) + k - 1;
        ensure!(
            distance(part.eval(real(k)), spline.eval(real(joint))) <= slack,
            "joint {k} is not joint {joint} of the spline"
        );
    }
    Ok(())
}

fn split<P: Space>(case: &Case) -> Checked {
    let (spline, t) = (spline::<P>(case, "spline"), number(case, "t"));
    let (left, right) = value!(case, spline.split(t));
    let end = |spline: &Spline<P>| spline.eval(real(spline.segment_count()));
    ensure!(
        left.eval(0.0) == spline.eval(0.0) && end(&right) == end(&spline),
        "the outer ends are not kept"
    );
    ensure!(end(&left) == right.eval(0.0), "the parts do not join");
    let gap = distance(end(&left), spline.eval(t));
    ensure!(
        gap <= slack_at(case, &spline, t),
        "the parts join {gap:e} from the point at t"
    );
    has_points_of(case, &spline, &right, t)
}

fn subsegment<P: Space>(case: &Case) -> Checked {
    let spline = spline::<P>(case, "spline");
    let (t0, t1) = (number(case, "t0"), number(case, "t1"));
    let part = value!(case, spline.subsegment(t0, t1));
    ensure!(!part.is_closed(), "a closed part");
    let slack = slack_at(case, &spline, t0).max(slack_at(case, &spline, t1));
    let ends = [part.eval(0.0), part.eval(real(part.segment_count()))];
    for (end, t) in ends.into_iter().zip([t0, t1]) {
        let gap = distance(end, spline.eval(t));
        ensure!(gap <= slack, "the end is {gap:e} from the point at {t}");
    }
    let forward = if t0 > t1 { part.reverse() } else { part };
    has_points_of(case, &spline, &forward, t0.min(t1))
}
