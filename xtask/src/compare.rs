//! `compare`: the generated calls of the tests with the library of an earlier revision and with the present one; results
//! that differ are listed.

use crate::shell;
use anyhow::{Context, Result, bail, ensure};
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// The folders of the tests that make the calls. Those of the working tree are used with both libraries.
const CALLS: [&str; 2] = ["tests/generated", "tests/generator"];
/// The number of calls of each function, unless `--cases` gives another one.
const CASES: &str = "500";

struct Options {
    revision: String,
    cases: String,
    /// The largest distance of two numbers that counts as equal, relative to the largest number of the result.
    distance: f64,
    /// One function, such as `Curve::offset`.
    function: Option<String>,
}

/// `compare REVISION [FUNCTION] [--cases N] [--distance D]`.
pub(crate) fn compare(args: &[String]) -> Result<()> {
    let options = parse(args)?;
    let folder = shell::target_dir().join("compare");
    let tree = checked_out(&options.revision, &folder)?;
    let old = results(&tree, &folder.join("old"), &options)?;
    let new = results(&shell::root(), &folder.join("new"), &options)?;
    report(&old, &new, options.distance)
}

fn parse(args: &[String]) -> Result<Options> {
    let mut options = Options {
        revision: String::new(),
        cases: CASES.to_owned(),
        distance: 0.0,
        function: None,
    };
    let mut rest = args.iter();
    while let Some(arg) = rest.next() {
        let mut value = || {
            let value = rest.next().cloned();
            value.with_context(|| format!("{arg}: expected a number after it"))
        };
        match arg.as_str() {
            "--cases" => options.cases = value()?,
            "--distance" => options.distance = value()?.parse().context("--distance")?,
            name if name.contains("::") => options.function = Some(name.to_owned()),
            revision if options.revision.is_empty() => options.revision = revision.to_owned(),
            other => bail!("expected a function such as Curve::offset, got {other}"),
        }
    }
    ensure!(!options.revision.is_empty(), "expected a revision");
    Ok(options)
}

/// Checks a revision out into a worktree, and puts the present calls into it.
fn checked_out(revision: &str, folder: &Path) -> Result<PathBuf> {
    let tree = folder.join("tree");
    let git = |folder: &Path, args: &[&str]| {
        let mut git = shell::command("git", args);
        shell::run_quietly(git.current_dir(folder))
    };
    if tree.join(".git").exists() {
        git(
            &tree,
            &["checkout", "--quiet", "--force", "--detach", revision],
        )?;
        git(&tree, &["clean", "--quiet", "-d", "--force", "tests"])?;
    } else {
        fs::create_dir_all(folder)?;
        let path = tree.to_string_lossy();
        git(&shell::root(), &["worktree", "prune"])?;
        git(
            &shell::root(),
            &["worktree", "add", "--detach", &path, revision],
        )?;
    }
    for calls in CALLS {
        fs::remove_dir_all(tree.join(calls)).ok();
        copy(&shell::root().join(calls), &tree.join(calls))?;
    }
    Ok(tree)
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for item in fs::read_dir(from)? {
        let path = item?.path();
        let target = to.join(path.file_name().context("a name")?);
        if path.is_dir() {
            copy(&path, &target)?;
        } else {
            fs::copy(&path, &target).with_context(|| path.display().to_string())?;
        }
    }
    Ok(())
}

/// Runs the calls with the library in a folder. They write a file of results for each function. A test that fails is no
/// error here, because an earlier revision may have defects that the present checks find.
fn results(tree: &Path, output: &Path, options: &Options) -> Result<PathBuf> {
    if output.exists() {
        fs::remove_dir_all(output)?;
    }
    fs::create_dir_all(output)?;
    let mut cargo = shell::cargo(&["test", "--package", "casteljau", "--test", "generated"]);
    cargo.args(["--features", "serde,kurbo"]).current_dir(tree);
    cargo.env("CASTELJAU_RECORD", output);
    cargo.env("CASTELJAU_CASES", &options.cases);
    if let Some(function) = &options.function {
        cargo.env("CASTELJAU_ONLY", function);
    }
    if tree != shell::root() {
        cargo.env(
            "CARGO_TARGET_DIR",
            shell::target_dir().join("compare/target"),
        );
    }
    println!("calls with the library in {}", tree.display());
    let result = shell::run_quietly(&mut cargo);
    let count = fs::read_dir(output)?.count();
    if count == 0 {
        result?;
        bail!("no results in {}", output.display());
    }
    Ok(output.to_owned())
}

/// The numbers of each call of a function, sorted by the case: its number, and those of the result.
fn read(file: &Path) -> Result<Vec<Vec<f64>>> {
    let Ok(bytes) = fs::read(file) else {
        return Ok(Vec::new());
    };
    let mut numbers = bytes.chunks_exact(8).map(|word| {
        let word: [u8; 8] = word.try_into().unwrap_or_default();
        u64::from_le_bytes(word)
    });
    let mut calls: Vec<Vec<f64>> = Vec::new();
    while let Some(count) = numbers.next() {
        let count = usize::try_from(count)?;
        calls.push(numbers.by_ref().take(count).map(f64::from_bits).collect());
    }
    // Tests that run at the same time record their calls in any order.
    calls.sort_by(|a, b| case(a).total_cmp(&case(b)));
    Ok(calls)
}

/// The number of the case, which is the first number of a call.
fn case(call: &[f64]) -> f64 {
    call.first().copied().unwrap_or(0.0)
}

/// Prints a line for each function whose results differ, and fails if there is one.
fn report(old: &Path, new: &Path, distance: f64) -> Result<()> {
    let mut names: BTreeSet<OsString> = BTreeSet::new();
    for folder in [old, new] {
        for item in fs::read_dir(folder)? {
            names.insert(item?.file_name());
        }
    }
    let (mut calls, mut failed) = (0, 0);
    for name in &names {
        let (before, after) = (read(&old.join(name))?, read(&new.join(name))?);
        calls += after.len();
        let different = differences(&before, &after, distance);
        let Some(&(first, _)) = different.first() else {
            continue;
        };
        failed += 1;
        let call = after.get(first).or(before.get(first));
        let case = call.map_or(0.0, |call| case(call));
        let largest = different.iter().map(|&(_, apart)| apart);
        println!(
            "{}: {} of {} calls differ, first in case {case}, largest relative distance {:e}",
            name.to_string_lossy().replace('.', "::"),
            different.len(),
            before.len().max(after.len()),
            largest.fold(0.0, f64::max)
        );
    }
    println!("{calls} calls of {} functions", names.len());
    ensure!(failed == 0, "the results of {failed} functions differ");
    Ok(())
}

/// The numbers of the calls whose results differ, and their relative distances.
fn differences(before: &[Vec<f64>], after: &[Vec<f64>], distance: f64) -> Vec<(usize, f64)> {
    let none = Vec::new();
    let call = |calls: &[Vec<f64>], k: usize| calls.get(k).unwrap_or(&none).clone();
    let count = before.len().max(after.len());
    let apart = (0..count).map(|k| (k, relative_distance(&call(before, k), &call(after, k))));
    apart
        .filter(|&(_, apart)| apart.is_some_and(|apart| distance == 0.0 || apart > distance))
        .map(|(k, apart)| (k, apart.unwrap_or(0.0)))
        .collect()
}

/// The largest difference of two numbers, relative to the largest number; infinite if the results have different lengths or
/// only one of two numbers is finite. `None` if they are equal bit for bit.
fn relative_distance(a: &[f64], b: &[f64]) -> Option<f64> {
    if a.len() != b.len() {
        return Some(f64::INFINITY);
    }
    let unequal = |(x, y): &(&f64, &f64)| x.to_bits() != y.to_bits();
    let mut pairs = a.iter().zip(b).filter(unequal).peekable();
    pairs.peek()?;
    let size = a.iter().chain(b).filter(|x| x.is_finite());
    let size = size.fold(f64::MIN_POSITIVE, |size, x| size.max(x.abs()));
    let difference = |(x, y): (&f64, &f64)| (x - y).abs() / size;
    let apart = pairs.map(difference);
    Some(apart.fold(0.0, |max, x| {
        if x.is_nan() {
            f64::INFINITY
        } else {
            max.max(x)
        }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_equal_bit_for_bit_or_have_a_distance() {
        let distance = |a: &[f64], b: &[f64]| relative_distance(a, b);
        assert_eq!(distance(&[1.0, f64::NAN], &[1.0, f64::NAN]), None);
        assert_eq!(distance(&[0.0, 4.0], &[-0.0, 4.0]), Some(0.0));
        assert_eq!(distance(&[1.0, 4.0], &[2.0, 4.0]), Some(0.25));
        assert_eq!(distance(&[1.0], &[]), Some(f64::INFINITY));
        assert_eq!(distance(&[1.0], &[f64::NAN]), Some(f64::INFINITY));
        let calls = [vec![1.0], vec![2.0, 3.0]];
        assert_eq!(differences(&calls, &calls, 0.0), []);
        assert_eq!(differences(&calls, &calls[..1], 0.0), [(1, f64::INFINITY)]);
        assert_eq!(differences(&calls, &[vec![1.5], vec![2.0, 3.0]], 0.4), []);
        assert_eq!(differences(&[vec![0.0]], &[vec![-0.0]], 0.0), [(0, 0.0)]);
    }
}
