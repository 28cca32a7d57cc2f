//! Seeded cases for the generated tests of casteljau: the same calls in Rust and in JavaScript.
//!
//! [`case`] makes the arguments of one call from a seed, the name of a function and a number. The Rust tests use this
//! crate as a library; its program prints the same cases as lines of JSON for the tests of the npm package.

pub mod adversarial;
mod arguments;
mod case;
mod functions;
mod geometry;
mod large;
mod lists;
mod mutations;
mod notation;
mod random;
mod texts;

pub use arguments::case;
pub use case::{Case, Mode, NurbsSurfaceData, RationalData, SplineData, SurfaceData, Value};
pub use functions::{FUNCTIONS, Signature, find};
pub use random::{Rng, real};

/// A copy of a value after a change in place, which may be refused.
pub fn changed<T: Clone, E>(
    value: &T,
    change: impl FnOnce(&mut T) -> Result<(), E>,
) -> Result<T, E> {
    let mut copy = value.clone();
    change(&mut copy).map(|()| copy)
}
