//! `size`: the sizes of the parts of the package after minification and gzip.

use crate::{build, shell};
use anyhow::Result;

/// Builds, then runs xtask/size.js (which uses the installed esbuild and Node's zlib); fails if a size exceeds its
/// limit.
pub(crate) fn size() -> Result<()> {
    build::build()?;
    shell::run(&mut shell::node(&["xtask/size.js"]))
}
