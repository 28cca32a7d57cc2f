//! Fitting a smooth spline of few cubics to a sequence of points.
//!
//! From each point the algorithm searches the longest run of points that one cubic can approximate: it starts with the
//! length of the previous run, doubles it while the fit succeeds, then bisects. The cubic has the given tangents at
//! both ends of the run, so consecutive cubics join smoothly. The lengths of its handles come from least squares: first
//! with chord-length parameters, then with the normal distance at each point's foot (Gauss–Newton method). Sources:
//! Schneider, "An algorithm for automatically fitting digitized curves", Graphics Gems (1990), for the start; Wang,
//! Pottmann and Liu, "Fitting B-spline curves to point clouds by curvature-based squared distance minimization", ACM
//! TOG 25 (2006), for the iterations after it.

use super::grid::NormalizedGrid;
use crate::geometry::point::{CrossProduct, Point};

/// The part of the tolerance that is reserved for rounding.
pub(crate) const ROUNDING_SHARE: f64 = 1e-3;

/// The criteria that each cubic must satisfy.
#[derive(Clone, Copy, Default)]
pub(crate) struct FitCriteria<P> {
    /// The maximum distance between a point and its foot on a cubic.
    pub(crate) tolerance: f64,
    /// Whether the polyline between the points counts too: the bound of the distance between the cubic and its chord
    /// from foot to foot is then added to the distances of the points. Otherwise the cubic may be farther from an edge
    /// than the tolerance, by a sixth of its length or a quarter of the tolerance.
    pub(crate) between: bool,
    /// Whether each coordinate of the control points must be in order, so that the ends have its extrema.
    pub(crate) monotone: bool,
    /// The grid on which all control points must lie.
    pub(crate) grid: Option<NormalizedGrid<P>>,
}

/// How much is computed for a fit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub enum FitEffort {
    /// Each segment is as long as the tolerance allows, so the last one before a corner may be much shorter and closer than
    /// the others: the default.
    #[default]
    Fast,
    /// No more segments than with [`Fast`](Self::Fast), but as close to the points as that number allows: between two corners
    /// the smallest tolerance is found by bisection, to 1/1000. Takes about 11 times as long.
    Best,
}

/// The input points with the joint, the tangent and the chord length from the start at each point.
pub(crate) struct FitSamples<P> {
    pub(crate) points: Vec<P>,
    /// The position of a joint at each point, within the tolerance of the point.
    pub(crate) joints: Vec<P>,
    pub(crate) tangents: Vec<P>,
    pub(crate) lengths: Vec<f64>,
    pub(crate) criteria: FitCriteria<P>,
}

/// The maximum number of points used for least squares; all points are checked.
const MAX_SAMPLES: usize = 16;

/// Iterations of least squares, and of Newton's method for a foot.
const MAX_ROUNDS: usize = 6;
const FOOT_ROUNDS: usize = 2;

/// If the error exceeds this many tolerances after the first two iterations, the fit is given up.
const MAX_INITIAL_ERROR: f64 = 50.0;

/// Bisection steps for the longest run, which is found to 1/64.
const BISECTIONS: usize = 6;

/// Bisection steps for the smallest tolerance.
const TOLERANCE_BISECTIONS: usize = 10;

/// Added to the diagonal of the normal equations, whose entries are of the order of 1 or smaller.
const DAMPING: f64 = 1e-6;

/// The minimum and the maximum length of a handle as a ratio of the chord length of its run. A handle of length 0 would
/// leave the tangent at the joint undefined.
const SHORTEST_HANDLE: f64 = 1.0 / 64.0;
const LONGEST_HANDLE: f64 = 1.5;

/// How much farther than the tolerance a cubic may be from the edge between two sampled points, in lengths of the edge:
/// the height of an arc that turns by 74°.
const BETWEEN: f64 = 1.0 / 6.0;

/// The same in tolerances, where the points are as close together as their noise is large.
const NOISE: f64 = 0.25;

/// How far, in tolerances, a point may lie from the part of the cubic after the feet of the points before it.
const MAX_STEP_BACK: f64 = 3.0;

/// The cumulative chord length at each point.
pub(crate) fn chord_lengths<P: Point>(points: &[P]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut lengths = vec![0.0];
    lengths.extend(points.windows(2).map(|p| {
        sum += (p[1] - p[0]).norm();
        sum
    }));
    lengths
}

/// The cubics along a run: for each one the index of its end point and its two inner control points.
#[derive(Default)]
struct Cover<P> {
    cubics: Vec<(usize, [P; 2])>,
    /// The number of edges along which no cubic satisfies the criteria.
    failures: usize,
}

impl<P: Point> FitSamples<P> {
    /// The cubics from stop to stop. `tangents` are the tangents before and after each point; they differ only at stops.
    pub(crate) fn cover_all(
        mut self,
        tangents: &[[P; 2]],
        stops: &[usize],
        effort: FitEffort,
    ) -> Vec<(usize, [P; 2])> {
        let mut cubics = Vec::new();
        for pair in stops.windows(2) {
            self.tangents[pair[0]] = tangents[pair[0]][1];
            self.tangents[pair[1]] = tangents[pair[1]][0];
            cubics.extend(self.closest_cover(pair[0], pair[1], effort).cubics);
        }
        cubics
    }

    /// The cubics from index `first` to `last`.
    fn cover(&self, first: usize, last: usize) -> Cover<P> {
        let mut cover = Cover::default();
        let (mut from, mut step) = (first, last - first);
        while from < last {
            let (to, handles) = self.longest(from, last, step);
            cover.failures += usize::from(handles.is_none());
            let handles = handles.unwrap_or_else(|| self.short_handles(from, to));
            cover.cubics.push((to, handles));
            step = to - from;
            from = to;
        }
        cover
    }

    /// The inner control points where no cubic satisfies the criteria, between two consecutive points: of a line, or within
    /// the distance that is allowed between samples, with the tangents of both ends.
    fn short_handles(&self, from: usize, to: usize) -> [P; 2] {
        let (start, end) = (self.joints[from], self.joints[to]);
        if self.criteria.between {
            return [start, end];
        }
        let length = BETWEEN * (end - start).norm();
        [
            start + self.tangents[from] * length,
            end - self.tangents[to] * length,
        ]
    }

    /// The cubics for the tolerance; with the best effort for the smallest one that needs no more of them.
    fn closest_cover(&mut self, first: usize, last: usize, effort: FitEffort) -> Cover<P> {
        let tolerance = self.criteria.tolerance;
        let bisections = match effort {
            FitEffort::Fast => 0,
            FitEffort::Best => TOLERANCE_BISECTIONS,
        };
        let (mut low, mut high) = (0.0, tolerance);
        let mut best: Option<Cover<P>> = None;
        for _ in 0..=bisections {
            let next = self.cover(first, last);
            let is_worse = best.as_ref().is_some_and(|best| {
                next.cubics.len() > best.cubics.len() || next.failures > best.failures
            });
            if is_worse {
                low = self.criteria.tolerance;
            } else {
                (best, high) = (Some(next), self.criteria.tolerance);
            }
            self.criteria.tolerance = 0.5 * (low + high);
        }
        self.criteria.tolerance = tolerance;
        best.unwrap_or_default()
    }

    /// The end of the longest run from an index that a cubic approximates and its inner control points; the next index
    /// and `None` if there is no cubic.
    fn longest(&self, from: usize, last: usize, step: usize) -> (usize, Option<[P; 2]>) {
        let mut best = (from + 1, self.handles(from, from + 1));
        let (mut fails, mut to) = (last + 1, (from + step.max(2)).min(last));
        let mut bisections = 0;
        while to > best.0 {
            match self.handles(from, to) {
                Some(handles) => best = (to, Some(handles)),
                None => fails = to,
            }
            if fails > last {
                to = (from + 2 * (best.0 - from)).min(last);
            } else {
                bisections += 1;
                let wide = fails - best.0 > (best.0 - from) / 4;
                to = if bisections > BISECTIONS && !wide {
                    best.0
                } else {
                    best.0 + (fails - best.0) / 2
                };
            }
        }
        best
    }

    /// The inner control points of a cubic that satisfies the criteria along a run, or `None` if none was found.
    fn handles(&self, from: usize, to: usize) -> Option<[P; 2]> {
        let chord_length = self.lengths[to] - self.lengths[from];
        let (start, end) = (self.joints[from], self.joints[to]);
        let (t0, t1) = (self.tangents[from], self.tangents[to]);
        let mut samples = self.samples(from, to);
        // The handles of a line would leave it on the grid, so it has none.
        let is_line = self.criteria.grid.is_some()
            && is_straight(&self.points[from..=to], self.criteria.tolerance);
        let (mut a, mut b) = (chord_length / 3.0, chord_length / 3.0);
        let mut previous = f64::INFINITY;
        for round in 0..MAX_ROUNDS {
            let cubic = if is_line {
                let third = |k: f64| start.lerp(end, k / 3.0);
                [start, third(1.0), third(2.0), end]
            } else {
                [start, start + t0 * a, end + t1 * -b, end]
            };
            let mut equations = Equations::default();
            let mut worst: f64 = 0.0;
            for (index, u) in &mut samples {
                let p = self.points[*index];
                if round > 0 {
                    *u = foot(&cubic, p, *u);
                }
                let (q, w, _) = at(&cubic, *u);
                worst = worst.max((q - p).norm());
                let along = if round > 0 { w.unit() } else { P::default() };
                equations.add(q - p, along, (t0, t1), *u);
            }
            if worst <= self.criteria.tolerance {
                let grid = self.criteria.grid.filter(|_| !is_line);
                let on_grid = |p: P| grid.map_or(p, |grid| grid.nearest(p));
                let [_, p1, p2, _] = cubic;
                let cubic = [start, on_grid(p1), on_grid(p2), end];
                if self.keeps(&cubic, from, to, &samples) {
                    return Some(if is_line {
                        [start, end]
                    } else {
                        [cubic[1], cubic[2]]
                    });
                }
            }
            let limit = MAX_INITIAL_ERROR * self.criteria.tolerance;
            if round > 1 && !(worst < 0.8 * previous && worst < limit) {
                return None;
            }
            previous = worst;
            let (da, db) = equations.solved();
            let clamped = |length: f64| {
                length.clamp(
                    SHORTEST_HANDLE * chord_length,
                    LONGEST_HANDLE * chord_length,
                )
            };
            (a, b) = (clamped(a + da), clamped(b + db));
        }
        None
    }

    /// Inner points of a run, evenly spaced by index, and their chord-length parameters.
    fn samples(&self, from: usize, to: usize) -> Vec<(usize, f64)> {
        let count = (to - from - 1).min(MAX_SAMPLES);
        (1..=count)
            .map(|k| {
                let index = from + k * (to - from) / (count + 1);
                (index, self.part(from, to, index))
            })
            .collect()
    }

    /// The position of a point in a run by chord length, 0 to 1.
    fn part(&self, from: usize, to: usize, index: usize) -> f64 {
        let (a, b) = (self.lengths[from], self.lengths[to]);
        if b > a {
            (self.lengths[index] - a) / (b - a)
        } else {
            0.5
        }
    }

    /// Whether the cubic satisfies the criteria at all points of a run.
    fn keeps(&self, cubic: &[P; 4], from: usize, to: usize, samples: &[(usize, f64)]) -> bool {
        if self.criteria.monotone && !is_monotone(cubic) {
            return false;
        }
        let mut known = samples.iter().copied().chain([(to, 1.0)]);
        let (mut left, mut right) = ((from, 0.0), known.next().unwrap_or((to, 1.0)));
        let mut last: (f64, f64) = (0.0, (self.joints[from] - self.points[from]).norm());
        for index in from + 1..=to {
            while index > right.0 {
                (left, right) = (right, known.next().unwrap_or((to, 1.0)));
            }
            // Interpolate the parameter between the neighbouring samples by chord length.
            let guess = left.1 + (right.1 - left.1) * self.part(left.0, right.0, index);
            let p = self.points[index];
            let u = if index == to {
                1.0
            } else {
                foot(cubic, p, guess)
            };
            let distance = |u: f64| (at(cubic, u).0 - p).norm();
            let forward = u.max(last.0);
            let tolerance = self.criteria.tolerance;
            let (u, off) = if self.criteria.between {
                (forward, distance(forward))
            } else if forward > u && distance(forward) > MAX_STEP_BACK * tolerance {
                return false;
            } else {
                (forward, distance(u))
            };
            let room = if self.criteria.between {
                0.0
            } else {
                let edge = (p - self.points[index - 1]).norm();
                (BETWEEN * edge).max(NOISE * tolerance)
            };
            if off > tolerance || off.max(last.1) + sag(cubic, last.0, u) > tolerance + room {
                return false;
            }
            last = (u, off);
        }
        true
    }
}

/// Whether each coordinate of the points increases or decreases throughout.
pub(crate) fn is_monotone<P: Point>(points: &[P]) -> bool {
    (0..P::DIMENSION).all(|axis| {
        let coordinate = |p: &P| p.coordinate(axis);
        points.is_sorted_by(|a, b| coordinate(a) <= coordinate(b))
            || points.is_sorted_by(|a, b| coordinate(a) >= coordinate(b))
    })
}

/// Points within this part of the length of a chord and of the tolerance are on it.
const STRAIGHT: f64 = 1e-9;
const STRAIGHT_SHARE: f64 = 0.5 * ROUNDING_SHARE;

/// Whether all points lie on the chord from the first to the last one.
pub(crate) fn is_straight<P: Point>(points: &[P], tolerance: f64) -> bool {
    let (start, end) = (points[0], points[points.len() - 1]);
    let chord = end - start;
    let square = chord.dot(chord);
    let length = square.sqrt();
    let room = (STRAIGHT * length).min(STRAIGHT_SHARE * tolerance) * length;
    square > 0.0
        && points.iter().all(|&p| {
            let gap = p - start;
            (0.0..=square).contains(&gap.dot(chord)) && chord.cross(gap).size() <= room
        })
}

/// The normal equations of the two handle lengths.
#[derive(Default)]
struct Equations {
    aa: f64,
    ab: f64,
    bb: f64,
    ra: f64,
    rb: f64,
}

impl Equations {
    /// Adds the residual `off` of a point; only the components perpendicular to `along` count.
    fn add<P: Point>(&mut self, off: P, along: P, (t0, t1): (P, P), u: f64) {
        let r = 1.0 - u;
        let across = |v: P| v - along * v.dot(along);
        let (ja, jb) = (
            across(t0 * (3.0 * u * r * r)),
            across(t1 * (-3.0 * u * u * r)),
        );
        self.aa += ja.dot(ja);
        self.ab += ja.dot(jb);
        self.bb += jb.dot(jb);
        self.ra -= ja.dot(off);
        self.rb -= jb.dot(off);
    }

    fn solved(&self) -> (f64, f64) {
        let (aa, bb) = (self.aa + DAMPING, self.bb + DAMPING);
        let scale = 1.0 / (aa * bb - self.ab * self.ab);
        (
            (self.ra * bb - self.rb * self.ab) * scale,
            (self.rb * aa - self.ra * self.ab) * scale,
        )
    }
}

/// The value and the first two derivatives of a cubic.
fn at<P: Point>(p: &[P; 4], u: f64) -> (P, P, P) {
    let (d0, d1, d2) = (p[1] - p[0], p[2] - p[1], p[3] - p[2]);
    let r = 1.0 - u;
    (
        P::blend4(*p, [r * r * r, 3.0 * r * r * u, 3.0 * r * u * u, u * u * u]),
        P::blend3([d0, d1, d2], [3.0 * r * r, 6.0 * r * u, 3.0 * u * u]),
        (d1 - d0).lerp(d2 - d1, u) * 6.0,
    )
}

/// The parameter of the foot of a point on a cubic, by Newton's method from the guess `u`.
fn foot<P: Point>(cubic: &[P; 4], p: P, mut u: f64) -> f64 {
    for _ in 0..FOOT_ROUNDS {
        let (q, w, b) = at(cubic, u);
        let gap = p - q;
        let slope = w.dot(w) - gap.dot(b);
        if slope > 0.0 {
            u = (u + gap.dot(w) / slope).clamp(0.0, 1.0);
        }
    }
    u
}

/// A bound of the Hausdorff distance between a cubic and its chord over [u0, u1]: h²/8 times the maximum of the second
/// derivative, of its component across the chord if the cubic advances along the chord throughout.
fn sag<P: Point>(cubic: &[P; 4], u0: f64, u1: f64) -> f64 {
    let h = u1 - u0;
    let [(p, v0, a0), (q, v1, a1)] = [at(cubic, u0), at(cubic, u1)];
    let chord = (q - p).unit();
    // The derivative along the chord as a quadratic Bézier polynomial.
    let advances = [v0, v0 + a0 * (0.5 * h), v1]
        .iter()
        .all(|v| v.dot(chord) >= 0.0);
    let across = |a: P| {
        if advances {
            a - chord * a.dot(chord)
        } else {
            a
        }
    };
    across(a0).norm().max(across(a1).norm()) * h * h * 0.125
}
