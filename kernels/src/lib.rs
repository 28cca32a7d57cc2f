//! The inner loops of the crate `casteljau`: numbers in, numbers out.
//!
//! Programs use `casteljau`; the interface of this package changes with it. It is a package of its own because Cargo
//! chooses the opt-level by package: the wasm build compiles it for speed and the rest for size. Generic functions take
//! the opt-level of the package that instantiates them, so what must be fast is concrete.

/// Polynomials in Bernstein form.
pub mod bernstein {
    pub mod de_casteljau;
    pub mod derivatives;
    pub mod vector_products;
    pub mod weights;
}

/// Quadrature, work limits, and what the standard library lacks in wasm.
pub mod numeric {
    pub mod gauss;
    pub mod lanes;
    pub mod order;
    pub mod trigonometry;
    pub mod vector;
    pub mod work_limit;
    pub mod zero;
}

/// One curve.
pub mod curve {
    pub mod chord_rates;
    pub mod curvature;
    pub mod rational_cubic;
    pub mod sample_plane_cubic;

    /// Arc length.
    pub mod arc_length {
        pub mod plane_cubic;
        pub mod rational_cubic;
        pub mod speed;
    }

    /// Intersections.
    pub mod intersect {
        pub mod clipping;
    }

    /// Nearest points.
    pub mod nearest {
        pub mod search;
    }
}

/// Splines.
pub mod spline {
    pub mod fit_run;
    pub mod handles;

    /// Offset curves.
    pub mod offset {
        pub mod offset_curve;
        pub mod side_bound;
    }
}

/// Grids of points of patches.
#[cfg(feature = "surfaces")]
pub mod mesh {
    pub mod bicubic;
    pub mod cell_triangulator;
    pub mod layout;
    pub mod row_sampler;
    pub mod second_differences;
}
