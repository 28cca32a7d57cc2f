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
    /// A patch that names a vertex which is not there.
    Vertex {
        /// The patch.
        patch: usize,
        /// The number of vertices.
        count: usize,
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
    /// One value of a list that does not fit.
    Item {
        /// The argument.
        what: &'static str,
        /// The index of the first such value.
        index: usize,
        /// What would fit, in words.
        expected: &'static str,
        /// The value that came.
        got: f64,
    },
    /// A tolerance below what the coordinates can resolve.
    Tolerance {
        /// The least tolerance for this input, in the input's unit.
        min: f64,
        /// The tolerance that came.
        got: f64,
    },
    /// A size below what the numbers of a mesh can show.
    TooSmall {
        /// The argument.
        what: &'static str,
        /// The least value for this input, in the input's unit.
        min: f64,
        /// The value that came.
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

/// A piece of a message: the words are ours, the numbers are written by whoever shows it.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Part {
    /// Words.
    Text(&'static str),
    /// A number.
    Number(f64),
}

impl Error {
    /// Refuses the first of some numbers that is a NaN or an infinity.
    pub(crate) fn unless_finite(what: &'static str, numbers: &[f64]) -> Result<(), Self> {
        match numbers.iter().position(|x| !x.is_finite()) {
            Some(index) => Err(Self::NotFinite {
                what,
                index,
                got: numbers[index],
            }),
            None => Ok(()),
        }
    }

    /// The message in pieces. One wording serves `Display` and JavaScript, which writes its own numbers (the code that
    /// prints an f64 would be a tenth of the wasm module).
    pub(crate) fn parts(&self) -> [Part; 7] {
        use Part::{Number, Text};
        let count = |n: usize| Number(n as f64);
        let none = Text("");
        match *self {
            Self::Count {
                what,
                expected,
                got,
            } => [
                Text(what),
                Text(": expected "),
                Text(expected),
                Text(", got "),
                count(got),
                none,
                none,
            ],
            Self::NotFinite { what, index, got } => [
                Text(what),
                Text("["),
                count(index),
                Text("]: expected a finite number, got "),
                Number(got),
                none,
                none,
            ],
            Self::Index {
                what,
                first,
                last,
                got,
            } => [
                Text(what),
                Text(": expected an index from "),
                count(first),
                Text(" to "),
                count(last),
                Text(", got "),
                count(got),
            ],
            Self::Vertex { patch, count, got } => [
                Text("patches["),
                Number(patch as f64),
                Text("]: expected vertex indices below "),
                Number(count as f64),
                Text(", got "),
                Number(got as f64),
                none,
            ],
            Self::Range {
                what,
                expected,
                got,
            } => [
                Text(what),
                Text(": expected "),
                Text(expected),
                Text(", got "),
                Number(got),
                none,
                none,
            ],
            Self::Item {
                what,
                index,
                expected,
                got,
            } => [
                Text(what),
                Text("["),
                count(index),
                Text("]: expected "),
                Text(expected),
                Text(", got "),
                Number(got),
            ],
            Self::Tolerance { min, got } => [
                Text("tolerance: expected at least "),
                Number(min),
                Text(" (4 ulps of the largest coordinate)"),
                Text(", got "),
                Number(got),
                none,
                none,
            ],
            Self::TooSmall { what, min, got } => [
                Text(what),
                Text(": expected at least "),
                Number(min),
                Text(" (f32 shows nothing smaller here)"),
                Text(", got "),
                Number(got),
                none,
            ],
            Self::TooMany {
                what,
                limit,
                needed,
            } => [
                Text(what),
                Text(": expected at most "),
                count(limit),
                Text(", this needs "),
                count(needed),
                none,
                none,
            ],
            Self::Gap { index, got } => [
                Text("curves["),
                count(index),
                Text("]: expected to start where the curve before it ends"),
                Text(", got a gap of "),
                Number(got),
                none,
                none,
            ],
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.parts().iter().try_for_each(|part| match part {
            Part::Text(text) => f.write_str(text),
            // Counts without a decimal point, measures with an exponent where they need one.
            Part::Number(n) if n.fract() == 0.0 && n.abs() < 1e15 => write!(f, "{n:.0}"),
            Part::Number(n) => write!(f, "{n:?}"),
        })
    }
}

impl std::error::Error for Error {}
