//! The inner loops of the crate, in a package of their own for the wasm build.
//!
//! The files belong to their subjects and are compiled as a part of the crate everywhere else. With the feature `wasm`
//! the crate imports them from here instead, because this package is compiled for speed and the rest for size.

#[path = "../../bernstein"]
pub mod bernstein {
    pub mod de_casteljau;
    pub mod weights;
}

#[path = "../../numeric"]
pub mod numeric {
    pub mod gauss;
    pub mod order;
    pub mod trigonometry;
    pub mod work_limit;
    pub mod zero;
}

#[path = "../../curve"]
pub mod curve {
    pub mod sample_plane_cubic;

    pub mod arc_length {
        pub mod plane_cubic;
        pub mod speed;
    }

    pub mod intersect {
        pub mod clipping;
    }

    pub mod nearest {
        pub mod search;
    }
}

#[path = "../../spline"]
pub mod spline {
    pub mod offset {
        pub mod offset_curve;
    }
}

#[path = "../../mesh"]
pub mod mesh {
    pub mod bicubic;
    pub mod cell_triangulator;
    pub mod layout;
    pub mod row_sampler;
    pub mod second_differences;
}
