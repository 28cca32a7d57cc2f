//! Detection of corners in a sequence of points with noise.
//!
//! The angle between neighbouring chords is meaningless where the points are as close together as their noise is large.
//! Therefore the points are merged into clusters of the size of the tolerance, and two models of the points around
//! a cluster are compared: two straight lines that meet there, and a parabola. Both have three vectors as parameters.
//! A corner is where the lines turn by more than the corner angle, fit within the tolerance, and leave at most half of
//! the parabola's sum of squares. Noise and smooth bends do not favour the lines: over an arm length L, the root
//! mean square residual of the parabola is 0.072 L sin(θ/2) at a corner of angle θ, and of the order L³ at a smooth bend.
//!
//! The comparison is made at several arm lengths, the shortest first: a short one separates close corners, a long one
//! recognises a flat corner in noise. Where the points are farther apart than the shortest arm, the turns of the
//! polyline are used. Sources: Rattarangsi and Chin, "Scale-based detection of corners of planar curves", IEEE
//! PAMI 14 (1992), for the scales; Hinkley, "Inference about the intersection in two-phase regression", Biometrika 56
//! (1969), for the comparison.

use super::local_fit::{Parabola, TwoLines};
use super::polyline::{Cluster, SampledPolyline};
use crate::geometry::point::Point;
use crate::numeric::sort::sort_by;
use casteljau_kernels::numeric::trigonometry::cos_sin;
use std::ops::Range;

/// Arm lengths in tolerances. A direction over the shortest one has an error of a few degrees if the noise is as large as
/// the tolerance: noise σ at n points gives an error of σ √(12/n)/L.
const ARMS: [f64; 3] = [8.0, 16.0, 32.0];

/// Between points farther apart than this (in tolerances), a turn by more than this angle (75°) is a corner even if the
/// turns beside it are as large.
const SPARSE_CORNER_ANGLE: f64 = 1.3;

/// The maximum number of clusters in an arm, and the number of those that are used.
const MAX_IN_ARM: usize = 128;
const MAX_SAMPLES: usize = 16;

/// An arm has at least this many clusters, unless they are farther apart than the shortest arm length.
const MIN_IN_ARM: usize = 3;

/// The parabola's sum of squares must be at least this multiple of the sum of squares of the lines.
const MIN_RATIO: f64 = 2.0;

/// The indices of the corners in increasing order. The ends of an open polyline are not corners.
pub(crate) fn corners<P: Point>(
    polyline: &SampledPolyline<P>,
    tolerance: f64,
    angle: f64,
) -> Vec<usize> {
    let period = polyline.period();
    // A closed polyline is examined in the second of three rounds.
    let rounds = if polyline.is_closed() { 3 } else { 1 };
    let clusters = polyline.clusters(0, rounds * period - 1, tolerance);
    let round = |cluster: &Cluster<P>| cluster.first / period;
    let own = clusters.partition_point(|c| round(c) < rounds / 2)
        ..clusters.partition_point(|c| round(c) <= rounds / 2);
    let detector = CornerDetector {
        closed: polyline.is_closed(),
        // Both arms together do not go around a closed polyline more than once.
        max_in_arm: (own.len() / 2).clamp(1, MAX_IN_ARM),
        clusters,
        own,
        tolerance,
        angle,
        cosines: [0.5 * angle, angle].map(|angle| cos_sin(angle).0),
    };
    let mut found = Vec::new();
    let mut taken = vec![false; detector.own.len()];
    for arm in ARMS {
        detector.add_corners(arm * tolerance, &mut taken, &mut found);
    }
    let mut indices: Vec<usize> = found
        .iter()
        .map(|corner| detector.index(polyline, corner) % period)
        .collect();
    sort_by(&mut indices, |a, b| a.cmp(b));
    indices.dedup();
    indices
}

struct CornerDetector<P> {
    clusters: Vec<Cluster<P>>,
    /// The clusters at which corners are searched; the others continue a closed polyline.
    own: Range<usize>,
    closed: bool,
    max_in_arm: usize,
    tolerance: f64,
    angle: f64,
    /// The cosines of half the angle and of the angle.
    cosines: [f64; 2],
}

/// A corner at a cluster.
#[derive(Clone, Copy)]
struct DetectedCorner<P> {
    cluster: usize,
    apex: P,
    /// The unit vector that bisects the outer angle; zero between points far apart.
    outward: P,
    /// How much better the lines fit than the parabola.
    ratio: f64,
    /// The number of clusters in the longer arm.
    reach: usize,
}

impl<P: Point> CornerDetector<P> {
    /// Adds the corners that are detected with an arm length. Within an arm of a corner no other one is added; shorter
    /// arms and better fits come first. `taken` marks the clusters with a corner, counted from the start of `own`.
    fn add_corners(&self, arm: f64, taken: &mut [bool], found: &mut Vec<DetectedCorner<P>>) {
        let mut candidates: Vec<DetectedCorner<P>> = self
            .own
            .clone()
            .filter_map(|k| self.corner(k, arm))
            .collect();
        sort_by(&mut candidates, |a, b| b.ratio.total_cmp(&a.ratio));
        for corner in candidates {
            let here = corner.cluster - self.own.start;
            if !self.is_near(taken, here, corner.reach) {
                taken[here] = true;
                found.push(corner);
            }
        }
    }

    /// Whether a cluster fewer than `reach` steps away is marked; around the start if the polyline is closed.
    fn is_near(&self, taken: &[bool], here: usize, reach: usize) -> bool {
        let count = taken.len();
        let marked = |at: Option<usize>| at.is_some_and(|at| taken[at]);
        (0..reach.min(count)).any(|steps| {
            let (ahead, behind) = (here + steps, here.checked_sub(steps));
            if self.closed {
                let behind = behind.unwrap_or(here + count - steps);
                marked(Some(ahead % count)) || marked(Some(behind))
            } else {
                marked(Some(ahead).filter(|&at| at < count)) || marked(behind)
            }
        })
    }

    fn corner(&self, k: usize, arm: f64) -> Option<DetectedCorner<P>> {
        let before = self.arm(k, arm, |steps| k.checked_sub(steps))?;
        let after = self.arm(k, arm, |steps| {
            Some(k + steps).filter(|&at| at < self.clusters.len())
        })?;
        // Three points are too few to compare two models with three parameters each.
        if before == 1 && after == 1 {
            return self.sparse_corner(k);
        }
        let mean = |index: usize| self.clusters[index].mean;
        let arms = [mean(k) - mean(k - before), mean(k + after) - mean(k)];
        if !turns_by_more_than(arms, self.cosines[0]) {
            return None;
        }
        let mut samples: Vec<(P, f64)> = Vec::with_capacity(2 * MAX_SAMPLES + 1);
        let here = self.clusters[k];
        let mut add = |index: usize| {
            let cluster = self.clusters[index];
            samples.push((cluster.mean - here.mean, cluster.length - here.length));
        };
        add(k);
        spread(before).for_each(|steps| add(k - steps));
        spread(after).for_each(|steps| add(k + steps));
        let lines = TwoLines::fitted(&samples);
        // The cheapest tests first: most clusters are no corners.
        if lines.apex.norm() > self.tolerance
            || !turns_by_more_than([lines.before, lines.after], self.cosines[1])
        {
            return None;
        }
        let limit = samples.len() as f64 * self.tolerance.powi(2);
        let off = lines.squares(&samples);
        if off > limit {
            return None;
        }
        // The addend keeps the ratio small where both models fit up to rounding.
        let ratio = Parabola::fitted(&samples).squares / (off + 1e-4 * limit);
        (ratio >= MIN_RATIO).then_some(DetectedCorner {
            cluster: k,
            apex: here.mean + lines.apex,
            outward: (lines.before.unit() - lines.after.unit()).unit(),
            ratio,
            reach: before.max(after),
        })
    }

    /// The number of clusters in an arm.
    fn arm(&self, k: usize, arm: f64, at: impl Fn(usize) -> Option<usize>) -> Option<usize> {
        let here = self.clusters[k].mean;
        let is_within = |steps: usize, far: f64| {
            at(steps).map(|index| {
                let gap = self.clusters[index].mean - here;
                gap.dot(gap) < far * far
            })
        };
        if !is_within(1, ARMS[0] * self.tolerance)? {
            return Some(1);
        }
        let mut steps = 1;
        while steps < self.max_in_arm && is_within(steps + 1, arm) == Some(true) {
            steps += 1;
        }
        let steps = steps.max(MIN_IN_ARM.min(self.max_in_arm));
        at(steps).map(|_| steps)
    }

    /// A corner of the polyline at a cluster whose neighbours are far away.
    fn sparse_corner(&self, k: usize) -> Option<DetectedCorner<P>> {
        let turn = |k: usize| {
            let mean = |index: usize| self.clusters.get(index).map(|cluster| cluster.mean);
            let (a, b, c) = (mean(k.checked_sub(1)?)?, mean(k)?, mean(k + 1)?);
            Some(angle_between(b - a, c - b))
        };
        let here = turn(k)?;
        let beside = |k: Option<usize>| k.and_then(turn).unwrap_or(0.0);
        let stands_out = here > 2.0 * beside(k.checked_sub(1)).max(beside(Some(k + 1)));
        (here > self.angle && (here > SPARSE_CORNER_ANGLE || stands_out)).then_some(
            DetectedCorner {
                cluster: k,
                apex: self.clusters[k].mean,
                outward: P::default(),
                ratio: f64::INFINITY,
                reach: 1,
            },
        )
    }

    /// The index of the point at a corner: the outermost one near the apex. The apex is off by up to half a tolerance,
    /// because the cluster at the corner has points of both lines.
    fn index(&self, polyline: &SampledPolyline<P>, corner: &DetectedCorner<P>) -> usize {
        let first = |k: usize| {
            self.clusters
                .get(k)
                .map_or_else(|| polyline.points.len(), |cluster| cluster.first)
        };
        let inwards = |index: usize| {
            // |x|²/(4τ) − x·outward is minimal at x = 2τ · outward, 2 tolerances outside of the apex.
            let offset = polyline.point(index) - corner.apex;
            offset.dot(offset) / (4.0 * self.tolerance) - offset.dot(corner.outward)
        };
        let k = corner.cluster;
        (first(k.saturating_sub(1))..first(k + 2))
            .min_by(|&a, &b| inwards(a).total_cmp(&inwards(b)))
            .unwrap_or(0)
    }
}

/// At most MAX_SAMPLES even steps up to `count`.
fn spread(count: usize) -> impl Iterator<Item = usize> {
    let samples = count.min(MAX_SAMPLES);
    (1..=samples).map(move |i| i * count / samples)
}

/// Whether two vectors differ by more than the angle with a given cosine. A vector of length 0 has no angle.
fn turns_by_more_than<P: Point>([u, v]: [P; 2], cosine: f64) -> bool {
    u.dot(v) < cosine * (u.dot(u) * v.dot(v)).sqrt()
}

/// 2 atan2(|u − v|, |u + v|) for unit vectors, which is accurate for small and for large angles.
pub(crate) fn angle_between<P: Point>(u: P, v: P) -> f64 {
    let (u, v) = (u.unit(), v.unit());
    2.0 * (u - v).norm().atan2((u + v).norm())
}
