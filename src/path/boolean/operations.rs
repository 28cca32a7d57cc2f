//! The public operations on regions.

use super::arrangement::Arrangement;
use super::contours::contours;
use super::outline::push_contour;
use super::segments::Role;
use super::windings::Windings;
use crate::geometry::error::Error;
use crate::path::Path;
use crate::path::winding::FillRule;

/// How [`Path::combine`] combines regions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BooleanOperation {
    /// The points in at least one region.
    Union,
    /// The points in all regions.
    Intersect,
    /// The points in an odd number of regions.
    Exclude,
}

impl Path {
    /// The union of two regions.
    pub fn union(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self, other], BooleanOperation::Union, rule)
    }

    /// The intersection of two regions.
    pub fn intersect(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self, other], BooleanOperation::Intersect, rule)
    }

    /// The points that are in exactly one of two regions.
    pub fn exclude(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self, other], BooleanOperation::Exclude, rule)
    }

    /// The points of this region that are not in another one.
    pub fn subtract(&self, other: &Self, rule: FillRule) -> Result<Self, Error> {
        region(&[self, other], rule, |windings| {
            windings.is_inside(0) && !windings.is_inside(1)
        })
    }

    /// Combines any number of regions.
    pub fn combine<'a>(
        paths: impl IntoIterator<Item = &'a Self>,
        operation: BooleanOperation,
        rule: FillRule,
    ) -> Result<Self, Error> {
        let paths: Vec<&Self> = paths.into_iter().collect();
        region(&paths, rule, |windings| match operation {
            BooleanOperation::Union => windings.inside_count > 0,
            BooleanOperation::Intersect => windings.inside_count == paths.len(),
            BooleanOperation::Exclude => windings.inside_count % 2 == 1,
        })
    }

    /// The region that the path fills, as simple contours.
    pub fn remove_overlaps(&self, rule: FillRule) -> Result<Self, Error> {
        Self::combine([self], BooleanOperation::Union, rule)
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
    let regions = arrangement.joined_faces(|a, b| inside[a] && inside[b], &inside);
    Ok(path_of(&arrangement, &regions))
}

/// The contours of all regions.
fn path_of(arrangement: &Arrangement, regions: &[usize]) -> Path {
    let mut path = Path::default();
    for contour in contours(arrangement, regions) {
        push_contour(arrangement, &contour.half_edges, &mut path);
    }
    path
}
