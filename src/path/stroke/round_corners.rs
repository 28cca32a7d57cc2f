//! Corners of a path replaced by arcs.

use super::has_size;
use super::tangent_circle::{CornerArc, corner_arc};
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::path::{Path, Subpath};
use crate::spline::offset::offset_curve::add_arc;
use glam::DVec2;

/// The largest distance of the cubics from an arc, as a part of its radius.
const ARC_TOLERANCE: f64 = 1e-9;

/// Two arcs meet if at most this part of the parameters of a segment is between them.
const MEETS: f64 = 1e-12;

impl Path {
    /// The path with its corners replaced by arcs of a radius that are tangent to both segments at the corner.
    ///
    /// A corner is a joint where the tangent turns by 0.06° to 179.94°; other joints stay, and so do the ends of open
    /// subpaths. A closed subpath is rounded at its start, too, and then starts at the end of that arc. At straight
    /// segments that turn by θ the arc starts r tan(θ/2) before the corner. At curves its centre is the intersection of
    /// their offset curves at the distance r that is reached from the corner as the radius grows from 0. Arcs are cubics
    /// within 10⁻⁹ of their radius. Segments without a corner are returned bit for bit.
    ///
    /// An arc replaces at most the two segments at its corner. Where these are too short, or bend more tightly than the
    /// arc, the radius at this corner is the largest one that fits. Where the arcs at both ends of a segment overlap,
    /// each ends in the middle of the segment (t = ½) at the latest. Segments of length 0 at a rounded corner are
    /// omitted. A corner stays if its radius is below 10⁻⁹ of the size of its segments. A radius of 0 returns the path.
    ///
    /// ```
    /// use casteljau::Path;
    ///
    /// let square: Path = "M0 0H10V10H0Z".parse().expect("path data");
    /// let area = square.round_corners(2.0)?.area();
    /// assert!((area - (100.0 - (4.0 - std::f64::consts::PI) * 4.0)).abs() < 1e-7);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a radius that is negative or not finite.
    pub fn round_corners(&self, radius: f64) -> Result<Self, Error> {
        if !(radius >= 0.0 && radius.is_finite()) {
            return Err(Error::Range {
                what: "radius",
                expected: "a finite number, at least 0",
                got: radius,
            });
        }
        if radius == 0.0 {
            return Ok(self.clone());
        }
        let mut path = Self::default();
        for part in self.parts() {
            RoundedSubpath::new(part, radius).push_to(&mut path);
        }
        Ok(path)
    }
}

/// A subpath and the arcs at its corners.
struct RoundedSubpath<'a> {
    part: Subpath<'a>,
    /// The segments that are not points.
    curves: Vec<Curve<DVec2>>,
    /// The arc at the end of each of these segments.
    arcs: Vec<Option<CornerArc>>,
}

impl<'a> RoundedSubpath<'a> {
    fn new(part: Subpath<'a>, radius: f64) -> Self {
        let segments = part.segments().map(Curve::from_slice);
        let curves: Vec<Curve<DVec2>> = segments.filter(has_size).collect();
        let mut rounded = Self {
            part,
            arcs: vec![None; curves.len()],
            curves,
        };
        let mut limits = vec![[1.0; 2]; rounded.curves.len()];
        for k in 0..rounded.curves.len() {
            rounded.arcs[k] = rounded.arc(k, radius, limits[k]);
        }
        let overlapping: Vec<usize> = (0..rounded.curves.len())
            .filter(|&k| rounded.used(k) > 1.0 + MEETS)
            .collect();
        for &k in &overlapping {
            limits[k][0] = 0.5;
            limits[rounded.before(k)][1] = 0.5;
        }
        for (k, &limit) in limits.iter().enumerate() {
            if limit != [1.0; 2] {
                rounded.arcs[k] = rounded.arc(k, radius, limit);
            }
        }
        rounded
    }

    /// The index of the segment before segment k.
    fn before(&self, k: usize) -> usize {
        k.checked_sub(1).unwrap_or(self.curves.len() - 1)
    }

    /// The arc at the end of segment k.
    fn arc(&self, k: usize, radius: f64, limits: [f64; 2]) -> Option<CornerArc> {
        let next = match self.curves.get(k + 1) {
            Some(next) => next,
            None if self.part.closed => &self.curves[0],
            None => return None,
        };
        corner_arc([&self.curves[k], next], radius, limits)
    }

    /// The lengths of the intervals at both ends of segment k that arcs replace.
    fn cuts(&self, k: usize) -> [f64; 2] {
        let start = self.arcs[self.before(k)].map_or(0.0, |arc| arc.from_corner[1]);
        [start, self.arcs[k].map_or(0.0, |arc| arc.from_corner[0])]
    }

    fn used(&self, k: usize) -> f64 {
        let [start, end] = self.cuts(k);
        start + end
    }

    fn push_to(&self, path: &mut Path) {
        let Some(last) = self.arcs.last() else {
            let count = self.part.points.len() - usize::from(self.part.closed);
            let points = &self.part.points[..count];
            return path.push(points, self.part.degrees, self.part.closed);
        };
        let start = last.map_or(self.part.points[0], |arc| arc.ends[1]);
        let mut out = Pieces {
            points: vec![start],
            degrees: Vec::new(),
        };
        let mut k = 0;
        for points in self.part.segments() {
            if points.iter().all(|&p| p == points[0]) {
                let at_arc = self.arcs[self.before(k)].is_some();
                if !at_arc {
                    out.add(points);
                }
                continue;
            }
            self.push_segment(k, &mut out);
            k += 1;
        }
        if self.part.closed {
            out.points.pop();
        }
        path.push(&out.points, &out.degrees, self.part.closed);
    }

    /// Appends what is left of segment k, and the arc after it.
    fn push_segment(&self, k: usize, out: &mut Pieces) {
        let curve = &self.curves[k];
        let [start, end] = self.cuts(k);
        let arcs = [self.arcs[self.before(k)], self.arcs[k]];
        if start + end < 1.0 - MEETS {
            let mut rest = if start == 0.0 && end == 0.0 {
                curve.control_points().to_vec()
            } else {
                curve.subsegment(start, 1.0 - end).control_points().to_vec()
            };
            let last = rest.len() - 1;
            if let Some(arc) = arcs[0] {
                rest[0] = arc.ends[1];
            }
            if let Some(arc) = arcs[1] {
                rest[last] = arc.ends[0];
            }
            out.add(&rest);
        }
        if let Some(arc) = arcs[1] {
            out.add_arc(&arc);
        }
    }
}

/// A subpath under construction.
struct Pieces {
    points: Vec<DVec2>,
    degrees: Vec<u8>,
}

impl Pieces {
    /// Appends a segment that starts at the last point.
    fn add(&mut self, points: &[DVec2]) {
        self.points.extend(&points[1..]);
        let degree = u8::try_from(points.len() - 1).unwrap_or(u8::MAX); // at most 64
        self.degrees.push(degree);
    }

    fn add_arc(&mut self, arc: &CornerArc) {
        let [from, to] = arc.tangents;
        let angle = from.perp_dot(to).atan2(from.dot(to));
        // The start is the origin.
        let center = from.perp() * arc.radius;
        let mut points = Vec::new();
        let tolerance = ARC_TOLERANCE * arc.radius.abs();
        add_arc(
            [center; 2],
            [from, to],
            angle,
            -arc.radius,
            tolerance,
            &mut points,
        );
        let count = points.len();
        self.points
            .extend(points.iter().map(|&p| arc.ends[0] + p * arc.unit));
        self.degrees.extend(std::iter::repeat_n(3, count / 3));
        if let Some(last) = self.points.last_mut() {
            *last = arc.ends[1];
        }
    }
}
