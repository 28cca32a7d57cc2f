//! How large is the surface?

use super::Patch;
use super::tile_area::TileArea;
use crate::numeric::float::ratio;
use crate::numeric::sort::sort_by;
use crate::surface::frame::Frame;
use crate::surface::network::Surface;
use casteljau_kernels::WorkLimit;

/// The error of an area that is aimed at: a tenth of what is promised.
const AREA_ERROR: f64 = 1e-9;

/// In units of the patch's size squared, what is left of an area where there is none.
const NO_AREA: f64 = 32.0 * f64::EPSILON;

/// The most steps of an area, about one for each two multiplications. Only folds need so many, and patches of high degrees
/// that have as many bends.
const MAX_STEPS: usize = 1 << 22;

/// Tiles are halved no more often than this in u and v.
const MAX_ROUNDS: usize = 40;

/// A rectangle of parameters, with its area.
#[derive(Clone, Copy)]
struct Tile {
    u: [f64; 2],
    v: [f64; 2],
    area: f64,
    /// By how much the area of the tile that this is a quarter of changed when it was split.
    change_before: f64,
}

/// A tile that was split in four.
struct Split {
    quarters: [Tile; 4],
    area: f64,
    /// An estimate of what the area is still off by.
    error: f64,
}

impl Patch {
    /// The area, ∫∫|∂u × ∂v| du dv, within 1e-8 of itself.
    ///
    /// Gauss and Legendre's rule on tiles, split in four until that changes little. What the patch covers twice counts
    /// twice. Zero for a patch that is a curve or a point.
    ///
    /// At most 2²² steps, about one for each two multiplications (some milliseconds). Where the patch folds back, or has
    /// very different sizes along its axes, the result is the best estimate and the fifth digit may be off: the rule may
    /// miss a fold that cuts a corner of a tile off, and folds may need more steps. Where coordinates differ by many
    /// powers of ten, the fourth.
    pub fn area(&self) -> f64 {
        let frame = Frame::around(self.control_bounds());
        let area = area_in_frame(&frame.image(self));
        if area <= NO_AREA {
            return 0.0;
        }
        area * frame.size * frame.size
    }
}

impl Surface {
    /// The area of all patches together, within 1e-8 of itself; 0 without patches. See [`Patch::area`].
    pub fn area(&self) -> f64 {
        // Not `sum`, which begins with −0.
        self.patches().fold(0.0, |sum, patch| sum + patch.area())
    }
}

fn area_in_frame(patch: &Patch) -> f64 {
    let points = patch.points.iter().map(|p| p.to_array()).collect();
    let mut rule = TileArea::new(points, patch.columns);
    let mut work = WorkLimit::new(MAX_STEPS);
    let steps_of_split = 2 * (rule.steps(true) + rule.steps(false));
    let mut tiles = vec![Tile::new([0.0, 1.0], [0.0, 1.0], 0.0, &mut rule)];
    let mut finished = 0.0;
    for _ in 0..MAX_ROUNDS {
        let affordable = (MAX_STEPS - work.used()) / steps_of_split;
        let is_last = tiles.len() > affordable;
        if is_last {
            sort_by(&mut tiles, |a, b| {
                b.change_before.total_cmp(&a.change_before)
            });
            finished += tiles.drain(affordable..).map(|tile| tile.area).sum::<f64>();
        }
        if !work.spend(tiles.len() * steps_of_split) {
            break;
        }
        let split: Vec<Split> = tiles.iter().map(|tile| tile.split(&mut rule)).collect();
        let area = split.iter().fold(finished, |sum, tile| sum + tile.area);
        let error: f64 = split.iter().map(|tile| tile.error).sum();
        if is_last || error <= AREA_ERROR * area + NO_AREA {
            return area;
        }
        let allowed = AREA_ERROR * area / (2.0 * ratio(split.len(), 1));
        tiles.clear();
        for tile in split {
            if tile.error > allowed {
                tiles.extend(tile.quarters);
            } else {
                finished += tile.area;
            }
        }
    }
    tiles.iter().fold(finished, |sum, tile| sum + tile.area)
}

impl Tile {
    fn new(u: [f64; 2], v: [f64; 2], change_before: f64, rule: &mut TileArea) -> Self {
        let area = rule.area(u, v);
        Self {
            u,
            v,
            area,
            change_before,
        }
    }

    fn split(&self, rule: &mut TileArea) -> Split {
        let halves = |[from, to]: [f64; 2]| {
            let middle = 0.5 * (from + to);
            [[from, middle], [middle, to]]
        };
        let ([u0, u1], [v0, v1]) = (halves(self.u), halves(self.v));
        // Neighbours in this order share a range, which the rule makes use of.
        let mut quarters =
            [(u0, v0), (u0, v1), (u1, v1), (u1, v0)].map(|(u, v)| Tile::new(u, v, 0.0, rule));
        let area: f64 = quarters.iter().map(|quarter| quarter.area).sum();
        let change = (area - self.area).abs();
        for quarter in &mut quarters {
            quarter.change_before = change;
        }
        // The area changes once more as it did last time, a quarter of that change having been this tile's.
        let error = change * (4.0 * change / self.change_before).min(1.0);
        Split {
            quarters,
            area,
            error,
        }
    }
}
