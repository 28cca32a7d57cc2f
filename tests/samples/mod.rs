//! Runs the Rust samples of the site: each must print the contents of www/samples/<name>.txt, as its JavaScript version
//! does. A new sample needs its two lines below; the last test fails if they are missing.

/// A macro, so that a line of output in the samples is a statement, like `println!`, which the site shows.
macro_rules! writeln {
    ($out:expr) => { $out.push('\n') };
    ($out:expr, $($line:tt)*) => { $out.push_str(&(format!($($line)*) + "\n")) };
}

#[path = "../../www/samples/arc-length.rs"]
mod arc_length;
#[path = "../../www/samples/basis.rs"]
mod basis;
#[path = "../../www/samples/bernstein.rs"]
mod bernstein;
#[path = "../../www/samples/boolean-operations.rs"]
mod boolean_operations;
#[path = "../../www/samples/bounding-boxes.rs"]
mod bounding_boxes;
#[path = "../../www/samples/bytes.rs"]
mod bytes;
#[path = "../../www/samples/casteljau.rs"]
mod casteljau;
#[path = "../../www/samples/circle-error.rs"]
mod circle_error;
#[path = "../../www/samples/circles.rs"]
mod circles;
#[path = "../../www/samples/degrees.rs"]
mod degrees;
#[path = "../../www/samples/derivatives.rs"]
mod derivatives;
#[path = "../../www/samples/dicing.rs"]
mod dicing;
#[path = "../../www/samples/differences.rs"]
mod differences;
#[path = "../../www/samples/eval.rs"]
mod eval;
#[path = "../../www/samples/files.rs"]
mod files;
#[path = "../../www/samples/grid.rs"]
mod grid;
#[path = "../../www/samples/home.rs"]
mod home;
#[path = "../../www/samples/intersections.rs"]
mod intersections;
#[path = "../../www/samples/isocurves.rs"]
mod isocurves;
#[path = "../../www/samples/joints.rs"]
mod joints;
#[path = "../../www/samples/nearest-point.rs"]
mod nearest_point;
#[path = "../../www/samples/no-cracks.rs"]
mod no_cracks;
#[path = "../../www/samples/offsets.rs"]
mod offsets;
#[path = "../../www/samples/patch.rs"]
mod patch;
#[path = "../../www/samples/patch-joint.rs"]
mod patch_joint;
#[path = "../../www/samples/patch-normals.rs"]
mod patch_normals;
#[path = "../../www/samples/polyline.rs"]
mod polyline;
#[path = "../../www/samples/properties.rs"]
mod properties;
#[path = "../../www/samples/quadratic.rs"]
mod quadratic;
#[path = "../../www/samples/rays.rs"]
mod rays;
#[path = "../../www/samples/recursion.rs"]
mod recursion;
#[path = "../../www/samples/rounding.rs"]
mod rounding;
#[path = "../../www/samples/rows-then-curve.rs"]
mod rows_then_curve;
#[path = "../../www/samples/splines.rs"]
mod splines;
#[path = "../../www/samples/split.rs"]
mod split;
#[path = "../../www/samples/split-patch.rs"]
mod split_patch;
#[path = "../../www/samples/teapot.rs"]
mod teapot;
#[path = "../../www/samples/text-rays.rs"]
mod text_rays;
#[path = "../../www/samples/tolerance.rs"]
mod tolerance;
#[path = "../../www/samples/uses.rs"]
mod uses;
#[path = "../../www/samples/wires.rs"]
mod wires;

type Sample = fn(&mut String);

const SAMPLES: &[(&str, Sample)] = &[
    ("arc-length", arc_length::sample),
    ("basis", basis::sample),
    ("bernstein", bernstein::sample),
    ("boolean-operations", boolean_operations::sample),
    ("bounding-boxes", bounding_boxes::sample),
    ("bytes", bytes::sample),
    ("casteljau", casteljau::sample),
    ("circle-error", circle_error::sample),
    ("circles", circles::sample),
    ("degrees", degrees::sample),
    ("derivatives", derivatives::sample),
    ("differences", differences::sample),
    ("dicing", dicing::sample),
    ("eval", eval::sample),
    ("files", files::sample),
    ("grid", grid::sample),
    ("home", home::sample),
    ("intersections", intersections::sample),
    ("isocurves", isocurves::sample),
    ("joints", joints::sample),
    ("nearest-point", nearest_point::sample),
    ("no-cracks", no_cracks::sample),
    ("offsets", offsets::sample),
    ("patch", patch::sample),
    ("patch-joint", patch_joint::sample),
    ("patch-normals", patch_normals::sample),
    ("polyline", polyline::sample),
    ("properties", properties::sample),
    ("quadratic", quadratic::sample),
    ("rays", rays::sample),
    ("recursion", recursion::sample),
    ("rounding", rounding::sample),
    ("rows-then-curve", rows_then_curve::sample),
    ("splines", splines::sample),
    ("split", split::sample),
    ("split-patch", split_patch::sample),
    ("teapot", teapot::sample),
    ("text-rays", text_rays::sample),
    ("tolerance", tolerance::sample),
    ("uses", uses::sample),
    ("wires", wires::sample),
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
