//! The vertices of a polyline along a quadratic or cubic.
//!
//! The curve is divided into eight equal parts. A bound on its deviation from chords in a part gives a rate: the number
//! of chords for each unit of t. The vertices divide the integral of the rates evenly, so that few chords end at the
//! boundary of a part. Chords inside a part need no test; those across a boundary are measured, and if one of them is too
//! long, the boundary becomes a vertex.

use crate::bernstein::evaluate::weigh4;
use crate::geometry::point::{CrossProduct, Point};
use casteljau_kernels::bernstein::de_casteljau::split_cubic_with;
use casteljau_kernels::curve::chord_rates::{ChordRates, PARTS, rates_in_plane, rates_in_space};
use std::ops::Range;

/// The length of a part.
const PART_LENGTH: f64 = 1.0 / PARTS as f64;

/// The bounds are wasteful if they give more chords than one of these multiples of the estimate plus a number: for few
/// chords, and for many.
const WASTEFUL: [(f64, f64); 2] = [(1.5, 3.0), (1.3, 24.0)];

/// A range of t that is not halved any more: the curve is a point there, up to rounding.
const MIN_LENGTH: f64 = 1.0 / (1_u64 << 40) as f64;

/// The Taylor expansion at some t: B(t + s) − B(t) = s D₁ + s² D₂ + s³ D₃.
#[derive(Clone, Copy)]
struct CubicTaylor<P> {
    first: P,
    second: P,
    third: P,
}

impl<P: Point> CubicTaylor<P> {
    /// The expansion at 0 of the curve with the given control points times `scale`.
    fn of([p0, p1, p2, p3]: [P; 4], scale: f64) -> Self {
        // D₁ = 3 ΔP₀, D₂ = 3 Δ²P₀, D₃ = Δ³P₀.
        let (e0, e1, e2) = ((p1 - p0) * scale, (p2 - p1) * scale, (p3 - p2) * scale);
        Self {
            first: e0 * 3.0,
            second: (e1 - e0) * 3.0,
            third: (e2 - e1) - (e1 - e0),
        }
    }

    /// B(t + s) − B(t).
    #[inline(always)]
    fn offset(&self, s: f64) -> P {
        (self.first + (self.second + self.third * s) * s) * s
    }

    #[inline(always)]
    fn derivative(&self, s: f64) -> P {
        self.first + (self.second * 2.0 + self.third * (3.0 * s)) * s
    }

    /// The expansion at t + s.
    #[inline(always)]
    fn moved(&self, s: f64) -> Self {
        Self {
            first: self.derivative(s),
            second: self.second + self.third * (3.0 * s),
            third: self.third,
        }
    }

    /// See [`rates_in_plane`].
    fn rates(&self, per_tolerance: f64) -> ChordRates {
        let coefficients = [self.first, self.second, self.third];
        if P::DIMENSION == 2 {
            let plane = coefficients.map(|p| p.to_2d().to_array());
            rates_in_plane(&plane, per_tolerance)
        } else {
            let space = coefficients.map(|p| p.to_3d().to_array());
            rates_in_space(&space, per_tolerance)
        }
    }

    /// Whether the chord from here to s keeps the tolerance: the distance from the chord is s²·σ(1 − σ) times a linear
    /// function of σ from 0 to 1, divided by the length of the chord.
    #[inline]
    fn chord_is_within(&self, s: f64, tolerance: f64) -> bool {
        let Self {
            first,
            second,
            third,
            ..
        } = *self;
        // (B(t + σs) − B(t)) × (D₁ + sD₂ + s²D₃) = s²σ(1 − σ) (a + bs(1 + σ) + cs²σ). `start` and `end` are its last
        // factor for σ = 0 and 1.
        let (a, b, c) = (first.cross(second), first.cross(third), second.cross(third));
        let start = a + b * s;
        let end = start + (b + c * s) * s;
        // The chord divided by s.
        let chord = first + (second + third * s) * s;
        let (leaves, arrives) = (first.dot(chord), self.derivative(s).dot(chord));
        let square = chord.dot(chord);
        // Then the inner control points are between the ends along the chord, and so is the curve.
        let is_inside = leaves.min(arrives) >= 0.0 && leaves.max(arrives) <= 3.0 * square;
        // σ(1 − σ) ≤ ¼, so the distance is at most s²/4 · max(|start|, |end|) / |chord|.
        let farthest = s * s * s * s * start.size_squared().max(end.size_squared());
        square > 0.0 && is_inside && farthest <= 16.0 * tolerance * tolerance * square
    }
}

/// A cubic in equal parts, and the rates of chords in them.
pub(super) struct CubicParts<P> {
    /// The start of each part.
    starts: [P; PARTS],
    /// Scaled.
    parts: [CubicTaylor<P>; PARTS],
    rates: [f64; PARTS],
    tolerance: f64,
    inverse_scale: f64,
    /// The integral of the rates.
    sum: f64,
    /// An estimate of the smallest number of chords that is possible.
    min_chords: f64,
}

/// Passes on the curve with the given control points and its range of t, or parts of it: it is halved while the bounds
/// are far above what its curvature needs, as at a cusp. The differences of the control points times `scale` have a
/// moderate size.
pub(super) fn visit_parts<P: Point>(
    points: [P; 4],
    [from, length]: [f64; 2],
    scale: f64,
    tolerance: f64,
    visit: &mut impl FnMut(&CubicParts<P>, [f64; 2]),
) {
    let parts = CubicParts::new(points, scale, tolerance);
    if parts.is_wasteful() && length > MIN_LENGTH {
        let (left, right) = split_cubic_with(points, |a, b| (a + b) * 0.5);
        let half = 0.5 * length;
        visit_parts(left, [from, half], scale, tolerance, visit);
        visit_parts(right, [from + half, half], scale, tolerance, visit);
    } else {
        visit(&parts, [from, length]);
    }
}

impl<P: Point> CubicParts<P> {
    fn new(points: [P; 4], scale: f64, tolerance: f64) -> Self {
        let whole = CubicTaylor::of(points, scale);
        let tolerance = tolerance * scale;
        let ChordRates { enough, minimum } = whole.rates(0.125 / tolerance);
        let rates = enough.map(f64::from);
        Self {
            starts: std::array::from_fn(|k| weigh4(points, k as f64 * PART_LENGTH)),
            parts: std::array::from_fn(|k| whole.moved(k as f64 * PART_LENGTH)),
            sum: rates.iter().sum::<f64>() * PART_LENGTH,
            min_chords: f64::from(minimum.iter().sum::<f32>()) * PART_LENGTH,
            rates,
            tolerance,
            inverse_scale: 1.0 / scale,
        }
    }

    /// The number of chords, if none has to end at a boundary; a whole number.
    pub(super) fn chord_count(&self) -> f64 {
        self.sum.ceil().max(1.0)
    }

    fn is_wasteful(&self) -> bool {
        let limits = WASTEFUL.map(|(ratio, more)| ratio * self.min_chords + more);
        self.sum > limits[0].min(limits[1])
    }

    /// Calls `vertex` with t and the point for all vertices inside (0, 1).
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "numbers of chords, below 2^25"
    )]
    pub(super) fn visit_inner_vertices(&self, vertex: &mut impl FnMut(f64, P)) {
        let chords = self.chord_count();
        // Each chord gets the same share of the integral, at most 1.
        let (share, per_share) = (self.sum / chords, chords / self.sum);
        let mut remaining = chords as u32 - 1;
        // The last vertex, the first boundary after it, and the integral of the rates up to the next vertex.
        let (mut from, mut boundary, mut left) = (0.0, 1, share);
        for (k, (part, &rate)) in self.parts.iter().zip(&self.rates).enumerate() {
            let (start, within) = (k as f64 * PART_LENGTH, rate * PART_LENGTH);
            if remaining == 0 {
                break;
            }
            if left >= within {
                left -= within;
                continue;
            }
            // The rate is constant in a part, so its vertices are equal steps in t apart.
            let per_rate = 1.0 / rate;
            let (first, step) = (left * per_rate, share * per_rate);
            // A vertex may be at a boundary, before or after rounding.
            let inside = usize::from(start + first > start);
            self.emit_boundary_vertices(from, start + first, boundary..k + inside, vertex);
            let more = (((within - left) * per_share) as u32).min(remaining - 1);
            for i in 0..=more {
                let t = start + (first + f64::from(i) * step);
                vertex(
                    t,
                    self.starts[k] + part.offset(t - start) * self.inverse_scale,
                );
            }
            from = start + (first + f64::from(more) * step);
            boundary = k + 1 + usize::from(from >= start + PART_LENGTH);
            remaining -= more + 1;
            left += f64::from(more + 1) * share - within;
        }
        self.emit_boundary_vertices(from, 1.0, boundary..PARTS, vertex);
    }

    /// Adds boundaries inside a chord as vertices, so that the parts of the chord keep the tolerance.
    #[inline]
    fn emit_boundary_vertices(
        &self,
        from: f64,
        to: f64,
        boundaries: Range<usize>,
        vertex: &mut impl FnMut(f64, P),
    ) {
        // A chord without a boundary inside keeps the tolerance, because of the rate of its part.
        if let Some(before) = boundaries.clone().next().map(|first| first - 1) {
            let at = self.parts[before].moved(from - before as f64 * PART_LENGTH);
            if !at.chord_is_within(to - from, self.tolerance) {
                self.divide(from, to, boundaries, vertex);
            }
        }
    }

    #[cold]
    fn divide(
        &self,
        from: f64,
        to: f64,
        Range { start, end }: Range<usize>,
        vertex: &mut impl FnMut(f64, P),
    ) {
        let middle = usize::midpoint(start, end - 1);
        let t = middle as f64 * PART_LENGTH;
        self.emit_boundary_vertices(from, t, start..middle, vertex);
        vertex(t, self.starts[middle]);
        self.emit_boundary_vertices(t, to, middle + 1..end, vertex);
    }
}
