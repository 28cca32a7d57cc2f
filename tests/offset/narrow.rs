//! Offsets whose distance is small relative to the curve's bends or to the tolerance.

use crate::common::plane;
use crate::error;

/// Beside the curve's cusp the offset has a cusp of its own, which rounding of the derivative does not decide.
#[test]
fn an_offset_cusp_beside_a_cusp_of_the_curve() {
    let curve = plane(&[
        (0.0, 0.0),
        (0.9935563923557464, 0.9842993896513079),
        (0.25775673990529824, 0.9860995950286244),
        (0.7357996524504482, -0.0018002053773165105),
    ]);
    let found = error(&curve, 0.0062708664085428766, 0.0002418974111902895);
    assert!(found <= 1.0, "{found} tolerances");
}

/// A tolerance just below twice the distance does not allow a curve on the other side.
#[test]
fn a_tolerance_above_the_distance_is_kept() {
    let curve = plane(&[(-1.0, -1.0), (0.0, -2.0), (0.0, 2.0), (-2.0, 2.0)]);
    let found = error(&curve, -0.0307959074354502, 0.060898472809483795);
    assert!(found <= 1.0, "{found} tolerances");
}
