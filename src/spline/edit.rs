//! Moving points while the joints keep what they promise.
//!
//! The point goes where it was told. Then the joints are repaired outwards, the nearest first, each once: the side
//! that is nearer to the moved point is given, the handle on the far side follows. A joint is only touched if
//! something near it changed, so on cubic segments the repair ends at once, and on quadratic ones it may run along the
//! chain; on a closed chain it stops where both runs meet.

use super::{JointMode, Spline};
use crate::curve::{check_finite, ratio};
use crate::error::Error;
use crate::point::Point;

/// The control points around a joint, as indices.
#[derive(Clone, Copy)]
struct Around {
    before: usize,
    joint: usize,
    after: usize,
}

impl<P: Point> Spline<P> {
    /// The spline with control point `index` at `to`, the joints repaired.
    ///
    /// `mode(k)` is the mode of the joint at t = k. A joint that is dragged takes its two handles along, unless it is
    /// free.
    ///
    /// # Errors
    /// [`Error::Index`] past the last control point, [`Error::NotFinite`] for a NaN or an infinity.
    pub fn move_point(
        &self,
        index: usize,
        to: P,
        mode: impl Fn(usize) -> JointMode,
    ) -> Result<Self, Error> {
        let last = self.points.len() - 1;
        if index > last {
            return Err(Error::Index {
                what: "index",
                first: 0,
                last,
                got: index,
            });
        }
        check_finite("to", &[to])?;
        let mut moved = self.clone();
        let mut changed = vec![false; self.points.len()];
        moved.put(index, to, &mut changed);
        let dragged = self.joints().find(|&k| self.starts[k] == index);
        if let Some(k) = dragged.filter(|&k| mode(k) != JointMode::Free) {
            moved.take_along(k, to - self.points[index], mode(k), &mut changed);
        }
        moved.repair(index, dragged, &mode, &mut changed);
        Ok(moved)
    }

    /// The spline with a joint made what `mode` asks: the handle before it is kept, the one after it follows.
    ///
    /// # Errors
    /// [`Error::Index`] unless `joint` lies between two segments.
    pub fn set_joint(&self, joint: usize, mode: JointMode) -> Result<Self, Error> {
        self.check_joint(joint)?;
        let mut set = self.clone();
        let around = self.around(joint);
        set.points[around.after] = self.followed(around, joint, true, mode);
        Ok(set)
    }

    /// The joints: where two segments meet.
    fn joints(&self) -> std::ops::Range<usize> {
        usize::from(!self.closed)..self.segment_count()
    }

    fn around(&self, joint: usize) -> Around {
        let index = self.starts[joint];
        let count = self.points.len();
        Around {
            before: (index + count - 1) % count,
            joint: index,
            after: (index + 1) % count,
        }
    }

    /// Where the handle after a joint (or before it) belongs, the other one given.
    fn followed(&self, around: Around, joint: usize, forward: bool, mode: JointMode) -> P {
        let degrees = |k: usize| self.starts[k + 1] - self.starts[k];
        let (after, before) = (
            degrees(joint),
            degrees((joint + self.segment_count() - 1) % self.segment_count()),
        );
        let Around {
            before: b,
            joint: j,
            after: a,
        } = around;
        if a == b {
            // A ring of two lines, or of one quadratic: one point cannot lie on both sides.
            return self.points[a];
        }
        let (near, far, near_degree, far_degree) = if forward {
            (b, a, before, after)
        } else {
            (a, b, after, before)
        };
        mode.follow(
            self.points[near],
            self.points[j],
            self.points[far],
            ratio(near_degree, far_degree),
        )
    }

    fn put(&mut self, index: usize, to: P, changed: &mut [bool]) {
        if !changed[index] && to.is_finite() {
            changed[index] = self.points[index] != to;
            self.points[index] = to;
        }
    }

    /// Moves both handles of a dragged joint with it.
    fn take_along(&mut self, joint: usize, by: P, mode: JointMode, changed: &mut [bool]) {
        let around = self.around(joint);
        // On lines the neighbour is a joint itself and stays.
        for (handle, segment) in [
            (around.before, joint + self.segment_count() - 1),
            (around.after, joint),
        ] {
            let segment = segment % self.segment_count();
            if self.starts[segment + 1] - self.starts[segment] > 1 {
                self.put(handle, self.points[handle] + by, changed);
            }
        }
        let follow = self.followed(around, joint, true, mode);
        self.points[around.after] = if follow.is_finite() {
            follow
        } else {
            self.points[around.after]
        };
    }

    fn repair(
        &mut self,
        index: usize,
        done: Option<usize>,
        mode: &impl Fn(usize) -> JointMode,
        changed: &mut [bool],
    ) {
        for (joint, forward) in self.joints_outward(index, done) {
            let around = self.around(joint);
            let near = if forward { around.before } else { around.after };
            if changed[near] || changed[around.joint] {
                let far = if forward { around.after } else { around.before };
                let follow = self.followed(around, joint, forward, mode(joint));
                self.put(far, follow, changed);
            }
        }
    }

    /// The joints by distance from a control point, each with whether it lies ahead of it.
    ///
    /// Around a closed chain both runs would reach every joint; each is taken by the run that is there first.
    fn joints_outward(&self, index: usize, done: Option<usize>) -> Vec<(usize, bool)> {
        let joints: Vec<usize> = self.joints().filter(|&k| Some(k) != done).collect();
        let (all, count) = (joints.len(), self.points.len());
        let split = joints.partition_point(|&k| self.starts[k] <= index);
        let (last_ahead, last_behind) = if self.closed {
            (all, all)
        } else {
            (all - split, split)
        };
        let mut order = Vec::with_capacity(all);
        let (mut ahead, mut behind) = (0, 0);
        while order.len() < all {
            let next = joints[(split + ahead) % all];
            let last = joints[(split + all - 1 - behind) % all];
            let distance_ahead = (self.starts[next] + count - index) % count;
            let distance_behind = (index + count - self.starts[last]) % count;
            let forward =
                ahead < last_ahead && (behind >= last_behind || distance_ahead <= distance_behind);
            if forward {
                ahead += 1;
            } else {
                behind += 1;
            }
            order.push((if forward { next } else { last }, forward));
        }
        order
    }
}
