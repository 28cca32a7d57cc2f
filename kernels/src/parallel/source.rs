//! The curve of which parallels are made.

use super::VANISHING_SPEED;
use super::vector::Plane;

/// The most control points of a curve.
const MOST_POINTS: usize = 65;

/// A curve, ready to be asked for points and derivatives.
pub struct Source {
    /// The control points, and the differences of neighbours, of a degree above 3.
    many: Vec<Plane>,
    differences: Vec<Plane>,
    /// The control points up to degree 3.
    few: [Plane; 4],
    count: usize,
    /// Taylor coefficients at t = 0, where the degree is at most 3.
    powers: [Plane; 4],
    /// A bound on the fourth derivative: 0 up to degree 3.
    fourth: f64,
    /// The largest |B′| of the hodograph's control points.
    speed: f64,
}

/// A place on the curve: the parameter, the point, the first two derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Place {
    pub(crate) t: f64,
    pub(crate) b: Plane,
    pub(crate) v: Plane,
    pub(crate) a: Plane,
}

impl Source {
    /// From 2 to 65 control points, of a size of about 1 and near the origin.
    pub fn new(given: &[[f64; 2]]) -> Self {
        let count = given.len().min(MOST_POINTS);
        let mut few = [Plane::default(); 4];
        let (mut many, mut differences) = (Vec::new(), Vec::new());
        if count > 4 {
            many.extend(given[..count].iter().map(|&[x, y]| Plane { x, y }));
            differences.extend(many.windows(2).map(|p| p[1] - p[0]));
        } else {
            for (p, &[x, y]) in few.iter_mut().zip(given) {
                *p = Plane { x, y };
            }
        }
        let all = if count > 4 { &many } else { &few[..count] };
        let n = count.saturating_sub(1);
        let speed = all
            .windows(2)
            .fold(0.0, |m: f64, p| m.max((p[1] - p[0]).square()));
        let fourth = fourth_bound(all);
        let [p0, p1, p2, p3] = few;
        let powers = match count {
            0 | 1 => [p0, Plane::default(), Plane::default(), Plane::default()],
            2 => [p0, p1 - p0, Plane::default(), Plane::default()],
            3 => [p0, (p1 - p0) * 2.0, (p2 - p1) - (p1 - p0), Plane::default()],
            _ => {
                let (e0, e1, e2) = (p1 - p0, p2 - p1, p3 - p2);
                [p0, e0 * 3.0, (e1 - e0) * 3.0, (e2 - e1) - (e1 - e0)]
            }
        };
        Self {
            many,
            differences,
            few,
            count,
            powers,
            fourth,
            speed: n as f64 * speed.sqrt(),
        }
    }

    /// The largest |B′| that the control points allow.
    pub(crate) fn speed(&self) -> f64 {
        self.speed
    }

    /// How far a cubic with the same ends and derivatives there may be from a piece of this length.
    #[inline(always)]
    pub(crate) fn remainder(&self, h: f64) -> f64 {
        self.fourth * (h * h) * (h * h) / 384.0
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.count - 1
    }

    fn points(&self) -> &[Plane] {
        if self.count > 4 {
            &self.many
        } else {
            &self.few[..self.count]
        }
    }

    /// The differences of neighbours, for degrees above 3.
    pub(crate) fn differences(&self) -> &[Plane] {
        &self.differences
    }

    /// The control points of B′ as a quadratic, up to degree 3.
    pub(crate) fn first_vectors(&self) -> [Plane; 3] {
        let [_, c1, c2, c3] = self.powers;
        [c1, c1 + c2, c1 + c2 * 2.0 + c3 * 3.0]
    }

    /// The tangents at both ends: toward the first control point that is not the end itself.
    pub fn end_tangents(&self) -> [Plane; 2] {
        let least = VANISHING_SPEED * self.speed;
        let points = self.points();
        let toward = |end: Plane, p: &Plane| {
            let way = *p - end;
            (way.length() > least).then(|| way.unit())
        };
        let (first, last) = (points[0], points[self.count - 1]);
        let start = points.iter().find_map(|p| toward(first, p));
        let end = points.iter().rev().find_map(|p| toward(last, p));
        [start.unwrap_or_default(), -end.unwrap_or_default()]
    }

    /// The place at t.
    #[inline]
    pub(crate) fn at(&self, t: f64) -> Place {
        if self.count > 4 {
            return self.at_by_casteljau(t);
        }
        let [c0, c1, c2, c3] = self.powers;
        let (d2, d3) = (c2 * 2.0, c3 * 3.0);
        Place {
            t,
            b: c0 + (c1 + (c2 + c3 * t) * t) * t,
            v: c1 + (d2 + d3 * t) * t,
            a: d2 + d3 * (2.0 * t),
        }
    }

    /// By de Casteljau's algorithm; derivatives from the differences, so that they keep their digits next to handles
    /// without a length.
    fn at_by_casteljau(&self, t: f64) -> Place {
        let mut row = [Plane::default(); MOST_POINTS];
        let mut slopes = row;
        row[..self.count].copy_from_slice(&self.many);
        slopes[..self.degree()].copy_from_slice(&self.differences);
        let s = 1.0 - t;
        let n = self.degree();
        for last in (1..=n).rev() {
            for i in 0..last {
                row[i] = row[i] * s + row[i + 1] * t;
            }
        }
        for last in (2..n).rev() {
            for i in 0..last {
                slopes[i] = slopes[i] * s + slopes[i + 1] * t;
            }
        }
        let n = n as f64;
        Place {
            t,
            b: row[0],
            v: (slopes[0] * s + slopes[1] * t) * n,
            a: (slopes[1] - slopes[0]) * (n * (n - 1.0)),
        }
    }
}

/// n(n−1)(n−2)(n−3) times the longest fourth difference.
fn fourth_bound(points: &[Plane]) -> f64 {
    if points.len() < 5 {
        return 0.0;
    }
    let n = (points.len() - 1) as f64;
    let most = points.windows(5).fold(0.0, |m: f64, p| {
        m.max((p[0] + p[4] - (p[1] + p[3]) * 4.0 + p[2] * 6.0).square())
    });
    n * (n - 1.0) * (n - 2.0) * (n - 3.0) * most.sqrt()
}
