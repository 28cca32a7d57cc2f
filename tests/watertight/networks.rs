//! Random networks of patches: mixed degrees, edges shared in all orientations, tubes, Möbius bands, collapsed edges,
//! touching corners, three patches at an edge, patches that are curves or points, vertices listed twice.

use crate::support::Rng;
use casteljau::Surface;
use casteljau::glam::DVec3;

/// A network under construction.
struct Draft {
    vertices: Vec<DVec3>,
    nets: Vec<Net>,
}

/// The vertex indices, and the length of a row.
#[derive(Clone)]
struct Net {
    vertices: Vec<usize>,
    columns: usize,
}

/// A sheet of patches whose left and right, or lower and upper, edges may be joined.
struct Quilt {
    degrees_u: Vec<usize>,
    degrees_v: Vec<usize>,
    closed_u: bool,
    closed_v: bool,
    /// Joined with a half twist: a Möbius band.
    twisted: bool,
}

/// Changes to a network, each with some probability.
const EDITS: [fn(&mut Draft, &mut Rng); 9] = [
    Draft::collapse_side,
    Draft::merge_vertices,
    Draft::remove_patch,
    Draft::repeat_patch,
    Draft::attach_patch,
    Draft::make_curve,
    Draft::make_point,
    Draft::list_twice,
    Draft::mirror_row,
];

pub(crate) fn random(rng: &mut Rng) -> Surface {
    let mut draft = Quilt::random(rng).draft(rng);
    for edit in EDITS {
        if rng.chance(0.2) {
            edit(&mut draft, rng);
        }
    }
    for k in 0..draft.nets.len() {
        draft.turn(k, rng);
    }
    draft.surface()
}

impl Quilt {
    fn random(rng: &mut Rng) -> Self {
        let degrees = |rng: &mut Rng| -> Vec<usize> {
            let count = rng.pick(&[1, 1, 2, 2, 3]);
            let mut degree = || rng.pick(&[1, 1, 2, 2, 3, 3, 3, 4, 5]);
            (0..count).map(|_| degree()).collect()
        };
        let mut quilt = Self {
            degrees_u: degrees(rng),
            degrees_v: degrees(rng),
            closed_u: rng.chance(0.4),
            closed_v: rng.chance(0.2),
            twisted: rng.chance(0.4),
        };
        if quilt.twisted {
            let back: Vec<usize> = quilt.degrees_v.iter().rev().copied().collect();
            quilt.degrees_v.extend(back);
        }
        quilt
    }

    fn draft(&self, rng: &mut Rng) -> Draft {
        let [width, height]: [usize; 2] =
            [&self.degrees_u, &self.degrees_v].map(|d| d.iter().sum());
        let vertex = |i: usize, j: usize| {
            let around = self.closed_u && i == width;
            let j = if around && self.twisted {
                height - j
            } else {
                j
            };
            let j = if self.closed_v && j == height { 0 } else { j };
            j * (width + 1) + if around { 0 } else { i }
        };
        let mut nets = Vec::new();
        for (column, m) in steps(&self.degrees_u) {
            for (row, n) in steps(&self.degrees_v) {
                let locations = (0..=n).flat_map(|j| (0..=m).map(move |i| (i, j)));
                let vertices = locations.map(|(i, j)| vertex(column + i, row + j));
                let (vertices, columns) = (vertices.collect(), m + 1);
                nets.push(Net { vertices, columns });
            }
        }
        let count = (width + 1) * (height + 1);
        let vertices = locations(rng, count, width + 1);
        Draft { vertices, nets }
    }
}

/// The start and the length of each step.
fn steps(lengths: &[usize]) -> Vec<(usize, usize)> {
    let starts = lengths.iter().scan(0, |sum, &length| {
        *sum += length;
        Some(*sum - length)
    });
    starts.zip(lengths.iter().copied()).collect()
}

/// Positions of vertices: anywhere, near a plane sheet, on a coarse grid (many coincide), or in a plane.
fn locations(rng: &mut Rng, count: usize, columns: usize) -> Vec<DVec3> {
    let kind = rng.below(5);
    let scale = rng.magnitude(-6.0, 6.0);
    let shift = rng.point(3) * scale * rng.pick(&[0.0, 0.0, 0.0, 0.0, 100.0]);
    let mut location = |k: usize| match kind {
        0 | 1 => rng.point(3) * 2.0,
        2 => DVec3::new((k % columns) as f64, (k / columns) as f64, 0.0) + rng.point(3) * 0.4,
        3 => (rng.point(3) * 2.5).round(),
        _ => rng.point(2),
    };
    (0..count).map(|k| location(k) * scale + shift).collect()
}

impl Net {
    fn rows(&self) -> usize {
        self.vertices.len() / self.columns
    }

    fn transpose(&mut self) {
        let (columns, rows) = (self.columns, self.rows());
        let transposed = (0..columns * rows).map(|k| self.vertices[k % rows * columns + k / rows]);
        self.vertices = transposed.collect();
        self.columns = rows;
    }
}

impl Draft {
    fn any(&mut self, rng: &mut Rng) -> &mut Net {
        let at = rng.below(self.nets.len());
        &mut self.nets[at]
    }

    fn collapse_side(&mut self, rng: &mut Rng) {
        let net = self.any(rng);
        let (step, count) = rng.pick(&[(1, net.columns), (net.columns, net.rows())]);
        let side: Vec<usize> = (0..count).map(|k| net.vertices[k * step]).collect();
        let others = side[1..].iter();
        others.for_each(|&vertex| self.replace(vertex, side[0]));
    }

    fn merge_vertices(&mut self, rng: &mut Rng) {
        let count = self.vertices.len();
        self.replace(rng.below(count), rng.below(count));
    }

    fn replace(&mut self, old: usize, new: usize) {
        for vertex in self.nets.iter_mut().flat_map(|net| &mut net.vertices) {
            if *vertex == old {
                *vertex = new;
            }
        }
    }

    fn remove_patch(&mut self, rng: &mut Rng) {
        if self.nets.len() > 1 {
            self.nets.swap_remove(rng.below(self.nets.len()));
        }
    }

    fn repeat_patch(&mut self, rng: &mut Rng) {
        let net = self.any(rng).clone();
        self.nets.push(net);
    }

    /// Attaches a patch to an edge, shared or not.
    fn attach_patch(&mut self, rng: &mut Rng) {
        let net = self.any(rng).clone();
        let (columns, degree) = (net.columns, 1 + rng.below(3));
        let mut vertices = net.vertices[..columns].to_vec();
        for _ in 0..degree * columns {
            vertices.push(self.vertices.len());
            let near = rng.pick(&self.vertices);
            self.vertices.push(near + rng.point(3));
        }
        self.nets.push(Net { vertices, columns });
    }

    /// Makes a patch a curve: all rows equal the first one.
    fn make_curve(&mut self, rng: &mut Rng) {
        let net = self.any(rng);
        for k in net.columns..net.vertices.len() {
            net.vertices[k] = net.vertices[k - net.columns];
        }
    }

    fn make_point(&mut self, rng: &mut Rng) {
        let net = self.any(rng);
        let first = net.vertices[0];
        net.vertices.fill(first);
    }

    /// Gives a patch copies of its vertices, so that it is joined only by positions.
    fn list_twice(&mut self, rng: &mut Rng) {
        let at = rng.below(self.nets.len());
        for vertex in &mut self.nets[at].vertices {
            self.vertices.push(self.vertices[*vertex]);
            *vertex = self.vertices.len() - 1;
        }
    }

    /// Makes an edge equal forwards and backwards.
    fn mirror_row(&mut self, rng: &mut Rng) {
        let net = self.any(rng);
        let row = net.vertices[..net.columns].to_vec();
        for k in 0..row.len() / 2 {
            self.replace(row[row.len() - 1 - k], row[k]);
        }
    }

    /// Applies one of the eight symmetries of u and v to the patch.
    fn turn(&mut self, k: usize, rng: &mut Rng) {
        let net = &mut self.nets[k];
        if rng.chance(0.5) {
            net.transpose();
        }
        if rng.chance(0.5) {
            net.vertices.reverse();
        }
        if rng.chance(0.5) {
            let rows = net.vertices.chunks_mut(net.columns);
            rows.for_each(<[usize]>::reverse);
        }
    }

    fn surface(self) -> Surface {
        let degrees = |net: &Net| [net.columns - 1, net.rows() - 1];
        let degrees: Vec<[usize; 2]> = self.nets.iter().map(degrees).collect();
        let indices = self.nets.iter().flat_map(|net| &net.vertices);
        let indices = indices.map(|&vertex| u32::try_from(vertex).unwrap());
        let indices = indices.collect();
        Surface::with_degrees(self.vertices, indices, &degrees).unwrap()
    }
}
