//! Moving points while the joints keep what they promise.

use super::Spline;
use super::joint::JointMode;
use super::repair::Edit;
use crate::geometry::check::check_finite;
use crate::geometry::error::Error;
use crate::geometry::point::Point;

impl<P: Point> Spline<P> {
    /// The spline with control point `index` at `to`, the joints repaired.
    ///
    /// `mode(k)` is the mode of the joint at t = k. A joint that is dragged takes its two handles along, unless it is
    /// free. Handles of automatic joints follow the joints beside them; so does the handle at an open end whose
    /// neighbour is automatic, a third of the way there. Joints with equal second derivatives pass a move on, in
    /// cubic segments nearly four times as large from joint to joint and with the other sign.
    ///
    /// What cannot be held is not held: where the point would overflow, or was placed before (on a closed chain, where
    /// both ways around meet). [`continuity`](Self::continuity) tells.
    ///
    /// # Errors
    /// [`Error::Index`] past the last control point, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Range`] for
    /// [`JointMode::G2`] in space.
    pub fn move_point(
        &self,
        index: usize,
        to: P,
        mode: impl Fn(usize) -> JointMode,
    ) -> Result<Self, Error> {
        if P::DIMENSION == 3 {
            self.joints().try_for_each(|k| check_plane(mode(k)))?;
        }
        self.moved(index, to, mode)
    }

    /// The same without a look at the dimension: the bindings keep plane splines in space.
    pub(crate) fn moved(
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
        if self.points[index] == to {
            return Ok(self.clone());
        }
        let mut edit = Edit::new(self.clone(), &mode);
        edit.set_point(index, to);
        let dragged = self.joint_at(index).filter(|&k| mode(k) != JointMode::Free);
        if let Some(k) = dragged {
            edit.drag(k, self.points[index]);
        }
        edit.spread(index);
        edit.ends();
        Ok(edit.done())
    }

    /// The spline with a joint made what `mode` asks: the handle before it is kept, the one after it follows (for C2 the
    /// point behind that one too). Automatic handles are set on both sides.
    ///
    /// # Errors
    /// [`Error::Index`] unless `joint` lies between two segments, [`Error::Range`] for [`JointMode::G2`] in space.
    pub fn set_joint(&self, joint: usize, mode: JointMode) -> Result<Self, Error> {
        if P::DIMENSION == 3 {
            check_plane(mode)?;
        }
        self.joint_set(joint, mode)
    }

    /// The same without a look at the dimension.
    pub(crate) fn joint_set(&self, joint: usize, mode: JointMode) -> Result<Self, Error> {
        self.check_joint(joint)?;
        let of = |_| mode;
        let mut edit = Edit::new(self.clone(), &of);
        edit.repair(joint, true);
        Ok(edit.done())
    }

    /// The joints: where two segments meet.
    pub(crate) fn joints(&self) -> std::ops::Range<usize> {
        usize::from(!self.closed)..self.segment_count()
    }

    /// The joint whose point has this index.
    pub(crate) fn joint_at(&self, index: usize) -> Option<usize> {
        let found = self.starts.binary_search(&index).ok();
        found.filter(|k| self.joints().contains(k))
    }

    pub(crate) fn degree_of(&self, segment: usize) -> usize {
        self.starts[segment + 1] - self.starts[segment]
    }

    /// The segments before and after a joint.
    pub(crate) fn beside(&self, joint: usize) -> (usize, usize) {
        let count = self.segment_count();
        ((joint + count - 1) % count, joint)
    }
}

fn check_plane(mode: JointMode) -> Result<(), Error> {
    if mode != JointMode::G2 {
        return Ok(());
    }
    Err(Error::Range {
        what: "mode",
        expected: "a spline of dimension 2 for G2",
        got: 3.0,
    })
}
