//! Runs steps one after the other, or two in parallel if the output of one can wait, and records their outcomes.

use super::args::Choice;
use super::beside::Other;
use super::step::{Command, Context, Done, Step, blocked, file, find, prepare, record};
use super::summary::{self, Outcome, Record};
use anyhow::{Result, bail};
use std::time::Instant;

/// Runs the selected steps, prints the summary, and fails if a step failed.
pub(crate) fn run(command: &Command, steps: &[Step], choices: &[Choice]) -> Result<()> {
    let start = Instant::now();
    let mut records: Vec<Record> = Vec::new();
    let mut rest = choices;
    while let Some(first) = rest.first() {
        let beside = |choice: &&Choice| {
            find(steps, choice).is_ok_and(|step| step.beside == Some(first.step.as_str()))
        };
        let width = 1 + rest[1..].iter().take_while(beside).count();
        let mut others = Vec::new();
        for choice in &rest[1..width] {
            others.push(Other::start(
                command,
                find(steps, choice)?,
                choice,
                &records,
            )?);
        }
        records.push(run_here(command, find(steps, first)?, first, &records)?);
        for other in others {
            records.push(other.finish()?);
        }
        rest = &rest[width..];
    }
    print!(
        "{}",
        summary::render(&records, start.elapsed().as_secs_f64())
    );
    let failed = |record: &&Record| matches!(record.outcome, Outcome::Failed(_));
    match records.iter().filter(failed).count() {
        0 => Ok(()),
        count => bail!("{count} of {} steps failed", records.len()),
    }
}

fn run_here(command: &Command, step: &Step, choice: &Choice, records: &[Record]) -> Result<Record> {
    println!("\n━━ {} ({})", step.title, step.name);
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
    Ok(record(
        command,
        step,
        choice,
        begin.elapsed().as_secs_f64(),
        outcome,
    ))
}
