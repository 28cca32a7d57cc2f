//! Checks of splines: nearest points, intersections, joints, polylines.

use crate::arguments::*;
use crate::check::*;
use crate::curve_query::{contacts_hold, doubles_hold, is_nearest};
use crate::runner::Row;
use crate::spline_measure::slack_at;
use casteljau::glam::DVec2;
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Spline::nearest", both!(nearest)),
    ("Spline::intersections", intersections),
    ("Spline::intersections_with_curve", intersections_with_curve),
    ("Spline::self_intersections", self_intersections),
    ("Spline::continuity", both!(continuity)),
    ("Spline::flatten", both!(flatten)),
];

fn nearest<P: Space>(case: &Case) -> Checked {
    let (spline, p) = (spline::<P>(case, "spline"), point::<P>(case, "p"));
    let nearest = answer!(case, spline.nearest(p));
    let slack = slack_at(case, &spline, 0.0);
    ensure!(
        (0.0..=real(spline.segment_count())).contains(&nearest.t),
        "t = {}",
        nearest.t
    );
    ensure!(
        distance(nearest.point, spline.eval(nearest.t)) <= slack,
        "the point is not that at t"
    );
    is_nearest(
        p,
        nearest.point,
        nearest.distance,
        4.0 * slack,
        spline.sample(20).expect("samples").into_iter(),
    )
}

fn intersections(case: &Case) -> Checked {
    let (a, b) = (
        spline::<DVec2>(case, "spline"),
        spline::<DVec2>(case, "other"),
    );
    let found = value!(case, a.intersections(&b));
    let slack = slack(case.size(), 12) * 4.0;
    contacts_hold(
        &found,
        [real(a.segment_count()), real(b.segment_count())],
        slack,
        |t| a.eval(t),
        |u| b.eval(u),
    )
}

fn intersections_with_curve(case: &Case) -> Checked {
    let (a, b) = (
        spline::<DVec2>(case, "spline"),
        curve::<DVec2>(case, "curve"),
    );
    let found = value!(case, a.intersections_with_curve(&b));
    let slack = slack(case.size(), b.degree().max(12)) * 4.0;
    contacts_hold(
        &found,
        [real(a.segment_count()), 1.0],
        slack,
        |t| a.eval(t),
        |u| b.eval(u),
    )
}

fn self_intersections(case: &Case) -> Checked {
    let spline = spline::<DVec2>(case, "spline");
    let found = value!(case, spline.self_intersections());
    doubles_hold(
        &found,
        real(spline.segment_count()),
        slack_at(case, &spline, 0.0),
        |t| spline.eval(t),
    )
}

fn continuity<P: Space>(case: &Case) -> Checked {
    let (spline, joint) = (spline::<P>(case, "spline"), count(case, "joint"));
    let found = answer!(
        case,
        spline.continuity(joint, optional(case, "tolerance")),
        &["joint", "tolerance"]
    );
    ensure!(found.c0 && found.gap == 0.0, "a gap of {:e}", found.gap);
    ensure!(
        (0.0..=std::f64::consts::PI).contains(&found.angle),
        "an angle of {}",
        found.angle
    );
    ensure!(!found.c2 || found.c1, "C2 without C1");
    Ok(())
}

fn flatten<P: Space>(case: &Case) -> Checked {
    let (spline, tolerance) = (spline::<P>(case, "spline"), number(case, "tolerance"));
    let line = answer!(case, spline.flatten(tolerance), &["tolerance"]);
    let end = real(spline.segment_count());
    ensure!(ascends(&line.ts, 0.0, end), "the parameters do not ascend");
    ensure!(
        (0..=spline.segment_count()).all(|k| line.ts.contains(&real(k))),
        "a joint is no vertex"
    );
    let slack = slack_at(case, &spline, 0.0);
    for k in (0..line.points.len() - 1).step_by(line.points.len().div_ceil(50)) {
        let p = spline.eval(0.5 * (line.ts[k] + line.ts[k + 1]));
        let gap = from_segment(p, line.points[k], line.points[k + 1]);
        ensure!(
            gap <= tolerance + slack,
            "{gap:e} from the polyline, the tolerance is {tolerance:e}"
        );
    }
    Ok(())
}
