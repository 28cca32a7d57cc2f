//! Offsets whose distance is small relative to the curve's bends or to the tolerance.

use crate::offset::error;
use crate::support::plane;

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

/// The curve almost stops and turns back: the rounding of its derivative there rotates the normal by more than the
/// tolerance, but the offset is an arc whose radius is known.
#[test]
fn an_arc_about_a_sharp_turn_keeps_the_tolerance() {
    let quadratic = plane(&[
        (6.856891647420488e-13, -1.2263523790540343e-11),
        (11.64056369313804, -60.574972054505),
        (3.304547698250419e-11, 2.635000407296085e-11),
    ]);
    let cubic = plane(&[
        (0.0, 0.0),
        (-1.4466308420087906, -0.7057648816983153),
        (-0.9040531342634578, -0.03651582919143115),
        (-0.5425777072027551, -0.6692490518376351),
    ]);
    for (curve, distance, tolerance) in [
        (quadratic, -1522.9248717258197, 0.03821814127545613),
        (cubic, -43.64697232990304, 0.00020517047360263214),
    ] {
        let found = error(&curve, distance, tolerance);
        assert!(found <= 1.0, "{found} tolerances, {curve:?}");
    }
}
