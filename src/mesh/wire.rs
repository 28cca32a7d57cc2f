//! Options of wireframe meshes.

/// The options of [`Surface::wireframe`](crate::Surface::wireframe).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct WireframeOptions {
    /// The number of strips per patch in each direction, at least 1.
    pub lines: usize,
    /// The shape of the lines.
    pub wire: Wire,
}

/// The shape of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Wire {
    /// A tube with round ends.
    Tube {
        /// The radius of the circle around the line on which the corners lie, in the surface's unit.
        radius: f64,
        /// The number of corners of the cross-section, at least 3.
        sides: usize,
    },
    /// A flat band in the tangent planes of the surface.
    Ribbon {
        /// The width from edge to edge, in the surface's unit.
        width: f64,
    },
}

impl Default for WireframeOptions {
    /// Four strips, and tubes with eight sides and the radius 0.01.
    fn default() -> Self {
        Self {
            lines: 4,
            wire: Wire::Tube {
                radius: 0.01,
                sides: 8,
            },
        }
    }
}

impl WireframeOptions {
    /// This number of strips per patch in each direction, with lines of this shape.
    pub const fn new(lines: usize, wire: Wire) -> Self {
        Self { lines, wire }
    }
}
