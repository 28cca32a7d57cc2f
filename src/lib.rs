//! Bézier curves and surfaces: exact evaluation, splitting, flattening and tessellation.
//!
//! # The idea
//!
//! A Bézier curve is drawn by a few **control points** P₀ … Pₙ. Its point at the parameter t, between 0 and 1, is their
//! weighted mean B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ, with the **Bernstein polynomials** as weights; n is the **degree**.
//! **De Casteljau's algorithm** finds the same point by dividing lines, and divides the curve as it goes. Several
//! curves end to end make a **spline**, whose **joints** are more or less smooth; a curve whose control points run along
//! curves makes a **patch**, and patches that share control points make a surface.
//!
//! # Conventions
//!
//! - t, u, v ∈ \[0, 1\]; values outside extrapolate. Degree, never "order". End points come back exactly.
//! - The net of a patch has the index iv·(degree_u + 1) + iu: u runs along the fast index. A grid's vertex index is
//!   iv·(segments_u + 1) + iu. Triangles run counter-clockwise as seen from the side that ∂u × ∂v points to.
//! - Formulas assume x right and y up: curvature is positive when turning counter-clockwise, the normal is the tangent
//!   turned by +90°. On a canvas, where y runs down, all signs flip. Angles are in radians.
//! - Basis matrices act as \[t³ t² t 1\]·M·P, row-major.
//! - A tolerance is the greatest distance, in the input's own unit, and it is kept.
//! - Degenerate geometry is no error and gives a defined result. An [`Error`] means that the caller erred: a wrong count,
//!   a NaN, 0 segments, a tolerance that the coordinates cannot resolve.
//!
//! # An example
//!
//! ```
//! use casteljau::{Curve, glam::DVec2};
//!
//! let points = [(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from);
//! let arch = Curve::new(&points)?;
//! assert_eq!(arch.eval(0.5), DVec2::new(1.0, 1.5));
//!
//! let (left, right) = arch.split(0.5);
//! assert_eq!(left.end(), right.start());
//!
//! let line = arch.flatten(0.01)?;
//! assert_eq!(line.ts.first(), Some(&0.0));
//! # Ok::<(), casteljau::Error>(())
//! ```
#![deny(clippy::disallowed_methods)]

mod bernstein;
pub mod curve;
mod easing;
mod geometry;
mod io;
pub mod mesh;
pub mod models;
mod numeric;
pub mod patch;
pub mod path;
pub mod spline;
pub mod surface;

#[cfg(feature = "kurbo")]
mod kurbo;
#[cfg(feature = "serde")]
mod serde;
#[cfg(feature = "wasm")]
mod wasm;

pub use curve::Curve;
pub use easing::Easing;
pub use geometry::error::{Error, MAX_DEGREE};
pub use geometry::point::{CrossProduct, Point};
pub use glam;
pub use mesh::{Grid, GridMethod, Indices, Mesh};
pub use models::TeapotOptions;
pub use patch::Patch;
pub use path::Path;
pub use spline::Spline;
pub use surface::Surface;

/// The examples of the README, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
