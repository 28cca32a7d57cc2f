//! De Casteljau's algorithm on a patch, with all intermediate points, for drawing the construction.

use super::Patch;
use crate::curve::Curve;
use glam::DVec3;

/// All intermediate points of de Casteljau's algorithm for S(u, v): rows, then a curve, then the point.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PatchDeCasteljau {
    /// All levels at u for each row of the net: the row itself first, its point last; see [`Curve::de_casteljau`].
    pub rows: Vec<Vec<Vec<DVec3>>>,
    /// All levels at v of the curve u = constant. Its control points are the points of the rows.
    pub column: Vec<Vec<DVec3>>,
    /// The point S(u, v), which is also the last level of the column.
    pub point: DVec3,
}

impl Patch {
    /// De Casteljau's algorithm at (u, v), with all intermediate points.
    ///
    /// Each of the n + 1 rows is a curve of degree m, evaluated at u. The resulting points are the control points of a
    /// curve of degree n, evaluated at v. Parameters outside [0, 1] extrapolate. Source: de Casteljau, *Courbes et
    /// surfaces à pôles* (Citroën, 1963); Farin, *Curves and Surfaces for CAGD*, 5th ed., §14.3.
    pub fn de_casteljau(&self, u: f64, v: f64) -> PatchDeCasteljau {
        let rows: Vec<_> = self
            .points
            .chunks(self.columns)
            .map(|row| Curve::from_slice(row).de_casteljau(u))
            .collect();
        let ends: Vec<DVec3> = rows.iter().map(|levels| last(levels)).collect();
        let column = Curve::from_slice(&ends).de_casteljau(v);
        let point = last(&column);
        PatchDeCasteljau {
            rows,
            column,
            point,
        }
    }
}

/// The only point of the last level.
fn last(levels: &[Vec<DVec3>]) -> DVec3 {
    levels
        .last()
        .and_then(|level| level.first())
        .copied()
        .unwrap_or_default()
}
