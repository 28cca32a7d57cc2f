//! Tangents and smoothed positions of points with noise.
//!
//! A parabola is fitted to the points around each cluster. Its range starts with a few tolerances, so that the direction
//! does not follow the noise, and is doubled while the residual does not grow: noise leaves the same residual over
//! any range, but where the curve is not a parabola the residual grows with the third power of the range. Source:
//! Lepskii, "On a problem of adaptive estimation in Gaussian white noise", Theory of Probability and its Applications
//! 35 (1991).

use super::local_fit::Parabola;
use super::polyline::{Cluster, SampledPolyline};
use crate::geometry::point::Point;

/// Half of the first range, in tolerances.
const FIRST_RANGE: f64 = 4.0;

/// The range is doubled at most this often.
const MAX_DOUBLINGS: usize = 4;

/// The number of clusters from which a parabola is fitted.
const MAX_SAMPLES: usize = 24;

/// The assumed standard deviation, as a part of the tolerance, if there are too few points to measure it.
const UNKNOWN: f64 = 0.3;

/// A standard deviation below this part of the tolerance is not regarded as growing.
const NEGLIGIBLE: f64 = 0.02;

/// The smoothed position and the unit tangent at a point.
#[derive(Clone, Copy, Default)]
pub(crate) struct Smoothed<P> {
    pub(crate) position: P,
    pub(crate) tangent: P,
}

/// The smoothed position and the tangent for each index from `first` to `last`, using no points outside this range.
pub(crate) fn smoothed<P: Point>(
    polyline: &SampledPolyline<P>,
    [first, last]: [usize; 2],
    tolerance: f64,
) -> impl Iterator<Item = (usize, Smoothed<P>)> {
    let clusters = polyline.clusters(first, last, tolerance);
    let chord = polyline.point(last) - polyline.point(first);
    (0..clusters.len()).flat_map(move |k| {
        let next = clusters.get(k + 1).map_or(last + 1, |next| next.first);
        let (here, parabola) = (clusters[k], local_parabola(&clusters, k, tolerance));
        (here.first..next).map(move |index| {
            let x = here.length_to(polyline.length(index));
            let position = here.mean + parabola.value(x);
            let mut tangent = parabola.derivative(x).unit();
            if tangent == P::default() {
                tangent = chord.unit();
            }
            (index, Smoothed { position, tangent })
        })
    })
}

/// The parabola near cluster k, relative to its mean and chord length.
fn local_parabola<P: Point>(clusters: &[Cluster<P>], k: usize, tolerance: f64) -> Parabola<P> {
    let mut half = first_half(clusters, k, FIRST_RANGE * tolerance);
    let mut best = Fit::new(clusters, k, half);
    let mut limit = best.limit(tolerance);
    for _ in 0..MAX_DOUBLINGS {
        // The range already contains all clusters.
        if 2 * half + 1 >= clusters.len() {
            break;
        }
        half *= 2;
        let next = Fit::new(clusters, k, half);
        if next.variance() > limit * limit {
            break;
        }
        limit = next.limit(tolerance);
        best = next;
    }
    best.parabola
}

/// The number of clusters to one side, at least 1, within a distance.
fn first_half<P: Point>(clusters: &[Cluster<P>], k: usize, range: f64) -> usize {
    let near = |index: usize| (clusters[index].mean - clusters[k].mean).norm() < range;
    let before = (1..=k.min(MAX_SAMPLES)).take_while(|n| near(k - n)).count();
    let room = clusters.len() - 1 - k;
    let after = (1..=room.min(MAX_SAMPLES))
        .take_while(|n| near(k + n))
        .count();
    before.max(after).max(1)
}

/// A parabola and the number of its samples.
struct Fit<P> {
    parabola: Parabola<P>,
    /// The number of points beyond the three that determine a parabola.
    excess: usize,
}

impl<P: Point> Fit<P> {
    /// Fits 2·half + 1 clusters around cluster k. Next to an end the range is shifted.
    fn new(clusters: &[Cluster<P>], k: usize, half: usize) -> Self {
        let count = (2 * half + 1).min(clusters.len());
        let first = k.saturating_sub(half).min(clusters.len() - count);
        let used = count.min(MAX_SAMPLES);
        let mut samples = [(P::default(), 0.0); MAX_SAMPLES];
        for (i, sample) in samples[..used].iter_mut().enumerate() {
            // Even steps from the first to the last cluster of the range.
            let cluster = clusters[first + i * (count - 1) / (used - 1).max(1)];
            *sample = (
                cluster.mean - clusters[k].mean,
                cluster.length - clusters[k].length,
            );
        }
        Self {
            parabola: Parabola::fitted(&samples[..used]),
            excess: used.saturating_sub(3),
        }
    }

    fn variance(&self) -> f64 {
        self.parabola.squares / self.excess.max(1) as f64
    }

    /// The standard deviation above which a larger range is refused: the present one and its standard error.
    fn limit(&self, tolerance: f64) -> f64 {
        if self.excess == 0 {
            return UNKNOWN * tolerance;
        }
        // The relative standard error of a standard deviation with n degrees of freedom is 1/√(2n).
        let error = 1.0 / (2.0 * self.excess as f64).sqrt();
        (self.variance().sqrt() * (1.0 + error)).max(NEGLIGIBLE * tolerance)
    }
}
