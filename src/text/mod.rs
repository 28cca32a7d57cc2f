//! Numbers as text, and parts of a text in the messages of errors.

pub(crate) mod number;
pub(crate) mod shown;
