//! The maximum number of steps of one call of a function, as counted by `casteljau::take_steps`.

/// For functions without a documented limit of their own.
const DEFAULT: usize = 1_000_000;

/// The documented limit of one search in a patch, plus the amount by which its last step may exceed it.
const SEARCH: usize = (1 << 23) + (1 << 22);

/// The limit of a ray, including three searches for the nearest point to the origin.
const RAY: usize = (1 << 27) + 4 * SEARCH;

/// The maximum number of patches of a generated surface.
const PATCHES: usize = 100;

/// The documented limit of vertices, and the forecast and the cubics of every segment of a generated spline or path.
const FLATTEN: usize = (1 << 24) + DEFAULT;

/// The documented limits.
const LIMITS: &[(&str, usize)] = &[
    ("Curve::flatten", FLATTEN),
    ("Curve::flatten_with", FLATTEN),
    ("Spline::flatten", FLATTEN),
    ("Path::flatten", FLATTEN),
    ("Patch::nearest", 2 * SEARCH),
    ("Patch::intersect_ray", RAY),
    ("Patch::bounds", 6 * SEARCH),
    ("Patch::area", 1 << 22),
    ("Surface::nearest", PATCHES * 2 * SEARCH),
    ("Surface::intersect_ray", PATCHES * RAY),
    ("Surface::bounds", PATCHES * 6 * SEARCH),
    ("Surface::area", PATCHES << 22),
    // The search for contacts of a few thousand segments.
    ("Path::union", 1 << 31),
    ("Path::intersect", 1 << 31),
    ("Path::subtract", 1 << 31),
    ("Path::exclude", 1 << 31),
    ("Path::combine", 1 << 31),
    ("Path::remove_overlaps", 1 << 31),
    ("Path::faces", 1 << 31),
    ("Path::divide", 1 << 31),
    ("Path::clip", 1 << 31),
    ("Path::filled_area", 1 << 31),
    ("Path::filled_moments", 1 << 31),
    ("Path::stroke", 1 << 31),
    ("Path::offset", 1 << 31),
    ("Curve::chain", FLATTEN),
    ("Spline::chain", FLATTEN),
    ("Path::chain", 1 << 29),
    ("Patch::chain", 2 * RAY),
    ("Surface::chain", 2 * PATCHES * RAY),
    ("Surface::subdivide", (1 << 24) + (1 << 18)),
];

/// The limit of a function.
pub(crate) fn of(function: &str) -> usize {
    let found = LIMITS.iter().find(|(name, _)| *name == function);
    found.map_or(DEFAULT, |&(_, limit)| limit)
}
