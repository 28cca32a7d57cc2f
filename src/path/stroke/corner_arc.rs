//! The arc that replaces a corner: a part of the circle of a given radius that is tangent to both segments.
//!
//! The centre lies on the offset curves of both segments at the distance of the radius. These meet in many points; the
//! one that belongs to the corner is found by continuation: the radius grows from 0 in steps, and Newton's method
//! follows the two points of tangency away from the corner, as long as the segments bend towards the circle less than
//! the circle itself.

use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// A joint is a corner if the sine of its turn is larger. This holds for turns of 0.06° to 179.94°.
const MIN_CORNER_SINE: f64 = 1e-3;

/// Larger radii, as a multiple of the size, are limited by the segments.
const MAX_RADIUS: f64 = 1e9;

/// Radii below this part of the size of both segments leave the corner.
const MIN_RADIUS: f64 = 1e-9;

/// The first step moves the points of tangency by this part of the shorter segment.
const FIRST_STEP: f64 = 0.25;

/// Where the circle cannot grow, the radius is found up to this part of it.
const RADIUS_PRECISION: f64 = 1e-6;

/// The largest number of iterations of Newton's method for one radius, and for a corner.
const MAX_ITERATIONS: usize = 12;
const MAX_WORK: usize = 1 << 11;

/// A system is solved if both centres are this close, relative to the size and the radius.
const MAX_GAP: f64 = 4e-15;
const MAX_GAP_WITH_ROUNDING: f64 = 1e-12;

/// The cosine of the largest turn of a tangent in one step (37°).
const MAX_TURN_COSINE: f64 = 0.8;

/// Parameters this close to a limit, relative to it, are at the limit.
const LIMIT_TOLERANCE: f64 = 1e-12;

/// An arc that replaces a corner.
#[derive(Clone, Copy)]
pub(super) struct CornerArc {
    /// The parameters of the points of tangency, on the segment before the corner and on the one after it, both counted
    /// from the corner.
    pub(super) from_corner: [f64; 2],
    /// The points of tangency.
    pub(super) ends: [DVec2; 2],
    /// The unit tangents of the path there.
    pub(super) tangents: [DVec2; 2],
    /// The radius in units of `unit`, negative for a right turn.
    pub(super) radius: f64,
    pub(super) unit: f64,
}

/// Whether a joint with these unit tangents is a corner that an arc can replace.
pub(super) fn is_corner([before, after]: [DVec2; 2]) -> bool {
    before.perp_dot(after).abs() > MIN_CORNER_SINE
}

/// The arc of a radius above 0 at a corner. Both sides are lists of segments that are not points, start at the corner,
/// and lead away from it. The points of tangency are at most at the given parameters; the radius is reduced where it
/// must be. `None` if only a negligible arc is possible.
pub(super) fn corner_arc(
    sides: &[Vec<Curve<DVec2>>; 2],
    radius: f64,
    limits: [f64; 2],
) -> Option<CornerArc> {
    let corner = sides[1][0].start();
    let tangents = [-sides[0][0].start_tangent(), sides[1][0].start_tangent()];
    let (scaled, unit) = scaled(sides, corner);
    let sign = 1.0_f64.copysign(tangents[0].perp_dot(tangents[1]));
    let side = |k: usize, sign: f64| CornerSide {
        segments: scaled[k]
            .iter()
            .map(|points| CurveWithDerivatives::new(points))
            .collect(),
        current: 0,
        sign,
        limit: limits[k],
    };
    let mut fitted = CornerFit {
        sides: [side(0, -sign), side(1, sign)],
        tangents,
        sign,
    };
    let tangency = fitted.fit((radius / unit).min(MAX_RADIUS));
    if tangency[RADIUS] < MIN_RADIUS {
        return None;
    }
    let between_lines = fitted.starts_with_lines() && tangency[0].max(tangency[1]) <= 1.0;
    let distance = tangency[RADIUS] * fitted.tangent_of_half_turn() * unit;
    let end = |k: usize, outward: DVec2| {
        if between_lines && tangency[k] < 1.0 && tangency[k] != limits[k] {
            corner + outward * distance
        } else {
            eval(&sides[k], tangency[k])
        }
    };
    Some(CornerArc {
        from_corner: [tangency[0], tangency[1]],
        ends: [end(0, -tangents[0]), end(1, tangents[1])],
        tangents: [
            -fitted.outward(&tangency, 0)?,
            fitted.outward(&tangency, 1)?,
        ],
        radius: sign * tangency[RADIUS],
        unit,
    })
}

/// The control points of the curves relative to the corner, scaled to a size of about 1, and the unit.
fn scaled(sides: &[Vec<Curve<DVec2>>; 2], corner: DVec2) -> ([Vec<Vec<DVec2>>; 2], f64) {
    let curves = sides.iter().flatten().map(Curve::control_points);
    let normalized = Normalized::around(corner, &curves.collect::<Vec<_>>().concat());
    let points = |curve: &Curve<DVec2>| normalized.points(curve.control_points());
    let scaled = sides
        .each_ref()
        .map(|side| side.iter().map(points).collect());
    (scaled, 1.0 / normalized.scale)
}

/// The point of a list of curves at a parameter.
fn eval(curves: &[Curve<DVec2>], x: f64) -> DVec2 {
    let mut rest = x;
    for curve in &curves[..curves.len() - 1] {
        if rest < 1.0 {
            return curve.eval(rest);
        }
        rest -= 1.0;
    }
    curves[curves.len() - 1].eval(rest)
}

/// A corner with its two segments, which are scaled to a size of about 1, start at the corner, and lead away from it.
struct CornerFit<'a> {
    sides: [CornerSide<'a>; 2],
    /// The tangents at the corner, along the path.
    tangents: [DVec2; 2],
    /// 1 for a left turn, −1 for a right turn.
    sign: f64,
}

/// Segments that follow each other smoothly; parameters are those of a spline.
struct CornerSide<'a> {
    segments: Vec<CurveWithDerivatives<'a, DVec2>>,
    /// The index of the segment with the point of tangency.
    current: usize,
    /// The normal towards the circle is this multiple of the left one.
    sign: f64,
    /// The largest parameter.
    limit: f64,
}

/// What a side is like at a parameter.
struct SidePoint {
    point: DVec2,
    velocity: DVec2,
    tangent: DVec2,
    /// The unit normal towards the circle, and the curvature towards it.
    normal: DVec2,
    curvature: f64,
}

/// The parameters of both points of tangency, and the radius.
type Tangency = [f64; 3];
const RADIUS: usize = 2;

impl CornerSide<'_> {
    /// `None` where the derivative vanishes.
    fn at(&self, x: f64) -> Option<SidePoint> {
        let (curve, x) = (&self.segments[self.current], x - self.current as f64);
        let [velocity, second] = curve.derivatives(x);
        let speed = Point::norm(velocity);
        let tangent = velocity / speed;
        let curvature = self.sign * tangent.perp_dot(second) / (speed * speed);
        (speed > 0.0 && curvature.is_finite()).then(|| SidePoint {
            point: curve.at(x),
            velocity,
            tangent,
            normal: tangent.perp() * self.sign,
            curvature,
        })
    }

    /// The largest parameter in the current segment.
    fn end(&self) -> f64 {
        self.limit.min((self.current + 1) as f64)
    }

    /// The largest distance of a control point of the first segment from the corner.
    fn reach(&self) -> f64 {
        let distances = self.segments[0].points.iter().map(|&p| Point::norm(p));
        distances.fold(0.0, f64::max)
    }

    /// A parameter at about a distance from the corner.
    fn at_distance(&self, distance: f64) -> f64 {
        let (mut low, mut high) = (0.0, self.end());
        for _ in 0..24 {
            let middle = 0.5 * (low + high);
            if Point::norm(self.segments[0].at(middle)) < distance {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    }
}

impl CornerFit<'_> {
    /// The distance of the points of tangency of straight segments, as a multiple of the radius.
    fn tangent_of_half_turn(&self) -> f64 {
        let [before, after] = self.tangents;
        before.perp_dot(after).abs() / (1.0 + before.dot(after))
    }

    fn between_lines(&self, goal: f64) -> Tangency {
        let tangent = self.tangent_of_half_turn();
        let lengths = self.sides.each_ref().map(|side| side.reach());
        let room = (self.sides[0].end() * lengths[0]).min(self.sides[1].end() * lengths[1]);
        let distance = (goal * tangent).min(room);
        let radius = if distance < room {
            goal
        } else {
            distance / tangent
        };
        [distance / lengths[0], distance / lengths[1], radius]
    }

    fn starts_with_lines(&self) -> bool {
        self.sides
            .iter()
            .all(|side| side.segments[0].points.len() == 2)
    }

    /// The tangency of the largest radius up to a goal.
    fn fit(&mut self, goal: f64) -> Tangency {
        let mut tangency = [0.0; 3];
        let reach = self.sides[0].reach().min(self.sides[1].reach());
        if reach == 0.0 {
            return tangency; // One side is so much smaller than the other that it vanishes in the scaled coordinates.
        }
        if self.starts_with_lines() {
            tangency = self.between_lines(goal);
        }
        let mut work = WorkLimit::new(MAX_WORK);
        let mut step = FIRST_STEP * reach / self.tangent_of_half_turn();
        while self.enter_segments(&mut tangency) && tangency[RADIUS] < goal && !work.is_exceeded() {
            let radius = (tangency[RADIUS] + step).min(goal);
            if let Some(next) = self.advance_to(&tangency, radius, &mut work) {
                tangency = next;
                step *= 2.0;
            } else if step < RADIUS_PRECISION * tangency[RADIUS].max(MIN_RADIUS) {
                break;
            } else {
                step *= 0.5;
            }
        }
        tangency
    }

    /// Moves points of tangency at the end of a segment to the next one; false at the limit of a side.
    fn enter_segments(&mut self, tangency: &mut Tangency) -> bool {
        let mut is_free = true;
        for (x, side) in tangency.iter_mut().zip(&mut self.sides) {
            let end = side.end();
            if *x >= end * (1.0 - LIMIT_TOLERANCE) {
                *x = end;
                if end < side.limit {
                    side.current += 1;
                } else {
                    is_free = false;
                }
            }
        }
        is_free
    }

    /// The tangency for a larger radius, or where a side reaches its limit before.
    fn advance_to(&self, from: &Tangency, radius: f64, work: &mut WorkLimit) -> Option<Tangency> {
        let mut start = [from[0], from[1], radius];
        // At the corner: the distance of the points of tangency between lines is a first guess.
        if from[RADIUS] == 0.0 {
            let distance = radius * self.tangent_of_half_turn();
            for (x, side) in start.iter_mut().zip(&self.sides) {
                *x = side.at_distance(distance);
            }
        }
        if let Some(found) = self.solve(start, RADIUS, work) {
            let within = (0..2).all(|k| found[k] <= self.sides[k].end());
            if within {
                return self.is_continuation(from, &found).then_some(found);
            }
            start = found;
        }
        // Otherwise one point of tangency is at the end of its segment, and the radius is unknown.
        (0..2).find_map(|k| {
            let mut clamped = [0, 1].map(|k| start[k].clamp(from[k], self.sides[k].end()));
            clamped[k] = self.sides[k].end();
            let found = self.solve([clamped[0], clamped[1], radius], k, work)?;
            (found[RADIUS] <= radius && self.is_continuation(from, &found)).then_some(found)
        })
    }

    /// Newton's method for two of the unknowns; the fixed one keeps its value.
    fn solve(&self, mut z: Tangency, fixed: usize, work: &mut WorkLimit) -> Option<Tangency> {
        let free = [[1, 2], [0, 2], [0, 1]][fixed];
        let mut rest = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            if !work.spend(1) {
                return None;
            }
            let [before, after] = [self.sides[0].at(z[0])?, self.sides[1].at(z[1])?];
            let normals = before.normal - after.normal;
            // The centres as seen from both sides, B + r N, have to be the same point.
            let gap = before.point - after.point + normals * z[RADIUS];
            rest = Point::norm(gap) / (1.0 + z[RADIUS]);
            if rest <= MAX_GAP {
                break;
            }
            // The derivatives of the gap: (B + r N)′ = B′ (1 − r κ), because N′ = −κ B′.
            let columns = [
                before.velocity * (1.0 - z[RADIUS] * before.curvature),
                -after.velocity * (1.0 - z[RADIUS] * after.curvature),
                normals,
            ];
            let [first, second] = free.map(|k| columns[k]);
            // A step of Newton's method, by Cramer's rule.
            let determinant = first.perp_dot(second);
            z[free[0]] -= gap.perp_dot(second) / determinant;
            z[free[1]] -= first.perp_dot(gap) / determinant;
            if !z.iter().all(|x| x.is_finite()) {
                return None;
            }
        }
        (rest <= MAX_GAP_WITH_ROUNDING).then_some(z)
    }

    /// Whether a tangency continues another one: the points move away from the corner within their limits, no tangent
    /// turns far, neither segment bends towards the circle more than the circle does, and the turn keeps its side.
    fn is_continuation(&self, from: &Tangency, to: &Tangency) -> bool {
        let on_side = |k: usize| {
            let side = &self.sides[k];
            let (Some(local), Some(old)) = (side.at(to[k]), self.outward(from, k)) else {
                return false;
            };
            (from[k]..=side.end()).contains(&to[k])
                && to[RADIUS] * local.curvature < 1.0
                && local.tangent.dot(old) >= MAX_TURN_COSINE
        };
        to[RADIUS] > from[RADIUS] && on_side(0) && on_side(1) && self.turns_to_corner_side(to)
    }

    /// The direction away from the corner at a tangency.
    fn outward(&self, tangency: &Tangency, k: usize) -> Option<DVec2> {
        if tangency[RADIUS] == 0.0 {
            return Some(if k == 0 {
                -self.tangents[0]
            } else {
                self.tangents[1]
            });
        }
        self.sides[k].at(tangency[k]).map(|local| local.tangent)
    }

    /// Whether the path turns at a tangency to the side of the corner, by less than 180°.
    fn turns_to_corner_side(&self, tangency: &Tangency) -> bool {
        match [0, 1].map(|k| self.outward(tangency, k)) {
            [Some(before), Some(after)] => self.sign * after.perp_dot(before) > 0.0,
            _ => false,
        }
    }
}
