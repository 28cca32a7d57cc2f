//! A tree of boxes: finds the pairs of items whose boxes overlap, and the items at a point or along a ray.
//!
//! The items are the leaves of a binary tree, in the order of a curve that fills the plane, so that neighbours in the
//! tree are close in the plane. Source: Morton, "A computer oriented geodetic data base" (IBM, 1966), for the order.

use super::bounds::Bounds;
use crate::numeric::sort::sort_by;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// The resolution of the grid in which centres of boxes are sorted.
const GRID_BITS: u32 = 16;

/// A binary tree in an array: node k has the children 2k and 2k + 1.
pub(crate) struct BoxTree {
    boxes: Vec<Bounds<DVec2>>,
    /// The items in the order of the leaves.
    order: Vec<usize>,
}

impl BoxTree {
    /// The tree of the boxes of items, whose numbers are those of the list.
    pub(crate) fn new(items: &[Bounds<DVec2>]) -> Self {
        let order = sorted_by_place(items);
        let leaves = order.len().next_power_of_two();
        let mut boxes = vec![NOTHING; 2 * leaves];
        for (leaf, &item) in boxes[leaves..].iter_mut().zip(&order) {
            *leaf = items[item];
        }
        for k in (1..leaves).rev() {
            boxes[k] = boxes[2 * k].union(boxes[2 * k + 1]);
        }
        Self { boxes, order }
    }

    fn leaves(&self) -> usize {
        self.boxes.len() / 2
    }

    /// Calls `act` once for each pair of different items with overlapping boxes, until the work is used up. A comparison
    /// of boxes is one step; `act` counts its own.
    pub(crate) fn pairs_within(
        &self,
        work: &mut WorkLimit,
        mut act: impl FnMut(usize, usize, &mut WorkLimit),
    ) {
        let mut stack = vec![(1, 1)];
        while let Some((k, l)) = stack.pop() {
            if !work.spend(1) {
                return;
            }
            if k != l {
                self.descend(self, (k, l), &mut stack, |i, j| act(i, j, work));
            } else if k < self.leaves() {
                let (left, right) = (2 * k, 2 * k + 1);
                stack.extend([(left, left), (right, right), (left, right)]);
            }
        }
    }

    /// Calls `act` for each item of this tree and each one of another tree with overlapping boxes, until the work is used
    /// up. A comparison of boxes is one step.
    pub(crate) fn pairs_with(
        &self,
        other: &Self,
        work: &mut WorkLimit,
        mut act: impl FnMut(usize, usize),
    ) {
        let mut stack = vec![(1, 1)];
        while let Some(pair) = stack.pop() {
            if !work.spend(1) {
                return;
            }
            self.descend(other, pair, &mut stack, &mut act);
        }
    }

    /// Compares a node of this tree with one of another: calls `act` for two items, and otherwise appends the pairs with
    /// the children of the larger node.
    fn descend(
        &self,
        other: &Self,
        (k, l): (usize, usize),
        stack: &mut Vec<(usize, usize)>,
        act: impl FnOnce(usize, usize),
    ) {
        let (a, b) = (self.boxes[k], other.boxes[l]);
        if a.min.cmpgt(b.max).any() || b.min.cmpgt(a.max).any() {
            return;
        }
        let is_leaf = (k >= self.leaves(), l >= other.leaves());
        if is_leaf == (true, true) {
            // Leaves without an item overlap nothing, unless a box is infinite.
            let items = [(self, k), (other, l)].map(|(tree, k)| tree.order.get(k - tree.leaves()));
            if let [Some(&i), Some(&j)] = items {
                act(i, j);
            }
        } else if is_leaf.1 || !is_leaf.0 && size(a) >= size(b) {
            stack.extend([(2 * k, l), (2 * k + 1, l)]);
        } else {
            stack.extend([(k, 2 * l), (k, 2 * l + 1)]);
        }
    }
}

#[cfg(feature = "regions")]
impl BoxTree {
    /// Calls `act` for each item whose box contains a point, until the work is used up. A comparison is one step.
    pub(crate) fn around_point(
        &self,
        p: DVec2,
        work: &mut WorkLimit,
        act: impl FnMut(usize, &mut WorkLimit),
    ) {
        let contains =
            |bounds: &Bounds<DVec2>| !(p.cmplt(bounds.min).any() || p.cmpgt(bounds.max).any());
        self.matching(contains, work, act);
    }

    /// Calls `act` for each item whose box matches, until the work is used up. A comparison is one step. A box matches if
    /// one in it does.
    pub(crate) fn matching(
        &self,
        matches: impl Fn(&Bounds<DVec2>) -> bool,
        work: &mut WorkLimit,
        mut act: impl FnMut(usize, &mut WorkLimit),
    ) {
        let mut stack = vec![1];
        while let Some(k) = stack.pop() {
            if !work.spend(1) || !matches(&self.boxes[k]) {
                continue;
            }
            if k < self.leaves() {
                stack.extend([2 * k, 2 * k + 1]);
            } else if let Some(&item) = self.order.get(k - self.leaves()) {
                act(item, work);
            }
        }
    }

    /// Lowers a distance to that of the nearest item of all that are closer to a point, until the work is used up. A
    /// comparison is one step.
    pub(crate) fn within(
        &self,
        p: DVec2,
        distance: &mut f64,
        work: &mut WorkLimit,
        distance_of: impl Fn(usize) -> f64,
    ) {
        let to_box = |k: usize| self.boxes[k].distance(p);
        let mut stack = vec![(1, to_box(1))];
        while let Some((k, to_box_of_k)) = stack.pop() {
            if !work.spend(1) || to_box_of_k >= *distance {
                continue;
            }
            if k < self.leaves() {
                // The nearer child is examined first.
                let mut children = [2 * k, 2 * k + 1].map(|child| (child, to_box(child)));
                if children[0].1 < children[1].1 {
                    children.reverse();
                }
                stack.extend(children);
            } else if let Some(&item) = self.order.get(k - self.leaves()) {
                *distance = distance.min(distance_of(item));
            }
        }
    }

    /// Calls `act` for each item whose box meets the ray from p in a direction, which is not along an axis; `act` returns
    /// the length at which the ray may end.
    pub(crate) fn along_ray(&self, p: DVec2, direction: DVec2, mut act: impl FnMut(usize) -> f64) {
        debug_assert!(
            direction.cmpne(DVec2::ZERO).all(),
            "0/0 at the sides of boxes"
        );
        let mut end = f64::INFINITY;
        let mut stack = vec![1];
        while let Some(k) = stack.pop() {
            let Bounds { min, max } = self.boxes[k];
            let (a, b) = ((min - p) / direction, (max - p) / direction);
            let (enter, leave) = (a.min(b).max_element(), a.max(b).min_element());
            if enter > leave || leave < 0.0 || enter > end || min.x > max.x {
                continue;
            }
            if k < self.leaves() {
                stack.extend([2 * k, 2 * k + 1]);
            } else if let Some(&item) = self.order.get(k - self.leaves()) {
                end = act(item);
            }
        }
    }
}

/// The box that contains no point.
const NOTHING: Bounds<DVec2> = Bounds {
    min: DVec2::INFINITY,
    max: DVec2::NEG_INFINITY,
};

fn size(bounds: Bounds<DVec2>) -> f64 {
    (bounds.max - bounds.min).max_element()
}

/// The items sorted by the interleaved bits of the centres of their boxes (Morton order).
fn sorted_by_place(items: &[Bounds<DVec2>]) -> Vec<usize> {
    let center = |bounds: &Bounds<DVec2>| bounds.min * 0.5 + bounds.max * 0.5;
    let (min, max) = items
        .iter()
        .map(center)
        .fold((NOTHING.min, NOTHING.max), |(min, max), p| {
            (min.min(p), max.max(p))
        });
    let width = (max - min).max_element();
    let cells = f64::from((1_u32 << GRID_BITS) - 1) / width.max(f64::MIN_POSITIVE);
    let mut keys: Vec<(u64, usize)> = Vec::with_capacity(items.len());
    keys.extend(items.iter().enumerate().map(|(k, bounds)| {
        let cell = (center(bounds) - min) * cells;
        (spread(cell.x) | spread(cell.y) << 1, k)
    }));
    sort_by(&mut keys, |a, b| a.cmp(b));
    keys.into_iter().map(|(_, k)| k).collect()
}

/// The bits of a cell number, with a 0 before each.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a cell number is from 0 to 2^16 − 1; larger ones are clamped"
)]
fn spread(cell: f64) -> u64 {
    let mut bits = cell.clamp(0.0, f64::from((1_u32 << GRID_BITS) - 1)) as u64;
    for shift in [8, 4, 2, 1] {
        let mask = u64::MAX / ((1 << shift) + 1);
        bits = (bits | bits << shift) & mask;
    }
    bits
}
