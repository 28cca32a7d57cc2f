//! What can be refused, always with the offending value.

use std::fmt;

/// The highest degree of a curve, and of a patch in either direction.
pub const MAX_DEGREE: usize = 64;

/// A refusal: the caller's input is not what the function works on.
///
/// Degenerate geometry is never an error. Every variant carries what was expected and what came, so that the
/// message can name both.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number of control points (or of values) that does not fit.
    Count {
        /// What was counted.
        what: &'static str,
        /// The rule that the count must follow.
        expected: &'static str,
        /// The count that came.
        got: usize,
    },
    /// A NaN or an infinite value.
    NotFinite {
        /// The argument.
        what: &'static str,
        /// The index of the first such value or point.
        index: usize,
        /// The value that came.
        got: f64,
    },
    /// An index past the end.
    Index {
        /// What is indexed.
        what: &'static str,
        /// The first allowed index.
        first: usize,
        /// The last allowed index.
        last: usize,
        /// The index that came.
        got: usize,
    },
    /// A value outside of its range.
    Range {
        /// The argument.
        what: &'static str,
        /// The range in words.
        expected: &'static str,
        /// The value that came.
        got: f64,
    },
    /// A tolerance below what the coordinates can resolve.
    Tolerance {
        /// The least tolerance for this input, in the input's unit.
        least: f64,
        /// The tolerance that came.
        got: f64,
    },
    /// A result that would pass a limit; nothing was allocated for it.
    TooMany {
        /// What would be made.
        what: &'static str,
        /// The greatest allowed number.
        limit: usize,
        /// The number that the request needs (the limit plus one where counting stopped there).
        needed: usize,
    },
    /// Curves that should join end to end and do not.
    Gap {
        /// The index of the curve that does not start where the one before it ends.
        index: usize,
        /// The distance between the two ends.
        got: f64,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Count {
                what,
                expected,
                got,
            } => write!(f, "{what}: expected {expected}, got {got}"),
            Self::NotFinite { what, index, got } => {
                write!(f, "{what}[{index}]: expected a finite number, got {got}")
            }
            Self::Index {
                what,
                first,
                last,
                got,
            } => {
                write!(
                    f,
                    "{what}: expected an index from {first} to {last}, got {got}"
                )
            }
            Self::Range {
                what,
                expected,
                got,
            } => write!(f, "{what}: expected {expected}, got {got}"),
            Self::Tolerance { least, got } => {
                write!(
                    f,
                    "tolerance: expected at least {least:e} for coordinates of this size, got {got:e}"
                )
            }
            Self::TooMany {
                what,
                limit,
                needed,
            } => {
                write!(f, "{what}: expected at most {limit}, this needs {needed}")
            }
            Self::Gap { index, got } => {
                write!(
                    f,
                    "curves[{index}]: expected to start where the curve before it ends, got a gap of {got:e}"
                )
            }
        }
    }
}

impl std::error::Error for Error {}
