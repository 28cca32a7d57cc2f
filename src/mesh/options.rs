//! How fine must a mesh be?

use super::grid::Grid;
use super::weld::Weld;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use glam::{DMat4, DVec2, DVec3, DVec4};

/// How a surface becomes a mesh: how fine, and which vertices are joined.
///
/// ```
/// use casteljau::mesh::{TessellationOptions, Weld};
///
/// let fine = TessellationOptions::tolerance(1e-3).weld(Weld::Position);
/// assert_eq!(TessellationOptions::segments(8).weld, Weld::Normal); // the default
/// # assert_eq!(fine.weld, Weld::Position);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct TessellationOptions {
    /// How fine the mesh must be.
    pub detail: Detail,
    /// Which points become one vertex; by default those with the same normal.
    pub weld: Weld,
}

/// How fine a mesh must be.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Detail {
    /// This many segments along u and v of every patch.
    Segments(Grid),
    /// The largest distance from the surface to the mesh, in the surface's unit.
    Tolerance(f64),
    /// The largest distance on the screen, in pixels; what lies outside of the picture may be coarser.
    Pixels(View),
}

/// A tolerance as a camera sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct View {
    /// The greatest distance in pixels.
    pub pixels: f64,
    /// From the surface's coordinates to clip space: (x, y, z, 1) to (X, Y, Z, W), seen at (X/W, Y/W) in −1 … 1.
    pub view_projection: DMat4,
    /// Width and height of the picture in pixels.
    pub viewport: DVec2,
}

/// What is nearer to the eye than this part of its own distance from there is treated as if it were no nearer: a piece
/// that the eye looks out of would have to be infinitely fine.
const NEAR_RATIO: f64 = 1e-2;

impl TessellationOptions {
    /// This many segments along u and v of every patch: a [`Grid`], or one number for both.
    pub fn segments(grid: impl Into<Grid>) -> Self {
        Detail::Segments(grid.into()).into()
    }

    /// The largest distance from the surface to the mesh, in the surface's unit.
    pub fn tolerance(tolerance: f64) -> Self {
        Detail::Tolerance(tolerance).into()
    }

    /// The largest distance on the screen, in pixels.
    pub fn pixels(view: View) -> Self {
        Detail::Pixels(view).into()
    }

    /// The same with another rule for vertices.
    #[must_use]
    pub fn weld(self, weld: Weld) -> Self {
        Self { weld, ..self }
    }
}

impl From<Detail> for TessellationOptions {
    fn from(detail: Detail) -> Self {
        Self {
            detail,
            weld: Weld::default(),
        }
    }
}

impl Detail {
    /// Whether [`tolerance_for`](Self::tolerance_for) looks at the piece.
    pub(crate) fn depends_on_position(&self) -> bool {
        matches!(self, Self::Pixels(_))
    }

    /// The tolerance for a piece whose control points lie in a box.
    pub(crate) fn tolerance_for(&self, control_box: impl Fn() -> [DVec3; 2]) -> f64 {
        match self {
            Self::Segments(_) => f64::INFINITY,
            Self::Tolerance(tolerance) => *tolerance,
            Self::Pixels(view) => view.tolerance_for(control_box()),
        }
    }
}

impl View {
    /// Refuses what is no view.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let positive = |what, got: f64| {
            if got > 0.0 && got.is_finite() {
                return Ok(());
            }
            Err(Error::Range {
                what,
                expected: "a number above 0",
                got,
            })
        };
        positive("pixels", self.pixels)?;
        positive("viewport[0]", self.viewport.x)?;
        positive("viewport[1]", self.viewport.y)?;
        Error::unless_finite("view_projection", &self.view_projection.to_cols_array())
    }

    /// The distance in space that is seen as at most `pixels` everywhere in the piece: by the derivative of the
    /// projection at the piece's middle, at the least W in the sphere around its box. Infinite outside of the picture.
    fn tolerance_for(&self, [low, high]: [DVec3; 2]) -> f64 {
        let [x, y, w] = [0, 1, 3].map(|row| self.view_projection.row(row));
        let middle = low * 0.5 + high * 0.5;
        let radius = Point::length(high - middle);
        // Outside of one of these half-spaces nothing is seen, neither of the piece nor of triangles between its points.
        let unseen = |plane: DVec4| {
            plane.dot(middle.extend(1.0)) + radius * Point::length(plane.truncate()) <= 0.0
        };
        if [w, w + x, w - x, w + y, w - y].into_iter().any(unseen) {
            return f64::INFINITY;
        }
        let depth = w.dot(middle.extend(1.0));
        let reach = radius * Point::length(w.truncate());
        let near = (depth - reach).max((depth + reach) * NEAR_RATIO);
        let slope = |row: DVec4, half: f64| {
            // ∂(X/W) = (∂X − X/W·∂W)/W; what is outside of the picture counts as on its rim.
            let projected = row.dot(middle.extend(1.0)) / depth.max(near);
            (row - w * projected.clamp(-1.0, 1.0)).truncate() * (half / near)
        };
        let stretch = longest(
            slope(x, self.viewport.x / 2.0),
            slope(y, self.viewport.y / 2.0),
        );
        let tolerance = self.pixels / stretch;
        // Not a number where the matrix's own numbers overflow: nothing can be seen then.
        if tolerance.is_nan() {
            f64::INFINITY
        } else {
            tolerance
        }
    }
}

/// The length of the longest image of a unit vector under the map with these two rows: its spectral norm.
fn longest(x: DVec3, y: DVec3) -> f64 {
    let (a, b, c) = (x.dot(x), x.dot(y), y.dot(y));
    (f64::midpoint(a, c) + ((a - c) / 2.0).hypot(b)).sqrt()
}
