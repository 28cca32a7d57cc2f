//! Enforcing the joint modes around a moved point.
//!
//! The joints are repaired outwards from the moved point, the nearest first, each once: the control points on the side
//! nearer to the moved point are given, the handle on the far side follows, and for C2 the point after that handle. A
//! joint is only repaired if a control point near it changed, and a point is moved only once; two fronts therefore run
//! along the spline and end where nothing has changed. On cubic segments with aligned handles they end at the next
//! joint; joints with equal second derivatives and quadratic segments propagate the change. On a closed spline the
//! fronts meet, and the mode of the joint between them may not be satisfied.

use super::Spline;
use super::joint::JointMode;
use super::joint::{Sides, catmull_rom};
use crate::geometry::check::is_within_limit;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;

/// A spline whose points are being moved, each at most once.
pub(crate) struct JointRepair<'a, P: Point, M> {
    spline: &'a mut Spline<P>,
    mode: &'a M,
    /// The state of each control point.
    states: Vec<PointState>,
}

#[derive(Clone, Copy, PartialEq)]
enum PointState {
    /// Unchanged; the point may be moved.
    Free,
    /// Unchanged; the point must not move, because a repaired joint depends on it.
    Fixed,
    Changed,
}

/// The indices of the control points around a joint, as in [`Sides`].
struct JointPoints {
    near: [usize; 2],
    joint: usize,
    far: [usize; 2],
}

impl<'a, P: Point, M: Fn(usize) -> JointMode> JointRepair<'a, P, M> {
    pub(crate) fn new(spline: &'a mut Spline<P>, mode: &'a M) -> Self {
        Self {
            states: vec![PointState::Free; spline.points.len()],
            spline,
            mode,
        }
    }

    /// Moves a point unless it must not move; returns whether the point is at `to` now.
    pub(crate) fn set_point(&mut self, index: usize, to: P) -> bool {
        let target = &mut self.spline.points[index];
        let free = self.states[index] == PointState::Free;
        // A free point that is already at `to`, or cannot move there, is fixed.
        if free && is_within_limit(to) && *target != to {
            *target = to;
            self.states[index] = PointState::Changed;
        } else if free {
            self.states[index] = PointState::Fixed;
        }
        *target == to
    }

    fn around(&self, joint: usize, forward: bool) -> JointPoints {
        let (index, count) = (self.spline.starts[joint], self.spline.points.len());
        // The indices wrap around short lists more than once.
        let behind = [1, 2].map(|k| (index + 2 * count - k) % count);
        let ahead = [1, 2].map(|k| (index + k) % count);
        let (near, far) = if forward {
            (behind, ahead)
        } else {
            (ahead, behind)
        };
        JointPoints {
            near,
            joint: index,
            far,
        }
    }

    fn sides(&self, around: &JointPoints, joint: usize, forward: bool) -> Sides<P> {
        let at = |index: usize| self.spline.points[index];
        let (before, after) = self.spline.adjacent_segments(joint);
        let (near, far) = if forward {
            (before, after)
        } else {
            (after, before)
        };
        Sides {
            near: around.near.map(at),
            joint: at(around.joint),
            far: around.far.map(at),
            near_degree: self.spline.degree_of(near),
            far_degree: self.spline.degree_of(far),
        }
    }

    /// Enforces the mode of a joint by moving its far side.
    pub(crate) fn repair(&mut self, joint: usize, forward: bool) {
        let mode = (self.mode)(joint);
        match mode {
            JointMode::Free => {}
            JointMode::Auto => self.automatic(joint),
            _ => self.move_far_side(joint, forward, mode),
        }
    }

    fn move_far_side(&mut self, joint: usize, forward: bool, mode: JointMode) {
        let around = self.around(joint, forward);
        let JointPoints { near, far, .. } = around;
        // On a closed spline of two lines or of one quadratic, the same point is on both sides.
        if near[0] == far[0] {
            return;
        }
        let mut sides = self.sides(&around, joint, forward);
        // On a closed spline of one segment, the second points can be the first points of the other side.
        let apart = near[1] != far[0] && near[1] != far[1];
        let second = mode.is_second_order() && sides.are_cubic() && apart;
        let mode = if second { mode } else { mode.of_first_order() };
        let handle = sides.far_handle(mode);
        for index in [around.joint, near[0]] {
            self.mark_fixed(index);
        }
        if second {
            self.mark_fixed(near[1]);
        }
        let is_set = self.set_point(far[0], handle);
        if is_set && mode == JointMode::C2 {
            sides.far[0] = handle;
            self.set_point(far[1], sides.second());
        }
    }

    fn mark_fixed(&mut self, index: usize) {
        if self.states[index] == PointState::Free {
            self.states[index] = PointState::Fixed;
        }
    }

    /// Sets both handles of an automatic joint from the neighbouring joints.
    fn automatic(&mut self, joint: usize) {
        let [before, here, after] = self.anchors(joint).map(|index| self.spline.points[index]);
        // The centripetal parametrization: steps are the square roots of the chords.
        let steps = [here - before, after - here].map(|chord| chord.norm().sqrt());
        let (departure, arrival) = catmull_rom([before, here, after], steps);
        let around = self.around(joint, true);
        let (left, right) = self.spline.adjacent_segments(joint);
        for (segment, handle, derivative) in [
            (left, around.near[0], -arrival),
            (right, around.far[0], departure),
        ] {
            let degree = self.spline.degree_of(segment);
            if degree > 2 {
                self.set_point(handle, here + derivative * ratio(1, degree));
            }
        }
    }

    /// The indices of the previous joint, the joint and the next joint; the ends of an open spline count as joints
    /// here.
    fn anchors(&self, joint: usize) -> [usize; 3] {
        let starts = &self.spline.starts;
        let (left, right) = self.spline.adjacent_segments(joint);
        [
            starts[left],
            starts[right],
            starts[right + 1] % self.spline.points.len(),
        ]
    }

    /// Moves both handles of a dragged joint with it, then enforces its mode.
    pub(crate) fn drag(&mut self, joint: usize, from: P) {
        let mode = (self.mode)(joint);
        if mode == JointMode::Auto {
            return self.automatic(joint);
        }
        let around = self.around(joint, true);
        let (left, right) = self.spline.adjacent_segments(joint);
        let (near, far) = (around.near[0], around.far[0]);
        let to = self.spline.points[around.joint];
        // A handle of length zero keeps that length.
        let along = |handle: P| {
            if handle == from {
                to
            } else {
                handle + (to - from)
            }
        };
        let handle = self.spline.points[far];
        // On a line the neighbouring control point is a joint itself and is not moved.
        if self.spline.degree_of(left) > 1 {
            self.set_point(near, along(self.spline.points[near]));
        }
        // The far handle is not marked as changed yet, because `move_far_side` may move it again.
        if self.spline.degree_of(right) > 1 && near != far && is_within_limit(along(handle)) {
            self.spline.points[far] = along(handle);
        }
        self.move_far_side(joint, true, mode);
        if self.spline.points[far] != handle {
            self.states[far] = PointState::Changed;
        }
    }

    /// Repairs the joints outwards from a control point with two fronts, the nearer joint first.
    pub(crate) fn repair_outwards(&mut self, index: usize) {
        let count = self.spline.points.len();
        let starts = &self.spline.starts[..self.spline.segment_count()];
        let mut remaining =
            self.spline.joints().len() - usize::from(self.spline.joint_at(index).is_some());
        let mut ahead = self.joint_from(starts.partition_point(|&start| start <= index));
        let mut behind = self.joint_before(starts.partition_point(|&start| start < index));
        while remaining > 0 {
            // The number of control points before the next joint on each side; the joint at `index` comes last.
            let distance_ahead = ahead.map(|k| (self.spline.starts[k] + count - index - 1) % count);
            let distance_behind =
                behind.map(|k| (index + count - self.spline.starts[k] - 1) % count);
            let forward = match (distance_ahead, distance_behind) {
                (Some(a), Some(b)) => a <= b,
                (Some(_), None) => true,
                (None, Some(_)) => false,
                (None, None) => return,
            };
            let front = if forward { &mut ahead } else { &mut behind };
            // The front stays `None`, and ends, unless the joint is touched.
            let Some(joint) = front.take() else { return };
            if self.is_touched(joint, forward) {
                self.repair(joint, forward);
                remaining -= 1;
                if forward {
                    ahead = self.joint_from(joint + 1);
                } else {
                    behind = self.joint_before(joint);
                }
            }
        }
    }

    /// This joint if it exists, otherwise the first joint of a closed spline.
    fn joint_from(&self, joint: usize) -> Option<usize> {
        let all = self.spline.joints();
        if all.contains(&joint) {
            return Some(joint);
        }
        self.spline.closed.then_some(0)
    }

    /// The previous joint; for the first joint of a closed spline, the last one.
    fn joint_before(&self, joint: usize) -> Option<usize> {
        let all = self.spline.joints();
        if joint > all.start {
            return Some(joint - 1);
        }
        self.spline.closed.then(|| all.end - 1)
    }

    /// Whether a control point that determines the near side of a joint has changed.
    fn is_touched(&self, joint: usize, forward: bool) -> bool {
        let around = self.around(joint, forward);
        let changed = |index: usize| self.states[index] == PointState::Changed;
        let mode = (self.mode)(joint);
        let [before, _, after] = self.anchors(joint);
        changed(around.near[0])
            || changed(around.joint)
            || mode.is_second_order() && changed(around.near[1])
            || mode == JointMode::Auto && changed(if forward { before } else { after })
    }

    /// Sets the handles at the ends of an open spline whose neighbouring joints are automatic.
    pub(crate) fn set_end_handles(&mut self) {
        let segments = self.spline.segment_count();
        if self.spline.closed || segments < 2 {
            return;
        }
        let starts = &self.spline.starts;
        let (first, last) = (starts[1], starts[segments - 1]);
        let end = starts[segments];
        for (joint, segment, [from, handle, to]) in [
            (1, 0, [0, 1, first]),
            (segments - 1, segments - 1, [end, end - 1, last]),
        ] {
            let degree = self.spline.degree_of(segment);
            let moved =
                self.states[from] == PointState::Changed || self.states[to] == PointState::Changed;
            if moved && degree > 2 && (self.mode)(joint) == JointMode::Auto {
                let (from, to) = (self.spline.points[from], self.spline.points[to]);
                self.set_point(handle, from + (to - from) * ratio(1, degree));
            }
        }
    }
}
