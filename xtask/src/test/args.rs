//! The command line arguments of `test` and `test-deep`.

use anyhow::{Context, Result, bail};

/// The name of a step and the arguments it accepts.
#[derive(Clone, Copy)]
pub(crate) struct StepName {
    pub(crate) name: &'static str,
    /// Whether names of files or tests may follow.
    pub(crate) selects: bool,
}

/// A step to run, and its filters (names of files or tests); without filters it runs all of its tests.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Choice {
    pub(crate) step: String,
    pub(crate) filters: Vec<String>,
}

/// The steps to run in order, and the number of cases for generated tests.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Request {
    pub(crate) choices: Vec<Choice>,
    pub(crate) cases: Option<u64>,
}

/// Parses `[STEP [FILE_OR_NAME …] …] [--from STEP] [--only STEP[,STEP]]`. An argument that is not the name of a step is
/// a filter of the step before it, as is every argument after `--`.
pub(crate) fn parse(args: &[String], steps: &[StepName]) -> Result<Request> {
    let mut parser = Parser {
        steps,
        choices: Vec::new(),
        selected_by: None,
    };
    let mut rest = args.iter();
    while let Some(arg) = rest.next() {
        match arg.as_str() {
            "--" => {
                for filter in rest.by_ref() {
                    parser.filter(filter)?;
                }
            }
            option @ ("--from" | "--only") => parser.select(option, rest.next())?,
            option if option.starts_with('-') => {
                bail!("expected --from, --only or the name of a step, got {option}")
            }
            word => parser.word(word)?,
        }
    }
    if parser.selected_by.is_none() {
        parser.choices = steps.iter().map(|step| Choice::all(step.name)).collect();
    }
    Ok(Request {
        choices: parser.choices,
        cases: None,
    })
}

/// [`parse`] for `test-deep`, which also takes `--cases N`.
pub(crate) fn parse_deep(args: &[String], steps: &[StepName]) -> Result<Request> {
    let Some(at) = args.iter().position(|arg| arg == "--cases") else {
        return parse(args, steps);
    };
    let number = args.get(at + 1).map_or("nothing", String::as_str);
    let cases: u64 = number
        .parse()
        .ok()
        .filter(|&cases| cases > 0)
        .with_context(|| format!("--cases: expected a number from 1, got {number}"))?;
    let others = [&args[..at], &args[at + 2..]].concat();
    Ok(Request {
        cases: Some(cases),
        ..parse(&others, steps)?
    })
}

impl Choice {
    fn all(step: &str) -> Self {
        Self {
            step: step.to_owned(),
            filters: Vec::new(),
        }
    }
}

struct Parser<'a> {
    steps: &'a [StepName],
    choices: Vec<Choice>,
    /// The form that selected the steps so far: `--from`, `--only`, or names.
    selected_by: Option<&'a str>,
}

impl<'a> Parser<'a> {
    fn find(&self, name: &str) -> Result<usize> {
        let known: Vec<&str> = self.steps.iter().map(|step| step.name).collect();
        let found = known.iter().position(|&step| step == name);
        found.with_context(|| format!("expected one of {}, got {name}", known.join(", ")))
    }

    /// Records the form that selects steps; returns an error if another one of the three forms was used before.
    fn claim(&mut self, form: &'a str) -> Result<()> {
        match self.selected_by.replace(form) {
            Some(other) if other != form => bail!("{other} and {form} cannot be combined"),
            _ => Ok(()),
        }
    }

    fn select(&mut self, option: &'a str, value: Option<&String>) -> Result<()> {
        self.claim(option)?;
        let value = value.with_context(|| format!("{option}: expected the name of a step"))?;
        if option == "--from" {
            let from = self.find(value)?;
            self.choices = self.steps[from..]
                .iter()
                .map(|step| Choice::all(step.name))
                .collect();
            return Ok(());
        }
        let mut chosen = Vec::new();
        for name in value.split(',') {
            chosen.push(self.find(name)?);
        }
        chosen.sort_unstable();
        chosen.dedup();
        let names = chosen.iter().map(|&k| self.steps[k].name);
        self.choices.extend(names.map(Choice::all));
        Ok(())
    }

    fn word(&mut self, word: &str) -> Result<()> {
        if self.selected_by == Some("names") && self.find(word).is_err() {
            return self.filter(word);
        }
        self.find(word)?;
        self.claim("names")?;
        self.choices.push(Choice::all(word));
        Ok(())
    }

    fn filter(&mut self, filter: &str) -> Result<()> {
        if self.selected_by != Some("names") {
            bail!("{filter}: expected the name of a step before it");
        }
        let error = self.find(filter).err();
        if let Some(last) = self.choices.last_mut() {
            let takes = |step: &StepName| step.name == last.step && step.selects;
            if !self.steps.iter().any(takes) {
                let known = error.map_or_else(String::new, |error| format!("; {error}"));
                bail!("{} has no tests to choose from{known}", last.step);
            }
            last.filters.push(filter.to_owned());
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: [StepName; 4] = [
        StepName {
            name: "fmt",
            selects: false,
        },
        StepName {
            name: "native",
            selects: true,
        },
        StepName {
            name: "build",
            selects: false,
        },
        StepName {
            name: "page",
            selects: true,
        },
    ];

    fn words(line: &str) -> Vec<String> {
        line.split_whitespace().map(str::to_owned).collect()
    }

    /// The parsed request as text: `step(filter filter) step`.
    fn read(line: &str) -> Result<String, String> {
        let request = parse_deep(&words(line), &STEPS).map_err(|error| error.to_string())?;
        let mut parts: Vec<String> = request
            .choices
            .into_iter()
            .map(|choice| match choice.filters.join(" ") {
                none if none.is_empty() => choice.step,
                filters => format!("{}({filters})", choice.step),
            })
            .collect();
        parts.extend(request.cases.map(|cases| cases.to_string()));
        Ok(parts.join(" "))
    }

    #[test]
    fn steps_and_filters_are_distinguished() {
        for (line, expected) in [
            ("", "fmt native build page"),
            ("fmt", "fmt"),
            ("page fmt", "page fmt"),
            ("native curve split", "native(curve split)"),
            (
                "native curve page site.test.js",
                "native(curve) page(site.test.js)",
            ),
            ("page -- fmt --from", "page(fmt --from)"),
            ("--from build", "build page"),
            ("--only page,fmt", "fmt page"),
            ("--only page --only fmt", "page fmt"),
            ("--cases 5000 page", "page 5000"),
            ("--cases 7", "fmt native build page 7"),
        ] {
            assert_eq!(read(line), Ok(expected.to_owned()), "{line}");
        }
    }

    #[test]
    fn refusals_name_what_is_expected() {
        let known = "expected one of fmt, native, build, page, got";
        for (line, expected) in [
            ("pages", format!("{known} pages")),
            ("--from pages", format!("{known} pages")),
            ("--only fmt,pages", format!("{known} pages")),
            ("--only fmt,", format!("{known} ")),
            (
                "fmt curve",
                format!("fmt has no tests to choose from; {known} curve"),
            ),
            ("--from", "--from: expected the name of a step".to_owned()),
            (
                "--only fmt --from fmt",
                "--only and --from cannot be combined".to_owned(),
            ),
            (
                "fmt --from fmt",
                "names and --from cannot be combined".to_owned(),
            ),
            (
                "--only fmt page",
                "--only and names cannot be combined".to_owned(),
            ),
            (
                "--only page -- site",
                "site: expected the name of a step before it".to_owned(),
            ),
            (
                "--deep",
                "expected --from, --only or the name of a step, got --deep".to_owned(),
            ),
            (
                "--cases many",
                "--cases: expected a number from 1, got many".to_owned(),
            ),
            (
                "--cases",
                "--cases: expected a number from 1, got nothing".to_owned(),
            ),
        ] {
            assert_eq!(read(line), Err(expected), "{line}");
        }
    }
}
