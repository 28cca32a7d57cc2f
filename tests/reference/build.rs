//! Makes a test of every Rust sample in www/api/entries: it must print the texts behind its `// → ` comments.
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

const ARROW: &str = "// → ";

fn main() {
    let entries = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../www/api/entries");
    println!("cargo::rerun-if-changed={}", entries.display());
    let mut tests = String::new();
    for file in markdown_files(&entries) {
        let text = fs::read_to_string(&file).expect("an entry");
        if let Some(code) = rust_sample(&text) {
            write_test(&mut tests, &name_of(&file), code);
        }
    }
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("OUT_DIR"));
    fs::write(out.join("samples.rs"), tests).expect("the generated tests");
}

fn markdown_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for item in fs::read_dir(folder).expect("www/api/entries") {
        let path = item.expect("an item of www/api/entries").path();
        if path.is_dir() {
            files.extend(markdown_files(&path));
        } else if path.extension().is_some_and(|ending| ending == "md") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The contents of the first block of Rust.
fn rust_sample(text: &str) -> Option<&str> {
    let (_, rest) = text.split_once("\n```rust")?;
    let (_, code) = rest.split_once('\n')?;
    code.split_once("\n```").map(|(code, _)| code)
}

/// `curve/timesAtCoordinate.md` is `curve_times_at_coordinate`.
fn name_of(file: &Path) -> String {
    let folder = file.parent().and_then(Path::file_name).expect("a folder");
    let stem = file.file_stem().expect("a name").to_string_lossy();
    let mut name = format!("{}_", folder.to_string_lossy());
    for letter in stem.chars() {
        if letter.is_ascii_uppercase() {
            name.push('_');
        }
        name.push(letter.to_ascii_lowercase());
    }
    name
}

fn write_test(tests: &mut String, name: &str, code: &str) {
    let expected: Vec<&str> = code
        .lines()
        .filter_map(|line| line.split_once(ARROW).map(|(_, text)| text))
        .collect();
    write!(
        tests,
        "#[test]\nfn {name}() {{\n    check({expected:?}.as_slice(), || {{\n{code}\nOk(())\n}});\n}}\n"
    )
    .expect("writing to a string");
}
