//! The steps of `test-deep`, which would take too long in `test`.

use super::step::{Context, Done, Step};
use super::{node, select};
use crate::{build, shell, wasm_test};
use anyhow::Result;
use std::process::Command;

/// The environment variable that makes tests run many more cases.
const DEEP: &str = "CASTELJAU_DEEP";
/// The environment variable with the number of calls per function in the generated tests.
const CASES: &str = "CASTELJAU_CASES";
/// The test binary of generated calls, which is a separate step.
const GENERATED: &str = "generated";

pub(crate) const STEPS: [Step; 5] = [
    Step {
        name: "sweeps",
        title: "Rust tests with many more cases",
        needs: &[],
        selects: true,
        beside: None,
        act: sweeps,
    },
    Step {
        name: "generated",
        title: "Generated calls of the Rust crate",
        needs: &[],
        selects: true,
        beside: None,
        act: generated,
    },
    Step {
        name: "generated-js",
        title: "Generated calls of the npm package",
        needs: &[],
        selects: false,
        beside: None,
        act: generated_js,
    },
    Step {
        name: "wasm-chromium",
        title: "Rust tests as wasm, in Chromium",
        needs: &[],
        selects: true,
        beside: None,
        act: |context| wasm_test::in_chromium(context.filters),
    },
    Step {
        name: "page",
        title: "Page tests that take long, in Chromium",
        needs: &[],
        selects: true,
        beside: None,
        act: |context| node::page(context, &["--deep"]),
    },
];

/// Runs the test binaries that have more cases in deep mode.
fn sweeps(context: &Context) -> Result<Done> {
    let targets = select::test_targets().into_iter();
    let known: Vec<String> = targets
        .filter(|(name, root)| name != GENERATED && select::mentions(root, DEEP))
        .map(|(name, _)| name)
        .collect();
    let chosen = select::binaries(context.filters, &known);
    let targets = if chosen.targets.is_empty() {
        &known
    } else {
        &chosen.targets
    };
    let tests = || with_variables(rust_tests(targets), context);
    shell::run_tests(tests, &chosen.tests)?;
    Ok(Done::Passed)
}

fn generated(context: &Context) -> Result<Done> {
    let tests = || with_variables(rust_tests(&[GENERATED.to_owned()]), context);
    shell::run_tests(tests, context.filters)?;
    Ok(Done::Passed)
}

fn generated_js(context: &Context) -> Result<Done> {
    build::build()?;
    let mut tests = shell::node(&[
        "--test",
        "--test-reporter=spec",
        "tests/js/generated.test.js",
    ]);
    tests.env_remove("CHROME_PATH");
    shell::run(&mut with_variables(tests, context))?;
    Ok(Done::Passed)
}

fn rust_tests(targets: &[String]) -> Command {
    let mut tests = shell::cargo(&["test", "--profile", "deep", "--package", "casteljau"]);
    tests.arg("--no-fail-fast");
    for target in targets {
        tests.args(["--test", target]);
    }
    tests
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
