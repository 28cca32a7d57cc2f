//! Adversarial curves: coincident and collinear points, cusps, loops, points a few ulps apart, huge and tiny coordinates.

use crate::random::{Rng, real};
use glam::DVec3;

/// The largest coordinate that the library accepts: 2⁵⁰⁰.
pub const MAX_COORDINATE: f64 = 3.273_390_607_896_142e150;

/// Defines the kinds and the list of all of them.
macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident,)*) => {
        /// What makes a curve difficult.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Kind {
            $($(#[$doc])* $kind,)*
        }
        const KINDS: &[Kind] = &[$(Kind::$kind),*];
    };
}

kinds! {
    /// Random control points.
    Random,
    /// Small integer coordinates.
    Integers,
    /// The end point is the start point.
    Closed,
    /// All control points on one line.
    Collinear,
    /// Control points close to one line.
    NearlyCollinear,
    /// Several control points coincide with an end point.
    ZeroHandles,
    /// A cusp, or almost one.
    Cusp,
    /// A loop.
    Loop,
    /// A flat curve with alternating sides.
    FlatS,
    /// All control points within a few ulps.
    FewUlps,
    /// All control points but one coincide.
    OneAway,
    /// All control points coincide.
    Coincident,
    /// Control points of very different magnitudes.
    Mixed,
    /// Far from the origin.
    FarAway,
    /// A curve of lower degree, elevated.
    Elevated,
    /// One control point far from the others.
    LongHandle,
    /// The curve runs there and back on almost the same line.
    Spike,
    /// Coordinates near 1e148.
    Huge,
    /// Coordinates near 1e-300.
    Tiny,
    /// Coordinates up to the limit of the library, and equal to it.
    Largest,
}

const fn first<const N: usize>() -> [Kind; N] {
    let (mut kinds, mut i) = ([Kind::Random; N], 0);
    while i < N {
        kinds[i] = KINDS[i];
        i += 1;
    }
    kinds
}

/// The kinds with coordinates of ordinary size.
pub const ORDINARY: [Kind; 17] = first();

/// All kinds but [`Kind::Largest`], where results of operations exceed the limit of coordinates.
pub const ALL: [Kind; 19] = first();

/// Control points of a kind and a degree; z = 0 where `dimension` is 2.
pub fn points(rng: &mut Rng, kind: Kind, degree: usize, dimension: usize) -> Vec<DVec3> {
    let mut p: Vec<DVec3> = (0..=degree).map(|_| rng.point(dimension)).collect();
    let n = degree;
    match kind {
        Kind::Random => {}
        Kind::Integers => p.iter_mut().for_each(|p| *p = (*p * 2.5).round()),
        Kind::Closed => p[n] = p[0],
        Kind::Collinear => on_a_line(rng, &mut p, dimension),
        Kind::NearlyCollinear => {
            on_a_line(rng, &mut p, dimension);
            let off = rng.magnitude(-16.0, -1.0);
            p.iter_mut().for_each(|p| *p += rng.point(dimension) * off);
        }
        Kind::ZeroHandles => {
            let count = 1 + rng.below(n);
            let at = if rng.chance(0.5) { 0 } else { n + 1 - count };
            let same = p[if at == 0 { 0 } else { n }];
            p[at..at + count].fill(same);
        }
        Kind::Cusp | Kind::Loop => cross_handles(rng, &mut p, kind),
        Kind::FlatS => flat_s(rng, &mut p),
        Kind::FewUlps => {
            let centre = rng.point(dimension);
            p.iter_mut()
                .for_each(|p| *p = centre + (*p * 6.0).round() * f64::EPSILON);
        }
        Kind::OneAway => {
            let (centre, at, away) = (rng.point(dimension), rng.below(n + 1), p[0]);
            p.fill(centre);
            p[at] = away;
        }
        Kind::Coincident => p = vec![p[0]; n + 1],
        Kind::Mixed => p.iter_mut().for_each(|p| *p *= rng.magnitude(-12.0, 3.0)),
        Kind::FarAway => {
            let offset = rng.point(dimension) * rng.magnitude(1.0, 7.0);
            p.iter_mut().for_each(|p| *p += offset);
        }
        Kind::Elevated => {
            p.truncate(1 + n.div_ceil(2));
            p = elevated_to(p, n);
        }
        Kind::LongHandle => {
            let at = if rng.chance(0.5) { 1 } else { n - 1 };
            p[at.clamp(1, n)] *= rng.magnitude(0.0, 4.0);
        }
        Kind::Spike => {
            // There and back on almost the same line.
            let thin = rng.magnitude(-9.0, -2.0);
            p.iter_mut().for_each(|p| p.y *= thin);
            p[n] = p[0] + rng.point(dimension) * thin;
        }
        Kind::Huge => p.iter_mut().for_each(|p| *p *= 1e148),
        Kind::Tiny => p.iter_mut().for_each(|p| *p *= 1e-300),
        Kind::Largest => {
            for p in &mut p {
                if rng.chance(0.5) {
                    *p = p.signum() * p.abs().ceil();
                }
                *p *= MAX_COORDINATE;
            }
        }
    }
    p
}

fn flat_s(rng: &mut Rng, p: &mut [DVec3]) {
    let height = rng.magnitude(-7.0, -0.5);
    for (i, p) in p.iter_mut().enumerate() {
        let up = if i % 2 == 0 { height } else { -height };
        *p = DVec3::new(real(i) * (0.5 + rng.unit()), up * rng.unit(), p.z * height);
    }
}

fn on_a_line(rng: &mut Rng, p: &mut [DVec3], dimension: usize) {
    let mut direction = rng.point(dimension);
    if rng.chance(0.4) {
        direction = rng.pick(&[DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.0)]);
    }
    let is_central = rng.chance(0.5);
    let origin = if is_central {
        DVec3::ZERO
    } else {
        rng.point(dimension)
    };
    for p in p.iter_mut() {
        let is_rounded = rng.chance(0.3);
        let along = if is_rounded { (p.x * 3.0).round() } else { p.x };
        *p = origin + direction * along;
    }
    let n = p.len() - 1;
    if rng.chance(0.2) {
        p[n] = p[0];
    }
}

/// Handles that cross: a cusp in the middle, or past it a loop; somewhere in the plane.
fn cross_handles(rng: &mut Rng, p: &mut [DVec3], kind: Kind) {
    let (u, v) = (p[0], p[1]);
    let off = rng.pick(&[0.0, 1e-15, 1e-9, 1e-4]);
    let reach = match kind {
        Kind::Cusp => 1.0 + off,
        _ => 1.0 + rng.magnitude(-6.0, 0.5),
    };
    let (low, high) = (0.5 - 0.5 * reach, 0.5 + 0.5 * reach);
    let corners = [(0.0, 0.0), (high, 1.0), (low, 1.0), (1.0, 0.0)];
    let n = p.len() - 1;
    for (i, p) in p.iter_mut().enumerate().take(4.min(n + 1)) {
        let (a, b) = corners[if n < 3 { (i * 3) / n } else { i }];
        *p = u * a + v * b;
    }
    if n > 3 {
        // The same cubic, elevated to the degree.
        p.copy_from_slice(&elevated_to(p[..4].to_vec(), n));
    }
}

/// The nearest point whose coordinates are within the limit.
pub(crate) fn within_range(p: DVec3) -> DVec3 {
    let max = DVec3::splat(MAX_COORDINATE);
    p.clamp(-max, max)
}

/// A curve of at least a degree, by elevation.
pub(crate) fn elevated_to(mut p: Vec<DVec3>, degree: usize) -> Vec<DVec3> {
    while p.len() <= degree {
        p = elevated(&p);
    }
    p
}

/// Degree elevation by the textbook formula, independent of the library.
pub fn elevated(p: &[DVec3]) -> Vec<DVec3> {
    let n = real(p.len());
    let inner = (1..p.len()).map(|i| p[i - 1] * (real(i) / n) + p[i] * (1.0 - real(i) / n));
    let mut raised = vec![p[0]];
    // Rounding may exceed the limit.
    raised.extend(inner.map(within_range));
    raised.push(p[p.len() - 1]);
    raised
}
