//! Generated calls of every public function: no panic, no NaN, the invariants of each result, the limits of work.
//!
//! `CASTELJAU_CASES=N` sets the number of calls per function, `CASTELJAU_SEED=S` selects other calls.
//! `CASTELJAU_ONLY=Curve::offset` restricts the test to one function, `CASTELJAU_ONLY=Curve::offset:123` to one call.
#![cfg(not(target_family = "wasm"))]

mod arguments;
mod chains;
mod check;
mod coverage;
mod curve_drawing;
mod curve_edit;
mod curve_locations;
mod curve_measure;
mod curve_query;
mod curve_shape;
mod export;
mod limits;
mod mesh;
mod numbers;
mod parsers;
mod patch;
mod patch_query;
mod path;
mod path_query;
mod path_regions;
mod path_strokes;
mod percentiles;
mod runner;
mod spline_edit;
mod spline_forms;
mod spline_local;
mod spline_measure;
mod spline_query;
mod surface;
mod surface_query;

use runner::Row;

/// The functions in groups; each group is a test, so that the groups run in parallel.
const GROUPS: [(&str, &[&[Row]]); 11] = [
    ("curves: evaluation", &[curve_shape::ROWS]),
    ("curves: editing", &[curve_edit::ROWS, curve_drawing::ROWS]),
    ("curves: measures", &[curve_measure::ROWS]),
    (
        "curves: queries",
        &[curve_query::ROWS, curve_locations::ROWS],
    ),
    (
        "splines",
        &[
            spline_edit::ROWS,
            spline_forms::ROWS,
            spline_local::ROWS,
            spline_measure::ROWS,
            spline_query::ROWS,
        ],
    ),
    (
        "paths",
        &[
            path::ROWS,
            path_query::ROWS,
            path_regions::ROWS,
            path_strokes::ROWS,
        ],
    ),
    ("patches", &[patch::ROWS, patch_query::ROWS]),
    ("surfaces: meshes", &[surface::ROWS, export::ROWS]),
    ("surfaces: queries", &[surface_query::ROWS]),
    ("parsers", &[parsers::ROWS]),
    ("chains", &[chains::ROWS]),
];

macro_rules! groups {
    ($($name:ident: $index:literal,)*) => {$(
        #[test]
        fn $name() {
            runner::run(GROUPS[$index].1);
        }
    )*};
}

groups! {
    curves_evaluation: 0,
    curves_editing: 1,
    curves_measures: 2,
    curves_queries: 3,
    splines: 4,
    paths: 5,
    patches: 6,
    surfaces_meshes: 7,
    surfaces_queries: 8,
    parsers_read_what_they_wrote: 9,
    chains_of_operations: 10,
}
