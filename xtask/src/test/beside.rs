//! Steps that run beside another: each in a process of its own, so that their output can be kept apart.

use super::RUN_STEP;
use super::args::{Choice, Request};
use super::runner::{Command, Context, Done, Step, blocked, file, find, prepare, record};
use super::summary::{Outcome, Record};
use anyhow::{Result, bail};
use std::fs::{self, File};
use std::process::{self, Child, Stdio};
use std::time::Instant;

/// A step that runs in a process of its own, its output kept until the step before it has ended.
pub(crate) struct Other<'a> {
    command: &'a Command,
    step: &'a Step,
    choice: &'a Choice,
    begin: Instant,
    state: State,
}

enum State {
    Running(Child),
    Blocked(Outcome),
}

impl<'a> Other<'a> {
    pub(crate) fn start(
        command: &'a Command,
        step: &'a Step,
        choice: &'a Choice,
        records: &[Record],
    ) -> Result<Self> {
        prepare(step)?;
        let state = match blocked(step, records) {
            Some(outcome) => State::Blocked(outcome),
            None => State::Running(spawn(step, choice)?),
        };
        Ok(Self {
            command,
            step,
            choice,
            begin: Instant::now(),
            state,
        })
    }

    pub(crate) fn finish(self) -> Result<Record> {
        println!("\n━━ {} ({})", self.step.title, self.step.name);
        let outcome = match self.state {
            State::Blocked(outcome) => outcome,
            State::Running(mut child) => {
                let passed = child.wait()?.success();
                let output = fs::read_to_string(file(self.step, "log"))?;
                print!("{output}");
                ended(self.step, passed, &output)
            }
        };
        let Self {
            command,
            step,
            choice,
            begin,
            ..
        } = self;
        Ok(record(command, step, choice, begin, outcome))
    }
}

fn spawn(step: &Step, choice: &Choice) -> Result<Child> {
    let log = File::create(file(step, "log"))?;
    let mut command = process::Command::new(std::env::current_exe()?);
    command
        .args([RUN_STEP, step.name, "--"])
        .args(&choice.filters);
    command
        .stdin(Stdio::null())
        .stdout(log.try_clone()?)
        .stderr(log);
    Ok(command.spawn()?)
}

/// How a step in another process ended: by its exit code, the file of [`run_alone`], and its last words.
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

/// Runs a single step without a summary. Why it is skipped, if it is, stands in a file.
pub(crate) fn run_alone(steps: &[Step], request: &Request) -> Result<()> {
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
