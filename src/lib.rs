//! Bézier curves and surfaces: exact evaluation, splitting, flattening and tessellation.
//!
//! # Definitions
//!
//! A Bézier curve is defined by a few **control points** P₀ … Pₙ. Its point at the parameter t, between 0 and 1, is
//! their weighted mean B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ, with the **Bernstein polynomials** as weights; n is the
//! **degree**. **De Casteljau's algorithm** computes the same point by repeated linear interpolation, and splits the
//! curve at that point. Several curves joined end to end form a **spline**; its **joints** have different degrees of
//! continuity. A curve whose control points move along curves sweeps out a **patch** (a tensor-product surface), and
//! patches that share control points form a surface.
//!
//! # Conventions
//!
//! - t, u, v ∈ \[0, 1\]; values outside extrapolate. The documentation uses "degree", never "order". End points are
//!   exact.
//! - The net of a patch has the index iv·(degree_u + 1) + iu: u runs along the fast index. A grid's vertex index is
//!   iv·(segments_u + 1) + iu. Triangles are counter-clockwise as seen from the side that ∂u × ∂v points to.
//! - Formulas assume x right and y up: curvature is positive for a counter-clockwise turn, the normal is the tangent
//!   rotated by +90°. On a canvas, where y points down, all signs flip. Angles are in radians.
//! - Basis matrices act as \[t³ t² t 1\]·M·P, row-major.
//! - A tolerance is a maximum distance, in the unit of the input, and it is guaranteed.
//! - Degenerate geometry is not an error and gives a defined result. An [`Error`] means an invalid argument: a wrong
//!   count, a NaN, 0 segments, a tolerance that the coordinates cannot resolve.
//!
//! - Numbers that are NaN: functions that evaluate ([`Curve::eval`], [`Curve::time_at_length`]) return NaN, questions with
//!   yes or no ([`Path::contains`]) say no, and searches ([`Curve::nearest`]) return an error.
//! - `Result` stands where an argument can be refused, a position in a part that does not exist ([`Path::eval`],
//!   [`Surface::eval`]) among them; `Option` where there may be nothing to return: the [`bounds`](Path::bounds) of an empty path, the item at an
//!   index ([`Surface::patch`]). [`Path::nearest`] has both.
//!
//! # Coming from kurbo or lyon
//!
//! | kurbo, lyon | here |
//! |---|---|
//! | `Line`, `QuadBez`, `CubicBez`; `LineSegment`, `QuadraticBezierSegment`, `CubicBezierSegment` | [`curve::Line`], [`curve::Quad`], [`curve::Cubic`], which are `Copy`; [`Curve`] for any degree; kurbo's types convert with `From` and `TryFrom` (feature `kurbo`) |
//! | `BezPath`; `Path` | [`Path`], a list of [`Spline`]s; [`Path::builder`], [`Path::from_elements`], [`Path::elements`], [`Path::trace`] into a [`curve::PathSink`] |
//! | `Circle`, `Rect`, `RoundedRect`, `Arc`, `Ellipse` | [`Path::circle`], [`Path::rect`], [`Path::rounded_rect`], [`Path::arc`], [`Path::ellipse`] |
//! | `eval`, `subsegment(a..b)`, `subdivide`; `sample`, `split_range`, `split` | [`Curve::eval`], [`Curve::subsegment`], [`Curve::halve`], [`Curve::split`] |
//! | `arclen(accuracy)`, `inv_arclen`; `approximate_length` | [`Curve::length`] and [`Curve::length_within`], [`Curve::time_at_length`]; [`Path::lengths`] for many questions |
//! | `nearest(p, accuracy)` | [`Curve::nearest`], to rounding |
//! | `bounding_box`; `bounding_box`, `fast_bounding_box` | [`Curve::bounds`], [`Curve::control_bounds`] |
//! | `flatten`, `offset_cubic`, `stroke`; `for_each_flattened` | [`Curve::flatten`], [`Curve::offset`], [`Path::stroke`], [`Curve::flatten_with`] |
//! | `fit_to_bezpath`, `simplify_bezpath` | [`Spline::fit`], [`Spline::simplify`] |
//!
//! # Features
//!
//! Curves, splines and paths need no feature; with `default-features = false` glam is the only dependency. These features
//! are on by default:
//!
//! - `regions`: Boolean operations ([`Path::union`]), strokes ([`Path::stroke`]), dashes, offsets of regions, rounded
//!   corners and ink ([`path::InkStroke`]). It includes `fit`, because ink is fitted.
//! - `fit`: fitting points ([`Spline::fit`]) and simplification ([`Spline::simplify`]).
//! - `easing`: CSS timing functions ([`Easing`]).
//! - `io`: SVG path data ([`Path::from_svg`]); with `surfaces` also their text forms, and meshes as OBJ, STL and GLB.
//! - `nurbs`: curves with weights ([`RationalCurve`], [`NurbsCurve`]).
//! - `surfaces`: patches, surfaces, also with weights ([`RationalPatch`], [`NurbsSurface`], [`RationalSurface`]), meshes and
//!   the teapot. It includes `nurbs`.
//! - `fast`: control points are stored inline, and plane curves have code of their own: faster, and more code. The
//!   results are the same. The npm package does without it.
//!
//! These are off by default:
//!
//! - `serde`: serialization of curves, splines, paths, patches, surfaces, easings, options and results. What is read is
//!   checked as by the constructors; options that are left out have their defaults. JSON keeps every bit of a number only if
//!   the crate `serde_json` has its feature `float_roundtrip`.
//! - `kurbo`: conversions from and to the curves and paths of the crate kurbo.
//! - `rayon`: `grid`, `tessellate`, `area`, `volume` and `intersect_ray` of a surface use all cores, through the global
//!   thread pool of the crate rayon or the pool in which they are called. The results are the same bit for bit. It pays
//!   off for surfaces with many patches.
//! - `count-work`: adds up the steps of all calls on a thread (`take_steps`), and the segments that lines replace in
//!   Boolean operations (`path::take_replaced_segments`), for tests.
//!
//! # Example
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
#![cfg_attr(docsrs, feature(doc_cfg))] // docs.rs writes the feature that an item needs beside it
#![deny(clippy::disallowed_methods)]

mod bernstein;
pub mod curve;
#[cfg(feature = "easing")]
mod easing;
mod geometry;
#[cfg(feature = "io")]
mod io;
#[cfg(feature = "surfaces")]
pub mod mesh;
#[cfg(feature = "surfaces")]
pub mod models;
mod numeric;
#[cfg(feature = "surfaces")]
mod parallel;
#[cfg(feature = "surfaces")]
pub mod patch;
pub mod path;
#[cfg(feature = "nurbs")]
mod rational;
pub mod spline;
#[cfg(feature = "surfaces")]
pub mod surface;
#[cfg(any(feature = "easing", feature = "io"))]
mod text;

#[cfg(feature = "kurbo")]
mod kurbo;
#[cfg(feature = "serde")]
mod serde;
#[cfg(feature = "wasm")]
mod wasm;

#[cfg(feature = "count-work")]
pub use casteljau_kernels::numeric::work_limit::take_steps;
pub use curve::Curve;
#[cfg(feature = "easing")]
pub use easing::{Easing, EasingError};
pub use geometry::check::MAX_COORDINATE;
pub use geometry::error::{Error, MAX_DEGREE};
pub use geometry::point::{CrossProduct, Point};
pub use glam;
#[cfg(feature = "surfaces")]
pub use mesh::{Grid, GridMethod, Indices, Mesh, TessellationOptions};
#[cfg(feature = "surfaces")]
pub use models::TeapotOptions;
#[cfg(feature = "surfaces")]
pub use patch::Patch;
#[cfg(feature = "regions")]
pub use path::StrokeOptions;
pub use path::{FillRule, Path, PathBuilder, PathTime};
#[cfg(feature = "nurbs")]
pub use rational::{EllipticalArc, NurbsCurve, RationalCurve};
#[cfg(feature = "surfaces")]
pub use rational::{NurbsSurface, RationalPatch, RationalSurface};
pub use spline::Spline;
#[cfg(feature = "surfaces")]
pub use surface::Surface;

/// The examples of the README, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The value that a method returns has to be used, also behind `?`.
///
/// ```compile_fail
/// #![deny(unused_must_use)]
/// use casteljau::{Error, Spline, glam::DVec2};
///
/// fn longer(spline: Spline<DVec2>) -> Result<Spline<DVec2>, Error> {
///     spline.append(DVec2::ONE)?;
///     Ok(spline)
/// }
/// ```
#[cfg(doctest)]
struct Unused;
