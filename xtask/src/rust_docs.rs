//! The Rust documentation in the folder rust/ of the site.

use crate::shell;
use anyhow::{Context, Result};
use std::fs;
use std::path::Path;
use std::process::Command;

/// `cargo doc` of the crate, with the same flags wherever it is called, so that it runs once.
pub(crate) fn command() -> Command {
    let package = ["--package", "casteljau", "--features", "serde,kurbo"];
    let mut docs = shell::cargo(&["doc", "--quiet", "--no-deps"]);
    docs.args(package).env("RUSTDOCFLAGS", "--deny warnings");
    docs
}

/// Builds the documentation and copies it to site/rust.
pub(crate) fn add_to_site() -> Result<()> {
    shell::run(&mut command())?;
    let root = shell::root();
    let docs = root.join("target/doc");
    let site = root.join("site/rust");
    for item in fs::read_dir(&docs).context("target/doc")? {
        let path = item?.path();
        let name = path.file_name().expect("a name").to_owned();
        // Other packages may have been documented as well.
        let is_shared = [
            "src",
            "static.files",
            "search.index",
            "trait.impl",
            "type.impl",
        ]
        .iter()
        .any(|shared| name == *shared);
        if path.is_file() || is_shared || name == "casteljau" {
            copy(&path, &site.join(name))?;
        }
    }
    Ok(())
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    if from.is_file() {
        fs::create_dir_all(to.parent().expect("a folder"))?;
        fs::copy(from, to).with_context(|| from.display().to_string())?;
        return Ok(());
    }
    for item in fs::read_dir(from)? {
        let path = item?.path();
        copy(&path, &to.join(path.file_name().expect("a name")))?;
    }
    Ok(())
}
