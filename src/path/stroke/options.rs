//! Options of strokes.

use crate::geometry::check::MAX_COORDINATE;
use crate::geometry::error::Error;
use crate::path::PathTime;
use crate::spline::Join;

/// What the ends of open subpaths look like.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum StrokeCap {
    /// The stroke ends at the end of the path, perpendicular to it.
    #[default]
    Butt,
    /// A half disk.
    Round,
    /// A rectangle half as long as the stroke is wide.
    Square,
}

/// Options of [`Path::stroke`](crate::Path::stroke); the defaults are those of SVG and Canvas.
///
/// ```
/// use casteljau::path::{StrokeCap, StrokeOptions};
///
/// let options = StrokeOptions::new().cap(StrokeCap::Round).dash(&[4.0, 2.0], 0.0);
/// assert_eq!(options.miter_limit, 4.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct StrokeOptions {
    /// The joins at corners: `Miter` by default.
    pub join: Join,
    /// A miter that reaches farther from its corner than this many half widths becomes a bevel: 4 by default.
    pub miter_limit: f64,
    /// The caps: `Butt` by default.
    pub cap: StrokeCap,
    /// The lengths of dashes and gaps, as for [`Path::dash`](crate::Path::dash). An empty list, the default, means a
    /// stroke without gaps.
    pub dash: Vec<f64>,
    /// The length in the dash pattern at which each subpath starts: 0 by default.
    pub dash_offset: f64,
    /// The largest distance of the boundary from that of the exact stroke. The default is 10⁻⁴ of the diagonal of the
    /// control points' box plus the width, and at least 10⁻¹² of the largest coordinate plus half the width. The union
    /// of `simple` adds an error of up to 10⁻⁹ of the size of the stroke.
    pub tolerance: Option<f64>,
    /// Whether the result has no overlaps: true by default.
    pub simple: bool,
}

impl Default for StrokeOptions {
    fn default() -> Self {
        Self::new()
    }
}

/// Methods that set one option, for chaining.
impl StrokeOptions {
    /// The default options.
    pub const fn new() -> Self {
        Self {
            join: Join::Miter,
            miter_limit: 4.0,
            cap: StrokeCap::Butt,
            dash: Vec::new(),
            dash_offset: 0.0,
            tolerance: None,
            simple: true,
        }
    }

    /// Sets the joins at corners.
    #[must_use]
    pub fn join(self, join: Join) -> Self {
        Self { join, ..self }
    }

    /// Sets the limit of miters, in half widths.
    #[must_use]
    pub fn miter_limit(self, miter_limit: f64) -> Self {
        Self {
            miter_limit,
            ..self
        }
    }

    /// Sets the caps.
    #[must_use]
    pub fn cap(self, cap: StrokeCap) -> Self {
        Self { cap, ..self }
    }

    /// Sets the lengths of dashes and gaps, and the length in the pattern at which subpaths start.
    #[must_use]
    pub fn dash(self, dash: &[f64], dash_offset: f64) -> Self {
        Self {
            dash: dash.to_vec(),
            dash_offset,
            ..self
        }
    }

    /// Sets the largest distance of the boundary from that of the exact stroke.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self {
            tolerance: Some(tolerance),
            ..self
        }
    }

    /// Sets whether the result has no overlaps.
    #[must_use]
    pub fn simple(self, simple: bool) -> Self {
        Self { simple, ..self }
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        check_miter_limit(self.miter_limit)
    }
}

/// Options of [`Path::round_corners_with`](crate::Path::round_corners_with).
///
/// ```
/// use casteljau::{Path, path::{CornerOptions, PathTime}};
///
/// let square: Path = "M0 0H10V10H0Z".parse().expect("path data");
/// let first = CornerOptions::new().corners(&[PathTime::new(0, 1.0)]).tolerance(0.001);
/// assert_eq!(square.round_corners_with(2.0, &first)?.segment_count(), 5);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct CornerOptions {
    /// The largest distance of the cubics from the arcs: 10⁻⁹ of the radius by default.
    pub tolerance: Option<f64>,
    /// The joints at which corners are rounded: all by default. Joints without a corner in the list stay.
    pub corners: Option<Vec<PathTime>>,
}

/// Methods that set one option, for chaining.
impl CornerOptions {
    /// The default options.
    pub const fn new() -> Self {
        Self {
            tolerance: None,
            corners: None,
        }
    }

    /// Sets the largest distance of the cubics from the arcs.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self {
            tolerance: Some(tolerance),
            ..self
        }
    }

    /// Sets the joints at which corners are rounded.
    #[must_use]
    pub fn corners(self, corners: &[PathTime]) -> Self {
        Self {
            corners: Some(corners.to_vec()),
            ..self
        }
    }
}

pub(super) fn check_miter_limit(limit: f64) -> Result<(), Error> {
    if (1.0..=f64::MAX).contains(&limit) {
        return Ok(());
    }
    Err(Error::Range {
        what: "miter_limit",
        expected: "a finite number, at least 1",
        got: limit,
    })
}

/// The checked parameters of a stroke.
#[derive(Clone, Copy)]
pub(super) struct Pen {
    /// Half the width, or the larger one of the widths of both sides; above 0.
    pub(super) radius: f64,
    /// The widths on the left and on the right, if they are different.
    pub(super) sides: Option<[f64; 2]>,
    pub(super) join: Join,
    pub(super) miter_limit: f64,
    pub(super) cap: StrokeCap,
    pub(super) tolerance: f64,
    /// The scale of the radius and the tolerance.
    pub(super) unit: f64,
}

impl Pen {
    /// The pen in coordinates that are multiplied by a scale.
    pub(super) fn scaled(&self, scale: f64) -> Self {
        Self {
            radius: self.radius * scale,
            sides: self.sides.map(|sides| sides.map(|side| side * scale)),
            tolerance: self.tolerance * scale,
            unit: self.unit * scale,
            ..*self
        }
    }

    /// The factor of the sum of two unit normals of a disc that gives the tip of a miter; `None` for a join that is not
    /// a miter, or exceeds the limit of miters or that of coordinates.
    ///
    /// The tip is 1/cos(θ/2) radii away, and 1 + cos θ = 2cos²(θ/2).
    pub(super) fn miter(&self, radius: f64, cos: f64) -> Option<f64> {
        let twice = 1.0 + cos;
        let within = twice * self.miter_limit * self.miter_limit >= 2.0;
        let reach = radius / twice;
        (self.join == Join::Miter && within && reach <= 0.125 * MAX_COORDINATE * self.unit)
            .then_some(reach)
    }
}
