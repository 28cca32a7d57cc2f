//! What can be wrong with path data.

use crate::path::Path;
use std::fmt;

/// Refused path data: where, what was expected there, what came, and what was read before.
///
/// ```
/// use casteljau::Path;
///
/// let error = Path::from_svg("M 10,10 L 20,20,30").unwrap_err();
/// assert_eq!(error.to_string(), "d: expected a number at offset 18, got the end of the text");
/// assert_eq!(error.path.to_svg(None, None)?, "M10,10 L20,20");
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SvgError {
    /// Where, in bytes from the start of the text (all before it is ASCII).
    pub offset: usize,
    /// What would have been right.
    pub expected: &'static str,
    /// The text there, in quotes, up to the next blank or comma.
    pub got: String,
    /// All segments before the error: what SVG asks viewers to draw.
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
