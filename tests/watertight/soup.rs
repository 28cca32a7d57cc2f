//! A mesh as its triangles between places: vertices at the same place, bit for bit, are one.

use casteljau::Mesh;
use casteljau::glam::DVec3;
use std::collections::HashMap;

/// Triangles between places.
pub(crate) struct Soup {
    /// Where the places are.
    pub(crate) points: Vec<DVec3>,
    /// The place of each vertex of the mesh.
    pub(crate) position_of: Vec<u32>,
    /// Three places each.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The same by vertices of the mesh.
    pub(crate) corners: Vec<[usize; 3]>,
}

/// Directed edges with a count: +1 for each triangle that runs along, −1 for each that runs against it.
pub(crate) type Corners = HashMap<(u32, u32), i32>;

impl Soup {
    pub(crate) fn new<T: Copy + Into<f64>>(mesh: &Mesh<T>) -> Self {
        let mut locations = HashMap::new();
        let mut points = Vec::new();
        let mut position_of = Vec::new();
        for p in vectors(&mesh.positions) {
            // −0 + 0 is 0: both zeros are one place.
            let key = p.to_array().map(|x| (x + 0.0).to_bits());
            let location = *locations.entry(key).or_insert_with(|| {
                points.push(p);
                u32::try_from(points.len() - 1).unwrap()
            });
            position_of.push(location);
        }
        let indices: Vec<usize> = mesh.indices.iter().collect();
        assert!(
            indices.iter().all(|&index| index < position_of.len()),
            "an index past the vertices"
        );
        let corners: Vec<[usize; 3]> = indices.as_chunks().0.to_vec();
        Self {
            points,
            triangles: corners.iter().map(|t| t.map(|v| position_of[v])).collect(),
            position_of,
            corners,
        }
    }

    /// Where the corners of a triangle are.
    pub(crate) fn corners_at(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|location| self.points[location as usize])
    }

    /// No triangle has two corners at one place.
    pub(crate) fn assert_no_collapsed_triangle(&self) {
        for &[a, b, c] in &self.triangles {
            assert!(
                a != b && b != c && c != a,
                "a triangle without three places"
            );
        }
    }

    /// Every edge has two triangles that run along it in opposite directions, or one; returns the edges with one.
    ///
    /// Two halves of a tube that one segment each must stand for lie flat on each other: then `sheets` is 2.
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
                _ => panic!(
                    "an edge with {uses:?} triangles at {}",
                    self.points[low as usize]
                ),
            }
        }
        open.sort_unstable();
        open
    }

    /// What is left of all edges of some triangles when opposite ones cancel.
    pub(crate) fn rim(triangles: &[[u32; 3]]) -> Corners {
        let mut chain = Corners::new();
        for &triangle in triangles {
            for (from, to) in edges_of(triangle) {
                add(&mut chain, from, to);
            }
        }
        chain
    }

    /// The volume inside, by the divergence theorem: Σ a · (b × c) / 6.
    pub(crate) fn volume(&self) -> f64 {
        let triangles = 0..self.triangles.len();
        let sum = triangles
            .map(|k| self.corners_at(k))
            .map(|[a, b, c]| a.dot(b.cross(c)));
        sum.sum::<f64>() / 6.0
    }

    pub(crate) fn area(&self) -> f64 {
        let triangles = 0..self.triangles.len();
        let sum = triangles
            .map(|k| self.corners_at(k))
            .map(|[a, b, c]| (b - a).cross(c - a).length());
        sum.sum::<f64>() / 2.0
    }
}

/// One more edge; opposite ones cancel, an edge from a place to itself is none.
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

/// Numbers by threes.
pub(crate) fn vectors<T: Copy + Into<f64>>(numbers: &[T]) -> impl Iterator<Item = DVec3> {
    numbers
        .as_chunks()
        .0
        .iter()
        .map(|&[x, y, z]| DVec3::new(x.into(), y.into(), z.into()))
}
