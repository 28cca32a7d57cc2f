//! Data of the teacup and its saucer: half-profiles and cross-sections.
//!
//! Provenance: the 1990 tea-set archive as printed in freeglut 3.4.0's `fg_teapot_data.h` (MIT-style licence). The
//! archive contains its original measures divided by 1.1 and rounded to six digits. The original measures are integer
//! multiples of 1/1000; the tables contain them in units of 1/1100. Dividing and rounding to six digits gives the
//! published decimals bit for bit. The direction of each curve is opposite to v of the archive, so that normals point
//! outwards.

use super::teapot_data::{Ring, TubeSection};

/// The tables are in units of 1 / `UNITS`.
pub(crate) const UNITS: f64 = 1100.0;

/// The profile curves of the cup: rim, outside, inside; four rings each.
pub(crate) const CUP: [Ring; 12] = [
    [500, 280, 850],
    [500, 280, 975],
    [450, 252, 975],
    [450, 252, 850],
    [350, 196, 50],
    [500, 280, 300],
    [500, 280, 600],
    [500, 280, 850],
    [450, 252, 850],
    [450, 252, 600],
    [450, 252, 300],
    [300, 168, 50],
];

/// The cross-sections of the handle from its lower end: one curve.
pub(crate) const HANDLE: [TubeSection; 4] = [
    [-450, 400, -450, 325, -50],
    [-850, 575, -1000, 525, -50],
    [-850, 950, -900, 1050, -50],
    [-500, 775, -500, 850, -50],
];

/// The profile curves of the saucer: upper side, edge, underside; four rings each.
pub(crate) const SAUCER: [Ring; 12] = [
    [1000, 560, 150],
    [800, 448, 150],
    [600, 336, 50],
    [350, 196, 50],
    [1000, 560, 100],
    [1100, 616, 100],
    [1100, 616, 150],
    [1000, 560, 150],
    [350, 196, 0],
    [600, 336, 0],
    [800, 448, 100],
    [1000, 560, 100],
];
