//! Solids of revolution: surfaces of revolution with caps.
//!
//! Caps are ruled, with the rows of control points and weights that they share with the side, so that the patches along an edge
//! have the same vertices and weights, bit for bit.

use super::RationalSurface;
use crate::bernstein::roots::{crossings, max_of};
use crate::bernstein::wronskian::Wronskian;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ratio};
use crate::numeric::list::Points;
use crate::rational::RationalCurve;
use crate::rational::nurbs::NurbsCurve;
use crate::rational::patch::RationalPatch;
use crate::rational::surface::Turning;
use crate::rational::weighted::WeightedPoint;
use glam::DVec3;
use std::f64::consts::TAU;

/// The number of points on a segment of a profile in the polygon whose centroid is the tip of the caps.
const POLYGON_POINTS: usize = 16;

/// The area below which a profile of size 1 counts as having no area.
const NO_AREA: f64 = 32.0 * f64::EPSILON;

impl RationalSurface {
    /// The solid that a profile sweeps over when it turns around an axis through `origin`, by an angle in radians:
    /// [`NurbsSurface::revolve`](crate::NurbsSurface::revolve) with caps.
    ///
    /// An end of an open profile that is not on the axis has a disk, or a sector of it. After less than a full turn there are also
    /// two caps between the profile and the axis, which consist of the perpendiculars from the profile to the axis; for a profile
    /// that ends where it starts they consist of the lines from the profile to its centroid. All edges are shared by two patches,
    /// and the normals point outwards: the volume is positive. It
    /// is that of Pappus: the angle times ½ ∫ r² dz, or times the area of a closed profile and the distance of its centroid from
    /// the axis. The time is that of
    /// [`volume`](Self::volume).
    ///
    /// Where the profile is perpendicular to the axis, these two caps have triangles without area. An angle near 0 or a profile without
    /// area gives a surface without volume, whose edges may belong to more than two patches.
    ///
    /// # Errors
    /// As [`NurbsSurface::revolve`](crate::NurbsSurface::revolve); [`Error::Range`] for less than a full turn of a profile that turns
    /// back along the axis, or around its centroid if it ends where it starts: such caps would overlap themselves; and for a profile
    /// so small, beside its distance from the axis, that rounding leaves open edges.
    ///
    /// ```
    /// use casteljau::{NurbsCurve, RationalSurface, glam::DVec3};
    /// use std::f64::consts::{PI, TAU};
    ///
    /// let side = [(1.0, 0.0, 0.0), (1.0, 0.0, 2.0)].map(DVec3::from);
    /// let side = NurbsCurve::new(1, &side, None, &[0.0, 0.0, 1.0, 1.0], false)?;
    /// let cylinder = RationalSurface::solid_of_revolution(&side, DVec3::ZERO, DVec3::Z, TAU)?;
    /// assert_eq!(cylinder.patch_count(), 12); // four of the side, four of each disk
    /// assert!((cylinder.volume().expect("closed") - 2.0 * PI).abs() < 1e-9);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn solid_of_revolution(
        profile: &NurbsCurve<DVec3>,
        origin: DVec3,
        axis: DVec3,
        angle: f64,
    ) -> Result<Self, Error> {
        let turning = Turning::new(profile, origin, axis)?;
        let (is_part, is_closed) = turning.kind(angle);
        let tip = centroid(&turning.profile);
        if is_part && is_closed {
            turning.check_around(tip)?;
        } else if is_part {
            turning.check_along()?;
        }
        let size = turning.size();
        let solid = turning.capped(tip, angle)?;
        if !solid.topology().open.is_empty() {
            return Err(Error::Range {
                what: "size of the profile",
                expected: "more than rounding errors at its distance from the axis",
                got: size,
            });
        }
        if solid.volume().is_none_or(|volume| volume >= 0.0) {
            return Ok(solid);
        }
        Turning::new(&profile.reverse(), origin, axis)?.capped(tip, angle)
    }
}

/// The ruled patch between an edge and a row of as many points, which comes first if `is_reversed`.
fn cap(line: Vec<WeightedPoint<DVec3>>, feet: &[DVec3], is_reversed: bool) -> RationalPatch {
    let columns = line.len();
    let foot = |(part, &point): (&WeightedPoint<DVec3>, &DVec3)| WeightedPoint { point, ..*part };
    let feet: Vec<_> = line.iter().zip(feet).map(foot).collect();
    let rows = if is_reversed {
        [feet, line]
    } else {
        [line, feet]
    };
    RationalPatch::from_weighted(&rows.concat(), columns)
}

impl RationalPatch {
    /// The control points along v = 0, or v = 1.
    fn row(&self, is_last: bool) -> Vec<WeightedPoint<DVec3>> {
        let columns = self.degree_u() + 1;
        let from = if is_last {
            self.degree_v() * columns
        } else {
            0
        };
        self.weighted()[from..from + columns].to_vec()
    }

    /// The control points along u = 0, or u = 1.
    fn column(&self, is_last: bool) -> Vec<WeightedPoint<DVec3>> {
        let from = if is_last { self.degree_u() } else { 0 };
        let parts = self.weighted().into_iter();
        parts.skip(from).step_by(self.degree_u() + 1).collect()
    }
}

/// Whether the edges of a patch that are not points are one line, so that the patches beside it can share that line.
fn is_line(patch: &RationalPatch) -> bool {
    let parts = patch.weighted();
    let rows = || parts.chunks(patch.degree_u() + 1);
    let is_point = |row: &[WeightedPoint<DVec3>]| row.iter().all(|part| *part == row[0]);
    rows().all(is_point)
        || rows().all(|row| row == &parts[..row.len()])
        || matches!(parts[..], [a, b, c, d] if c == d && (a == c || b == c) || a == b && (c == a || d == a))
}

impl Turning {
    /// Whether an angle is less than a full turn, and whether the profile ends where it starts.
    fn kind(&self, angle: f64) -> (bool, bool) {
        let is_closed = self.profile.start() == self.profile.end();
        (angle.abs() < TAU, is_closed)
    }

    /// The side and its caps, whose normals point outwards for a positive volume. The caps beside the side have the tip in common for a
    /// profile that ends where it starts.
    fn capped(mut self, tip: DVec3, angle: f64) -> Result<RationalSurface, Error> {
        self.level();
        let (is_part, is_closed) = self.kind(angle);
        let side = self.surface(angle)?;
        let [columns, rows] = [side.joints_u(), side.joints_v()].map(|joints| joints.len() - 1);
        let grid: Vec<&[RationalPatch]> = side.patches().chunks(columns).collect();
        let feet = self.feet()?;
        let mut patches = Vec::new();
        if is_part {
            let turned = self.arc(tip, 1.0).turned(angle)?.end();
            for (is_last, column, tip) in [(false, 0, tip), (true, columns - 1, turned)] {
                for (row, feet) in grid.iter().zip(&feet) {
                    let line = row[column].column(is_last);
                    let tips = vec![tip; line.len()];
                    let feet = if is_closed {
                        &tips[..]
                    } else {
                        feet.control_points()
                    };
                    patches.push(cap(line, feet, is_last));
                }
            }
        }
        let ends = [(0, feet[0].start()), (rows - 1, feet[rows - 1].end())];
        for (is_last, (row, center)) in [false, true].into_iter().zip(ends) {
            for patch in grid[row] {
                let line = patch.row(is_last);
                let center = vec![center; line.len()];
                let is_pole = line.iter().all(|part| part.point == line[0].point);
                if !is_closed && !is_pole {
                    patches.push(cap(line, &center, !is_last));
                }
            }
        }
        patches.extend_from_slice(side.patches());
        patches.retain(|patch| !is_line(patch));
        RationalSurface::from_patches(&patches)
    }

    /// The largest distance of a control point from the first one.
    fn size(&self) -> f64 {
        let points = self.profile.control_points();
        let distances = points.iter().map(|&p| Point::norm(p - points[0]));
        distances.fold(0.0, f64::max)
    }

    /// Moves points to the height of the point before if they differ by rounding, so that a part across the axis has one foot.
    fn level(&mut self) {
        let axis = self.axis;
        for k in 1..self.arcs.len() {
            let before = self.arcs[k - 1].center;
            let center = &mut self.arcs[k].center;
            if (*center - before).dot(axis).abs() <= self.near {
                *center = before;
            }
        }
    }

    /// The segments of the curve of the nearest points of the axis.
    fn feet(&self) -> Result<Vec<RationalCurve<DVec3>>, Error> {
        let (profile, feet) = (&self.profile, self.arcs.iter().map(|arc| arc.center));
        let feet: Vec<DVec3> = feet.collect();
        let (weights, knots) = (profile.weights(), profile.knots());
        let curve = NurbsCurve::new(profile.degree(), &feet, Some(weights), knots, false)?;
        Ok(curve.segments().to_vec())
    }

    /// Returns an error if the profile turns back along the axis.
    fn check_along(&self) -> Result<(), Error> {
        let height = |p: DVec3, q: DVec3| (q - p).dot(self.axis);
        let sign = height(self.profile.start(), self.profile.end()).signum();
        let what = "t where the profile turns back along the axis";
        self.check_forwards(what, self.near, |p, q| sign * height(p, q))
    }

    /// Returns an error if the profile turns back around a point.
    fn check_around(&self, tip: DVec3) -> Result<(), Error> {
        let points = self.profile.control_points();
        let size = points
            .iter()
            .fold(0.0, |size: f64, &p| size.max(Point::norm(p - tip)));
        let normal = Point::unit(
            points
                .windows(2)
                .map(|p| (p[0] - tip).cross(p[1] - tip))
                .sum(),
        );
        let what = "t where the profile turns back around its centroid";
        self.check_forwards(what, 2.0 * size * self.near, |p, q| {
            (p - tip).cross(q - tip).dot(normal)
        })
    }

    /// Returns an error if a quantity falls along the profile, of which `change(p, q)` is the change from a point to another one
    /// and `rounding` the error.
    ///
    /// Its derivative has the sign of the polynomial Σ wᵢ wⱼ (Bᵢ Bⱼ′ − Bᵢ′ Bⱼ) change(Pᵢ, Pⱼ) over i < j.
    fn check_forwards(
        &self,
        what: &'static str,
        rounding: f64,
        change: impl Fn(DVec3, DVec3) -> f64,
    ) -> Result<(), Error> {
        let wronskian = Wronskian::of_degree(self.profile.degree());
        for (segment, joints) in self
            .profile
            .segments()
            .iter()
            .zip(self.profile.joints().windows(2))
        {
            let (points, w) = (segment.control_points(), segment.scaled_weights());
            let rate = wronskian.coefficients(|i, j| change(points[i], points[j]) * (w[i] * w[j]));
            let slack = max_of(&wronskian.coefficients(|i, j| rounding * (w[i] * w[j])));
            // Without a change of sign the integral, the mean of the coefficients, has the sign of the rate.
            let total: f64 = rate.iter().sum();
            let falls = (total < -slack * as_f64(rate.len())).then_some(0.0);
            if let Some(t) = crossings(&rate, slack).first().copied().or(falls) {
                return Err(Error::Range {
                    what,
                    expected: "no such place for less than a full turn",
                    got: joints[0] + t * (joints[1] - joints[0]),
                });
            }
        }
        Ok(())
    }
}

/// The centroid of the area of a polygon on a closed profile; the start for a profile without area.
fn centroid(profile: &NurbsCurve<DVec3>) -> DVec3 {
    let segments = profile.segments().iter();
    let samples: Vec<DVec3> = segments
        .flat_map(|segment| (0..POLYGON_POINTS).map(|k| segment.eval(ratio(k, POLYGON_POINTS))))
        .collect();
    let start = profile.start();
    let normalized = Normalized::around(start, &samples);
    let polygon: Points<DVec3> = normalized.points(&samples);
    let sides = polygon
        .windows(2)
        .map(|side| (side[0] + side[1], side[0].cross(side[1])));
    let normal = Point::unit(sides.clone().map(|(_, area)| area).sum());
    let (moment, area) = sides.fold((DVec3::ZERO, 0.0), |(moment, total), (ends, area)| {
        let area = area.dot(normal);
        (moment + ends * area, total + area)
    });
    if area <= NO_AREA {
        return start;
    }
    start + moment / (3.0 * area * normalized.scale)
}
