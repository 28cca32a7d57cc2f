//! The Rust samples of the site, run: each must print what www/samples/<name>.txt holds, as its JavaScript twin does.
//! A new sample needs its two lines below; the last test tells if they were forgotten.
#![cfg(not(target_family = "wasm"))]

/// In the samples a line that is written is a statement: readers see `println!`.
macro_rules! writeln {
    ($out:expr) => { $out.push('\n') };
    ($out:expr, $($line:tt)*) => { $out.push_str(&(format!($($line)*) + "\n")) };
}

#[path = "../../www/samples/basis.rs"]
mod basis;
#[path = "../../www/samples/bernstein.rs"]
mod bernstein;
#[path = "../../www/samples/casteljau.rs"]
mod casteljau;
#[path = "../../www/samples/degrees.rs"]
mod degrees;
#[path = "../../www/samples/eval.rs"]
mod eval;
#[path = "../../www/samples/home.rs"]
mod home;
#[path = "../../www/samples/joints.rs"]
mod joints;
#[path = "../../www/samples/polyline.rs"]
mod polyline;
#[path = "../../www/samples/properties.rs"]
mod properties;
#[path = "../../www/samples/quadratic.rs"]
mod quadratic;
#[path = "../../www/samples/recursion.rs"]
mod recursion;
#[path = "../../www/samples/splines.rs"]
mod splines;
#[path = "../../www/samples/split.rs"]
mod split;
#[path = "../../www/samples/uses.rs"]
mod uses;

type Sample = fn(&mut String);

const SAMPLES: &[(&str, Sample)] = &[
    ("basis", basis::sample),
    ("bernstein", bernstein::sample),
    ("casteljau", casteljau::sample),
    ("degrees", degrees::sample),
    ("eval", eval::sample),
    ("home", home::sample),
    ("joints", joints::sample),
    ("polyline", polyline::sample),
    ("properties", properties::sample),
    ("quadratic", quadratic::sample),
    ("recursion", recursion::sample),
    ("splines", splines::sample),
    ("split", split::sample),
    ("uses", uses::sample),
];

fn folder() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("www/samples")
}

#[test]
fn samples_print_what_the_site_shows() {
    for (name, sample) in SAMPLES {
        let expected = std::fs::read_to_string(folder().join(format!("{name}.txt")))
            .unwrap_or_else(|error| panic!("{name}.txt: {error}"));
        let mut out = String::new();
        sample(&mut out);
        assert_eq!(out, expected, "www/samples/{name}.rs");
    }
}

#[test]
fn every_sample_is_run() {
    let files = std::fs::read_dir(folder()).expect("www/samples");
    let paths = files.map(|file| file.expect("a file").path());
    let mut names: Vec<String> = paths
        .filter(|path| path.extension().is_some_and(|ending| ending == "rs"))
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into())
        .collect();
    names.sort();
    let mut run: Vec<&str> = SAMPLES.iter().map(|(name, _)| *name).collect();
    run.sort_unstable();
    assert_eq!(names, run);
}
