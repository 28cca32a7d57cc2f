//! Checks that curves and splines share: points, pieces, lengths, bounding boxes, other forms, queries.

use crate::arguments::Space;
use crate::check::*;
use crate::geometry::*;
use crate::shared::*;
use casteljau::curve::{Frame, Intersection, IntersectionKind, SelfIntersection};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Point, Spline};

/// The relative slack of arc lengths: one length is accurate to 1e-12, and three of them are compared.
const LENGTH_SLACK: f64 = 1e-11;

/// Checks a comparison within a tolerance: it is symmetric, and a value equals itself.
pub(crate) fn compares<T>(
    approx_eq: impl Fn(&T, &T, f64) -> bool,
    (a, b): (&T, &T),
    tolerance: f64,
) -> Checked {
    let equal = call(|| approx_eq(a, b, tolerance))?;
    same(approx_eq(b, a, tolerance), equal, "the other order")?;
    holds!(approx_eq(a, a, 0.0), "not equal to itself")
}

finite! {
    // tests/curve/eval.rs, tests/spline/measure.rs
    [L: Line] eval(line: L, t: f64): call(|| line.eval(t))?;
    [L: Line] eval_at(line: L, ts: Vec<f64>): call(|| line.eval_at(&ts))?;
}

pub(crate) fn sample<L: Line>(line: L, segments: usize) -> Checked {
    let points = answer!(line.sample(segments), "segments");
    same(points[0], line.eval(0.0), "the first sample")?;
    let ts = (0..=segments * line.curves().len()).map(|k| real(k) / real(segments));
    are_points(&line, &points, &ts.collect::<Vec<_>>())
}

fn are_points<L: Line>(line: &L, points: &[L::P], ts: &[f64]) -> Checked {
    same(points.len(), ts.len(), "the number of points")?;
    for (&t, &point) in ts.iter().zip(points) {
        near(point, line.eval(t), line.slack_at(t), t)?;
    }
    Ok(())
}

pub(crate) fn frames<L: SpaceLine>(line: L, segments: usize) -> Checked {
    let frames = answer!(line.frames(segments), "segments");
    let ts = (0..=segments * line.curves().len()).map(|k| real(k) / real(segments));
    are_frames(&line, &frames, &ts.collect::<Vec<_>>())
}

pub(crate) fn frames_at<L: SpaceLine>(line: L, ts: Vec<f64>, normal: Option<DVec3>) -> Checked {
    let frames = answer!(line.frames_at(&ts, normal));
    are_frames(&line, &frames, &ts)
}

/// Checks that frames are at points of the line and orthonormal.
fn are_frames<L: SpaceLine>(line: &L, frames: &[Frame], ts: &[f64]) -> Checked {
    let known: Vec<f64> = frames.iter().map(|frame| frame.t).collect();
    same(known.as_slice(), ts, "the parameters")?;
    let points: Vec<DVec3> = frames.iter().map(|frame| frame.point).collect();
    are_points(line, &points, ts)?;
    for frame in frames.iter().filter(|frame| frame.tangent != DVec3::ZERO) {
        let (t, n, b) = (frame.tangent, frame.normal, frame.binormal);
        for direction in [t, n, b] {
            near(direction.length(), 1.0, 1e-9, "the length of a direction")?;
        }
        at_most(t.dot(n).abs(), 1e-9, "the normal leans to the tangent")?;
        near(t.cross(n), b, 1e-9, "not right-handed")?;
    }
    Ok(())
}

pub(crate) fn reverse<L: Line>(line: L) -> Checked {
    let reversed = call(|| line.reverse())?;
    same(&reversed.reverse(), &line, "twice backwards")?;
    let (curves, backwards) = (line.curves(), reversed.curves());
    same(curves.len(), backwards.len(), "the number of segments")?;
    for (curve, back) in curves.iter().zip(backwards.iter().rev()) {
        let points = back.control_points().iter().rev();
        ensure!(points.eq(curve.control_points()), "not backwards");
    }
    Ok(())
}

/// Checks that points were mapped exactly.
pub(crate) fn are_images<P: Point>(points: &[P], images: &[P], map: &P::Affine) -> Checked {
    let expected: Vec<P> = points.iter().map(|p| p.transform(map)).collect();
    same(images, expected.as_slice(), "the mapped points")
}

pub(crate) fn transform<L: Line>(line: L, map: <L::P as Point>::Affine) -> Checked {
    let image = answer!(line.transform(&map), "image");
    are_images(line.control_points(), image.control_points(), &map)
}

/// Checks that a piece has the points of a curve between two parameters.
pub(crate) fn is_piece<P: Space>(
    curve: &Curve<P>,
    piece: &Curve<P>,
    [t0, t1]: [f64; 2],
) -> Checked {
    let n = curve.degree();
    let slack = 4.0 * slack(size(), n) * growth(t0, n) * growth(t1, n);
    let part = |s: f64| curve.eval(t0 * (1.0 - s) + t1 * s);
    agree(4, slack, |s| piece.eval(s), part)
}

/// Checks that a part of a spline has the points of the spline between two parameters.
fn is_part<P: Space>(spline: &Spline<P>, part: &Spline<P>, [t0, t1]: [f64; 2]) -> Checked {
    let (end, last) = (part.last(), spline.last());
    let slack = spline.slack_at(t0).max(spline.slack_at(t1));
    near(part.eval(0.0), spline.eval(t0), slack, "the start")?;
    near(part.eval(end), spline.eval(t1), slack, "the end")?;
    ensure!(!part.is_closed(), "a closed part");
    // The joints of a part that starts in segment j are the joints of the spline from j + 1 on.
    let forward = if t0 > t1 {
        part.reverse()
    } else {
        part.clone()
    };
    let next = (t0.min(t1).floor() + 1.0).clamp(1.0, last);
    for k in parameters(forward.curves().len() - 1, end - 1.0).skip(1) {
        near(forward.eval(k), spline.eval(next + k - 1.0), slack, k)?;
    }
    Ok(())
}

/// Lines whose pieces are checked.
pub(crate) trait Divided: Line {
    /// Checks that a piece has the points between two parameters.
    fn has_piece(&self, piece: &Self, range: [f64; 2]) -> Checked;
}

impl<P: Space> Divided for Curve<P> {
    fn has_piece(&self, piece: &Self, range: [f64; 2]) -> Checked {
        is_piece(self, piece, range)
    }
}

impl<P: Space> Divided for Spline<P> {
    fn has_piece(&self, piece: &Self, range: [f64; 2]) -> Checked {
        is_part(self, piece, range)
    }
}

pub(crate) fn split<L: Divided>(line: L, t: f64) -> Checked {
    let pieces = value!(line.split(t));
    let (left, right) = &pieces;
    let [end, last] = [left.last(), right.last()];
    same(left.eval(end), right.eval(0.0), "where the pieces join")?;
    same(left.eval(0.0), line.eval(0.0), "the start")?;
    same(right.eval(last), line.eval(line.last()), "the end")?;
    line.has_piece(left, [0.0, t])?;
    line.has_piece(right, [t, line.last()])
}

pub(crate) fn split_at<L: Divided>(line: L, ts: Vec<f64>) -> Checked {
    let parts = value!(line.split_at(&ts));
    same(parts.len(), ts.len() + 1, "the number of parts")?;
    let mut ends = ts;
    ends.sort_by(f64::total_cmp);
    ends.insert(0, 0.0);
    ends.push(line.last());
    for (part, range) in parts.iter().zip(ends.windows(2)) {
        line.has_piece(part, [range[0], range[1]])?;
    }
    for pair in parts.windows(2) {
        same(pair[0].eval(pair[0].last()), pair[1].eval(0.0), "a gap")?;
    }
    Ok(())
}

pub(crate) fn subsegment<L: Divided>(line: L, t0: f64, t1: f64) -> Checked {
    let piece = value!(line.subsegment(t0..t1));
    line.has_piece(&piece, [t0, t1])
}

pub(crate) fn length<L: Line>(line: L, tolerance: Option<f64>) -> Checked {
    let length = match tolerance {
        None => value!(line.length()),
        Some(tolerance) => answer!(line.length_within(tolerance), "tolerance"),
    };
    let (mut chords, mut polygons, mut sum) = (0.0, 0.0, 0.0);
    for curve in line.curves() {
        chords += Metric::distance(curve.start(), curve.end());
        polygons += polygon_length(curve.control_points());
        sum += curve.length();
    }
    let slack = LENGTH_SLACK * polygons + line.slack();
    at_most(chords, length + slack, "the chords are longer")?;
    at_most(length, polygons + slack, "longer than the polygons")?;
    let (left, right) = line.split(0.375 * line.last());
    let halves = left.length() + right.length();
    near(length, halves, 4.0 * slack, "the sum of the pieces")?;
    near(length, sum, slack, "the sum of the segments")
}

/// Checks that a length lies between the start and t.
fn lies_before<L: Line>(line: &L, t: f64, s: f64, tolerance: f64) -> Checked {
    let whole = line.length();
    // A parameter is an f64: where the speed is large, the arc length jumps from one parameter to the next.
    let step = 4.0 * f64::EPSILON * t * line.derivative_at(t, 1).norm();
    let slack = LENGTH_SLACK * whole + 4.0 * line.slack() + tolerance + step;
    near(line.split(t).0.length(), s.clamp(0.0, whole), slack, t)
}

pub(crate) fn time_at_length<L: Line>(line: L, s: f64, tolerance: Option<f64>) -> Checked {
    let t = match tolerance {
        None => {
            let t = value!(line.time_at_length(s));
            let at = line.point_at_length(s);
            ensure!(
                s.is_nan() || (at.t, at.point) == (t, line.eval(t)),
                "another point"
            );
            t
        }
        Some(tolerance) => answer!(line.time_at_length_within(s, tolerance), "tolerance"),
    };
    ensure!(!s.is_nan() || t.is_nan(), "t = {t} for NaN");
    if s.is_nan() {
        return Ok(());
    }
    ensure!((0.0..=line.last()).contains(&t), "t = {t}");
    ensure!(s > 0.0 || t == 0.0, "t = {t} for the length {s}");
    lies_before(&line, t, s, tolerance.unwrap_or(0.0))
}

pub(crate) fn equidistant_times<L: Line>(line: L, segments: usize) -> Checked {
    let ts = answer!(line.equidistant_times(segments), "segments");
    same(ts.len(), segments + 1, "the number of parameters")?;
    same([ts[0], ts[segments]], [0.0, line.last()], "the ends")?;
    ensure!(ts.is_sorted(), "the parameters do not ascend");
    let k = segments / 2;
    let expected = line.length() * real(k) / real(segments);
    lies_before(&line, ts[k], expected, 0.0)
}

pub(crate) fn area<L: PlaneLine>(line: L) -> Checked {
    let area = value!(line.area());
    let slack = 8.0 * line.slack() * size();
    let sum: f64 = line.curves().iter().map(|curve| curve.area()).sum();
    let (left, right) = line.split(0.375 * line.last());
    near(area, sum, slack, "the sum of the segments")?;
    near(area, left.area() + right.area(), slack, "the pieces")?;
    near(area, -line.reverse().area(), slack, "backwards")
}

pub(crate) fn bounds<L: Line>(line: L) -> Checked {
    let (bounds, slack) = (value!(line.bounds()), line.slack());
    for t in parameters(40.max(10 * line.curves().len()), line.last()) {
        ensure!(holds(&bounds, line.eval(t), slack), "outside at {t}");
    }
    for axis in 0..L::P::DIMENSION {
        let mut values = Vec::new();
        for curve in line.curves() {
            let ts = curve.extrema(axis)?.into_iter().chain([0.0, 1.0]);
            values.extend(ts.map(|t| curve.eval(t).coordinate(axis)));
        }
        let largest = -min(values.iter().map(|x| -x));
        let [low, high] = [bounds.min, bounds.max].map(|p| p.coordinate(axis));
        near(low, min(values), slack, "the lower side")?;
        near(high, largest, slack, "the upper side")?;
    }
    Ok(())
}

pub(crate) fn control_bounds<L: Line>(line: L) -> Checked {
    let bounds = call(|| line.control_bounds())?;
    let expected = box_of(line.control_points().iter().copied());
    same(Some(bounds), expected, "the box of the control points")?;
    holds!(bounds.diagonal() >= 0.0, "a negative diagonal")
}

pub(crate) fn nearest<L: Line>(line: L, p: L::P) -> Checked {
    let found = answer!(line.nearest(p));
    let (slack, last) = (line.slack(), line.last());
    ensure!((0.0..=last).contains(&found.t), "t = {}", found.t);
    near(found.point, line.eval(found.t), slack, "the point at t")?;
    let distance = Metric::distance(found.point, p);
    near(distance, found.distance, 4.0 * slack, "the distance")?;
    let closest = from_nearest(p, line.sample(100 / line.curves().len())?);
    at_most(found.distance, closest + 4.0 * slack, "a sample is nearer")
}

pub(crate) fn intersections<L: PlaneLine>(line: L, other: L) -> Checked {
    let found = value!(line.intersections(&other));
    are_contacts(&found, &line, &other)
}

pub(crate) fn with_spline(curve: Curve<DVec2>, spline: Spline<DVec2>) -> Checked {
    let found = value!(curve.intersections_with_spline(&spline));
    are_contacts(&found, &curve, &spline)
}

pub(crate) fn with_curve(spline: Spline<DVec2>, curve: Curve<DVec2>) -> Checked {
    let found = value!(spline.intersections_with_curve(&curve));
    are_contacts(&found, &spline, &curve)
}

/// Checks that both lines are at the stated points at the stated parameters, and that the list is sorted.
pub(crate) fn are_contacts(
    found: &[Intersection],
    a: &impl PlaneLine,
    b: &impl PlaneLine,
) -> Checked {
    let times = found.iter().map(|contact| (contact.t, contact.u));
    ensure!(times.is_sorted(), "the list is not sorted");
    // The documented 64 (n + 2) ulps; parameters of splines are rounded in addition.
    let least = if a.last() + b.last() > 2.0 { 12 } else { 1 };
    let slack = 4.0 * slack(size(), a.degree().max(b.degree()).max(least));
    for contact in found {
        near(a.eval(contact.t), contact.point, slack, "the point")?;
        let mut pairs = vec![(contact.t, contact.u)];
        if let IntersectionKind::Overlap { t_end, u_end } = contact.kind {
            pairs.push((t_end, u_end));
        }
        for (t, u) in pairs {
            let ranges = [(t, a.last()), (u, b.last())];
            let inside = ranges.iter().all(|(t, end)| (0.0..=*end).contains(t));
            ensure!(inside, "({t}, {u}) is out of range");
            near(a.eval(t), b.eval(u), slack, format_args!("({t}, {u})"))?;
        }
    }
    Ok(())
}

pub(crate) fn self_intersections<L: PlaneLine>(line: L) -> Checked {
    let found = value!(line.self_intersections());
    let slack = 4.0 * slack(size(), line.degree());
    ensure!(found.is_sorted_by(|a, b| a.t <= b.t), "not sorted");
    for &SelfIntersection { t, u, point, .. } in &found {
        let in_range = 0.0 <= t && t < u && u <= line.last();
        ensure!(in_range, "({t}, {u}) is out of range");
        near(line.eval(t), point, slack, t)?;
        near(line.eval(t), line.eval(u), slack, u)?;
    }
    Ok(())
}

pub(crate) fn flatten<L: Line>(line: L, tolerance: f64) -> Checked {
    let polyline = answer!(line.flatten(tolerance), "tolerance");
    follows(&line, (&polyline.ts, &polyline.points), tolerance)
}

/// Checks that a polyline has its vertices on a line, at its joints among others, and follows it within a tolerance.
pub(crate) fn follows<L: Line>(
    line: &L,
    (ts, points): (&[f64], &[L::P]),
    tolerance: f64,
) -> Checked {
    same(points.len(), ts.len(), "the number of vertices")?;
    ensure!(ascends(ts, 0.0, line.last()), "not ascending");
    let mut joints = parameters(line.curves().len(), line.last());
    let is_vertex = |t: f64| ts.binary_search_by(|known| known.total_cmp(&t)).is_ok();
    ensure!(joints.all(is_vertex), "a joint is no vertex");
    let slack_at_vertices = line.slack();
    let room = tolerance + 2.0 * slack(size(), line.degree());
    for k in (0..points.len() - 1).step_by(points.len().div_ceil(50)) {
        near(points[k], line.eval(ts[k]), slack_at_vertices, ts[k])?;
        for s in [0.25, 0.5, 0.8] {
            let t = ts[k] * (1.0 - s) + ts[k + 1] * s;
            let gap = from_segment(line.eval(t), points[k], points[k + 1]);
            at_most(gap, room, format_args!("the polyline at {t}"))?;
        }
    }
    Ok(())
}
