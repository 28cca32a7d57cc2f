//! Runs the steps of both lanes, and records their outcomes.

use super::args::Choice;
use super::child;
use super::step::{Command, Context, Done, Lane, Step, blocked, file, find, prepare, record};
use super::summary::{self, Outcome, Record};
use anyhow::{Result, bail};
use std::sync::mpsc::{Sender, channel};
use std::thread;
use std::time::Instant;

/// A step that ran in a process of its own, and its output.
struct Finished {
    title: String,
    record: Record,
    output: String,
}

impl Finished {
    fn show(self) -> Record {
        print!("\n{}\n{}", self.title, self.output);
        self.record
    }
}

/// Runs the selected steps, prints the summary, and fails if a step failed. The output of the first lane is shown at once,
/// that of a step of the other lane when it has ended and no step of the first lane is running.
pub(crate) fn run(command: &Command, steps: &[Step], choices: &[Choice]) -> Result<()> {
    let start = Instant::now();
    let is_rust = |choice: &&Choice| find(steps, choice).is_ok_and(|step| step.lane == Lane::Rust);
    let (mut first, mut other): (Vec<_>, Vec<_>) = choices.iter().partition(is_rust);
    if first.is_empty() {
        (first, other) = (other, first);
    }
    let mut records: Vec<Record> = Vec::new();
    thread::scope(|scope| -> Result<()> {
        let (sender, receiver) = channel();
        scope.spawn(|| run_other_lane(command, steps, other, sender));
        for choice in first {
            let record = run_here(command, find(steps, choice)?, choice, &records)?;
            records.push(record);
            for finished in receiver.try_iter() {
                records.push(finished?.show());
            }
        }
        for finished in receiver {
            records.push(finished?.show());
        }
        Ok(())
    })?;
    records.sort_by_key(|record| choices.iter().position(|choice| choice.step == record.name));
    let seconds = start.elapsed().as_secs_f64();
    print!("{}", summary::render(&records, seconds));
    let failed = |record: &&Record| matches!(record.outcome, Outcome::Failed(_));
    match records.iter().filter(failed).count() {
        0 => Ok(()),
        count => bail!("{count} of {} steps failed", records.len()),
    }
}

/// Runs steps one after the other, each in a process of its own, so that their output is kept apart.
fn run_other_lane(
    command: &Command,
    steps: &[Step],
    choices: Vec<&Choice>,
    sender: Sender<Result<Finished>>,
) {
    let mut records: Vec<Record> = Vec::new();
    for choice in choices {
        let finished = run_child(command, steps, choice, &records);
        records.extend(finished.iter().map(|finished| finished.record.clone()));
        if sender.send(finished).is_err() {
            return; // the first lane has ended with an error
        }
    }
}

fn run_child(
    command: &Command,
    steps: &[Step],
    choice: &Choice,
    records: &[Record],
) -> Result<Finished> {
    let step = find(steps, choice)?;
    prepare(step)?;
    let begin = Instant::now();
    let (outcome, output) = match blocked(step, records) {
        Some(outcome) => (outcome, String::new()),
        None => child::run(step, choice)?,
    };
    let seconds = begin.elapsed().as_secs_f64();
    Ok(Finished {
        title: title(step),
        record: record(command, step, choice, seconds, outcome),
        output,
    })
}

fn run_here(command: &Command, step: &Step, choice: &Choice, records: &[Record]) -> Result<Record> {
    println!("\n{}", title(step));
    prepare(step)?;
    let begin = Instant::now();
    let act = || {
        let context = Context {
            filters: &choice.filters,
            cases: command.cases,
            skipped: file(step, "skipped-tests"),
        };
        match (step.act)(&context) {
            Ok(Done::Passed) => Outcome::Passed,
            Ok(Done::Skipped(reason)) => Outcome::Skipped(reason),
            Err(error) => Outcome::Failed(format!("{error:#}")),
        }
    };
    let outcome = blocked(step, records).unwrap_or_else(act);
    if let Outcome::Failed(reason) | Outcome::Skipped(reason) = &outcome {
        println!("{}: {reason}", step.name);
    }
    let seconds = begin.elapsed().as_secs_f64();
    Ok(record(command, step, choice, seconds, outcome))
}

fn title(step: &Step) -> String {
    format!("━━ {} ({})", step.title, step.name)
}
