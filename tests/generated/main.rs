//! Generated calls of every public function: no panic, no NaN, the invariants of each answer, the limits of work.
//!
//! `CASTELJAU_CASES=N` asks for N calls per function, `CASTELJAU_SEED=S` for other ones, and
//! `CASTELJAU_ONLY=Curve::offset` or `CASTELJAU_ONLY=Curve::offset:123` for those of one function, or for one call.
#![cfg(not(target_family = "wasm"))]

mod arguments;
mod check;
mod coverage;
mod curve_edit;
mod curve_measure;
mod curve_query;
mod curve_shape;
mod limits;
mod mesh;
mod numbers;
mod parsers;
mod patch;
mod path;
mod percentiles;
mod runner;
mod spline_edit;
mod spline_measure;
mod surface;

use runner::Row;

/// The functions in groups; each group is a test, so that they run side by side.
const GROUPS: [(&str, &[&[Row]]); 8] = [
    (
        "curves: evaluation and editing",
        &[curve_shape::ROWS, curve_edit::ROWS],
    ),
    ("curves: measures", &[curve_measure::ROWS]),
    ("curves: queries", &[curve_query::ROWS]),
    ("splines", &[spline_edit::ROWS, spline_measure::ROWS]),
    ("paths", &[path::ROWS]),
    ("patches", &[patch::ROWS]),
    ("surfaces", &[surface::ROWS, mesh::ROWS]),
    ("parsers", &[parsers::ROWS]),
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
    curves_evaluation_and_editing: 0,
    curves_measures: 1,
    curves_queries: 2,
    splines: 3,
    paths: 4,
    patches: 5,
    surfaces: 6,
    parsers_read_what_they_wrote: 7,
}
