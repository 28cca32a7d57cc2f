//! Pieces of polynomials over the unit square, for branch-and-bound searches by subdivision.
//!
//! A polynomial in Bernstein form lies between its smallest and its largest coefficient. Over half of the square it has
//! other coefficients, which bound it more tightly: their distance from the polynomial falls to a quarter with each
//! halving. A search drops the pieces whose coefficients exclude a solution, halves the others, and repeats this.
//! Bounds, nearest points and rays all use this search with different polynomials. Source: Lane and Riesenfeld, "A
//! theoretical development for the computer generation and display of piecewise polynomial surfaces", IEEE PAMI 2
//! (1980).

use crate::numeric::float::as_f64;
use crate::patch::taylor::{BernsteinWeights, LONG_ROW, MAX_COUNT, taylor};
use casteljau_kernels::bernstein::de_casteljau::halve_net;
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// More halvings than the parameters allow in both directions: each has 53 bits, and a few more until the step becomes
/// 0.
const MAX_ROUNDS: usize = 2 * (f64::MANTISSA_DIGITS as usize + 11);

/// The maximum number of coefficients in all pieces of one round: 4 MB.
const MAX_COEFFICIENTS: usize = 1 << 19;

/// The maximum number of steps of a search: `MAX_STEPS` for patches up to this degree, `MAX_STEPS_ABOVE` for higher
/// degrees.
pub(crate) const MODERATE_DEGREE: usize = 24;
const MAX_STEPS: usize = 1 << 23;
const MAX_STEPS_ABOVE: usize = 1 << 26;

/// The steps that an evaluation and a piece cost in addition to the steps for their coefficients: memory is allocated
/// for a piece, and the piece is moved.
const JET_STEPS: usize = 256;
const PIECE_STEPS: usize = 640;

/// One or more polynomials ("planes") over a rectangle of parameters.
#[derive(Clone, Debug)]
pub(crate) struct PolynomialPiece {
    /// The index of the polynomial that this is a piece of.
    pub(crate) index: usize,
    /// The range of u …
    pub(crate) u: [f64; 2],
    /// … and the range of v.
    pub(crate) v: [f64; 2],
    /// The number of coefficients along u and along v.
    columns: usize,
    rows: usize,
    /// The Bernstein coefficients of one plane after the other, u along the fast index.
    planes: Vec<f64>,
}

/// The value and derivatives of a polynomial at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet {
    pub(crate) f: f64,
    pub(crate) u: f64,
    pub(crate) v: f64,
    pub(crate) uu: f64,
    pub(crate) uv: f64,
    pub(crate) vv: f64,
}

/// The maximum number of steps of a search in polynomials of a degree: a lower one up to `moderate`, a higher one above it.
pub(crate) fn max_search_steps(degree: usize, moderate: usize) -> usize {
    if degree > moderate {
        MAX_STEPS_ABOVE
    } else {
        MAX_STEPS
    }
}

impl PolynomialPiece {
    /// Whole polynomials over the unit square.
    pub(crate) fn whole(index: usize, columns: usize, rows: usize, planes: Vec<f64>) -> Self {
        Self {
            index,
            u: [0.0, 1.0],
            v: [0.0, 1.0],
            columns,
            rows,
            planes,
        }
    }

    /// The maximum number of steps of a search in polynomials: a lower one up to this degree, a higher one above it.
    pub(crate) fn max_search_steps(&self, degree: usize) -> usize {
        max_search_steps(self.columns.max(self.rows) - 1, degree)
    }

    /// Whether the range of u or of v contains a number between its ends.
    pub(crate) fn is_divisible(&self) -> bool {
        let [u, v] = self.middle();
        let inside = |[from, to]: [f64; 2], t: f64| from < t && t < to;
        inside(self.u, u) || inside(self.v, v)
    }

    /// The steps for examining and halving the piece, about one for each multiplication.
    pub(crate) fn steps(&self) -> usize {
        PIECE_STEPS + self.planes.len() * (self.columns.max(self.rows) + 8) / 2
    }

    /// The steps for one [`jet`](Self::jet).
    pub(crate) fn jet_steps(&self) -> usize {
        JET_STEPS + self.columns * self.rows * (self.columns.min(LONG_ROW) + 1)
    }

    /// The coefficients of one plane.
    pub(crate) fn plane(&self, k: usize) -> &[f64] {
        let count = self.columns * self.rows;
        &self.planes[k * count..(k + 1) * count]
    }

    /// The middle of the rectangle.
    pub(crate) fn middle(&self) -> [f64; 2] {
        [self.u, self.v].map(|[from, to]| 0.5 * (from + to))
    }

    /// The area of the rectangle.
    pub(crate) fn area(&self) -> f64 {
        (self.u[1] - self.u[0]) * (self.v[1] - self.v[0])
    }

    /// The smallest and the largest coefficient of a plane.
    pub(crate) fn range(&self, k: usize) -> [f64; 2] {
        let first = [f64::INFINITY, f64::NEG_INFINITY];
        let widen = |[low, high]: [f64; 2], &c: &f64| [low.min(c), high.max(c)];
        self.plane(k).iter().fold(first, widen)
    }

    /// The four corners: their parameters, and the value of a plane there.
    pub(crate) fn corners(&self, k: usize) -> [([f64; 2], f64); 4] {
        let (last, end) = (self.columns - 1, self.columns * self.rows - 1);
        let plane = self.plane(k);
        [
            ([self.u[0], self.v[0]], plane[0]),
            ([self.u[1], self.v[0]], plane[last]),
            ([self.u[0], self.v[1]], plane[end - last]),
            ([self.u[1], self.v[1]], plane[end]),
        ]
    }

    /// The coefficients of the derivative of a plane along u (or v), with this rectangle as the unit square.
    pub(crate) fn slopes(&self, k: usize, along_u: bool) -> impl Iterator<Item = f64> + '_ {
        let (columns, plane) = (self.columns, self.plane(k));
        let (step, length, degree) = if along_u {
            (1, columns, columns - 1)
        } else {
            (columns, plane.len(), self.rows - 1)
        };
        let factor = as_f64(degree);
        plane.chunks_exact(length).flat_map(move |part| {
            let pairs = part[..length - step].iter().zip(&part[step..]);
            pairs.map(move |(a, b)| (b - a) * factor)
        })
    }

    /// The ranges of the coefficients of the second derivatives uu, uv and vv of plane 0, with this rectangle as the
    /// unit square.
    pub(crate) fn second_derivatives(&self) -> [[f64; 2]; 3] {
        let bend = |du: usize, dv: usize| {
            let (m, n) = (self.columns - 1, self.rows - 1);
            let step = |first: bool| if first { 1 } else { self.columns };
            let (a, b) = (step(du > 0), step(du > 1));
            let factor = match du {
                0 => as_f64(n * n.saturating_sub(1)),
                1 => as_f64(m * n),
                _ => as_f64(m * m.saturating_sub(1)),
            };
            let mut range = [0.0; 2];
            let mut first = true;
            for row in 0..self.rows.saturating_sub(dv) {
                for i in row * self.columns..(row + 1) * self.columns - du.min(self.columns) {
                    let c = |at: usize| self.planes[at];
                    let value = (c(i + a + b) - c(i + a) - (c(i + b) - c(i))) * factor;
                    range = if first {
                        [value; 2]
                    } else {
                        [range[0].min(value), range[1].max(value)]
                    };
                    first = false;
                }
            }
            range
        };
        [bend(2, 0), bend(1, 1), bend(0, 2)]
    }

    /// The largest absolute slope of the first `planes` planes.
    fn steepest(&self, along_u: bool, planes: usize) -> f64 {
        (0..planes)
            .flat_map(|k| self.slopes(k, along_u))
            .fold(0.0, |max: f64, slope| max.max(slope.abs()))
    }

    /// The two halves, split in the direction in which the first `planes` planes change most.
    pub(crate) fn halves(mut self, planes: usize) -> [Self; 2] {
        let mut other = self.clone();
        let along_u = self.steepest(true, planes) >= self.steepest(false, planes);
        let area = self.columns * self.rows;
        let planes = self.planes.chunks_exact_mut(area);
        for (plane, half) in planes.zip(other.planes.chunks_exact_mut(area)) {
            halve_net(plane, half, self.columns, along_u);
        }
        let [u, v] = self.middle();
        if along_u {
            (self.u[1], other.u[0]) = (u, u);
        } else {
            (self.v[1], other.v[0]) = (v, v);
        }
        [self, other]
    }

    /// The value and derivatives of a plane at a point of this piece's unit square.
    pub(crate) fn jet(&self, k: usize, [u, v]: [f64; 2]) -> Jet {
        let mut columns = [[0.0; MAX_COUNT]; 3];
        let weights = BernsteinWeights::new(self.columns, u);
        for (j, row) in self.plane(k).chunks(self.columns).enumerate() {
            let [f, slope, bend] = match &weights {
                Some(weights) => weights.blend(row),
                None => taylor(row, u),
            };
            (columns[0][j], columns[1][j], columns[2][j]) = (f, slope, bend);
        }
        let [f, f_v, f_vv] = taylor(&columns[0][..self.rows], v);
        let [f_u, f_uv, _] = taylor(&columns[1][..self.rows], v);
        let [f_uu, ..] = taylor(&columns[2][..self.rows], v);
        Jet {
            f,
            u: f_u,
            v: f_v,
            uu: f_uu,
            uv: f_uv,
            vv: f_vv,
        }
    }

    /// The four edges of a whole piece, or the two ends of an edge; none for a corner.
    pub(crate) fn sides(&self) -> Vec<Self> {
        let side = |start: usize, step: usize, columns: usize, rows: usize, u, v| Self {
            index: self.index,
            u,
            v,
            columns,
            rows,
            planes: (0..self.planes.len() / (self.columns * self.rows))
                .flat_map(|k| {
                    self.plane(k)
                        .iter()
                        .skip(start)
                        .step_by(step)
                        .take(columns * rows)
                })
                .copied()
                .collect(),
        };
        let (m, n) = (self.columns - 1, self.rows - 1);
        let mut sides = Vec::new();
        let ([u0, u1], [v0, v1]) = (self.u, self.v);
        if m > 0 {
            sides.push(side(0, m + 1, 1, n + 1, [u0, u0], self.v));
            sides.push(side(m, m + 1, 1, n + 1, [u1, u1], self.v));
        }
        if n > 0 {
            sides.push(side(0, 1, m + 1, 1, self.u, [v0, v0]));
            sides.push(side(n * (m + 1), 1, m + 1, 1, self.u, [v1, v1]));
        }
        sides
    }
}

/// Passes pieces to `examine`, halves those for which it returns `true`, and repeats this until no piece is left.
///
/// Returns `false` when there are so many pieces that the solutions cannot be isolated points (for example a whole
/// curve), and when the work limit is reached.
pub(crate) fn search(
    mut pieces: Vec<PolynomialPiece>,
    max: usize,
    work: &mut WorkLimit,
    examine: &mut dyn FnMut(&PolynomialPiece, &mut WorkLimit) -> bool,
) -> bool {
    for _ in 0..MAX_ROUNDS {
        pieces.retain(|piece| work.spend(piece.steps()) && examine(piece, work));
        if work.is_exceeded() {
            return false;
        }
        let coefficients: usize = pieces.iter().map(|piece| piece.planes.len()).sum();
        if pieces.is_empty() {
            return true;
        }
        if pieces.len() > max || coefficients > MAX_COEFFICIENTS {
            return false;
        }
        pieces = pieces
            .into_iter()
            .flat_map(|piece| piece.halves(2))
            .collect();
    }
    true
}
