//! Least squares for the lengths of both handles of a cubic with given ends and end tangents.
//!
//! A point of the cubic moves by 3u(1 − u)² t₀ with the length of the first handle, and by −3u²(1 − u) t₁ with that of the
//! second one, where t₀ and t₁ are the unit tangents. So the vectors from some targets to points of the cubic depend
//! linearly on both lengths. Fits of points, offset curves and sides of strokes solve these equations some times, each time
//! with parameters nearer to the feet of the targets.

use crate::numeric::vector::Euclidean;

/// Rounds of least squares. The last ones gain digits if the tolerance is far below the first error; with 5 instead of 6
/// some fits, offsets and strokes take one cubic more, and none is faster.
pub const MAX_ROUNDS: usize = 6;

/// The damping that is added to the diagonal of the normal equations, as a part of the trace: if the cubic is nearly
/// straight, the handles do not influence the distances.
const DAMPING: f64 = 1e-9;

/// The minimum damping for targets without noise; the entries of the matrix are of the order of 1 or smaller.
pub const MIN_DAMPING: f64 = 1e-18;

/// The normal equations of the changes of both lengths.
#[derive(Default)]
pub struct HandleEquations {
    aa: f64,
    ab: f64,
    bb: f64,
    ra: f64,
    rb: f64,
}

impl HandleEquations {
    /// Adds the vector from a target to the point of the cubic at u. Where only some components count, the tangents and this
    /// vector are given by these components, or by their multiples of one unit vector.
    #[inline(always)]
    pub fn add<V: Euclidean>(&mut self, u: f64, [t0, t1]: [V; 2], off: V) {
        let r = 1.0 - u;
        let (ja, jb) = (t0 * (3.0 * u * r * r), t1 * (-3.0 * u * u * r));
        self.aa += ja.dot(ja);
        self.ab += ja.dot(jb);
        self.bb += jb.dot(jb);
        self.ra -= ja.dot(off);
        self.rb -= jb.dot(off);
    }

    /// The changes of both lengths with the least squares.
    #[inline]
    pub fn solved(&self, min_damping: f64) -> [f64; 2] {
        let damping = DAMPING * (self.aa + self.bb) + min_damping;
        let (aa, bb) = (self.aa + damping, self.bb + damping);
        let scale = 1.0 / (aa * bb - self.ab * self.ab);
        [
            (self.ra * bb - self.rb * self.ab) * scale,
            (self.rb * aa - self.ra * self.ab) * scale,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::{HandleEquations, MIN_DAMPING};
    use crate::bernstein::derivatives::CubicWithDerivatives;
    use glam::DVec2;

    /// The targets are points of a cubic at known parameters, so the equations are exact.
    #[test]
    fn the_handles_of_a_cubic_are_found_at_once() {
        let (start, end) = (DVec2::ZERO, DVec2::new(4.0, 1.0));
        let tangents = [DVec2::new(0.6, 0.8), DVec2::new(0.8, -0.6)];
        let point = |[a, b]: [f64; 2], u: f64| {
            let inner = [start + tangents[0] * a, end - tangents[1] * b];
            CubicWithDerivatives::new([start, inner[0], inner[1], end]).at(u)[0]
        };
        let (expected, guess) = ([1.5, 0.7], [1.0, 1.2]);
        let mut equations = HandleEquations::default();
        for u in [0.25, 0.5, 0.75] {
            equations.add(u, tangents, point(guess, u) - point(expected, u));
        }
        let changes = equations.solved(MIN_DAMPING);
        for k in 0..2 {
            let found = guess[k] + changes[k];
            assert!((found - expected[k]).abs() < 1e-7, "{found}");
        }
    }

    #[test]
    fn handles_without_influence_keep_their_lengths() {
        let mut equations = HandleEquations::default();
        equations.add(0.5, [0.0, 0.0], 1.0);
        assert_eq!(equations.solved(MIN_DAMPING), [0.0, 0.0]);
    }
}
