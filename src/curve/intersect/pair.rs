//! Two curves made comparable.

use super::super::{Points, Scalars, ratio};
use super::contact_interval::joined;
use super::pieces::{stops, with_ends};
use super::{Curve, Intersection, IntersectionKind};
use casteljau_kernels as kernels;
use casteljau_kernels::{ClippingSolver, Piece, intersect_cubics};
use glam::DVec2;

/// Pairs of pieces that are looked at, and so many more for each degree above 3: more than ten times what 999 of 1000
/// curves of moderate numbers need, also where one of them is nearly the other.
const MAX_PAIRS: usize = 4096;
const MAX_PAIRS_PER_DEGREE: usize = 256;

/// The rounding of a coordinate of the input, which moves a curve by up to one ulp in each coordinate of both curves.
const INPUT_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// What evaluating and cutting adds at size 1, for each degree.
const STEP_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Parameters so close are the same: a few roundings of numbers up to 1.
const ONE_PARAMETER: f64 = 8.0 * f64::EPSILON;

/// A crossing that two pieces share is found by both, with some roundings between.
const SAME_POINT: f64 = 1e-10;

/// A contact so near to an end of a shared piece is that end.
const ONE_END: f64 = 1e-7;

/// A place by its parameters, and what it is.
pub(super) type ClassifiedPoint = (f64, f64, IntersectionKind);

/// Two curves moved to the origin and scaled to size 1.
pub(super) struct NormalizedPair {
    pub(super) curves: [Points<DVec2>; 2],
    /// Points closer than this are one point.
    pub(super) slack: f64,
    /// Where they stop: cusps, and where a straight curve turns back.
    pub(super) stops: [Scalars; 2],
}

impl NormalizedPair {
    /// `None` where the boxes of the control points are apart.
    pub(super) fn new(a: &[DVec2], b: &[DVec2]) -> Option<Self> {
        let (min_a, max_a) = corners(a);
        let (min_b, max_b) = corners(b);
        let (min, max) = (min_a.min(min_b), max_a.max(max_b));
        let largest = min.abs().max(max.abs()).max_element();
        let nearest = INPUT_ROUNDING * largest;
        let gap = min_a.max(min_b) - max_a.min(max_b);
        if gap.max_element() > nearest {
            return None;
        }
        // Halves, so that no difference overflows; powers of two, so that nothing is rounded.
        let unit = power_of_two(largest);
        let origin = a[0] * unit;
        let spread = ((max * unit - origin).abs())
            .max((min * unit - origin).abs())
            .max_element();
        let scale = power_of_two(spread);
        let normalized = |p: &DVec2| (*p * unit - origin) * scale;
        let degree = (a.len().max(b.len()) - 1) as f64;
        let (a, b): (Points<DVec2>, Points<DVec2>) = (
            a.iter().map(normalized).collect(),
            b.iter().map(normalized).collect(),
        );
        Some(Self {
            stops: [stops(&a), stops(&b)],
            curves: [a, b],
            slack: INPUT_ROUNDING * (largest * unit) * scale + STEP_ROUNDING * (1.0 + degree),
        })
    }

    /// Everything that the curves share, in order.
    pub(super) fn solve(&self, a: &Curve<DVec2>, b: &Curve<DVec2>) -> Vec<Intersection> {
        let locations = if self.is_of_lines() {
            self.lines()
        } else {
            self.exact(self.locations(self.contacts()))
        };
        locations
            .into_iter()
            .map(|(t, u, kind)| Intersection {
                t,
                u,
                point: point_at(a, b, t, u),
                kind,
            })
            .collect()
    }

    /// All contacts of the curves.
    fn contacts(&self) -> Vec<kernels::Contact> {
        if self.stops.iter().all(|stops| stops.is_empty()) {
            self.search(&[0.0, 1.0], &[0.0, 1.0], [(0, 0)])
        } else {
            let [cuts_a, cuts_b] = self.stops.each_ref().map(|stops| with_ends(stops));
            let (n, m) = (cuts_a.len() - 1, cuts_b.len() - 1);
            let pairs = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
            self.search(&cuts_a, &cuts_b, pairs)
        }
    }

    /// What the contacts are, in order.
    pub(super) fn locations(&self, found: Vec<kernels::Contact>) -> Vec<ClassifiedPoint> {
        let mut locations = Vec::with_capacity(found.len());
        if found.iter().all(|contact| contact.crossing) {
            let normalized =
                |contact: &kernels::Contact| self.snapped((contact.t[0], contact.u[0]));
            locations.extend(
                found
                    .iter()
                    .map(normalized)
                    .map(|(t, u)| (t, u, IntersectionKind::Cross)),
            );
        } else {
            for interval in joined(self, found) {
                self.classify(&interval, &mut locations);
            }
        }
        tidied(locations)
    }

    /// The contacts of some pieces with some others, in no order; the pieces lie between cuts.
    pub(super) fn search(
        &self,
        cuts_a: &[f64],
        cuts_b: &[f64],
        pairs: impl IntoIterator<Item = (usize, usize)>,
    ) -> Vec<kernels::Contact> {
        let [a, b] = &self.curves;
        let degree = a.len().max(b.len()) - 1;
        if degree <= 3 {
            let whole = [cubic(a), cubic(b)];
            let mut solver = ClippingSolver::new(whole, self.slack, MAX_PAIRS);
            for (i, j) in pairs {
                intersect_cubics(
                    &mut solver,
                    [cuts_a[i], cuts_a[i + 1]],
                    [cuts_b[j], cuts_b[j + 1]],
                );
            }
            return solver.found;
        }
        let whole = [piece(a, degree), piece(b, degree)];
        let mut solver = ClippingSolver::new(
            whole,
            self.slack,
            MAX_PAIRS + MAX_PAIRS_PER_DEGREE * (degree - 3),
        );
        for (i, j) in pairs {
            solver.run([cuts_a[i], cuts_a[i + 1]], [cuts_b[j], cuts_b[j + 1]]);
        }
        solver.found
    }
}

/// Sorted by t, then by u, parameters that differ by rounding made one, and each place once.
fn tidied(mut locations: Vec<ClassifiedPoint>) -> Vec<ClassifiedPoint> {
    sort(&mut locations, |p, q| p.0 < q.0);
    for k in 1..locations.len() {
        if locations[k].0 - locations[k - 1].0 <= ONE_PARAMETER {
            locations[k].0 = locations[k - 1].0;
        }
    }
    sort(&mut locations, |p, q| (p.0, p.1) < (q.0, q.1));
    let mut kept: Vec<ClassifiedPoint> = Vec::with_capacity(locations.len());
    for &normalized in &locations {
        let again = kept
            .iter()
            .rev()
            .any(|q| near(normalized, (q.0, q.1), SAME_POINT) && is_point(q));
        if !(is_point(&normalized) && (again || ends_piece(normalized, &locations))) {
            kept.push(normalized);
        }
    }
    kept
}

/// By insertion: the lists are short, or nearly in order.
pub(super) fn sort(
    locations: &mut [ClassifiedPoint],
    before: impl Fn(&ClassifiedPoint, &ClassifiedPoint) -> bool,
) {
    for k in 1..locations.len() {
        let mut i = k;
        while i > 0 && before(&locations[i], &locations[i - 1]) {
            locations.swap(i, i - 1);
            i -= 1;
        }
    }
}

fn is_point(normalized: &ClassifiedPoint) -> bool {
    !matches!(normalized.2, IntersectionKind::Overlap { .. })
}

fn near(p: ClassifiedPoint, (t, u): (f64, f64), within: f64) -> bool {
    (p.0 - t).abs() <= within && (p.1 - u).abs() <= within
}

/// Whether a place is an end of a shared piece.
fn ends_piece(normalized: ClassifiedPoint, all: &[ClassifiedPoint]) -> bool {
    all.iter().any(|q| {
        let IntersectionKind::Overlap { t_end, u_end } = q.2 else {
            return false;
        };
        near(normalized, (q.0, q.1), ONE_END) || near(normalized, (t_end, u_end), ONE_END)
    })
}

/// The point of both; where one of them ends there, its end as it was given.
fn point_at(a: &Curve<DVec2>, b: &Curve<DVec2>, t: f64, u: f64) -> DVec2 {
    if (u == 0.0 || u == 1.0) && t != 0.0 && t != 1.0 {
        b.eval(u)
    } else {
        a.eval(t)
    }
}

fn corners(points: &[DVec2]) -> (DVec2, DVec2) {
    points
        .iter()
        .fold((points[0], points[0]), |(min, max), &p| {
            (min.min(p), max.max(p))
        })
}

/// 2ᵏ so that x · 2ᵏ is in [½, 1); for the largest numbers up to 4, for the smallest below.
fn power_of_two(x: f64) -> f64 {
    if x == 0.0 {
        return 1.0;
    }
    let exponent = (x.to_bits() >> 52).clamp(1, 2044);
    f64::from_bits((2045 - exponent) << 52)
}

fn cubic(points: &[DVec2]) -> Piece<[f64; 4]> {
    let p = |i: usize| points[i];
    let points = match points.len() {
        2 => [
            p(0),
            p(0).lerp(p(1), 1.0 / 3.0),
            p(1).lerp(p(0), 1.0 / 3.0),
            p(1),
        ],
        3 => [
            p(0),
            (p(0) + p(1) * 2.0) / 3.0,
            (p(2) + p(1) * 2.0) / 3.0,
            p(2),
        ],
        _ => [p(0), p(1), p(2), p(3)],
    };
    Piece {
        x: points.map(|p| p.x),
        y: points.map(|p| p.y),
        from: 0.0,
        to: 1.0,
    }
}

/// The curve in a higher degree.
fn piece(points: &[DVec2], degree: usize) -> Piece<Vec<f64>> {
    let mut points = Points::from(points);
    while points.len() <= degree {
        let count = points.len();
        points.push(points[count - 1]);
        for i in (1..count).rev() {
            let part = ratio(i, count);
            points[i] = points[i - 1] * part + points[i] * (1.0 - part);
        }
    }
    Piece {
        x: points.iter().map(|p| p.x).collect(),
        y: points.iter().map(|p| p.y).collect(),
        from: 0.0,
        to: 1.0,
    }
}
