//! Which spline of fewer segments is close enough?

use super::Spline;
use super::cubics::{FitCriteria, FitSamples, chord_lengths};
use super::fit::{ROUNDING_SHARE, assemble, scale_of, scaled};
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use casteljau_kernels::WorkLimit;

/// The polyline that stands for the spline takes this part of the tolerance.
const POLYLINE_SHARE: f64 = 1.0 / 32.0;

/// Vertices of the polyline, for each segment: at 1/32 of a tolerance of 10⁻⁶ of its size a cubic needs about half of them.
const MAX_VERTICES_PER_SEGMENT: usize = 1 << 12;

/// Pieces that are made of a segment of a higher degree where its polyline would have too many vertices.
const MAX_CUBICS_PER_SEGMENT: usize = 1 << 12;

/// Tangents that differ by more than this, as a distance of unit vectors (3°), make a corner.
const CORNER: f64 = 0.05;

impl<P: Point> Spline<P> {
    /// A spline of fewer cubics, each point of which lies within `tolerance` of this one, and the other way round.
    ///
    /// Corners (joints where the tangent turns by more than 3°) and ends stay where they are; other joints are smooth. The
    /// spline is replaced by a polyline within 1/32 of the tolerance; along it each cubic has, vertex by vertex, a distance that is
    /// checked, and chords that are no farther from it than what is left. Where that makes no fewer segments, and
    /// none is above degree 3, the spline comes back as it is. So does one that is a point.
    ///
    /// The work grows a little faster than the number of the polyline's vertices. Where they would be more than 4096 for
    /// each segment (tolerances below about 10⁻⁷ of a segment's size), no fewer segments are looked for: degrees up to 3
    /// come back as they are, and higher ones as cubics with the same tangents.
    ///
    /// # Errors
    /// As [`flatten`](Self::flatten) for the tolerance; [`Error::TooMany`] where those cubics are more than 4096 for each
    /// segment.
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
        let scale = scale_of(&kept);
        let points = scaled(&kept, scale);
        let fit_samples = FitSamples {
            lengths: chord_lengths(&points),
            tangents: tangents.iter().map(|pair| pair[1]).collect(),
            points,
            criteria: FitCriteria {
                tolerance: (tolerance * (1.0 - ROUNDING_SHARE) - share) * scale,
                between: true,
            },
        };
        let cubics = covered(fit_samples, &tangents, &corners);
        if plain && cubics.len() >= self.segment_count() {
            return Ok(self.clone());
        }
        Ok(assemble(&kept, scale, &cubics, self.closed))
    }

    /// The vertices of a polyline, each once, the tangents before and after each, and the indices of corners and ends.
    #[allow(clippy::type_complexity, reason = "three lists that go together")]
    fn vertices(&self, share: f64) -> Result<(Vec<P>, Vec<[P; 2]>, Vec<usize>), Error> {
        let mut kept: Vec<P> = Vec::new();
        let mut tangents: Vec<[P; 2]> = Vec::new();
        let mut corners = vec![0];
        let limit = MAX_VERTICES_PER_SEGMENT.saturating_mul(self.segment_count());
        for curve in self.segments() {
            let line = curve.flatten_within(share, limit.saturating_sub(kept.len()))?;
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
    /// The same spline with cubics in the place of segments of a higher degree: those are halved until a cubic with the
    /// same ends and tangents is within the tolerance.
    fn in_cubics(&self, tolerance: f64) -> Result<Self, Error> {
        let mut work = WorkLimit::new(MAX_CUBICS_PER_SEGMENT.saturating_mul(self.segment_count()));
        let mut cubics = Vec::new();
        for segment in self.segments() {
            // The pieces that are left, the first one last.
            let mut rest = vec![segment];
            while let Some(piece) = rest.pop() {
                if !work.spend(1) {
                    let limit = MAX_CUBICS_PER_SEGMENT.saturating_mul(self.segment_count());
                    return Err(Error::TooMany {
                        what: "cubics of the simplified spline",
                        limit,
                        needed: limit.saturating_add(1),
                    });
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

/// The cubics between corners, each with the tangents of its own side.
fn covered<P: Point>(
    mut fit_samples: FitSamples<P>,
    tangents: &[[P; 2]],
    corners: &[usize],
) -> Vec<(usize, [P; 2])> {
    let mut cubics = Vec::new();
    for pair in corners.windows(2) {
        fit_samples.tangents[pair[0]] = tangents[pair[0]][1];
        fit_samples.tangents[pair[1]] = tangents[pair[1]][0];
        fit_samples.cover(pair[0], pair[1], &mut cubics);
    }
    cubics
}
