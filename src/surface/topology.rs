//! Topology of a surface: which patches are joined, and along which edges.
//!
//! Two edges are the same line when their control points are equal, in the same order or reversed. Patches that were
//! joined when the surface was created stay joined when a point moves. An edge whose control points are all equal is
//! collapsed: it is a point.

use super::hash_index::{HashIndex, mix};
use super::network::Surface;
use casteljau_kernels::numeric::order::to_u32;

/// The number of edges of a patch.
pub(crate) const SIDES: usize = 4;

/// An edge of a patch, by the parameter that is constant along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum PatchEdge {
    /// u = 0; it runs along v.
    U0,
    /// u = 1; it runs along v.
    U1,
    /// v = 0; it runs along u.
    V0,
    /// v = 1; it runs along u.
    V1,
}

/// One edge of one patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct EdgeUse {
    /// The index of the patch.
    pub patch: usize,
    /// The edge of the patch.
    pub edge: PatchEdge,
    /// Whether it runs against the direction of the first edge in its group of shared edges.
    pub reversed: bool,
}

/// How the patches of a surface are joined. Every edge of every patch is in exactly one of the first four lists.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Topology {
    /// Pairs of edges that are the same line.
    pub shared: Vec<Vec<EdgeUse>>,
    /// Groups of three or more edges that are the same line.
    pub non_manifold: Vec<Vec<EdgeUse>>,
    /// Edges with one patch: the boundary.
    pub open: Vec<EdgeUse>,
    /// Edges that are a point.
    pub collapsed: Vec<EdgeUse>,
    /// The patches of each connected component, joined by shared edges; each list is in ascending order.
    pub components: Vec<Vec<usize>>,
}

/// The relation of an edge to all edges of a surface, which are numbered patch · 4 + edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SideUse {
    /// The first edge that is the same line; the edge itself if no earlier one is.
    pub(crate) first: usize,
    /// Whether it runs against the direction of that first edge.
    pub(crate) reversed: bool,
    /// Whether the edge is a point.
    pub(crate) collapsed: bool,
}

impl PatchEdge {
    /// All edges in the order of their numbers.
    pub(crate) const ALL: [Self; SIDES] = [Self::U0, Self::U1, Self::V0, Self::V1];
}

impl Surface {
    /// How the patches are joined; see [`Topology`].
    ///
    /// Edges are compared by their control points, which must be equal in the same order or reversed. An edge of
    /// another degree, or a part of a longer edge, is a different line. Patches that have only isolated points in
    /// common are not connected.
    pub fn topology(&self) -> Topology {
        self.topology_of(&self.side_uses())
    }

    /// How the patches are joined if their edges have these relations.
    pub(crate) fn topology_of(&self, uses: &[SideUse]) -> Topology {
        let mut topology = Topology {
            components: self.components(uses),
            ..Topology::default()
        };
        let mut groups: Vec<Vec<EdgeUse>> = vec![Vec::new(); uses.len()];
        for (number, used) in uses.iter().enumerate() {
            let side = EdgeUse {
                patch: number / SIDES,
                edge: PatchEdge::ALL[number % SIDES],
                reversed: used.reversed,
            };
            if used.collapsed {
                topology.collapsed.push(side);
            } else {
                groups[used.first].push(side);
            }
        }
        for group in groups {
            match group.len() {
                0 => {}
                1 => topology.open.extend(group),
                2 => topology.shared.push(group),
                _ => topology.non_manifold.push(group),
            }
        }
        topology
    }

    /// The relation of each edge to all edges, by their vertices.
    pub(crate) fn side_uses(&self) -> Vec<SideUse> {
        self.side_uses_by(|_, _, _| true, |_| [0; 2])
    }

    /// The relation of each edge to all edges; see [`SideUse`]. Two edges with the same vertices are the same line if
    /// `is_same` holds for their numbers, and whether their directions differ. `keys` has two keys of an edge: the first one of an edge
    /// is a key of all edges that are the same line. So different lines with the same vertices take linear time.
    pub(crate) fn side_uses_by(
        &self,
        is_same: impl Fn(usize, usize, bool) -> bool,
        keys: impl Fn(usize) -> [u64; 2],
    ) -> Vec<SideUse> {
        let count = self.patch_count() * SIDES;
        let mut first = HashIndex::new(2 * count);
        (0..count)
            .map(|number| {
                let side = || self.side(number);
                let start = side().next();
                let collapsed = side().all(|vertex| Some(vertex) == start);
                let hash = line_hash(side(), side().count());
                let [key, other_key] = keys(number).map(|key| mix(hash, key));
                let number_u32 = to_u32(number);
                let runs_along =
                    |other: usize| side().eq(self.side(other)) && is_same(number, other, false);
                let found = first.find(number_u32, key, |other| {
                    let other = other as usize;
                    runs_along(other)
                        || side().rev().eq(self.side(other)) && is_same(number, other, true)
                });
                if found == number_u32 {
                    first.find(number_u32, other_key, |_| false);
                }
                let found = found as usize;
                SideUse {
                    first: found,
                    reversed: !runs_along(found),
                    collapsed,
                }
            })
            .collect()
    }

    /// The vertices of edge `number % 4` of patch `number / 4` in the direction of u or v; joined vertices are
    /// represented by the first of them.
    pub(crate) fn side(
        &self,
        number: usize,
    ) -> impl DoubleEndedIterator<Item = u32> + ExactSizeIterator + Clone {
        let (from, to, step) = self.side_positions(number);
        let line = self.indices().get(from..to).unwrap_or_default();
        line.iter().step_by(step).map(|&vertex| self.joined(vertex))
    }

    /// Where the indices of an edge are in those of all patches: from, to, and the step between them.
    pub(crate) fn side_positions(&self, number: usize) -> (usize, usize, usize) {
        let (patch, side) = (number / SIDES, number % SIDES);
        let net = self.net_range(patch);
        let columns = self.degrees(patch).map_or(1, |[degree_u, _]| degree_u + 1);
        let last = net.end.saturating_sub(columns);
        match side {
            0 => (net.start, net.end, columns),
            1 => (net.start + columns - 1, net.end, columns),
            2 => (net.start, net.start + columns, 1),
            _ => (last, net.end, 1),
        }
    }

    /// The connected components: lists of patches that shared edges connect.
    fn components(&self, uses: &[SideUse]) -> Vec<Vec<usize>> {
        let mut parent: Vec<usize> = (0..self.patch_count()).collect();
        for (number, used) in uses.iter().enumerate().filter(|(_, used)| !used.collapsed) {
            let a = root(&mut parent, number / SIDES);
            let b = root(&mut parent, used.first / SIDES);
            parent[a.max(b)] = a.min(b);
        }
        let mut parts: Vec<Vec<usize>> = vec![Vec::new(); parent.len()];
        for patch in 0..parent.len() {
            let part = root(&mut parent, patch);
            parts[part].push(patch);
        }
        parts.retain(|part| !part.is_empty());
        parts
    }
}

/// The first patch of the component; shortens the path to it (union–find with path halving).
fn root(parent: &mut [usize], mut patch: usize) -> usize {
    while parent[patch] != patch {
        parent[patch] = parent[parent[patch]];
        patch = parent[patch];
    }
    patch
}

/// A hash of the vertices of a line, equal for both directions.
fn line_hash(line: impl DoubleEndedIterator<Item = u32> + Clone, count: usize) -> u64 {
    let direction = |hash, vertex| mix(hash, u64::from(vertex));
    let forwards = line.clone().fold(count as u64, direction);
    let backwards = line.rev().fold(count as u64, direction);
    mix(0, forwards.wrapping_add(backwards))
}
