//! Errors of the SVG path data parser.

use crate::geometry::error::Error;
use crate::path::Path;
use std::fmt;

/// An error in SVG path data: its position, the expected and the actual text, and the path before it.
///
/// ```
/// use casteljau::Path;
///
/// let error = Path::from_svg("M 10,10 L 20,20,30").unwrap_err();
/// assert_eq!(error.to_string(), "d: expected a number at offset 18, got the end of the text");
/// assert_eq!(error.path.to_svg(), "M10,10 L20,20");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SvgError {
    /// The position in bytes from the start of the text (all text before it is ASCII).
    pub offset: usize,
    /// What the parser expected.
    pub expected: &'static str,
    /// The text at the position, in quotes, up to the next blank or comma.
    pub got: String,
    /// All segments before the error, which SVG requires viewers to draw.
    pub path: Path,
}

impl fmt::Display for SvgError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            offset,
            expected,
            got,
            ..
        } = self;
        write!(f, "d: expected {expected} at offset {offset}, got {got}")
    }
}

impl std::error::Error for SvgError {}

impl From<SvgError> for Error {
    fn from(error: SvgError) -> Self {
        Self::Syntax {
            what: "d",
            expected: error.expected,
            unit: "offset",
            at: error.offset,
        }
    }
}
