//! Into which pieces must a patch be cut so that flat triangles are close enough?
//!
//! A piece of degrees m × n over its own unit square is within (M₁ + 2M₂ + M₃) / 8 of every linear interpolant whose
//! corners lie in the square, with bounds on the second derivatives M₁ = m(m − 1) max |Δuu|, M₂ = mn max |ΔuΔv| and
//! M₃ = n(n − 1) max |Δvv| (Filip, Magedson and Markot, "Surface algorithms using bounds on derivatives", CAGD 3, 1986).
//! So the bound holds for the triangles that join pieces of different sizes, too. A piece that is too large is halved
//! along the direction that bends more. Cuts are at halves of halves: their parameters are exact.

use super::view::Fineness;
use crate::error::Error;
use crate::point::Point;
use glam::DVec3;

/// Parameters are whole numbers from 0 to this: pieces can be halved 30 times each way.
pub(super) const DYADIC: u32 = 1 << 30;

/// After so many halvings a piece's own bound tells about how many pieces it will need.
const FORECAST_DEPTH: u32 = 8;

/// How much more than the limit the forecast must be, since the bound is one.
const FORECAST_SLACK: f64 = 4.0;

/// Up to here above the tolerance it is worth to look closer before cutting: for bicubic pieces the maxima over halves
/// are seldom smaller by more.
const WORTH_A_LOOK: f64 = 2.0;

/// A rectangle of parameters: from (`u`, `v`) on, `du` × `dv` large.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Leaf {
    pub(super) u: u32,
    pub(super) v: u32,
    pub(super) du: u32,
    pub(super) dv: u32,
}

/// Control points (or vector coefficients) in rows, which halves along either direction.
#[derive(Clone, Debug, Default)]
struct Rows {
    points: Vec<DVec3>,
    columns: usize,
}

/// What is known of one piece: second differences, and its own control points where the tolerance depends on the place.
#[derive(Clone, Debug)]
struct Piece {
    uu: Rows,
    uv: Rows,
    vv: Rows,
    net: Rows,
    leaf: Leaf,
    depth: u32,
}

/// Cuts patches into leaves.
pub(super) struct Cutter<'a> {
    pub(super) fineness: &'a Fineness,
    /// The least tolerance that the mesh's numbers can keep, and the part of it that rounding takes.
    pub(super) least: f64,
    pub(super) rounding: f64,
    /// The greatest number of leaves in all.
    pub(super) limit: usize,
    /// How many leaves are to be expected in all, as far as pieces have come.
    pub(super) expected: f64,
    pub(super) leaves: Vec<Leaf>,
}

impl Cutter<'_> {
    /// Appends the leaves of one patch.
    ///
    /// # Errors
    /// [`Error::TooMany`] above the limit.
    pub(super) fn cut(&mut self, net: &[DVec3], columns: usize) -> Result<(), Error> {
        let mut pending = vec![Piece::new(net, columns, self.fineness.depends_on_place())];
        while let Some(piece) = pending.pop() {
            let wanted = self.fineness.tolerance_for(&piece.net.points);
            let tolerance = wanted.max(self.least) - self.rounding;
            let bound = piece.bound();
            if piece.depth == FORECAST_DEPTH {
                self.expected += bound / tolerance;
            }
            let limit = self.limit as f64;
            if self.leaves.len() >= self.limit || self.expected > FORECAST_SLACK * limit {
                return Err(self.too_many());
            }
            let fits = bound <= tolerance
                || (bound <= WORTH_A_LOOK * tolerance && piece.closer_bound() <= tolerance);
            match piece.direction() {
                Some(along_u) if !fits => pending.extend(piece.halves(along_u)),
                _ => self.leaves.push(piece.leaf),
            }
        }
        Ok(())
    }

    /// Two triangles a leaf.
    fn too_many(&self) -> Error {
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is for people to read"
        )]
        let expected = self.expected as usize;
        Error::TooMany {
            what: "triangles",
            limit: 2 * self.limit,
            needed: expected.max(self.leaves.len() + 1).saturating_mul(2),
        }
    }
}

impl Piece {
    /// The whole patch.
    fn new(net: &[DVec3], columns: usize, with_net: bool) -> Self {
        let net = Rows {
            points: net.to_vec(),
            columns,
        };
        let (m, n) = (columns as f64 - 1.0, net.rows() as f64 - 1.0);
        let (du, dv) = (net.differences_u(), net.differences_v());
        Self {
            uu: du.differences_u().scaled(m * (m - 1.0)),
            uv: du.differences_v().scaled(m * n),
            vv: dv.differences_v().scaled(n * (n - 1.0)),
            net: if with_net { net } else { Rows::default() },
            leaf: Leaf {
                u: 0,
                v: 0,
                du: DYADIC,
                dv: DYADIC,
            },
            depth: 0,
        }
    }

    /// A bound on the distance of flat triangles.
    fn bound(&self) -> f64 {
        (self.uu.largest() + 2.0 * self.uv.largest() + self.vv.largest()) / 8.0
    }

    /// The same from the maxima over the four quarters, which is less.
    fn closer_bound(&self) -> f64 {
        let quarters = |rows: &Rows| {
            let (a, b) = rows.halves(true);
            let both = [a.halves(false), b.halves(false)];
            both.map(|(c, d)| c.largest().max(d.largest()))
        };
        // The greatest of the four sums, each quarter with its own maxima, would be less still, by a per cent or two.
        let largest = |rows: &Rows| quarters(rows).into_iter().fold(0.0, f64::max);
        (largest(&self.uu) + 2.0 * largest(&self.uv) + largest(&self.vv)) / 8.0
    }

    /// Whether to cut along u, the direction that bends more; where both bend alike, that which was cut less. None when
    /// the parameters can be halved no more.
    fn direction(&self) -> Option<bool> {
        let (along_u, along_v) = (self.uu.largest(), self.vv.largest());
        let Leaf { du, dv, .. } = self.leaf;
        let better = along_u > along_v || (along_u == along_v && du >= dv);
        match (du > 1, dv > 1) {
            (true, true) => Some(better),
            (false, false) => None,
            (only_u, _) => Some(only_u),
        }
    }

    fn halves(&self, along_u: bool) -> [Self; 2] {
        let (near, far) = self.leaf.halves(along_u);
        // Differences in the half's own parameter: a half for each along the cut.
        let (uu, uv, vv) = if along_u {
            (0.25, 0.5, 1.0)
        } else {
            (1.0, 0.5, 0.25)
        };
        let [uu, uv, vv, net] = [
            (&self.uu, uu),
            (&self.uv, uv),
            (&self.vv, vv),
            (&self.net, 1.0),
        ]
        .map(|(rows, factor)| {
            let (near, far) = rows.halves(along_u);
            (near.scaled(factor), far.scaled(factor))
        });
        let depth = self.depth + 1;
        [
            Self {
                uu: uu.0,
                uv: uv.0,
                vv: vv.0,
                net: net.0,
                leaf: near,
                depth,
            },
            Self {
                uu: uu.1,
                uv: uv.1,
                vv: vv.1,
                net: net.1,
                leaf: far,
                depth,
            },
        ]
    }
}

impl Leaf {
    fn halves(&self, along_u: bool) -> (Self, Self) {
        let Self { u, v, du, dv } = *self;
        if along_u {
            let du = du / 2;
            (
                Self { u, v, du, dv },
                Self {
                    u: u + du,
                    v,
                    du,
                    dv,
                },
            )
        } else {
            let dv = dv / 2;
            (
                Self { u, v, du, dv },
                Self {
                    u,
                    v: v + dv,
                    du,
                    dv,
                },
            )
        }
    }
}

impl Rows {
    fn rows(&self) -> usize {
        self.points.len() / self.columns.max(1)
    }

    /// The differences of neighbours in each row.
    fn differences_u(&self) -> Self {
        let rows = self.points.chunks(self.columns.max(1));
        Self {
            points: rows
                .flat_map(|row| row.windows(2).map(|pair| pair[1] - pair[0]))
                .collect(),
            columns: self.columns.saturating_sub(1),
        }
    }

    /// The differences of neighbouring rows.
    fn differences_v(&self) -> Self {
        let above = self.points.iter().skip(self.columns);
        Self {
            points: above.zip(&self.points).map(|(&b, &a)| b - a).collect(),
            columns: self.columns,
        }
    }

    fn scaled(mut self, factor: f64) -> Self {
        for point in &mut self.points {
            *point *= factor;
        }
        self
    }

    /// The length of the longest vector.
    fn largest(&self) -> f64 {
        self.points.iter().fold(0.0, |most, p| most.max(p.norm()))
    }

    /// The coefficients of the two halves along u or v, by de Casteljau's algorithm at ½.
    fn halves(&self, along_u: bool) -> (Self, Self) {
        let (mut near, mut far) = (self.clone(), self.clone());
        let (columns, rows) = (self.columns, self.rows());
        let (lines, step, length, stride) = if along_u {
            (rows, columns, columns, 1)
        } else {
            (columns, 1, rows, columns)
        };
        for line in 0..lines {
            let (near, far) = (
                &mut near.points[line * step..],
                &mut far.points[line * step..],
            );
            for level in 0..length {
                near[level * stride] = far[0];
                for i in 1..length - level {
                    far[(i - 1) * stride] = (far[(i - 1) * stride] + far[i * stride]) * 0.5;
                }
            }
        }
        (near, far)
    }
}
