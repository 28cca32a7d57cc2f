//! Runs the Rust samples of the site: each must print the contents of www/samples/<name>.txt, as its JavaScript version
//! does. A new sample needs its row below; the last test fails if it is missing.

/// A macro, so that a line of output in the samples is a statement, like `println!`, which the site shows.
macro_rules! writeln {
    ($out:expr) => { $out.push('\n') };
    ($out:expr, $($line:tt)*) => { $out.push_str(&(format!($($line)*) + "\n")) };
}

type Sample = fn(&mut String);

/// Declares the files of the samples as modules, and the table of their functions.
macro_rules! samples {
    ($($file:literal $name:ident,)*) => {
        $(#[path = $file] mod $name;)*

        const SAMPLES: &[(&str, Sample)] = &[$(($file, $name::sample),)*];
    };
}

samples! {
    "../../www/samples/arc-length.rs" arc_length, "../../www/samples/basis.rs" basis,
    "../../www/samples/bernstein.rs" bernstein, "../../www/samples/boolean-operations.rs" boolean_operations,
    "../../www/samples/bounding-boxes.rs" bounding_boxes, "../../www/samples/bytes.rs" bytes,
    "../../www/samples/casteljau.rs" casteljau, "../../www/samples/circle-error.rs" circle_error,
    "../../www/samples/circles.rs" circles, "../../www/samples/degrees.rs" degrees,
    "../../www/samples/derivatives.rs" derivatives, "../../www/samples/dicing.rs" dicing,
    "../../www/samples/differences.rs" differences, "../../www/samples/eval.rs" eval,
    "../../www/samples/files.rs" files, "../../www/samples/fitting.rs" fitting, "../../www/samples/grid.rs" grid,
    "../../www/samples/home.rs" home,
    "../../www/samples/intersections.rs" intersections, "../../www/samples/isocurves.rs" isocurves,
    "../../www/samples/joints.rs" joints, "../../www/samples/nearest-point.rs" nearest_point,
    "../../www/samples/no-cracks.rs" no_cracks, "../../www/samples/offsets.rs" offsets,
    "../../www/samples/patch.rs" patch, "../../www/samples/patch-joint.rs" patch_joint,
    "../../www/samples/patch-normals.rs" patch_normals, "../../www/samples/polyline.rs" polyline,
    "../../www/samples/properties.rs" properties, "../../www/samples/quadratic.rs" quadratic,
    "../../www/samples/rational.rs" rational, "../../www/samples/rays.rs" rays, "../../www/samples/recursion.rs" recursion,
    "../../www/samples/revolution.rs" revolution, "../../www/samples/rounding.rs" rounding,
    "../../www/samples/rows-then-curve.rs" rows_then_curve,
    "../../www/samples/shapes.rs" shapes,
    "../../www/samples/sphere.rs" sphere, "../../www/samples/splines.rs" splines, "../../www/samples/split.rs" split,
    "../../www/samples/split-patch.rs" split_patch, "../../www/samples/teapot.rs" teapot,
    "../../www/samples/text-rays.rs" text_rays, "../../www/samples/tolerance.rs" tolerance,
    "../../www/samples/uses.rs" uses, "../../www/samples/varying-width.rs" varying_width, "../../www/samples/wires.rs" wires,
}

/// The name of a file without its folder and ending.
fn name_of(file: &str) -> &str {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.trim_end_matches(".rs")
}

fn folder() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("www/samples")
}

#[test]
fn samples_print_what_the_site_shows() {
    for (file, sample) in SAMPLES {
        let path = folder().join(name_of(file)).with_extension("txt");
        let expected = std::fs::read_to_string(path).expect(file);
        let mut out = String::new();
        sample(&mut out);
        assert_eq!(out, expected, "{file}");
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
    let mut run: Vec<&str> = SAMPLES.iter().map(|(file, _)| name_of(file)).collect();
    run.sort_unstable();
    assert_eq!(names, run);
}
