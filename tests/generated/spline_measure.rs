//! Checks.

use crate::runner::Row;

pub(crate) const ROWS: &[Row] = &[];
