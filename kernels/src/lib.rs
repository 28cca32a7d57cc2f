//! The innermost loops of the crate `casteljau`: numbers in, numbers out.
//!
//! They live apart so that a build for small size can compile them for speed. They check nothing but lengths.

mod angle;
mod bend;
mod bernstein;
mod bicubic;
mod curve;
mod gauss;
mod lattice;
mod layout;
mod length;
mod meet;
mod nearest;
mod normals;
mod parallel;
mod positions;
mod sample;
mod speed;
mod weights;
mod work;

pub use angle::cos_sin;
pub use bend::{BEND_SLACK, Bends, Sizes};
pub use bernstein::halve_coefficients;
pub use bicubic::BicubicGrid;
pub use curve::sample_plane_cubic;
pub use gauss::{GAUSS_8, GAUSS_16, GAUSS_32, Rule};
pub use lattice::{Cell, Lattice, first, pair, place, second, sort_distinct};
pub use layout::{
    Repeats, fill_indices_u16, fill_indices_u32, fill_patch_ids, fill_uvs, gather, whole_numbers,
};
pub use length::plane_cubic_length;
pub use meet::{Contact, Meeting, Piece, Row, meet_cubics};
pub use nearest::{nearest_in_plane, nearest_in_space};
pub use parallel::{Parallel, Plane, Source, arc_pieces};
pub use sample::{Sampler, Vector};
pub use speed::speed_integral;
pub use weights::{binomial, weights};
pub use work::WorkLimit;
#[cfg(feature = "count-work")]
pub use work::take_steps;
