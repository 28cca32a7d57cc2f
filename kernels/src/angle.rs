//! Cosine and sine of moderate angles. The functions of the standard library handle all numbers and take 8 kB of the
//! wasm module.

use std::f64::consts::FRAC_PI_2;

/// The difference of π/2 and the nearest f64.
const REST_OF_HALF_PI: f64 = 6.123_233_995_736_766e-17;

/// Number of terms of the series; the first omitted term is below 1e-19 at π/4.
const TERMS: u32 = 9;

/// cos and sin of an angle of at most a few turns, with an error of at most two ulps of 1.
pub fn cos_sin(angle: f64) -> (f64, f64) {
    let quarters = (angle / FRAC_PI_2).round();
    let rest = (angle - quarters * FRAC_PI_2) - quarters * REST_OF_HALF_PI;
    // 1 − x²/2 (1 − x²/12 (1 − …)) and x (1 − x²/6 (1 − x²/20 (1 − …))).
    let (mut cos, mut sin) = (1.0, 1.0);
    let square = rest * rest;
    for k in (1..TERMS).rev() {
        let k = 2.0 * f64::from(k);
        cos = 1.0 - square * cos / (k * (k - 1.0));
        sin = 1.0 - square * sin / (k * (k + 1.0));
    }
    sin *= rest;
    let quarters = quarters - 4.0 * (0.25 * quarters).floor();
    if quarters == 0.0 {
        (cos, sin)
    } else if quarters == 1.0 {
        (-sin, cos)
    } else if quarters == 2.0 {
        (-cos, -sin)
    } else {
        (sin, -cos)
    }
}
