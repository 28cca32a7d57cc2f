//! Checks of splines: construction, editing, other forms of the same curve, local properties, joints.

use crate::arguments::{Space, spline_of};
use crate::check::*;
use crate::geometry::*;
use crate::lines::compares;
use crate::shared::*;
use casteljau::glam::DVec3;
use casteljau::spline::{FitOptions, Interpolation, JointMode, SimplifyOptions};
use casteljau::{Error, Spline};
use casteljau_generator::{SplineData, changed};

pub(crate) fn new<P: Space>(points: Vec<P>, degree: usize, closed: bool) -> Checked {
    let spline = answer!(Spline::new(&points, degree, closed), "points");
    same(spline.control_points(), points.as_slice(), "the points")?;
    same(spline.is_closed(), closed, "closed")?;
    has_degree(&spline, degree)
}

fn has_degree<P: Space>(spline: &Spline<P>, degree: usize) -> Checked {
    let degrees = spline.degrees();
    holds!(degrees.iter().all(|&known| known == degree), "{degrees:?}")
}

pub(crate) fn accessors<P: Space>(data: SplineData) -> Checked {
    let spline = call(|| spline_of::<P>(&data))?;
    same(spline.degrees(), data.degrees, "the degrees")?;
    same(spline.is_closed(), data.closed, "closed")?;
    let points: Vec<P> = data.points.iter().map(|&p| P::from_3d(p)).collect();
    same(spline.control_points(), points.as_slice(), "the points")?;
    let curves = spline.curves();
    same(curves.len(), spline.segment_count(), "segments")?;
    let mut first = 0;
    for (curve, degree) in curves.iter().zip(spline.degrees()) {
        let mut known = points.iter().cycle().skip(first).take(degree + 1);
        let mut own = curve.control_points().iter();
        let own = own.all(|p| known.next() == Some(p));
        ensure!(own && curve.degree() == degree, "other points of a segment");
        first += degree;
    }
    same(first + usize::from(!data.closed), points.len(), "degrees")
}

pub(crate) fn segment<P: Space>(spline: Spline<P>, k: usize) -> Checked {
    let segment = call(|| spline.segment(k))?;
    same(segment.as_ref(), spline.curves().get(k), "the segment")
}

pub(crate) fn from_curves<P: Space>(spline: Spline<P>) -> Checked {
    let (curves, closed) = (spline.curves(), spline.is_closed());
    let back = answer!(Spline::from_curves(&curves, closed));
    same(back, spline, "the spline of its segments")
}

pub(crate) fn approx_eq<P: Space>(spline: Spline<P>, tolerance: f64) -> Checked {
    let reversed = spline.reverse();
    compares(Spline::approx_eq, (&spline, &reversed), tolerance)
}

pub(crate) fn append<P: Space>(spline: Spline<P>, p: P) -> Checked {
    let longer = answer!(spline.append(p), "spline|append|closed|point");
    let (old, new) = (spline.control_points(), longer.control_points());
    same(longer.last(), spline.last() + 1.0, "the segments")?;
    same(&new[..old.len()], old, "the earlier points")?;
    same(new.last(), Some(&p), "the end")
}

pub(crate) fn insert<P: Space>(spline: Spline<P>, t: f64) -> Checked {
    let more = answer!(spline.insert(t), "t");
    if more == spline {
        ensure!(t.fract() == 0.0, "nothing was inserted at {t}");
        return Ok(());
    }
    same(more.segment_count(), spline.segment_count() + 1, "segments")?;
    let joint = more.eval(t.floor() + 1.0);
    near(joint, spline.eval(t), slack(size(), 12), "the joint")
}

pub(crate) fn remove<P: Space>(spline: Spline<P>, joint: usize) -> Checked {
    let less = answer!(spline.remove(joint), "joint|segments");
    same(less.segment_count() + 1, spline.segment_count(), "segments")?;
    same(less.is_closed(), spline.is_closed(), "closed")
}

pub(crate) fn move_point<P: Space>(
    spline: Spline<P>,
    index: usize,
    to: P,
    modes: Vec<JointMode>,
) -> Checked {
    let mode = |k: usize| modes.get(k).copied().unwrap_or(JointMode::Free);
    let allowed = "index|mode|joint|joints|control points|points";
    let moved = answer!(changed(&spline, |s| s.move_point(index, to, mode)), allowed);
    same(moved.control_points()[index], to, "the point")?;
    same(moved.degrees(), spline.degrees(), "the degrees")
}

pub(crate) fn set_joint<P: Space>(spline: Spline<P>, joint: usize, mode: JointMode) -> Checked {
    let set = answer!(spline.set_joint(joint, mode), "joint|mode");
    same(set.degrees(), spline.degrees(), "the degrees")?;
    same(set.eval(real(joint)), spline.eval(real(joint)), "the joint")
}

pub(crate) fn from_bspline<P: Space>(
    points: Vec<P>,
    degree: usize,
    knots: Option<Vec<f64>>,
    closed: bool,
) -> Checked {
    let make = || Spline::from_bspline(&points, degree, knots.as_deref(), closed);
    let spline = answer!(make(), "points|knots|degree");
    has_degree(&spline, degree)?;
    // Each control point is a mean of the control points of the B-spline.
    let reach = size() + slack(size(), 4 * degree);
    at_most(largest(spline.control_points()), reach, "the hull")
}

pub(crate) fn to_bspline<P: Space>(spline: Spline<P>) -> Checked {
    let form = answer!(spline.to_bspline(), "degrees|segments");
    let back = Spline::from_bspline(&form.points, form.degree, Some(&form.knots), form.closed);
    same(back, Ok(spline), "the spline of the B-spline")
}

pub(crate) fn interpolate<P: Space>(
    points: Vec<P>,
    kind: String,
    alpha: f64,
    closed: bool,
) -> Checked {
    let kind = match kind.as_str() {
        "natural" => Interpolation::Natural,
        _ => Interpolation::CatmullRom { alpha },
    };
    let spline = answer!(Spline::interpolate(&points, kind, closed));
    same(spline.is_closed(), closed, "closed")?;
    for (k, &p) in points.iter().enumerate() {
        near(spline.eval(real(k)), p, slack(size(), 3), k)?;
    }
    Ok(())
}

pub(crate) fn fit<P: Space>(
    points: Vec<P>,
    tolerance: f64,
    corner_angle: Option<f64>,
    closed: bool,
) -> Checked {
    let mut options = FitOptions::new(tolerance).closed(closed);
    options.corner_angle = corner_angle.unwrap_or(options.corner_angle);
    let make = || Spline::fit(&points, &options);
    let spline = answer!(make(), "tolerance|corner_angle");
    let room = tolerance + 16.0 * slack(size(), 3);
    for (k, &p) in points.iter().enumerate() {
        at_most(spline.nearest(p)?.distance, room, k)?;
    }
    Ok(())
}

pub(crate) fn simplify<P: Space>(spline: Spline<P>, tolerance: f64) -> Checked {
    let simple = answer!(spline.simplify(tolerance), "tolerance");
    let options = SimplifyOptions::new(tolerance).extrema(true);
    let monotone = spline.simplify_with(&options)?;
    let mut all = vec![simple, monotone];
    match spline.simplify_with(&options.precision(2)) {
        Err(Error::Range {
            what: "precision", ..
        }) => {}
        rounded => {
            let rounded = rounded?;
            for p in rounded.control_points() {
                let mut all_decimals = true;
                p.visit(&mut |x| {
                    all_decimals &= f64::abs(x) > 1e13 || (x * 100.0).round() / 100.0 == x
                });
                ensure!(all_decimals, "{p:?} has more than two decimals");
            }
            all.push(rounded);
        }
    }
    let room = tolerance + 16.0 * slack(size(), 12);
    for simple in &all {
        for (from, to) in [(&spline, simple), (simple, &spline)] {
            for t in parameters(12, from.last()) {
                at_most(to.nearest(from.eval(t))?.distance, room, t)?;
            }
        }
    }
    Ok(())
}

/// Defines checks that the answer of a spline is that of the segment of t, with a kind of call for each.
macro_rules! of_segment {
    ($([$($generic:tt)*] $p:ty, $call:ident $name:ident($($k:ident: $type:ty)?);)*) => {$(
        pub(crate) fn $name<$($generic)*>(
            spline: Spline<$p>,
            t: f64,
            $($k: $type)?
        ) -> Checked {
            let (segment, rest) = spline.segment_at(t);
            let answer = $call(|| spline.$name(t, $($k)?))?;
            same(answer, segment.$name(rest, $($k)?), "the answer of the segment")
        }
    )*};
}

of_segment! {
    [P: Space] P, call tangent();
    [P: Space] P, call normal();
    [P: Space] P, call_unbounded curvature();
    [P: Space] P, call_unbounded derivative_at(k: usize);
    [] DVec3, call_unbounded torsion();
}

pub(crate) fn cumulative_lengths<P: Space>(spline: Spline<P>) -> Checked {
    let ends = call(|| spline.cumulative_lengths())?;
    same(ends.len(), spline.segment_count() + 1, "lengths")?;
    same(ends[0], 0.0, "the first length")?;
    ensure!(ends.is_sorted(), "decreasing lengths");
    same(ends.last(), Some(&spline.length()), "the last length")
}

pub(crate) fn continuity<P: Space>(
    spline: Spline<P>,
    joint: usize,
    tolerance: Option<f64>,
) -> Checked {
    let found = match tolerance {
        None => answer!(spline.continuity(joint), "joint"),
        Some(tolerance) => answer!(
            spline.continuity_within(joint, tolerance),
            "joint|tolerance"
        ),
    };
    ensure!(found.c0 && found.gap == 0.0, "a gap of {:e}", found.gap);
    let angle = found.angle;
    ensure!((0.0..=std::f64::consts::PI).contains(&angle), "{angle}");
    holds!(!found.c2 || found.c1, "C2 without C1")
}
