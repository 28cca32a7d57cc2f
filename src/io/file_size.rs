//! The limit on the size of exported files.

use crate::geometry::error::Error;

/// The maximum size of a file in bytes: 1 GiB.
const MAX_BYTES: usize = 1 << 30;

/// Returns an error for a file above the limit.
pub(crate) fn checked_length(length: usize) -> Result<usize, Error> {
    if length <= MAX_BYTES {
        return Ok(length);
    }
    Err(Error::too_many("bytes", MAX_BYTES, length))
}
