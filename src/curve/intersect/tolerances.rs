//! Tolerances that several steps of the intersection share.

/// An overlap is longer than this many times the slack; a shorter one is a point. Contacts are not
/// joined across a reversal of a curve that is farther than this from both contacts.
pub(super) const MIN_OVERLAP: f64 = 64.0;

/// The largest gap, in either parameter, between contacts or crossings that may belong together.
pub(super) const LARGEST_GAP: f64 = 0.05;

/// Heights up to this many times the slack count as 0: the slack of both curves, and of their difference.
pub(super) const NO_HEIGHT: f64 = 4.0;
