//! Simplification: approximation of a spline by fewer segments.

use super::Spline;
use super::corners::angle_between;
use super::cubics::{FitEffort, ROUNDING_SHARE, is_monotone};
use super::fit::{CurveFitter, DEFAULT_CORNER_ANGLE, check_corner_angle};
use super::grid::DecimalGrid;
use crate::curve::Curve;
use crate::curve::extrema::extrema_of;
use crate::curve::flatten::Polyline;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::list::Scalars;
use crate::numeric::sort::sort_by;

/// The ratio of the tolerance that is spent on the polyline that approximates the spline.
const POLYLINE_SHARE: f64 = 1.0 / 32.0;

/// The maximum number of polyline vertices per segment: at 1/32 of a tolerance of 10⁻⁶ of its size, a cubic needs about
/// half of them.
const MAX_VERTICES_PER_SEGMENT: usize = 1 << 12;

/// Tangents that differ by less than this, as the distance of unit vectors (3°), are those of a smooth joint.
const SMOOTH: f64 = 0.05;

/// The length of the arms over which a joint must turn to be a corner, in tolerances.
const ARM: f64 = 8.0;

/// Options of [`Spline::simplify_with`] and [`Path::simplify_with`](crate::Path::simplify_with).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct SimplifyOptions {
    /// The largest distance between the original and the result, in the unit of the points.
    pub tolerance: f64,
    /// The smallest turn that is kept as a corner, in radians, above 0 and at most π: π/5 (36°) by default.
    #[cfg_attr(feature = "serde", serde(default = "super::fit::default_corner_angle"))]
    pub corner_angle: f64,
    /// Whether the extrema of each coordinate become joints with handles parallel to the axis, as in outlines of fonts:
    /// false by default.
    #[cfg_attr(feature = "serde", serde(default))]
    pub extrema: bool,
    /// The number of decimals of all control points, at most 15: `None` by default, for no rounding.
    pub precision: Option<u8>,
    /// How much is computed: [`FitEffort::Fast`] by default.
    #[cfg_attr(feature = "serde", serde(default))]
    pub effort: FitEffort,
}

/// Methods that set one option, for chaining.
impl SimplifyOptions {
    /// The options with a tolerance and otherwise the defaults.
    pub const fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            corner_angle: DEFAULT_CORNER_ANGLE,
            extrema: false,
            precision: None,
            effort: FitEffort::Fast,
        }
    }

    /// Sets the smallest turn that is kept as a corner, in radians.
    #[must_use]
    pub const fn corner_angle(self, corner_angle: f64) -> Self {
        Self {
            corner_angle,
            ..self
        }
    }

    /// Sets whether the extrema of each coordinate become joints.
    #[must_use]
    pub const fn extrema(self, extrema: bool) -> Self {
        Self { extrema, ..self }
    }

    /// Sets the number of decimals of all control points.
    #[must_use]
    pub const fn precision(self, precision: u8) -> Self {
        Self {
            precision: Some(precision),
            ..self
        }
    }

    /// Sets how much is computed.
    #[must_use]
    pub const fn effort(self, effort: FitEffort) -> Self {
        Self { effort, ..self }
    }
}

impl<P: Point> Spline<P> {
    /// A spline of fewer lines and cubics such that each point of one spline lies within `tolerance` of the other one.
    ///
    /// Corners and ends are kept; the other joints are smooth, or lie where the turn cannot be removed within the
    /// tolerance. A corner turns by more than 36° over arms of 8, 16 or 32 tolerances, as in [`fit`](Self::fit); see
    /// [`simplify_with`](Self::simplify_with) for another angle. The spline is replaced by a polyline within 1/32 of the
    /// tolerance. For each cubic the distance at each vertex is checked, and the distance of the cubic from its chords
    /// between the feet of the vertices must be within the rest of the tolerance. If the result does not have fewer
    /// segments and no segment is above degree 3, the spline is returned unchanged. A spline that is a point is returned
    /// unchanged too. A closed spline that is replaced starts at its first corner, or where it started if it has none.
    ///
    /// The work grows slightly faster than the number of vertices of the polyline. If more than 4096 vertices per
    /// segment were needed (tolerances below about 10⁻⁷ of the size of a segment), the number of segments is not
    /// reduced: segments up to degree 3 are returned unchanged, segments of a higher degree as cubics with the same
    /// tangents.
    ///
    /// # Errors
    /// As [`flatten`](Self::flatten) for the tolerance; [`Error::TooMany`] if more than 4096 of those cubics per
    /// segment are needed.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let corner = |k| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 120.0) * 100.0;
    /// let polygon = Spline::new(&(0..120).map(corner).collect::<Vec<_>>(), 1, true)?;
    /// assert!(polygon.simplify(0.5)?.segment_count() <= 6);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn simplify(&self, tolerance: f64) -> Result<Self, Error> {
        self.simplify_with(&SimplifyOptions::new(tolerance))
    }

    /// [`simplify`](Self::simplify) with all options.
    ///
    /// With `extrema`, each coordinate increases or decreases along each segment, and the handles of smooth joints at
    /// extrema are parallel to an axis; a closed spline without corners starts at an extremum. Segments above degree 3 at
    /// tolerances below about 10⁻⁷ of their size are monotone only up to the tolerance. With `precision`, all control points have that number of decimals, and the
    /// tolerance holds for the rounded result; smooth joints may turn by as much as the rounding of their handles. A
    /// spline with no fewer segments is returned with its extrema as joints and with rounded control points.
    ///
    /// # Errors
    /// As [`simplify`](Self::simplify); [`Error::Range`] for the angle, and for a precision p above 15 or one that can
    /// move a point, by √2/2 · 10⁻ᵖ in 2D and √3/2 · 10⁻ᵖ in 3D, by more than 0.96 of the tolerance.
    pub fn simplify_with(&self, options: &SimplifyOptions) -> Result<Self, Error> {
        let SimplifyOptions {
            tolerance,
            corner_angle,
            extrema,
            precision,
            effort: _,
        } = *options;
        check_tolerance(tolerance, self.max_abs())?;
        check_corner_angle(corner_angle)?;
        let share = (POLYLINE_SHARE * tolerance).max(4.0 * ulp(self.max_abs()));
        // The tolerance is shared by the polyline, the rounding of the result and the fit.
        let distance = tolerance * (1.0 - ROUNDING_SHARE) - share;
        let grid = match precision {
            Some(decimals) => Some(DecimalGrid::new(decimals, &self.points, tolerance)?),
            None => None,
        };
        let plain = self.degrees().iter().all(|&degree| degree <= 3);
        let divided = if extrema {
            let mut pieces = Vec::new();
            for segment in self.segments() {
                push_monotone_pieces(&segment, &mut pieces);
            }
            Self::from_curves(&pieces, self.closed)?
        } else {
            self.clone()
        };
        let source = match divided.vertices(share) {
            Err(Error::TooMany { .. }) if plain => return divided.rounded(grid),
            Err(Error::TooMany { .. }) => {
                let rounding = grid.map_or(0.0, |grid| grid.radius);
                return divided.in_cubics(tolerance - rounding)?.rounded(grid);
            }
            source => source?,
        };
        if source.points.len() < 2 {
            return divided.rounded(grid);
        }
        let spline = source.simplified(options, (distance, grid), self.closed);
        let is_kept = |curve: Curve<P>| !extrema || is_monotone(curve.control_points());
        if plain
            && divided.segment_count() <= spline.segment_count()
            && divided.segments().all(is_kept)
        {
            return divided.rounded(grid);
        }
        Ok(spline)
    }

    /// The spline with control points on a grid. Segments that become a point are left out.
    fn rounded(self, grid: Option<DecimalGrid>) -> Result<Self, Error> {
        let Some(grid) = grid else {
            return Ok(self);
        };
        let rounded = |curve: Curve<P>| {
            let points = curve.control_points().iter().map(|&p| grid.nearest(p));
            Curve::from_points(points.collect())
        };
        let mut pieces: Vec<Curve<P>> = self.segments().map(rounded).collect();
        let first = pieces[0].clone();
        pieces.retain(|piece| piece.control_points().iter().any(|&p| p != piece.start()));
        if pieces.is_empty() {
            pieces.push(first);
        }
        Self::from_curves(&pieces, self.closed)
    }

    /// The distinct vertices of a polyline, and the tangents before and after each vertex.
    fn vertices(&self, share: f64) -> Result<Vertices<P>, Error> {
        let mut source = Vertices {
            points: Vec::new(),
            tangents: Vec::new(),
        };
        let limit = MAX_VERTICES_PER_SEGMENT.saturating_mul(self.segment_count());
        self.check_vertices(share, limit)?;
        for curve in self.segments() {
            let mut line = Polyline::default();
            line.append(&curve, 0.0, share);
            for (k, (&p, &t)) in line.points.iter().zip(&line.ts).enumerate() {
                let tangent = curve.tangent(t);
                // A segment starts at the last vertex of the previous one: only the tangent after it is new.
                if source.points.last() != Some(&p) {
                    source.points.push(p);
                    source.tangents.push([tangent; 2]);
                } else if k == 0 && tangent != P::default() {
                    let index = source.tangents.len() - 1;
                    source.tangents[index][1] = tangent;
                }
            }
        }
        Ok(source)
    }
}

/// A polyline next to a spline, with the tangents of the spline before and after each vertex.
struct Vertices<P> {
    points: Vec<P>,
    tangents: Vec<[P; 2]>,
}

impl<P: Point> Vertices<P> {
    /// The spline fitted to the polyline within a distance, on a grid; the tolerance is the scale of corners.
    fn simplified(
        mut self,
        options: &SimplifyOptions,
        (distance, grid): (f64, Option<DecimalGrid>),
        closed: bool,
    ) -> Spline<P> {
        let corner_angle = options.corner_angle;
        let last = self.points.len() - 1;
        let closed = closed && last > 1;
        if closed {
            // The first and the last vertex are one.
            let around = [self.tangents[last][0], self.tangents[0][1]];
            (self.tangents[0], self.tangents[last]) = (around, around);
        }
        let mut fitter = CurveFitter::new(&self.points, options.tolerance, corner_angle, closed);
        fitter.require(distance, options.extrema, grid);
        fitter.effort = options.effort;
        let turns = self
            .tangents
            .iter()
            .map(|[before, after]| angle_between(*before, *after));
        let inner = if closed { 0..last } else { 1..last };
        let tree = fitter.tree();
        // Tangents may also turn where no corner is visible: the polyline must turn over arms of some tolerances too.
        let sharp = turns.enumerate().filter(|&(k, turn)| {
            let turns_at = |k| fitter.turn_at(&tree, k, ARM) > corner_angle;
            inner.contains(&k) && turn > corner_angle && turns_at(k)
        });
        let sharp: Vec<usize> = sharp.map(|(k, _)| k).collect();
        fitter.add_corners(sharp);
        let is_corner = |k: usize| fitter.corners().binary_search(&(k % last)).is_ok();
        // The other joints get the mean tangent; if one turns by more than SMOOTH, the fitter computes all tangents.
        let mut is_smooth = true;
        for (k, pair) in self.tangents.iter_mut().enumerate() {
            let [before, after] = *pair;
            if !is_corner(k) && before != after {
                is_smooth &= (after - before).norm() <= SMOOTH;
                *pair = [(before + after).unit(); 2];
            }
        }
        fitter.fitted(is_smooth.then_some(self.tangents))
    }
}

impl<P: Point> Spline<P> {
    /// The spline with each segment of a higher degree replaced by cubics within the tolerance.
    fn in_cubics(&self, tolerance: f64) -> Result<Self, Error> {
        let mut cubics = Vec::new();
        for segment in self.segments() {
            segment.for_each_cubic(tolerance * (1.0 - ROUNDING_SHARE), &mut |cubic| {
                cubics.push(cubic.clone());
            });
        }
        Self::from_curves(&cubics, self.closed)
    }
}

/// Appends the parts of a curve along which each coordinate increases or decreases, in order.
fn push_monotone_pieces<P: Point>(curve: &Curve<P>, pieces: &mut Vec<Curve<P>>) {
    let mut ts = vec![0.0, 1.0];
    for axis in 0..P::DIMENSION {
        let points = curve.control_points().iter();
        let values: Scalars = points.map(|p| p.coordinate(axis)).collect();
        ts.extend(extrema_of(&values));
    }
    sort_by(&mut ts, f64::total_cmp);
    ts.dedup();
    if ts.len() == 2 {
        pieces.push(curve.clone());
        return;
    }
    for pair in ts.windows(2) {
        pieces.push(curve.part(pair[0], pair[1]));
    }
}
