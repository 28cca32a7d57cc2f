//! Checks of splines: construction, editing, other forms of the same curve.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::Spline;
use casteljau::spline::JointMode;
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Spline::new", both!(new)),
    ("Spline::with_degrees", both!(accessors)),
    ("Spline::control_points", both!(accessors)),
    ("Spline::is_closed", both!(accessors)),
    ("Spline::segment_count", both!(accessors)),
    ("Spline::degrees", both!(accessors)),
    ("Spline::segment", both!(segment)),
    ("Spline::segments", both!(accessors)),
    ("Spline::from_curves", both!(from_curves)),
    ("Spline::approx_eq", both!(approx_eq)),
    ("Spline::append", both!(append)),
    ("Spline::insert", both!(insert)),
    ("Spline::remove", both!(remove)),
    ("Spline::move_point", both!(move_point)),
    ("Spline::set_joint", both!(set_joint)),
];

fn new<P: Space>(case: &Case) -> Checked {
    let (points, degree) = (points::<P>(case, "points"), count(case, "degree"));
    let spline = answer!(
        case,
        Spline::new(&points, degree, flag(case, "closed")),
        &["points"]
    );
    ensure!(spline.control_points() == points, "other control points");
    ensure!(
        spline.degrees().iter().all(|&known| known == degree),
        "other degrees"
    );
    Ok(())
}

fn accessors<P: Space>(case: &Case) -> Checked {
    let data = spline_data(case, "spline");
    let spline = call(case, || spline_of::<P>(data))?;
    ensure!(
        spline.degrees() == data.degrees && spline.is_closed() == data.closed,
        "other degrees"
    );
    ensure!(
        spline.segment_count() == data.degrees.len(),
        "{} segments",
        spline.segment_count()
    );
    ensure!(
        spline.control_points().len() == data.points.len(),
        "other control points"
    );
    let segments = spline.segments().collect::<Vec<_>>();
    let joined = segments.windows(2).all(|w| w[0].end() == w[1].start());
    ensure!(
        joined && segments.len() == data.degrees.len(),
        "the segments do not join"
    );
    ensure!(
        !data.closed || segments[segments.len() - 1].end() == segments[0].start(),
        "not closed"
    );
    Ok(())
}

fn segment<P: Space>(case: &Case) -> Checked {
    let (spline, k) = (spline::<P>(case, "spline"), count(case, "k"));
    let segment = call(case, || spline.segment(k))?;
    ensure!(
        segment.as_ref() == spline.segments().collect::<Vec<_>>().get(k),
        "not segment {k}"
    );
    Ok(())
}

fn from_curves<P: Space>(case: &Case) -> Checked {
    let spline = spline::<P>(case, "spline");
    let back = answer!(
        case,
        Spline::from_curves(&spline.segments().collect::<Vec<_>>(), spline.is_closed())
    );
    ensure!(back == spline, "another spline");
    Ok(())
}

fn approx_eq<P: Space>(case: &Case) -> Checked {
    let (spline, tolerance) = (spline::<P>(case, "spline"), number(case, "tolerance"));
    let same = call(case, || spline.approx_eq(&spline.reverse(), tolerance))?;
    ensure!(
        same == spline.reverse().approx_eq(&spline, tolerance),
        "not symmetric"
    );
    ensure!(spline.approx_eq(&spline, 0.0), "not equal to itself");
    Ok(())
}

fn append<P: Space>(case: &Case) -> Checked {
    let (spline, p) = (spline::<P>(case, "spline"), point::<P>(case, "p"));
    let longer = answer!(
        case,
        spline.append(p),
        &["spline", "append", "closed", "point"]
    );
    ensure!(
        longer.segment_count() == spline.segment_count() + 1,
        "{} segments",
        longer.segment_count()
    );
    ensure!(
        longer.control_points().ends_with(&[p]),
        "it does not end at the point"
    );
    ensure!(
        longer.control_points().starts_with(spline.control_points()),
        "earlier points have changed"
    );
    Ok(())
}

fn insert<P: Space>(case: &Case) -> Checked {
    let (spline, t) = (spline::<P>(case, "spline"), number(case, "t"));
    let more = answer!(case, spline.insert(t), &["t"]);
    if more == spline {
        let at_joint = t.fract() == 0.0;
        ensure!(at_joint, "nothing was inserted at {t}");
        return Ok(());
    }
    ensure!(
        more.segment_count() == spline.segment_count() + 1,
        "{} segments",
        more.segment_count()
    );
    let k = t.floor() + 1.0;
    let gap = distance(more.eval(k), spline.eval(t));
    ensure!(gap <= slack(case.size(), 12), "the joint is {gap:e} off");
    Ok(())
}

fn remove<P: Space>(case: &Case) -> Checked {
    let (spline, joint) = (spline::<P>(case, "spline"), count(case, "joint"));
    let less = answer!(case, spline.remove(joint), &["joint", "segments"]);
    ensure!(
        less.segment_count() + 1 == spline.segment_count(),
        "{} segments",
        less.segment_count()
    );
    ensure!(
        less.is_closed() == spline.is_closed(),
        "closed: {}",
        less.is_closed()
    );
    Ok(())
}

fn mode(word: &str) -> JointMode {
    match word {
        "g1" => JointMode::G1,
        "c1" => JointMode::C1,
        "c2" => JointMode::C2,
        "g2" => JointMode::G2,
        "auto" => JointMode::Auto,
        _ => JointMode::Free,
    }
}

fn move_point<P: Space>(case: &Case) -> Checked {
    let (spline, index, to) = (
        spline::<P>(case, "spline"),
        count(case, "index"),
        point::<P>(case, "to"),
    );
    let modes = words(case, "modes");
    let moved = answer!(
        case,
        spline.move_point(index, to, |k| mode(modes.get(k).copied().unwrap_or("free"))),
        &[
            "index",
            "mode",
            "joint",
            "joints",
            "control points",
            "points"
        ]
    );
    ensure!(
        moved.control_points()[index] == to,
        "the point is elsewhere"
    );
    ensure!(moved.degrees() == spline.degrees(), "other degrees");
    Ok(())
}

fn set_joint<P: Space>(case: &Case) -> Checked {
    let (spline, joint, word) = (
        spline::<P>(case, "spline"),
        count(case, "joint"),
        word(case, "mode"),
    );
    let set = answer!(
        case,
        spline.set_joint(joint, mode(word)),
        &["joint", "mode"]
    );
    ensure!(set.degrees() == spline.degrees(), "other degrees");
    let at = if set.is_closed() && joint == 0 {
        0.0
    } else {
        real(joint)
    };
    ensure!(set.eval(at) == spline.eval(at), "the joint has moved");
    Ok(())
}
