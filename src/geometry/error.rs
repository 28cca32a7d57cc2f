//! What can be refused, always with the offending value.

use Part::{Number, Text};
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

/// A part of a message. Whoever shows the message formats the numbers.
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

    /// The message in parts: subject, ": expected ", expectation, ", got ", value. One wording serves `Display` and
    /// JavaScript, which formats its own numbers (code that prints an f64 would be a tenth of the wasm module).
    pub(crate) fn parts(&self) -> [Part; 11] {
        let [s0, s1, s2, s3] = self.subject();
        let [e0, e1, e2, e3] = self.expectation();
        let (separator, value) = self.value();
        let expected = Text(": expected ");
        [
            s0,
            s1,
            s2,
            s3,
            expected,
            e0,
            e1,
            e2,
            e3,
            Text(separator),
            value,
        ]
    }

    /// What does not fit.
    fn subject(&self) -> [Part; 4] {
        let item = |what, index: usize| [Text(what), Text("["), count(index), Text("]")];
        match *self {
            Self::Count { what, .. }
            | Self::Index { what, .. }
            | Self::Range { what, .. }
            | Self::TooSmall { what, .. }
            | Self::TooMany { what, .. } => [Text(what), NONE, NONE, NONE],
            Self::NotFinite { what, index, .. } | Self::Item { what, index, .. } => {
                item(what, index)
            }
            Self::Vertex { patch, .. } => item("patches", patch),
            Self::Tolerance { .. } => [Text("tolerance"), NONE, NONE, NONE],
            Self::Gap { index, .. } => item("curves", index),
        }
    }

    /// What would fit.
    fn expectation(&self) -> [Part; 4] {
        let text = |text| [Text(text), NONE, NONE, NONE];
        let minimum = |min, why| [Text("at least "), Number(min), Text(why), NONE];
        match *self {
            Self::Count { expected, .. }
            | Self::Range { expected, .. }
            | Self::Item { expected, .. } => text(expected),
            Self::NotFinite { .. } => text("a finite number"),
            Self::Index { first, last, .. } => {
                let words = [Text("an index from "), Text(" to ")];
                [words[0], count(first), words[1], count(last)]
            }
            Self::Vertex { count: n, .. } => [Text("vertex indices below "), count(n), NONE, NONE],
            Self::Tolerance { min, .. } => minimum(min, " (4 ulps of the largest coordinate)"),
            Self::TooSmall { min, .. } => minimum(min, " (f32 shows nothing smaller here)"),
            Self::TooMany { limit, .. } => [Text("at most "), count(limit), NONE, NONE],
            Self::Gap { .. } => text("to start where the curve before it ends"),
        }
    }

    /// The value that came, and the words before it.
    fn value(&self) -> (&'static str, Part) {
        match *self {
            Self::Count { got, .. } | Self::Index { got, .. } | Self::Vertex { got, .. } => {
                (", got ", count(got))
            }
            Self::NotFinite { got, .. }
            | Self::Range { got, .. }
            | Self::Item { got, .. }
            | Self::Tolerance { got, .. }
            | Self::TooSmall { got, .. } => (", got ", Number(got)),
            Self::TooMany { needed, .. } => (", this needs ", count(needed)),
            Self::Gap { got, .. } => (", got a gap of ", Number(got)),
        }
    }
}

/// A part without words.
const NONE: Part = Text("");

fn count(n: usize) -> Part {
    Number(n as f64)
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
