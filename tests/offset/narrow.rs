//! Offsets whose distance is small relative to the curve's bends or to the tolerance.

use crate::offset::error;
use crate::support::bezier;

#[test]
fn the_tolerance_is_kept() {
    for (points, distance, tolerance) in [
        // Beside the curve's cusp the offset has a cusp of its own, which rounding of the derivative does not decide.
        (
            "0 0, 0.9935563923557464 0.9842993896513079, 0.25775673990529824 0.9860995950286244,
             0.7357996524504482 -0.0018002053773165105",
            0.0062708664085428766,
            0.0002418974111902895,
        ),
        // A tolerance just below twice the distance does not allow a curve on the other side.
        (
            "-1 -1, 0 -2, 0 2, -2 2",
            -0.0307959074354502,
            0.060898472809483795,
        ),
        // These curves almost stop and turn back: the rounding of their derivative there rotates the normal by more
        // than the tolerance, but the offset is an arc whose radius is known.
        (
            "6.856891647420488e-13 -1.2263523790540343e-11, 11.64056369313804 -60.574972054505,
             3.304547698250419e-11 2.635000407296085e-11",
            -1522.9248717258197,
            0.03821814127545613,
        ),
        (
            "0 0, -1.4466308420087906 -0.7057648816983153,
             -0.9040531342634578 -0.03651582919143115, -0.5425777072027551 -0.6692490518376351",
            -43.64697232990304,
            0.00020517047360263214,
        ),
        // Both ends are one point within the tolerance and B′ is 0 there, but the middle is 5.5 away.
        (
            "0 0, 0 0, 0 0, 10 0, 10 0.0001, 0 0.0001, 0 0.0001, 0 0.0001",
            -5.0,
            0.01,
        ),
    ] {
        let found = error(&bezier(points), distance, tolerance);
        assert!(found <= 1.0, "{found} tolerances: {points}");
    }
}
