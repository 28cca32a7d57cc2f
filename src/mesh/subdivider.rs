//! Into which pieces must a patch be cut so that flat triangles are close enough?
//!
//! A piece of degrees m × n over its own unit square is within (M₁ + 2M₂ + M₃) / 8 of every linear interpolant whose
//! corners lie in the square, with bounds on the second derivatives M₁ = m(m − 1) max |Δuu|, M₂ = mn max |ΔuΔv| and
//! M₃ = n(n − 1) max |Δvv| (Filip, Magedson and Markot, "Surface algorithms using bounds on derivatives", CAGD 3, 1986).
//! So the bound holds for the triangles that join pieces of different sizes, too. A piece that is too large is halved
//! along the direction that bends more; if the maxima over the two halves show that it was not too large, it stays whole.
//! Cuts are at halves of halves: their parameters are exact.

use super::buffers::to_f32;
use super::options::Detail;
use crate::geometry::check::max_abs;
use crate::geometry::error::Error;
use crate::numeric::list::Net;
use crate::patch::net::{differences_u, differences_v};
use casteljau_kernels::{BEND_SLACK, Cell, SecondDifferences};
use glam::DVec3;

/// Parameters are whole numbers from 0 to this: pieces can be halved 30 times each way.
pub(crate) const DYADIC: u32 = 1 << 30;

/// After how many halvings pieces tell how many they will become: at first as they are, and only if that is too many
/// from closer.
pub(crate) const FORECAST_DEPTHS: [u32; 2] = [0, 8];

/// After how many halvings pieces tell how many they will become when each is halved again and again, if that may be too
/// many; when closer pieces tell nearly the same, it is.
pub(crate) const CLOSE_FORECAST_DEPTHS: [u32; 2] = [12, 14];

/// The most vectors of all pieces, in halving all patches: for bicubic ones, more than the largest mesh needs.
const MAX_VECTORS: usize = 1 << 31;

/// A piece that may be too large: how much it bends along u, along both and along v, per unit of the patch's parameters.
#[derive(Clone, Copy, Debug)]
struct Piece {
    cell: Cell,
    /// The cell's part of the patch's parameters, along u and v.
    lengths: [f64; 2],
    depth: u32,
    bend: [f64; 3],
}

/// Cuts patches into cells.
pub(crate) struct AdaptiveSubdivider<'a> {
    pub(crate) detail: &'a Detail,
    /// The least tolerance that the mesh's numbers can keep, and the part of it that rounding takes.
    pub(crate) min: f64,
    pub(crate) rounding: f64,
    /// The greatest number of cells in all.
    pub(crate) limit: usize,
    /// While cells are only counted: after how many halvings, and how many are to be expected so far.
    pub(crate) forecast: Option<u32>,
    pub(crate) expected: f64,
    /// … and how many if each piece is halved as if it bent everywhere as it does most: no fewer than there will be.
    pub(crate) expected_max: f64,
    pub(crate) cells: Vec<Cell>,
    /// The vectors of the pieces that wait, in units of `size`.
    pub(crate) second_differences: SecondDifferences,
    pub(crate) size: f64,
}

impl AdaptiveSubdivider<'_> {
    /// Appends the cells of one patch.
    ///
    /// # Errors
    /// [`Error::TooMany`] above the limit.
    pub(crate) fn cut(&mut self, net: &[DVec3], columns: usize) -> Result<(), Error> {
        self.start(net, columns);
        let mut pieces = vec![Piece {
            cell: Cell {
                u: 0,
                v: 0,
                du: DYADIC,
                dv: DYADIC,
            },
            lengths: [1.0; 2],
            depth: 0,
            bend: self.bend(0),
        }];
        let closed = closed(net, columns);
        let mut tolerance = self.tolerance();
        while let Some(piece) = pieces.pop() {
            if self.detail.depends_on_position() {
                tolerance = self.tolerance();
            }
            let distance = bound(piece.lengths, piece.bend);
            if self.forecast == Some(piece.depth) {
                self.expected += piece.min_cells(tolerance);
                self.expected_max += piece.halved_cells(tolerance);
                self.second_differences.pop();
                continue;
            }
            if self.cells.len() >= self.limit {
                return Err(self.too_many());
            }
            let must = piece.cell_closes(closed);
            let along_u = if distance > tolerance {
                piece.longer_along_u()
            } else {
                must
            };
            let Some(along_u) = along_u else {
                self.add(piece.cell);
                self.second_differences.pop();
                continue;
            };
            self.second_differences.halve(along_u);
            let second_differences = [self.bend(1), self.bend(0)];
            let closer =
                [0, 1, 2].map(|k| larger(second_differences[0][k], second_differences[1][k]));
            if must.is_none() && bound(piece.lengths, closer) <= tolerance {
                self.add(piece.cell);
                self.second_differences.pop();
                self.second_differences.pop();
            } else {
                pieces.extend(piece.halves(along_u, second_differences));
            }
        }
        Ok(())
    }

    /// Puts the second derivatives of a patch on the empty stack, as Bézier nets.
    fn start(&mut self, net: &[DVec3], columns: usize) {
        self.size = max_abs(net).max(f64::MIN_POSITIVE);
        let (m, n) = (columns - 1, net.len() / columns - 1);
        let (a, b) = (m as f64, n as f64);
        let net: Vec<DVec3> = net.iter().map(|&p| p / self.size).collect();
        let (du, dv) = (differences_u(&net, columns), differences_v(&net, columns));
        // A direction of degree 1 has no second difference: the empty net.
        let uu = if m > 1 {
            differences_u(&du, m)
        } else {
            Net::new()
        };
        let vv = if n > 1 {
            differences_v(&dv, columns)
        } else {
            Net::new()
        };
        let uv = differences_v(&du, m);
        let position = if self.detail.depends_on_position() {
            &net[..]
        } else {
            &[]
        };
        let sizes = [
            (m - 1, n + 1),
            (m, n),
            (m + 1, n - 1),
            (columns, position.len() / columns),
        ];
        let nets = [
            (&uu[..], a * (a - 1.0)),
            (&uv, a * b),
            (&vv, b * (b - 1.0)),
            (position, 1.0),
        ];
        let vectors = nets.into_iter().flat_map(|(net, factor)| {
            net.iter()
                .map(move |&p| (p * factor).to_array().map(to_f32))
        });
        self.second_differences.start(sizes, vectors);
    }

    /// How much the last piece but `before` bends.
    fn bend(&self, before: usize) -> [f64; 3] {
        let scale = self.size * (1.0 + BEND_SLACK);
        self.second_differences
            .longest(before)
            .map(|length| f64::from(length) * scale)
    }

    /// The tolerance for the last piece.
    fn tolerance(&self) -> f64 {
        let wanted = self.detail.tolerance_for(|| {
            self.second_differences
                .control_box()
                .map(|corner| DVec3::from(corner.map(f64::from)) * self.size)
        });
        wanted.max(self.min) - self.rounding
    }

    fn add(&mut self, cell: Cell) {
        if self.forecast.is_some() {
            self.expected += 1.0;
            self.expected_max += 1.0;
        } else {
            self.cells.push(cell);
        }
    }

    /// Two triangles a cell.
    pub(crate) fn too_many(&self) -> Error {
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is for people to read"
        )]
        let expected = self.expected as usize;
        Error::TooMany {
            what: "triangles",
            limit: 2 * self.limit,
            needed: expected.max(self.limit + 1).saturating_mul(2),
        }
    }
}

impl Piece {
    /// Whether to cut along u, the direction that bends more; where both bend alike, that which was cut less. None when
    /// the parameters can be halved no more.
    fn longer_along_u(&self) -> Option<bool> {
        let Cell { du, dv, .. } = self.cell;
        let [h, k] = self.lengths;
        let (along_u, along_v) = (h * h * self.bend[0], k * k * self.bend[2]);
        let better = along_u > along_v || (along_u == along_v && du >= dv);
        match (du > 1, dv > 1) {
            (true, true) => Some(better),
            (false, false) => None,
            (only_u, _) => Some(only_u),
        }
    }

    /// How many cells it needs at least, if it bends alike everywhere: with i × j equal cells a/i² + b/(i·j) + c/j² must
    /// be within the tolerance, so i·j is no less than any of these.
    fn min_cells(&self, tolerance: f64) -> f64 {
        let [h, k] = self.lengths;
        let [uu, uv, vv] = self.bend;
        let (a, b, c) = (h * h * uu / 8.0, h * k * uv / 4.0, k * k * vv / 8.0);
        let both = (2.0 * a.sqrt() * c.sqrt() + b) / tolerance;
        both.max((a.max(c) / tolerance).sqrt()).max(1.0)
    }

    /// How many cells it becomes when it is halved until these are within the tolerance, if it bends alike everywhere.
    fn halved_cells(mut self, tolerance: f64) -> f64 {
        let mut cells = 1.0;
        while bound(self.lengths, self.bend) > tolerance {
            let Some(along_u) = self.longer_along_u() else {
                break;
            };
            [self, _] = self.halves(along_u, [self.bend; 2]);
            cells *= 2.0;
        }
        cells
    }

    /// Along which of the closed directions, if any, it still goes all the way round.
    fn cell_closes(&self, [along_u, along_v]: [bool; 2]) -> Option<bool> {
        match (
            along_u && self.cell.du == DYADIC,
            along_v && self.cell.dv == DYADIC,
        ) {
            (false, false) => None,
            (only_u, _) => Some(only_u),
        }
    }

    fn halves(&self, along_u: bool, second_differences: [[f64; 3]; 2]) -> [Self; 2] {
        let (mut near, [mut h, mut k]) = (self.cell, self.lengths);
        let mut far;
        if along_u {
            near.du /= 2;
            h /= 2.0;
            far = near;
            far.u += near.du;
        } else {
            near.dv /= 2;
            k /= 2.0;
            far = near;
            far.v += near.dv;
        }
        let (cells, lengths) = ([near, far], [h, k]);
        [0, 1].map(|k| Self {
            cell: cells[k],
            lengths,
            depth: self.depth + 1,
            bend: second_differences[k],
        })
    }
}

/// The most cells whose pieces together have no more vectors than [`MAX_VECTORS`]: there are about twice as many pieces as
/// cells.
pub(crate) fn cell_limit(degree_u: usize, degree_v: usize) -> usize {
    let (m, n) = (degree_u, degree_v);
    MAX_VECTORS / (2 * ((m - 1) * (n + 1) + m * n + (m + 1) * (n - 1)))
}

/// Whether a patch begins and ends at one place along u, and along v. However thin such a tube is, a single piece of it
/// would have triangles without a third corner, and nothing would stand for it.
fn closed(net: &[DVec3], columns: usize) -> [bool; 2] {
    let (last, end) = (net.len() - columns, net.len());
    let ring = |from: usize, to: usize, step: usize| {
        let mut inside = (from..to).step_by(step);
        net[from] == net[to] && inside.any(|k| net[k] != net[from])
    };
    [
        ring(0, columns - 1, 1) || ring(last, end - 1, 1),
        ring(0, last, columns) || ring(columns - 1, end - 1, columns),
    ]
}

/// The greatest distance of flat triangles over a cell with these lengths.
fn bound([h, k]: [f64; 2], [uu, uv, vv]: [f64; 3]) -> f64 {
    (h * h * uu + 2.0 * h * k * uv + k * k * vv) / 8.0
}

/// Not `max`, which would be a call.
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
