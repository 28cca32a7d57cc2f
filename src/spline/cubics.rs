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
use casteljau_kernels::spline::fit_run::{EDGE_ALLOWANCE, FitRun};

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
    pub(crate) bound_edges: bool,
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

/// Bisection steps for the longest run, which is found to 1/64.
const BISECTIONS: usize = 6;

/// Bisection steps for the smallest tolerance.
const TOLERANCE_BISECTIONS: usize = 10;

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
struct GreedyFit<P> {
    cubics: Vec<(usize, [P; 2])>,
    /// The number of edges along which no cubic satisfies the criteria.
    failures: usize,
}

impl<P: Point> FitSamples<P> {
    /// The cubics from stop to stop. `tangents` are the tangents before and after each point; they differ only at stops.
    pub(crate) fn fit_between_stops(
        mut self,
        tangents: &[[P; 2]],
        stops: &[usize],
        effort: FitEffort,
    ) -> Vec<(usize, [P; 2])> {
        let mut cubics = Vec::new();
        for pair in stops.windows(2) {
            self.tangents[pair[0]] = tangents[pair[0]][1];
            self.tangents[pair[1]] = tangents[pair[1]][0];
            cubics.extend(self.closest_fit(pair[0], pair[1], effort).cubics);
        }
        cubics
    }

    /// The cubics from index `first` to `last`.
    fn greedy_fit(&self, first: usize, last: usize) -> GreedyFit<P> {
        let mut fit = GreedyFit::default();
        let (mut from, mut step) = (first, last - first);
        while from < last {
            let (to, handles) = self.longest_cubic(from, last, step);
            fit.failures += usize::from(handles.is_none());
            let handles = handles.unwrap_or_else(|| self.short_handles(from, to));
            fit.cubics.push((to, handles));
            step = to - from;
            from = to;
        }
        fit
    }

    /// The inner control points where no cubic satisfies the criteria, between two consecutive points: of a line, or within
    /// the distance that is allowed between samples, with the tangents of both ends.
    fn short_handles(&self, from: usize, to: usize) -> [P; 2] {
        let (start, end) = (self.joints[from], self.joints[to]);
        if self.criteria.bound_edges {
            return [start, end];
        }
        let length = EDGE_ALLOWANCE * (end - start).norm();
        [
            start + self.tangents[from] * length,
            end - self.tangents[to] * length,
        ]
    }

    /// The cubics for the tolerance; with the best effort for the smallest one that needs no more of them.
    fn closest_fit(&mut self, first: usize, last: usize, effort: FitEffort) -> GreedyFit<P> {
        let tolerance = self.criteria.tolerance;
        let bisections = match effort {
            FitEffort::Fast => 0,
            FitEffort::Best => TOLERANCE_BISECTIONS,
        };
        let (mut low, mut high) = (0.0, tolerance);
        let mut best: Option<GreedyFit<P>> = None;
        // After the first round `best` is the cover for `high`; a cover for `low` is worse, unless `low` is 0.
        for _ in 0..=bisections {
            let next = self.greedy_fit(first, last);
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
    fn longest_cubic(&self, from: usize, last: usize, step: usize) -> (usize, Option<[P; 2]>) {
        let mut best = (from + 1, self.handles(from, from + 1));
        let (mut fails, mut to) = (last + 1, (from + step.max(2)).min(last));
        let mut bisections = 0;
        // Up to `best.0` a cubic fits, or that is one edge; up to `fails` none fits, or that is beyond `last`.
        while to > best.0 {
            match self.handles(from, to) {
                Some(handles) => best = (to, Some(handles)),
                None => fails = to,
            }
            if fails > last {
                to = (from + 2 * (best.0 - from)).min(last);
            } else {
                bisections += 1;
                // `to` = `best.0` ends the loop, after BISECTIONS steps and once the interval is short.
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
        let FitCriteria {
            tolerance,
            bound_edges,
            monotone,
            grid,
        } = self.criteria;
        let points = &self.points[from..=to];
        // The handles of a line would leave it on the grid, so it has none.
        let is_line = grid.is_some() && is_straight(points, tolerance);
        let rounded = |[start, p1, p2, end]: [P; 4]| {
            let on_grid = |p: P| match grid {
                Some(grid) if !is_line => grid.nearest(p),
                _ => p,
            };
            let cubic = [start, on_grid(p1), on_grid(p2), end];
            (!monotone || is_monotone(&cubic)).then_some(cubic)
        };
        P::fit_handles(&FitRun {
            points,
            lengths: &self.lengths[from..=to],
            ends: [from, to].map(|k| self.joints[k]),
            tangents: [from, to].map(|k| self.tangents[k]),
            tolerance,
            bound_edges,
            is_line,
            rounded: &rounded,
        })
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
    // |chord × gap| is the distance from the chord times its length.
    let room = (STRAIGHT * length).min(STRAIGHT_SHARE * tolerance) * length;
    square > 0.0
        && points.iter().all(|&p| {
            let gap = p - start;
            (0.0..=square).contains(&gap.dot(chord)) && chord.cross(gap).size() <= room
        })
}
