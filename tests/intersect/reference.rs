//! A slow reference: the unit square of both parameters is repeatedly divided into four, and a box is discarded only
//! where the two pieces are certainly apart. The remaining boxes surround all contacts.

use casteljau::Curve;
use casteljau::glam::DVec2;

/// The side of the boxes at which the search ends, as a power of two below 1.
const DEPTH: usize = 20;

/// A search with more boxes than this ends sooner: the curves overlap.
const MAX_BOXES: usize = 1500;

#[derive(Clone)]
struct Cell {
    t: f64,
    u: f64,
    a: Vec<DVec2>,
    b: Vec<DVec2>,
}

/// A connected group of boxes.
#[derive(Debug)]
pub(crate) struct Cluster {
    pub(crate) t: [f64; 2],
    pub(crate) u: [f64; 2],
    pub(crate) boxes: Vec<(f64, f64)>,
}

#[derive(Debug)]
pub(crate) struct Reference {
    pub(crate) clusters: Vec<Cluster>,
    /// The side length of a box.
    pub(crate) side: f64,
}

impl Reference {
    pub(crate) fn new(a: &Curve<DVec2>, b: &Curve<DVec2>, margin: f64) -> Self {
        let (a, b) = (a.control_points().to_vec(), b.control_points().to_vec());
        let mut cells = vec![Cell {
            t: 0.0,
            u: 0.0,
            a,
            b,
        }];
        let mut side = 1.0;
        for _ in 0..DEPTH {
            if cells.len() > MAX_BOXES {
                break;
            }
            side *= 0.5;
            cells = cells
                .iter()
                .flat_map(|cell| quarters(cell, side))
                .filter(|cell| !apart(&cell.a, &cell.b, margin))
                .collect();
        }
        Self {
            clusters: clusters(&cells, side),
            side,
        }
    }

    /// The cluster that contains a point in one of its boxes, or next to one.
    pub(crate) fn cluster_at(&self, t: f64, u: f64) -> Option<usize> {
        let near = |&(bt, bu): &(f64, f64)| {
            let within = |x: f64, from: f64| x >= from - self.side && x <= from + 2.0 * self.side;
            within(t, bt) && within(u, bu)
        };
        self.clusters.iter().position(|c| c.boxes.iter().any(near))
    }
}

fn quarters(cell: &Cell, side: f64) -> [Cell; 4] {
    let ((a0, a1), (b0, b1)) = (halves(&cell.a), halves(&cell.b));
    [
        (0.0, 0.0, &a0, &b0),
        (0.0, side, &a0, &b1),
        (side, 0.0, &a1, &b0),
        (side, side, &a1, &b1),
    ]
    .map(|(t, u, a, b)| Cell {
        t: cell.t + t,
        u: cell.u + u,
        a: a.clone(),
        b: b.clone(),
    })
}

fn halves(p: &[DVec2]) -> (Vec<DVec2>, Vec<DVec2>) {
    let (mut left, mut right) = (p.to_vec(), p.to_vec());
    for (level, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for i in 1..p.len() - level {
            right[i - 1] = (right[i - 1] + right[i]) * 0.5;
        }
    }
    (left, right)
}

/// Whether some direction separates the control points by more than the margin.
fn apart(a: &[DVec2], b: &[DVec2], margin: f64) -> bool {
    let chord = |p: &[DVec2]| (p[p.len() - 1] - p[0]).perp();
    [DVec2::X, DVec2::Y, chord(a), chord(b)].iter().any(|axis| {
        let along = axis.normalize_or_zero();
        let span = |p: &[DVec2]| {
            p.iter().fold((f64::MAX, f64::MIN), |(lo, hi), q| {
                let d = along.dot(*q);
                (lo.min(d), hi.max(d))
            })
        };
        let ((lo_a, hi_a), (lo_b, hi_b)) = (span(a), span(b));
        lo_a > hi_b + margin || lo_b > hi_a + margin
    })
}

fn clusters(cells: &[Cell], side: f64) -> Vec<Cluster> {
    let mut group: Vec<usize> = (0..cells.len()).collect();
    fn root(group: &mut [usize], mut i: usize) -> usize {
        while group[i] != i {
            group[i] = group[group[i]];
            i = group[i];
        }
        i
    }
    // Sorted by columns of t: neighbours are in the same column or in the next.
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by(|&i, &j| cells[i].t.total_cmp(&cells[j].t));
    for (k, &i) in order.iter().enumerate() {
        for &j in order[k + 1..]
            .iter()
            .take_while(|&&j| cells[j].t - cells[i].t < 1.5 * side)
        {
            if (cells[i].u - cells[j].u).abs() < 1.5 * side {
                let (a, b) = (root(&mut group, i), root(&mut group, j));
                group[a] = b;
            }
        }
    }
    let mut found: Vec<(usize, Cluster)> = Vec::new();
    for (i, cell) in cells.iter().enumerate() {
        let of = root(&mut group, i);
        let (t, u) = (cell.t, cell.u);
        let k = found.iter().position(|(g, _)| *g == of).unwrap_or_else(|| {
            let (t, u) = ([t; 2], [u; 2]);
            found.push((
                of,
                Cluster {
                    t,
                    u,
                    boxes: Vec::new(),
                },
            ));
            found.len() - 1
        });
        let cluster = &mut found[k].1;
        cluster.t = [cluster.t[0].min(t), cluster.t[1].max(t + side)];
        cluster.u = [cluster.u[0].min(u), cluster.u[1].max(u + side)];
        cluster.boxes.push((t, u));
    }
    found.into_iter().map(|(_, cluster)| cluster).collect()
}
