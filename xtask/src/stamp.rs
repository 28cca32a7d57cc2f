//! Incremental builds: the contents of the inputs are hashed and compared with those of the last run.

use crate::shell;
use anyhow::{Context, Result};
use std::fs::{self, File};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// A build task: its inputs, and the outputs that must exist afterwards.
pub(crate) struct Work<'a> {
    pub(crate) name: &'a str,
    pub(crate) inputs: &'a [PathBuf],
    pub(crate) outputs: &'a [PathBuf],
}

/// Runs `act` unless the last run had the same inputs and every output still exists.
pub(crate) fn unless_current(work: &Work, act: impl FnOnce() -> Result<()>) -> Result<()> {
    let stamp = stamp_path(work.name);
    let key = format!("{:016x}", fingerprint(work.inputs)?);
    let current = fs::read_to_string(&stamp).is_ok_and(|old| old == key);
    if current && work.outputs.iter().all(|output| output.exists()) {
        println!("{:<10} up to date", work.name);
        return Ok(());
    }
    let start = std::time::Instant::now();
    act()?;
    println!("{:<10} {:.1} s", work.name, start.elapsed().as_secs_f64());
    fs::create_dir_all(stamp.parent().context("a stamp lies in a folder")?)?;
    Ok(fs::write(stamp, key)?)
}

/// Waits until no other driver runs in this clone, and blocks others until dropped.
pub(crate) fn lock() -> Result<File> {
    fs::create_dir_all(shell::target_dir())?;
    let file = File::create(shell::target_dir().join("xtask.lock"))?;
    file.lock()?;
    Ok(file)
}

/// All files below a folder, sorted, without `node_modules` and hidden files.
pub(crate) fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let Ok(entries) = fs::read_dir(folder) else {
        return files;
    };
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with('.') || name == "node_modules" {
            continue;
        }
        if path.is_dir() {
            files.extend(files_below(&path))
        } else {
            files.push(path)
        }
    }
    files.sort();
    files
}

fn stamp_path(name: &str) -> PathBuf {
    shell::target_dir()
        .join("xtask-stamps")
        .join(name.replace(' ', "-"))
}

/// A hash of the inputs. The driver itself is an input too, because a changed encoder must encode again.
fn fingerprint(inputs: &[PathBuf]) -> Result<u64> {
    let mut hasher = DefaultHasher::new();
    fs::metadata(std::env::current_exe()?)?
        .modified()?
        .hash(&mut hasher);
    for path in inputs {
        path.hash(&mut hasher);
        let bytes = fs::read(path).with_context(|| format!("reading {}", path.display()))?;
        bytes.hash(&mut hasher);
    }
    Ok(hasher.finish())
}
