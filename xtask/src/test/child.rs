//! A step in a process of its own.

use super::args::{Choice, Request};
use super::step::{Context, Done, Step, file, find};
use super::summary::Outcome;
use anyhow::{Result, bail};
use std::fs::{self, File};
use std::process::{self, Stdio};

/// The hidden command with which the driver starts itself to run one step.
pub(crate) const RUN_STEP: &str = "run-test-step";

/// Runs a step in a process of its own; returns its outcome and its output.
pub(crate) fn run(step: &Step, choice: &Choice) -> Result<(Outcome, String)> {
    let log = File::create(file(step, "log"))?;
    let mut command = process::Command::new(std::env::current_exe()?);
    command
        .args([RUN_STEP, step.name, "--"])
        .args(&choice.filters);
    command
        .stdin(Stdio::null())
        .stdout(log.try_clone()?)
        .stderr(log);
    let passed = command.status()?.success();
    let output = fs::read_to_string(file(step, "log"))?;
    Ok((ended(step, passed, &output), output))
}

/// The outcome of a step in another process, from its exit code, the file of [`run_by_itself`], and the end of its
/// output.
fn ended(step: &Step, passed: bool, output: &str) -> Outcome {
    if !passed {
        let mut errors = output
            .lines()
            .rev()
            .filter_map(|line| line.strip_prefix("error: "));
        return Outcome::Failed(
            errors
                .next()
                .unwrap_or("it ended without a message")
                .to_owned(),
        );
    }
    fs::read_to_string(file(step, "skipped")).map_or(Outcome::Passed, Outcome::Skipped)
}

/// Runs a single step without a summary. If it is skipped, the reason is written to a file.
pub(crate) fn run_by_itself(steps: &[Step], request: &Request) -> Result<()> {
    let [choice] = request.choices.as_slice() else {
        bail!("expected the name of one step");
    };
    let step = find(steps, choice)?;
    let context = Context {
        filters: &choice.filters,
        cases: request.cases,
        skipped: file(step, "skipped-tests"),
    };
    if let Done::Skipped(reason) = (step.act)(&context)? {
        fs::write(file(step, "skipped"), reason)?;
    }
    Ok(())
}
