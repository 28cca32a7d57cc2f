//! The steps of `test-deep`, which would take too long in `test`.

use super::node;
use super::select::{self, Choice};
use super::step::{Context, Done, Lane, Step};
use crate::{build, shell, wasm_test};
use anyhow::Result;
use std::process::Command;

/// The environment variable that makes tests run many more cases.
const DEEP: &str = "CASTELJAU_DEEP";
/// The environment variable with the number of calls per function in the generated tests.
const CASES: &str = "CASTELJAU_CASES";
/// The part of a step: a name for the command line, and what it covers.
const fn part(name: &'static str, title: &'static str, act: fn(&Context) -> Result<Done>) -> Step {
    Step {
        name,
        title,
        needs: &[],
        selects: true,
        lane: Lane::Rust,
        act,
    }
}

/// Each part runs alone, so that a change runs only those that it can affect.
pub(crate) const STEPS: [Step; 11] = [
    part(
        "curves",
        "Many more curves: flattening, points, timing functions",
        |context| sweep(context, &["curve", "easing", "flatten", "points"]),
    ),
    part(
        "splines",
        "Many more splines: length, area, frames, joints, interpolation",
        |context| sweep(context, &["arc", "spline"]),
    ),
    part(
        "intersections",
        "Many more intersections and offset curves",
        |context| sweep(context, &["intersect", "offset"]),
    ),
    part(
        "paths",
        "Many more Boolean operations, strokes, large paths",
        |context| sweep(context, &["path", "path_boolean", "stroke"]),
    ),
    part(
        "surfaces",
        "Many more patches, meshes and queries of surfaces",
        |context| {
            sweep(
                context,
                &["patch_work", "queries", "surface", "watertight", "wires"],
            )
        },
    ),
    part(
        "generated-curves",
        "Generated calls of curves and splines, and of parsers",
        |context| {
            let groups = ["curves_", "splines", "parsers_", "chains_of_curves"];
            generated(context, &groups)
        },
    ),
    part("generated-paths", "Generated calls of paths", |context| {
        generated(context, &["paths_", "chains_of_paths"])
    }),
    part(
        "generated-surfaces",
        "Generated calls of patches, surfaces and meshes",
        |context| generated(context, &["patches", "surfaces_", "chains_of_surfaces"]),
    ),
    Step {
        selects: false,
        ..part(
            "npm-package",
            "The npm package: more generated calls, every icon of a set",
            npm_package,
        )
    },
    part(
        "wasm-chromium",
        "Rust tests as wasm, in Chromium",
        |context| wasm_test::in_chromium(context.filters),
    ),
    part(
        "page",
        "Page tests that take long, in Chromium",
        |context| node::page(context, &["--deep"]),
    ),
];

/// Runs modules of the test binaries, or the tests that the filters choose, with the numbers of cases of `CASTELJAU_DEEP`.
fn sweep(context: &Context, modules: &[&str]) -> Result<Done> {
    let modules: Vec<String> = modules.iter().map(|&name| name.to_owned()).collect();
    rust_tests(context, &select::tests(&modules, &select::test_binaries()))
}

/// Runs groups of generated calls, or the tests that the filters choose.
fn generated(context: &Context, groups: &[&str]) -> Result<Done> {
    let part = Choice {
        targets: vec!["generated".to_owned()],
        tests: groups.iter().map(|&name| name.to_owned()).collect(),
    };
    rust_tests(context, &part)
}

fn rust_tests(context: &Context, part: &Choice) -> Result<Done> {
    let chosen = select::tests(context.filters, &select::test_binaries());
    let tests = || {
        let mut tests = shell::cargo(&["test", "--profile", "deep", "--package", "casteljau"]);
        tests.arg("--no-fail-fast");
        for target in &part.targets {
            tests.args(["--test", target]);
        }
        with_variables(tests, context)
    };
    let filters = if chosen.tests.is_empty() {
        &part.tests
    } else {
        &chosen.tests
    };
    shell::run_tests(tests, filters)?;
    Ok(Done::Passed)
}

fn npm_package(context: &Context) -> Result<Done> {
    build::build()?;
    let mut tests = shell::node(&[
        "--test",
        "--test-reporter=spec",
        "tests/js/generated.test.js",
        "tests/js/large-drawings.test.js",
        "tests/js/memory.test.js",
    ]);
    tests.env_remove("CHROME_PATH");
    shell::run(&mut with_variables(tests, context))?;
    Ok(Done::Passed)
}

fn with_variables(mut command: Command, context: &Context) -> Command {
    command
        .env(DEEP, "1")
        .env("CASTELJAU_SKIPPED", &context.skipped);
    if let Some(cases) = context.cases {
        command.env(CASES, cases.to_string());
    }
    command
}
