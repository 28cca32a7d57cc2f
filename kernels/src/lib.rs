//! Inner loops of the crate `casteljau`; arguments and results are numbers.
//!
//! They form a separate crate so that a build optimized for size can compile them for speed. They check only lengths.

mod angle;
mod bernstein;
mod bicubic;
mod bicubic_fill;
mod cell_triangulator;
mod clipping;
mod curve;
mod gauss;
mod lanes;
mod layout;
mod length;
mod nearest;
mod normals;
mod offset;
mod positions;
mod sample;
mod second_differences;
mod speed;
mod weights;
mod work;

pub use angle::cos_sin;
pub use bernstein::halve_coefficients;
pub use bicubic::BicubicGrid;
pub use cell_triangulator::{Cell, CellTriangulator, first, index_of, pair, second, sort_distinct};
pub use clipping::{ClippingSolver, Contact, Piece, Row, intersect_cubics};
pub use curve::sample_plane_cubic;
pub use gauss::{GAUSS_8, GAUSS_16, GAUSS_32, Rule};
pub use layout::{
    Repeats, collect_points, fill_indices_u16, fill_indices_u32, fill_patch_ids, fill_uvs,
    whole_numbers,
};
pub use length::plane_cubic_length;
pub use nearest::{nearest_in_plane, nearest_in_space};
pub use offset::{OffsetCurve, Source, Vec2, arc_pieces};
pub use sample::{Sampler, Vector};
pub use second_differences::{BEND_SLACK, SecondDifferences, Sizes};
pub use speed::speed_integral;
pub use weights::{binomial, weights};
pub use work::WorkLimit;
#[cfg(feature = "count-work")]
pub use work::take_steps;
