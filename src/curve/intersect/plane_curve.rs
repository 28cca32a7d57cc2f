//! What intersections ask of a curve, which may be polynomial or rational.

use super::constants::{MAX_PAIRS, MAX_PAIRS_PER_DEGREE};
use crate::bernstein::evaluate::evaluate;
use crate::curve::Curve;
use crate::curve::elevate::elevate_once;
use crate::curve::hodograph::derivative_zeros;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::numeric::list::{Points, Scalars};
use casteljau_kernels::bernstein::de_casteljau::keep_between;
use casteljau_kernels::curve::intersect::clipping::{
    ClippingSolver, Coefficients, Contact, Piece, Unweighted, Weights, intersect_cubics,
};
use glam::DVec2;

/// A plane curve that lies in the hull of its control points, and whose direction is everywhere a sum of its control edges
/// with positive factors.
pub(crate) trait PlaneCurve: Sized {
    /// The rounding of evaluation and subdivision, as a multiple of that of a polynomial curve.
    const ROUNDING: f64;

    /// The control points.
    fn points(&self) -> &[DVec2];

    /// The curve relative to an origin, times a scale.
    fn normalized(&self, origin: DVec2, scale: f64) -> Self;

    /// The point at t.
    fn at(&self, t: f64) -> DVec2;

    /// The point and the first two derivatives, as a function of t.
    fn jets(&self) -> impl Fn(f64) -> [DVec2; 3] + '_;

    /// The unit tangent at t.
    fn tangent_at(&self, t: f64) -> DVec2;

    /// The control points of a segment, from ≤ to.
    fn part(&self, from: f64, to: f64) -> Points<DVec2>;

    /// The parameters inside (0, 1) where the derivative vanishes.
    fn derivative_zeros(&self) -> Scalars;

    /// The contacts, points closer than `slack`, of the given pairs of segments of two curves, which lie between cuts, unsorted, and
    /// the number of steps of the search.
    fn search(
        curves: &[Self; 2],
        slack: f64,
        cuts: [&[f64]; 2],
        pairs: impl Iterator<Item = (usize, usize)>,
    ) -> (Vec<Contact>, usize);
}

impl PlaneCurve for Curve<DVec2> {
    const ROUNDING: f64 = 1.0;

    fn points(&self) -> &[DVec2] {
        &self.points
    }

    fn normalized(&self, origin: DVec2, scale: f64) -> Self {
        let image = |p: &DVec2| (*p - origin) * scale;
        Self::from_points(self.points.iter().map(image).collect())
    }

    fn at(&self, t: f64) -> DVec2 {
        evaluate(&self.points, t)
    }

    fn jets(&self) -> impl Fn(f64) -> [DVec2; 3] + '_ {
        let curve = CurveWithDerivatives::new(&self.points);
        move |t| curve.jet(t)
    }

    fn tangent_at(&self, t: f64) -> DVec2 {
        self.tangent(t)
    }

    fn part(&self, from: f64, to: f64) -> Points<DVec2> {
        let mut points = self.points.clone();
        keep_between(&mut points, from, to);
        points
    }

    fn derivative_zeros(&self) -> Scalars {
        derivative_zeros(&self.points)
    }

    fn search(
        [a, b]: &[Self; 2],
        slack: f64,
        cuts: [&[f64]; 2],
        pairs: impl Iterator<Item = (usize, usize)>,
    ) -> (Vec<Contact>, usize) {
        if a.degree().max(b.degree()) <= 3 {
            // Lower degrees are elevated to 3, for which the search is compiled with arrays.
            let whole = [cubic(&a.points), cubic(&b.points)];
            return search_with(whole, slack, cuts, pairs, intersect_cubics);
        }
        let degree = a.degree().max(b.degree());
        let whole = [piece(&a.points, degree), piece(&b.points, degree)];
        search_with(whole, slack, cuts, pairs, ClippingSolver::run)
    }
}

/// [`PlaneCurve::search`] with a function that searches one pair of segments.
pub(crate) fn search_with<C: Coefficients, W: Weights<C>>(
    whole: [Piece<C, W>; 2],
    slack: f64,
    cuts: [&[f64]; 2],
    pairs: impl Iterator<Item = (usize, usize)>,
    run: impl Fn(&mut ClippingSolver<C, W>, [f64; 2], [f64; 2]),
) -> (Vec<Contact>, usize) {
    let degree = whole[0].x.get().len() - 1;
    let limit = MAX_PAIRS + MAX_PAIRS_PER_DEGREE * degree.saturating_sub(3);
    let mut solver = ClippingSolver::new(whole, slack, limit);
    for (i, j) in pairs {
        let [ts, us] = [&cuts[0][i..i + 2], &cuts[1][j..j + 2]];
        run(&mut solver, [ts[0], ts[1]], [us[0], us[1]]);
    }
    (solver.found, solver.work.used())
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
        weights: Unweighted,
        from: 0.0,
        to: 1.0,
    }
}

/// The curve elevated to a given degree.
fn piece(points: &[DVec2], degree: usize) -> Piece<Vec<f64>> {
    let mut points = Points::from(points);
    while points.len() <= degree {
        elevate_once(&mut points);
    }
    Piece {
        x: points.iter().map(|p| p.x).collect(),
        y: points.iter().map(|p| p.y).collect(),
        weights: Unweighted,
        from: 0.0,
        to: 1.0,
    }
}
