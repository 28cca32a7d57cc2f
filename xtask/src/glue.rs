//! Generates js/glue from the compiled wasm: the bindings, the optimised modules, and their bytes as text.

use crate::liveness::Linked;
use crate::{encode, shell, strip_panics};
use anyhow::{Context, Result, bail, ensure};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Child;
use walrus::ir::Value;
use walrus::{ConstExpr, DataKind};
use wasm_bindgen_cli_support::Bindgen;

/// Options of wasm-opt: optimise for size, twice (more rounds have no effect); the compiler has already inlined hot
/// code.
///
/// Inlining functions with a single caller reduces the size but increases it after gzip; so do local common
/// subexpression elimination and reordering functions. `-lmu` folds constants into addresses, because there is no data
/// below [`LOW_MEMORY`].
const OPTIMISE: [&str; 6] = [
    "-lmu",
    "-ocimfs=10",
    "-sp=local-cse",
    "-Oz",
    "-Oz",
    "--reorder-locals",
];

/// The address below which `-lmu` assumes that there is no data.
const LOW_MEMORY: i32 = 1024;

/// The wasm features that rustc uses, given explicitly because the optimiser enables fewer by default.
const FEATURES: [&str; 7] = [
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];

/// A separate module with some of the functions, so that a program that uses only curves does not include the surfaces.
pub(crate) struct Part {
    pub(crate) name: &'static str,
    /// Its functions, besides [`COMMON`]; see [`selects`].
    own: &'static [&'static [&'static str]],
}

pub(crate) const PARTS: [Part; 8] = [
    Part {
        name: "curves",
        own: &[&[
            "curve_",
            "spline_",
            "path_",
            "basis_",
            "bernstein_",
            "cubic_",
        ]],
    },
    Part {
        name: "surfaces",
        own: &[SURFACES],
    },
    Part {
        name: "regions",
        own: &[&["region_"]],
    },
    // For casteljau/core.
    Part {
        name: "core",
        own: &[CORE_CURVES, CURVE_MEASURES, CORE_SPLINES, CORE_PATHS],
    },
    // For casteljau/surfaces, whose curves have the methods of casteljau/core.
    Part {
        name: "core-surfaces",
        own: &[SURFACES, CORE_CURVES, &["basis_matrix"]],
    },
    // For casteljau/nurbs, whose splines have the methods of casteljau/core.
    Part {
        name: "nurbs",
        own: &[NURBS, CORE_CURVES, CURVE_MEASURES, CORE_SPLINES],
    },
    // For the surfaces of casteljau/nurbs.
    Part {
        name: "nurbs-surfaces",
        own: &[NURBS_SURFACES, MESHES],
    },
    // The functions that js/applet calls, for bezier-app.js, which does not expose curves.
    Part {
        name: "applet",
        own: &[&[
            "cubic_eval",
            "curve_hull",
            "curve_de_casteljau",
            "curve_split",
            "spline_append",
            "spline_continuity",
            "spline_move_point",
            "spline_set_joint",
        ]],
    },
];

const SURFACES: &[&str] = &["surface_", "patch_", "mesh_", "grid_", "points_joined"];

/// Of [`SURFACES`], what all kinds of surfaces call.
const MESHES: &[&str] = &["mesh_", "points_joined"];

/// Left out of the complete module, which has what `casteljau` calls; so are [`NURBS_SURFACES`].
const NURBS: &[&str] = &["nurbs_", "rational_"];

const NURBS_SURFACES: &[&str] = &["nurbssurface_", "rationalpatch_", "rationalsurface_"];

/// The functions that js/geometry/curve/core-curve.ts calls, besides measures.
const CORE_CURVES: &[&str] = &[
    "bernstein_weights",
    "cubic_eval",
    "curve_bounds",
    "curve_cubics",
    "curve_curvature",
    "curve_de_casteljau",
    "curve_derivative",
    "curve_derivative_at",
    "curve_elevate",
    "curve_eval",
    "curve_eval_at",
    "curve_flatten",
    "curve_hull",
    "curve_normal",
    "curve_sample",
    "curve_split",
    "curve_subdivide",
    "curve_subsegment",
    "curve_tangent",
    "path_check_tolerance",
];

/// What `Curve` of casteljau/surfaces does without.
const CURVE_MEASURES: &[&str] = &[
    "cubic_length",
    "cubic_nearest",
    "curve_area",
    "curve_equidistant_times",
    "curve_length",
    "curve_nearest",
    "curve_time_at_length",
];

/// The functions that js/geometry/spline/core-spline.ts calls.
const CORE_SPLINES: &[&str] = &[
    "spline_append",
    "spline_area",
    "spline_bounds",
    "spline_continuity",
    "spline_equidistant_times",
    "spline_eval_at",
    "spline_flatten",
    "spline_from_curves",
    "spline_insert",
    "spline_length",
    "spline_move_point",
    "spline_remove",
    "spline_reverse",
    "spline_sample",
    "spline_set_joint",
    "spline_time_at_length",
];

/// The functions that js/geometry/path/core-path.ts calls, besides those of splines.
const CORE_PATHS: &[&str] = &[
    "curve_crossings",
    "path_area",
    "path_bounds",
    "path_equidistant_times",
    "path_flatten",
    "path_length",
    "path_nearest",
    "path_segment_ends",
    "path_time_at_length",
    "path_winding_number",
];

/// The exports of every module.
const COMMON: &[&str] = &["arena_", "points_transform", "memory", "__"];

/// Whether a list contains the name of an export, or a prefix of it; prefixes end with an underscore.
fn selects(list: &[&str], export: &str) -> bool {
    let export = without_hash(export);
    list.iter().any(|name| match name.ends_with('_') {
        true => export.starts_with(name),
        false => export == *name,
    })
}

/// The name of an export without the hash that it has before wasm-bindgen runs: `grid_part_0123456789abcdef`.
fn without_hash(export: &str) -> &str {
    match export.rsplit_once('_') {
        Some((name, hash)) if hash.len() == 16 && hash.chars().all(|c| c.is_ascii_hexdigit()) => {
            name
        }
        _ => export,
    }
}

fn in_complete_module(export: &str) -> bool {
    !selects(NURBS, export) && !selects(NURBS_SURFACES, export)
}

impl Part {
    fn contains(&self, export: &str) -> bool {
        self.own.iter().any(|list| selects(list, export))
    }
}

/// The folder of the generated JavaScript sources.
pub(crate) fn folder() -> PathBuf {
    shell::root().join("js/glue")
}

/// Generates all files of js/glue from the wasm that cargo built.
pub(crate) fn generate(compiled: &Path) -> Result<()> {
    let linked = Linked::read(&fs::read(compiled)?)?;
    for (export, _) in linked.exports() {
        let known = selects(COMMON, export) || PARTS.iter().any(|part| part.contains(export));
        ensure!(
            known,
            "{export}: no part in xtask/src/glue.rs has this function"
        );
    }
    clear()?;
    write_needs(compiled, &linked)?;
    let whole = bound(compiled, &linked, &folder(), in_complete_module)?;
    let glue = without_side_effects(&fs::read_to_string(folder().join("casteljau.js"))?)?;
    fs::write(folder().join("casteljau.js"), &glue)?;
    let mut optimisers = vec![optimiser(&whole, "casteljau")?];
    for part in PARTS {
        let mine = |export: &str| part.contains(export) || selects(COMMON, export);
        let cut = bound(compiled, &linked, &scratch(part.name), mine)?;
        optimisers.push(optimiser(&cut, part.name)?);
        // Each part gets its own copy of the glue, because the glue stores its memory in module variables.
        fs::write(folder().join(format!("{}.js", part.name)), &glue)?;
        write_types(part.name)?;
    }
    for mut optimiser in optimisers {
        ensure!(optimiser.wait()?.success(), "wasm-opt failed");
    }
    fs::remove_file(whole)?;
    for part in PARTS {
        let wasm = fs::read(folder().join(format!("{}.wasm", part.name)))?;
        let bytes = folder().join(format!("{}-bytes.js", part.name));
        fs::write(bytes, encode::module(&wasm))?;
    }
    Ok(fs::write(folder().join("functions.d.ts"), FUNCTIONS_TYPES)?)
}

/// Writes what each export of the complete module needs, for `custom/cut.js`.
fn write_needs(compiled: &Path, linked: &Linked) -> Result<()> {
    let panicking = strip_panics::panicking(&walrus::Module::from_file(compiled)?);
    let needs = linked.needs(&panicking, |export| {
        let is_included = !export.starts_with("__") && in_complete_module(export);
        is_included.then(|| without_hash(export).to_owned())
    })?;
    Ok(fs::write(
        folder().join("needs.json"),
        serde_json::to_string(&needs)?,
    )?)
}

/// Removes what an earlier build has left in js/glue.
fn clear() -> Result<()> {
    if folder().exists() {
        fs::remove_dir_all(folder())?;
    }
    Ok(fs::create_dir_all(folder())?)
}

/// Generates js/glue with one module, which has all functions and is as the compiler made it.
pub(crate) fn generate_for_development(compiled: &Path) -> Result<()> {
    clear()?;
    bindings(compiled, &folder())?;
    let glue = without_side_effects(&fs::read_to_string(folder().join("casteljau.js"))?)?;
    fs::write(folder().join("casteljau.js"), &glue)?;
    let whole = folder().join("casteljau.wasm");
    fs::rename(folder().join("casteljau_bg.wasm"), &whole)?;
    let bytes = encode::module(&fs::read(whole)?);
    fs::write(folder().join("casteljau-bytes.js"), bytes)?;
    for part in PARTS {
        write_types(part.name)?;
    }
    Ok(fs::write(folder().join("functions.d.ts"), FUNCTIONS_TYPES)?)
}

fn write_types(part: &str) -> Result<()> {
    fs::write(folder().join(format!("{part}.d.ts")), PART_TYPES)?;
    Ok(fs::write(
        folder().join(format!("{part}-bytes.d.ts")),
        BYTES_TYPES,
    )?)
}

/// The folder in which the bindings of a part are generated.
fn scratch(part: &str) -> PathBuf {
    shell::target_dir().join("wasm").join(part)
}

/// Generates a module with some of the exports and the code that they need, with bindings, in a folder.
fn bound(
    compiled: &Path,
    linked: &Linked,
    folder: &Path,
    wanted: impl Fn(&str) -> bool,
) -> Result<PathBuf> {
    fs::create_dir_all(folder)?;
    let bound = folder.join("casteljau_bg.wasm");
    let reduced = folder.join("reduced.wasm");
    strip_panics::reduced(compiled, linked, &wanted)?.emit_wasm_file(&reduced)?;
    bindings(&reduced, folder)?;
    fs::remove_file(reduced)?;
    let mut module = strip_panics::without(&bound, |export| !wanted(export))?;
    check_low_memory(&module)?;
    module.emit_wasm_file(&bound)?;
    Ok(bound)
}

/// Returns an error for data at addresses that the optimiser assumes to be unused.
fn check_low_memory(module: &walrus::Module) -> Result<()> {
    for data in module.data.iter() {
        if let DataKind::Active { offset, .. } = &data.kind {
            let ConstExpr::Value(Value::I32(address)) = *offset else {
                bail!("a data segment at an address that is not a constant");
            };
            ensure!(
                address >= LOW_MEMORY,
                "data at the address {address}, below {LOW_MEMORY}"
            );
        }
    }
    Ok(())
}

/// Runs wasm-bindgen. The default module path is omitted: `import.meta` would break IIFE bundles and `require()`.
fn bindings(reduced: &Path, folder: &Path) -> Result<()> {
    Bindgen::new()
        .web(true)?
        .typescript(true)
        .omit_default_module_path(true)
        .remove_producers_section(true)
        .input_path(reduced)
        .out_name("casteljau")
        .generate(folder)
        .context("generating the bindings")
}

/// Makes the import of the glue free of side effects. The glue constructs its decoder of error messages on import and
/// warms it up, which bundlers must keep. The warm-up is removed, and the constructor call is marked as pure.
fn without_side_effects(glue: &str) -> Result<String> {
    const CONSTRUCTED: &str = "let cachedTextDecoder = new ";
    const WARMED: &str = "\ncachedTextDecoder.decode();\n";
    ensure!(
        glue.contains(CONSTRUCTED) && glue.contains(WARMED),
        "wasm-bindgen's glue has another form than expected"
    );
    Ok(glue
        .replace(CONSTRUCTED, "let cachedTextDecoder = /* @__PURE__ */ new ")
        .replace(WARMED, "\n"))
}

/// Starts the optimiser; all modules are optimised in parallel.
fn optimiser(from: &Path, name: &str) -> Result<Child> {
    let mut wasm_opt = shell::node(&["node_modules/binaryen/bin/wasm-opt"]);
    wasm_opt.args(OPTIMISE).args(FEATURES).args([
        "--strip-debug",
        "--strip-producers",
        "--strip-target-features",
    ]);
    let to = folder().join(format!("{name}.wasm"));
    wasm_opt
        .arg(from)
        .arg("-o")
        .arg(to)
        .spawn()
        .context("starting wasm-opt")
}

/// Types of the raw exports. The wrappers of wasm-bindgen change nothing but the sign of an address.
const FUNCTIONS_TYPES: &str = "\
import type * as glue from \"./casteljau.js\";
export type Functions = Omit<typeof glue, \"default\" | \"initSync\">;
";

const PART_TYPES: &str = "\
export { initSync } from \"./casteljau.js\";
";

const BYTES_TYPES: &str = "\
export declare const length: number;
export declare const frequent: number[];
export declare const alphabet: string;
export declare const text: string;
";
