//! The summary of a run: a table of times, the failures, the skipped tests, and one line of counts.

use std::fmt::Write;

/// The outcome of a step; the texts give the reason.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outcome {
    Passed,
    Failed(String),
    Skipped(String),
}

/// The record of a finished step.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    pub(crate) name: String,
    pub(crate) title: &'static str,
    pub(crate) seconds: f64,
    pub(crate) outcome: Outcome,
    /// The command that repeats this step.
    pub(crate) command: String,
    /// The tests that were skipped in the step, each with the reason.
    pub(crate) skipped_tests: Vec<String>,
}

/// The text of the summary. The last line contains only the counts of steps.
pub(crate) fn render(records: &[Record], seconds: f64) -> String {
    let mut text = String::from("\n━━ Summary\n");
    for record in records {
        text += &row(record);
    }
    let _ = writeln!(text, "  {:<8}{seconds:>7.1} s  together", "");
    text += &failures(records);
    text += &skips(records);
    let count = |kind: fn(&Outcome) -> bool| records.iter().filter(|r| kind(&r.outcome)).count();
    let passed = count(|outcome| *outcome == Outcome::Passed);
    let failed = count(|outcome| matches!(outcome, Outcome::Failed(_)));
    let skipped = count(|outcome| matches!(outcome, Outcome::Skipped(_)));
    let _ = writeln!(
        text,
        "\n{passed} passed, {failed} failed, {skipped} skipped"
    );
    text
}

fn row(record: &Record) -> String {
    let outcome = match record.outcome {
        Outcome::Passed => "passed",
        Outcome::Failed(_) => "FAILED",
        Outcome::Skipped(_) => "skipped",
    };
    let tests = match record.skipped_tests.len() {
        0 => String::new(),
        1 => ", 1 test skipped".to_owned(),
        n => format!(", {n} tests skipped"),
    };
    let Record {
        name,
        title,
        seconds,
        ..
    } = record;
    format!("  {outcome:<8}{seconds:>7.1} s  {title} ({name}){tests}\n")
}

fn failures(records: &[Record]) -> String {
    let mut text = String::new();
    for record in records {
        if let Outcome::Failed(reason) = &record.outcome {
            let Record { name, command, .. } = record;
            let _ = writeln!(text, "  {name}: {reason}\n      to repeat: {command}");
        }
    }
    titled("Failed", text)
}

fn skips(records: &[Record]) -> String {
    let mut text = String::new();
    for record in records {
        let name = &record.name;
        if let Outcome::Skipped(reason) = &record.outcome {
            let _ = writeln!(text, "  {name}: {reason}");
        }
        for test in &record.skipped_tests {
            let _ = writeln!(text, "  {name}: {test}");
        }
    }
    titled("Skipped", text)
}

fn titled(title: &str, text: String) -> String {
    if text.is_empty() {
        text
    } else {
        format!("\n{title}:\n{text}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(name: &str, outcome: Outcome, skipped_tests: &[&str]) -> Record {
        Record {
            name: name.to_owned(),
            title: "A title",
            seconds: 12.34,
            outcome,
            command: format!("cargo xtask test {name}"),
            skipped_tests: skipped_tests.iter().map(|&test| test.to_owned()).collect(),
        }
    }

    #[test]
    fn failures_and_skips_are_listed_and_counted() {
        let records = [
            record("fmt", Outcome::Passed, &[]),
            record("build", Outcome::Failed("cargo ended".to_owned()), &[]),
            record("page", Outcome::Skipped("build failed".to_owned()), &[]),
            record("native", Outcome::Passed, &["a: no data", "b: no data"]),
        ];
        let expected = "
━━ Summary
  passed     12.3 s  A title (fmt)
  FAILED     12.3 s  A title (build)
  skipped    12.3 s  A title (page)
  passed     12.3 s  A title (native), 2 tests skipped
             50.0 s  together

Failed:
  build: cargo ended
      to repeat: cargo xtask test build

Skipped:
  page: build failed
  native: a: no data
  native: b: no data

2 passed, 1 failed, 1 skipped
";
        assert_eq!(render(&records, 50.0), expected);
    }

    #[test]
    fn without_failures_and_skips_only_the_table_and_the_counts_remain() {
        let text = render(&[record("fmt", Outcome::Passed, &[])], 12.0);
        assert!(
            !text.contains("Failed") && !text.contains("Skipped"),
            "{text}"
        );
        assert!(
            text.ends_with("\n\n1 passed, 0 failed, 0 skipped\n"),
            "{text}"
        );
    }
}
