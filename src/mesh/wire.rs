//! What the lines of a wireframe are made of.

/// What a [`Surface::wireframe`](crate::Surface::wireframe) is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct WireframeOptions {
    /// Strips per patch each way, at least 1.
    pub lines: usize,
    /// The body of each line.
    pub wire: Wire,
}

/// The body of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Wire {
    /// A tube with round ends.
    Tube {
        /// Of the circle around the line that the corners lie on, in the surface's unit.
        radius: f64,
        /// Corners of the cross-section, at least 3.
        sides: usize,
    },
    /// A flat band in the surface's tangent planes.
    Ribbon {
        /// From edge to edge, in the surface's unit.
        width: f64,
    },
}

impl Default for WireframeOptions {
    /// Four strips; tubes of eight sides and the radius 0.01.
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
