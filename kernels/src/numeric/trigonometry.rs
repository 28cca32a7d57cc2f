//! Trigonometric functions from basic arithmetic.
//!
//! Sums, products, quotients and square roots are identical on every platform; library functions such as sine are not,
//! and take 8 kB of the wasm module. The Rust and the JavaScript parser must return bit-identical paths:
//! `js/io/svg-arc.ts` performs the same operations.

use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

/// The difference of π/2 and the nearest f64.
const REST_OF_HALF_PI: f64 = 6.123_233_995_736_766e-17;

/// This number of terms of the series leaves an error below 2⁻⁵³ up to π/4: (π/4)¹⁹/19! < 10⁻¹⁹.
const TERMS: usize = 9;
/// The number of terms for the arc tangent up to tan(π/16): 0.2²⁷/27 < 10⁻²⁰.
const TANGENT_TERMS: usize = 13;

/// (cos x, sin x) for |x| ≤ π/4, by Taylor series.
pub fn unit_vector(x: f64) -> DVec2 {
    let square = x * x;
    let (mut cos, mut sin) = (1.0, 1.0);
    for k in (1..=TERMS).rev() {
        let n = 2.0 * k as f64;
        cos = 1.0 - square / ((n - 1.0) * n) * cos;
        sin = 1.0 - square / (n * (n + 1.0)) * sin;
    }
    DVec2::new(cos, sin * x)
}

/// (cos φ, sin φ) of an angle in degrees; exact at multiples of 90°.
pub fn unit_vector_of_degrees(degrees: f64) -> DVec2 {
    let rest = degrees % 360.0;
    let quarters = (rest / 90.0 + 0.5).floor();
    let unit = unit_vector((rest - 90.0 * quarters) * (std::f64::consts::PI / 180.0));
    quarter_turns(unit, (quarters + 4.0) % 4.0)
}

/// (cos x, sin x) of an angle of at most a few turns, with an error of at most two ulps of 1.
pub fn cos_sin(angle: f64) -> (f64, f64) {
    let quarters = (angle / FRAC_PI_2).round();
    let rest = (angle - quarters * FRAC_PI_2) - quarters * REST_OF_HALF_PI;
    let rotated = quarter_turns(
        unit_vector(rest),
        quarters - 4.0 * (0.25 * quarters).floor(),
    );
    (rotated.x, rotated.y)
}

/// A vector turned by 90° a given number of times, from 0 to 3.
fn quarter_turns(unit: DVec2, quarters: f64) -> DVec2 {
    match quarters {
        1.0 => DVec2::new(-unit.y, unit.x),
        2.0 => -unit,
        3.0 => DVec2::new(unit.y, -unit.x),
        _ => unit,
    }
}

/// The angle of a unit vector in the first quadrant: halved three times (tan(x/2) = sin x / (1 + cos x)), then computed
/// by the series of the arc tangent.
pub fn angle(unit: DVec2) -> f64 {
    let (mut cos, mut tan) = (unit.x, unit.y / (1.0 + unit.x));
    for _ in 0..2 {
        cos = (0.5 * (1.0 + cos)).sqrt();
        // Here tan(x/2) is computed with sin x = tan x · cos x.
        tan = tan * cos / (1.0 + cos);
    }
    let square = tan * tan;
    let mut sum = 0.0;
    for k in (0..TANGENT_TERMS).rev() {
        sum = 1.0 / (2 * k + 1) as f64 - square * sum;
    }
    8.0 * tan * sum
}

/// A vector rotated by the angle of a unit vector.
pub fn rotated(v: DVec2, by: DVec2) -> DVec2 {
    DVec2::new(v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x)
}

#[cfg(test)]
mod tests {
    use super::cos_sin;

    #[test]
    fn cos_sin_is_that_of_the_standard_library() {
        for k in -4000..=4000 {
            let angle = f64::from(k) * 0.002_345;
            let (cos, sin) = cos_sin(angle);
            assert!((cos - angle.cos()).abs() <= 4.5e-16, "cos {angle}: {cos}");
            assert!((sin - angle.sin()).abs() <= 4.5e-16, "sin {angle}: {sin}");
        }
        assert_eq!(cos_sin(0.0), (1.0, 0.0));
    }
}
