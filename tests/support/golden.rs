//! Reads golden data from `tests/data`, or from `../shared/data`, which may be absent.

use serde_json::Value;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;

/// The file with this name in `tests/data`, without `.json`.
pub(crate) fn golden(name: &str) -> Value {
    let path = format!("{}/tests/data/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The file with this name in `../shared/data`, which is not part of the project. If it is absent, the calling test is
/// reported as skipped.
pub(crate) fn shared(name: &str) -> Option<Value> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    let Ok(text) = fs::read_to_string(folder.join(name).with_extension("json")) else {
        report_skipped(&format!("../shared/data/{name}.json is absent"));
        return None;
    };
    Some(serde_json::from_str(&text).unwrap_or_else(|error| panic!("{name}: {error}")))
}

/// Reports that the running test, or a part of it, is skipped. The environment variable `CASTELJAU_SKIPPED`, set by the
/// driver, names a file that collects these lines for its summary, because libtest counts such a test as passed.
pub(crate) fn report_skipped(reason: &str) {
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("a test without a name");
    let line = format!("{} {test}: {reason}\n", env!("CARGO_CRATE_NAME"));
    print!("SKIPPED: {line}");
    if let Some(path) = std::env::var_os("CASTELJAU_SKIPPED") {
        let file = OpenOptions::new().create(true).append(true).open(path);
        let written = file.and_then(|mut file| file.write_all(line.as_bytes()));
        written.expect("CASTELJAU_SKIPPED: the file can be written");
    }
}
