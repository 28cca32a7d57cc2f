//! The constants of the search. Coordinates are at most about 1; the slack is the distance by which rounding moves points.

/// Heights up to this many times the slack count as 0: the slack of both curves, and of their difference. It is above 1 so
/// that halving ends: a segment is discarded above the slack, and in contact below this.
pub const CONTACT: f64 = 4.0;

/// The parameter at which a segment is halved. It is not the middle, where symmetric curves often intersect, because
/// both halves would find that intersection.
pub(super) const SPLIT: f64 = 0.484375;

/// If a clip leaves more than this part, it is not worth applying, and a segment is halved instead. Source: Sederberg
/// and Nishita.
pub(super) const WORTH_CLIPPING: f64 = 0.8;

/// If clipping leaves more than this part of both segments, they are halved instead. Only the cost depends on it, but it
/// must be below [`WORTH_CLIPPING`]: a clip that leaves more changes nothing, and repeating it would not end.
pub(super) const WORTH_GOING_ON: f64 = 0.6;

/// Newton's method doubles the number of digits with each step; if it needs more steps, there is no crossing nearby.
pub(super) const NEWTON_STEPS: usize = 8;

/// After a step this small, in parameters of the segment, the next step is of the order of its square, 10⁻⁸, and is the
/// last one.
pub(super) const QUADRATIC_STEP: f64 = 1e-4;

/// The last step, on the whole curves, is shorter than this: the square of [`QUADRATIC_STEP`].
pub(super) const MAX_LAST_STEP: f64 = 1e-8;

/// The search is abandoned if a parameter leaves the segment by more than this, in parameters of the segment.
pub(super) const MAX_OVERSHOOT: f64 = 0.5;

/// The smallest sine of the angle of a crossing, in the 1-norm; at a smaller angle the contact is returned as not crossing,
/// and the caller decides its kind.
pub(super) const MIN_CROSSING_SINE: f64 = 1e-5;
