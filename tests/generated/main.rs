//! Generated calls of every public function: no panic, no NaN, the invariants of each result, the limits of work.
//!
//! `CASTELJAU_CASES=N` sets the number of calls per function, `CASTELJAU_SEED=S` selects other calls.
//! `CASTELJAU_ONLY=Curve::offset` restricts the test to one function, `CASTELJAU_ONLY=Curve::offset:123` to one call.
#![cfg(not(target_family = "wasm"))]

mod arguments;
mod chains;
mod check;
mod coverage;
mod curves;
mod drawing;
mod geometry;
mod ink;
mod invalid;
mod limits;
mod lines;
mod meshes;
mod numbers;
mod nurbs;
mod nurbs_surfaces;
mod parsers;
mod patches;
mod paths;
mod rational;
mod rational_surfaces;
mod recorded;
mod recorder;
mod runner;
mod shared;
mod splines;
mod surfaces;

use arguments::run;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Patch, Path, Spline, Surface};
use runner::Row;

/// A row for one function and a check `(module name)`; without a name, the check is named as the function.
///
/// `one` is a check of no parameter. `of` takes the type itself; `each` takes the type in the plane and in space, by the
/// dimension of the case; `plane` and `space` take one of them. `points` takes the type of points instead.
macro_rules! row {
    ($type:ident $kind:ident ($module:ident) $name:ident) => {
        row!($type $kind ($module $name) $name)
    };
    ($type:ident $kind:ident ($module:ident $check:ident) $name:ident) => {
        (
            concat!(stringify!($type), "::", stringify!($name)),
            |case| row!(@ $kind $type case $module $check),
        )
    };
    (@ one $type:ident $case:ident $module:ident $check:ident) => {
        run(&$module::$check, $case)
    };
    (@ of $type:ident $case:ident $module:ident $check:ident) => {
        run(&$module::$check::<$type>, $case)
    };
    (@ plane $type:ident $case:ident $module:ident $check:ident) => {
        run(&$module::$check::<$type<DVec2>>, $case)
    };
    (@ space $type:ident $case:ident $module:ident $check:ident) => {
        run(&$module::$check::<$type<DVec3>>, $case)
    };
    (@ each $type:ident $case:ident $module:ident $check:ident) => {
        match $case.dimension() {
            3 => run(&$module::$check::<$type<DVec3>>, $case),
            _ => run(&$module::$check::<$type<DVec2>>, $case),
        }
    };
    (@ points $type:ident $case:ident $module:ident $check:ident) => {
        match $case.dimension() {
            3 => run(&$module::$check::<DVec3>, $case),
            _ => run(&$module::$check::<DVec2>, $case),
        }
    };
}

/// The functions in groups; each group is a test, so that the groups run in parallel.
macro_rules! groups {
    ($($group:ident { $($type:ident $kind:ident $check:tt: $($name:ident)+;)* })*) => {
        mod rows {
            use super::*;
            $(#[allow(non_upper_case_globals, reason = "the name of a test")]
            pub(super) const $group: &[Row] = &[$($(row!($type $kind $check $name)),+),*];)*
        }

        /// The rows of all groups.
        pub(crate) fn rows() -> impl Iterator<Item = Row> {
            [$(rows::$group),*].into_iter().flatten().copied()
        }

        $(#[test]
        fn $group() {
            crate::runner::run(rows::$group);
        })*
    };
}

groups! {
    curves_evaluation {
        Curve points (curves): new from_basis to_basis approx_eq interpolate sample_into;
        Curve points (curves accessors): degree control_points start end;
        Curve points (curves low_degrees): line quad cubic;
        Curve points (curves): derivative derivative_at tangent normal curvature torsion;
        Curve one (curves): basis_matrix;
        Curve one (curves bernstein_weights): bernstein;
        Curve each (lines): eval eval_at sample;
    }
    curves_editing {
        Curve each (lines): split split_at subsegment reverse transform flatten;
        Curve points (curves): halve elevate reduce flatten_with subdivide;
        Curve points (curves every_level): de_casteljau;
        Curve plane (drawing): trace to_svg;
        Curve one (drawing curve_offset): offset;
    }
    curves_measures {
        Curve each (lines): length time_at_length equidistant_times bounds control_bounds;
        Curve plane (lines): area;
        Curve space (lines): frames frames_at;
        Curve one (curves): moments hull;
    }
    curves_queries {
        Curve plane (lines): intersections self_intersections;
        Curve one (lines with_spline): intersections_with_spline;
        Curve each (lines): nearest;
        Curve points (curves): distance_to hausdorff extrema times_at_coordinate cusps classify;
        Curve one (curves): inflections tangents_from;
    }
    splines {
        Spline points (splines): new segment from_curves approx_eq append insert remove move_point set_joint;
        Spline points (splines accessors): with_degrees control_points is_closed segment_count degrees segments;
        Spline points (splines): from_bspline to_bspline interpolate fit simplify cumulative_lengths continuity;
        Spline points (splines): derivative_at tangent normal curvature;
        Spline one (splines): torsion;
        Spline each (lines): eval eval_at sample split split_at subsegment reverse transform flatten nearest;
        Spline each (lines): length time_at_length equidistant_times bounds control_bounds;
        Spline plane (lines): area intersections self_intersections;
        Spline one (lines with_curve): intersections_with_curve;
        Spline space (lines): frames frames_at;
        Spline plane (drawing): trace to_svg;
        Spline one (drawing spline_offset): offset;
    }
    rational_curves {
        RationalCurve points (rational): new conic from eval eval_at sample derivative_at tangent normal curvature;
        RationalCurve points (rational accessors): degree control_points weights start end;
        RationalCurve points (rational): split halve subsegment reverse elevate reparametrize transform project;
        RationalCurve points (rational): bounds control_bounds extrema nearest length time_at_length flatten to_spline;
        RationalCurve points (rational): approx_eq;
        RationalCurve one (rational): intersections intersections_with_curve self_intersections area inflections to_elliptical_arc to_svg trace;
    }
    nurbs_curves {
        NurbsCurve points (nurbs accessors): degree control_points weights knots is_closed domain segments joints start end;
        NurbsCurve points (nurbs): new from interpolate greville reverse elevate insert_knot remove_knot refine split;
        NurbsCurve points (nurbs): subsegment transform project eval eval_at sample derivative_at tangent normal curvature;
        NurbsCurve points (nurbs): bounds control_bounds extrema nearest length time_at_length flatten to_spline approx_eq;
        NurbsCurve points (nurbs): arc;
        NurbsCurve one (nurbs): intersections self_intersections circle ellipse area to_svg trace;
    }
    paths_queries {
        Path one (paths accessors): new subpath_count segment_count is_empty subpaths segments;
        Path one (paths): subpath approx_eq bounds control_bounds length time_at_length equidistant_times;
        Path one (paths): area moments flatten simplify transform reverse nearest winding_number contains;
        Path one (paths): intersections self_intersections;
        Path one (drawing): elements;
        Path of (drawing): trace to_svg;
    }
    paths_regions {
        Path one (paths): union intersect subtract exclude combine remove_overlaps faces divide clip;
    }
    paths_strokes {
        Path one (paths): filled_area filled_moments stroke stroke_sides stroke_contains dash offset round_corners round_corners_by to_arcs;
    }
    ink_strokes {
        InkStroke one (ink): outline;
    }
    patches {
        Patch one (patches new): new degree_u degree_v control_points;
        Patch one (patches): from_basis approx_eq eval partials normal curvature isocurve_at_u isocurve_at_v;
        Patch one (patches every_level): de_casteljau;
        Patch one (patches): split_u split_v split elevate flatness area;
        Patch of (patches): control_bounds transform move_point bounds nearest intersect_ray;
        Patch of (meshes): grid grid_into grid_by;
        Patch of (meshes): tessellate tessellate_f64;
    }
    rational_patches {
        RationalPatch one (nurbs_surfaces patch_accessors): new degree_u degree_v control_points weights;
        RationalPatch one (nurbs_surfaces patch_from): from;
        RationalPatch one (nurbs_surfaces patch_eval): eval;
        RationalPatch one (nurbs_surfaces patch_partials): partials;
        RationalPatch one (nurbs_surfaces patch_normal): normal;
        RationalPatch one (nurbs_surfaces patch_curvature): curvature;
        RationalPatch one (nurbs_surfaces patch_isocurve_at_u): isocurve_at_u;
        RationalPatch one (nurbs_surfaces patch_isocurve_at_v): isocurve_at_v;
        RationalPatch one (nurbs_surfaces patch_split_u): split_u;
        RationalPatch one (nurbs_surfaces patch_split_v): split_v;
        RationalPatch one (nurbs_surfaces patch_elevate): elevate;
        RationalPatch one (nurbs_surfaces patch_transform): transform;
        RationalPatch one (nurbs_surfaces patch_project): project;
        RationalPatch one (nurbs_surfaces patch_bounds): bounds control_bounds;
        RationalPatch one (nurbs_surfaces patch_approx_eq): approx_eq;
    }
    nurbs_surfaces {
        NurbsSurface one (nurbs_surfaces accessors): new degree_u degree_v control_points weights knots_u knots_v domain_u domain_v joints_u joints_v patches;
        NurbsSurface one (nurbs_surfaces): plane sphere cylinder cone torus ruled extrude revolve loft;
        NurbsSurface one (nurbs_surfaces): eval partials normal curvature isocurve_at_u isocurve_at_v split_u split_v;
        NurbsSurface one (nurbs_surfaces): insert_knot_u insert_knot_v elevate_u elevate_v reverse transform project to_surface approx_eq;
        NurbsSurface one (nurbs_surfaces box_of_surface): bounds control_bounds;
    }
    surfaces_meshes {
        Surface one (surfaces): new teapot teacup teaspoon to_text;
        Surface one (surfaces accessors): with_degrees vertices indices patch_count patches;
        Surface one (surfaces one_patch): degrees patch_indices patch;
        Surface of (patches): control_bounds transform move_point;
        Surface of (meshes): grid grid_into grid_by;
        Surface of (meshes): tessellate tessellate_f64;
        Surface one (meshes): tessellate_view;
        Mesh one (meshes counts): vertex_count triangle_count;
        Mesh one (meshes): to_f32 to_obj to_stl to_glb;
        Grid one (meshes grid_check): check;
        Grid one (meshes grid_quads): quads;
    }
    surfaces_queries {
        Surface of (patches): bounds nearest intersect_ray;
        Surface one (surfaces): area volume topology isocurves trace_projected subdivide;
        Surface one (meshes): wireframe;
    }
    rational_surfaces_meshes {
        RationalSurface one (rational_surfaces): solid_of_revolution;
        RationalSurface one (rational_surfaces): new from from_patches eval transform move_point topology to_text;
        RationalSurface one (rational_surfaces accessors): with_degrees vertices indices weights patch_count patches;
        RationalSurface one (rational_surfaces one_patch): degrees patch_indices patch_weights patch;
        RationalSurface one (rational_surfaces mismatches): weight_mismatches;
        RationalSurface one (rational_surfaces): grid grid_into tessellate tessellate_f64 tessellate_view wireframe;
    }
    rational_surfaces_queries {
        RationalSurface one (rational_surfaces): bounds control_bounds nearest intersect_ray area volume isocurves trace_projected;
    }
    parsers_read_what_they_wrote {
        Path one (parsers): from_svg from_svg_with;
        Surface one (parsers): parse;
        RationalSurface one (parsers parse_rational): parse;
        Easing one (parsers easing_new): new;
        Easing one (parsers easing_eval): eval;
        Easing one (parsers easing_to_linear): to_linear;
        Easing one (parsers easing_text): text;
    }
    chains_of_curves {
        Curve points (chains curve): chain;
        Spline points (chains spline): chain;
    }
    chains_of_paths {
        Path one (chains path): chain;
    }
    chains_of_surfaces {
        Patch one (chains patch): chain;
        Surface one (chains surface): chain;
        RationalSurface one (chains rational_surface): chain;
    }
}
