//! The largest number of steps that one call of a function may take, as `casteljau_kernels::take_steps` counts them.

/// For functions that have no documented limit of their own.
const DEFAULT: usize = 1_000_000;

/// The documented limit of one search in a patch, and by how much its last step may pass it.
const SEARCH: usize = (1 << 23) + (1 << 22);

/// That of rays, with three searches for the origin.
const RAY: usize = (1 << 27) + 4 * SEARCH;

/// The most patches of a generated surface.
const PATCHES: usize = 4;

/// The documented limits.
const LIMITS: &[(&str, usize)] = &[
    ("Patch::nearest", 2 * SEARCH),
    ("Patch::intersect_ray", RAY),
    ("Patch::bounds", 6 * SEARCH),
    ("Patch::area", 1 << 22),
    ("Surface::nearest", PATCHES * 2 * SEARCH),
    ("Surface::intersect_ray", PATCHES * RAY),
    ("Surface::bounds", PATCHES * 6 * SEARCH),
    ("Surface::area", PATCHES << 22),
    ("Surface::subdivide", (1 << 24) + (1 << 12)),
];

/// The limit of a function.
pub(crate) fn of(function: &str) -> usize {
    let found = LIMITS.iter().find(|(name, _)| *name == function);
    found.map_or(DEFAULT, |&(_, limit)| limit)
}
