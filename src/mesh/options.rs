//! Options of the tessellation: level of detail and welding.

use super::grid::Grid;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use glam::{DMat4, DVec2, DVec3, DVec4};

/// Options of [`Surface::tessellate`](crate::Surface::tessellate): the level of detail, and which vertices are joined.
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
#[non_exhaustive]
pub struct TessellationOptions {
    /// The level of detail of the mesh.
    pub detail: Detail,
    /// Which corners become one vertex; by default those with the same normal.
    #[cfg_attr(feature = "serde", serde(default))]
    pub weld: Weld,
}

/// Which corners become one vertex of a mesh. Positions are bit-identical for all three rules.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Weld {
    /// One vertex for each point. Where patches meet in a crease, its normal is the mean of their normals, each
    /// weighted by the angles of its triangles at the point.
    Position,
    /// One vertex for each point and normal: patches share a vertex unless their normals differ by more than 0.1°.
    #[default]
    Normal,
    /// Each patch has its own vertices, so that `uvs` and `patch_ids` are available.
    None,
}

/// The level of detail of a mesh.
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
    /// The largest distance on the screen, in pixels; parts outside the viewport may be coarser.
    Pixels(View),
}

/// A tolerance in pixels for a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct View {
    /// The largest distance in pixels.
    pub pixels: f64,
    /// Maps the surface's coordinates to clip space: (x, y, z, 1) to (X, Y, Z, W), projected to (X/W, Y/W) in −1 … 1.
    pub view_projection: DMat4,
    /// Width and height of the viewport in pixels.
    pub viewport: DVec2,
}

/// The smallest depth of a piece, as a fraction of its largest depth. Without this limit, a piece that contains the eye
/// would have to be infinitely fine.
const NEAR_RATIO: f64 = 1e-2;

/// The options with a level of detail, and a method that sets the other option.
impl TessellationOptions {
    /// This number of segments along u and v of every patch: a [`Grid`], or one number for both.
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

    /// Sets which corners become one vertex.
    #[must_use]
    pub const fn weld(self, weld: Weld) -> Self {
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
    /// Whether [`tolerance_for`](Self::tolerance_for) depends on the position of the piece.
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
    /// Returns an error for an invalid view.
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

    /// The distance in space that is projected to at most `pixels` everywhere in the piece. It follows from the
    /// derivative of the projection at the piece's middle, at the smallest W in the sphere around its bounding box.
    /// Infinite outside the viewport.
    fn tolerance_for(&self, [low, high]: [DVec3; 2]) -> f64 {
        let [x, y, w] = [0, 1, 3].map(|row| self.view_projection.row(row));
        let middle = low * 0.5 + high * 0.5;
        let radius = Point::norm(high - middle);
        // Outside one of these half-spaces neither the piece nor triangles between its points are visible.
        let unseen = |plane: DVec4| {
            plane.dot(middle.extend(1.0)) + radius * Point::norm(plane.truncate()) <= 0.0
        };
        if [w, w + x, w - x, w + y, w - y].into_iter().any(unseen) {
            return f64::INFINITY;
        }
        let depth = w.dot(middle.extend(1.0));
        let reach = radius * Point::norm(w.truncate());
        let near = (depth - reach).max((depth + reach) * NEAR_RATIO);
        let slope = |row: DVec4, half: f64| {
            // ∂(X/W) = (∂X − X/W·∂W)/W; points outside the viewport are clamped to its border.
            let projected = row.dot(middle.extend(1.0)) / depth.max(near);
            (row - w * projected.clamp(-1.0, 1.0)).truncate() * (half / near)
        };
        let stretch = longest(
            slope(x, self.viewport.x / 2.0),
            slope(y, self.viewport.y / 2.0),
        );
        let tolerance = self.pixels / stretch;
        // The tolerance is NaN if the numbers of the matrix overflow; nothing is visible then.
        if tolerance.is_nan() {
            f64::INFINITY
        } else {
            tolerance
        }
    }
}

/// The spectral norm of the map with these two rows: the length of the longest image of a unit vector.
fn longest(x: DVec3, y: DVec3) -> f64 {
    let (a, b, c) = (x.dot(x), x.dot(y), y.dot(y));
    (f64::midpoint(a, c) + ((a - c) / 2.0).hypot(b)).sqrt()
}
