//! `test` and `test-deep`: run all or selected steps, and print a summary with the failed and the skipped ones.

mod args;
mod child;
mod deep;
mod node;
mod runner;
mod select;
mod step;
mod steps;
mod summary;

use crate::setup;
use anyhow::Result;
use args::{Request, StepName};
pub(crate) use child::RUN_STEP;
pub(crate) use select::{Binary, test_binaries, tests as select_tests};
pub(crate) use step::Done;
use step::{Command, Step};

/// Runs all steps in order, or the selected ones; after a failure the other steps still run.
pub(crate) fn test(args: &[String]) -> Result<()> {
    let request = args::parse(args, &names(&steps::STEPS))?;
    run("test", &steps::STEPS, &request)
}

/// Runs the long sweeps and the soak tests, with many times the cases of [`test`].
pub(crate) fn deep(args: &[String]) -> Result<()> {
    let request = args::parse_deep(args, &names(&deep::STEPS))?;
    run("test-deep", &deep::STEPS, &request)
}

/// Runs one step in a process of its own; only `test` has steps in two lanes.
pub(crate) fn run_step(args: &[String]) -> Result<()> {
    let request = args::parse(args, &names(&steps::STEPS))?;
    child::run_by_itself(&steps::STEPS, &request)
}

fn run(name: &'static str, steps: &[Step], request: &Request) -> Result<()> {
    setup::wasm_target()?;
    setup::components()?;
    let cases = request.cases;
    runner::run(&Command { name, cases }, steps, &request.choices)
}

fn names(steps: &[Step]) -> Vec<StepName> {
    let name = |step: &Step| StepName {
        name: step.name,
        selects: step.selects,
    };
    steps.iter().map(name).collect()
}
