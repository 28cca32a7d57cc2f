//! The teacup and the teaspoon of the tea set to which the Utah teapot belongs.
//!
//! The patches are in the order of the original listing, with v reversed, because in the listing ∂u × ∂v points
//! inwards. The cup stands on the plane z = 0: the point (x, y, z) of the listing, where y is up, becomes (x, −z, y).
//! The bowl of the spoon is open to +z, as in the listing. Equal points are one vertex, numbered in the order of first
//! use.

use super::teapot::{Up, Whole, index_points, revolve, sweep};
use super::{teacup_data, teaspoon_data};
use crate::surface::network::Surface;
use glam::DVec3;

impl Surface {
    /// Newell's teacup on its saucer: 26 bicubic patches, 2 units wide.
    ///
    /// Rim 0–3, outside 4–7, inside 8–11, handle 12–13, saucer 14–25; ∂u × ∂v points outwards. The coordinates are
    /// those of the 1990 tea-set archive, with (x, y, z) of the archive as (x, −z, y) and v reversed; with [`Up::Y`]
    /// the axes are those of the archive. The bottoms of cup and saucer and the ends of the handle are open: 12 of the
    /// 104 edges; the others form 46 pairs.
    pub fn teacup(up: Up) -> Self {
        let mut points = Vec::new();
        for curve in teacup_data::CUP.chunks(4) {
            revolve(curve, -1, &mut points);
        }
        sweep(&teacup_data::HANDLE, &mut points);
        for curve in teacup_data::SAUCER.chunks(4) {
            revolve(curve, -1, &mut points);
        }
        surface(&points, teacup_data::UNITS, up)
    }

    /// Newell's teaspoon: 16 bicubic patches, 1.2 units long, with the bowl open upwards.
    ///
    /// Four groups of four patches around the spoon, from the end of the bowl to the tip of the handle, which points
    /// along −y; ∂u × ∂v points outwards. The coordinates are those of the 1990 tea-set archive with v reversed; with
    /// [`Up::Y`] (x, y, z) becomes (x, z, −y). They are unedited: the two halves differ slightly, and the edges at the
    /// end of the bowl and at the tip leave gaps; 8 edges are open, 28 are shared.
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

/// One control point of cross-section `ring` of the spoon; `around` may exceed the number of points and wraps around.
fn spoon_point(ring: usize, around: usize) -> Whole {
    use teaspoon_data::{ASYMMETRIC_POINTS, HALVES, POINTS_AROUND};
    let around = around % POINTS_AROUND;
    if let Some(odd) = ASYMMETRIC_POINTS
        .iter()
        .find(|odd| (odd.0, odd.1) == (ring, around))
    {
        return odd.2;
    }
    let half = &HALVES[ring];
    match around {
        2..8 => half[around - 2],
        _ => {
            let [x, y, z] = half[(3 + POINTS_AROUND - around) % POINTS_AROUND - 2];
            [-x, y, z]
        }
    }
}

/// The bicubic surface of control points given in integer units.
fn surface(points: &[Whole], units: f64, up: Up) -> Surface {
    let (vertices, indices) = index_points(points);
    let vertices = vertices.iter().map(|p| {
        let [x, y, z] = p.map(|whole| six_digits(f64::from(whole) / units));
        match up {
            Up::Z => DVec3::new(x, y, z),
            // 0 − y avoids −0.
            Up::Y => DVec3::new(x, z, 0.0 - y),
        }
    });
    Surface::bicubic(vertices.collect(), indices)
}

/// x rounded to six decimal digits, as the nearest f64; |x| ≤ 1.
fn six_digits(x: f64) -> f64 {
    let mut scale = 1e6;
    while x.abs() * scale < 1e5 && scale < 1e12 {
        scale *= 10.0;
    }
    // The quotient is rounded only once, because the integer and the power of ten, below 10²², are exact.
    (x * scale).round_ties_even() / scale
}
