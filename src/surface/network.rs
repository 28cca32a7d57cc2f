//! Surfaces: networks of patches that share control points.

use super::hash_index::joined;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::{check_points, images};
use crate::geometry::error::Error;
use crate::numeric::list::Net;
use crate::patch::tensor_product::Patch;
use crate::patch::tensor_product::{check_degree, checked_point};
use glam::{DAffine3, DVec3};
use std::ops::Range;

/// A network of Bézier patches: a list of vertices, and for each patch the indices of its control points among them.
///
/// Patches that use the same vertices along an edge stay joined when a vertex moves. A surface without patches is
/// allowed; its mesh is empty. Surfaces are immutable: every change returns a new one.
///
/// ```
/// use casteljau::{Grid, Surface, TeapotOptions};
///
/// let teapot = Surface::teapot(&TeapotOptions::default());
/// assert_eq!(teapot.patch_count(), 32);
/// let mesh = teapot.grid(Grid::from(16), false)?;
/// assert_eq!(mesh.vertex_count(), 9_248);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct Surface {
    vertices: Vec<DVec3>,
    /// For each vertex, the first vertex that had the same position when the surface was created.
    joined: Vec<u32>,
    /// The control nets of all patches, one after the other.
    indices: Vec<u32>,
    patches: Vec<PatchLayout>,
}

/// The degrees of a patch, and the position of its net in the indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct PatchLayout {
    first: usize,
    degree_u: usize,
    degree_v: usize,
}

impl PatchLayout {
    fn count(&self) -> usize {
        (self.degree_u + 1) * (self.degree_v + 1)
    }
}

impl Surface {
    /// A surface whose patches all have the same degrees, such as (3, 3) for bicubic patches.
    ///
    /// `indices` holds (`degree_u` + 1)·(`degree_v` + 1) vertex indices for each patch, u along the fast index.
    ///
    /// # Errors
    /// As [`with_degrees`](Self::with_degrees).
    pub fn new(
        vertices: Vec<DVec3>,
        indices: Vec<u32>,
        degree_u: usize,
        degree_v: usize,
    ) -> Result<Self, Error> {
        check_degree("degree_u", degree_u)?;
        check_degree("degree_v", degree_v)?;
        let count = indices.len() / ((degree_u + 1) * (degree_v + 1));
        Self::with_degrees(vertices, indices, &vec![[degree_u, degree_v]; count])
    }

    /// A surface whose patches have the given degrees `[m, n]`, one pair for each patch.
    ///
    /// `indices` holds the (m + 1)·(n + 1) vertex indices of the first patch, then those of the next.
    ///
    /// # Errors
    /// [`Error::Range`] for a degree that is not 1 to 64, [`Error::Count`] when the number of indices does not match
    /// the degrees, [`Error::Vertex`] for an index without a vertex, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a coordinate
    /// beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn with_degrees(
        vertices: Vec<DVec3>,
        indices: Vec<u32>,
        degrees: &[[usize; 2]],
    ) -> Result<Self, Error> {
        let joined = joined(&vertices);
        Self::from_parts(vertices, joined, indices, degrees)
    }

    /// A surface from vertices whose `joined` list is already known.
    pub(crate) fn from_parts(
        vertices: Vec<DVec3>,
        joined: Vec<u32>,
        indices: Vec<u32>,
        degrees: &[[usize; 2]],
    ) -> Result<Self, Error> {
        let mut first = 0;
        let mut patches = Vec::with_capacity(degrees.len());
        for &[degree_u, degree_v] in degrees {
            check_degree("degree_u", degree_u)?;
            check_degree("degree_v", degree_v)?;
            let layout = PatchLayout {
                first,
                degree_u,
                degree_v,
            };
            first += layout.count();
            patches.push(layout);
        }
        if first != indices.len() {
            return Err(Error::Count {
                what: "patches",
                expected: "(degree_u + 1)·(degree_v + 1) vertex indices for each patch",
                got: indices.len(),
            });
        }
        check_points("vertices", &vertices)?;
        let surface = Self {
            vertices,
            joined,
            indices,
            patches,
        };
        surface.check_indices()?;
        Ok(surface)
    }

    /// A surface of bicubic patches whose indices are already checked.
    pub(crate) fn bicubic(vertices: Vec<DVec3>, indices: Vec<u32>) -> Self {
        let patches = (0..indices.len() / 16)
            .map(|patch| PatchLayout {
                first: 16 * patch,
                degree_u: 3,
                degree_v: 3,
            })
            .collect();
        Self {
            joined: joined(&vertices),
            vertices,
            indices,
            patches,
        }
    }

    /// Returns an error for the first index without a vertex.
    fn check_indices(&self) -> Result<(), Error> {
        let count = self.vertices.len();
        for patch in 0..self.patches.len() {
            for &index in self.patch_indices(patch).unwrap_or_default() {
                if index as usize >= count {
                    return Err(Error::Vertex {
                        patch,
                        count,
                        got: index as usize,
                    });
                }
            }
        }
        Ok(())
    }

    /// All vertices.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// The vertex indices of all patches, one net after the other.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// The number of patches.
    pub fn patch_count(&self) -> usize {
        self.patches.len()
    }

    /// The degrees `[m, n]` of a patch; `None` if there is no such patch.
    pub fn degrees(&self, patch: usize) -> Option<[usize; 2]> {
        let layout = self.patches.get(patch)?;
        Some([layout.degree_u, layout.degree_v])
    }

    /// The vertex indices of a patch, u along the fast index; `None` if there is no such patch.
    pub fn patch_indices(&self, patch: usize) -> Option<&[u32]> {
        self.patches.get(patch)?;
        self.indices.get(self.net_range(patch))
    }

    /// Where the net of a patch is in the indices; empty if there is no such patch.
    pub(crate) fn net_range(&self, patch: usize) -> Range<usize> {
        let layout = self.patches.get(patch);
        layout.map_or(0..0, |layout| layout.first..layout.first + layout.count())
    }

    /// The patch with this index; `None` if there is no such patch.
    pub fn patch(&self, patch: usize) -> Option<Patch> {
        let columns = self.patches.get(patch)?.degree_u + 1;
        let points: Net = self.points_of(patch).collect();
        Some(Patch::from_net(points, columns))
    }

    /// The point of a patch at (u, v), see [`Patch::eval`].
    ///
    /// # Errors
    /// [`Error::Index`] for a patch that does not exist, [`Error::Count`] for a surface without patches.
    pub fn eval(&self, patch: usize, u: f64, v: f64) -> Result<DVec3, Error> {
        self.check_patch(patch)?;
        let found = self.patch(patch);
        Ok(found.map_or(DVec3::NAN, |patch| patch.eval(u, v)))
    }

    /// Returns an error for a patch that does not exist.
    pub(crate) fn check_patch(&self, patch: usize) -> Result<(), Error> {
        let last = self.patch_count().checked_sub(1).ok_or(Error::Count {
            what: "patches",
            expected: "at least 1",
            got: 0,
        })?;
        if patch <= last {
            return Ok(());
        }
        Err(Error::Index {
            what: "patch",
            first: 0,
            last,
            got: patch,
        })
    }

    /// All patches in order.
    pub fn patches(&self) -> impl Iterator<Item = Patch> {
        (0..self.patch_count()).map_while(|patch| self.patch(patch))
    }

    /// The control points of a patch; none if there is no such patch.
    pub(crate) fn points_of(&self, patch: usize) -> impl Iterator<Item = DVec3> {
        let indices = self.patch_indices(patch).unwrap_or_default();
        indices.iter().map(|&index| self.vertices[index as usize])
    }

    /// The bounding box of all control points that patches use, which contains the surface; `None` without patches.
    pub fn control_bounds(&self) -> Option<Bounds<DVec3>> {
        let mut points = self.indices.iter().map(|&i| self.vertices[i as usize]);
        let first = points.next()?;
        let start = Bounds {
            min: first,
            max: first,
        };
        Some(points.fold(start, |bounds, p| bounds.including(p)))
    }

    /// The image of the surface under an affine map.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn transform(&self, map: &DAffine3) -> Result<Self, Error> {
        Ok(Self {
            vertices: images(&self.vertices, map)?,
            ..self.clone()
        })
    }

    /// Moves one vertex, in place.
    ///
    /// All vertices that had the same position when the surface was created move together, in all patches that share
    /// them. So patches that were joined stay joined, and others do not become joined.
    ///
    /// # Errors
    /// [`Error::Count`] without vertices, [`Error::Index`] for an index without a vertex, [`Error::NotFinite`] for a
    /// target with a NaN or an infinity; the surface is then unchanged.
    pub fn move_point(&mut self, index: usize, to: DVec3) -> Result<(), Error> {
        if self.vertices.is_empty() {
            return Err(Error::Count {
                what: "vertices",
                expected: "at least 1",
                got: 0,
            });
        }
        checked_point(&mut self.vertices, index, to)?;
        // All vertices of one former position have the same entry, that of the first of them.
        let joint = self.joined[index];
        for (vertex, &joined) in self.vertices.iter_mut().zip(&self.joined) {
            if joined == joint {
                *vertex = to;
            }
        }
        Ok(())
    }

    /// The first vertex that is joined to this one.
    pub(crate) fn joined(&self, vertex: u32) -> u32 {
        self.joined.get(vertex as usize).copied().unwrap_or(vertex)
    }
}

impl Patch {
    /// A surface that consists of this patch only.
    pub(crate) fn as_surface(&self) -> Surface {
        let vertices = self.points.to_vec();
        Surface {
            joined: joined(&vertices),
            indices: (0..).take(vertices.len()).collect(),
            patches: vec![PatchLayout {
                first: 0,
                degree_u: self.degree_u(),
                degree_v: self.degree_v(),
            }],
            vertices,
        }
    }
}
