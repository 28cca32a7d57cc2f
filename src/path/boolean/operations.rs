//! Operations whose result is a region: unions, intersections, differences, faces, and measurements of a region.

use super::arrangement::Arrangement;
use super::contours::{Contour, contours};
use super::outline::push_contours;
use super::segments::Role;
use super::windings::Windings;
use crate::curve::moments::Moments;
use crate::geometry::error::Error;
use crate::path::Path;
use crate::path::winding::FillRule;

/// How [`Path::combine`] combines regions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum BooleanOperation {
    /// The points that are in at least one region.
    Union,
    /// The points that are in all regions.
    Intersect,
    /// The points that are in an odd number of regions.
    Exclude,
}

/// A face of the division of the plane by paths; see [`Path::faces`].
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Face {
    /// The face: an outer contour that runs counter-clockwise (y up), followed by its holes, which run clockwise.
    pub path: Path,
    /// For each path, whether it contains the face.
    pub inside: Vec<bool>,
}

impl Path {
    /// The union of the regions that two paths fill: the points in at least one of them.
    ///
    /// The region of a path consists of the points that its winding number and `rule` put inside; open subpaths are
    /// closed by a line, as for filling. The empty path is the empty region.
    ///
    /// The result consists of closed contours that do not cross themselves or each other; they may touch in points.
    /// Its winding numbers are 0 and 1, so both fill rules give the same region. Outer contours run counter-clockwise
    /// (y up), holes clockwise; each outer contour is followed by its holes. A segment that no other outline touches
    /// keeps its control points bit for bit, reversed where the contour runs the other way; a contour that is kept
    /// whole starts where it started. Other segments are cut where outlines meet, and only there. All numbers scaled by
    /// a power of two give the result scaled by it.
    ///
    /// Let ε be 10⁻⁹ of the larger side of the box around all control points, or 32 roundings of the largest
    /// coordinate if that is more. The boundary is within ε of the true one. Outlines that run along each other within
    /// 0.4 ε count as one, so coinciding and touching outlines need no special care; parts thinner than that may
    /// disappear. If rounding makes the winding numbers of the parts of the plane contradict each other, lines replace the
    /// segments next to the features of about this size there: between points of a grid, within 2⁻¹⁵ of the larger side
    /// of the box around all outlines, and within 2⁻²⁰ if few lines are enough. Other segments stay as they are. None of
    /// 600,000 random outlines with coordinates of one decimal needed such lines; of 300,000 outlines whose points are
    /// 10⁻¹² to 1 apart one in a thousand did.
    ///
    /// Pairs of segments are found with a tree of boxes: for n segments with k intersections the time is about
    /// (n + k) log (n + k), some microseconds for each. The union of many paths takes one call of
    /// [`combine`](Self::combine); a union with one path after the other computes all earlier contours again each time.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more than 2²² segments, more than 2²² contacts of segments, or more steps of the
    /// search for contacts than 2³⁰ and 2¹³ for each segment and each contact: only tens of thousands of long segments
    /// beside each other need as many. The same for lines that replace segments, if there are more than 2²².
    ///
    /// Source: winding numbers of the faces of a planar map, as in de Berg et al., *Computational Geometry*, §2.3 (the
    /// overlay of two subdivisions).
    ///
    /// ```
    /// use casteljau::{Path, path::FillRule};
    ///
    /// let a: Path = "M0 0H3V3H0Z".parse().expect("path data");
    /// let b: Path = "M2 1H4V2H2Z".parse().expect("path data");
    /// let union = a.union(&b, FillRule::NonZero)?;
    /// assert_eq!(union.to_string(), "M0,0 L3,0 L3,1 L4,1 L4,2 L3,2 L3,3 L0,3 Z");
    /// assert_eq!(union.area(), 10.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn union(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self, other], BooleanOperation::Union, rule)
    }

    /// The intersection of the regions that two paths fill: the points in both. See [`union`](Self::union).
    ///
    /// # Errors
    /// As [`union`](Self::union).
    pub fn intersect(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self, other], BooleanOperation::Intersect, rule)
    }

    /// The difference of the regions that two paths fill: the points of this one that are not in the other. See
    /// [`union`](Self::union).
    ///
    /// # Errors
    /// As [`union`](Self::union).
    #[doc(alias = "difference")]
    pub fn subtract(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        region(&[self, other], rule, |windings| {
            windings.is_inside(0) && !windings.is_inside(1)
        })
    }

    /// The symmetric difference of the regions that two paths fill: the points in exactly one of them. See
    /// [`union`](Self::union).
    ///
    /// # Errors
    /// As [`union`](Self::union).
    #[doc(alias = "xor")]
    pub fn exclude(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self, other], BooleanOperation::Exclude, rule)
    }

    /// Combines the regions of any number of paths at once. See [`union`](Self::union).
    ///
    /// Each path is filled by `rule` on its own. No path gives the empty path.
    ///
    /// # Errors
    /// As [`union`](Self::union).
    ///
    /// ```
    /// use casteljau::{Path, path::{BooleanOperation, FillRule}};
    ///
    /// let squares = ["M0 0H3V3H0Z", "M1 1H4V4H1Z", "M2 0H5V3H2Z"].map(|d| d.parse().expect("path data"));
    /// let common = Path::combine(&squares, BooleanOperation::Intersect, FillRule::NonZero)?;
    /// assert_eq!(common.area(), 2.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn combine<'a>(
        paths: impl IntoIterator<Item = &'a Self>,
        operation: BooleanOperation,
        rule: FillRule,
    ) -> Result<Self, Error> {
        let paths: Vec<&Self> = paths.into_iter().collect();
        region(&paths, rule, |windings| match operation {
            BooleanOperation::Union => windings.inside_count > 0,
            BooleanOperation::Intersect => {
                !paths.is_empty() && windings.inside_count == paths.len()
            }
            BooleanOperation::Exclude => windings.inside_count % 2 == 1,
        })
    }

    /// The region that the path fills, as contours that do not cross or overlap. See [`union`](Self::union), which
    /// describes the result.
    ///
    /// # Errors
    /// As [`union`](Self::union).
    ///
    /// ```
    /// use casteljau::{Path, path::FillRule};
    ///
    /// let bow_tie: Path = "M0 0L2 2V0L0 2Z".parse().expect("path data");
    /// let triangles = bow_tie.remove_overlaps(FillRule::NonZero)?;
    /// assert_eq!(triangles.subpath_count(), 2);
    /// assert_eq!(triangles.area(), 2.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn remove_overlaps(&self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self], BooleanOperation::Union, rule)
    }

    /// The bounded faces into which the outlines of paths divide the plane, and which paths contain each.
    ///
    /// Every bounded face is in the list, also those that no path contains (the hole of a ring). Faces do not overlap;
    /// neighbours share parts of outlines. Open subpaths are closed by a line. The faces are sorted by the first
    /// segment on their outer contours. See [`union`](Self::union) for the contours and for the distance within which
    /// outlines count as one.
    ///
    /// # Errors
    /// As [`union`](Self::union).
    ///
    /// ```
    /// use casteljau::{Path, path::FillRule};
    ///
    /// let paths = ["M0 0H2V2H0Z", "M1 1H3V3H1Z"].map(|d| d.parse().expect("path data"));
    /// let faces = Path::faces(&paths, FillRule::NonZero)?;
    /// let common: Vec<f64> = faces
    ///     .iter()
    ///     .filter(|face| face.inside == [true, true])
    ///     .map(|face| face.path.area())
    ///     .collect();
    /// assert_eq!((faces.len(), common), (3, vec![1.0]));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn faces<'a>(
        paths: impl IntoIterator<Item = &'a Self>,
        rule: FillRule,
    ) -> Result<Vec<Face>, Error> {
        let inputs: Vec<(&Self, Role)> = paths.into_iter().map(|p| (p, Role::Region)).collect();
        let arrangement = Arrangement::new(&inputs)?;
        let count = arrangement.faces.count;
        let mut inside = vec![Vec::new(); count];
        arrangement.visit_faces(rule, |face, windings| {
            inside[face].extend((0..inputs.len()).map(|path| windings.is_inside(path)));
        });
        let mut regions: Vec<Option<usize>> = (0..count).map(Some).collect();
        regions[arrangement.faces.outside] = None;
        let face = |(region, path): (usize, Self)| Face {
            path,
            inside: std::mem::take(&mut inside[region]),
        };
        Ok(paths_of(&arrangement, &regions)
            .into_iter()
            .map(face)
            .collect())
    }

    /// The area of the region that the path fills, each point counted once; [`area`](Self::area) counts points with
    /// their winding numbers.
    ///
    /// It is never negative. The region is that of [`remove_overlaps`](Self::remove_overlaps), and
    /// the area of it exact up to rounding.
    ///
    /// # Errors
    /// As [`union`](Self::union).
    ///
    /// ```
    /// use casteljau::{Path, path::FillRule};
    ///
    /// let squares: Path = "M0 0H2V2H0Z M1 1H4V4H1Z".parse().expect("path data");
    /// assert_eq!(squares.area(), 13.0);
    /// assert_eq!(squares.filled_area(FillRule::NonZero)?, 12.0);
    /// assert_eq!(squares.filled_area(FillRule::EvenOdd)?, 11.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn filled_area(&self, rule: FillRule) -> Result<f64, Error> {
        Ok(self.remove_overlaps(rule)?.area().max(0.0))
    }

    /// The integrals of 1, x, y, x², xy and y² over the region that the path fills, each point counted once; see
    /// [`filled_area`](Self::filled_area) and [`moments`](Self::moments).
    ///
    /// # Errors
    /// As [`union`](Self::union).
    pub fn filled_moments(&self, rule: FillRule) -> Result<Moments, Error> {
        Ok(self.remove_overlaps(rule)?.moments())
    }
}

/// The region of all points with winding numbers that satisfy a condition.
fn region(
    paths: &[&Path],
    rule: FillRule,
    is_inside: impl Fn(&Windings) -> bool,
) -> Result<Path, Error> {
    let inputs: Vec<(&Path, Role)> = paths.iter().map(|&path| (path, Role::Region)).collect();
    let arrangement = Arrangement::new(&inputs)?;
    let mut inside = vec![false; arrangement.faces.count];
    arrangement.visit_faces(rule, |face, windings| inside[face] = is_inside(windings));
    let regions = arrangement.joined_faces(&inside, |_| true);
    let mut path = Path::default();
    push_contours(&arrangement, &contours(&arrangement, &regions), &mut path);
    Ok(path)
}

/// The contours of each region as a path, with the label of the region.
pub(super) fn paths_of(arrangement: &Arrangement, regions: &[Option<usize>]) -> Vec<(usize, Path)> {
    let all = contours(arrangement, regions);
    let same_region = |a: &Contour, b: &Contour| a.region == b.region;
    let mut paths: Vec<(usize, Path)> = Vec::new();
    for own in all.chunk_by(same_region) {
        let mut path = Path::default();
        push_contours(arrangement, own, &mut path);
        if !path.is_empty() {
            paths.push((own[0].region, path));
        }
    }
    paths
}
