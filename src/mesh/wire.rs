//! Options of wireframe meshes.

/// Options of [`Surface::wireframe`](crate::Surface::wireframe).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct WireframeOptions {
    /// The number of strips per patch in each direction, at least 1: 4 by default.
    pub lines: usize,
    /// The shape of the lines: tubes with eight sides and the radius 0.01 by default.
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
    fn default() -> Self {
        Self::new()
    }
}

/// Methods that set one option, for chaining.
impl WireframeOptions {
    /// The default options.
    pub const fn new() -> Self {
        Self {
            lines: 4,
            wire: Wire::Tube {
                radius: 0.01,
                sides: 8,
            },
        }
    }

    /// Sets the number of strips per patch in each direction.
    #[must_use]
    pub const fn lines(self, lines: usize) -> Self {
        Self { lines, ..self }
    }

    /// Sets the shape of the lines.
    #[must_use]
    pub const fn wire(self, wire: Wire) -> Self {
        Self { wire, ..self }
    }
}
