//! The limit on the size of exported files.

use crate::geometry::error::Error;

/// The most bytes of a file: 1 GiB.
const MAX_BYTES: usize = 1 << 30;

/// Refuses files above the limit.
pub(crate) fn checked_length(length: usize) -> Result<usize, Error> {
    if length <= MAX_BYTES {
        return Ok(length);
    }
    Err(Error::TooMany {
        what: "bytes",
        limit: MAX_BYTES,
        needed: length,
    })
}
