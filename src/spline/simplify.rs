//! Which spline of fewer segments is close enough?

use super::Spline;
use super::cubics::{Promise, Trail, ways};
use super::fit::{ROUNDING_SHARE, assemble, scale_of, scaled};
use crate::curve::{check_tolerance, ulp};
use crate::error::Error;
use crate::point::Point;

/// The polyline that stands for the spline takes this part of the tolerance.
const POLYLINE_SHARE: f64 = 1.0 / 32.0;

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
    /// # Errors
    /// As [`flatten`](Self::flatten).
    pub fn simplify(&self, tolerance: f64) -> Result<Self, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        let share = (POLYLINE_SHARE * tolerance).max(4.0 * ulp(self.max_abs()));
        let (given, tangents, corners) = self.vertices(share)?;
        let plain = self.degrees().iter().all(|&degree| degree <= 3);
        if given.len() < 2 {
            return Ok(self.clone());
        }
        let scale = scale_of(&given);
        let points = scaled(&given, scale);
        let trail = Trail {
            lengths: ways(&points),
            tangents: tangents.iter().map(|pair| pair[1]).collect(),
            points,
            promise: Promise {
                tolerance: (tolerance * (1.0 - ROUNDING_SHARE) - share) * scale,
                between: true,
            },
        };
        let cubics = covered(trail, &tangents, &corners);
        if plain && cubics.len() >= self.segment_count() {
            return Ok(self.clone());
        }
        Ok(assemble(&given, scale, &cubics, self.closed))
    }

    /// The vertices of a polyline, each once, the tangents before and after each, and the indices of corners and ends.
    #[allow(clippy::type_complexity, reason = "three lists that go together")]
    fn vertices(&self, share: f64) -> Result<(Vec<P>, Vec<[P; 2]>, Vec<usize>), Error> {
        let mut given: Vec<P> = Vec::new();
        let mut tangents: Vec<[P; 2]> = Vec::new();
        let mut corners = vec![0];
        for curve in self.segments() {
            let line = curve.flatten(share)?;
            for (k, (&p, &t)) in line.points.iter().zip(&line.ts).enumerate() {
                let tangent = curve.tangent(t);
                if given.last() != Some(&p) {
                    given.push(p);
                    tangents.push([tangent; 2]);
                } else if k == 0 && tangent != P::default() {
                    let index = tangents.len() - 1;
                    tangents[index][1] = tangent;
                    if index > 0 && (tangent - tangents[index][0]).norm() > CORNER {
                        corners.push(index);
                    }
                }
            }
        }
        corners.push(given.len() - 1);
        corners.dedup();
        Ok((given, tangents, corners))
    }
}

/// The cubics between corners, each with the tangents of its own side.
fn covered<P: Point>(
    mut trail: Trail<P>,
    tangents: &[[P; 2]],
    corners: &[usize],
) -> Vec<(usize, [P; 2])> {
    let mut cubics = Vec::new();
    for pair in corners.windows(2) {
        trail.tangents[pair[0]] = tangents[pair[0]][1];
        trail.tangents[pair[1]] = tangents[pair[1]][0];
        trail.cover(pair[0], pair[1], &mut cubics);
    }
    cubics
}
