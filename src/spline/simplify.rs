//! Simplification: approximation of a spline by fewer segments.

use super::Spline;
use super::cubics::{FitCriteria, FitSamples, chord_lengths};
use super::fit::{ROUNDING_SHARE, assemble};
use crate::curve::flatten::{Polyline, check_vertices};
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::work_limit::WorkLimit;

/// The ratio of the tolerance that is spent on the polyline that approximates the spline.
const POLYLINE_SHARE: f64 = 1.0 / 32.0;

/// The maximum number of polyline vertices per segment: at 1/32 of a tolerance of 10⁻⁶ of its size, a cubic needs about
/// half of them.
const MAX_VERTICES_PER_SEGMENT: usize = 1 << 12;

/// The maximum number of cubics that replace a segment of a higher degree whose polyline would have too many vertices.
const MAX_CUBICS_PER_SEGMENT: usize = 1 << 12;

/// Tangents that differ by more than this, as the distance of unit vectors (3°), make a corner.
const CORNER: f64 = 0.05;

impl<P: Point> Spline<P> {
    /// A spline of fewer cubics such that each point of one spline lies within `tolerance` of the other one.
    ///
    /// Corners (joints where the tangent turns by more than 3°) and ends are kept; the other joints are smooth. The
    /// spline is replaced by a polyline within 1/32 of the tolerance. For each cubic the distance at each vertex is
    /// checked, and the distance of the cubic from its chords between the feet of the vertices must be within the rest
    /// of the tolerance. If the result does not have fewer segments and no segment is above degree 3, the spline is
    /// returned unchanged. A spline that is a point is returned unchanged too.
    ///
    /// The work grows slightly faster than the number of vertices of the polyline. If more than 4096 vertices per
    /// segment were needed (tolerances below about 10⁻⁷ of the size of a segment), the number of segments is not
    /// reduced: segments up to degree 3 are returned unchanged, segments of a higher degree as cubics with the same
    /// tangents.
    ///
    /// # Errors
    /// As [`flatten`](Self::flatten) for the tolerance; [`Error::TooMany`] if more than 4096 of those cubics per
    /// segment are needed.
    pub fn simplify(&self, tolerance: f64) -> Result<Self, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        let share = (POLYLINE_SHARE * tolerance).max(4.0 * ulp(self.max_abs()));
        let plain = self.degrees().iter().all(|&degree| degree <= 3);
        let (kept, tangents, corners) = match self.vertices(share) {
            Err(Error::TooMany { .. }) if plain => return Ok(self.clone()),
            Err(Error::TooMany { .. }) => return self.in_cubics(tolerance),
            vertices => vertices?,
        };
        if kept.len() < 2 {
            return Ok(self.clone());
        }
        let normalized = Normalized::around(kept[0], &kept);
        let points: Vec<P> = normalized.points(&kept);
        let fit_samples = FitSamples {
            lengths: chord_lengths(&points),
            tangents: tangents.iter().map(|pair| pair[1]).collect(),
            joints: points.clone(),
            points,
            criteria: FitCriteria {
                tolerance: (tolerance * (1.0 - ROUNDING_SHARE) - share) * normalized.scale,
                between: true,
            },
        };
        let cubics = fit_samples.cover_all(&tangents, &corners);
        if plain && cubics.len() >= self.segment_count() {
            return Ok(self.clone());
        }
        Ok(assemble(&normalized, &cubics, self.closed, |k| kept[k]))
    }

    /// The distinct vertices of a polyline, the tangents before and after each vertex, and the indices of corners and
    /// ends.
    #[allow(clippy::type_complexity, reason = "three parallel lists")]
    fn vertices(&self, share: f64) -> Result<(Vec<P>, Vec<[P; 2]>, Vec<usize>), Error> {
        let mut kept: Vec<P> = Vec::new();
        let mut tangents: Vec<[P; 2]> = Vec::new();
        let mut corners = vec![0];
        let limit = MAX_VERTICES_PER_SEGMENT.saturating_mul(self.segment_count());
        check_vertices(|| self.segments(), share, limit)?;
        for curve in self.segments() {
            let mut line = Polyline::default();
            line.append(&curve, 0.0, share);
            for (k, (&p, &t)) in line.points.iter().zip(&line.ts).enumerate() {
                let tangent = curve.tangent(t);
                if kept.last() != Some(&p) {
                    kept.push(p);
                    tangents.push([tangent; 2]);
                } else if k == 0 && tangent != P::default() {
                    let index = tangents.len() - 1;
                    tangents[index][1] = tangent;
                    if index > 0 && (tangent - tangents[index][0]).length() > CORNER {
                        corners.push(index);
                    }
                }
            }
        }
        corners.push(kept.len() - 1);
        corners.dedup();
        Ok((kept, tangents, corners))
    }
}

impl<P: Point> Spline<P> {
    /// The spline with each segment of a higher degree replaced by cubics: it is halved until the cubic with the same
    /// ends and tangents is within the tolerance.
    fn in_cubics(&self, tolerance: f64) -> Result<Self, Error> {
        let mut work = WorkLimit::new(MAX_CUBICS_PER_SEGMENT.saturating_mul(self.segment_count()));
        let mut cubics = Vec::new();
        for segment in self.segments() {
            // The remaining parts of the segment, the first one last.
            let mut rest = vec![segment];
            while let Some(piece) = rest.pop() {
                if !work.spend(1) {
                    let limit = MAX_CUBICS_PER_SEGMENT.saturating_mul(self.segment_count());
                    return Err(Error::too_many(
                        "cubics of the simplified spline",
                        limit,
                        limit.saturating_add(1),
                    ));
                }
                if piece.degree() <= 3 {
                    cubics.push(piece);
                    continue;
                }
                let cubic = piece.cubic_of_same_tangents();
                if piece.distance_of_controls(&cubic) <= tolerance * (1.0 - ROUNDING_SHARE) {
                    cubics.push(cubic);
                } else {
                    let (left, right) = piece.halve();
                    rest.extend([right, left]);
                }
            }
        }
        Self::from_curves(&cubics, self.closed)
    }
}
