//! Offsets of regions.

use super::options::check_miter_limit;
use super::{StrokeCap, StrokeOptions};
use crate::geometry::error::Error;
use crate::path::Path;
use crate::path::winding::FillRule;
use crate::spline::Join;

/// Options of [`Path::offset`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct OffsetOptions {
    /// The joins at corners that the offset opens: `Miter` by default.
    pub join: Join,
    /// A miter that reaches farther from its corner than this many distances becomes a bevel: 4 by default.
    pub miter_limit: f64,
    /// The largest distance of the boundary from the exact one; the default is that of [`StrokeOptions`] for a stroke
    /// of twice the distance.
    pub tolerance: Option<f64>,
}

impl Default for OffsetOptions {
    fn default() -> Self {
        Self::new()
    }
}

/// Methods that set one option, for chaining.
impl OffsetOptions {
    /// The default options.
    pub const fn new() -> Self {
        Self {
            join: Join::Miter,
            miter_limit: 4.0,
            tolerance: None,
        }
    }

    /// Sets the joins at corners.
    #[must_use]
    pub const fn join(self, join: Join) -> Self {
        Self { join, ..self }
    }

    /// Sets the limit of miters, in distances.
    #[must_use]
    pub const fn miter_limit(self, miter_limit: f64) -> Self {
        Self {
            miter_limit,
            ..self
        }
    }

    /// Sets the largest distance of the boundary from the exact one.
    #[must_use]
    pub const fn tolerance(self, tolerance: f64) -> Self {
        Self {
            tolerance: Some(tolerance),
            ..self
        }
    }

    fn check(&self) -> Result<(), Error> {
        check_miter_limit(self.miter_limit)
    }
}

impl Path {
    /// The region that the path fills, grown by a distance, or shrunk if it is negative.
    ///
    /// The union of the region with a stroke of its boundary, or the region without that stroke; the width of the
    /// stroke is twice the distance. Growing and shrinking do not depend on the orientation of the subpaths. Open
    /// subpaths are closed, and the nonzero rule applies. A region that is thinner than twice the distance shrinks to
    /// the empty path. The result is a region as [`union`](Self::union) describes it.
    /// [`Spline::offset`](crate::Spline::offset) is the parallel curve on one side instead.
    ///
    /// ```
    /// use casteljau::Path;
    /// use casteljau::path::OffsetOptions;
    ///
    /// let square: Path = "M0 0H4V4H0Z".parse().expect("path data");
    /// assert_eq!(square.offset(1.0, &OffsetOptions::new())?.area(), 36.0);
    /// assert_eq!(square.offset(-1.0, &OffsetOptions::new())?.area(), 4.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a distance that is not finite or makes coordinates infinite; otherwise as
    /// [`stroke`](Self::stroke).
    pub fn offset(&self, distance: f64, options: &OffsetOptions) -> Result<Self, Error> {
        let width = 2.0 * distance.abs();
        if !width.is_finite() {
            return Err(Error::Range {
                what: "distance",
                expected: "a finite number, and coordinates that stay below 2^498",
                got: distance,
            });
        }
        options.check()?;
        let region = self.remove_overlaps(FillRule::NonZero)?;
        let stroke = StrokeOptions {
            join: options.join,
            miter_limit: options.miter_limit,
            cap: StrokeCap::Butt,
            tolerance: options.tolerance,
            ..StrokeOptions::default()
        };
        // The points up to the distance from the boundary, with joins at its corners.
        let border = region.stroke(width, &stroke)?;
        if distance > 0.0 {
            region.union(&border, FillRule::NonZero)
        } else {
            region.subtract(&border, FillRule::NonZero)
        }
    }
}
