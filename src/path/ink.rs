//! Freehand strokes: samples of a pointer become a curve of varying width while the pointer moves.
//!
//! Each sample is pulled towards the one before it (streamline) and gets a width from its pressure; then positions and
//! widths are averaged over their neighbours along the stroke (smoothing). The smoothed samples are fitted by cubics from
//! joint to joint: the longest run that one cubic can follow within the tolerance, with the tangents of parabolas through
//! three samples. As soon as a run is followed by another one it is settled: later samples do not change it.

use super::Path;
use super::stroke::{StrokeCap, StrokeOptions, WidthInterpolation, WidthProfile};
use crate::curve::Curve;
use crate::geometry::check::{MAX_COORDINATE, check_points, check_tolerance};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::spline::cubics::{FitCriteria, FitEffort, FitSamples, is_straight};
use crate::spline::{Join, Spline};
use glam::DVec2;

/// Samples on each side of one with which it is averaged at most.
const MAX_NEIGHBOURS: usize = 16;

/// A run that is longer is settled, so that the time for a sample is bounded.
const MAX_RUN: usize = 256;

/// A run is fitted again when it has grown by this many points and by a quarter.
const MIN_GROWTH: usize = 8;

/// Tangents that differ by more than the angle with this cosine, 60°, make a corner.
const CORNER_COSINE: f64 = 0.5;

/// Milliseconds between samples without times, and those in which the fastest stroke advances by its size.
const SAMPLE_INTERVAL: f64 = 10.0;

/// Simulated pressure follows the speed with a delay of this many widths.
const PRESSURE_DELAY: f64 = 4.0;

/// The pressure at which the width is `size`.
const MIDDLE_PRESSURE: f64 = 0.5;

/// The part of the way to the next position that full streamlining leaves out.
const STREAMLINE: f64 = 0.85;

/// The tolerance that `size` has by default.
const TOLERANCE_PART: f64 = 0.025;

/// Positions of the stops along a taper, from its pointed end.
const TAPER_STOPS: [f64; 4] = [0.0, 0.25, 0.5, 1.0];

/// Where the pressure of an [`InkStroke`] comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum InkPressure {
    /// From the speed: a fast stroke has little pressure.
    #[default]
    Simulated,
    /// From the samples; those without a pressure have 0.5.
    Device,
}

/// Options of an [`InkStroke`].
///
/// ```
/// use casteljau::path::InkOptions;
///
/// let pen = InkOptions::new(12.0).thinning(0.7).taper(40.0, 60.0);
/// assert_eq!(pen.smoothing, 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct InkOptions {
    /// The width at a pressure of 0.5, above 0.
    pub size: f64,
    /// How much the width follows the pressure p, from −1 to 1: it is size·(1 + thinning·(2p − 1)). 0.5 by default;
    /// a negative number makes fast strokes wider.
    #[cfg_attr(feature = "serde", serde(default = "half"))]
    pub thinning: f64,
    /// The lengths over which the width grows from 0 at the start and shrinks to 0 at the end: 0 by default. In a stroke that is
    /// shorter than both, they have the same ratio and fill it.
    #[cfg_attr(feature = "serde", serde(default))]
    pub taper: [f64; 2],
    /// From 0 to 1: positions and widths are averaged over this part of `size` along the stroke, half of it to each side.
    /// 0.5 by default.
    #[cfg_attr(feature = "serde", serde(default = "half"))]
    pub smoothing: f64,
    /// From 0 to 1, how far each position stays behind its sample: 0.5 by default. The end of the stroke is the last sample.
    #[cfg_attr(feature = "serde", serde(default = "half"))]
    pub streamline: f64,
    /// The largest distance of the curve from the smoothed samples, and of the outline from that of the curve: 2.5 % of
    /// `size` by default.
    pub tolerance: Option<f64>,
    /// Where the pressure comes from: the speed by default.
    #[cfg_attr(feature = "serde", serde(default))]
    pub pressure: InkPressure,
}

#[cfg(feature = "serde")]
const fn half() -> f64 {
    0.5
}

/// Methods that set one option, for chaining.
impl InkOptions {
    /// The options with a size and otherwise the defaults.
    pub const fn new(size: f64) -> Self {
        Self {
            size,
            thinning: 0.5,
            taper: [0.0; 2],
            smoothing: 0.5,
            streamline: 0.5,
            tolerance: None,
            pressure: InkPressure::Simulated,
        }
    }

    /// Sets how much the width follows the pressure.
    #[must_use]
    pub const fn thinning(self, thinning: f64) -> Self {
        Self { thinning, ..self }
    }

    /// Sets the lengths of the tapers.
    #[must_use]
    pub const fn taper(self, start: f64, end: f64) -> Self {
        Self {
            taper: [start, end],
            ..self
        }
    }

    /// Sets the length over which samples are averaged.
    #[must_use]
    pub const fn smoothing(self, smoothing: f64) -> Self {
        Self { smoothing, ..self }
    }

    /// Sets how far positions stay behind.
    #[must_use]
    pub const fn streamline(self, streamline: f64) -> Self {
        Self { streamline, ..self }
    }

    /// Sets the largest distance of the curve from the smoothed samples.
    #[must_use]
    pub const fn tolerance(self, tolerance: f64) -> Self {
        Self {
            tolerance: Some(tolerance),
            ..self
        }
    }

    /// Sets where the pressure comes from.
    #[must_use]
    pub const fn pressure(self, pressure: InkPressure) -> Self {
        Self { pressure, ..self }
    }

    /// The tolerance, if all options are in their ranges.
    fn checked_tolerance(&self) -> Result<f64, Error> {
        let check = |what, expected, got: f64, is_valid: bool| {
            if is_valid {
                Ok(())
            } else {
                Err(Error::Range {
                    what,
                    expected,
                    got,
                })
            }
        };
        let is_length = |x: f64| x > 0.0 && x <= MAX_COORDINATE;
        check(
            "size",
            "a number above 0 and at most 2^500",
            self.size,
            is_length(self.size),
        )?;
        let thinning = (-1.0..=1.0).contains(&self.thinning);
        check("thinning", "a number from -1 to 1", self.thinning, thinning)?;
        for got in self.taper {
            check(
                "taper",
                "a number from 0 to 2^500",
                got,
                got == 0.0 || is_length(got),
            )?;
        }
        for (what, got) in [
            ("smoothing", self.smoothing),
            ("streamline", self.streamline),
        ] {
            check(
                what,
                "a number from 0 to 1",
                got,
                (0.0..=1.0).contains(&got),
            )?;
        }
        let tolerance = self.tolerance.unwrap_or(TOLERANCE_PART * self.size);
        check(
            "tolerance",
            "a number above 0 and at most 2^500",
            tolerance,
            is_length(tolerance),
        )?;
        Ok(tolerance)
    }

    fn width(&self, pressure: f64) -> f64 {
        self.size * (1.0 + self.thinning * (2.0 * pressure - 1.0))
    }
}

/// What a sample of a stroke has besides its position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InkSample {
    /// The pressure, from 0 to 1.
    pub pressure: Option<f64>,
    /// The time in milliseconds. Samples without times, or not later than the one before, count as 10 ms apart.
    pub time: Option<f64>,
}

/// The changes of an outline, from [`InkStroke::changes`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InkChanges {
    /// The contours that are new and that later samples do not change.
    pub settled: Path,
    /// The contours of the rest of the stroke, which replace those of the last call.
    pub open: Path,
}

/// A position with its width, and the length of the polyline up to it.
#[derive(Clone, Copy, Debug)]
struct InkPoint {
    position: DVec2,
    width: f64,
    length: f64,
}

/// Appends a point unless it is where the last one is.
fn push(points: &mut Vec<InkPoint>, position: DVec2, width: f64) {
    let length = match points.last() {
        None => 0.0,
        Some(last) => {
            let step = (position - last.position).norm();
            if last.length + step <= last.length {
                return;
            }
            last.length + step
        }
    };
    points.push(InkPoint {
        position,
        width,
        length,
    });
}

/// The weighted mean of the points around one, at most `reach` away along the polyline and as far to both sides.
fn weighted_mean(points: &[InkPoint], k: usize, reach: f64) -> (DVec2, f64) {
    let [first, last] = [
        k.saturating_sub(MAX_NEIGHBOURS),
        (k + MAX_NEIGHBOURS).min(points.len() - 1),
    ];
    let here = points[k];
    let reach = reach
        .min(here.length - points[first].length)
        .min(points[last].length - here.length);
    let (mut offset, mut change, mut total) = (DVec2::ZERO, 0.0, 1.0);
    for other in &points[first..=last] {
        let weight = 1.0 - (other.length - here.length).abs() / reach;
        if weight > 0.0 && weight < 1.0 {
            offset += (other.position - here.position) * weight;
            change += (other.width - here.width) * weight;
            total += weight;
        }
    }
    (here.position + offset / total, here.width + change / total)
}

/// A fitted cubic or line.
#[derive(Clone, Debug)]
struct InkPiece {
    curve: Curve<DVec2>,
    length: f64,
    /// Arc lengths on the curve, from 0 to its length, and widths.
    stops: Vec<(f64, f64)>,
}

impl InkPiece {
    /// Widths that are interpolated linearly within twice the tolerance, the radii within the tolerance, become no stops.
    fn new(run: &[InkPoint], handles: [DVec2; 2], tolerance: f64) -> Self {
        let [first, last] = [run[0], run[run.len() - 1]];
        let points = [first.position, handles[0], handles[1], last.position];
        let curve = if is_straight(&points, tolerance) {
            Curve::from_slice(&[points[0], points[3]])
        } else {
            Curve::from_slice(&points)
        };
        let length = curve.length();
        let scale = length / (last.length - first.length);
        let mut stops = vec![(0.0, first.width)];
        let mut before = (0.0, first.width);
        let [mut min, mut max] = [f64::NEG_INFINITY, f64::INFINITY];
        for point in &run[1..] {
            let here = ((point.length - first.length) * scale, point.width);
            let slope = |from: (f64, f64), width: f64| (width - from.1) / (here.0 - from.0);
            let mut from = stops[stops.len() - 1];
            if !(min..=max).contains(&slope(from, here.1)) && before.0 > from.0 {
                stops.push(before);
                from = before;
                [min, max] = [f64::NEG_INFINITY, f64::INFINITY];
            }
            min = min.max(slope(from, here.1 - 2.0 * tolerance));
            max = max.min(slope(from, here.1 + 2.0 * tolerance));
            before = here;
        }
        stops.push((length, last.width));
        Self {
            curve,
            length,
            stops,
        }
    }
}

/// The unit tangents before and after each point of a run; they differ at corners. `start` is the tangent at its start, if
/// that is known.
fn tangents(run: &[InkPoint], start: Option<DVec2>) -> Vec<[DVec2; 2]> {
    let chord = |k: usize| (run[k + 1].position - run[k].position).unit();
    let step = |k: usize| run[k + 1].length - run[k].length;
    let last = run.len() - 1;
    let mut result: Vec<[DVec2; 2]> = (0..=last)
        .map(|k| {
            if k == 0 || k == last {
                return [chord(k.min(last - 1)); 2];
            }
            let [before, after] = [chord(k - 1), chord(k)];
            if before.dot(after) < CORNER_COSINE {
                [before, after]
            } else {
                [(before * step(k) + after * step(k - 1)).unit(); 2]
            }
        })
        .collect();
    // As on a circle, the chord bisects the tangents at its ends.
    let reflected =
        |along: DVec2, tangent: DVec2| (2.0 * along.dot(tangent) * along - tangent).unit();
    if last > 1 {
        result[0] = [reflected(chord(0), result[1][0]); 2];
        result[last] = [reflected(chord(last - 1), result[last - 1][1]); 2];
    }
    if let Some(start) = start {
        result[0] = [start; 2];
    }
    result
}

/// The pieces of a run up to a point, each with the index of its end.
fn fitted_pieces(
    run: &[InkPoint],
    tangents: &[[DVec2; 2]],
    last: usize,
    tolerance: f64,
) -> Vec<(usize, InkPiece)> {
    let points: Vec<DVec2> = run[..=last].iter().map(|point| point.position).collect();
    let mut stops = vec![0];
    stops.extend((1..last).filter(|&k| tangents[k][0] != tangents[k][1]));
    stops.push(last);
    let samples = FitSamples {
        joints: points.clone(),
        points,
        tangents: tangents.iter().map(|pair| pair[1]).collect(),
        lengths: run[..=last].iter().map(|point| point.length).collect(),
        criteria: FitCriteria {
            tolerance,
            ..FitCriteria::default()
        },
    };
    let mut from = 0;
    let piece = |(to, handles)| {
        let piece = InkPiece::new(&run[from..=to], handles, tolerance);
        from = to;
        (to, piece)
    };
    samples
        .fit_between_stops(tangents, &stops, FitEffort::Fast)
        .into_iter()
        .map(piece)
        .collect()
}

/// A freehand stroke that grows with the samples of a pointer.
///
/// The centre line is a smooth chain of cubics within the tolerance of the smoothed samples, the widths follow the pressure,
/// and the outline is that of [`Path::stroke_with`] with round caps and joins. The time for a sample is bounded; that of
/// [`changes`](Self::changes) does not depend on the length of the stroke.
///
/// ```
/// use casteljau::path::{InkOptions, InkSample, InkStroke};
/// use casteljau::glam::DVec2;
///
/// let mut ink = InkStroke::new(&InkOptions::new(8.0).taper(10.0, 20.0))?;
/// for k in 0..40 {
///     let x = f64::from(k) * 4.0;
///     ink.append(DVec2::new(x, 20.0 * (x / 30.0).sin()), InkSample::default())?;
/// }
/// assert_eq!(ink.outline()?.subpath_count(), 1);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct InkStroke {
    options: InkOptions,
    tolerance: f64,
    /// The last sample, as it came.
    last_sample: Option<LastSample>,
    /// The streamlined samples.
    samples: Vec<InkPoint>,
    /// The number of samples whose mean is final.
    averaged: usize,
    /// The means since the last joint.
    run: Vec<InkPoint>,
    /// The number of points of the run with which it is fitted next.
    next_fit: usize,
    /// The tangent at that joint.
    tangent: Option<DVec2>,
    /// The curve up to that joint.
    pieces: Vec<InkPiece>,
    length: f64,
    /// The number of pieces whose contours have been returned as settled, and their length.
    drawn: usize,
    drawn_length: f64,
}

#[derive(Clone, Copy, Debug)]
struct LastSample {
    position: DVec2,
    pressure: f64,
    width: f64,
    time: Option<f64>,
}

impl InkStroke {
    /// A stroke without samples.
    ///
    /// # Errors
    /// [`Error::Range`] for an option outside of its range.
    pub fn new(options: &InkOptions) -> Result<Self, Error> {
        Ok(Self {
            tolerance: options.checked_tolerance()?,
            options: *options,
            last_sample: None,
            samples: Vec::new(),
            averaged: 0,
            run: Vec::new(),
            next_fit: MIN_GROWTH,
            tangent: None,
            pieces: Vec::new(),
            length: 0.0,
            drawn: 0,
            drawn_length: 0.0,
        })
    }

    /// Appends a sample. One at the position of the last sample adds nothing, except that the first position takes its width.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a position or a time with a NaN or an infinity, [`Error::Range`] for a pressure outside of 0 to
    /// 1, and as [`Curve::flatten`] for a tolerance that is too small for the coordinates. The stroke is then as before.
    pub fn append(&mut self, position: DVec2, sample: InkSample) -> Result<(), Error> {
        check_points("position", &[position])?;
        check_tolerance(
            self.tolerance,
            position.abs().max_element().max(self.options.size),
        )?;
        let InkSample { pressure, time } = sample;
        if let Some(got) = pressure.filter(|got| !(0.0..=1.0).contains(got)) {
            return Err(Error::Range {
                what: "pressure",
                expected: "a number from 0 to 1",
                got,
            });
        }
        if let Some(got) = time.filter(|got| !got.is_finite()) {
            return Err(Error::NotFinite {
                what: "time",
                index: 0,
                got,
            });
        }
        let pressure = match self.options.pressure {
            InkPressure::Device => pressure.unwrap_or(MIDDLE_PRESSURE),
            InkPressure::Simulated => self.simulated_pressure(position, time),
        };
        let is_simulated = self.options.pressure == InkPressure::Simulated;
        let width = self.options.width(pressure);
        self.last_sample = Some(LastSample {
            position,
            pressure,
            width,
            time,
        });
        let advance = 1.0 - STREAMLINE * self.options.streamline;
        let count = self.samples.len();
        match self.samples.last_mut() {
            None => push(&mut self.samples, position, width),
            Some(first) if count == 1 && first.position == position => first.width = width,
            Some(last) => {
                if is_simulated && count == 1 {
                    last.width = width; // The speed at the first sample is that to the second one.
                }
                let last = *last;
                push(
                    &mut self.samples,
                    last.position.lerp(position, advance),
                    last.width + (width - last.width) * advance,
                );
            }
        }
        self.settle();
        Ok(())
    }

    /// The pressure that follows from the speed.
    fn simulated_pressure(&self, position: DVec2, time: Option<f64>) -> f64 {
        let Some(last_sample) = self.last_sample else {
            return MIDDLE_PRESSURE;
        };
        let elapsed = match (last_sample.time, time) {
            (Some(from), Some(to)) if to > from => to - from,
            _ => SAMPLE_INTERVAL,
        };
        let widths = (position - last_sample.position).norm() / self.options.size;
        let target = 1.0 - (widths * SAMPLE_INTERVAL / elapsed).min(1.0);
        if self.samples.len() == 1 && widths > 0.0 {
            return target;
        }
        target + (last_sample.pressure - target) * (-widths / PRESSURE_DELAY).exp()
    }

    /// Half the length over which samples are averaged.
    fn reach(&self) -> f64 {
        0.5 * self.options.smoothing * self.options.size
    }

    /// Averages the samples whose neighbours are there, and settles the runs that are followed by others.
    fn settle(&mut self) {
        let (last, reach) = (self.samples.len() - 1, self.reach());
        let end = self.samples[last].length;
        while self.averaged < last
            && (last - self.averaged >= MAX_NEIGHBOURS
                || end - self.samples[self.averaged].length >= reach)
        {
            let (position, width) = weighted_mean(&self.samples, self.averaged, reach);
            self.averaged += 1;
            push(&mut self.run, position, width);
            if self.run.len() >= self.next_fit {
                self.settle_run();
            }
        }
    }

    /// Settles all pieces of the run that are followed by others.
    fn settle_run(&mut self) {
        // The tangent at the last point depends on the next one.
        let Some(last) = self.run.len().checked_sub(2).filter(|&last| last > 0) else {
            return;
        };
        let tangents = tangents(&self.run, self.tangent);
        let mut fitted = fitted_pieces(&self.run, &tangents, last, self.tolerance);
        self.next_fit = self.run.len() + MIN_GROWTH.max(self.run.len() / 4);
        if last < MAX_RUN {
            fitted.pop();
        }
        let Some(&(joint, _)) = fitted.last() else {
            return;
        };
        self.tangent = Some(tangents[joint][1]);
        self.run.drain(..joint);
        for (_, piece) in fitted {
            self.length += piece.length;
            self.pieces.push(piece);
        }
        self.next_fit = self.run.len() + MIN_GROWTH;
    }

    /// The pieces after the last joint, and those to the predicted positions.
    fn open_pieces(&self, predicted: &[DVec2]) -> Vec<InkPiece> {
        let Some(last_sample) = self.last_sample else {
            return Vec::new();
        };
        // The means of the last samples, and of those that no other sample follows.
        let start = self.averaged.saturating_sub(MAX_NEIGHBOURS);
        let mut samples = self.samples[start..].to_vec();
        for &position in std::iter::once(&last_sample.position).chain(predicted) {
            push(&mut samples, position, last_sample.width);
        }
        let mut run = self.run.clone();
        for k in self.averaged - start..samples.len() {
            let (position, width) = weighted_mean(&samples, k, self.reach());
            push(&mut run, position, width);
        }
        if run.len() < 2 {
            return Vec::new();
        }
        let tangents = tangents(&run, self.tangent);
        let fitted = fitted_pieces(&run, &tangents, run.len() - 1, self.tolerance);
        fitted.into_iter().map(|(_, piece)| piece).collect()
    }

    /// The tapers of a stroke of a length.
    fn tapers(&self, length: f64) -> [f64; 2] {
        let [start, end] = self.options.taper;
        let scale = (length / (start + end)).min(1.0);
        [start, end].map(|taper| if taper > 0.0 { taper * scale } else { 0.0 })
    }

    /// The widths of pieces that begin at a length of a stroke; the positions are parts of its whole length.
    fn profile<'a>(
        &self,
        pieces: impl Iterator<Item = &'a InkPiece>,
        mut from: f64,
        length: f64,
    ) -> WidthProfile {
        let mut base: Vec<(f64, f64)> = Vec::new();
        let mut add = |position: f64, width: f64| {
            if base.last().is_none_or(|last| position > last.0) {
                base.push((position, width));
            }
        };
        for piece in pieces {
            for &(along, width) in &piece.stops {
                add((from + along) / length, width);
            }
            from += piece.length;
        }
        if let Some(last) = base.last_mut()
            && from >= length
        {
            last.0 = 1.0;
        }
        let [start, end] = self.tapers(length).map(|taper| taper / length);
        let taper = |x: f64, length: f64| {
            if x < length {
                x / length * (2.0 - x / length)
            } else {
                1.0
            }
        };
        let mut positions: Vec<f64> = base.iter().map(|stop| stop.0).collect();
        let range = positions[0]..=positions[positions.len() - 1];
        for part in TAPER_STOPS {
            let inner = [start * part, 1.0 - end * part];
            positions.extend(
                inner
                    .into_iter()
                    .filter(|position| range.contains(position)),
            );
        }
        positions.sort_by(f64::total_cmp);
        positions.dedup();
        let mut next = 1;
        let stops = positions.into_iter().map(|position| {
            while next + 1 < base.len() && base[next].0 < position {
                next += 1;
            }
            let (a, b) = (base[next - 1], base[next.min(base.len() - 1)]);
            let part = if b.0 > a.0 {
                (position - a.0) / (b.0 - a.0)
            } else {
                0.0
            };
            let width = a.1 + (b.1 - a.1) * part;
            (
                position,
                width * taper(position, start) * taper(1.0 - position, end),
            )
        });
        WidthProfile::new(&stops.collect::<Vec<_>>()).interpolation(WidthInterpolation::Smooth)
    }

    /// The centre line; `None` without samples. A single point is a line of length 0.
    pub fn spline(&self) -> Option<Spline<DVec2>> {
        self.spline_with(&self.open_pieces(&[]))
    }

    fn spline_with(&self, open: &[InkPiece]) -> Option<Spline<DVec2>> {
        let start = self.samples.first()?.position;
        Some(spline_of(start, self.pieces.iter().chain(open)))
    }

    /// The widths along the centre line, which has the outline as its stroke.
    pub fn widths(&self) -> WidthProfile {
        self.widths_with(&self.open_pieces(&[]))
    }

    fn widths_with(&self, open: &[InkPiece]) -> WidthProfile {
        let length = self.length + length_of(open);
        if length > 0.0 {
            self.profile(self.pieces.iter().chain(open), 0.0, length)
        } else {
            WidthProfile::constant(
                self.last_sample
                    .map_or(self.options.size, |last_sample| last_sample.width),
            )
        }
    }

    /// The outline, without overlaps. Without samples it is empty, and a single point is a disc.
    ///
    /// # Errors
    /// As [`Path::stroke_with`].
    pub fn outline(&self) -> Result<Path, Error> {
        let open = self.open_pieces(&[]);
        let Some(spline) = self.spline_with(&open) else {
            return Ok(Path::default());
        };
        Path::from(spline).stroke_with(&self.widths_with(&open), &self.stroke_options())
    }

    /// The contours that are new since the last call, for drawing while the pointer moves.
    ///
    /// Those of `settled` stay as they are; those of `open` replace the last ones. Contours overlap, and fill the stroke
    /// under the nonzero rule. The end of the stroke is open over the length of its taper, and the whole stroke while it is
    /// shorter than both tapers. `predicted` are positions that the pointer may have next; only `open` reaches them, with the
    /// width of the last sample.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a predicted position with a NaN or an infinity, otherwise as [`Path::stroke_with`].
    pub fn changes(&mut self, predicted: &[DVec2]) -> Result<InkChanges, Error> {
        check_points("predicted", predicted)?;
        self.settle_run();
        let open = self.open_pieces(predicted);
        let length = self.length + length_of(&open);
        if length <= 0.0 {
            return Ok(InkChanges {
                settled: Path::default(),
                open: self.outline()?,
            });
        }
        // The slope of the width at a joint depends on one stop before it and one after it.
        let context = self.drawn.saturating_sub(1);
        let from = self.drawn_length - length_of(&self.pieces[context..self.drawn]);
        let pieces: Vec<&InkPiece> = self.pieces[context..].iter().chain(&open).collect();
        let profile = self.profile(pieces.iter().copied(), from.max(0.0), length);
        let fixed = self.length - self.options.taper[1];
        let (mut settled, mut end) = (self.drawn, self.drawn_length);
        if self.length >= self.options.taper[0] + self.options.taper[1] {
            while settled + 1 < self.pieces.len()
                && end + self.pieces[settled].length + self.pieces[settled + 1].length <= fixed
            {
                end += self.pieces[settled].length;
                settled += 1;
            }
        }
        let options = self.stroke_options().simple(false);
        let stroke = |part: &[&InkPiece], from: f64| {
            let Some(first) = part.first() else {
                return Ok(Path::default());
            };
            let spline = spline_of(first.curve.start(), part.iter().copied());
            Path::stroke_part(spline, from, length, &profile, &options)
        };
        let [a, b] = [self.drawn - context, settled - context];
        let changes = InkChanges {
            settled: stroke(&pieces[a..b], self.drawn_length)?,
            open: stroke(&pieces[b..], end)?,
        };
        (self.drawn, self.drawn_length) = (settled, end);
        Ok(changes)
    }

    fn stroke_options(&self) -> StrokeOptions {
        StrokeOptions::new()
            .join(Join::Round)
            .cap(StrokeCap::Round)
            .tolerance(self.tolerance)
    }
}

fn length_of(pieces: &[InkPiece]) -> f64 {
    pieces.iter().map(|piece| piece.length).sum()
}

/// The spline of consecutive pieces.
fn spline_of<'a>(start: DVec2, pieces: impl Iterator<Item = &'a InkPiece>) -> Spline<DVec2> {
    let mut points = vec![start];
    let mut degrees = Vec::new();
    for piece in pieces {
        points.extend(&piece.curve.control_points()[1..]);
        degrees.push(piece.curve.degree());
    }
    if degrees.is_empty() {
        points.push(start);
        degrees.push(1);
    }
    Spline::from_parts(points, &degrees, false)
}
