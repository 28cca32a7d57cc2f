//! A mesh as a triangle soup: vertices with bit-identical positions are merged.

use crate::support::nets::triangles;
pub(crate) use crate::support::nets::vectors;
use casteljau::Mesh;
use casteljau::glam::DVec3;
use std::collections::HashMap;

/// Triangles between distinct positions.
pub(crate) struct Soup {
    /// The distinct positions.
    pub(crate) points: Vec<DVec3>,
    /// The index of the position of each vertex of the mesh.
    pub(crate) position_of: Vec<u32>,
    /// Three indices of positions for each triangle.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The triangles as vertex indices of the mesh.
    pub(crate) corners: Vec<[usize; 3]>,
}

/// Directed edges with a count: +1 for each triangle that traverses the edge forwards, −1 for each that traverses it
/// backwards.
pub(crate) type Corners = HashMap<(u32, u32), i32>;

impl Soup {
    pub(crate) fn new<T: Copy + Into<f64>>(mesh: &Mesh<T>) -> Self {
        let mut locations = HashMap::new();
        let mut points = Vec::new();
        let mut position_of = Vec::new();
        for p in vectors(&mesh.positions) {
            // −0 + 0 is 0, so both zeros count as equal.
            let key = p.to_array().map(|x| (x + 0.0).to_bits());
            let location = *locations.entry(key).or_insert_with(|| {
                points.push(p);
                u32::try_from(points.len() - 1).unwrap()
            });
            position_of.push(location);
        }
        let corners = triangles(mesh);
        Self {
            points,
            triangles: corners.iter().map(|t| t.map(|v| position_of[v])).collect(),
            position_of,
            corners,
        }
    }

    /// The positions of the corners of a triangle.
    pub(crate) fn corners_at(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|location| self.points[location as usize])
    }

    /// Asserts that no triangle has two corners at the same position.
    pub(crate) fn assert_no_collapsed_triangle(&self) {
        for &[a, b, c] in &self.triangles {
            assert!(a != b && b != c && c != a, "corners at one place");
        }
    }

    /// Asserts that every edge has two triangles that traverse it in opposite directions, or one; returns the edges
    /// with one.
    ///
    /// Two halves of a tube that are represented by one segment each lie flat on each other: then `sheets` is 2.
    #[track_caller]
    pub(crate) fn boundary(&self, sheets: u32) -> Vec<(u32, u32)> {
        let mut edges: HashMap<(u32, u32), [u32; 2]> = HashMap::new();
        for &triangle in &self.triangles {
            for (from, to) in edges_of(triangle) {
                let along = usize::from(from > to);
                edges.entry((from.min(to), from.max(to))).or_default()[along] += 1;
            }
        }
        let mut open = Vec::new();
        for ((low, high), uses) in edges {
            match uses {
                [a, b] if a == b && a <= sheets => {}
                [1, 0] => open.push((low, high)),
                [0, 1] => open.push((high, low)),
                _ => panic!("{uses:?} triangles at {}", self.points[low as usize]),
            }
        }
        open.sort_unstable();
        open
    }

    /// The edges of some triangles that remain when opposite edges cancel.
    pub(crate) fn rim(triangles: &[[u32; 3]]) -> Corners {
        let mut chain = Corners::new();
        for &triangle in triangles {
            for (from, to) in edges_of(triangle) {
                add(&mut chain, from, to);
            }
        }
        chain
    }

    /// The positions of the corners of all triangles.
    pub(crate) fn all_corners(&self) -> impl Iterator<Item = [DVec3; 3]> {
        (0..self.triangles.len()).map(|k| self.corners_at(k))
    }

    /// The enclosed volume, by the divergence theorem: Σ a · (b × c) / 6.
    pub(crate) fn volume(&self) -> f64 {
        let parts = self.all_corners().map(|[a, b, c]| a.dot(b.cross(c)));
        parts.sum::<f64>() / 6.0
    }

    pub(crate) fn area(&self) -> f64 {
        self.all_corners().map(area).sum()
    }
}

pub(crate) fn area([a, b, c]: [DVec3; 3]) -> f64 {
    (b - a).cross(c - a).length() / 2.0
}

/// Adds an edge; opposite edges cancel, and an edge from a position to itself is ignored.
pub(crate) fn add(chain: &mut Corners, from: u32, to: u32) {
    if from == to {
        return;
    }
    let sense = if from < to { 1 } else { -1 };
    let key = (from.min(to), from.max(to));
    let count = chain.entry(key).or_default();
    *count += sense;
    if *count == 0 {
        chain.remove(&key);
    }
}

pub(crate) fn edges_of([a, b, c]: [u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}
