//! Where is a polynomial over patches least? The certain answer, by branch and bound.

use super::piece::{Jet, MODERATE_DEGREE, Piece};
use super::waiting::Waiting;
use casteljau_kernels::WorkLimit;
use std::collections::BinaryHeap;

/// What rounding makes of coefficients of the size 1 to 8, after products and halvings; as much is no difference.
const SLACK: f64 = 64.0 * f64::EPSILON;

/// Minima nearer than this in u and v are one: the square root of rounding, where a minimum is flat, and some.
const SAME: f64 = 1.0 / 1_048_576.0;

/// Newton's steps from one start; they double the digits, unless the minimum is flat.
const MAX_STEPS: usize = 32;

/// A step below this is the last: what is left is of the size of its square.
const LAST_STEP: f64 = 1e-9;

/// More steps are cut than this only at a start that is no use.
const MAX_CUTS: usize = 8;

/// The most coefficients of pieces that wait: 16 MB.
const MAX_WAITING: usize = 1 << 21;

/// What a refinement is counted as, in evaluations with derivatives.
const REFINEMENT_JETS: usize = 4;

const UNIT_SQUARE: [[f64; 2]; 2] = [[0.0, 1.0]; 2];

/// The most starts that are tried because they are as good as the best place. Minima that are one by one as good are
/// few; where whole curves are, trying all of them would take long.
const MAX_TIES: usize = 256;

/// The place of a minimum.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Minimum {
    /// The number of the polynomial, as its piece says.
    pub(crate) root: usize,
    pub(crate) u: f64,
    pub(crate) v: f64,
    /// What the objective says of it.
    pub(crate) value: f64,
}

/// What is asked for, in other words than by the polynomials, which rise and fall with it.
pub(crate) trait Objective {
    /// The value at a place of a polynomial. It decides between places that the polynomials cannot tell apart.
    fn value(&self, root: usize, at: [f64; 2]) -> f64;

    /// How many times a patch's degree that of its polynomial is.
    fn degree_factor(&self) -> usize {
        1
    }

    /// A place that is as good or better, found in a way that loses fewer digits.
    fn refine(&self, _root: usize, at: [f64; 2]) -> [f64; 2] {
        at
    }

    /// Whether the search can end: no place is better by more than rounding, or a more exact search follows.
    fn is_min(&self, _minimum: &Minimum) -> bool {
        false
    }
}

/// The least of polynomials over the unit square with coefficients of the size 1 to 8 or less.
///
/// Where not points but whole curves are least, one of their points. When the search has taken the most steps for
/// each polynomial, the best place found: a local minimum from the least corner of all pieces so far. Also whether the
/// search came to its end.
pub(crate) fn minimise(roots: &[Piece], objective: &dyn Objective) -> Option<(Minimum, bool)> {
    let limits = roots
        .iter()
        .map(|root| root.max_search_steps(objective.degree_factor() * MODERATE_DEGREE));
    let mut work = WorkLimit::new(limits.fold(0, usize::saturating_add));
    let mut min = Min {
        roots,
        objective,
        is_done: false,
        floor: f64::INFINITY,
        best: None,
        ties: 0,
    };
    let corner = |root: &Piece| min_corner(root).1;
    let first = roots
        .iter()
        .min_by(|a, b| corner(a).total_cmp(&corner(b)))?;
    min.improve(first, &UNIT_SQUARE, true, &mut work);
    for root in roots {
        for (at, _) in root.corners(0) {
            min.keep_better(root, at, &mut work);
        }
    }
    let is_complete = min.search(&mut work);
    min.best.map(|best| (best, is_complete))
}

/// The least value so far.
struct Min<'a> {
    roots: &'a [Piece],
    objective: &'a dyn Objective,
    /// Whether no place is better than the best one.
    is_done: bool,
    /// The least value of a polynomial.
    floor: f64,
    best: Option<Minimum>,
    /// How many starts were tried that are no better than it.
    ties: usize,
}

impl Min<'_> {
    /// Looks at pieces, that with the least coefficient first, and halves those that may hold a lesser value. False when
    /// the limits end the search.
    fn search(&mut self, work: &mut WorkLimit) -> bool {
        let mut waiting: BinaryHeap<Waiting> =
            self.roots.iter().cloned().map(by_min_coefficient).collect();
        // Of halves only: all whole polynomials are there before.
        let mut coefficients = 0;
        while let Some(Waiting { low, piece }) = waiting.pop() {
            let count = piece.plane(0).len();
            coefficients = usize::saturating_sub(coefficients, count);
            // The least coefficients of all others are no less.
            if self.is_done || low >= self.floor + SLACK {
                return true;
            }
            if !work.spend(piece.steps()) {
                return false;
            }
            if self.look(&piece, low, work) {
                coefficients += 2 * count;
                if coefficients > MAX_WAITING {
                    return false;
                }
                waiting.extend(piece.halves(1).map(by_min_coefficient));
            }
        }
        true
    }

    /// Whether a piece may hold a lesser value and has to be seen closer.
    fn look(&mut self, piece: &Piece, low: f64, work: &mut WorkLimit) -> bool {
        self.improve(piece, &UNIT_SQUARE, false, work);
        if self.is_done || low >= self.floor - SLACK || !piece.is_divisible() {
            return false;
        }
        // Of a convex piece one minimum is the only one.
        !(is_convex(piece) && self.improve(piece, &[piece.u, piece.v], true, work))
    }

    /// Goes down from the least corner of a piece, if that is worth it, and says whether it reached a minimum.
    fn improve(
        &mut self,
        piece: &Piece,
        within: &[[f64; 2]; 2],
        always: bool,
        work: &mut WorkLimit,
    ) -> bool {
        let (start, corner) = min_corner(piece);
        let root = &self.roots[piece.root];
        if !always && corner > self.floor - SLACK {
            if corner > self.floor + SLACK
                || self.ties == MAX_TIES
                || self.is_known(piece.root, start)
                || !work.spend(root.jet_steps())
                || !self.is_better(self.objective.value(piece.root, start))
            {
                return false;
            }
            self.ties += 1;
        }
        let (at, value, converged) = go_down(root, within, start, work);
        self.floor = self.floor.min(value);
        self.keep_better(root, at, work);
        converged
    }

    fn is_better(&self, value: f64) -> bool {
        self.best.is_none_or(|best| value < best.value)
    }

    /// Makes a place the best one if it is better than that.
    fn keep_better(&mut self, piece: &Piece, at: [f64; 2], work: &mut WorkLimit) {
        let root = piece.root;
        let [u, v] = if work.spend(REFINEMENT_JETS * piece.jet_steps()) {
            self.objective.refine(root, at)
        } else {
            at
        };
        let value = self.objective.value(root, [u, v]);
        if self.is_better(value) {
            let best = Minimum { root, u, v, value };
            self.is_done = self.objective.is_min(&best);
            self.best = Some(best);
        }
    }

    /// Whether the best place is that one.
    fn is_known(&self, root: usize, [u, v]: [f64; 2]) -> bool {
        self.best.is_some_and(|best| {
            best.root == root && (best.u - u).abs() < SAME && (best.v - v).abs() < SAME
        })
    }
}

fn by_min_coefficient(piece: Piece) -> Waiting {
    let [low, _] = piece.range(0);
    Waiting { low, piece }
}

/// The least corner of a piece and its value.
fn min_corner(piece: &Piece) -> ([f64; 2], f64) {
    let [first, others @ ..] = piece.corners(0);
    let lesser = |a: ([f64; 2], f64), b: ([f64; 2], f64)| if b.1 < a.1 { b } else { a };
    others.into_iter().fold(first, lesser)
}

/// Newton's method within a rectangle, each step cut short until it goes down. The last place, its value, and whether
/// no step was left to take there.
fn go_down(
    root: &Piece,
    within: &[[f64; 2]; 2],
    start: [f64; 2],
    work: &mut WorkLimit,
) -> ([f64; 2], f64, bool) {
    let mut at = start;
    let mut jet = root.jet(0, at);
    for _ in 0..MAX_STEPS {
        let mut step = newton_step(&jet, at, within);
        let is_last = step.iter().all(|s| s.abs() < LAST_STEP);
        let mut cuts = 0;
        let (next, there) = loop {
            let next = moved(at, step, within);
            let there = root.jet(0, next);
            let may_go_on = work.spend(root.jet_steps());
            if is_last || there.f <= jet.f || cuts == MAX_CUTS || !may_go_on {
                break (next, there);
            }
            cuts += 1;
            step = step.map(|s| 0.25 * s);
        };
        if is_last {
            return (next, there.f, true);
        }
        if there.f > jet.f {
            break;
        }
        (at, jet) = (next, there);
    }
    (at, jet.f, false)
}

fn moved(at: [f64; 2], step: [f64; 2], within: &[[f64; 2]; 2]) -> [f64; 2] {
    [0, 1].map(|k| (at[k] + step[k]).clamp(within[k][0], within[k][1]))
}

/// Newton's step, along a side only where the way down leads out of the rectangle.
fn newton_step(jet: &Jet, at: [f64; 2], within: &[[f64; 2]; 2]) -> [f64; 2] {
    let stuck = |k: usize, slope: f64| {
        (at[k] <= within[k][0] && slope >= 0.0) || (at[k] >= within[k][1] && slope <= 0.0)
    };
    // Along one direction; where the bend is not that of a minimum, some way down.
    let uncoupled = |slope: f64, bend: f64| -slope / bend.max(slope.abs()).max(f64::MIN_POSITIVE);
    match (stuck(0, jet.u), stuck(1, jet.v)) {
        (true, true) => [0.0; 2],
        (true, false) => [0.0, uncoupled(jet.v, jet.vv)],
        (false, true) => [uncoupled(jet.u, jet.uu), 0.0],
        (false, false) => {
            let det = jet.uu * jet.vv - jet.uv * jet.uv;
            // Below this share rounding decides on the direction.
            if jet.uu > 0.0 && det > f64::EPSILON.sqrt() * jet.uu * jet.vv.abs() {
                [
                    (jet.uv * jet.v - jet.vv * jet.u) / det,
                    (jet.uv * jet.u - jet.uu * jet.v) / det,
                ]
            } else {
                let bend = jet.uu.max(0.0) + jet.vv.max(0.0);
                [uncoupled(jet.u, bend), uncoupled(jet.v, bend)]
            }
        }
    }
}

/// Whether the second derivatives' coefficients prove that the polynomial has one minimum in the piece.
fn is_convex(piece: &Piece) -> bool {
    let [uu, uv, vv] = piece.second_derivatives();
    uu[0] > 0.0 && vv[0] > 0.0 && uu[0] * vv[0] > uv[0].abs().max(uv[1].abs()).powi(2)
}
