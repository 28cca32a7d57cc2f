//! Approximation of a path by lines and arcs of circles.

use super::Path;
use crate::bernstein::product::Binomials;
use crate::curve::Curve;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::list::Scalars;
use casteljau_kernels::bernstein::de_casteljau::halve;
use glam::DVec2;
use std::f64::consts::PI;

/// The largest number of lines and arcs.
const MAX_ARCS: usize = 1 << 22;
/// Halvings of a step along a curve: shorter steps are below the rounding of the parameter.
const STEP_HALVINGS: u32 = f64::MANTISSA_DIGITS - 1;
/// Bisections of the search for the longest part that two arcs approximate, between a length and its double.
const REFINEMENTS: usize = 8;
/// Halvings of a polynomial whose coefficients do not decide yet whether it keeps a bound. The distance of the coefficients
/// from the polynomial falls by 4 with each, to 2⁻¹²; a bound that is not decided then counts as not kept.
const MAX_DEPTH: usize = 6;
/// The part of the tolerance that joining arcs of nearly the same circle may take.
const JOIN_SHARE: f64 = 0.05;
/// A part within this share of the tolerance of a line is not replaced by arcs of huge radius.
const LINE_SHARE: f64 = 0.01;
/// The rounding of coordinates of a curve of size 1.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A line or an arc of a circle: a part of [`Path::to_arcs`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct CircularArc {
    /// The start.
    pub start: DVec2,
    /// The end.
    pub end: DVec2,
    /// The centre of the circle; `None` for a line.
    pub center: Option<DVec2>,
    /// The radius; infinite for a line.
    pub radius: f64,
    /// The angle from the x-axis to the start as seen from the centre, from −π to π; 0 for a line.
    pub start_angle: f64,
    /// The angle to the end: larger than the start angle for a counter-clockwise arc (x right, y up); 0 for a line.
    pub end_angle: f64,
}

impl Path {
    /// The subpaths as lines and arcs of circles, for machines that have no other curves (G-code G1 to G3).
    ///
    /// Each arc starts where the previous one ends. Within a segment the arcs are pairs with a common tangent (biarcs)
    /// that also have the tangents of the curve, each pair as long as the tolerance permits; straight parts are lines,
    /// and neighbouring arcs of one circle are joined, up to half a turn. The Hausdorff distance of a subpath from its
    /// arcs is at most the tolerance: of the polynomial |B(t) − c|² − r² its Bernstein coefficients are bounded. The
    /// rounding of centre and angles adds some 10⁻¹⁵ of the radius. There are about (size / tolerance)^⅓ arcs.
    ///
    /// A subpath that is a point gives one line of length 0. Source of the pairs: K. M. Bolton, "Biarc curves",
    /// Computer-Aided Design 7 (1975).
    ///
    /// ```
    /// use casteljau::{Path, glam::DVec2};
    ///
    /// let circle = Path::circle(DVec2::new(3.0, 4.0), 2.0)?;
    /// let arcs = circle.to_arcs(1e-3)?;
    /// assert_eq!(arcs[0].len(), 2);
    /// assert!((arcs[0][0].radius - 2.0).abs() < 1e-3);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a tolerance not above 0 or below 4 ulps of the largest coordinate; [`Error::TooMany`] for more
    /// than 2²² arcs.
    pub fn to_arcs(&self, tolerance: f64) -> Result<Vec<Vec<CircularArc>>, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        let mut count = 0;
        let mut subpaths = Vec::new();
        for part in self.parts() {
            let mut arcs = Vec::new();
            for points in part.segments() {
                append_arcs(&Curve::from_slice(points), tolerance, &mut arcs);
                if count + arcs.len() > MAX_ARCS {
                    return Err(Error::too_many("arcs", MAX_ARCS, count + arcs.len()));
                }
            }
            let arcs = joined(arcs, JOIN_SHARE * tolerance);
            count += arcs.len();
            subpaths.push(arcs);
        }
        Ok(subpaths)
    }
}

/// An arc by its ends, the tangent at its start and its signed curvature.
#[derive(Clone, Copy)]
struct TangentArc {
    start: DVec2,
    tangent: DVec2,
    curvature: f64,
    end: DVec2,
}

impl TangentArc {
    /// The arc with a tangent at its start to another point.
    fn new(start: DVec2, tangent: DVec2, end: DVec2) -> Self {
        let chord = end - start;
        let curvature = 2.0 * tangent.perp_dot(chord) / chord.length_squared();
        Self {
            start,
            tangent,
            curvature: if curvature.is_finite() {
                curvature
            } else {
                0.0
            },
            end,
        }
    }

    fn line(start: DVec2, end: DVec2) -> Self {
        Self {
            start,
            tangent: Point::unit(end - start),
            curvature: 0.0,
            end,
        }
    }

    /// The angle by which the tangent turns.
    fn turn(&self) -> f64 {
        let chord = self.end - self.start;
        if self.curvature == 0.0 {
            return 0.0;
        }
        2.0 * self.tangent.perp_dot(chord).atan2(self.tangent.dot(chord))
    }

    /// The tangent at the end: that at the start, reflected in the chord.
    fn end_tangent(&self) -> DVec2 {
        let chord = Point::unit(self.end - self.start);
        2.0 * self.tangent.dot(chord) * chord - self.tangent
    }

    /// Whether a part of a curve from the start to the end stays within a distance of the arc.
    ///
    /// With D = B − start and the normal N at the start, (|B − c|² − r²) / 2r = ½ κ |D|² − D·N. The distance of B from the
    /// circle is at most ε if this lies between −ε + ½ κ ε² and ε + ½ κ ε² (for κ > 0, otherwise the signs change). A curve
    /// within the ring that begins and ends at the ends of the arc also passes each of its angles; it stays between the
    /// rays through these ends if D·T ≥ 0 there, and likewise at the end.
    fn is_near(&self, points: &[DVec2], tolerance: f64) -> bool {
        let normal = self.tangent.perp();
        let n = points.len() - 1;
        let from_start = |i: usize| points[i] - self.start;
        let from_end = |i: usize| points[i] - self.end;
        let end_tangent = self.end_tangent();
        let behind = -ROUNDING;
        let is_between = (0..=n).all(|i| {
            from_start(i).dot(self.tangent) >= behind && from_end(i).dot(end_tangent) <= -behind
        });
        let has_direction = self.tangent != DVec2::ZERO;
        if !(has_direction && is_between) {
            return false;
        }
        let distances = Binomials::new(n, n).product(|i, j| {
            let [a, b] = [from_start(i), from_start(j)];
            0.5 * self.curvature * a.dot(b) - 0.5 * (a + b).dot(normal)
        });
        let shift = 0.5 * self.curvature * tolerance * tolerance;
        stays_between(distances, -tolerance + shift, tolerance + shift, MAX_DEPTH)
    }

    /// The arc in the unit of the path.
    fn to_arc(self, map: &Normalized<DVec2>) -> CircularArc {
        let [start, end] = [self.start, self.end].map(|p| map.inverse(p));
        let line = CircularArc {
            start,
            end,
            center: None,
            radius: f64::INFINITY,
            start_angle: 0.0,
            end_angle: 0.0,
        };
        let radius = 1.0 / self.curvature;
        let center = self.start + self.tangent.perp() * radius;
        let turn = self.turn();
        // The sagitta of a nearly straight arc is below the rounding of its ends.
        let is_straight = Point::norm(self.end - self.start) * turn.abs() < ROUNDING;
        if self.curvature == 0.0 || is_straight {
            return line;
        }
        let from_center = self.start - center;
        let start_angle = from_center.y.atan2(from_center.x);
        CircularArc {
            center: Some(map.inverse(center)),
            radius: radius.abs() / map.scale,
            start_angle,
            end_angle: start_angle + turn,
            ..line
        }
    }
}

/// Whether a polynomial with these Bernstein coefficients stays between two bounds on 0 to 1; no if `depth` halvings do
/// not decide it.
fn stays_between(mut coefficients: Scalars, min: f64, max: f64, depth: usize) -> bool {
    let holds = |x: &f64| (min..=max).contains(x);
    if coefficients.iter().all(holds) {
        return true;
    }
    let ends = [coefficients.first(), coefficients.last()];
    if depth == 0 || !ends.into_iter().flatten().all(holds) {
        return false;
    }
    let mut right = coefficients.clone();
    halve(&mut coefficients, &mut right);
    stays_between(coefficients, min, max, depth - 1) && stays_between(right, min, max, depth - 1)
}

/// Two arcs with a common tangent, which have the tangents of a part of a curve at its ends, if they are near enough.
fn fit_biarc(part: &Curve<DVec2>, tolerance: f64) -> Option<[TangentArc; 2]> {
    let points = part.control_points();
    let [p0, p1] = [points[0], points[points.len() - 1]];
    let [t0, t1] = [part.start_tangent(), part.end_tangent()];
    // The two tangents have the same length d: |V|² = 2 d V·(T₀ + T₁) + 2 d² (1 − T₀·T₁).
    let v = p1 - p0;
    let (a, b, c) = (
        2.0 * (1.0 - t0.dot(t1)),
        2.0 * v.dot(t0 + t1),
        v.length_squared(),
    );
    let root = (b * b + 4.0 * a * c).sqrt();
    let d = if b > 0.0 {
        2.0 * c / (b + root)
    } else {
        (root - b) / (2.0 * a)
    };
    let [q0, q1] = [p0 + t0 * d, p1 - t1 * d];
    let joint = 0.5 * (q0 + q1);
    let tangent = Point::unit(q1 - q0);
    if !(d > 0.0 && joint.is_finite() && tangent.length_squared() > 0.5) {
        return None;
    }
    let first = TangentArc::new(p0, t0, joint);
    let second = TangentArc::new(joint, tangent, p1);
    // Neither turns by more than 90°.
    if t0.dot(tangent) < 0.0 || tangent.dot(t1) < 0.0 {
        return None;
    }
    let u = parameter_across(points, joint, tangent);
    let [before, after] = [part.part(0.0, u), part.part(u, 1.0)];
    let is_near = first.is_near(before.control_points(), tolerance)
        && second.is_near(after.control_points(), tolerance);
    is_near.then_some([first, second])
}

/// A parameter at which a curve crosses the line through a point across a direction.
fn parameter_across(points: &[DVec2], through: DVec2, direction: DVec2) -> f64 {
    let mut along: Scalars = points
        .iter()
        .map(|&p| (p - through).dot(direction))
        .collect();
    let (mut from, mut to) = (0.0, 1.0);
    for _ in 0..STEP_HALVINGS {
        let mut right = along.clone();
        halve(&mut along, &mut right);
        let middle = 0.5 * (from + to);
        if right[0] < 0.0 {
            (from, along) = (middle, right);
        } else {
            to = middle;
        }
    }
    0.5 * (from + to)
}

/// The line from the start to the end of a part of a curve, if it is near enough.
fn fit_line(part: &Curve<DVec2>, tolerance: f64) -> Option<TangentArc> {
    let points = part.control_points();
    let arc = TangentArc::line(points[0], points[points.len() - 1]);
    let reach = points.iter().map(|&p| Point::norm(p - points[0]));
    let is_small = reach.fold(0.0, f64::max) <= tolerance;
    (is_small || arc.is_near(points, tolerance)).then_some(arc)
}

/// The lines and arcs of one segment.
fn append_arcs(curve: &Curve<DVec2>, tolerance: f64, arcs: &mut Vec<CircularArc>) {
    let map = Normalized::around(curve.start(), curve.control_points());
    let unit = Curve::from_points(map.points(curve.control_points()));
    let tolerance = (tolerance * map.scale * (1.0 - JOIN_SHARE)).max(ROUNDING);
    let (mut from, mut step) = (0.0, 1.0);
    while from < 1.0 && arcs.len() <= MAX_ARCS {
        let (to, found) = longest_arcs(&unit, from, step, tolerance);
        step = 2.0 * (to - from);
        arcs.extend(found.into_iter().flatten().map(|arc| arc.to_arc(&map)));
        from = to;
    }
    // Exact joints between segments.
    if let Some(last) = arcs.last_mut() {
        last.end = curve.end();
    }
}

/// The longest part from a parameter, up to the precision of a few bisections, that a line or two arcs approximate; the search
/// begins with a given step.
fn longest_arcs(
    curve: &Curve<DVec2>,
    from: f64,
    mut step: f64,
    tolerance: f64,
) -> (f64, [Option<TangentArc>; 2]) {
    let fit = |to: f64| {
        let part = curve.part(from, to);
        let line = |tolerance| fit_line(&part, tolerance).map(|line| [Some(line), None]);
        let pair = || fit_biarc(&part, tolerance).map(|pair| pair.map(Some));
        line(LINE_SHARE * tolerance)
            .or_else(pair)
            .or_else(|| line(tolerance))
    };
    let end_of = |step: f64| if from + step < 1.0 { from + step } else { 1.0 };
    let mut best = None;
    let mut too_far = None;
    step = step.min(1.0 - from);
    for _ in 0..2 * STEP_HALVINGS {
        let to = end_of(step);
        if to == from {
            break;
        }
        match fit(to) {
            Some(found) => best = Some((to, found)),
            None => too_far = Some(to),
        }
        if best.is_some() && (too_far.is_some() || to == 1.0) {
            break;
        }
        step *= if best.is_some() { 2.0 } else { 0.5 };
    }
    let Some((mut to, mut found)) = best else {
        // The part is shorter than the rounding of its parameters.
        let to = end_of(step.max(f64::EPSILON));
        let part = curve.part(from, to);
        let points = part.control_points();
        return (
            to,
            [
                Some(TangentArc::line(points[0], points[points.len() - 1])),
                None,
            ],
        );
    };
    if let Some(mut too_far) = too_far {
        for _ in 0..REFINEMENTS {
            let middle = 0.5 * (to + too_far);
            match fit(middle) {
                Some(fitted) => (to, found) = (middle, fitted),
                None => too_far = middle,
            }
        }
    }
    (to, found)
}

/// The arcs with neighbours of nearly the same circle, or on one line, joined.
fn joined(arcs: Vec<CircularArc>, tolerance: f64) -> Vec<CircularArc> {
    let mut result: Vec<CircularArc> = Vec::with_capacity(arcs.len());
    // The arcs that the last one of the result replaces begin here.
    let mut first = 0;
    for (k, arc) in arcs.iter().enumerate() {
        let whole = result
            .last()
            .and_then(|last| joined_pair(last, arc))
            .filter(|whole| {
                arcs[first..=k]
                    .iter()
                    .all(|part| is_near_arc(part, whole, tolerance))
            });
        match (whole, result.last_mut()) {
            (Some(whole), Some(last)) if k - first < MAX_JOINED => *last = whole,
            _ => {
                result.push(*arc);
                first = k;
            }
        }
    }
    result
}

/// The largest number of arcs that one arc replaces.
const MAX_JOINED: usize = 64;

/// The arc from the start of one to the end of the next with the tangent of the first at its start.
fn joined_pair(a: &CircularArc, b: &CircularArc) -> Option<CircularArc> {
    let (center, _) = (a.center?, b.center?);
    let turns = [a, b].map(|arc| arc.end_angle - arc.start_angle);
    let turn = turns[0] + turns[1];
    if turns[0] * turns[1] <= 0.0 || turn.abs() > PI * (1.0 + 1e-6) {
        return None;
    }
    let map = Normalized::new(a.start, a.radius);
    let outwards = Point::unit(a.start - center);
    let tangent = outwards.perp() * turn.signum();
    let arc = TangentArc::new(DVec2::ZERO, tangent, (b.end - a.start) * map.scale);
    let arc = arc.to_arc(&map);
    Some(CircularArc { end: b.end, ..arc })
        .filter(|arc| (arc.end_angle - arc.start_angle - turn).abs() < 1.0)
}

/// Whether a part of an arc lies within a distance of it: the distance of two circles is at most that of their centres and
/// the difference of their radii.
fn is_near_arc(part: &CircularArc, whole: &CircularArc, tolerance: f64) -> bool {
    match (part.center, whole.center) {
        (Some(a), Some(b)) => Point::norm(a - b) + (part.radius - whole.radius).abs() <= tolerance,
        _ => false,
    }
}
