//! The constants of the intersections. Those of the search are a table of their own, `clipping/constants.rs` of the kernels.
//!
//! Curves are compared at size 1. Rounding moves their points by at most the slack σ = 2ε(L + n + 1), where L is their
//! largest coordinate and n their degree. Distances are limited to multiples of σ. A parameter cannot be: where a distance
//! grows with the kth power of a difference of parameters, rounding hides differences up to ᵏ√σ. For cubics near the
//! origin σ is about 2·10⁻¹⁵, √σ 5·10⁻⁸, ³√σ 10⁻⁵ and ⁴√σ 2·10⁻⁴.
//!
//! How much depends on them was measured with half and twice each constant (but for those of the slack, and for `SPLIT` and the
//! two of what is worth clipping) on 9,600 pairs of curves: random ones of degree 1
//! to 5, with coordinates 0 to 4, parts of one curve, copies moved by 10⁻³ to 10⁻¹⁶, tangent, with a common end, with a cusp,
//! far from the origin. The number or the kinds of intersections change in at most 4 pairs, except for [`CONTACT`] (15
//! with half of it, 7 with twice) and [`EQUAL_POINTS`] (17 and 8).

use crate::bernstein::roots::DOUBLE_ROOT;
pub(super) use casteljau_kernels::curve::intersect::clipping::CONTACT;

// The slack.

/// The rounding of an input coordinate: up to one ulp in each coordinate of both curves.
pub(super) const INPUT_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Rounding of evaluation and subdivision at size 1, for each degree.
pub(super) const STEP_ROUNDING: f64 = 2.0 * f64::EPSILON;

// Distances, as multiples of the slack.

/// Two points are equal: each curve may be off by the slack.
pub(super) const EQUAL_POINTS: f64 = 2.0;

/// The two points at an end of an overlap, and points of an overlap outside its box: rounding of the parameters may
/// double the height of a contact.
pub(super) const END_OF_CONTACT: f64 = 2.0 * CONTACT;

/// A height is certainly not 0: four times one that counts as 0.
pub(super) const CLEAR_HEIGHT: f64 = 4.0 * CONTACT;

/// An overlap is longer; a shorter one is a point. Contacts are not joined across a reversal of a curve that is farther
/// than this from both contacts.
pub(super) const MIN_OVERLAP: f64 = 64.0;

/// Rounding rotates the direction of a curve by at most this multiple of the slack divided by its speed.
pub(super) const ROTATION: f64 = 16.0;

// Parameters and sines that differ by some roundings.

/// Equal numbers up to 1.
pub(super) const ONE_PARAMETER: f64 = 8.0 * f64::EPSILON;

/// Equal directions.
pub(super) const PARALLEL: f64 = 4.0 * f64::EPSILON;

/// The ends of two contacts are one.
pub(super) const ONE_END_OF_CONTACTS: f64 = 1e-13;

/// A crossing at a common end of two segments, which is found in both.
pub(super) const ONE_CROSSING: f64 = 1e-12;

/// Crossings of one interval are two, and intersections after all steps are not the same one.
pub(super) const TWO_CROSSINGS: f64 = 1e-10;

// Roots of the slack.

/// Ten times the accuracy of a double root, which is some √σ. A shorter contact has no direction: it may be one tangency, whatever the directions of the curves. The
/// boxes of the segments between contacts are widened by their size and this, because the ends of contacts correspond
/// only roughly.
pub(super) const MANY_DOUBLE_ROOTS: f64 = 10.0 * DOUBLE_ROOT;

/// The largest sine of the angle between the directions at a contact of higher order after Newton's method has
/// converged: some √σ.
pub(super) const NEARLY_PARALLEL: f64 = 1e-7;

/// Directions closer than this count as equal where rounding hides the difference: at a distance of 10⁻⁸ from a cusp,
/// directions change by as much.
pub(super) const HIDDEN_TURN: f64 = 1e-6;

/// The distance, at size 1, of intersections that are one if an end or a zero of B′ lies between them: some √σ.
pub(super) const SAME_POINT_DISTANCE: f64 = 1e-8;

/// The largest parameter difference of such intersections: the square root of their distance, because next to a zero of
/// B′ the distance grows with the square of the parameter.
pub(super) const NEARBY_PARAMETERS: f64 = 1e-4;

/// The difference of a parameter from an end to which it is snapped: ³√σ, because the distance grows with the third power
/// of the parameter where both B′ and B″ vanish at the end.
pub(super) const NEAR_END: f64 = 1e-5;

/// A loop shorter than this, in parameters, is a cusp up to rounding: some ³√σ, because next to a cusp the branches separate
/// with the third power of the parameter.
pub(super) const MIN_LOOP: f64 = 2e-5;

// Ratios that are far from both cases that they distinguish.

/// The deviation of u from a linear function of t within a contact, as a part of the square of its width.
pub(super) const MAX_CURVING: f64 = 0.01;

/// The largest gap, in either parameter, between contacts or crossings that may belong together; whether they do is
/// decided by heights.
pub(super) const LARGEST_GAP: f64 = 0.05;

// Numbers of steps.

/// Maximum number of pairs of segments: a fixed number, and an additional one for each degree above 3. This is more
/// than ten times what 999 of 1000 curves with moderate numbers need, also if one of them nearly coincides with the
/// other.
pub(super) const MAX_PAIRS: usize = 4096;
pub(super) const MAX_PAIRS_PER_DEGREE: usize = 256;

/// At a contact of higher order each step of Newton's method at least about halves the error: enough for the 53 bits of a
/// parameter, with 7 as a reserve.
pub(super) const TANGENCY_STEPS: usize = f64::MANTISSA_DIGITS as usize + 7;

/// From a good starting point, Newton's method for crossings ends much sooner.
pub(super) const CROSSING_STEPS: usize = 20;

/// Number of parts of a segment for the comparison with a box.
pub(super) const BOX_SAMPLES: usize = 8;

/// Depth of halving of a curve that may cross itself: half of the bits reach √ε and 4 more are below √σ. A segment that
/// still reverses contains a cusp smaller than rounding.
pub(super) const LOOP_HALVINGS: usize = f64::MANTISSA_DIGITS as usize / 2 + 4;

/// Maximum number of segments: about one on each side of every halving next to the cusps of a curve of degree 64.
pub(super) const MAX_SEGMENTS: usize = 1 << 12;
