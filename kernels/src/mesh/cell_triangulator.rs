//! Triangulation of the cells of a patch without T-junctions.
//!
//! Where a neighbouring cell is subdivided further, its vertices lie on the cell's edges. All of them become corners of
//! the cell, which is then a polygon inside its rectangle; the triangles connect its lower left polyline with its upper
//! right one.

use crate::numeric::order::to_u32;

/// A rectangle in the parameter plane with integer coordinates: its corner (`u`, `v`) and its size `du` × `dv`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The smallest u.
    pub u: u32,
    /// The smallest v.
    pub v: u32,
    /// The length along u, at least 1.
    pub du: u32,
    /// The length along v, at least 1.
    pub dv: u32,
}

/// Marks the last vertex of a column, which has no next one.
const NONE: u32 = u32::MAX;

/// The vertices of one patch, identified by their parameters.
#[derive(Debug, Default)]
pub struct CellTriangulator {
    /// v in the upper half, u in the lower half: row by row. The number of a vertex is its index in this list.
    rows: Vec<u64>,
    /// The next vertex in the column of each vertex.
    next_in_column: Vec<u32>,
    /// The u of each column, and its last vertex so far.
    columns: Vec<u64>,
    last: Vec<u32>,
    /// The two polylines around a cell, both from its corner (u₁, v₀) to (u₀, v₁): through (u₀, v₀), and through (u₁,
    /// v₁).
    below: Vec<u32>,
    above: Vec<u32>,
    /// The segments to which the omitted triangles of the last cell degenerate.
    omitted: Vec<Segment>,
}

/// The two ends of a triangle without area.
type Segment = [[f64; 3]; 2];

/// Packs two numbers into one that sorts by the first.
pub fn pack(upper: u32, lower: u32) -> u64 {
    u64::from(upper) << 32 | u64::from(lower)
}

/// The lower 32 bits.
#[allow(
    clippy::cast_possible_truncation,
    reason = "only the lower half is needed"
)]
pub fn lower_half(key: u64) -> u32 {
    key as u32
}

/// The upper 32 bits.
pub fn upper_half(key: u64) -> u32 {
    lower_half(key >> 32)
}

/// Sorts and removes duplicates.
#[inline(never)]
pub fn sort_distinct(numbers: &mut Vec<u64>) {
    numbers.sort_unstable();
    numbers.dedup();
}

/// The index of a number in a sorted list, or its insertion index.
#[inline(never)]
pub fn index_of(sorted: &[u64], number: u64) -> usize {
    sorted.partition_point(|&other| other < number)
}

impl CellTriangulator {
    /// Replaces the vertices by all corners of the cells, which fill the square from 0 to `full`, and by additional
    /// vertices (u, v).
    pub fn fill(&mut self, cells: &[Cell], full: u32, more: impl Iterator<Item = (u32, u32)>) {
        self.rows.clear();
        self.rows.extend(more.map(|(u, v)| pack(v, u)));
        self.rows.extend([pack(0, full), pack(full, 0)]);
        self.add_cells(cells);
    }

    /// Adds the first and the last corner of each cell. Every other corner is one of these for another cell, except for
    /// two corners of the square.
    #[inline(never)]
    fn add_cells(&mut self, cells: &[Cell]) {
        for cell in cells {
            let far = pack(cell.v + cell.dv, cell.u + cell.du);
            self.rows.extend([pack(cell.v, cell.u), far]);
        }
        sort_distinct(&mut self.rows);
        self.link_columns();
    }

    /// Finds the next vertex in the column of each vertex.
    fn link_columns(&mut self) {
        let us = self.rows.iter().map(|&key| u64::from(lower_half(key)));
        self.columns.clear();
        self.columns.extend(us);
        sort_distinct(&mut self.columns);
        self.last.clear();
        self.last.resize(self.columns.len(), NONE);
        self.next_in_column.clear();
        self.next_in_column.resize(self.rows.len(), NONE);
        for (vertex, &key) in self.rows.iter().enumerate() {
            let column = index_of(&self.columns, u64::from(lower_half(key)));
            let before = std::mem::replace(&mut self.last[column], to_u32(vertex));
            if let Some(next) = self.next_in_column.get_mut(before as usize) {
                *next = to_u32(vertex);
            }
        }
    }

    /// The parameters (u, v) of all vertices, in the order of their numbers.
    pub fn vertices(&self) -> impl Iterator<Item = (u32, u32)> {
        self.rows
            .iter()
            .map(|&key| (lower_half(key), upper_half(key)))
    }

    /// The number of the vertex with a key of `rows`.
    fn of_row(&self, key: u64) -> u32 {
        to_u32(index_of(&self.rows, key))
    }

    /// The numbers of the vertices in a row from number `from` up to, but not including, the key `to`.
    fn along_row(&self, from: u32, to: u64) -> std::ops::Range<u32> {
        let after = self.rows[from as usize..].iter();
        from..from + to_u32(after.take_while(|&&key| key < to).count())
    }

    /// Appends the numbers of the vertices in a column after the vertex `from` and before v; returns that of the next one.
    fn along_column(&self, from: u32, v: u32, polyline: &mut Vec<u32>) -> u32 {
        let mut vertex = self.next_in_column[from as usize];
        while upper_half(self.rows[vertex as usize]) < v {
            polyline.push(vertex);
            vertex = self.next_in_column[vertex as usize];
        }
        vertex
    }

    /// Computes the two polylines of a cell.
    fn find_polylines(&mut self, cell: &Cell) {
        let Cell { u, v, du, dv } = *cell;
        let (far_u, far_v) = (u + du, v + dv);
        let near = self.along_row(self.of_row(pack(v, u)), pack(v, far_u));
        let mut below = std::mem::take(&mut self.below);
        below.clear();
        below.push(near.end);
        below.extend(near.clone().rev());
        let far = self.along_column(near.start, far_v, &mut below);
        let far = self.along_row(far, pack(far_v, far_u));
        below.push(far.start);
        self.below = below;
        let mut above = std::mem::take(&mut self.above);
        above.clear();
        above.push(near.end);
        self.along_column(near.end, far_v, &mut above);
        above.push(far.end);
        above.extend(far.rev());
        self.above = above;
    }

    /// Appends the triangles of a cell, counter-clockwise over (u, v), with vertex numbers that start at `base`.
    /// Triangles with two coincident corners are omitted. `points` holds the position of each vertex.
    ///
    /// A cell without additional vertices gives the two triangles of a grid cell. Returns whether the triangles cover
    /// the cell: each omitted triangle is a segment, which must be an edge of another triangle.
    #[inline(never)]
    pub fn triangulate(
        &mut self,
        cell: &Cell,
        points: &[[f64; 3]],
        base: u32,
        triangles: &mut Vec<[u32; 3]>,
    ) -> bool {
        let from = triangles.len();
        self.find_polylines(cell);
        self.zip(points, base, triangles);
        let point = |vertex: u32| points[(vertex - base) as usize];
        let edges = triangles[from..].iter().flat_map(|triangle| {
            let [a, b, c] = triangle.map(point);
            [[a, b], [b, c], [c, a]]
        });
        let is_edge =
            |&[p, q]: &Segment| edges.clone().any(|edge| edge == [p, q] || edge == [q, p]);
        self.omitted.iter().all(is_edge)
    }

    /// Connects the two polylines of the cell with triangles.
    fn zip(&mut self, points: &[[f64; 3]], base: u32, triangles: &mut Vec<[u32; 3]>) {
        let (below, above) = (&self.below[..], &self.above[..]);
        let omitted = &mut self.omitted;
        omitted.clear();
        let point = |vertex: u32| points[vertex as usize];
        let mut emit = |triangle: [u32; 3]| {
            let [a, b, c] = triangle.map(point);
            if a != b && b != c && c != a {
                triangles.push(triangle.map(|vertex| vertex + base));
            } else if a != b || b != c {
                omitted.push([a, if a == b { c } else { b }]);
            }
        };
        if let (&[a, b, c], &[_, d, _]) = (below, above)
            && point(b) == point(d)
        {
            // The two middle corners coincide: with the other diagonal the triangles have three distinct corners.
            emit([b, a, c]);
            emit([a, d, c]);
            return;
        }
        let (last_below, last_above) = (below.len() - 2, above.len() - 2);
        emit([below[1], below[0], above[1]]);
        let (mut i, mut j) = (1, 1);
        // Neither polyline reaches the common end before the last triangle, so that one never has all its corners on
        // one polyline.
        while i < last_below || j < last_above {
            let gap = |i: usize, j: usize| gap_squared(point(below[i]), point(above[j]));
            if j == last_above || (i < last_below && gap(i + 1, j) < gap(i, j + 1)) {
                emit([below[i + 1], below[i], above[j]]);
                i += 1;
            } else {
                emit([below[i], above[j], above[j + 1]]);
                j += 1;
            }
        }
        emit([below[i], above[j], below[i + 1]]);
    }

    /// The vertices around the cell that was triangulated last, counter-clockwise over (u, v).
    pub fn outline(&self) -> impl Iterator<Item = u32> + Clone {
        let back = &self.below[1..self.below.len() - 1];
        self.above.iter().chain(back.iter().rev()).copied()
    }

    /// Appends a triangle fan from a vertex inside that cell to all edges around it, as
    /// [`triangulate`](Self::triangulate) does. The fan covers the cell unless the position of the vertex coincides
    /// with one on the outline, or all positions on the outline coincide.
    pub fn fan(&self, center: u32, points: &[[f64; 3]], base: u32, triangles: &mut Vec<[u32; 3]>) {
        let next = self.outline().cycle().skip(1);
        for (from, to) in self.outline().zip(next) {
            if points[from as usize] != points[to as usize] {
                triangles.push([center, from, to].map(|vertex| vertex + base));
            }
        }
    }
}

fn gap_squared(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [x, y, z] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    x * x + y * y + z * z
}
