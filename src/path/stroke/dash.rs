//! Dashes: the pieces of a path along a pattern of lengths.

use crate::curve::arc_length::segments::SegmentLengths;
use crate::geometry::error::Error;
use crate::numeric::float::as_f64;
use crate::path::Path;
use crate::spline::Spline;
use glam::DVec2;

/// The largest number of pieces.
const MAX_DASHES: usize = 1 << 22;

/// An end of a dash this close to a joint, as a part of the length of the subpath, is moved to the joint.
const JOINT_TOLERANCE: f64 = 1e-13;

/// One dash.
pub(super) struct Dash {
    pub(super) spline: Spline<DVec2>,
    /// The unit tangent at its start: the direction of a dash of length 0.
    pub(super) tangent: DVec2,
    /// The parameter and the arc length at its start on the subpath.
    pub(super) from: (f64, f64),
    /// The parameter at its end, larger than the number of segments if it passes the start of a closed subpath.
    to: f64,
}

impl Dash {
    /// A subpath without gaps.
    pub(super) fn whole(spline: Spline<DVec2>) -> Self {
        Self {
            to: as_f64(spline.segment_count()),
            spline,
            tangent: DVec2::X,
            from: (0.0, 0.0),
        }
    }

    /// A part that begins at an arc length, which the stroke does not ask for its parameters on the subpath.
    pub(super) fn from_length(spline: Spline<DVec2>, length: f64) -> Self {
        Self {
            from: (0.0, length),
            ..Self::whole(spline)
        }
    }

    /// The parameters on the subpath at the ends of the segments of the dash.
    pub(super) fn parameters(&self) -> Vec<f64> {
        let count = self.spline.segment_count();
        let joint = |k: usize| (self.from.0.floor() + as_f64(k)).min(self.to);
        let mut ts: Vec<f64> = (0..=count).map(joint).collect();
        (ts[0], ts[count]) = (self.from.0, self.to);
        ts
    }
}

impl Path {
    /// The dashes of the path along a pattern of lengths: on, off, on, off …
    ///
    /// A pattern with an odd number of entries is repeated once, so that its dashes and gaps alternate. Each subpath
    /// starts at the length `offset` in the pattern, which may be negative. The dashes are open subpaths in the order
    /// of the path, cut by arc length with an error of at most 10⁻⁹ of the length of their subpath. On a closed subpath
    /// the dash that reaches the end continues at the start, and is then the first one; a dash that covers the whole
    /// subpath leaves it closed. An entry of 0 for a dash gives a line of length 0, which has round or square caps when it is
    /// stroked. A subpath that is a point is returned unchanged if it starts in a dash. An empty pattern returns the
    /// path.
    ///
    /// ```
    /// use casteljau::Path;
    ///
    /// let line: Path = "M0 0H10".parse().expect("path data");
    /// assert_eq!(line.dash(&[4.0, 2.0], 0.0)?.to_string(), "M0,0 L4,0 M6,0 L10,0");
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Item`] for an entry that is negative or not finite; [`Error::Range`] for a pattern of only zeros, or
    /// with an infinite sum, and for an offset that is not finite; [`Error::TooMany`] for more than 2²² dashes.
    ///
    /// Source: SVG 2, § 13.5.6 (stroke-dasharray, stroke-dashoffset).
    pub fn dash(&self, pattern: &[f64], offset: f64) -> Result<Self, Error> {
        let Some(pattern) = Pattern::new(pattern, offset)? else {
            return Ok(self.clone());
        };
        let mut count = 0;
        let mut path = Self::default();
        for spline in self.subpaths() {
            let dashes = pattern.dashes(&spline, &mut count)?;
            path.extend(dashes.into_iter().map(|dash| dash.spline));
        }
        Ok(path)
    }
}

/// A checked pattern.
pub(super) struct Pattern {
    /// The lengths from the start of a period to the ends of its entries; their number is even.
    ends: Vec<f64>,
    period: f64,
    /// The length in the pattern at which subpaths start, from 0 to the period.
    offset: f64,
}

impl Pattern {
    /// `None` for an empty list.
    pub(super) fn new(pattern: &[f64], offset: f64) -> Result<Option<Self>, Error> {
        if let Some(index) = pattern.iter().position(|&x| !(0.0..=f64::MAX).contains(&x)) {
            return Err(Error::Item {
                what: "pattern",
                index,
                expected: "a finite number, at least 0",
                got: pattern[index],
            });
        }
        if !offset.is_finite() {
            return Err(Error::Range {
                what: "offset",
                expected: "a finite number",
                got: offset,
            });
        }
        let repeats = 1 + pattern.len() % 2;
        let entries = std::iter::repeat_n(pattern, repeats).flatten();
        let ends: Vec<f64> = entries
            .scan(0.0, |end, entry| {
                *end += entry;
                Some(*end)
            })
            .collect();
        let Some(&period) = ends.last() else {
            return Ok(None);
        };
        if !(period > 0.0 && period.is_finite()) {
            return Err(Error::Range {
                what: "sum of the pattern",
                expected: "a finite number above 0",
                got: period,
            });
        }
        let offset = offset.rem_euclid(period);
        Ok(Some(Self {
            ends,
            period,
            offset: if offset < period { offset } else { 0.0 },
        }))
    }

    /// The dashes of a subpath; `count` is their number on all subpaths.
    pub(super) fn dashes(
        &self,
        spline: &Spline<DVec2>,
        count: &mut usize,
    ) -> Result<Vec<Dash>, Error> {
        let lengths = spline.segment_lengths();
        let whole = lengths.total();
        let needed = (whole / self.period).ceil() * (self.ends.len() / 2) as f64 + *count as f64;
        if needed.is_nan() || needed > MAX_DASHES as f64 {
            return Err(Error::too_many("dashes", MAX_DASHES, MAX_DASHES + 1));
        }
        if whole == 0.0 {
            let starts_on = self.ends.iter().position(|&end| end > self.offset);
            *count += 1;
            let on = starts_on.is_some_and(|entry| entry % 2 == 0);
            return Ok(if on {
                vec![Dash::whole(spline.clone())]
            } else {
                Vec::new()
            });
        }
        let intervals = self.intervals(whole);
        *count += intervals.len();
        Ok(DashSplitter { spline, lengths }.split(&intervals))
    }

    /// The arc lengths at which the dashes start and end, for a subpath of a given length.
    fn intervals(&self, whole: f64) -> Vec<[f64; 2]> {
        let mut intervals = Vec::new();
        let mut period = 0.0;
        loop {
            let origin = period * self.period - self.offset;
            if origin > whole {
                return intervals;
            }
            for entry in (0..self.ends.len()).step_by(2) {
                let start = entry.checked_sub(1).map_or(0.0, |k| self.ends[k]);
                let [from, to] = [start, self.ends[entry]].map(|s| origin + s);
                let is_point = start == self.ends[entry];
                if from < whole && (to > 0.0 || is_point && to >= 0.0) {
                    intervals.push([from.max(0.0), to.min(whole)]);
                }
            }
            period += 1.0;
        }
    }
}

/// Splits a spline at arc lengths.
struct DashSplitter<'a> {
    spline: &'a Spline<DVec2>,
    lengths: SegmentLengths,
}

impl DashSplitter<'_> {
    fn split(&mut self, intervals: &[[f64; 2]]) -> Vec<Dash> {
        let whole = self.lengths.total();
        let mut dashes: Vec<Dash> = Vec::with_capacity(intervals.len());
        // Whether the last dash goes on in the first one, across the start of a closed subpath.
        let around = match intervals {
            _ if !self.spline.is_closed() => false,
            [.., [_, to]] if *to < whole => false,
            [[from, _], ..] => *from == 0.0,
            [] => false,
        };
        if around && intervals.len() == 1 && intervals[0] == [0.0, whole] {
            return vec![Dash::whole(self.spline.clone())];
        }
        for &[from, to] in intervals {
            let ts = [from, to].map(|s| self.parameter_at(s));
            dashes.push(Dash {
                spline: self.spline.part(ts[0], ts[1]),
                tangent: if from == to {
                    self.spline.tangent(ts[0])
                } else {
                    DVec2::X
                },
                from: (ts[0], from),
                to: ts[1],
            });
        }
        if around
            && dashes.len() > 1
            && let Some(last) = dashes.pop()
        {
            dashes[0] = Dash {
                spline: joined(&last.spline, &dashes[0].spline),
                to: last.to + dashes[0].to,
                ..last
            };
        }
        dashes
    }

    /// The parameter at an arc length.
    fn parameter_at(&mut self, s: f64) -> f64 {
        let near = JOINT_TOLERANCE * self.lengths.total();
        let curve = &|k| self.spline.curve(k);
        let (k, t) = self.lengths.position(s, near, None, curve);
        as_f64(k) + t
    }
}

/// Two open splines, where the second starts at the end of the first, as one.
fn joined(first: &Spline<DVec2>, second: &Spline<DVec2>) -> Spline<DVec2> {
    let points = [first.control_points(), &second.control_points()[1..]].concat();
    let degrees = [first.degrees(), second.degrees()].concat();
    Spline::from_parts(points, &degrees, false)
}
