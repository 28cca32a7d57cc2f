//! The teapot's companions from the same archive: teacup and teaspoon.
//!
//! Patch for patch the figures are those of the listing, with v reversed: there ∂u × ∂v points inwards. The cup stands
//! on the plane z = 0, with (x, y, z) of the listing, where y is up, as (x, −z, y); the spoon lies with its bowl open
//! to +z, as in the listing. Coincident points are one vertex, numbered in the order in which patches use them.

use super::teapot::{Up, Whole, share, sweep, turn};
use super::{teacup_data, teaspoon_data};
use crate::surface::network::Surface;
use glam::DVec3;

impl Surface {
    /// Newell's teacup on its saucer: 26 bicubic patches, 2 wide.
    ///
    /// Rim 0–3, outside 4–7, inside 8–11, handle 12–13, saucer 14–25; ∂u × ∂v points outwards. The figures are those of
    /// the 1990 tea-set archive, (x, y, z) there being (x, −z, y) here and v running the other way; with [`Up::Y`] the
    /// axes are the archive's. The bottoms of cup and saucer and the ends of the handle are open: of 104 sides 12, the
    /// others make 46 pairs.
    pub fn teacup(up: Up) -> Self {
        let mut points = Vec::new();
        for curve in teacup_data::CUP.chunks(4) {
            turn(curve, -1, &mut points);
        }
        sweep(&teacup_data::HANDLE, &mut points);
        for curve in teacup_data::SAUCER.chunks(4) {
            turn(curve, -1, &mut points);
        }
        surface(&points, teacup_data::UNITS, up)
    }

    /// Newell's teaspoon: 16 bicubic patches, 1.2 long, the bowl open upwards.
    ///
    /// Four groups of four patches around, from the bowl's end to the tip of the handle, which points along −y; ∂u × ∂v
    /// points outwards. The figures are those of the 1990 tea-set archive with v running the other way; with [`Up::Y`]
    /// its (x, y, z) becomes (x, z, −y). As the archive has them, unedited: the two halves differ a little, and the
    /// last sides at the bowl's end and at the tip leave gaps, 8 open sides beside 28 shared ones.
    pub fn teaspoon(up: Up) -> Self {
        let mut points = Vec::new();
        for group in 0..4 {
            for quarter in 0..4 {
                for ring in (3 * group..=3 * group + 3).rev() {
                    let row = 3 * quarter..=3 * quarter + 3;
                    points.extend(row.map(|around| spoon_point(ring, around)));
                }
            }
        }
        surface(&points, teaspoon_data::UNITS, up)
    }
}

/// One control point of the spoon's cross-section `ring`; `around` counts on past the last one.
fn spoon_point(ring: usize, around: usize) -> Whole {
    use teaspoon_data::{AROUND, HALVES, ODD};
    let around = around % AROUND;
    if let Some(odd) = ODD.iter().find(|odd| (odd.0, odd.1) == (ring, around)) {
        return odd.2;
    }
    let half = &HALVES[ring];
    match around {
        2..8 => half[around - 2],
        _ => {
            let [x, y, z] = half[(3 + AROUND - around) % AROUND - 2];
            [-x, y, z]
        }
    }
}

/// The bicubic surface of control points in whole units.
fn surface(points: &[Whole], units: f64, up: Up) -> Surface {
    let (vertices, indices) = share(points);
    let vertices = vertices.iter().map(|p| {
        let [x, y, z] = p.map(|whole| six_digits(f64::from(whole) / units));
        match up {
            Up::Z => DVec3::new(x, y, z),
            // 0 − y: no −0.
            Up::Y => DVec3::new(x, z, 0.0 - y),
        }
    });
    Surface::bicubic(vertices.collect(), indices)
}

/// The nearest f64 to x rounded to six decimal digits; |x| ≤ 1.
fn six_digits(x: f64) -> f64 {
    let mut scale = 1e6;
    while x.abs() * scale < 1e5 && scale < 1e12 {
        scale *= 10.0;
    }
    // A whole number over a power of ten below 10²², both exact, so the quotient is rounded once.
    (x * scale).round_ties_even() / scale
}
