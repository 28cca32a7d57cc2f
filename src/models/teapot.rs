//! The Utah teapot.
//!
//! Thirty-two bicubic patches: rim 0–3, body 4–11, handle 12–15, spout 16–19, lid 20–27, bottom 28–31; z points up and
//! ∂u × ∂v outwards. The patches and their points are those of the usual listing, in the same order. Vertices are
//! renumbered: each distinct point is one vertex, in the order of first use. That gives 290 vertices instead of the
//! listing's 306, of which four are unused and twelve repeat the edge between body and bottom; here that edge is shared
//! like all others.

use super::teapot_data::{BOTTOM, HANDLE, LID, Ring, SPOUT, TubeSection, UNITS, WALL};
use crate::surface::network::Surface;
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;

/// Options of [`Surface::teapot`]: its parts, its height and the axis that points up.
///
/// ```
/// use casteljau::{Surface, TeapotOptions, models::Height};
///
/// let newells = TeapotOptions::new().height(Height::Original).bottom(false);
/// assert_eq!(Surface::teapot(&newells).patch_count(), 28);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct TeapotOptions {
    /// Whether the rim, patches 0–3 of the complete teapot, is a part: true by default.
    pub rim: bool,
    /// Whether the body, patches 4–11, is a part: true by default.
    pub body: bool,
    /// Whether the handle, patches 12–15, is a part: true by default.
    pub handle: bool,
    /// Whether the spout, patches 16–19, is a part: true by default.
    pub spout: bool,
    /// Whether the lid, patches 20–27, is a part: true by default.
    pub lid: bool,
    /// Whether the bottom, patches 28–31, which Newell's teapot did not have, is a part: true by default.
    pub bottom: bool,
    /// The height: `Squashed` by default.
    pub height: Height,
    /// The axis that points up: `Z` by default.
    pub up: Up,
}

/// The height of the teapot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Height {
    /// 3.15, as the teapot is commonly distributed: the pixels of Blinn's display were not square.
    #[default]
    Squashed,
    /// 4.2, 4/3 times as tall: Newell's original. (three.js uses a factor of 1.3.)
    Original,
}

/// The axis that points up; the spout points along +x.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Up {
    /// +z, as in the listing.
    #[default]
    Z,
    /// +y: (x, y, z) becomes (x, z, −y).
    Y,
}

impl Default for TeapotOptions {
    fn default() -> Self {
        Self::new()
    }
}

/// Methods that set one option, for chaining.
impl TeapotOptions {
    /// The default options.
    pub const fn new() -> Self {
        Self {
            rim: true,
            body: true,
            handle: true,
            spout: true,
            lid: true,
            bottom: true,
            height: Height::Squashed,
            up: Up::Z,
        }
    }

    /// Sets whether the rim is a part.
    #[must_use]
    pub const fn rim(self, rim: bool) -> Self {
        Self { rim, ..self }
    }

    /// Sets whether the body is a part.
    #[must_use]
    pub const fn body(self, body: bool) -> Self {
        Self { body, ..self }
    }

    /// Sets whether the handle is a part.
    #[must_use]
    pub const fn handle(self, handle: bool) -> Self {
        Self { handle, ..self }
    }

    /// Sets whether the spout is a part.
    #[must_use]
    pub const fn spout(self, spout: bool) -> Self {
        Self { spout, ..self }
    }

    /// Sets whether the lid is a part.
    #[must_use]
    pub const fn lid(self, lid: bool) -> Self {
        Self { lid, ..self }
    }

    /// Sets whether the bottom is a part.
    #[must_use]
    pub const fn bottom(self, bottom: bool) -> Self {
        Self { bottom, ..self }
    }

    /// Sets the height.
    #[must_use]
    pub const fn height(self, height: Height) -> Self {
        Self { height, ..self }
    }

    /// Sets the axis that points up.
    #[must_use]
    pub const fn up(self, up: Up) -> Self {
        Self { up, ..self }
    }
}

/// A control point in integer units; i32 is large enough for all sums and rotations of the tables.
pub(crate) type Whole = [i32; 3];

impl Surface {
    /// The Utah teapot or some of its parts; see [`TeapotOptions`].
    pub fn teapot(options: &TeapotOptions) -> Self {
        teapot(*options)
    }
}

/// The selected parts of the teapot.
fn teapot(options: TeapotOptions) -> Surface {
    let mut points: Vec<Whole> = Vec::new();
    if options.rim {
        revolve(&WALL[..4], 1, &mut points);
    }
    if options.body {
        revolve(&WALL[3..], 1, &mut points);
    }
    if options.handle {
        sweep(&HANDLE, &mut points);
    }
    if options.spout {
        sweep(&SPOUT, &mut points);
    }
    if options.lid {
        revolve(&LID, 1, &mut points);
    }
    if options.bottom {
        revolve(&BOTTOM, -1, &mut points);
    }
    let (vertices, indices) = index_points(&points);
    let vertices = vertices.iter().map(|&p| position(p, options)).collect();
    Surface::bicubic(vertices, indices)
}

/// A surface of revolution: rotates profiles about the z-axis, a quarter turn per patch; `sense` 1 is clockwise as seen
/// from above.
pub(crate) fn revolve(profile: &[Ring], sense: i32, points: &mut Vec<Whole>) {
    for curve in profile.windows(4).step_by(3) {
        for quarter in 0..4 {
            for ring in curve {
                let [radius, reach, z] = ring.map(i32::from);
                let arc = [(radius, 0), (radius, reach), (reach, radius), (0, radius)];
                points.extend(arc.map(|(x, y)| {
                    let (x, y) = (0..quarter).fold((x, y), |(x, y), _| (-y, x));
                    [x, -sense * y, z]
                }));
            }
        }
    }
}

/// A sweep along cross-sections: two curves, each with one patch on the side of −y and its mirror image.
pub(crate) fn sweep(sections: &[TubeSection], points: &mut Vec<Whole>) {
    for curve in sections.windows(4).step_by(3) {
        for section in curve {
            points.extend(half_section(section));
        }
        for section in curve {
            let mirrored = half_section(section).map(|[x, y, z]| [x, -y, z]);
            points.extend(mirrored.iter().rev());
        }
    }
}

/// The half of a cross-section with y ≤ 0.
fn half_section(section: &TubeSection) -> [Whole; 4] {
    let [x0, z0, x1, z1, width] = section.map(i32::from);
    [[x0, 0, z0], [x0, -width, z0], [x1, -width, z1], [x1, 0, z1]]
}

/// The distinct points in the order of first use, and the index of each point among them.
pub(crate) fn index_points(points: &[Whole]) -> (Vec<Whole>, Vec<u32>) {
    let mut vertices: Vec<Whole> = Vec::new();
    let mut indices = Vec::with_capacity(points.len());
    for point in points {
        let found = (0..).zip(&vertices).find(|(_, vertex)| *vertex == point);
        let index = found.map(|(index, _)| index);
        indices.push(index.unwrap_or_else(|| {
            vertices.push(*point);
            to_u32(vertices.len() - 1)
        }));
    }
    (vertices, indices)
}

/// The point in the units of the teapot. Each integer is divided once, so every coordinate is the nearest f64.
fn position([x, y, z]: Whole, options: TeapotOptions) -> DVec3 {
    let height_units = match options.height {
        Height::Squashed => UNITS,
        Height::Original => UNITS * 0.75,
    };
    let (x, z) = (f64::from(x) / UNITS, f64::from(z) / height_units);
    match options.up {
        Up::Z => DVec3::new(x, f64::from(y) / UNITS, z),
        Up::Y => DVec3::new(x, z, f64::from(-y) / UNITS),
    }
}
