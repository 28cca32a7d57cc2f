//! Strokes, dashes, offsets of regions, and rounded corners.
//!
//! The stroke of a path is the union of discs around its points, with joins and caps in place of what the discs cover at
//! corners and ends. A subpath is divided into sections ([`subpath`], [`section`]), each with two sides ([`side`]), and
//! these are joined to an outline ([`outline`]). The width may vary along the path.
//!
//! Sources: Nehab, "Converting stroked primitives to filled primitives" (SIGGRAPH 2020); Levien and Uguray,
//! "GPU-friendly stroke expansion" (HPG 2024).

mod contains;
mod contours;
mod corner_arc;
mod dash;
mod offset;
mod options;
mod outline;
mod profile;
mod round_corners;
mod section;
mod side;
mod side_bound;
mod side_fit;
mod subpath;

pub use offset::OffsetOptions;
pub use options::{CornerOptions, StrokeCap, StrokeOptions};
pub use profile::{WidthInterpolation, WidthPosition, WidthProfile};

use super::Path;
use super::boolean::BooleanOperation;
use super::winding::FillRule;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::spline::Spline;
use crate::spline::offset::curve::offset_tolerance;
use casteljau_kernels::numeric::order::larger;
use dash::Pattern;
use glam::DVec2;
use options::Pen;

impl Path {
    /// The region that a stroke of the path covers.
    ///
    /// The points on a normal of the path at a distance of at most half the width, the joins at corners, and the caps
    /// at the ends of open subpaths. Closed subpaths give two contours and have no caps. Where a segment reverses its
    /// direction (a cusp, a turn of a straight curve), the half disk ahead of that point belongs to the stroke. A
    /// subpath that is a point gives a disk with round caps, a square along the axes with square caps, and nothing with
    /// butt caps. A width of 0 gives the empty path.
    ///
    /// The boundary of the result is within `tolerance` of the exact one; see [`StrokeOptions`] for the default. With
    /// `simple` (the default) the result is a region as [`union`](Self::union) describes it, without parts and holes
    /// thinner than the tolerance. Otherwise the contours overlap, and fill the region under the nonzero rule.
    ///
    /// ```
    /// use casteljau::Path;
    /// use casteljau::path::StrokeOptions;
    ///
    /// let line: Path = "M0 0H10".parse().expect("path data");
    /// let outline = line.stroke(2.0, &StrokeOptions::default())?;
    /// assert_eq!(outline.area(), 20.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a width that is negative or not finite or makes coordinates infinite, for a miter limit
    /// below 1, and for a tolerance that is not above 0; [`Error::Tolerance`] for a tolerance below 4 ulps of the
    /// largest coordinate plus half the width; for dashes as [`dash`](Self::dash); [`Error::TooMany`] for
    /// outlines of more than 512 segments and 64 for each curve of the path, unless `simple` is false, and otherwise
    /// as [`Curve::offset`](crate::Curve::offset) and [`union`](Self::union).
    pub fn stroke(&self, width: f64, options: &StrokeOptions) -> Result<Self, Error> {
        check_width("width", width)?;
        self.stroke_with(&WidthProfile::constant(width), options)
    }

    /// The region of a stroke whose widths on the left and on the right of the path are different: the points on a left
    /// normal at a distance of at most `left`, and those on a right normal at a distance of at most `right`.
    ///
    /// Left is where [`normal`](Self::normal) points: the tangent rotated by +90° (x right, y up). Joins and the half disk
    /// ahead of a point where a segment reverses its direction are those of a stroke with twice the width of the outer side,
    /// at reversals of the wider one. A round cap is the half disk whose diameter is the end of the stroke, a square cap
    /// extends the stroke by half of left + right. With two equal widths w it is the [`stroke`](Self::stroke) of the width
    /// 2w. If both are 0, the result is the empty path.
    ///
    /// The boundary of the result is within `tolerance` of the exact one, by default that of a stroke of twice the larger
    /// width.
    ///
    /// ```
    /// use casteljau::Path;
    /// use casteljau::path::StrokeOptions;
    ///
    /// let line: Path = "M0 0H10".parse().expect("path data");
    /// let outline = line.stroke_sides(3.0, 1.0, &StrokeOptions::default())?;
    /// assert_eq!(outline.area(), 40.0);
    /// assert_eq!(outline.bounds().expect("a region").max.y, 3.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a width that is negative or not finite; otherwise as [`stroke`](Self::stroke).
    pub fn stroke_sides(
        &self,
        left: f64,
        right: f64,
        options: &StrokeOptions,
    ) -> Result<Self, Error> {
        check_width("left", left)?;
        check_width("right", right)?;
        let profile = WidthProfile::constant(2.0 * larger(left, right));
        let sides = (left != right).then_some([left, right]);
        self.region_of(&profile, sides, options)
    }

    /// The region that a stroke of varying width covers.
    ///
    /// The union of the discs around all points of the path whose radius is half the width there, with joins and caps as
    /// for [`stroke`](Self::stroke); a constant profile gives the same region. An interval in which the radius grows or
    /// shrinks faster than the path advances is the disc at its wider end. A butt cap is the line between the two points in
    /// which the last disc touches the sides; a square cap extends the stroke from that line by half the width. Miters
    /// follow the tangents of the sides; a corner of the path is no corner where the width is 0. Positions are fractions of
    /// each subpath, before dashing. If the first and the last width of a closed subpath differ, both discs belong to the
    /// stroke. Where the radius changes faster than the path advances right after a corner, that corner has a round join
    /// for every option: no side is there to be extended. A subpath that is a point has its largest width.
    ///
    /// The boundary is within `tolerance` of the exact one, by a bound for each of its cubics. Without `simple`, gaps thinner
    /// than twice the tolerance can be left inside of the stroke, where sides cross.
    ///
    /// ```
    /// use casteljau::Path;
    /// use casteljau::path::{StrokeOptions, WidthProfile};
    ///
    /// let line: Path = "M0 0H10".parse().expect("path data");
    /// let wedge = WidthProfile::new(&[(0.0, 0.0), (1.0, 4.0)]);
    /// let outline = line.stroke_with(&wedge, &StrokeOptions::default())?;
    /// assert_eq!(outline.segment_count(), 3);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Count`] for a profile without stops; [`Error::Item`] for positions that are not ascending from 0 to 1, and
    /// for a width that is negative or not finite; [`Error::TooMany`] for more than 2¹⁷ attempted cubics for one side of a
    /// curve; otherwise as [`stroke`](Self::stroke).
    ///
    /// Source of the envelope: Choi, Choi and Moon, "Mathematical theory of medial axis transform", Pacific J. Math. 181
    /// (1997).
    pub fn stroke_with(
        &self,
        profile: &WidthProfile,
        options: &StrokeOptions,
    ) -> Result<Self, Error> {
        self.region_of(profile, None, options)
    }

    /// `sides`: the widths on the left and on the right, if they are different; then the profile has twice the larger one.
    fn region_of(
        &self,
        profile: &WidthProfile,
        sides: Option<[f64; 2]>,
        options: &StrokeOptions,
    ) -> Result<Self, Error> {
        match self.outlines(profile, sides, options)? {
            Some((strokes, pen)) => strokes.finish(&pen, options.simple),
            None => Ok(Self::default()),
        }
    }

    /// The contours of the stroke of an open part of a subpath of some length; the part begins at the length `from` of it.
    pub(in crate::path) fn stroke_part(
        part: Spline<DVec2>,
        from: f64,
        length: f64,
        profile: &WidthProfile,
        options: &StrokeOptions,
    ) -> Result<Self, Error> {
        match Self::from(part.clone()).pen(profile.max(), options)? {
            Some(pen) => {
                Strokes::of_part(part, from, length, profile, &pen)?.finish(&pen, options.simple)
            }
            None => Ok(Self::default()),
        }
    }

    /// Whether a point is in a stroke of varying width, as [`stroke_with`](Self::stroke_with) describes it; within the
    /// tolerance of the boundary the answer may be either.
    ///
    /// The cost is that of the region.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a point with a NaN or an infinity, otherwise as [`stroke_with`](Self::stroke_with).
    pub fn stroke_contains_with(
        &self,
        p: DVec2,
        profile: &WidthProfile,
        options: &StrokeOptions,
    ) -> Result<bool, Error> {
        check_points("p", &[p])?;
        let strokes = self.outlines(profile, None, options)?;
        Ok(
            strokes
                .is_some_and(|(strokes, _)| strokes.overlapping().contains(p, FillRule::NonZero)),
        )
    }

    /// The outlines of all strokes; `None` if they are empty.
    fn outlines(
        &self,
        profile: &WidthProfile,
        sides: Option<[f64; 2]>,
        options: &StrokeOptions,
    ) -> Result<Option<(Strokes, Pen)>, Error> {
        profile.check()?;
        let pen = self.pen(profile.max(), options)?;
        let pen = pen.map(|pen| Pen { sides, ..pen });
        let pattern = Pattern::new(&options.dash, options.dash_offset)?;
        let Some(pen) = pen else {
            return Ok(None);
        };
        let strokes = self.strokes(profile, &pen, pattern.as_ref())?;
        Ok(Some((strokes, pen)))
    }

    /// The checked parameters of a stroke; `None` if it is empty.
    fn pen(&self, width: f64, options: &StrokeOptions) -> Result<Option<Pen>, Error> {
        options.check()?;
        let radius = 0.5 * width;
        let diagonal = || {
            self.control_bounds()
                .map_or(0.0, |bounds| bounds.diagonal())
                + width
        };
        let tolerance = offset_tolerance(radius, options.tolerance, self.max_abs(), diagonal)?;
        let pen = Pen {
            radius,
            sides: None,
            join: options.join,
            miter_limit: options.miter_limit,
            cap: options.cap,
            tolerance,
            unit: 1.0,
        };
        Ok((radius > 0.0 && !self.is_empty()).then_some(pen))
    }
}

fn check_width(what: &'static str, width: f64) -> Result<(), Error> {
    if (0.0..=f64::MAX).contains(&width) {
        return Ok(());
    }
    Err(Error::Range {
        what,
        expected: "a finite number, at least 0",
        got: width,
    })
}

/// The largest number of segments of outlines whose union a stroke computes: for each part of a curve that is stroked,
/// and in addition for any number of them. More mean that the tolerance is tiny compared with the turns of the outline.
const SEGMENTS_PER_CURVE: usize = 64;
const BASE_SEGMENTS: usize = 1 << 9;

/// The parts of a stroke.
#[derive(Default)]
struct Strokes {
    /// The number of parts of curves that are stroked.
    curve_count: usize,
    /// The outlines; their winding numbers are non-negative except in the folds.
    outlines: Path,
    /// The parts that are swept backwards, where the outlines alone can leave them out; see [`side`].
    folds: Path,
}

impl Strokes {
    fn finish(self, pen: &Pen, simple: bool) -> Result<Path, Error> {
        if simple {
            self.region(pen)
        } else {
            Ok(self.overlapping())
        }
    }

    /// All contours; the region is where the winding number is not 0.
    fn overlapping(self) -> Path {
        let mut path = self.outlines;
        // Once for the part that the outline counts as −1, and once more to make it positive.
        for spline in self.folds.subpaths() {
            path.extend([spline.clone(), spline]);
        }
        path
    }

    /// The region as simple contours.
    fn region(self, pen: &Pen) -> Result<Path, Error> {
        let needed = self.outlines.segment_count() + self.folds.segment_count();
        let limit = BASE_SEGMENTS + SEGMENTS_PER_CURVE * self.curve_count;
        if needed > limit {
            return Err(Error::too_many("segments", limit, needed));
        }
        let paths = [&self.outlines, &self.folds];
        let union = if self.folds.is_empty() {
            self.outlines.remove_overlaps(FillRule::NonZero)?
        } else {
            Path::combine(paths, BooleanOperation::Union, FillRule::NonZero)?
        };
        Ok(contours::without_thin(&union, pen))
    }
}
