//! The largest number of steps that one call of a function may take, as `casteljau_kernels::take_steps` counts them.

/// For functions that have no documented limit of their own.
const DEFAULT: usize = 1_000_000;

/// The documented limits.
const LIMITS: &[(&str, usize)] = &[];

/// The limit of a function.
pub(crate) fn of(function: &str) -> usize {
    let found = LIMITS.iter().find(|(name, _)| *name == function);
    found.map_or(DEFAULT, |&(_, limit)| limit)
}
