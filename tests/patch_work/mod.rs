//! The work of queries on patches, counted in steps and not in time: no call takes more than its documentation states.

mod beyond;
mod generate;
mod worst;

use crate::support::nets::{RandomNet, as_surface, graph, patch, points, samples};
use crate::support::{Rng, near};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::{Grid, TessellationOptions, Weld};
use casteljau::patch::PatchPoint;
use casteljau::take_steps;
use casteljau::{Error, Patch};
use generate::{any_patch, any_point, any_ray};

/// The documented limit of one search in a patch of degree at most 24.
const SEARCH: usize = 1 << 23;

/// The documented limit of a ray.
const RAY: usize = 1 << 27;

/// The steps of one piece or of one start of Newton's method: a search may exceed its limit by this number.
const ONE_MORE: usize = 1 << 22;

/// The number of calls of each function.
fn calls() -> u64 {
    crate::support::cases(200, 40_000) as u64
}

/// A patch of degrees up to 3 or up to 24, and the random number generator after its generation.
fn generated(seed: u64) -> (Rng, Patch) {
    let mut random = Rng(seed);
    let max_degree = random.pick(&[3, 24]);
    let patch = any_patch(&mut random, max_degree);
    (random, patch)
}

/// Runs a query on generated patches, and checks the steps of each call.
#[track_caller]
fn never_takes_more(limit: usize, ask: impl Fn(&mut Rng, &Patch)) {
    for seed in 0..calls() {
        let (mut random, patch) = generated(seed);
        take_steps();
        ask(&mut random, &patch);
        let steps = take_steps();
        assert!(steps <= limit, "seed {seed}: {steps} steps of {patch:?}");
    }
}

#[test]
fn of_the_nearest_point() {
    // Two searches: by squared distances, and by distances where these are small.
    never_takes_more(2 * (SEARCH + ONE_MORE), |random, patch| {
        let p = any_point(random, patch);
        let nearest = patch.nearest(p).unwrap();
        assert!(nearest.point.is_finite() && !nearest.distance.is_nan());
        assert_eq!(nearest.point, patch.eval(nearest.u, nearest.v));
        // No other point of the patch is nearer, except for rounding of the coordinates.
        let bounds = patch.control_bounds();
        let rounding = 2e-15 * bounds.min.abs().max(bounds.max.abs()).max_element();
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.5, 0.5)] {
            let (distance, other) = (nearest.distance, patch.eval(u, v).distance(p));
            let is_nearest = distance <= other * (1.0 + 1e-15) + rounding;
            assert!(is_nearest, "{distance} > {other}: {patch:?} from {p}");
        }
    });
}

#[test]
fn of_rays() {
    // The nearest point to the origin takes three searches at most.
    let limit = RAY + 4 * (SEARCH + ONE_MORE);
    never_takes_more(limit, |random, patch| {
        let (origin, direction) = any_ray(random, patch);
        let hits = match patch.intersect_ray(origin, direction) {
            Err(Error::TooMany { limit, .. }) if limit == RAY as u64 => return,
            hits => hits.unwrap(),
        };
        for hit in hits {
            assert!(hit.point.is_finite() && hit.distance >= 0.0);
            assert_eq!(hit.point, patch.eval(hit.u, hit.v));
        }
    });
}

#[test]
fn of_bounds() {
    never_takes_more(6 * (SEARCH + ONE_MORE), |random, patch| {
        let bounds = patch.bounds();
        let p = patch.eval(random.unit(), random.unit());
        // Along each axis: the search distinguishes values that differ by 64 units of rounding of half the control box,
        // and the evaluation of a point adds some rounding.
        let control = patch.control_bounds();
        let slack = 1e-14 * (control.max - control.min) + 1e-15 * p.abs();
        assert!(p.cmpge(bounds.min - slack).all() && p.cmple(bounds.max + slack).all());
    });
}

#[test]
fn of_areas() {
    never_takes_more(3 << 25, |_, patch| {
        let low = patch.degree_u().max(patch.degree_v()) <= 3;
        take_steps();
        let area = patch.area();
        assert!(area.is_finite() && area >= 0.0);
        assert!(!low || take_steps() <= SEARCH);
    });
}

#[test]
fn of_subdivision() {
    // 128 for each control point of the surface, and the control points of the piece that is one too many.
    never_takes_more((1 << 24) + 129 * 25 * 25, |random, patch| {
        let bounds = patch.control_bounds();
        let size = bounds.min.abs().max(bounds.max.abs()).max_element();
        let tolerance = size * 10_f64.powf(-1.0 - 2.0 * random.unit());
        match as_surface(patch).subdivide(tolerance) {
            Ok(pieces) => assert!(!pieces.is_empty()),
            Err(Error::TooMany { limit, needed, .. }) => {
                // One piece more than allowed, or the control points of the piece that was examined last.
                assert!((limit + 1..=limit + 25 * 25).contains(&needed));
            }
            // The patch is a point at the origin, so the tolerance is 0.
            Err(error) => assert!(size == 0.0, "{error}"),
        }
    });
}

/// Points of nets whose axes have very different sizes: squares of such distances are rounding noise.
#[test]
fn of_points_of_needles() {
    for asked in worst::points_of_needles() {
        take_steps();
        let distance = asked.patch.nearest(asked.point).unwrap().distance;
        let (steps, name) = (take_steps(), asked.name);
        assert!(steps < 2 * (SEARCH + ONE_MORE), "{name}: {steps}");
        let size = asked.point.abs().max_element();
        assert!(distance <= 1e-14 * size, "{name}: {distance}");
    }
}

/// The distance of a patch from one of its own points is at most the documented one, however different the sizes of its
/// coordinates are.
///
/// Where the search by distances reaches its limit, the error is that of the search by squared distances, 2⁻²⁰ of the
/// size; where both reach their limits, the documentation allows any local minimum.
#[test]
fn of_points_of_patches() {
    never_takes_more(0, |random, patch| {
        let (distance, steps) = distance_of_own_point(random, patch);
        assert!(steps <= 2 * (SEARCH + ONE_MORE), "{steps} steps");
        let allowed = match steps / SEARCH {
            0 => 4e-7,
            1 => 1.0 / f64::from(1 << 20),
            _ => f64::INFINITY,
        };
        assert!(distance <= allowed, "{distance} after {steps} steps");
    });
}

/// The distance of a patch from one of its own points, as a fraction of the size, and the steps of the query.
fn distance_of_own_point(random: &mut Rng, patch: &Patch) -> (f64, usize) {
    let p = patch.eval(random.unit(), random.unit());
    let nearest = patch.nearest(p).unwrap();
    let size = patch.control_points().iter().map(|q| q.abs().max_element());
    let size = size.fold(f64::MIN_POSITIVE, f64::max);
    (nearest.distance / size, take_steps())
}

/// The height of this graph over its plane is 1e13: squares of distances of about 0.1 are rounding noise.
#[test]
fn of_a_ray_from_a_steep_graph() {
    let net = points(
        "0 0 29461627192156.53  1 0 6.315880150695684e-10  0 1 -9.849630705258912e-7
         1 1 5.489802292970428e-9  0 2 -30370.53591563606  1 2 -161363518866805.9",
    );
    let patch = patch(&net, 1, 2);
    let origin = patch.eval(0.5, 0.5);
    let along = DVec3::new(1.0, 0.0, -26995146238120.406);
    let hits = patch.intersect_ray(origin, along).unwrap();
    let near = |hit: &PatchPoint| hit.point.distance(origin) <= 1e-14 * 1.6e14;
    assert!(hits.iter().any(near), "{hits:?}");
}

/// Areas of folded nets of different scales, compared with those of their quarters.
#[test]
fn of_areas_of_folded_nets() {
    for patch in worst::folded() {
        let quarters: f64 = patch.split(0.5, 0.5).iter().map(Patch::area).sum();
        let area = patch.area();
        near(area / quarters, 1.0, 1e-5);
    }
}

/// Nets that are a line or a plane: the plane through the nearest point, perpendicular to the line from the query
/// point, ends the search at once.
#[test]
fn of_a_line_and_of_a_plane_there_is_next_to_none() {
    for worst::Asked { name, patch, point } in worst::nearest_along_curves() {
        take_steps();
        let distance = patch.nearest(point).unwrap().distance;
        let steps = take_steps();
        assert!(steps < 100_000, "{name}: {steps}");
        let rounding = 1e-15 * patch.control_bounds().max.abs().max_element();
        for (u, v) in samples(100) {
            let other = patch.eval(u, v).distance(point);
            let is_nearest = distance <= other + 4.0 * rounding;
            assert!(is_nearest, "{name}: {distance} > {other}");
        }
    }
}

/// Closed forms at the same points: distances from a line and from a plane that the patch covers.
#[test]
fn of_elevated_flat_nets() {
    let mut line = patch(&points("-1 0 0  0 0 0  1 0 0  2 0 0"), 1, 1);
    let mut square = graph(1, 1, &[]);
    for _ in 1..24 {
        (line, square) = (line.elevate().unwrap(), square.elevate().unwrap());
        let distance = |patch: &Patch, p: [f64; 3]| patch.nearest(p.into()).unwrap().distance;
        take_steps();
        near(distance(&line, [0.25, 3.0, 4.0]), 5.0, 1e-14);
        near(distance(&square, [0.3, 0.6, 2.0]), 2.0, 1e-14);
        near(distance(&line, [0.25, 0.0, 0.0]), 0.0, 1e-14);
        let steps = take_steps();
        assert!(steps < 1 << 22, "degree {}: {steps}", line.degree_u());
    }
}

/// A mesh just above the limit is rejected by an estimate, and one below it is accepted.
#[test]
fn of_meshes_that_are_too_large() {
    for degree in [2, 3, 24] {
        let patch = Rng(5).patch(degree, degree);
        let size = patch.control_bounds().max.abs().max_element();
        let unit = DAffine3::from_scale(DVec3::splat(1.0 / size));
        let patch = patch.transform(&unit).unwrap();
        let of = |tolerance| {
            let options = TessellationOptions::tolerance(tolerance);
            patch.tessellate_f64(&options.weld(Weld::None))
        };
        assert!(of(1e-2).unwrap().triangle_count() > 10);
        let Err(Error::TooMany { limit, needed, .. }) = of(1e-9) else {
            panic!("a mesh of degree {degree}");
        };
        assert!(needed > limit);
    }
    let grid = TessellationOptions::segments(Grid::from(2)).weld(Weld::None);
    assert!(Rng(5).patch(24, 24).tessellate(&grid).is_ok());
}
