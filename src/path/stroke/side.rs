//! The boundary of one side of a section of a stroke.
//!
//! Where it runs forward it is the envelope of the discs: an offset curve if the radius is constant. Where it runs
//! backwards, the chord between both sides turns about a point of itself, its pivot (the evolute if the radius is
//! constant), and what the part of the chord beyond the pivot sweeps counts as −1. There the boundary may be any line
//! between the pivots and the side: the winding number of points beyond it is then 0 instead of −1, and that of the other
//! points of the region is larger by at least 1. A few lines midway are shorter than the side, and stay away from the other
//! boundaries, whose errors could otherwise leave slivers uncovered.
//!
//! Around a point take f, the distance from the centre of a disc less its radius, as a function of t: the sides count the
//! minima of f up to 0 as +1 and its maxima as −1. In an interval with f below 0, minima and maxima alternate, so the count
//! is 1 if the interval ends inside the path. It can be 0 or −1 only if the interval ends at an end or corner and the point
//! lies ahead of that end. A round or square cap, a round join and a miter count such points once more; a butt cap and a
//! bevel do not, so what is swept backwards near them is added: the folds. On a closed subpath the count is 0 also where
//! f is nowhere above 0.

use super::section::{COMPARED, Disc, RIGHT, SectionEvaluator, value_of};
use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::work_limit::WorkLimit;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// Maximum depth of halvings of a side.
const MAX_HALVINGS: usize = 40;

/// Maximum number of attempted cubics for one side of a section.
const MAX_STEPS: usize = 1 << 17;

/// The cosine of the largest turn of a side between two of these points.
const MAX_TURN: f64 = 0.8;

/// The part of the tolerance that is allowed at these points; the rest is for the points between them.
const COMPARED_PART: f64 = 0.75;

/// A side is straight if it is this close to its chord, as a part of the tolerance.
const STRAIGHT_PART: f64 = 1.0 / 1024.0;

/// Rounds of least squares for the handles of a cubic, each with parameters nearer to the compared points.
const FIT_ROUNDS: usize = 4;

/// Maximum depth of halvings of lines midway.
const MAX_MIDWAY_HALVINGS: usize = 8;

/// The parts of an interval at whose ends its chords are compared with a line midway.
const MIDWAY_PARTS: usize = 8;

/// The parts of an interval that runs backwards at whose ends its chords are compared with blunt ends.
const FOLD_PARTS: usize = 16;

/// With more blunt ends than this, folds are added without comparison.
const MAX_COMPARED_ENDS: usize = 64;

/// Maximum depth of halvings of the curve of pivots.
const MAX_PIVOT_HALVINGS: usize = 12;

/// A curve of pivots with more segments is not divided further: its chords are rounding errors, and the union refuses so
/// many.
const MAX_FOLD_SEGMENTS: usize = 1 << 10;

/// Appends a line unless it has no length.
pub(super) fn push_line(chain: &mut SplineBuilder, to: DVec2) {
    if chain.points.last() != Some(&to) {
        chain.line_to(to);
    }
}

/// One side of a section.
pub(super) struct Side<'a> {
    pub(super) evaluator: &'a SectionEvaluator<'a>,
    /// The discs at the ends of the section.
    pub(super) ends: [Disc; 2],
    pub(super) side: f64,
    pub(super) tolerance: f64,
}

impl Side<'_> {
    /// Appends an interval that runs forward, or all of it backwards if the sign is −1, to a chain that ends at its start.
    pub(super) fn add(
        &self,
        [a, b]: [f64; 2],
        sign: f64,
        chain: &mut SplineBuilder,
    ) -> Result<(), Error> {
        let section = self.evaluator.section;
        if section.is_straight() {
            push_line(chain, self.point(b));
            return Ok(());
        }
        if section.radius.is_constant() {
            let distance = self.side * self.ends[0].radius;
            if [a, b] == [0.0, 1.0] {
                return chain.add_offset(&section.curve, distance, self.tolerance);
            }
            let part = section.curve.part(a, b);
            if part.has_size() {
                return chain.add_offset(&part, distance, self.tolerance);
            }
            return Ok(());
        }
        let mut work = WorkLimit::new(MAX_STEPS);
        let fit = SideFit {
            evaluator: self.evaluator,
            side: self.side,
            tolerance: self.tolerance,
            sign,
        };
        let ends = [a, b].map(|t| self.disc(t));
        fit.add([a, b], ends, MAX_HALVINGS, chain, &mut work);
        Error::unless_within("steps of a stroke", &work)
    }

    fn disc(&self, t: f64) -> Disc {
        if t == 0.0 || t == 1.0 {
            self.ends[usize::from(t == 1.0)]
        } else {
            self.evaluator.at(t)
        }
    }

    pub(super) fn point(&self, t: f64) -> DVec2 {
        self.disc(t).point(self.side)
    }

    /// The pivot of the chord at t, and its end on this side.
    fn chord(&self, t: f64) -> [DVec2; 2] {
        let (disc, values) = self.evaluator.evaluate(t);
        let [own, other] = [self.side, -self.side].map(|side| disc.point(side));
        let [ahead, beyond] = [self.side, -self.side].map(|side| values[value_of(side)]);
        let part = if beyond <= 0.0 {
            1.0 // the whole chord moves backwards
        } else {
            let part = ahead / (ahead - beyond);
            // At a cusp the curvature is infinite, and the pivot is in the middle.
            if part.is_nan() {
                0.5
            } else {
                part.clamp(0.0, 1.0)
            }
        };
        [own + (other - own) * part, own]
    }

    /// The point midway between the pivot and the side.
    fn midway(&self, t: f64) -> DVec2 {
        let [pivot, own] = self.chord(t);
        (pivot + own) * 0.5
    }

    /// Appends lines along an interval that runs backwards; the chain may be empty.
    pub(super) fn add_midway(&self, [from, to]: [f64; 2], chain: &mut SplineBuilder) {
        chain.start(self.point(from));
        if from == 0.0 {
            push_line(chain, self.midway(from));
        }
        self.add_midway_lines([from, to], MAX_MIDWAY_HALVINGS, chain);
        if to == 1.0 {
            push_line(chain, self.point(to));
        }
    }

    fn add_midway_lines(&self, [from, to]: [f64; 2], halvings: usize, chain: &mut SplineBuilder) {
        let ends = [from, to].map(|t| self.midway(t));
        let is_between = |k: usize| {
            let [pivot, own] = self.chord(from + (to - from) * (as_f64(k) / as_f64(MIDWAY_PARTS)));
            let side_of = |p: DVec2| (ends[1] - ends[0]).perp_dot(p - ends[0]);
            side_of(pivot) * side_of(own) <= 0.0
        };
        if halvings == 0 || (1..MIDWAY_PARTS).all(is_between) {
            return push_line(chain, ends[1]);
        }
        let middle = 0.5 * (from + to);
        self.add_midway_lines([from, middle], halvings - 1, chain);
        self.add_midway_lines([middle, to], halvings - 1, chain);
    }

    /// Whether a point of an interval that runs backwards may lie ahead of a blunt end, and within its disc.
    pub(super) fn is_near(&self, [from, to]: [f64; 2], blunt_ends: &[Disc]) -> bool {
        if blunt_ends.len() > MAX_COMPARED_ENDS {
            return true;
        }
        let at = |k: usize| self.chord(from + (to - from) * (as_f64(k) / as_f64(FOLD_PARTS)));
        let chords: Vec<[DVec2; 2]> = (0..=FOLD_PARTS).map(at).collect();
        let step = |pair: &[[DVec2; 2]]| {
            let moved = [0, 1].map(|k| Point::norm(pair[1][k] - pair[0][k]));
            moved[0].max(moved[1])
        };
        let slack = chords.windows(2).map(step).fold(0.0, f64::max);
        blunt_ends.iter().any(|disc| {
            let middle = disc.center - disc.tangent * (disc.slope * disc.radius);
            chords.iter().any(|&[a, b]| {
                let ahead = [a, b].map(|p| (p - middle).dot(disc.tangent));
                ahead[0].max(ahead[1]) > -slack
                    && distance_to_line(disc.center, a, b) <= disc.radius + slack
            })
        })
    }

    /// The contour of what is swept backwards: the side forwards and the pivots backwards.
    pub(super) fn fold(&self, [a, b]: [f64; 2]) -> Result<SplineBuilder, Error> {
        let mut fold = SplineBuilder::default();
        let start = self.point(a);
        fold.start(start);
        self.add([a, b], -1.0, &mut fold)?;
        let pivot = |t: f64| self.chord(t)[0];
        push_line(&mut fold, pivot(b));
        let thirds = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|part| pivot(b + (a - b) * part));
        let tolerance = 0.5 * self.tolerance;
        push_curve(
            &pivot,
            [b, a],
            thirds,
            tolerance,
            MAX_PIVOT_HALVINGS,
            &mut fold,
        );
        fold.line_to(start);
        if self.side == RIGHT {
            fold.points.reverse();
            fold.degrees.reverse();
        }
        Ok(fold)
    }
}

/// The distance of a point from a line segment.
fn distance_to_line(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let chord = b - a;
    let t = (p - a).dot(chord) / chord.dot(chord);
    let nearest = if t > 0.0 { a + chord * t.min(1.0) } else { a };
    Point::norm(p - nearest)
}

/// Appends cubics that interpolate a curve; `thirds` are its points at the ends and at the thirds of the interval.
///
/// Both what is swept forwards and what is swept backwards cover the convex side of the pivots, so an error moves the
/// boundary of the stroke by no more than itself.
fn push_curve(
    curve: &impl Fn(f64) -> DVec2,
    [from, to]: [f64; 2],
    [a, p, q, d]: [DVec2; 4],
    tolerance: f64,
    halvings: usize,
    out: &mut SplineBuilder,
) {
    let b = (p * 18.0 - a * 5.0 - q * 9.0 + d * 2.0) / 6.0;
    let c = (a * 2.0 - p * 9.0 + q * 18.0 - d * 5.0) / 6.0;
    let cubic = Curve::from_slice(&[a, b, c, d]);
    // Midway between the interpolated points; with these they are the thirds of both halves.
    let parts = [1.0 / 6.0, 0.5, 5.0 / 6.0];
    let midway = parts.map(|part| curve(from + (to - from) * part));
    let is_close = |k: usize| Point::norm(cubic.eval(parts[k]) - midway[k]) <= tolerance;
    let is_last = halvings == 0 || out.degrees.len() >= MAX_FOLD_SEGMENTS;
    if is_last || (0..3).all(is_close) {
        out.points.extend([b, c, d]);
        out.degrees.push(3);
        return;
    }
    let middle = 0.5 * (from + to);
    let halves = [
        ([from, middle], [a, midway[0], p, midway[1]]),
        ([middle, to], [midway[1], q, midway[2], d]),
    ];
    for (interval, thirds) in halves {
        push_curve(curve, interval, thirds, tolerance, halvings - 1, out);
    }
}

/// One side of a section of varying radius, for its approximation by cubics.
struct SideFit<'a> {
    evaluator: &'a SectionEvaluator<'a>,
    side: f64,
    tolerance: f64,
    /// −1 where the side runs backwards.
    sign: f64,
}

impl SideFit<'_> {
    /// Appends cubics for an interval, from the point of the side at its start.
    fn add(
        &self,
        [a, b]: [f64; 2],
        ends: [Disc; 2],
        halvings: usize,
        chain: &mut SplineBuilder,
        work: &mut WorkLimit,
    ) {
        let inside = &self.evaluator.compared([a, b]);
        let end = ends[1].point(self.side);
        if self.is_sampled(&ends, inside) {
            if self.is_straight(&ends, inside) {
                return push_line(chain, end);
            }
            if let Some([b, c]) = self.handles(&ends, inside) {
                chain.points.extend([b, c, end]);
                chain.degrees.push(3);
                return;
            }
        }
        if halvings == 0 || !work.spend(1) {
            return push_line(chain, end);
        }
        let middle = 0.5 * (a + b);
        let between = self.evaluator.at(middle);
        let halves = [
            ([a, middle], [ends[0], between]),
            ([middle, b], [between, ends[1]]),
        ];
        for (interval, ends) in halves {
            self.add(interval, ends, halvings - 1, chain, work);
        }
    }

    /// Whether the normal turns little between the compared points, so that they show all of the side.
    fn is_sampled(&self, ends: &[Disc; 2], inside: &[Disc]) -> bool {
        let mut last = &ends[0];
        inside.iter().chain([&ends[1]]).all(|disc| {
            let [a, b] = [last, disc].map(|disc| disc.normal(self.side));
            last = disc;
            let is_small = Point::norm(a - b) * disc.radius <= STRAIGHT_PART * self.tolerance;
            is_small || a.dot(b) >= MAX_TURN
        })
    }

    /// Whether the side is next to its chord, in order.
    fn is_straight(&self, ends: &[Disc; 2], inside: &[Disc]) -> bool {
        let [start, end] = ends.map(|disc| disc.point(self.side));
        let chord = end - start;
        let length = Point::norm(chord);
        let max = STRAIGHT_PART * self.tolerance;
        let mut along = -max;
        inside.iter().all(|disc| {
            let gap = disc.point(self.side) - start;
            if length <= max {
                return Point::norm(gap) <= max;
            }
            let last = along;
            along = gap.dot(chord) / length;
            gap.perp_dot(chord).abs() <= max * length
                && along >= last - max
                && along <= length + max
        })
    }

    /// The inner control points of the cubic with the same ends and end directions that has the least squares of the
    /// distances at the compared points; `None` if one of these is too large.
    fn handles(&self, ends: &[Disc; 2], inside: &[Disc; COMPARED.len()]) -> Option<[DVec2; 2]> {
        let [start, end] = ends.map(|disc| disc.point(self.side));
        let [d0, d1] = ends.map(|disc| disc.forward(self.side) * self.sign);
        let points = inside.map(|disc| disc.point(self.side));
        let mut ts = [0.0; COMPARED.len()];
        let mut length = 0.0;
        for (k, &p) in points.iter().enumerate() {
            length += Point::norm(p - if k == 0 { start } else { points[k - 1] });
            ts[k] = length;
        }
        length += Point::norm(end - points[COMPARED.len() - 1]);
        ts.iter_mut().for_each(|t| *t /= length);
        let mut worst = f64::INFINITY;
        let mut handles = [start, end];
        for _ in 0..FIT_ROUNDS {
            let arms = self.arms([start, end], [d0, d1], inside, &points, &ts, length);
            handles = [start + d0 * arms[0], end - d1 * arms[1]];
            let cubic = [start, handles[0], handles[1], end];
            let with = CurveWithDerivatives::new(&cubic);
            let before = worst;
            worst = 0.0;
            let mut last = 0.0;
            for (k, &p) in points.iter().enumerate() {
                for _ in 0..2 {
                    let [q, first, _] = with.jet(ts[k]);
                    let step = (q - p).dot(first) / first.dot(first);
                    if step.is_finite() {
                        ts[k] = (ts[k] - step).clamp(0.0, 1.0);
                    }
                }
                // The sides of a thin stroke must not cross.
                let most = (COMPARED_PART * self.tolerance).min(0.5 * inside[k].radius);
                let distance =
                    Point::norm(with.at(ts[k]) - p) / most.max(STRAIGHT_PART * self.tolerance);
                // The feet of the points must have their order.
                worst = if ts[k] >= last {
                    distance.max(worst)
                } else {
                    f64::INFINITY
                };
                last = ts[k];
            }
            if worst <= 1.0 {
                return Some(handles);
            }
            if worst > 0.5 * before {
                return None;
            }
        }
        (worst <= 1.0).then_some(handles)
    }

    /// The lengths of both handles.
    fn arms(
        &self,
        [start, end]: [DVec2; 2],
        [d0, d1]: [DVec2; 2],
        inside: &[Disc; COMPARED.len()],
        points: &[DVec2; COMPARED.len()],
        ts: &[f64; COMPARED.len()],
        length: f64,
    ) -> [f64; 2] {
        let (mut aa, mut ab, mut bb, mut ar, mut br) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (k, disc) in inside.iter().enumerate() {
            let (t, normal) = (ts[k], disc.normal(self.side));
            let u = 1.0 - t;
            let (w1, w2) = (3.0 * u * u * t, 3.0 * u * t * t);
            let fixed = start * (u * u * u + w1) + end * (t * t * t + w2);
            let (a, b) = (w1 * d0.dot(normal), -w2 * d1.dot(normal));
            let rest = (points[k] - fixed).dot(normal);
            aa += a * a;
            ab += a * b;
            bb += b * b;
            ar += a * rest;
            br += b * rest;
        }
        let det = aa * bb - ab * ab;
        let arms = [(bb * ar - ab * br) / det, (aa * br - ab * ar) / det];
        let is_plain = |arm: f64| (0.0..=length).contains(&arm);
        if det > 1e-9 * aa * bb && arms.iter().all(|&arm| is_plain(arm)) {
            return arms;
        }
        [length / 3.0; 2]
    }
}
