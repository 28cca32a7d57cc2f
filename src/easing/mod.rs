//! CSS timing functions.

mod css;
mod cubic;
mod piecewise;
mod polyline;
mod scanner;
mod stops;

use crate::geometry::error::Error;
use cubic::CubicBezier;
use piecewise::{Linear, Steps};
use std::fmt;

/// The smallest tolerance of [`Easing::to_linear`], relative to the largest output.
const MIN_TOLERANCE: f64 = 1e-4;

/// A CSS timing function: output progress y over input progress x.
///
/// [`Easing::new`] gives `cubic-bezier(x1, y1, x2, y2)`; [`str::parse`] reads all timing functions of CSS, and
/// [`Display`](fmt::Display) writes them.
///
/// ```
/// use casteljau::Easing;
///
/// let ease = Easing::new(0.25, 0.1, 0.25, 1.0)?;
/// assert_eq!((ease.eval(0.0), ease.eval(1.0)), (0.0, 1.0));
/// assert!((ease.eval(0.5) - 0.802403387584857).abs() < 1e-15);
/// assert_eq!("ease".parse(), Ok(ease));
///
/// let steps: Easing = "steps(4, jump-none)".parse()?;
/// assert_eq!(steps.eval(0.5), 2.0 / 3.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Source: CSS Easing Functions Level 2.
#[derive(Clone, Debug, PartialEq)]
pub struct Easing {
    pub(crate) kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kind {
    Cubic(Box<CubicBezier>),
    Steps(Steps),
    Linear(Linear),
}

/// An error in the text of a CSS timing function: its position, the expected and the actual text.
///
/// ```
/// use casteljau::Easing;
///
/// let error = "steps(4, ende)".parse::<Easing>().unwrap_err();
/// assert_eq!(error.offset, 9);
/// assert_eq!(
///     error.to_string(),
///     "easing: expected jump-start, jump-end, jump-none, jump-both, start or end at offset 9, got \"ende\""
/// );
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EasingError {
    /// The position in bytes from the start of the text.
    pub offset: usize,
    /// What the parser expected.
    pub expected: &'static str,
    /// The text at the position, in quotes, up to the next blank, comma or parenthesis.
    pub got: String,
}

impl fmt::Display for EasingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            offset,
            expected,
            got,
        } = self;
        write!(
            f,
            "easing: expected {expected} at offset {offset}, got {got}"
        )
    }
}

impl std::error::Error for EasingError {}

impl From<EasingError> for Error {
    fn from(error: EasingError) -> Self {
        Self::Syntax {
            what: "easing",
            expected: error.expected,
            unit: "offset",
            at: error.offset,
        }
    }
}

impl Kind {
    /// For checked handles.
    fn cubic(handles: [f64; 4]) -> Self {
        Self::Cubic(Box::new(CubicBezier::new(handles)))
    }
}

impl Easing {
    /// The timing function `cubic-bezier(x1, y1, x2, y2)`.
    ///
    /// The cubic curve from (0, 0) to (1, 1) with the handles (x₁, y₁) and (x₂, y₂), as a function from x to y: x(t) =
    /// 3x₁t(1 − t)² + 3x₂t²(1 − t) + t³, and y(t) in the same way from y₁ and y₂. x₁ and x₂ lie in \[0, 1\], so y is
    /// unique.
    ///
    /// # Errors
    /// [`Error::Range`] for an x outside 0 to 1, a NaN or an infinity.
    pub fn new(x1: f64, y1: f64, x2: f64, y2: f64) -> Result<Self, Error> {
        for (what, got) in [("x1", x1), ("x2", x2)] {
            check(
                what,
                "a number from 0 to 1",
                got,
                (0.0..=1.0).contains(&got),
            )?;
        }
        for (what, got) in [("y1", y1), ("y2", y2)] {
            check(what, "a finite number", got, got.is_finite())?;
        }
        let kind = Kind::cubic([x1, y1, x2, y2]);
        Ok(Self { kind })
    }

    /// The value of y at x.
    ///
    /// `cubic-bezier()`: exact at 0 and 1; between them the result is y(t) for a t with |x(t) − x| ≤ 10⁻¹⁵. Below 0 and
    /// above 1 it is extrapolated along the line from the end to the nearest control point that differs from it; if that
    /// line is vertical, the result is constant.
    ///
    /// `steps()` and `linear()`: at a jump the value after it. Below 0 and above 1 the steps, and the first and the last
    /// part of `linear()`, continue.
    ///
    /// Overflow gives the largest finite number. NaN gives NaN.
    pub fn eval(&self, x: f64) -> f64 {
        if x.is_nan() {
            return x;
        }
        match &self.kind {
            Kind::Cubic(cubic) => cubic.eval(x),
            Kind::Steps(steps) => steps.eval(x),
            Kind::Linear(linear) => linear.eval(x),
        }
    }

    /// The function as the text of a CSS `linear()` whose output differs by at most `tolerance` for x from 0 to 1.
    ///
    /// For a cubic curve no `linear()` with fewer stops stays within 96 % of the tolerance, and the outputs at 0 and 1
    /// are exact. A `linear()` keeps its jumps and ends, and loses the stops between them that the tolerance permits;
    /// `steps()` remain as they are.
    ///
    /// ```
    /// use casteljau::Easing;
    ///
    /// let ease_in_out = "ease-in-out".parse::<Easing>()?;
    /// assert_eq!(ease_in_out.to_linear(0.1)?, "linear(0, 0.09 23%, 0.91 77%, 1)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a tolerance below 10⁻⁴, or below 10⁻⁴ of a larger y₁, y₂ or stop, a NaN or an infinity;
    /// [`Error::TooMany`] for more than 32,767 steps.
    pub fn to_linear(&self, tolerance: f64) -> Result<String, Error> {
        let scale = match &self.kind {
            Kind::Cubic(cubic) => 1.0_f64
                .max(cubic.handles[1].abs())
                .max(cubic.handles[3].abs()),
            Kind::Linear(linear) => linear
                .stops
                .iter()
                .fold(1.0_f64, |most, [_, y]| most.max(y.abs())),
            Kind::Steps(_) => 1.0,
        };
        let is_finite = tolerance.is_finite();
        check("tolerance", "a finite number", tolerance, is_finite)?;
        let is_large = tolerance >= MIN_TOLERANCE * scale;
        let expected = "at least 0.0001 of the largest output";
        check("tolerance", expected, tolerance, is_large)?;
        Ok(match &self.kind {
            Kind::Cubic(cubic) => {
                css::written_linear(&stops::fewest_stops(cubic.handles, tolerance, scale))
            }
            Kind::Steps(steps) => css::written_linear(&steps.stops()?),
            Kind::Linear(linear) => {
                css::written_linear(&stops::reduced_stops(&linear.stops, tolerance, scale))
            }
        })
    }
}

fn check(what: &'static str, expected: &'static str, got: f64, holds: bool) -> Result<(), Error> {
    if holds {
        return Ok(());
    }
    Err(Error::Range {
        what,
        expected,
        got,
    })
}
