//! Corners of a path replaced by arcs.

use super::corner_arc::{CornerArc, corner_arc, is_corner};
use super::options::CornerOptions;
use crate::curve::Curve;
use crate::geometry::check::{check_tolerance, clamp_to_limit};
use crate::geometry::error::Error;
use crate::numeric::float::as_f64;
use crate::numeric::sort::sort_by;
use crate::path::{Path, PathTime, Subpath};
use casteljau_kernels::numeric::order::larger;
use casteljau_kernels::spline::offset::offset_curve::add_arc;
use glam::DVec2;

/// The largest distance of the cubics from an arc, as a part of its radius.
const ARC_TOLERANCE: f64 = 1e-9;

const RADIUS_RANGE: &str = "a finite number, at least 0";

/// Two arcs meet if at most this part of the parameters of a segment is between them.
const MEETING_TOLERANCE: f64 = 1e-12;

/// The largest number of segments on each side of a corner that an arc can replace.
const MAX_RUN: usize = 64;

impl Path {
    /// The path with its corners replaced by arcs of a radius that are tangent to both segments at the corner.
    ///
    /// A corner is a joint where the tangent turns by 0.06° to 179.94°; other joints stay, and so do the ends of open
    /// subpaths. A closed subpath is rounded at its start, too, and then starts at the end of that arc. At straight
    /// segments that turn by θ the arc starts r tan(θ/2) before the corner. At curves its centre is the intersection of
    /// their offset curves at the distance r that is reached from the corner as the radius grows from 0. Arcs are cubics
    /// within 10⁻⁹ of their radius. Segments that no arc replaces are returned bit for
    /// bit.
    ///
    /// An arc replaces at most the 64 segments on each side that follow each other without a corner or a turn by 180°. Where these are too
    /// short, or bend more tightly than the arc, the radius at this corner is the largest one that fits. Where arcs at
    /// two corners overlap, one that needs at most half of the segments between them (in the parameter) keeps its radius, and
    /// the other one ends where it starts; if both need more, both end in the middle. Segments of length 0
    /// in the place of an arc are omitted. A corner stays if its radius is below 10⁻⁹ of the size of its segments. A
    /// radius of 0 returns the path.
    ///
    /// ```
    /// use casteljau::Path;
    ///
    /// let square: Path = "M0 0H10V10H0Z".parse().expect("path data");
    /// let area = square.round_corners(2.0)?.area();
    /// assert!((area - (100.0 - (4.0 - std::f64::consts::PI) * 4.0)).abs() < 1e-7);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// Coordinates that an arc next to the limit of coordinates would exceed are set to it.
    ///
    /// # Errors
    /// [`Error::Range`] for a radius that is negative or not finite.
    pub fn round_corners(&self, radius: f64) -> Result<Self, Error> {
        self.round_corners_with(radius, &CornerOptions::default())
    }

    /// [`round_corners`](Self::round_corners) at some corners only, or with fewer cubics within a tolerance.
    ///
    /// # Errors
    /// As [`round_corners`](Self::round_corners); [`Error::Index`] for a corner on a subpath that does not exist;
    /// [`Error::Range`] for one that is not at a joint, and for a tolerance that is not finite, not above 0 or below 4
    /// ulps of the largest coordinate.
    pub fn round_corners_with(&self, radius: f64, options: &CornerOptions) -> Result<Self, Error> {
        if !is_radius(radius) {
            return Err(Error::Range {
                what: "radius",
                expected: RADIUS_RANGE,
                got: radius,
            });
        }
        self.rounded(&mut |_| Ok(radius), options)
    }

    /// [`round_corners`](Self::round_corners) with a radius for each corner; 0 leaves a corner.
    ///
    /// The function is called once for each corner, in the order of the path: by subpath, then by t. The corner at the
    /// start of a closed subpath is its first one. With the option `corners`, it is called for each of these in their
    /// order, and the largest radius for a joint counts.
    ///
    /// ```
    /// use casteljau::{Path, path::CornerOptions};
    ///
    /// let square: Path = "M0 0H10V10H0Z".parse().expect("path data");
    /// let mut radii = [4.0, 4.0, 0.0, 0.0].into_iter();
    /// let arch = square.round_corners_by(|_| radii.next().unwrap_or(0.0), &CornerOptions::new())?;
    /// assert!((arch.area() - (100.0 - 0.5 * (4.0 - std::f64::consts::PI) * 16.0)).abs() < 1e-7);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Item`] for a radius that is negative or not finite, with the number of calls before it; otherwise as
    /// [`round_corners_with`](Self::round_corners_with).
    pub fn round_corners_by(
        &self,
        mut radius: impl FnMut(PathTime) -> f64,
        options: &CornerOptions,
    ) -> Result<Self, Error> {
        let mut calls = 0..;
        let mut checked = |corner| {
            let (got, index) = (radius(corner), calls.next().unwrap_or_default());
            if is_radius(got) {
                return Ok(got);
            }
            Err(Error::Item {
                what: "radius",
                index,
                expected: RADIUS_RANGE,
                got,
            })
        };
        self.rounded(&mut checked, options)
    }

    fn rounded(
        &self,
        radius_at: &mut dyn FnMut(PathTime) -> Result<f64, Error>,
        options: &CornerOptions,
    ) -> Result<Self, Error> {
        if let Some(tolerance) = options.tolerance {
            check_tolerance(tolerance, self.max_abs())?;
        }
        let mut chosen = Vec::new();
        for &corner in options.corners.as_deref().unwrap_or_default() {
            self.check_joint(corner)?;
            chosen.push((corner, radius_at(corner)?));
        }
        sort_by(&mut chosen, |a, b| a.0.total_cmp(&b.0));
        let mut rest = chosen.as_slice();
        let mut path = Self::default();
        for (subpath, part) in self.parts().enumerate() {
            let (own, others) =
                rest.split_at(rest.partition_point(|(corner, _)| corner.subpath <= subpath));
            rest = others;
            let mut rounded = RoundedSubpath::new(part);
            for corner in rounded.corners_in_order() {
                rounded.radii[corner] = if options.corners.is_some() {
                    rounded.chosen_radius(corner, own)
                } else {
                    radius_at(PathTime::new(subpath, rounded.joint_after(corner)))?
                };
            }
            rounded.fit_arcs();
            rounded.push_to(&mut path, options.tolerance);
        }
        Ok(path)
    }

    fn check_joint(&self, corner: PathTime) -> Result<(), Error> {
        let t = self.checked(corner)?.t;
        if t.fract() == 0.0 && t >= 0.0 && t <= self.end_of(corner.subpath).t {
            return Ok(());
        }
        Err(Error::Range {
            what: "corners",
            expected: "the t of a joint",
            got: t,
        })
    }
}

fn is_radius(radius: f64) -> bool {
    radius >= 0.0 && radius.is_finite()
}

/// A subpath and the arcs at its corners.
struct RoundedSubpath<'a> {
    part: Subpath<'a>,
    /// The segments that are not points, and their indices in the subpath.
    curves: Vec<Curve<DVec2>>,
    indices: Vec<usize>,
    /// Whether there is a corner at the end of each of these segments.
    corners: Vec<bool>,
    /// Its radius; 0 where it stays, and where there is none.
    radii: Vec<f64>,
    /// Whether the path turns back there.
    reversals: Vec<bool>,
    arcs: Vec<Option<CornerArc>>,
    /// The arcs that replace the start and the end of each of these segments.
    replaced: Vec<[Option<ReplacedPart>; 2]>,
}

/// The part of a segment, as an interval of its parameter at one of its ends, that an arc replaces.
#[derive(Clone, Copy)]
struct ReplacedPart {
    corner: usize,
    part: f64,
}

impl<'a> RoundedSubpath<'a> {
    /// All radii are 0 at first.
    fn new(part: Subpath<'a>) -> Self {
        let segments = part.segments().map(Curve::from_slice).enumerate();
        let (indices, curves): (Vec<usize>, Vec<Curve<DVec2>>) =
            segments.filter(|(_, curve)| curve.has_size()).unzip();
        let count = curves.len();
        let tangents = |k: usize| {
            let next = &curves[(k + 1) % count];
            [curves[k].end_tangent(), next.start_tangent()]
        };
        let is_corner_after = |k| (part.closed || k + 1 < count) && is_corner(tangents(k));
        let turns_back_after = |k| {
            let [before, after] = tangents(k);
            before.dot(after) < 0.0
        };
        Self {
            part,
            radii: vec![0.0; count],
            corners: (0..count).map(is_corner_after).collect(),
            reversals: (0..count).map(turns_back_after).collect(),
            arcs: vec![None; count],
            replaced: vec![[None; 2]; count],
            curves,
            indices,
        }
    }

    /// The segments that end at a corner, in the order of these corners: that at the start of a closed subpath is first.
    fn corners_in_order(&self) -> Vec<usize> {
        let last = self.curves.len().checked_sub(1);
        let all = last.into_iter().chain(0..last.unwrap_or(0));
        all.filter(|&k| self.corners[k]).collect()
    }

    /// The joint at the start of the segment after segment k.
    fn joint_after(&self, k: usize) -> f64 {
        as_f64(self.indices[(k + 1) % self.curves.len()])
    }

    /// The radius of the corner at the end of segment k: the largest one for a chosen joint there, otherwise 0.
    ///
    /// `chosen`: joints of the subpath in order. Segments that are points may follow segment k: the joints at both of
    /// their ends are those of the corner.
    fn chosen_radius(&self, k: usize, chosen: &[(PathTime, f64)]) -> f64 {
        let total = self.part.segment_count();
        let next = self.indices[(k + 1) % self.curves.len()];
        let first = self.indices[k] + 1;
        let last = if next >= first { next } else { next + total };
        // In this round of a closed subpath or in the next one.
        let rounds = [0.0, as_f64(total)].map(|turn| {
            let after = chosen.partition_point(|(joint, _)| joint.t + turn < as_f64(first));
            let at_corner = chosen[after..].iter();
            at_corner
                .take_while(|(joint, _)| joint.t + turn <= as_f64(last))
                .fold(0.0, |max, &(_, radius)| larger(max, radius))
        });
        larger(rounds[0], rounds[1])
    }

    /// Finds the arcs. Where two overlap, one that reaches at most half of the way keeps its length, and the other one ends
    /// there; otherwise both end in the middle.
    fn fit_arcs(&mut self) {
        let count = self.curves.len();
        let runs: Vec<[usize; 2]> = (0..count)
            .map(|k| [0, 1].map(|side| self.smooth_run(k, side)))
            .collect();
        let mut limits: Vec<[f64; 2]> = runs
            .iter()
            .map(|run| run.map(|n| n.min(MAX_RUN) as f64))
            .collect();
        for (k, &limit) in limits.iter().enumerate() {
            self.arcs[k] = self.arc(k, limit);
        }
        self.mark_replaced_parts();
        let mut overlapping = Vec::new();
        for k in (0..count).filter(|&k| self.replaced_fraction(k) > 1.0 + MEETING_TOLERANCE) {
            if let [Some(start), Some(end)] = self.replaced[k] {
                // Each arc may use what the other one leaves, and at least half of the segments between both corners.
                let room = runs[start.corner][1] as f64;
                let rest = |corner: usize, side: usize| {
                    room - self.arcs[corner].map_or(0.0, |arc| arc.from_corner[side])
                };
                limits[start.corner][1] = larger(0.5 * room, rest(end.corner, 0));
                limits[end.corner][0] = larger(0.5 * room, rest(start.corner, 1));
                overlapping.extend([start.corner, end.corner]);
            }
        }
        overlapping.dedup();
        for &k in &overlapping {
            self.arcs[k] = self.arc(k, limits[k]);
        }
        self.mark_replaced_parts();
    }

    /// The index of the segment before segment k.
    fn before(&self, k: usize) -> usize {
        k.checked_sub(1).unwrap_or(self.curves.len() - 1)
    }

    /// Segment k of those that lead away from the corner at the end of a segment, backwards (0) or forwards (1).
    fn segment_from_corner(&self, corner: usize, side: usize, k: usize) -> usize {
        let count = self.curves.len();
        if side == 0 {
            (corner + count - k) % count
        } else {
            (corner + 1 + k) % count
        }
    }

    /// The number of segments that lead smoothly away from a corner, up to twice the largest number of a side.
    fn smooth_run(&self, corner: usize, side: usize) -> usize {
        if !self.corners[corner] {
            return 0;
        }
        let count = self.curves.len();
        let ends = |k: usize| {
            let segment = self.segment_from_corner(corner, side, k);
            let joint = if side == 0 {
                self.before(segment)
            } else {
                segment
            };
            let is_end = !self.part.closed && joint == count - 1;
            self.corners[joint] || self.reversals[joint] || is_end
        };
        let limit = count.min(2 * MAX_RUN);
        1 + (0..limit - 1).take_while(|&k| !ends(k)).count()
    }

    /// The arc at the end of segment k.
    fn arc(&self, k: usize, limits: [f64; 2]) -> Option<CornerArc> {
        if self.radii[k] == 0.0 {
            return None;
        }
        let side = |side: usize| -> Vec<Curve<DVec2>> {
            let count = self.smooth_run(k, side).min(MAX_RUN);
            let curves = (0..count).map(|i| &self.curves[self.segment_from_corner(k, side, i)]);
            curves
                .map(|curve| {
                    if side == 0 {
                        curve.reverse()
                    } else {
                        curve.clone()
                    }
                })
                .collect()
        };
        corner_arc(&[side(0), side(1)], self.radii[k], limits)
    }

    /// Finds the segments that the arcs replace.
    fn mark_replaced_parts(&mut self) {
        self.replaced.fill([None; 2]);
        for corner in 0..self.curves.len() {
            let Some(arc) = self.arcs[corner] else {
                continue;
            };
            for (side, &from_corner) in arc.from_corner.iter().enumerate() {
                let (mut rest, mut k) = (from_corner, 0);
                while rest > 0.0 {
                    let segment = self.segment_from_corner(corner, side, k);
                    let part = rest.min(1.0);
                    self.replaced[segment][1 - side] = Some(ReplacedPart { corner, part });
                    (rest, k) = (rest - 1.0, k + 1);
                }
            }
        }
    }

    /// The part of segment k that arcs replace.
    fn replaced_fraction(&self, k: usize) -> f64 {
        self.replaced[k]
            .iter()
            .flatten()
            .map(|replaced| replaced.part)
            .sum()
    }

    /// An end of an arc.
    fn end(&self, part: ReplacedPart, side: usize) -> Option<DVec2> {
        self.arcs[part.corner].map(|arc| arc.ends[side])
    }

    /// The start of the subpath.
    fn start(&self) -> DVec2 {
        let moved = match self.replaced[0] {
            [Some(start), _] => self.end(start, 1),
            [None, Some(end)] if end.part >= 1.0 => self.end(end, 0),
            _ => None,
        };
        moved.unwrap_or(self.part.points[0])
    }

    fn push_to(&self, path: &mut Path, tolerance: Option<f64>) {
        if self.arcs.iter().all(Option::is_none) {
            let count = self.part.points.len() - usize::from(self.part.closed);
            let points = &self.part.points[..count];
            return path.push(points, self.part.degrees(), self.part.closed);
        }
        let mut out = SubpathBuilder {
            points: vec![self.start()],
            degrees: Vec::new(),
        };
        let mut k = 0;
        for points in self.part.segments() {
            if points.iter().any(|&p| p != points[0]) {
                self.push_segment(k, &mut out, tolerance);
                k += 1;
            } else if self.keeps_point(k) {
                out.add(points);
            }
        }
        if self.part.closed {
            out.points.pop();
        }
        out.points.iter_mut().for_each(|p| *p = clamp_to_limit(*p));
        path.push(&out.points, out.degrees, self.part.closed);
    }

    /// Whether no arc replaces the joint before segment k.
    fn keeps_point(&self, k: usize) -> bool {
        let before = self.replaced[self.before(k)][1];
        let after = self.replaced[k % self.curves.len()][0];
        before.is_none() && after.is_none()
    }

    /// Appends what is left of segment k, and the arc after it.
    fn push_segment(&self, k: usize, out: &mut SubpathBuilder, tolerance: Option<f64>) {
        if self.replaced_fraction(k) < 1.0 - MEETING_TOLERANCE {
            out.add(&self.remaining_part(k));
        }
        if let Some(arc) = self.arcs[k] {
            out.add_arc(&arc, tolerance);
        }
    }

    /// The control points of what is left of segment k.
    fn remaining_part(&self, k: usize) -> Vec<DVec2> {
        let curve = &self.curves[k];
        let [start, end] = self.replaced[k];
        if start.is_none() && end.is_none() {
            return curve.control_points().to_vec();
        }
        let [from, to] =
            [start, end].map(|replaced| replaced.map_or(0.0, |replaced| replaced.part));
        let mut rest = curve.part(from, 1.0 - to).control_points().to_vec();
        let last = rest.len() - 1;
        if let Some(p) = start.and_then(|part| self.end(part, 1)) {
            rest[0] = p;
        }
        if let Some(p) = end.and_then(|part| self.end(part, 0)) {
            rest[last] = p;
        }
        rest
    }
}

/// A subpath under construction.
struct SubpathBuilder {
    points: Vec<DVec2>,
    degrees: Vec<usize>,
}

impl SubpathBuilder {
    /// Appends a segment that starts at the last point.
    fn add(&mut self, points: &[DVec2]) {
        self.points.extend(&points[1..]);
        self.degrees.push(points.len() - 1);
    }

    /// `tolerance`: the largest distance from the arc, by default a small part of its radius.
    fn add_arc(&mut self, arc: &CornerArc, tolerance: Option<f64>) {
        let [from, to] = arc.tangents;
        let angle = from.perp_dot(to).atan2(from.dot(to));
        // The start is the origin.
        let center = from.perp() * arc.radius;
        let mut points = Vec::new();
        let default = ARC_TOLERANCE * arc.radius.abs();
        let tolerance = tolerance.map_or(default, |tolerance| tolerance / arc.unit);
        add_arc(
            [center; 2],
            [from, to],
            angle,
            -arc.radius,
            tolerance,
            &mut points,
        );
        let count = points.len();
        self.points
            .extend(points.iter().map(|&p| arc.ends[0] + p * arc.unit));
        self.degrees.extend(std::iter::repeat_n(3, count / 3));
        if let Some(last) = self.points.last_mut() {
            *last = arc.ends[1];
        }
    }
}
