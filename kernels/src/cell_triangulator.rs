//! Triangles over the cells of a patch, without T-junctions.
//!
//! Where a neighbour is cut finer, its vertices lie on the cell's sides. All of them become corners of the cell, which
//! is then a polygon inside its rectangle; triangles zip its lower left chain to its upper right one.

/// A rectangle of parameters, which are whole numbers: from (`u`, `v`) on, `du` × `dv` large.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The least u.
    pub u: u32,
    /// The least v.
    pub v: u32,
    /// The length along u, at least 1.
    pub du: u32,
    /// The length along v, at least 1.
    pub dv: u32,
}

/// The vertices of one patch by their parameters, in two orders.
#[derive(Debug, Default)]
pub struct CellTriangulator {
    /// v in the upper half, u in the lower: row by row. A vertex's number is its place here.
    rows: Vec<u64>,
    /// u in the upper half, v in the lower: column by column.
    columns: Vec<u64>,
    /// The two ways round a cell, both from its corner (u₁, v₀) to (u₀, v₁): by (u₀, v₀), and by (u₁, v₁).
    below: Vec<u32>,
    above: Vec<u32>,
    /// What the left-out triangles of the last cell are: segments.
    omitted: Vec<Segment>,
}

/// The two ends of a triangle that has no area.
type Segment = [[f64; 3]; 2];

/// Two numbers in one that sorts by the first.
pub fn pair(first: u32, second: u32) -> u64 {
    u64::from(first) << 32 | u64::from(second)
}

/// The second number of a pair.
#[allow(
    clippy::cast_possible_truncation,
    reason = "the lower half is what is wanted"
)]
pub fn second(pair: u64) -> u32 {
    pair as u32
}

/// The first number of a pair.
pub fn first(pair: u64) -> u32 {
    second(pair >> 32)
}

/// Sorts and keeps one of each.
#[inline(never)]
pub fn sort_distinct(numbers: &mut Vec<u64>) {
    numbers.sort_unstable();
    numbers.dedup();
}

/// The place of a number among sorted ones, or where it would be.
#[inline(never)]
pub fn index_of(sorted: &[u64], number: u64) -> usize {
    sorted.partition_point(|&other| other < number)
}

impl CellTriangulator {
    /// Starts anew with all corners of the cells, which fill the square from 0 to `full`, and more vertices (u, v).
    pub fn fill(&mut self, cells: &[Cell], full: u32, more: impl Iterator<Item = (u32, u32)>) {
        self.rows.clear();
        self.rows.extend(more.map(|(u, v)| pair(v, u)));
        self.rows.extend([pair(0, full), pair(full, 0)]);
        self.add_cells(cells);
    }

    /// The first and the last corner of each cell: every other one is one of these for another cell, but for two corners
    /// of the square.
    #[inline(never)]
    fn add_cells(&mut self, cells: &[Cell]) {
        for cell in cells {
            let far = pair(cell.v + cell.dv, cell.u + cell.du);
            self.rows.extend([pair(cell.v, cell.u), far]);
        }
        sort_distinct(&mut self.rows);
        let across = self.rows.iter().map(|&key| key.rotate_right(32));
        self.columns.clear();
        self.columns.extend(across);
        self.columns.sort_unstable();
    }

    /// (u, v) of all vertices in turn.
    pub fn vertices(&self) -> impl Iterator<Item = (u32, u32)> {
        self.rows.iter().map(|&key| (second(key), first(key)))
    }

    /// The number of the vertex of this key in the rows.
    fn of_row(&self, key: u64) -> u32 {
        number(index_of(&self.rows, key))
    }

    /// The numbers of the vertices in a row before the one of the key `to`, from number `from` on.
    fn along_row(&self, from: u32, to: u64) -> std::ops::Range<u32> {
        let after = self.rows[from as usize..].iter();
        from..from + number(after.take_while(|&&key| key < to).count())
    }

    /// Appends the numbers of the vertices in a column between two keys, without these.
    fn along_column(&self, from: u64, to: u64, chain: &mut Vec<u32>) {
        let after = &self.columns[index_of(&self.columns, from) + 1..];
        for key in after.iter().take_while(|&&key| key < to) {
            chain.push(self.of_row(key.rotate_right(32)));
        }
    }

    /// Sets the chains of a cell.
    fn chain(&mut self, cell: &Cell) {
        let Cell { u, v, du, dv } = *cell;
        let (far_u, far_v) = (u + du, v + dv);
        let near = self.along_row(self.of_row(pair(v, u)), pair(v, far_u));
        let far = self.along_row(self.of_row(pair(far_v, u)), pair(far_v, far_u));
        let mut below = std::mem::take(&mut self.below);
        below.clear();
        below.push(near.end);
        below.extend(near.clone().rev());
        self.along_column(pair(u, v), pair(u, far_v), &mut below);
        below.push(far.start);
        self.below = below;
        let mut above = std::mem::take(&mut self.above);
        above.clear();
        above.push(near.end);
        self.along_column(pair(far_u, v), pair(far_u, far_v), &mut above);
        above.push(far.end);
        above.extend(far.rev());
        self.above = above;
    }

    /// Appends the triangles of a cell, counter-clockwise over (u, v), with vertices numbered from `base` on; those with
    /// two corners at one place are left out. `points` tells where each vertex is.
    ///
    /// A cell without further vertices gives the two triangles of a grid's cell. Returns whether the triangles cover the
    /// cell: each left-out triangle is a segment, which has to be an edge of another triangle.
    #[inline(never)]
    pub fn triangulate(
        &mut self,
        cell: &Cell,
        points: &[[f64; 3]],
        base: u32,
        triangles: &mut Vec<[u32; 3]>,
    ) -> bool {
        let from = triangles.len();
        self.chain(cell);
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

    /// Zips the two chains of the cell.
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
            // Folded together: on the other diagonal the triangles have three corners.
            emit([b, a, c]);
            emit([a, d, c]);
            return;
        }
        let (last_below, last_above) = (below.len() - 2, above.len() - 2);
        emit([below[1], below[0], above[1]]);
        let (mut i, mut j) = (1, 1);
        // Neither chain reaches the common end before the last triangle, which so is never flat on one side.
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

    /// The vertices around the last cell that was triangulated, counter-clockwise over (u, v).
    pub fn outline(&self) -> impl Iterator<Item = u32> + Clone {
        let back = &self.below[1..self.below.len() - 1];
        self.above.iter().chain(back.iter().rev()).copied()
    }

    /// Appends triangles from a vertex inside of that cell to all edges around it, as [`triangulate`](Self::triangulate)
    /// does. They cover the cell unless the vertex is where one of the outline is, or all of these are at one point.
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

fn number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
