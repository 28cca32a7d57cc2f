//! Resolves filters of the command line to test binaries, test files and patterns.

use crate::shell;
use anyhow::{Result, bail};
use std::fs;
use std::path::{Path, PathBuf};

/// A test binary of the crate: `tests/NAME.rs`, or `tests/NAME/main.rs`.
pub(crate) struct Binary {
    pub(crate) name: String,
    /// The text of its root file.
    text: String,
}

impl Binary {
    /// Whether it has tests that also run as wasm.
    pub(crate) fn runs_in_wasm(&self) -> bool {
        self.text.contains("wasm_bindgen_test")
    }

    /// Whether its root file declares a module, a folder of `tests/`.
    fn has_module(&self, name: &str) -> bool {
        let declaration = format!("mod {name};");
        self.text.lines().any(|line| line == declaration)
    }
}

/// The test binaries of the crate, by name.
pub(crate) fn test_binaries() -> Vec<Binary> {
    let entries = fs::read_dir(shell::root().join("tests"));
    let paths = entries.into_iter().flatten().flatten();
    let mut binaries: Vec<Binary> = paths.filter_map(|entry| binary(&entry.path())).collect();
    binaries.sort_by(|a, b| a.name.cmp(&b.name));
    binaries
}

fn binary(path: &Path) -> Option<Binary> {
    let name = path.file_stem()?.to_string_lossy().into_owned();
    let is_file = path.extension().is_some_and(|extension| extension == "rs");
    let root = if is_file {
        path.to_owned()
    } else {
        path.join("main.rs")
    };
    let text = fs::read_to_string(root).ok()?;
    Some(Binary { name, text })
}

/// Names of test binaries, and substrings of test names.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Choice {
    pub(crate) targets: Vec<String>,
    pub(crate) tests: Vec<String>,
}

/// A filter that names a binary (`generated`) selects it; one that names a module of a binary (`curve`, `tests/curve`,
/// `tests/curve/eval.rs`) selects the binary and the tests of the module; any other filter is a substring of a test name.
pub(crate) fn tests(filters: &[String], binaries: &[Binary]) -> Choice {
    let mut chosen = Choice::default();
    for filter in filters {
        let path = filter.strip_prefix("tests/").unwrap_or(filter);
        let path = path.strip_suffix(".rs").unwrap_or(path).replace('/', "::");
        let first = path.split("::").next().unwrap_or(&path);
        let of_module = binaries.iter().find(|binary| binary.has_module(first));
        if let Some(binary) = binaries.iter().find(|binary| binary.name == first) {
            chosen.targets.push(binary.name.clone());
        } else if let Some(binary) = of_module.filter(|_| !filter.contains("::")) {
            chosen.targets.push(binary.name.clone());
            chosen
                .tests
                .push(format!("{}::", path.trim_end_matches("::mod")));
        } else {
            chosen.tests.push(filter.clone());
        }
    }
    chosen.targets.sort();
    chosen.targets.dedup();
    chosen
}

/// Files of JavaScript tests, and patterns of test names.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Files {
    pub(crate) files: Vec<PathBuf>,
    pub(crate) patterns: Vec<String>,
}

/// A filter that names a file (by its path or its name, with or without `.test.js`) selects it; any other filter is a
/// pattern of test names. If no filter names a file, all files are selected.
pub(crate) fn files(filters: &[String], all: &[PathBuf]) -> Result<Files> {
    let mut chosen = Files::default();
    for filter in filters {
        let found = all.iter().find(|path| is_named(path, filter));
        if let Some(path) = found {
            chosen.files.push(path.clone());
        } else if filter.ends_with(".js") {
            let known: Vec<String> = all.iter().map(|path| short_name(path)).collect();
            bail!("expected one of {}, got {filter}", known.join(", "));
        } else {
            chosen.patterns.push(pattern(filter));
        }
    }
    if chosen.files.is_empty() {
        chosen.files = all.to_vec();
    }
    Ok(chosen)
}

fn is_named(path: &Path, filter: &str) -> bool {
    path.ends_with(filter) || short_name(path) == filter
}

/// The pattern of a filter: `/…/` is a regular expression for test names; any other text is a substring.
fn pattern(filter: &str) -> String {
    if filter.len() > 2 && filter.starts_with('/') && filter.ends_with('/') {
        return filter.to_owned();
    }
    let special = |c: char| r".*+?^${}()|[]\".contains(c);
    let escaped = filter.chars().flat_map(|c| {
        let escape = special(c).then_some('\\');
        escape.into_iter().chain([c])
    });
    escaped.collect()
}

/// The name of a file without `.test.js`.
fn short_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.trim_end_matches(".test.js").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn owned(words: &[&str]) -> Vec<String> {
        words.iter().map(|&word| word.to_owned()).collect()
    }

    fn named(name: &str, text: &str) -> Binary {
        let (name, text) = (name.to_owned(), text.to_owned());
        Binary { name, text }
    }

    #[test]
    fn binaries_and_modules_are_chosen_by_name_or_path() {
        let known = [
            named("one", "mod curve;\nmod path;\n"),
            named("two", "mod runner;\n"),
        ];
        let read = |filters: &[&str]| tests(&owned(filters), &known);
        let expected = |targets: &[&str], tests: &[&str]| Choice {
            targets: owned(targets),
            tests: owned(tests),
        };
        for filter in ["curve", "tests/curve", "tests/curve/mod.rs"] {
            assert_eq!(
                read(&[filter]),
                expected(&["one"], &["curve::"]),
                "{filter}"
            );
        }
        assert_eq!(
            read(&["tests/curve/eval.rs"]),
            expected(&["one"], &["curve::eval::"])
        );
        for filter in ["two", "tests/two", "tests/two/main.rs", "tests/two.rs"] {
            assert_eq!(read(&[filter]), expected(&["two"], &[]), "{filter}");
        }
        assert_eq!(
            read(&["curve", "path"]),
            expected(&["one"], &["curve::", "path::"])
        );
        assert_eq!(
            read(&["curves", "curve::eval"]),
            expected(&[], &["curves", "curve::eval"])
        );
    }

    #[test]
    fn the_binaries_are_found_in_the_folder_of_tests() {
        let found = test_binaries();
        let names: Vec<&str> = found.iter().map(|binary| binary.name.as_str()).collect();
        assert_eq!(names, ["generated", "native", "native_and_wasm"]);
        let wasm: Vec<bool> = found.iter().map(Binary::runs_in_wasm).collect();
        assert_eq!(wasm, [false, false, true]);
    }

    #[test]
    fn files_are_chosen_by_name_or_path_and_the_rest_are_patterns() {
        let all = ["/a/tests/js/arc.test.js", "/a/tests/js/curve.test.js"].map(PathBuf::from);
        let read = |filters: &[&str]| files(&owned(filters), &all);
        for filter in ["curve", "curve.test.js", "tests/js/curve.test.js"] {
            let chosen = read(&[filter]).expect(filter);
            assert_eq!(chosen.files, all[1..], "{filter}");
        }
        let chosen = read(&["curve", "split", "(t)?", "/^at t/"]).expect("a file and patterns");
        assert_eq!(chosen.files, all[1..]);
        assert_eq!(chosen.patterns, ["split", r"\(t\)\?", "/^at t/"]);
        assert_eq!(read(&["split"]).expect("a pattern").files, all);
        let error = read(&["curves.test.js"]).expect_err("no such file");
        assert_eq!(
            error.to_string(),
            "expected one of arc, curve, got curves.test.js"
        );
    }
}
