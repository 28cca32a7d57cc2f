//! Widths that vary along a path.

use crate::geometry::error::Error;

/// What the positions of a [`WidthProfile`] measure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum WidthPosition {
    /// The arc length from the start of the subpath, as a fraction of its length.
    #[default]
    Length,
    /// The parameter, divided by the number of segments of the subpath.
    T,
}

/// How widths are interpolated between the stops of a [`WidthProfile`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum WidthInterpolation {
    /// Linearly.
    #[default]
    Linear,
    /// By cubics that have a common slope at each stop and exceed no width.
    Smooth,
}

/// The width of a stroke along each subpath, for [`Path::stroke_with`](crate::Path::stroke_with).
///
/// The width is given at stops, whose positions are fractions from 0, the start of a subpath, to 1, its end. Before the
/// first stop the width is that of the first one, after the last stop that of the last one.
///
/// ```
/// use casteljau::Path;
/// use casteljau::path::{StrokeOptions, WidthInterpolation, WidthProfile};
///
/// let wave: Path = "M0 0C40 60 60 -60 100 0".parse().expect("path data");
/// let leaf = WidthProfile::new(&[(0.0, 0.0), (0.5, 12.0), (1.0, 0.0)])
///     .interpolation(WidthInterpolation::Smooth);
/// let outline = wave.stroke_with(&leaf, &StrokeOptions::default())?;
/// assert_eq!(outline.subpath_count(), 1);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct WidthProfile {
    /// What the positions of the stops measure: the arc length by default.
    pub at: WidthPosition,
    /// The positions, ascending from 0 to 1, and the widths.
    pub stops: Vec<(f64, f64)>,
    /// How widths are interpolated: linearly by default.
    pub interpolation: WidthInterpolation,
}

impl WidthProfile {
    /// A linear profile by arc length, from pairs of a position and a width.
    pub fn new(stops: &[(f64, f64)]) -> Self {
        Self {
            at: WidthPosition::default(),
            stops: stops.to_vec(),
            interpolation: WidthInterpolation::default(),
        }
    }

    /// The same width everywhere.
    pub fn constant(width: f64) -> Self {
        Self::new(&[(0.0, width)])
    }

    /// Sets what the positions measure.
    #[must_use]
    pub fn at(self, at: WidthPosition) -> Self {
        Self { at, ..self }
    }

    /// Sets how widths are interpolated.
    #[must_use]
    pub fn interpolation(self, interpolation: WidthInterpolation) -> Self {
        Self {
            interpolation,
            ..self
        }
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        if self.stops.is_empty() {
            return Err(Error::Count {
                what: "stops",
                expected: "at least 1",
                got: 0,
            });
        }
        let mut last = -f64::MIN_POSITIVE;
        for (index, &(position, width)) in self.stops.iter().enumerate() {
            let item = |what, expected, got| Error::Item {
                what,
                index,
                expected,
                got,
            };
            if !(position > last && position <= 1.0) {
                let expected = "a position from 0 to 1, greater than the one before";
                return Err(item("stops", expected, position));
            }
            if !(0.0..=f64::MAX).contains(&width) {
                return Err(item("widths", "a finite number, at least 0", width));
            }
            last = position;
        }
        Ok(())
    }

    pub(super) fn max(&self) -> f64 {
        self.stops.iter().fold(0.0, |max, stop| max.max(stop.1))
    }
}

/// The radius, half the width, as a piecewise polynomial of the position.
pub(super) struct Radii {
    pub(super) at: WidthPosition,
    /// Whether positions above 1 continue at the start; those of an open subpath exceed 1 by rounding only.
    closed: bool,
    /// Position, radius and slope at each stop.
    stops: Vec<[f64; 3]>,
    interpolation: WidthInterpolation,
    /// The radii on the left and on the right, if they are different; then the radius is constant.
    pub(super) sides: Option<[f64; 2]>,
}

/// A cubic polynomial of the position.
#[derive(Clone, Copy)]
pub(super) struct RadiusPolynomial {
    from: f64,
    coefficients: [f64; 4],
}

impl RadiusPolynomial {
    /// The radius and its first two derivatives.
    pub(super) fn at(&self, position: f64) -> [f64; 3] {
        let (x, [a, b, c, d]) = (position - self.from, self.coefficients);
        [
            a + x * (b + x * (c + x * d)),
            b + x * (2.0 * c + x * 3.0 * d),
            2.0 * c + x * 6.0 * d,
        ]
    }

    /// Bounds of the sizes of the radius and its derivatives between two positions.
    pub(super) fn bounds(&self, ends: [f64; 2]) -> [f64; 4] {
        let x = ends.map(|end| (end - self.from).abs());
        let (x, [a, b, c, d]) = (x[0].max(x[1]), self.coefficients.map(f64::abs));
        [
            a + x * (b + x * (c + x * d)),
            b + x * (2.0 * c + x * 3.0 * d),
            2.0 * c + x * 6.0 * d,
            6.0 * d,
        ]
    }

    pub(super) fn is_linear(&self) -> bool {
        self.coefficients[2..] == [0.0; 2]
    }

    pub(super) fn is_constant(&self) -> bool {
        self.coefficients[1..] == [0.0; 3]
    }

    pub(super) fn is_zero(&self) -> bool {
        self.coefficients == [0.0; 4]
    }
}

impl Radii {
    /// Expects a checked profile; the widths are multiplied by a scale.
    pub(super) fn new(profile: &WidthProfile, scale: f64, closed: bool) -> Self {
        let radius = |&(position, width): &(f64, f64)| [position, 0.5 * width * scale, 0.0];
        let mut stops: Vec<[f64; 3]> = profile.stops.iter().map(radius).collect();
        let is_constant = stops.iter().all(|stop| stop[1] == stops[0][1]);
        if is_constant {
            stops.truncate(1);
        }
        if profile.interpolation == WidthInterpolation::Smooth {
            set_slopes(&mut stops);
        }
        Self {
            // Without a change of the width, positions do not matter, and lengths need not be found.
            at: if is_constant {
                WidthPosition::T
            } else {
                profile.at
            },
            closed,
            stops,
            interpolation: profile.interpolation,
            sides: None,
        }
    }

    pub(super) fn is_constant(&self) -> bool {
        self.stops.len() == 1
    }

    /// The positions of the stops between two positions.
    pub(super) fn stops_between(&self, from: f64, to: f64) -> impl Iterator<Item = f64> + '_ {
        let first = self.stops.partition_point(|stop| stop[0] <= from);
        let inside = self.stops[first..].iter().map(|stop| stop[0]);
        inside.take_while(move |&position| position < to)
    }

    /// The radii at the start and at the end.
    pub(super) fn ends(&self) -> [f64; 2] {
        [0.0, 1.0].map(|position| self.polynomial(position).at(position)[0])
    }

    /// How often positions pass the start: not at all, and once for a closed subpath.
    pub(super) fn rounds(&self) -> &'static [f64] {
        if self.closed { &[0.0, 1.0] } else { &[0.0] }
    }

    /// The polynomial around a position.
    pub(super) fn polynomial(&self, position: f64) -> RadiusPolynomial {
        let round = if self.closed && position > 1.0 {
            1.0
        } else {
            0.0
        };
        let next = self
            .stops
            .partition_point(|stop| stop[0] <= position - round);
        let constant = |[from, radius, _]: [f64; 3]| RadiusPolynomial {
            from: from + round,
            coefficients: [radius, 0.0, 0.0, 0.0],
        };
        let (Some(&before), Some(&after)) = (
            next.checked_sub(1).and_then(|k| self.stops.get(k)),
            self.stops.get(next),
        ) else {
            return constant(self.stops[next.min(self.stops.len() - 1)]);
        };
        let (h, rise) = (after[0] - before[0], after[1] - before[1]);
        let secant = rise / h;
        let coefficients = match self.interpolation {
            WidthInterpolation::Linear => [before[1], secant, 0.0, 0.0],
            WidthInterpolation::Smooth => {
                let (a, b) = (before[2], after[2]);
                // Hermite interpolation, in powers of the distance from the stop before.
                let c = (3.0 * secant - 2.0 * a - b) / h;
                [before[1], a, c, (a + b - 2.0 * secant) / (h * h)]
            }
        };
        RadiusPolynomial {
            from: before[0] + round,
            coefficients,
        }
    }
}

/// Sets the slopes so that the cubics are monotone between stops.
///
/// A slope is the harmonic mean of the slopes of both chords, weighted by their lengths, and 0 where these have different
/// signs; at an end of the subpath it is that of the chord. Source: Fritsch and Butland, "A method for constructing local
/// monotone piecewise cubic interpolants", SIAM J. Sci. Stat. Comput. 5 (1984).
fn set_slopes(stops: &mut [[f64; 3]]) {
    let chord = |a: [f64; 3], b: [f64; 3]| (b[0] - a[0], (b[1] - a[1]) / (b[0] - a[0]));
    for k in 0..stops.len() {
        let before = k.checked_sub(1).map(|b| chord(stops[b], stops[k]));
        let after = stops.get(k + 1).map(|&next| chord(stops[k], next));
        // Beside the first and the last stop the width is constant, unless the subpath ends there.
        let at_end = stops[k][0] == 0.0 || stops[k][0] == 1.0;
        stops[k][2] = match (before, after) {
            (Some((g, p)), Some((h, q))) if p * q > 0.0 => {
                let (v, w) = (g + 2.0 * h, 2.0 * g + h);
                (v + w) / (v / p + w / q)
            }
            (None, Some((_, slope))) | (Some((_, slope)), None) if at_end => slope,
            _ => 0.0,
        };
    }
}
