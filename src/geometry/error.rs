//! The error type; every error carries the offending value.

use Part::{Number, Text};
use casteljau_kernels::numeric::work_limit::WorkLimit;
use std::fmt;

/// The highest degree of a curve, and of a patch in either direction.
pub const MAX_DEGREE: usize = 64;

/// An invalid argument.
///
/// Degenerate geometry is never an error. Every variant carries the expected and the actual value, so that the message
/// can name both.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A wrong number of control points or values.
    Count {
        /// The counted items.
        what: &'static str,
        /// The rule for the count.
        expected: &'static str,
        /// The actual count.
        got: usize,
    },
    /// A NaN or an infinite value.
    NotFinite {
        /// The argument.
        what: &'static str,
        /// The index of the first such value or point.
        index: usize,
        /// The actual value.
        got: f64,
    },
    /// An index out of range.
    Index {
        /// The indexed items.
        what: &'static str,
        /// The first allowed index.
        first: usize,
        /// The last allowed index.
        last: usize,
        /// The actual index.
        got: usize,
    },
    /// A patch with a vertex index out of range.
    Vertex {
        /// The index of the patch.
        patch: usize,
        /// The number of vertices.
        count: usize,
        /// The invalid vertex index.
        got: usize,
    },
    /// A value outside its range.
    Range {
        /// The argument.
        what: &'static str,
        /// The range in words.
        expected: &'static str,
        /// The actual value.
        got: f64,
    },
    /// One invalid value of a list.
    Item {
        /// The argument.
        what: &'static str,
        /// The index of the first invalid value.
        index: usize,
        /// The allowed values in words.
        expected: &'static str,
        /// The actual value.
        got: f64,
    },
    /// A tolerance finer than the coordinates can resolve.
    Tolerance {
        /// The smallest tolerance for this input, in the unit of the input.
        min: f64,
        /// The actual tolerance.
        got: f64,
    },
    /// A size below the resolution of the numbers of a mesh.
    TooSmall {
        /// The argument.
        what: &'static str,
        /// The smallest value for this input, in the unit of the input.
        min: f64,
        /// The actual value.
        got: f64,
    },
    /// A result above a limit; nothing was allocated for it.
    TooMany {
        /// The items of the result.
        what: &'static str,
        /// The largest allowed number.
        limit: u64,
        /// The required number (the limit plus one if counting stopped there).
        needed: u64,
    },
    /// Curves that should join end to end but do not.
    Gap {
        /// The index of the curve that does not start at the end of the previous one.
        index: usize,
        /// The distance between the two ends.
        got: f64,
    },
    /// A closed spline where an open one is required.
    ClosedSpline {
        /// The operation.
        what: &'static str,
    },
    /// A spline without joints: a single open segment.
    NoJoint,
    /// The joint mode G2 for a spline in space; the formulas are for the plane.
    NotPlane,
    /// A matrix without an inverse.
    Singular {
        /// The argument.
        what: &'static str,
    },
    /// A text that cannot be parsed. Errors of parsers convert to it by `?`; they also have the text that they found.
    Syntax {
        /// The text.
        what: &'static str,
        /// What the parser expected.
        expected: &'static str,
        /// The words "offset" or "line".
        unit: &'static str,
        /// The offset of the error in bytes, or its line, from 1.
        at: usize,
    },
}

/// A part of a message. The caller that displays the message formats the numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Part {
    /// Text.
    Text(&'static str),
    /// A number.
    Number(f64),
}

impl Error {
    /// A result above a limit.
    pub(crate) fn too_many(what: &'static str, limit: usize, needed: usize) -> Self {
        Self::TooMany {
            what,
            limit: limit as u64,
            needed: needed as u64,
        }
    }

    /// An error if a call has taken more steps than its limit allows.
    pub(crate) fn unless_within(what: &'static str, work: &WorkLimit) -> Result<(), Self> {
        let (limit, needed) = work.limit_and_used();
        if needed <= limit {
            return Ok(());
        }
        Err(Self::TooMany {
            what,
            limit,
            needed,
        })
    }

    /// Returns an error for the first number that is a NaN or an infinity.
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

    /// The message in parts: subject, ": expected ", expectation, ", got ", value. `Display` and JavaScript share this
    /// text; JavaScript formats the numbers itself (code that prints an f64 would be a tenth of the wasm module).
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

    /// The invalid item.
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
            Self::ClosedSpline { what } | Self::Singular { what } | Self::Syntax { what, .. } => {
                [Text(what), NONE, NONE, NONE]
            }
            Self::NoJoint => [Text("joint"), NONE, NONE, NONE],
            Self::NotPlane => [Text("mode"), NONE, NONE, NONE],
        }
    }

    /// The expectation.
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
            Self::TooMany { limit, .. } => [Text("at most "), Number(limit as f64), NONE, NONE],
            Self::Gap { .. } => text("to start where the curve before it ends"),
            Self::ClosedSpline { .. } => text("an open spline, which has an end"),
            Self::NoJoint => text("a spline with a joint"),
            Self::NotPlane => text("a plane spline for G2"),
            Self::Singular { .. } => text("a matrix with an inverse"),
            Self::Syntax {
                expected, unit, at, ..
            } => {
                let place = match unit {
                    "line" => " in line ",
                    _ => " at offset ",
                };
                [Text(expected), Text(place), count(at), NONE]
            }
        }
    }

    /// The actual value, and the words before it.
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
            Self::TooMany { needed, .. } => (", this needs ", Number(needed as f64)),
            Self::Gap { got, .. } => (", got a gap of ", Number(got)),
            Self::ClosedSpline { .. } => (", got a closed one", NONE),
            Self::NoJoint => (", got a single open segment", NONE),
            Self::NotPlane => (", got one in space", NONE),
            Self::Singular { .. } => (", got a singular one", NONE),
            Self::Syntax { .. } => ("", NONE),
        }
    }
}

/// An empty part.
const NONE: Part = Text("");

fn count(n: usize) -> Part {
    Number(n as f64)
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.parts().iter().try_for_each(|part| match part {
            Part::Text(text) => f.write_str(text),
            // Integers without a decimal point, other numbers with an exponent if necessary.
            Part::Number(n) if n.fract() == 0.0 && n.abs() < 1e15 => write!(f, "{n:.0}"),
            Part::Number(n) => write!(f, "{n:?}"),
        })
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_work_limit_names_its_steps() {
        let mut work = WorkLimit::new(1 << 30);
        work.raise_limit(1 << 13, 1 << 22);
        work.count(1 << 30);
        work.count(1 << 35);
        assert_eq!(Error::unless_within("steps", &work), Ok(()));
        work.count(1);
        let error = Error::unless_within("steps of the search", &work).expect_err("one too many");
        let message = "steps of the search: expected at most 35433480192, this needs 35433480193";
        assert_eq!(error.to_string(), message);
    }
}
