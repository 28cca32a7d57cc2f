//! Resolves filters of the command line to test binaries, test files and patterns.

use crate::shell;
use anyhow::{Result, bail};
use std::fs;
use std::path::{Path, PathBuf};

/// Names of test binaries, and substrings of test names.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Binaries {
    pub(crate) targets: Vec<String>,
    pub(crate) tests: Vec<String>,
}

/// A filter that names a binary (`curve`, `tests/curve`, `tests/curve/main.rs`, `tests/one.rs`) selects it; any other
/// filter is a substring of a test name.
pub(crate) fn binaries(filters: &[String], known: &[String]) -> Binaries {
    let mut chosen = Binaries::default();
    for filter in filters {
        let name = filter.strip_prefix("tests/").unwrap_or(filter);
        let name = name.strip_suffix(".rs").unwrap_or(name);
        let name = name.split('/').next().unwrap_or(name);
        if known.iter().any(|target| target == name) {
            chosen.targets.push(name.to_owned());
        } else {
            chosen.tests.push(filter.clone());
        }
    }
    chosen
}

/// The names of the test binaries of the crate, each with its main file.
pub(crate) fn test_targets() -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(shell::root().join("tests"));
    let paths = entries
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.path());
    let mut targets: Vec<(String, PathBuf)> = paths.filter_map(target).collect();
    targets.sort();
    targets
}

fn target(path: PathBuf) -> Option<(String, PathBuf)> {
    let name = path.file_stem()?.to_string_lossy().into_owned();
    let root = match path.extension() {
        Some(extension) => Some(path.clone()).filter(|_| extension == "rs"),
        None => Some(path.join("main.rs")),
    };
    root.filter(|root| root.is_file()).map(|root| (name, root))
}

/// Whether the main file of a test binary, or a file beside it, contains a text.
pub(crate) fn mentions(root: &Path, text: &str) -> bool {
    let has = |path: &Path| fs::read_to_string(path).is_ok_and(|source| source.contains(text));
    if root.file_name().is_none_or(|name| name != "main.rs") {
        return has(root);
    }
    let entries = root.parent().and_then(|folder| fs::read_dir(folder).ok());
    let mut paths = entries
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.path());
    paths.any(|path| has(&path))
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

    #[test]
    fn binaries_are_chosen_by_name_or_path() {
        let known = owned(&["curve", "one"]);
        let read = |filters: &[&str]| binaries(&owned(filters), &known);
        let expected = |targets: &[&str], tests: &[&str]| Binaries {
            targets: owned(targets),
            tests: owned(tests),
        };
        for filter in [
            "curve",
            "tests/curve",
            "tests/curve/main.rs",
            "tests/curve/eval.rs",
        ] {
            assert_eq!(read(&[filter]), expected(&["curve"], &[]), "{filter}");
        }
        assert_eq!(read(&["tests/one.rs"]), expected(&["one"], &[]));
        assert_eq!(read(&["curve", "split"]), expected(&["curve"], &["split"]));
        assert_eq!(read(&["curves"]), expected(&[], &["curves"]));
    }

    #[test]
    fn the_binaries_are_found_in_the_folder_of_tests() {
        let targets = test_targets();
        let has = |name: &str| targets.iter().any(|(target, _)| target == name);
        assert!(has("curve") && has("surface"), "{targets:?}");
        assert!(!has("common") && !has("js") && !has("data"), "{targets:?}");
        let in_wasm = |name: &str| {
            let found = targets.iter().find(|(target, _)| target == name);
            found.is_some_and(|(_, root)| mentions(root, "wasm_bindgen_test"))
        };
        assert!(in_wasm("curve") && in_wasm("surface") && !in_wasm("watertight"));
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
