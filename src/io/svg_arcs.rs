//! Runs of cubics that are elliptical arcs, for the command A of SVG path data.
//!
//! A cubic with the ends, the tangents and the midpoint of an arc of angle θ has the handles 4/3 tan(θ/4) times the
//! derivatives by the angle. Their sum is parallel to the chord, and the ratio of the two lengths determines θ. This holds for the
//! arcs of every ellipse, because an ellipse is an affine image of a circle. The shorter the arc, the less it says about its
//! ellipse, which is therefore computed from the whole run. `js/io/svg-arcs.ts` performs the same operations.

use crate::numeric::float::as_f64;
use crate::path::arc::{Arc, MAX_PIECE_ANGLE, arc};
use casteljau_kernels::numeric::trigonometry::angle;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Vectors are parallel, and ellipses equal, up to this ratio. Whether a run is an arc is decided afterwards.
const MAX_ELLIPSE_DIFFERENCE: f64 = 1e-9;

/// tan²(θ/4) is between these values: from a small angle, above which an arc is not a line, to more than a quarter turn.
const SQUARES: std::ops::Range<f64> = 1e-9..0.18;

/// Two cubics of one arc have the same tan²(θ/4) up to this.
const SAME_SQUARE: f64 = 1e-12;

/// An arc is found if none of its control points differs by more than this part of the largest coordinate.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// No tolerance divides a full turn into more cubics, since none is below the rounding of the radius.
const MAX_CUBICS: f64 = 414.0;

/// How the radii and the angle of the ellipse are tried: the number of significant digits, and the part by which the radii are
/// smaller. Of half an ellipse, larger radii would move the center far; smaller ones are scaled up when the arc is read.
const CANDIDATES: [(Option<usize>, f64); 6] = [
    (Some(12), 0.0),
    (Some(12), 1e-11),
    (Some(15), 0.0),
    (Some(15), 1e-14),
    (None, 0.0),
    (None, 16.0 * f64::EPSILON),
];

/// The number of cubics of an arc of less than half a turn that is compared with its middle: even, and enough for it.
#[cfg(feature = "nurbs")]
const PIECES: usize = 4;

/// An arc of less than half a turn with the fewest digits with which it is read as passing its middle, if there is one: rounded
/// radii of nearly half an ellipse may move it.
#[cfg(feature = "nurbs")]
pub(super) fn shortest(arc: &Arc, middle: DVec2) -> Option<Arc> {
    let largest = [arc.from, arc.to, middle]
        .iter()
        .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
    rounded(arc, |shape| passes(shape, middle, ROUNDING * largest))
}

/// Whether an arc is read as passing a point in its middle, up to an error in each coordinate.
#[cfg(feature = "nurbs")]
fn passes(shape: &Arc, middle: DVec2, max: f64) -> bool {
    let mut ends = Vec::new();
    let push = |points: &[DVec2]| {
        ends.push(points[2]);
        true
    };
    let is_arc = arc(shape, None, PIECES, push) && ends.len() == PIECES;
    is_arc && {
        let off = ends[PIECES / 2 - 1] - middle;
        off.x.abs() <= max && off.y.abs() <= max
    }
}

/// The first of the candidates that is the arc.
fn rounded(arc: &Arc, is_same: impl Fn(&Arc) -> bool) -> Option<Arc> {
    CANDIDATES.iter().find_map(|&(digits, less)| {
        let round = |x: f64| digits.map_or(x, |digits| significant(x, digits));
        let radii = arc.radii * (1.0 - less);
        let shape = Arc {
            radii: DVec2::new(round(radii.x), round(radii.y)),
            degrees: round(arc.degrees),
            ..*arc
        };
        is_same(&shape).then_some(shape)
    })
}

/// An elliptical arc and the cubics that it may consist of.
pub(super) struct Run<'a> {
    /// The point at the angle φ from the start is center + u cos φ + v sin φ.
    center: DVec2,
    u: DVec2,
    v: DVec2,
    /// tan²(θ/4) of each cubic.
    square: f64,
    cubics: Vec<&'a [DVec2]>,
}

impl<'a> Run<'a> {
    /// The longest run of cubics of equal angles on one ellipse, at most a turn.
    pub(super) fn of(mut segments: impl Iterator<Item = &'a [DVec2]>) -> Option<Self> {
        let first = segments.next()?;
        let (center, u, v, square) = ellipse_of(first)?;
        let turn = (TAU / cubic_angle(square)).ceil().min(MAX_CUBICS);
        let largest = |p: DVec2| p.x.abs().max(p.y.abs());
        let near = MAX_ELLIPSE_DIFFERENCE * largest(u).max(largest(v)).max(largest(center));
        let mut cubics = vec![first];
        let mut end = first[3];
        for next in segments {
            if as_f64(cubics.len()) >= turn || end == first[0] {
                break;
            }
            let Some((other, _, _, other_square)) = ellipse_of(next) else {
                break;
            };
            let same =
                largest(other - center) <= near && (other_square - square).abs() <= SAME_SQUARE;
            if !same {
                break;
            }
            cubics.push(next);
            end = next[3];
        }
        Some(Self {
            center,
            u,
            v,
            square,
            cubics,
        })
    }

    /// The number of cubics.
    pub(super) fn len(&self) -> usize {
        self.cubics.len()
    }

    /// Keeps the first half of the cubics.
    pub(super) fn halve(&mut self) {
        self.cubics.truncate(self.cubics.len() / 2);
    }

    /// The end point.
    pub(super) fn end(&self) -> DVec2 {
        self.cubics.last().map_or(self.center, |cubic| cubic[3])
    }

    /// The arc of these cubics, up to rounding, if there is one.
    pub(super) fn exact_arc(&self) -> Option<Arc> {
        let arc = self.arc();
        let largest = self
            .cubics
            .iter()
            .flat_map(|cubic| cubic.iter())
            .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
        rounded(&arc, |shape| self.is_arc(shape, ROUNDING * largest))
    }

    /// The number of cubics into which an arc is divided at least to be compared with these: 1 if they are as many as it is
    /// read as, or fewer; their number if they are finer.
    fn min_pieces(&self) -> usize {
        let count = as_f64(self.len());
        let read = (cubic_angle(self.square) * count / MAX_PIECE_ANGLE).ceil();
        if read < count { self.len() } else { 1 }
    }

    /// Whether an arc is read as these cubics, or consists of them if they are finer, up to an error in each coordinate.
    pub(super) fn is_arc(&self, shape: &Arc, max: f64) -> bool {
        let mut cubics = self.cubics.iter();
        let mut same = true;
        let compare = |points: &[DVec2]| {
            same = cubics.next().is_some_and(|cubic| {
                let near = |(&a, &b): (&DVec2, &DVec2)| {
                    (a.x - b.x).abs() <= max && (a.y - b.y).abs() <= max
                };
                cubic[1..].iter().zip(points).all(near)
            });
            same
        };
        arc(shape, None, self.min_pieces(), compare) && same && cubics.next().is_none()
    }

    /// The start of cubic k, or the end of the last one.
    fn joint(&self, k: usize) -> DVec2 {
        self.cubics
            .get(k)
            .map_or_else(|| self.end(), |cubic| cubic[0])
    }

    /// The center, and two conjugate radii in the order of the run, by four joints at equal angles φ. If a, b and c are
    /// three of them, a + c = 2 center + 2 cos φ (b − center), which gives cos φ by two such equations. A run of one or
    /// two cubics has the ellipse of the first one.
    fn ellipse(&self) -> [DVec2; 3] {
        let m = self.len() / 3;
        if m == 0 {
            return [self.center, self.u, self.v];
        }
        let [a, b, c, d] = [0, m, 2 * m, 3 * m].map(|k| self.joint(k));
        let (sum, middle) = ((a - b) + (c - d), b - c);
        let cos = 0.5 * (sum.x * middle.x + sum.y * middle.y)
            / (middle.x * middle.x + middle.y * middle.y);
        let u = ((b - a) + (b - c)) * (0.5 / (1.0 - cos));
        let v = (c - a) * (0.5 / ((1.0 - cos) * (1.0 + cos)).sqrt());
        [b - u, u, v]
    }

    /// The arc of the ellipse from the start to the end.
    pub(super) fn arc(&self) -> Arc {
        let [center, u, v] = self.ellipse();
        let area = u.x * v.y - u.y * v.x;
        let sweep = area > 0.0;
        let (a, b, c) = (
            u.x * u.x + v.x * v.x,
            u.x * u.y + v.x * v.y,
            u.y * u.y + v.y * v.y,
        );
        let (sum, half) = (a + c, (a - c) * 0.5);
        let h = (half * half + b * b).sqrt();
        let first = (0.5 * sum + h).sqrt();
        let second = area.abs() / first;
        let (radii, degrees) = if h <= MAX_ELLIPSE_DIFFERENCE * sum {
            (DVec2::splat((0.5 * sum).sqrt()), 0.0)
        } else if b.abs() <= MAX_ELLIPSE_DIFFERENCE * sum {
            let radii = if half > 0.0 {
                DVec2::new(first, second)
            } else {
                DVec2::new(second, first)
            };
            (radii, 0.0)
        } else {
            let turn = angle(DVec2::new(half.abs() / h, b.abs() / h));
            let turn = if half < 0.0 { PI - turn } else { turn };
            let signed = if b < 0.0 { -turn } else { turn };
            (DVec2::new(first, second), signed * (90.0 / PI))
        };
        let (s, e) = (self.joint(0) - center, self.end() - center);
        let beyond = s.x * e.y - s.y * e.x;
        let beyond = if sweep { beyond } else { -beyond };
        Arc {
            from: self.joint(0),
            to: self.end(),
            radii,
            degrees,
            large: beyond < -MAX_ELLIPSE_DIFFERENCE * area.abs(),
            sweep,
        }
    }
}

/// The ellipse on which a cubic may be an arc: its center, the vectors u and v at the start, and tan²(θ/4).
fn ellipse_of(points: &[DVec2]) -> Option<(DVec2, DVec2, DVec2, f64)> {
    let &[p0, p1, p2, p3] = points else {
        return None;
    };
    let (a, b, chord) = (p1 - p0, p3 - p2, p3 - p0);
    let sum = a + b;
    let dot = chord.x * sum.x + chord.y * sum.y;
    let cross = chord.x * sum.y - chord.y * sum.x;
    let q = 1.0 - 1.5 * (sum.x * sum.x + sum.y * sum.y) / dot;
    if !(cross.abs() <= MAX_ELLIPSE_DIFFERENCE * dot && SQUARES.contains(&q)) {
        return None;
    }
    let w = (1.0 + q) * (1.0 + q);
    let cos = (1.0 - 6.0 * q + q * q) / w;
    let handle_sin = 16.0 / 3.0 * q * (1.0 - q) / w;
    let to_center = (b - a * cos) / handle_sin;
    let v = a / (4.0 / 3.0 * q.sqrt());
    Some((p0 + to_center, -to_center, v, q))
}

/// The angle θ of an arc with tan²(θ/4) = q.
fn cubic_angle(q: f64) -> f64 {
    2.0 * angle(DVec2::new(1.0 - q, 2.0 * q.sqrt()) / (1.0 + q))
}

/// A number rounded to some significant digits.
fn significant(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits - 1).parse().unwrap_or(x)
}
