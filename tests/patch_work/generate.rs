//! Seeded generation of patches and of queries on them, including degenerate ones.

use crate::support::Rng;
use crate::support::nets::RandomNet;
use casteljau::Patch;
use casteljau::glam::DVec3;

/// The sizes of the coordinates of one net.
#[derive(Clone, Copy, PartialEq)]
enum Scale {
    /// −1 to 1, some of them rounded.
    Moderate,
    /// −1, 0 or 1.
    Coarse,
    /// 1e-12 to 1e15 with either sign, or 0.
    Mixed,
    /// One coordinate of each point is 1e6 plus a moderate number, the others are moderate.
    Far,
}

fn coordinate(random: &mut Rng, scale: Scale) -> f64 {
    match scale {
        Scale::Moderate | Scale::Far => random.coordinate(),
        Scale::Coarse => random.coordinate().round(),
        Scale::Mixed if random.below(8) == 0 => 0.0,
        Scale::Mixed => random.pick(&[-1.0, 1.0]) * random.magnitude(-12.0, 15.0),
    }
}

fn point(random: &mut Rng, scale: Scale) -> DVec3 {
    let [x, y, z] = [(); 3].map(|()| coordinate(random, scale));
    DVec3::new(x + if scale == Scale::Far { 1e6 } else { 0.0 }, y, z)
}

/// A patch of degrees 1 to `max_degree`.
pub(crate) fn any_patch(random: &mut Rng, max_degree: usize) -> Patch {
    let [m, n] = [(); 2].map(|()| 1 + random.below(max_degree));
    let scale = random.pick(&[Scale::Moderate, Scale::Coarse, Scale::Mixed, Scale::Far]);
    let count = (m + 1) * (n + 1);
    let mut net: Vec<DVec3> = (0..count).map(|_| point(random, scale)).collect();
    degrade(random, scale, &mut net, m + 1);
    Patch::new(&net, m, n).expect("finite points")
}

/// Makes a net degenerate in one of several ways, or leaves it unchanged.
fn degrade(random: &mut Rng, scale: Scale, net: &mut [DVec3], columns: usize) {
    let count = net.len();
    let (first, other) = (net[0], point(random, scale));
    match random.below(12) {
        // In a coordinate plane, and in another plane.
        0 => net.iter_mut().for_each(|p| p.z = first.z),
        1 => net.iter_mut().for_each(|p| p.z = 0.5 * p.x - 0.25 * p.y),
        // On a line, and in one point.
        2 => net.iter_mut().for_each(|p| *p = first + other * p.x),
        3 => net.fill(first),
        // One to four collapsed edges.
        4 => net[..columns].fill(first),
        5 => {
            for (k, p) in net.iter_mut().enumerate() {
                if k % columns == 0 || k >= count - columns {
                    *p = first;
                }
            }
        }
        // Coincident points.
        6 => {
            for k in 0..count {
                if random.below(2) == 0 {
                    net[k] = random.pick(net);
                }
            }
        }
        // Folded over: the rows run forth and back.
        7 => {
            for k in 0..count {
                let mirror = k / columns * columns + (columns - 1 - k % columns);
                net[k] = net[mirror];
            }
        }
        // A graph over a regular grid of parameters, and a translation surface.
        8 => {
            for (k, p) in net.iter_mut().enumerate() {
                (p.x, p.y) = ((k % columns) as f64, (k / columns) as f64);
            }
        }
        9 => {
            for k in columns..count {
                net[k] = net[k % columns] + (net[k / columns * columns] - first);
            }
        }
        _ => {}
    }
}

/// A query point: on the patch, in its bounding box, among its control points, or anywhere.
pub(crate) fn any_point(random: &mut Rng, patch: &Patch) -> DVec3 {
    let net = patch.control_points();
    match random.below(6) {
        0 => patch.eval(random.unit(), random.unit()),
        1 => random.pick(net),
        2 => net.iter().map(|&p| p / net.len() as f64).sum(),
        3 => patch.eval(random.unit(), random.unit()) + point(random, Scale::Mixed),
        4 => point(random, Scale::Mixed),
        _ => point(random, Scale::Moderate) * patch.control_bounds().max.abs().max_element(),
    }
}

/// A ray that intersects the patch, that runs within it, or that is arbitrary.
pub(crate) fn any_ray(random: &mut Rng, patch: &Patch) -> (DVec3, DVec3) {
    let origin = any_point(random, patch);
    let (u, v) = (random.unit(), random.unit());
    let direction = match random.below(6) {
        0 => patch.partials(u, v).u,
        1 => random.pick(&DVec3::AXES),
        2 => point(random, Scale::Coarse),
        _ => any_point(random, patch) - origin,
    };
    if direction.length() > 0.0 && direction.is_finite() {
        (origin, direction)
    } else {
        (origin, DVec3::new(1.0, 2.0, 3.0))
    }
}
