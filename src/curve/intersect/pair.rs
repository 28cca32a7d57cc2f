//! Two curves made comparable.

use super::super::{Points, ratio};
use super::zone::joined;
use super::{Contact, Curve, Intersection};
use casteljau_kernels as kernels;
use casteljau_kernels::{Meeting, Piece, meet_cubics};
use glam::DVec2;

/// The most pairs of pieces that are looked at for curves up to degree 3.
const BUDGET: usize = 20_000;

/// The rounding of a coordinate of the input, which moves a curve by up to one ulp in each coordinate of both curves.
const INPUT_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// What evaluating and cutting adds at size 1, for each degree.
const STEP_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Parameters so close are the same: a few roundings of numbers up to 1.
const ONE_PARAMETER: f64 = 8.0 * f64::EPSILON;

/// Two curves moved to the origin and scaled to size 1.
pub(super) struct Pair {
    pub(super) a: Points<DVec2>,
    pub(super) b: Points<DVec2>,
    /// Points closer than this are one point.
    pub(super) slack: f64,
}

impl Pair {
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
        let place = |p: &DVec2| (*p * unit - origin) * scale;
        let degree = (a.len().max(b.len()) - 1) as f64;
        Some(Self {
            a: a.iter().map(place).collect(),
            b: b.iter().map(place).collect(),
            slack: INPUT_ROUNDING * (largest * unit) * scale + STEP_ROUNDING * (1.0 + degree),
        })
    }

    /// Everything that the curves share, in order.
    pub(super) fn solve(&self, a: &Curve<DVec2>, b: &Curve<DVec2>) -> Vec<Intersection> {
        let mut places = Vec::new();
        for zone in joined(self, self.search()) {
            self.settle(&zone, &mut places);
        }
        in_order(&mut places);
        places
            .into_iter()
            .map(|(t, u, kind)| Intersection {
                t,
                u,
                point: point_at(a, b, t, u),
                kind,
            })
            .collect()
    }

    fn search(&self) -> Vec<kernels::Contact> {
        let degree = self.a.len().max(self.b.len()) - 1;
        if degree <= 3 {
            return meet_cubics(cubic(&self.a), cubic(&self.b), self.slack, BUDGET).found;
        }
        let (a, b) = (piece(&self.a, degree), piece(&self.b, degree));
        let mut meeting = Meeting::new(a, b, self.slack, BUDGET * degree);
        meeting.run();
        meeting.found
    }
}

/// Sorts by t, then by u; parameters that differ by rounding become one.
fn in_order(places: &mut [(f64, f64, Contact)]) {
    places.sort_by(|p, q| p.0.total_cmp(&q.0));
    for k in 1..places.len() {
        if places[k].0 - places[k - 1].0 <= ONE_PARAMETER {
            places[k].0 = places[k - 1].0;
        }
    }
    places.sort_by(|p, q| p.0.total_cmp(&q.0).then(p.1.total_cmp(&q.1)));
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
