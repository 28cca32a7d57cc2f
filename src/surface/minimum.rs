//! Where is a polynomial over patches least? The certain answer, by branch and bound.

use super::piece::{Jet, Piece, search};

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

const UNIT_SQUARE: [[f64; 2]; 2] = [[0.0, 1.0]; 2];

/// The most starts that are tried because they are as good as the best place. Minima that are one by one as good are
/// few; where whole curves are, trying all of them would take long.
const MAX_TIES: usize = 256;

/// The place of a minimum.
#[derive(Clone, Copy, Debug)]
pub(super) struct Minimum {
    /// The number of the polynomial, as its piece says.
    pub(super) root: usize,
    pub(super) u: f64,
    pub(super) v: f64,
    /// What `measure` says of it.
    pub(super) value: f64,
}

/// The least of polynomials over the unit square with coefficients of the size 1 to 8 or less.
///
/// `measure` gives the value that is asked for at a place; the polynomials rise and fall with it. It decides between
/// places that the polynomials cannot tell apart. Where not points but whole curves are least, one of their points.
pub(super) fn minimise(
    roots: &[Piece],
    measure: &dyn Fn(usize, f64, f64) -> f64,
) -> Option<Minimum> {
    let mut least = Least {
        roots,
        measure,
        floor: f64::INFINITY,
        best: None,
        ties: 0,
    };
    let corner = |root: &Piece| least_corner(root).1;
    let first = roots
        .iter()
        .min_by(|a, b| corner(a).total_cmp(&corner(b)))?;
    least.improve(first, &UNIT_SQUARE, true);
    search(roots.to_vec(), usize::MAX, &mut |piece| least.look(piece));
    least.best
}

/// The least value so far.
struct Least<'a> {
    roots: &'a [Piece],
    measure: &'a dyn Fn(usize, f64, f64) -> f64,
    /// The least value of a polynomial.
    floor: f64,
    best: Option<Minimum>,
    /// How many starts were tried that are no better than it.
    ties: usize,
}

impl Least<'_> {
    /// Whether a piece may hold a lesser value and has to be seen closer.
    fn look(&mut self, piece: &Piece) -> bool {
        let [low, _] = piece.range(0);
        if low >= self.floor + SLACK {
            return false;
        }
        self.improve(piece, &UNIT_SQUARE, false);
        if low >= self.floor - SLACK {
            return false;
        }
        // Of a convex piece one minimum is the only one.
        !(is_convex(piece) && self.improve(piece, &[piece.u, piece.v], true))
    }

    /// Goes down from the least corner of a piece, if that is worth it, and says whether it reached a minimum.
    fn improve(&mut self, piece: &Piece, within: &[[f64; 2]; 2], always: bool) -> bool {
        let (start, corner) = least_corner(piece);
        if !always && corner > self.floor - SLACK {
            if corner > self.floor + SLACK
                || self.ties == MAX_TIES
                || self.is_known(piece.root, start)
            {
                return false;
            }
            self.ties += 1;
        }
        let (at, value, settled) = go_down(&self.roots[piece.root], within, start);
        self.floor = self.floor.min(value);
        let measured = (self.measure)(piece.root, at[0], at[1]);
        if self.best.is_none_or(|best| measured < best.value) {
            self.best = Some(Minimum {
                root: piece.root,
                u: at[0],
                v: at[1],
                value: measured,
            });
        }
        settled
    }

    /// Whether the best place is that one.
    fn is_known(&self, root: usize, [u, v]: [f64; 2]) -> bool {
        self.best.is_some_and(|best| {
            best.root == root && (best.u - u).abs() < SAME && (best.v - v).abs() < SAME
        })
    }
}

/// The least corner of a piece and its value.
fn least_corner(piece: &Piece) -> ([f64; 2], f64) {
    let [first, others @ ..] = piece.corners();
    let lesser = |a: ([f64; 2], f64), b: ([f64; 2], f64)| if b.1 < a.1 { b } else { a };
    others.into_iter().fold(first, lesser)
}

/// Newton's method within a rectangle, each step cut short until it goes down. The last place, its value, and whether
/// no step was left to take there.
fn go_down(root: &Piece, within: &[[f64; 2]; 2], start: [f64; 2]) -> ([f64; 2], f64, bool) {
    let mut at = start;
    let mut jet = root.jet(0, at);
    for _ in 0..MAX_STEPS {
        let mut step = newton_step(&jet, at, within);
        let is_last = step.iter().all(|s| s.abs() < LAST_STEP);
        let mut cuts = 0;
        let (next, there) = loop {
            let next = moved(at, step, within);
            let there = root.jet(0, next);
            if is_last || there.f <= jet.f || cuts == MAX_CUTS {
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
    let alone = |slope: f64, bend: f64| -slope / bend.max(slope.abs()).max(f64::MIN_POSITIVE);
    match (stuck(0, jet.u), stuck(1, jet.v)) {
        (true, true) => [0.0; 2],
        (true, false) => [0.0, alone(jet.v, jet.vv)],
        (false, true) => [alone(jet.u, jet.uu), 0.0],
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
                [alone(jet.u, bend), alone(jet.v, bend)]
            }
        }
    }
}

/// Whether the second derivatives' coefficients prove that the polynomial has one minimum in the piece.
fn is_convex(piece: &Piece) -> bool {
    let [uu, uv, vv] = piece.bends();
    uu[0] > 0.0 && vv[0] > 0.0 && uu[0] * vv[0] > uv[0].abs().max(uv[1].abs()).powi(2)
}
