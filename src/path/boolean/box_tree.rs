//! A tree of boxes over segments, in the order of a curve that fills the plane.

use super::segments::Segments;
use crate::geometry::bounds::Bounds;
use crate::numeric::sort::sort_by;
use crate::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// The steps counted for the examination of a segment or of a pair of segments: it takes a few hundred times as long as
/// a comparison of boxes.
pub(super) const SEGMENT_STEPS: usize = 256;

/// The resolution of the grid in which centres of boxes are sorted.
const GRID_BITS: u32 = 16;

/// A binary tree in an array: node k has the children 2k and 2k + 1.
pub(super) struct BoxTree {
    boxes: Vec<[DVec2; 2]>,
    /// The segments in the order of the leaves.
    order: Vec<usize>,
}

impl BoxTree {
    /// The tree of the boxes of all segments, enlarged by a margin on each side.
    pub(super) fn new(segments: &Segments, margin: f64) -> Self {
        let order = sorted_by_place(segments);
        let leaves = order.len().next_power_of_two();
        let mut boxes = vec![[DVec2::INFINITY, DVec2::NEG_INFINITY]; 2 * leaves];
        for (leaf, &segment) in boxes[leaves..].iter_mut().zip(&order) {
            let Bounds { min, max } = segments.list[segment].bounds;
            *leaf = [min - margin, max + margin];
        }
        for k in (1..leaves).rev() {
            let [left, right] = [boxes[2 * k], boxes[2 * k + 1]];
            boxes[k] = [left[0].min(right[0]), left[1].max(right[1])];
        }
        Self { boxes, order }
    }

    fn leaves(&self) -> usize {
        self.boxes.len() / 2
    }

    /// Calls `act` once for each pair of different segments with overlapping boxes, until the work is used up.
    pub(super) fn pairs(&self, work: &mut WorkLimit, mut act: impl FnMut(usize, usize)) {
        let leaves = self.leaves();
        let size = |[min, max]: [DVec2; 2]| (max - min).max_element();
        let mut stack = vec![(1, 1)];
        while let Some((k, l)) = stack.pop() {
            if !work.spend(1) {
                return;
            }
            if k == l {
                if k < leaves {
                    let (left, right) = (2 * k, 2 * k + 1);
                    stack.extend([(left, left), (right, right), (left, right)]);
                }
                continue;
            }
            let ([min_k, max_k], [min_l, max_l]) = (self.boxes[k], self.boxes[l]);
            if min_k.cmpgt(max_l).any() || min_l.cmpgt(max_k).any() {
                continue;
            }
            match (k >= leaves, l >= leaves) {
                (true, true) => {
                    if !work.spend(SEGMENT_STEPS) {
                        return;
                    }
                    act(self.order[k - leaves], self.order[l - leaves]);
                }
                (leaf_k, leaf_l)
                    if leaf_l || !leaf_k && size(self.boxes[k]) >= size(self.boxes[l]) =>
                {
                    stack.extend([(2 * k, l), (2 * k + 1, l)]);
                }
                _ => stack.extend([(k, 2 * l), (k, 2 * l + 1)]),
            }
        }
    }

    /// Calls `act` for each segment whose box contains a point, until the work is used up.
    pub(super) fn around_point(&self, p: DVec2, work: &mut WorkLimit, mut act: impl FnMut(usize)) {
        let leaves = self.leaves();
        let mut stack = vec![1];
        while let Some(k) = stack.pop() {
            let [min, max] = self.boxes[k];
            if !work.spend(1) || p.cmplt(min).any() || p.cmpgt(max).any() {
                continue;
            }
            if k >= leaves {
                if !work.spend(SEGMENT_STEPS) {
                    return;
                }
                act(self.order[k - leaves]);
            } else {
                stack.extend([2 * k, 2 * k + 1]);
            }
        }
    }

    /// Calls `act` for each segment whose box meets the ray from p in a direction; `act` returns the length at which
    /// the ray may end.
    pub(super) fn along_ray(&self, p: DVec2, direction: DVec2, mut act: impl FnMut(usize) -> f64) {
        let leaves = self.leaves();
        let mut end = f64::INFINITY;
        let mut stack = vec![1];
        while let Some(k) = stack.pop() {
            let [min, max] = self.boxes[k];
            let (a, b) = ((min - p) / direction, (max - p) / direction);
            let (enter, leave) = (a.min(b).max_element(), a.max(b).min_element());
            if enter > leave || leave < 0.0 || enter > end || min.x > max.x {
                continue;
            }
            if k >= leaves {
                end = act(self.order[k - leaves]);
            } else {
                stack.extend([2 * k, 2 * k + 1]);
            }
        }
    }
}

/// The segments sorted by the interleaved bits of the centres of their boxes (Morton order).
fn sorted_by_place(segments: &Segments) -> Vec<usize> {
    let boxes = segments.list.iter().map(|segment| segment.bounds);
    let Some(all) = boxes.reduce(Bounds::union) else {
        return Vec::new();
    };
    let size = (all.max - all.min).max_element();
    let cells = f64::from((1_u32 << GRID_BITS) - 1) / size.max(f64::MIN_POSITIVE);
    let mut keys: Vec<(u64, usize)> = segments
        .list
        .iter()
        .enumerate()
        .map(|(k, segment)| {
            let cell = ((segment.bounds.min + segment.bounds.max) * 0.5 - all.min) * cells;
            (spread(cell.x) | spread(cell.y) << 1, k)
        })
        .collect();
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
