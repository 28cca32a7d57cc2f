//! Distance of a surface from a mesh: dense samples of the surface, compared with a tree of the mesh's triangles,
//! without knowledge of which triangle belongs to which part of a patch.

use super::soup::Soup;
use crate::support::real;
use casteljau::glam::DVec3;
use casteljau::{Patch, Surface};

/// The maximum number of triangles in a leaf of the tree.
const FEW: usize = 4;

/// A bounding box of triangles.
#[derive(Clone, Copy)]
struct Span {
    low: DVec3,
    high: DVec3,
}

/// A node of the tree: its triangles, and the index of its second child (0 for a leaf; the first child follows the
/// node).
struct Node {
    span: Span,
    from: usize,
    to: usize,
    second: usize,
}

/// A tree of triangles, split at the median along the longest axis.
pub(crate) struct Tree {
    nodes: Vec<Node>,
    triangles: Vec<[DVec3; 3]>,
}

impl Span {
    fn around(points: impl Iterator<Item = DVec3>) -> Self {
        let (low, high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        points.fold(Self { low, high }, |span, p| Self {
            low: span.low.min(p),
            high: span.high.max(p),
        })
    }

    fn distance_squared(&self, p: DVec3) -> f64 {
        (p - p.clamp(self.low, self.high)).length_squared()
    }
}

impl Tree {
    pub(crate) fn new(soup: &Soup) -> Self {
        let (nodes, triangles) = (Vec::new(), soup.all_corners().collect());
        let mut tree = Self { nodes, triangles };
        tree.build(0, tree.triangles.len());
        tree
    }

    fn build(&mut self, from: usize, to: usize) {
        let span = Span::around(self.triangles[from..to].as_flattened().iter().copied());
        let this = self.nodes.len();
        let second = 0;
        self.nodes.push(Node {
            span,
            from,
            to,
            second,
        });
        if to - from <= FEW {
            return;
        }
        let size = span.high - span.low;
        let axis = size.max_position();
        let middle = usize::midpoint(from, to);
        let at = |t: &[DVec3; 3]| t[0][axis] + t[1][axis] + t[2][axis];
        self.triangles[from..to]
            .select_nth_unstable_by(middle - from, |a, b| at(a).total_cmp(&at(b)));
        self.build(from, middle);
        self.nodes[this].second = self.nodes.len();
        self.build(middle, to);
    }

    /// The distance to the nearest triangle; `hint` is a triangle that may be near, and is set to the nearest one.
    pub(crate) fn distance(&self, p: DVec3, hint: &mut usize) -> f64 {
        self.nearest(p, hint)
            .map_or(f64::INFINITY, |q| (p - q).length())
    }

    /// The nearest point of the mesh.
    pub(crate) fn nearest(&self, p: DVec3, hint: &mut usize) -> Option<DVec3> {
        let first = self.triangles.get(*hint)?;
        let mut best = (p - nearest(p, first)).length_squared();
        let mut pending = vec![0];
        while let Some(location) = pending.pop() {
            let node = &self.nodes[location];
            if node.span.distance_squared(p) >= best {
                continue;
            }
            if node.second != 0 {
                let both = [location + 1, node.second];
                let [a, b] = both.map(|child| self.nodes[child].span.distance_squared(p));
                pending.extend(if a < b { [both[1], both[0]] } else { both });
                continue;
            }
            for k in node.from..node.to {
                let distance = (p - nearest(p, &self.triangles[k])).length_squared();
                if distance < best {
                    (best, *hint) = (distance, k);
                }
            }
        }
        Some(nearest(p, &self.triangles[*hint]))
    }
}

/// The point of a triangle nearest to p: in the plane if the projection is inside, otherwise on an edge.
fn nearest(p: DVec3, &[a, b, c]: &[DVec3; 3]) -> DVec3 {
    let normal = (b - a).cross(c - a);
    let inside = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) >= 0.0;
    let (ab, bc, ca) = (inside(a, b), inside(b, c), inside(c, a));
    if ab && bc && ca && normal.length_squared() > 0.0 {
        return p - normal * ((p - a).dot(normal) / normal.length_squared());
    }
    let ends = [on_edge(p, a, b), on_edge(p, b, c), on_edge(p, c, a)];
    let distance = |q: &DVec3| (p - *q).length_squared();
    let nearest = ends
        .into_iter()
        .min_by(|q, r| distance(q).total_cmp(&distance(r)));
    nearest.expect("three edges")
}

fn on_edge(p: DVec3, a: DVec3, b: DVec3) -> DVec3 {
    let (along, square) = (b - a, (b - a).length_squared());
    let t = ((p - a).dot(along) / square.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    a + along * t
}

/// The maximum distance of about `samples` points of the surface from the mesh, and the patch where it occurs.
pub(crate) fn greatest(surface: &Surface, soup: &Soup, samples: usize) -> (f64, usize) {
    let tree = Tree::new(soup);
    let per_line = (samples / surface.patch_count()).isqrt().max(4);
    let patches = surface.patches().enumerate();
    let distances = patches.map(|(k, patch)| (of_patch(&tree, &patch, per_line), k));
    distances.fold(
        (0.0, 0),
        |max, this| if this.0 > max.0 { this } else { max },
    )
}

fn of_patch(tree: &Tree, patch: &Patch, per_line: usize) -> f64 {
    let mut hint = 0;
    // Irrational steps, so that no regular grid misses everything between the vertices of another grid.
    let wander = |i: usize, j: usize| ((i * 7 + j * 3) as f64 * 0.618_033_988_749_894_8).fract();
    let mut max: f64 = 0.0;
    for j in 0..per_line {
        for step in 0..per_line {
            let i = if j % 2 == 0 {
                step
            } else {
                per_line - 1 - step
            };
            let u = (real(i) + wander(i, j)) / real(per_line);
            let v = (real(j) + wander(j, i)) / real(per_line);
            max = max.max(tree.distance(patch.eval(u, v), &mut hint));
        }
    }
    for k in 0..=per_line {
        let t = real(k) / real(per_line);
        for (u, v) in [(t, 0.0), (1.0, t), (t, 1.0), (0.0, t)] {
            max = max.max(tree.distance(patch.eval(u, v), &mut hint));
        }
    }
    max
}
