//! Surface area of patches and surfaces.

use super::Patch;
use super::tile_area::TileArea;
use crate::numeric::float::as_f64;
use crate::numeric::sort::sort_by;
use crate::parallel::map_patches;
use crate::surface::network::Surface;
use crate::surface::scaling::Scaling;
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// Relative error at which the integration of the area stops: a tenth of the documented error.
const AREA_ERROR: f64 = 1e-9;

/// Area below which a patch counts as having no area, in units of the square of the patch's size: rounding noise.
const NO_AREA: f64 = 32.0 * f64::EPSILON;

/// The maximum number of steps of one area, about one step for each two multiplications. Only folds, and patches of
/// high degree with many bends, need this many.
const MAX_STEPS: usize = 1 << 22;

/// The maximum number of times that a tile is halved in u and v: it then has 2⁻⁸⁰ of the parameters, which is below the
/// rounding of the sum.
const MAX_ROUNDS: usize = 40;

/// A rectangle of parameters and its area.
#[derive(Clone, Copy)]
struct AreaTile {
    u: [f64; 2],
    v: [f64; 2],
    area: f64,
    /// The change of the parent tile's area when it was split into four, of which this tile is one.
    change_before: f64,
}

/// A tile that is split into four.
struct SplitTile {
    quarters: [AreaTile; 4],
    area: f64,
    /// An estimate of the remaining error of the area.
    error: f64,
}

impl Patch {
    /// The surface area, ∫∫|∂u × ∂v| du dv, with a relative error of at most 1e-8.
    ///
    /// The method is Gauss–Legendre quadrature on tiles, which are split into four until the result changes little.
    /// Regions that the patch covers twice count twice. The area of a patch that is a curve or a point is zero.
    ///
    /// The function takes at most 2²² steps, about one for each two multiplications (some milliseconds). Where the
    /// patch folds back, or has very different sizes along its axes, the result is the best estimate and its fourth
    /// digit may be wrong: the quadrature may miss a fold that cuts off a corner of a tile, and folds may need more
    /// steps.
    pub fn area(&self) -> f64 {
        let scaling = Scaling::around(self.control_bounds());
        let area = scaled_area(&scaling.image(self));
        if area <= NO_AREA {
            return 0.0;
        }
        area * scaling.size * scaling.size
    }
}

impl Surface {
    /// The total area of all patches, with a relative error of at most 1e-8; 0 without patches. See [`Patch::area`].
    pub fn area(&self) -> f64 {
        let area = |k| self.patch(k).map_or(0.0, |patch| patch.area());
        let mut sum = 0.0; // `Iterator::sum` would start with −0
        for area in map_patches(self.patch_count(), area) {
            sum += area;
        }
        sum
    }
}

fn scaled_area(patch: &Patch) -> f64 {
    let points = patch.points.iter().map(|p| p.to_array()).collect();
    let mut rule = TileArea::new(points, patch.columns);
    let mut work = WorkLimit::new(MAX_STEPS);
    let steps_of_split = 2 * (rule.steps(true) + rule.steps(false));
    let mut tiles = vec![AreaTile::new([0.0, 1.0], [0.0, 1.0], 0.0, &mut rule)];
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
        let split: Vec<SplitTile> = tiles.iter().map(|tile| tile.split(&mut rule)).collect();
        let area = split.iter().fold(finished, |sum, tile| sum + tile.area);
        let error: f64 = split.iter().map(|tile| tile.error).sum();
        if is_last || error <= AREA_ERROR * area + NO_AREA {
            return area;
        }
        let allowed = AREA_ERROR * area / (2.0 * as_f64(split.len()));
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

impl AreaTile {
    fn new(u: [f64; 2], v: [f64; 2], change_before: f64, rule: &mut TileArea) -> Self {
        let area = rule.area(u, v);
        Self {
            u,
            v,
            area,
            change_before,
        }
    }

    fn split(&self, rule: &mut TileArea) -> SplitTile {
        let halves = |[from, to]: [f64; 2]| {
            let middle = 0.5 * (from + to);
            [[from, middle], [middle, to]]
        };
        let ([u0, u1], [v0, v1]) = (halves(self.u), halves(self.v));
        // Neighbours in this order share a range of u or of v, which `TileArea` reuses.
        let mut quarters =
            [(u0, v0), (u0, v1), (u1, v1), (u1, v0)].map(|(u, v)| AreaTile::new(u, v, 0.0, rule));
        let area: f64 = quarters.iter().map(|quarter| quarter.area).sum();
        let change = (area - self.area).abs();
        for quarter in &mut quarters {
            quarter.change_before = change;
        }
        // The next split is estimated to change the area in the same proportion as this split did; a quarter of the
        // parent's change is attributed to this tile.
        let error = change * (4.0 * change / self.change_before).min(1.0);
        SplitTile {
            quarters,
            area,
            error,
        }
    }
}
