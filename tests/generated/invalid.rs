//! Constructors, queries and changes with a coordinate that is not finite or beyond the limit refuse it; with other numbers of
//! any size constructors refuse or give coordinates. Nothing panics.

use crate::check::{Outcome, outcome_of};
use casteljau::MAX_COORDINATE;
use casteljau_generator::{Rng, Value, case};

const SEED: u64 = 12;
const CASES: u64 = 60;

/// What takes points or vertices.
const FUNCTIONS: &[&str] = &[
    "Curve::new",
    "Curve::from_basis",
    "Curve::interpolate",
    "Curve::nearest",
    "Curve::tangents_from",
    "RationalCurve::new",
    "RationalCurve::nearest",
    "NurbsCurve::interpolate",
    "NurbsCurve::nearest",
    "Spline::new",
    "Spline::from_bspline",
    "Spline::interpolate",
    "Spline::fit",
    "Spline::nearest",
    "Spline::append",
    "Spline::move_point",
    "Patch::new",
    "Patch::from_basis",
    "Patch::nearest",
    "Patch::move_point",
    "Patch::intersect_ray",
    "Surface::new",
    "Surface::move_point",
    "Surface::intersect_ray",
    "RationalSurface::nearest",
    "RationalSurface::move_point",
    "RationalSurface::intersect_ray",
];

/// Those with numbers that are no coordinates, of which the curve or the patch consists.
const CONSTRUCTORS: &[&str] = &[
    "Curve::from_basis",
    "Curve::interpolate",
    "Spline::from_bspline",
    "Spline::interpolate",
    "Spline::fit",
    "Patch::from_basis",
];

const NO_COORDINATES: [f64; 5] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    -1.001 * MAX_COORDINATE,
];

const NUMBERS: [f64; 9] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    -1e308,
    f64::MIN_POSITIVE,
    5e-324,
    0.0,
    -0.0,
];

/// Calls `check` with a random place for each number in each argument of each case.
fn each(
    functions: &[&str],
    numbers: &[f64],
    is_wanted: fn(&str, &str, &Value) -> bool,
    is_valid: fn(&Outcome) -> bool,
) {
    let mut rng = Rng::for_case(SEED, "invalid", 0);
    let mut calls = 0;
    for name in functions {
        let (_, check) = crate::rows()
            .find(|(known, _)| known == name)
            .expect("a row");
        for case in (0..CASES).map(|number| case(SEED, name, number)) {
            for (k, (argument, value)) in case.arguments.iter().enumerate() {
                let x = rng.pick(numbers);
                let changed = case.with_number(k, rng.below(1 << 16), x);
                let Some(changed) = changed.filter(|_| is_wanted(name, argument, value)) else {
                    continue;
                };
                let (outcome, _) = outcome_of(check, &changed);
                let valid = outcome.as_ref().is_some_and(is_valid);
                assert!(
                    valid,
                    "{name}:{}, {x:e} in {argument}: {outcome:?}",
                    case.number
                );
                calls += 1;
            }
        }
    }
    assert!(calls > CASES, "{calls}");
}

#[test]
fn wrong_coordinates_are_refused() {
    let is_wanted = |name: &str, argument: &str, value: &Value| match value {
        Value::Point(..) => argument != "direction", // which may have any length
        Value::Points(..) => true,
        Value::Patch(_) | Value::Surface(_) => name.ends_with("::new"),
        _ => false,
    };
    each(FUNCTIONS, &NO_COORDINATES, is_wanted, Option::is_none);
}

#[test]
fn other_numbers_are_refused_or_give_coordinates() {
    let is_wanted =
        |_: &str, _: &str, value: &Value| matches!(value, Value::Number(_) | Value::Numbers(_));
    each(CONSTRUCTORS, &NUMBERS, is_wanted, |outcome| {
        let mut coordinates = outcome.iter().flatten();
        coordinates.all(|x| x.abs() <= MAX_COORDINATE * (1.0 + 1e-9))
    });
}
