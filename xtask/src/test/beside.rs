//! Steps that run in parallel to another one, each in its own process, so that their outputs are kept apart.

use super::args::{Choice, Request};
use super::step::{Command, Context, Done, Step, blocked, file, find, prepare, record};
use super::summary::{Outcome, Record};
use anyhow::{Result, bail};
use std::fs::{self, File};
use std::io;
use std::process::{self, Child, Stdio};
use std::thread::{self, JoinHandle};
use std::time::Instant;

/// The hidden command with which the driver starts itself to run one step in parallel to another one.
pub(crate) const RUN_STEP: &str = "run-test-step";

/// A step that runs in its own process. Its output is held back until the previous step has ended.
pub(crate) struct Other<'a> {
    command: &'a Command,
    step: &'a Step,
    choice: &'a Choice,
    state: State,
}

enum State {
    /// A thread that waits for the process and returns whether it passed, and its time in seconds.
    Running(JoinHandle<io::Result<(bool, f64)>>),
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
            None => State::Running(wait_for(spawn(step, choice)?)),
        };
        Ok(Self {
            command,
            step,
            choice,
            state,
        })
    }

    pub(crate) fn finish(self) -> Result<Record> {
        println!("\n━━ {} ({})", self.step.title, self.step.name);
        let (outcome, seconds) = match self.state {
            State::Blocked(outcome) => (outcome, 0.0),
            State::Running(thread) => {
                let Ok(waited) = thread.join() else {
                    bail!("{}: the thread that waits for it panicked", self.step.name);
                };
                let (passed, seconds) = waited?;
                let output = fs::read_to_string(file(self.step, "log"))?;
                print!("{output}");
                (ended(self.step, passed, &output), seconds)
            }
        };
        let Self {
            command,
            step,
            choice,
            ..
        } = self;
        Ok(record(command, step, choice, seconds, outcome))
    }
}

fn wait_for(mut child: Child) -> JoinHandle<io::Result<(bool, f64)>> {
    let begin = Instant::now();
    thread::spawn(move || {
        let passed = child.wait()?.success();
        Ok((passed, begin.elapsed().as_secs_f64()))
    })
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
