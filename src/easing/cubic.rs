//! The CSS timing function `cubic-bezier()`.
//!
//! `js/geometry/easing-bezier.ts` performs the same operations in the same order and gives bit-identical results.

use super::piecewise::clamp_to_finite;

/// The number of pieces of the parameter range. A power of two, so that the Bernstein weights at the nodes are exact.
const PIECES: usize = 32;
/// The width of a piece in t.
const STEP: f64 = 1.0 / 32.0;
/// An error of t that can be neglected: a sixteenth of the rounding error of 1.
const NEGLIGIBLE: f64 = f64::EPSILON / 32.0;
/// Below this ratio of the first piece, Newton's method starts from an estimate of the magnitude of t.
const NEAR_START: f64 = 1.0 / 1024.0;
/// The factor for [`high_part`] that drops half of the bits of a number.
const HALF: f64 = 134_217_728.0; // 2²⁷
/// Handles above this value (2⁹⁰⁰) are scaled by 2⁻¹⁰⁰ for the computation, so that no sum overflows.
const HUGE: f64 = f64::from_bits((1023 + 900) << 52);
/// The scale factor for huge handles.
const SHRUNK: f64 = f64::from_bits((1023 - 100) << 52);
/// A safety limit: four times the maximum number of steps that was ever observed.
const MAX_STEPS: usize = 100;

/// The timing function `cubic-bezier(x1, y1, x2, y2)` for checked handles.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CubicBezier {
    /// The arguments x1, y1, x2, y2.
    pub(crate) handles: [f64; 4],
    nodes: Vec<ExpansionNode>,
    /// For each start of an interval of x of width 1/32, the piece of t that contains it.
    starts: [u8; PIECES],
    /// The slopes at (0, 0) and (1, 1) as CSS defines them.
    slopes: [f64; 2],
    /// Whether both handles lie on the diagonal: y = x.
    linear: bool,
    huge: bool,
}

/// The expansion of the curve about the node t = k/32.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ExpansionNode {
    x: Expansion,
    y: Expansion,
    /// The cubic that approximates the inverse function, x to t, on the piece that begins here.
    inverse_hermite: [f64; 3],
}

/// The Taylor expansion of one coordinate about a node: its value as a sum of two f64, and three coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Expansion {
    value: f64,
    low: f64,
    coefficients: [f64; 3],
}

impl CubicBezier {
    pub(crate) fn new([x1, y1, x2, y2]: [f64; 4]) -> Self {
        let huge = y1.abs().max(y2.abs()) > HUGE;
        let unit = if huge { SHRUNK } else { 1.0 };
        let nodes = nodes([x1, x2], [y1 * unit, y2 * unit], unit);
        Self {
            handles: [x1, y1, x2, y2],
            starts: first_pieces(&nodes),
            nodes,
            slopes: [
                slope(x1, y1, x2, y2),
                slope(1.0 - x2, 1.0 - y2, 1.0 - x1, 1.0 - y1),
            ],
            linear: x1 == y1 && x2 == y2,
            huge,
        }
    }

    pub(crate) fn eval(&self, x: f64) -> f64 {
        if self.linear {
            return x + 0.0; // turns −0 into 0
        }
        if !(x > 0.0 && x < 1.0) {
            return self.extrapolated(x);
        }
        let y = self.solve(x);
        if self.huge {
            clamp_to_finite(y / SHRUNK)
        } else {
            y
        }
    }

    fn extrapolated(&self, x: f64) -> f64 {
        if x == 0.0 || x == 1.0 {
            return x.abs();
        }
        if x < 0.0 {
            clamp_to_finite(slope_times(self.slopes[0], x))
        } else {
            clamp_to_finite(1.0 + slope_times(self.slopes[1], x - 1.0))
        }
    }

    /// The value of y at x between 0 and 1.
    fn solve(&self, mut x: f64) -> f64 {
        #[allow(clippy::cast_possible_truncation, reason = "floored, below 32")]
        #[allow(clippy::cast_sign_loss, reason = "x is above 0")]
        let mut k = usize::from(self.starts[(x * 32.0) as usize]);
        // The piece of t that contains x; x(t) does not descend.
        while self.nodes[k + 1].x.value <= x {
            k += 1;
        }
        if k == 0 {
            // Errors are relative here. Rounding x to 48 bits makes each step of x larger than the error, so that y is
            // monotone.
            x = high_part(x, 32.0).min(self.nodes[1].x.value);
        }
        let ExpansionNode {
            x: before,
            inverse_hermite: [a, b, c],
            ..
        } = self.nodes[k];
        // The first guess of t − k/32, by the interpolated inverse.
        let far = x - before.value;
        let mut d = far * (a + far * (b + far * c));
        if k == 0 && x < self.nodes[1].x.value * NEAR_START {
            d = size_at_start(&before, x);
        } else if d > 0.5 * STEP {
            // Use the nearer node, so that a small difference is added to an exact value.
            k += 1;
            d -= STEP;
        }
        let ExpansionNode { x: along, y, .. } = &self.nodes[k];
        let origin = if k == 0 { 0.0 } else { 1.0 };
        y.at(newton(along, x, d, origin))
    }
}

impl Expansion {
    /// The expansion of one coordinate with the control values 0, a, b, end about t, a multiple of 1/32.
    fn new(t: f64, a: f64, b: f64, end: f64) -> Self {
        let s = 1.0 - t;
        // The weights have at most 15 bits, so their products with the upper half of a number's bits are exact.
        let (u, v, w) = (3.0 * t * s * s, 3.0 * t * t * s, t * t * t * end);
        let (high_a, high_b) = (high_part(a, HALF), high_part(b, HALF));
        let pair = u * high_a + v * high_b;
        let sum = pair + w;
        let low = two_sum_error(u * high_a, v * high_b, pair)
            + two_sum_error(pair, w, sum)
            + u * (a - high_a)
            + v * (b - high_b);
        let value = sum + low;
        Self {
            value,
            low: low - (value - sum),
            coefficients: [
                3.0 * (a * s * s + 2.0 * (b - a) * t * s + (end - b) * t * t),
                3.0 * ((b - 2.0 * a) * s + (end - 2.0 * b + a) * t),
                end + 3.0 * (a - b),
            ],
        }
    }

    fn at(&self, d: f64) -> f64 {
        let [a, b, c] = self.coefficients;
        self.value + (self.low + d * (a + d * (b + d * c)))
    }
}

/// The slope at (0, 0) as CSS defines it: that of the line to the first control point that differs from (0, 0), or 0 if
/// that line is vertical.
fn slope(x1: f64, y1: f64, x2: f64, y2: f64) -> f64 {
    if x1 > 0.0 {
        clamp_to_finite(y1 / x1)
    } else if y1 != 0.0 {
        0.0
    } else if x2 > 0.0 {
        clamp_to_finite(y2 / x2)
    } else if y2 == 0.0 {
        1.0
    } else {
        0.0
    }
}

/// slope · x, with 0 instead of the NaN of 0 · ∞.
fn slope_times(slope: f64, x: f64) -> f64 {
    if slope == 0.0 && !x.is_nan() {
        0.0
    } else {
        slope * x
    }
}

fn nodes([x1, x2]: [f64; 2], [y1, y2]: [f64; 2], top: f64) -> Vec<ExpansionNode> {
    let mut nodes: Vec<ExpansionNode> = (0..=PIECES)
        .map(|k| k as f64 * STEP)
        .map(|t| ExpansionNode {
            x: Expansion::new(t, x1, x2, 1.0),
            y: Expansion::new(t, y1, y2, top),
            inverse_hermite: [0.0; 3],
        })
        .collect();
    for k in 0..PIECES {
        nodes[k].inverse_hermite = inverse_hermite(&nodes[k].x, &nodes[k + 1].x);
    }
    nodes
}

/// The cubic Hermite interpolant of the inverse function, x to t. Its end slopes are limited to three times the slope
/// of the chord, which makes it monotone (Fritsch and Carlson, "Monotone piecewise cubic interpolation", 1980).
fn inverse_hermite(from: &Expansion, to: &Expansion) -> [f64; 3] {
    let width = to.value - from.value;
    let chord = STEP / width;
    let first = (1.0 / from.coefficients[0]).abs().min(3.0 * chord);
    let last = (1.0 / to.coefficients[0]).abs().min(3.0 * chord);
    [
        first,
        (3.0 * chord - 2.0 * first - last) / width,
        (first + last - 2.0 * chord) / width / width,
    ]
}

fn first_pieces(nodes: &[ExpansionNode]) -> [u8; PIECES] {
    let mut piece = 0_u8;
    // The intervals are visited in ascending order, so the search goes on from the piece of the last one.
    std::array::from_fn(|i| {
        let ahead = |piece: u8| nodes[usize::from(piece) + 1].x.value <= i as f64 * STEP;
        while usize::from(piece) + 1 < PIECES && ahead(piece) {
            piece += 1;
        }
        piece
    })
}

/// A number rounded to fewer bits; `less` is 2 to the power of the number of bits dropped (Veltkamp splitting).
fn high_part(value: f64, less: f64) -> f64 {
    let spread = (less + 1.0) * value;
    spread - (spread - value)
}

/// The rounding error of a sum (Knuth's two-sum).
fn two_sum_error(a: f64, b: f64, sum: f64) -> f64 {
    let part = sum - a;
    a - (sum - part) + (b - part)
}

/// An estimate of t for a small x; no single term of the cubic exceeds x there.
fn size_at_start(start: &Expansion, x: f64) -> f64 {
    let fourth = x.sqrt().sqrt();
    let sixteenth = fourth.sqrt().sqrt();
    let cubic = fourth * sixteenth * sixteenth.sqrt().sqrt(); // x to the power 21/64, approximately the cube root
    1.0 / (start.coefficients[0] / x + start.coefficients[1].abs().sqrt() / x.sqrt() + 1.0 / cubic)
}

/// The zero of x(node + d) − x, by Newton's method; a step beyond the bracket is replaced by a bisection.
///
/// The iteration ends when the error that a step leaves, step² · |x″| / (2 x′), is negligible: relative to t at the
/// first node (origin 0), relative to 1 at the others.
fn newton(along: &Expansion, x: f64, mut d: f64, origin: f64) -> f64 {
    let [a, b, c] = along.coefficients;
    // The root of d (a + d (b + d c)) − sought, which does not decrease in d.
    let sought = x - along.value - along.low;
    let (mut min, mut max) = (-origin * STEP, STEP);
    for _ in 0..MAX_STEPS {
        let off = sought - d * (a + d * (b + d * c));
        if off == 0.0 {
            break;
        }
        let speed = a + d * (2.0 * b + 3.0 * d * c);
        let step = off / speed;
        if off > 0.0 {
            min = d;
        } else {
            max = d;
        }
        let left = step * step * (b + 3.0 * d * c).abs();
        let negligible = left <= NEGLIGIBLE * speed * (origin + d);
        d += step;
        if negligible {
            break;
        }
        if !(min..=max).contains(&d) {
            d = 0.5 * (min + max);
        }
    }
    d
}
