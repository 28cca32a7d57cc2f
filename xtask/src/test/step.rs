//! A step of a test run: its requirements, its input, and the record of its outcome.

use super::args::Choice;
use super::summary::{Outcome, Record};
use crate::shell;
use anyhow::{Context as _, Result, bail};
use std::fs;
use std::path::PathBuf;
use std::process;

/// One step of a run.
pub(crate) struct Step {
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    /// The steps that must pass before this one.
    pub(crate) needs: &'static [&'static str],
    /// Whether names of files or tests may follow its name.
    pub(crate) selects: bool,
    pub(crate) lane: Lane,
    pub(crate) act: fn(&Context) -> Result<Done>,
}

/// The steps of a lane run one after the other, and both lanes at the same time. A step needs only steps of its own lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lane {
    /// What compiles and runs Rust.
    Rust,
    /// What builds and runs JavaScript.
    JavaScript,
}

/// The input of a step.
pub(crate) struct Context<'a> {
    /// The names of the files or tests to run; if empty, all.
    pub(crate) filters: &'a [String],
    /// The number of cases for generated tests, if the user gave one.
    pub(crate) cases: Option<u64>,
    /// The file to which tests write that they are skipped, one line each.
    pub(crate) skipped: PathBuf,
}

/// The outcome of a step that did not fail.
pub(crate) enum Done {
    Passed,
    /// The step could not run on this machine; the text gives the reason.
    Skipped(String),
}

/// The command of the user.
pub(crate) struct Command {
    pub(crate) name: &'static str,
    pub(crate) cases: Option<u64>,
}

pub(crate) fn find<'a>(steps: &'a [Step], choice: &Choice) -> Result<&'a Step> {
    let found = steps.iter().find(|step| step.name == choice.step);
    found.with_context(|| format!("no step {}", choice.step))
}

/// The outcome of a step that cannot run: the first step that it needs and that has not passed. `None` if it can run.
pub(crate) fn blocked(step: &Step, records: &[Record]) -> Option<Outcome> {
    let failed = |record: &&Record| {
        step.needs.contains(&record.name.as_str()) && record.outcome != Outcome::Passed
    };
    let needed = records.iter().find(failed)?;
    let ended = match needed.outcome {
        Outcome::Skipped(_) => "was skipped",
        _ => "failed",
    };
    Some(Outcome::Skipped(format!(
        "needs {}, which {ended}",
        needed.name
    )))
}

pub(crate) fn record(
    command: &Command,
    step: &Step,
    choice: &Choice,
    seconds: f64,
    outcome: Outcome,
) -> Record {
    let skipped = fs::read_to_string(file(step, "skipped-tests")).unwrap_or_default();
    let mut skipped_tests: Vec<String> = skipped.lines().map(str::to_owned).collect();
    skipped_tests.sort();
    skipped_tests.dedup();
    Record {
        name: step.name.to_owned(),
        title: step.title,
        seconds,
        outcome,
        command: repeat(command, choice),
        skipped_tests,
    }
}

/// The path of a file that a step writes: its output, or its list of skipped tests.
pub(crate) fn file(step: &Step, extension: &str) -> PathBuf {
    let folder = shell::target_dir().join("xtask-steps");
    folder.join(step.name).with_extension(extension)
}

/// Creates the folder of [`file`] and removes the files of an earlier run.
pub(crate) fn prepare(step: &Step) -> Result<()> {
    fs::create_dir_all(shell::target_dir().join("xtask-steps"))?;
    for extension in ["log", "skipped", "skipped-tests"] {
        let path = file(step, extension);
        if path.exists() {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

/// The command line that repeats a step.
fn repeat(command: &Command, choice: &Choice) -> String {
    let mut words = vec![format!("cargo xtask {}", command.name)];
    words.extend(command.cases.map(|cases| format!("--cases {cases}")));
    words.push(choice.step.clone());
    if !choice.filters.is_empty() {
        words.push("--".to_owned());
    }
    words.extend(choice.filters.iter().map(|filter| quoted(filter)));
    words.join(" ")
}

/// A word quoted for the shell if necessary.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "_-./:,".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', r"'\''"))
}

/// Runs all commands, even if one of them fails.
pub(crate) fn run_all(commands: impl IntoIterator<Item = process::Command>) -> Result<Done> {
    let results = commands
        .into_iter()
        .map(|mut command| shell::run(&mut command));
    let failed: Vec<String> = results
        .filter_map(|result| result.err())
        .map(|e| e.to_string())
        .collect();
    if !failed.is_empty() {
        bail!("{}", failed.join("; "));
    }
    Ok(Done::Passed)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(name: &'static str, needs: &'static [&'static str]) -> Step {
        Step {
            name,
            title: "A title",
            needs,
            selects: true,
            lane: Lane::Rust,
            act: |_| Ok(Done::Passed),
        }
    }

    fn ended_step(name: &str, outcome: Outcome) -> Record {
        Record {
            name: name.to_owned(),
            title: "A title",
            seconds: 0.0,
            outcome,
            command: String::new(),
            skipped_tests: Vec::new(),
        }
    }

    #[test]
    fn only_what_depends_on_a_failed_step_is_skipped() {
        let records = [
            ended_step("native", Outcome::Failed(String::new())),
            ended_step("build", Outcome::Failed(String::new())),
            ended_step("site", Outcome::Skipped(String::new())),
        ];
        let reason = |needs| blocked(&step("page", needs), &records);
        assert_eq!(reason(&[]), None);
        let skipped = |text: &str| Some(Outcome::Skipped(text.to_owned()));
        assert_eq!(reason(&["build"]), skipped("needs build, which failed"));
        assert_eq!(reason(&["site"]), skipped("needs site, which was skipped"));
        let passed = [ended_step("build", Outcome::Passed)];
        assert_eq!(blocked(&step("page", &["build"]), &passed), None);
    }

    #[test]
    fn the_command_that_repeats_a_step_has_its_filters() {
        let line = |cases, filters: &[&str]| {
            let filters = filters.iter().map(|&filter| filter.to_owned()).collect();
            let choice = Choice {
                step: "page".to_owned(),
                filters,
            };
            repeat(
                &Command {
                    name: "test",
                    cases,
                },
                &choice,
            )
        };
        assert_eq!(line(None, &[]), "cargo xtask test page");
        assert_eq!(
            line(Some(7), &["site.test.js", "it's here"]),
            r"cargo xtask test --cases 7 page -- site.test.js 'it'\''s here'"
        );
    }
}
