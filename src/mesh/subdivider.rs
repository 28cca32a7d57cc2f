//! Adaptive subdivision of patches into cells, by a bound on the distance of flat triangles.
//!
//! A piece of degrees m × n over its own unit square is within (M₁ + 2M₂ + M₃) / 8 of every linear interpolant whose
//! corners lie in the square, with the bounds on the second derivatives M₁ = m(m − 1) max |Δuu|, M₂ = mn max |ΔuΔv| and
//! M₃ = n(n − 1) max |Δvv| (Filip, Magedson and Markot, "Surface algorithms using bounds on derivatives", CAGD 3,
//! 1986). So the bound also holds for the triangles that join pieces of different sizes. A piece that is too large is
//! halved in the direction with the larger second derivative; a rational piece whose weights differ much, in the
//! direction in which they differ more. If the maxima over the two halves show that the piece was not too large, it is
//! not split. The halves of a rational piece whose bounds suffice for them are not examined. All cuts are at dyadic
//! parameters, which are exact.

use super::mesh_patch::{Bends, Frame, MeshPatch};
use super::options::Detail;
use crate::geometry::error::Error;
use casteljau_kernels::mesh::cell_triangulator::Cell;
use casteljau_kernels::mesh::second_differences::SecondDifferences;
use glam::DVec3;

/// Parameters are integers from 0 to this: pieces can be halved 30 times in each direction.
pub(crate) const DYADIC: u32 = 1 << 30;

/// The depths (numbers of halvings) at which the number of cells is forecast: first without halving, and at the second
/// depth only if the first forecast is too large.
pub(crate) const FORECAST_DEPTHS: [u32; 2] = [0, 8];

/// The depths at which the number of cells is forecast by repeated halving, if there may be too many cells. If a deeper
/// forecast gives nearly the same number, it is accepted.
pub(crate) const CLOSE_FORECAST_DEPTHS: [u32; 2] = [12, 14];

/// The maximum number of vectors of all pieces when all patches are subdivided; for bicubic patches this is more than
/// the largest mesh needs.
const MAX_VECTORS: usize = 1 << 31;

/// A piece that may be too large, with bounds on its second derivatives.
#[derive(Clone, Copy, Debug)]
struct PatchPiece<B> {
    cell: Cell,
    /// The cell's size in the patch's parameters, along u and v.
    lengths: [f64; 2],
    depth: u32,
    bends: B,
}

/// Subdivides patches into cells.
pub(crate) struct AdaptiveSubdivider<'a> {
    pub(crate) detail: &'a Detail,
    /// The smallest tolerance for the mesh's number type (`min`), and the part of a tolerance that rounding takes.
    pub(crate) min: f64,
    pub(crate) rounding: f64,
    /// The maximum total number of cells.
    pub(crate) limit: usize,
    /// While cells are only counted: the depth at which they are forecast, and the expected number of cells so far.
    pub(crate) forecast: Option<u32>,
    pub(crate) expected: f64,
    /// The expected number of cells if each piece is halved as if its second derivatives had their maxima everywhere:
    /// an upper bound.
    pub(crate) expected_max: f64,
    pub(crate) cells: Vec<Cell>,
    /// The vectors of the pieces on the stack, in coordinates of the frame.
    pub(crate) second_differences: SecondDifferences,
    pub(crate) frame: Frame,
}

impl AdaptiveSubdivider<'_> {
    /// Appends the cells of one patch.
    ///
    /// # Errors
    /// [`Error::TooMany`] above the limit.
    pub(crate) fn cut<P: MeshPatch>(&mut self, patch: &P) -> Result<(), Error> {
        let has_position = self.detail.depends_on_position();
        self.frame = patch.start(has_position, &mut self.second_differences);
        // Depth first. `second_differences` is a stack, too: its top belongs to the piece on top of `pieces`.
        let mut pieces: Vec<PatchPiece<P::Bends>> = vec![PatchPiece {
            cell: Cell {
                u: 0,
                v: 0,
                du: DYADIC,
                dv: DYADIC,
            },
            lengths: [1.0; 2],
            depth: 0,
            bends: P::Bends::of_patch(&mut self.second_differences, &self.frame),
        }];
        let net = patch.net();
        let closed_directions = closed_directions(&net.points, net.columns);
        let mut tolerance = self.tolerance(&pieces[0].bends);
        while let Some(piece) = pieces.pop() {
            if has_position {
                tolerance = self.tolerance(&piece.bends);
            }
            let stack = &mut self.second_differences;
            let distance = piece.bends.distance(stack, piece.lengths);
            // A forecast counts the cells that the piece may need, without cutting it further.
            if self.forecast == Some(piece.depth) {
                self.expected += piece.min_cells(stack, tolerance);
                self.expected_max += piece.halved_cells(stack, tolerance);
                stack.pop();
                continue;
            }
            if self.cells.len() >= self.limit {
                return Err(self.too_many());
            }
            // Around a tube the piece is cut even if its triangles would be near enough.
            let closed_direction = piece.closed_direction(closed_directions);
            let along_u = if distance > tolerance {
                piece.cut_along_u(stack)
            } else {
                closed_direction
            };
            let Some(along_u) = along_u else {
                stack.pop();
                self.add(piece.cell);
                continue;
            };
            let lengths = piece.half_lengths(along_u);
            // Where the bounds for the piece suffice for its halves, these need none of their own.
            if P::Bends::SUFFICE_FOR_HALVES
                && !has_position
                && closed_direction.is_none()
                && piece.bends.distance(stack, lengths) <= tolerance
                && self.cells.len() + 1 < self.limit
            {
                stack.pop();
                let [near, far] = piece.half_cells(along_u);
                self.add(far);
                self.add(near);
                continue;
            }
            stack.halve(along_u);
            // The larger of the bounds on both halves is a tighter bound for the piece, which may then need no cut.
            let halves = piece.bends.of_halves(stack, &self.frame);
            if closed_direction.is_none()
                && P::Bends::joined_distance(&halves, stack, piece.lengths) <= tolerance
            {
                // Those of both halves.
                stack.pop();
                stack.pop();
                self.add(piece.cell);
            } else {
                for (cell, bends) in piece.half_cells(along_u).into_iter().zip(halves) {
                    pieces.push(PatchPiece {
                        cell,
                        lengths,
                        depth: piece.depth + 1,
                        bends,
                    });
                }
            }
        }
        Ok(())
    }

    /// A subdivider for other patches with the same settings.
    #[cfg(feature = "rayon")]
    pub(crate) fn without_cells(&self) -> Self {
        Self {
            cells: Vec::new(),
            second_differences: SecondDifferences::default(),
            ..*self
        }
    }

    /// The tolerance for the piece on top of the stack.
    fn tolerance<B: Bends>(&self, bends: &B) -> f64 {
        let Frame { origin, size } = self.frame;
        let wanted = self.detail.tolerance_for(|| {
            bends
                .control_box(&self.second_differences)
                .map(|corner| DVec3::from(corner.map(f64::from)) * size + origin)
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

    /// The error with two triangles for each cell.
    pub(crate) fn too_many(&self) -> Error {
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the cast saturates, and the number is only shown to people"
        )]
        let expected = self.expected as usize;
        Error::too_many(
            "triangles",
            2 * self.limit,
            expected.max(self.limit + 1).saturating_mul(2),
        )
    }
}

impl<B: Bends> PatchPiece<B> {
    /// Whether to cut along u: where the weights decide, otherwise as [`longer_along_u`](Self::longer_along_u).
    fn cut_along_u(&self, stack: &SecondDifferences) -> Option<bool> {
        let Cell { du, dv, .. } = self.cell;
        B::cut_by_weights(stack)
            .filter(|&along_u| (if along_u { du } else { dv }) > 1)
            .or_else(|| self.longer_along_u(stack))
    }

    /// Whether to cut along u: the direction with the larger second derivative, or the direction that was cut less if
    /// both are equal. `None` if the parameters cannot be halved again.
    fn longer_along_u(&self, stack: &SecondDifferences) -> Option<bool> {
        let Cell { du, dv, .. } = self.cell;
        let [h, k] = self.lengths;
        let [uu, _, vv] = self.bends.lengths(stack);
        let (along_u, along_v) = (h * h * uu, k * k * vv);
        let better = along_u > along_v || (along_u == along_v && du >= dv);
        match (du > 1, dv > 1) {
            (true, true) => Some(better),
            (false, false) => None,
            (only_u, _) => Some(only_u),
        }
    }

    /// A lower bound on the number of cells if the second derivatives are constant: with i × j equal cells,
    /// a/i² + b/(i·j) + c/j² must be within the tolerance, so i·j is at least each of the resulting lower bounds.
    fn min_cells(&self, stack: &SecondDifferences, tolerance: f64) -> f64 {
        let [h, k] = self.lengths;
        let [uu, uv, vv] = self.bends.lengths(stack);
        let tolerance = tolerance * B::MAX_EXCESS;
        let (a, b, c) = (h * h * uu / 8.0, h * k * uv / 4.0, k * k * vv / 8.0);
        // a/i² + c/j² ≥ 2√(ac)/(i·j), the arithmetic and the geometric mean; and i·j ≥ i ≥ √(a/tolerance).
        let both = (2.0 * a.sqrt() * c.sqrt() + b) / tolerance;
        both.max((a.max(c) / tolerance).sqrt()).max(1.0)
    }

    /// The number of cells from repeated halving until they are within the tolerance, if the second derivatives are
    /// constant.
    fn halved_cells(mut self, stack: &SecondDifferences, tolerance: f64) -> f64 {
        let mut cells = 1.0;
        while self.bends.distance(stack, self.lengths) > tolerance {
            let Some(along_u) = self.longer_along_u(stack) else {
                break;
            };
            self.lengths = self.half_lengths(along_u);
            [self.cell, _] = self.half_cells(along_u);
            cells *= 2.0;
        }
        cells
    }

    /// The closed direction, if any, in which the piece still covers the full range of the parameter.
    fn closed_direction(&self, [along_u, along_v]: [bool; 2]) -> Option<bool> {
        match (
            along_u && self.cell.du == DYADIC,
            along_v && self.cell.dv == DYADIC,
        ) {
            (false, false) => None,
            (only_u, _) => Some(only_u),
        }
    }

    fn half_lengths(&self, along_u: bool) -> [f64; 2] {
        let [h, k] = self.lengths;
        if along_u { [h / 2.0, k] } else { [h, k / 2.0] }
    }

    fn half_cells(&self, along_u: bool) -> [Cell; 2] {
        let mut near = self.cell;
        let mut far;
        if along_u {
            near.du /= 2;
            far = near;
            far.u += near.du;
        } else {
            near.dv /= 2;
            far = near;
            far.v += near.dv;
        }
        [near, far]
    }
}

/// The maximum number of cells whose pieces together have at most [`MAX_VECTORS`] vectors: there are about twice as
/// many pieces as cells.
pub(crate) fn cell_limit(degree_u: usize, degree_v: usize) -> usize {
    let (m, n) = (degree_u, degree_v);
    MAX_VECTORS / (2 * ((m - 1) * (n + 1) + m * n + (m + 1) * (n - 1)))
}

/// Whether a patch is closed (starts and ends at the same point) along u, and along v. A single piece of such a tube,
/// however thin, would have only triangles with two coincident corners, and nothing would represent it.
fn closed_directions(net: &[DVec3], columns: usize) -> [bool; 2] {
    let (last, end) = (net.len() - columns, net.len());
    // A boundary whose control points all coincide is a pole, not a ring.
    let ring = |from: usize, to: usize, step: usize| {
        let mut inside = (from..to).step_by(step);
        net[from] == net[to] && inside.any(|k| net[k] != net[from])
    };
    [
        ring(0, columns - 1, 1) || ring(last, end - 1, 1),
        ring(0, last, columns) || ring(columns - 1, end - 1, columns),
    ]
}
