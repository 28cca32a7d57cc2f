//! `size`: what the parts of the package weigh after minification and gzip.

use crate::{build, shell};
use anyhow::Result;

/// Builds, then lets xtask/size.js weigh (esbuild and zlib are there already); it fails above the limit.
pub(crate) fn size() -> Result<()> {
    build::build()?;
    shell::run(&mut shell::node(&["xtask/size.js"]))
}
