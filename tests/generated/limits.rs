//! The maximum number of steps of one call of a function, as counted by `casteljau::take_steps`.

use casteljau_generator::{Case, Value};

/// For functions without a documented limit of their own.
const DEFAULT: usize = 1_000_000;

/// The documented limit of one search in a patch, plus the amount by which its last step may exceed it.
const SEARCH: usize = (1 << 23) + (1 << 22);

/// A few searches for each of six faces.
const RATIONAL_BOUNDS: usize = 6 * 4 * SEARCH;

/// The documented limit of an area or a volume.
const INTEGRAL: usize = 1 << 25;

/// The limit of a ray, including three searches for the nearest point to the origin.
const RAY: usize = (1 << 27) + 4 * SEARCH;

/// The documented limit of vertices, and the forecast and the cubics of every segment of a generated spline or path.
const FLATTEN: usize = (1 << 24) + DEFAULT;

/// Boolean operations take at most 2³⁰ steps, and more for each segment and contact; a chain may make a path of many dashes.
const CHAIN: usize = 1 << 31;

/// The documented limits.
const LIMITS: &[(&str, usize)] = &[
    ("Curve::flatten", FLATTEN),
    ("Curve::flatten_with", FLATTEN),
    ("Spline::flatten", FLATTEN),
    ("Path::flatten", FLATTEN),
    ("RationalCurve::flatten", FLATTEN),
    ("NurbsCurve::flatten", FLATTEN),
    ("RationalPatch::bounds", RATIONAL_BOUNDS),
    ("RationalPatch::control_bounds", RATIONAL_BOUNDS),
    ("NurbsSurface::bounds", RATIONAL_BOUNDS),
    ("NurbsSurface::control_bounds", RATIONAL_BOUNDS),
    ("Patch::nearest", 2 * SEARCH),
    ("Patch::intersect_ray", RAY),
    ("Patch::bounds", 6 * SEARCH),
    ("Patch::area", 1 << 22),
    ("Surface::nearest", 2 * SEARCH),
    ("Surface::intersect_ray", RAY),
    ("Surface::bounds", 6 * SEARCH),
    ("Surface::area", 1 << 22),
    ("RationalSurface::bounds", RATIONAL_BOUNDS),
    ("RationalSurface::nearest", 2 * SEARCH),
    ("RationalSurface::intersect_ray", RAY),
    ("RationalSurface::area", INTEGRAL),
    ("RationalSurface::volume", INTEGRAL),
    // The volume says which way the normals point: four patches for each span of a generated profile, and the caps.
    ("RationalSurface::solid_of_revolution", 64 * INTEGRAL),
    ("RationalSurface::chain", RAY),
    ("InkStroke::outline", REGION),
    // All parts that are swept backwards are in the union: of 2,000 calls one takes 340 million steps.
    ("Path::stroke_sides", DOCUMENTED_REGION),
    ("Curve::chain", FLATTEN),
    ("Spline::chain", FLATTEN),
    ("Path::chain", CHAIN),
    ("Patch::chain", 2 * RAY),
    ("Surface::chain", 2 * RAY),
    ("Surface::subdivide", (1 << 24) + (1 << 18)),
];

/// The functions of regions, and the search for contacts of a few thousand segments.
const REGIONS: &str = "union intersect subtract exclude combine remove_overlaps faces divide clip \
    filled_area filled_moments stroke offset";
const REGION: usize = 1 << 27;
/// The documented limit of Boolean operations, up to 2¹³ for each segment and contact. Of 10,000 calls of `Path::offset` one
/// takes more than [`REGION`].
const DOCUMENTED_REGION: usize = 1 << 30;

/// The limit of the function of a case. Those of surfaces are limits of one patch.
pub(crate) fn of(case: &Case) -> usize {
    let is_region = |name: &str| REGIONS.split(' ').any(|known| known == name);
    if case.function.strip_prefix("Path::").is_some_and(is_region) {
        let deep = std::env::var_os("CASTELJAU_DEEP").is_some();
        return if deep { DOCUMENTED_REGION } else { REGION };
    }
    let found = LIMITS.iter().find(|(name, _)| *name == case.function);
    let limit = found.map_or(DEFAULT, |&(_, limit)| limit);
    match case.arguments.first() {
        Some((_, Value::Surface(surface) | Value::RationalSurface(surface))) => {
            limit * surface.degrees.len().max(1)
        }
        Some((_, Value::NurbsSurface(surface))) => {
            let spans = |k: usize| surface.knots[k].len() - 2 * surface.degrees[k] - 1;
            limit * spans(0) * spans(1)
        }
        _ => limit,
    }
}
