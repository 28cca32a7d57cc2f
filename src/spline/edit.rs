//! Moving control points and enforcing joint modes.

use super::Spline;
use super::joint::JointMode;
use super::repair::JointRepair;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::point::Point;

impl<P: Point> Spline<P> {
    /// Moves control point `index` to `to` and enforces the joint modes, in place.
    ///
    /// `mode(k)` is the mode of the joint at t = k. A dragged joint moves its two handles too, unless it is free. The
    /// handles of an automatic joint follow the neighbouring joints; so does the handle at an open end whose
    /// neighbouring joint is automatic: it lies at a third of the chord to that joint. Joints with equal second
    /// derivatives propagate a move; on cubic segments it grows nearly fourfold from joint to joint and alternates in
    /// sign.
    ///
    /// A mode is not enforced where the new point would overflow or has already been set (on a closed spline, where
    /// both directions meet). [`continuity`](Self::continuity) reports what holds.
    ///
    /// # Errors
    /// [`Error::Index`] past the last control point, [`Error::NotFinite`] for a NaN or an infinity,
    /// [`Error::NotPlane`] for [`JointMode::G2`] in space; the spline is then unchanged.
    pub fn move_point(
        &mut self,
        index: usize,
        to: P,
        mode: impl Fn(usize) -> JointMode,
    ) -> Result<(), Error> {
        if P::DIMENSION == 3 {
            self.joints().try_for_each(|k| check_plane(mode(k)))?;
        }
        self.move_point_unchecked(index, to, mode)
    }

    /// [`move_point`](Self::move_point) without the check of the dimension: the bindings store plane splines in space.
    pub(crate) fn move_point_unchecked(
        &mut self,
        index: usize,
        to: P,
        mode: impl Fn(usize) -> JointMode,
    ) -> Result<(), Error> {
        let last = self.points.len() - 1;
        if index > last {
            return Err(Error::Index {
                what: "index",
                first: 0,
                last,
                got: index,
            });
        }
        check_points("to", &[to])?;
        let from = self.points[index];
        if from == to {
            return Ok(());
        }
        let dragged = self.joint_at(index).filter(|&k| mode(k) != JointMode::Free);
        let mut repair = JointRepair::new(self, &mode);
        repair.set_point(index, to);
        if let Some(k) = dragged {
            repair.drag(k, from);
        }
        repair.repair_outwards(index);
        repair.set_end_handles();
        Ok(())
    }

    /// The spline with `mode` enforced at one joint: the handle before the joint is kept, the handle after it follows
    /// (for C2 also the control point after that handle). An automatic joint sets both handles.
    ///
    /// # Errors
    /// [`Error::Index`] unless `joint` lies between two segments, [`Error::NoJoint`] for a single open segment,
    /// [`Error::NotPlane`] for [`JointMode::G2`] in space.
    pub fn set_joint(&self, joint: usize, mode: JointMode) -> Result<Self, Error> {
        if P::DIMENSION == 3 {
            check_plane(mode)?;
        }
        self.set_joint_unchecked(joint, mode)
    }

    /// [`set_joint`](Self::set_joint) without the check of the dimension.
    pub(crate) fn set_joint_unchecked(&self, joint: usize, mode: JointMode) -> Result<Self, Error> {
        self.check_joint(joint)?;
        let of = |_| mode;
        let mut spline = self.clone();
        JointRepair::new(&mut spline, &of).repair(joint, true);
        Ok(spline)
    }

    /// The indices of all joints, where two segments meet.
    pub(crate) fn joints(&self) -> std::ops::Range<usize> {
        usize::from(!self.closed)..self.segment_count()
    }

    /// The joint at the control point with this index.
    pub(crate) fn joint_at(&self, index: usize) -> Option<usize> {
        // `starts` also contains both ends of an open spline, which are not joints.
        let found = self.starts.binary_search(&index).ok();
        found.filter(|k| self.joints().contains(k))
    }

    pub(crate) fn degree_of(&self, segment: usize) -> usize {
        self.starts[segment + 1] - self.starts[segment]
    }

    /// The segments before and after a joint.
    pub(crate) fn adjacent_segments(&self, joint: usize) -> (usize, usize) {
        let count = self.segment_count();
        ((joint + count - 1) % count, joint)
    }
}

fn check_plane(mode: JointMode) -> Result<(), Error> {
    if mode != JointMode::G2 {
        return Ok(());
    }
    Err(Error::NotPlane)
}
