//! Checks of meshes, grids and their exports.

use crate::arguments::*;
use crate::check::*;
use crate::numbers::Numbers;
use crate::patch::as_surface;
use crate::runner::Row;
use casteljau::glam::{DVec2, DVec3};
use casteljau::surface::{Fineness, View, Weld};
use casteljau::{Error, Grid, GridMethod, Mesh, Surface};
use casteljau_generator::{Case, Mode};

pub(crate) const ROWS: &[Row] = &[
    ("Mesh::vertex_count", counts),
    ("Mesh::triangle_count", counts),
    ("Mesh::to_f32", to_f32),
    ("Mesh::to_obj", to_obj),
    ("Mesh::to_stl", to_stl),
    ("Mesh::to_glb", to_glb),
    ("Grid::check", grid_check),
    ("Grid::quads", grid_quads),
];

/// Buffers that belong together, indices in range, finite positions, normals of length 1 or 0.
pub(crate) fn is_mesh<T: Copy + Into<f64>>(mesh: &Mesh<T>) -> Checked {
    let count = mesh.vertex_count();
    ensure!(
        mesh.positions.len() == 3 * count && mesh.normals.len() == 3 * count,
        "buffers of different lengths"
    );
    ensure!(
        mesh.indices.len() == 3 * mesh.triangle_count(),
        "indices that are no triangles"
    );
    ensure!(
        mesh.indices.iter().all(|i| i < count),
        "an index past the vertices"
    );
    let quads = mesh.quads.as_ref();
    ensure!(
        quads.is_none_or(|quads| quads.iter().all(|i| i < count)),
        "a quad past the vertices"
    );
    let finite = mesh.positions.iter().all(|&x| x.into().is_finite());
    ensure!(finite, "positions that are not finite");
    for normal in mesh.normals.chunks(3) {
        let length = DVec3::new(normal[0].into(), normal[1].into(), normal[2].into()).length();
        ensure!(
            length == 0.0 || (length - 1.0).abs() <= 1e-5,
            "a normal of length {length}"
        );
    }
    Ok(())
}

fn grid_of(case: &Case) -> Grid {
    Grid {
        segments_u: count(case, "segments_u"),
        segments_v: count(case, "segments_v"),
    }
}

const REFUSALS: [&str; 5] = [
    "segments",
    "segments_u",
    "segments_v",
    "tolerance",
    "vertices",
];

pub(crate) fn surface_grid(case: &Case) -> Checked {
    grid_mesh(case, &surface(case))
}

pub(crate) fn patch_grid(case: &Case) -> Checked {
    grid_mesh(case, &as_surface(&patch(case)))?;
    let (grid, quads) = (grid_of(case), flag(case, "quads"));
    let single = patch(case).grid(grid, quads);
    ensure!(
        single == as_surface(&patch(case)).grid(grid, quads),
        "a patch and a surface of it differ"
    );
    let mut mesh = Mesh::default();
    let filled = patch(case).grid_into(grid, quads, &mut mesh);
    ensure!(
        filled.is_err() || single == Ok(mesh.clone()),
        "grid_into makes another mesh"
    );
    let filled = patch(case).grid_by(GridMethod::ForwardDifference, grid, quads, &mut mesh);
    ensure!(
        filled.is_ok() == single.is_ok(),
        "the methods refuse different grids"
    );
    Ok(())
}

fn grid_mesh(case: &Case, surface: &Surface) -> Checked {
    let (grid, quads) = (grid_of(case), flag(case, "quads"));
    let mut mesh = Mesh::default();
    if case.function.ends_with("grid_by") {
        let method = if word(case, "method") == "forward" {
            GridMethod::ForwardDifference
        } else {
            GridMethod::Bernstein
        };
        answer!(
            case,
            surface.grid_by(method, grid, quads, &mut mesh),
            &REFUSALS
        );
    } else if case.function.ends_with("grid_into") {
        answer!(case, surface.grid_into(grid, quads, &mut mesh), &REFUSALS);
    } else {
        mesh = answer!(case, surface.grid(grid, quads), &REFUSALS);
    }
    is_mesh(&mesh)?;
    ensure!(
        mesh.vertex_count() == grid.vertex_count() * surface.patch_count(),
        "{} vertices",
        mesh.vertex_count()
    );
    ensure!(
        mesh.triangle_count() == grid.triangle_count() * surface.patch_count(),
        "{} triangles",
        mesh.triangle_count()
    );
    ensure!(
        mesh.quads.is_some() == quads,
        "quads: {}",
        mesh.quads.is_some()
    );
    // Positions in f32: 4 of its ulps, and what adding differences rounds.
    let slack = 1e-5 * case.size();
    for (k, patch) in surface.patches().enumerate() {
        let middle = grid.vertex(grid.segments_u / 2, grid.segments_v / 2);
        let (u, v) = grid.uv(grid.segments_u / 2, grid.segments_v / 2);
        let at = 3 * (k * grid.vertex_count() + middle);
        let p = DVec3::new(
            mesh.positions[at].into(),
            mesh.positions[at + 1].into(),
            mesh.positions[at + 2].into(),
        );
        let gap = distance(p, patch.eval(u, v));
        ensure!(gap <= slack, "a vertex is {gap:e} off the patch");
    }
    Ok(())
}

fn weld(case: &Case) -> Weld {
    match word(case, "weld") {
        "position" => Weld::Position,
        "normal" => Weld::Normal,
        _ => Weld::None,
    }
}

fn fineness(case: &Case) -> Fineness {
    match optional_count(case, "cells") {
        Some(cells) => Fineness::Segments(Grid::from(cells)),
        None => Fineness::Tolerance(number(case, "tolerance")),
    }
}

/// A mesh by tolerance comes near every sample of the surface: its box holds them.
fn tessellated<T: Copy + Into<f64> + Numbers>(
    case: &Case,
    surface: &Surface,
    mesh: Result<Mesh<T>, Error>,
) -> Checked {
    let mesh = answer!(case, mesh, &REFUSALS);
    is_mesh(&mesh)?;
    let vertices: Vec<DVec3> = mesh
        .positions
        .chunks(3)
        .map(|p| DVec3::new(p[0].into(), p[1].into(), p[2].into()))
        .collect();
    for triangle in mesh.indices.iter().collect::<Vec<_>>().chunks(3) {
        let [a, b, c] = [
            vertices[triangle[0]],
            vertices[triangle[1]],
            vertices[triangle[2]],
        ];
        ensure!(
            a != b && b != c && c != a,
            "a triangle with two corners at one place"
        );
    }
    let sampled: Vec<DVec3> = surface
        .patches()
        .map(|patch| patch.eval(0.5, 0.5))
        .collect();
    let reach = vertices
        .iter()
        .map(|p| p.abs().max_element())
        .fold(0.0, f64::max);
    ensure!(
        vertices.is_empty() || sampled.iter().all(|p| p.is_finite()),
        "samples that are not finite"
    );
    ensure!(
        reach <= case.size() * (1.0 + 1e-6),
        "a vertex outside of the control points' box"
    );
    Ok(())
}

pub(crate) fn surface_tessellate(case: &Case) -> Checked {
    let surface = surface(case);
    let mesh = call(case, || surface.tessellate(&fineness(case), weld(case)))?;
    tessellated(case, &surface, mesh)
}

pub(crate) fn surface_tessellate_f64(case: &Case) -> Checked {
    let surface = surface(case);
    let mesh = call(case, || surface.tessellate_f64(&fineness(case), weld(case)))?;
    tessellated(case, &surface, mesh)
}

pub(crate) fn surface_tessellate_view(case: &Case) -> Checked {
    let surface = surface(case);
    let view = View {
        pixels: number(case, "pixels"),
        view_projection: projection(case, "view"),
        viewport: DVec2::new(640.0, 480.0),
    };
    let mesh = answer!(
        case,
        surface.tessellate(&Fineness::Pixels(view), weld(case)),
        &["pixels", "tolerance", "too many", "vertices"]
    );
    is_mesh(&mesh)
}

pub(crate) fn patch_tessellate(case: &Case) -> Checked {
    let patch = patch(case);
    let mesh = call(case, || patch.tessellate(&fineness(case), weld(case)))?;
    tessellated(case, &as_surface(&patch), mesh)
}

pub(crate) fn patch_tessellate_f64(case: &Case) -> Checked {
    let patch = patch(case);
    let mesh = call(case, || patch.tessellate_f64(&fineness(case), weld(case)))?;
    tessellated(case, &as_surface(&patch), mesh)
}

/// Positions that f32 cannot hold are infinite in a grid, and exports refuse them.
fn positions(case: &Case) -> &'static [&'static str] {
    if case.mode == Mode::Extreme {
        &["positions"]
    } else {
        &[]
    }
}

/// A mesh to export.
fn mesh(case: &Case) -> Result<Mesh, Error> {
    surface(case).grid(Grid::from(count(case, "segments_u")), false)
}

fn counts(case: &Case) -> Checked {
    let mesh = answer!(case, mesh(case), &REFUSALS);
    ensure!(
        mesh.vertex_count() * 3 == mesh.positions.len(),
        "{} vertices",
        mesh.vertex_count()
    );
    ensure!(
        mesh.triangle_count() * 3 == mesh.indices.len(),
        "{} triangles",
        mesh.triangle_count()
    );
    Ok(())
}

fn to_f32(case: &Case) -> Checked {
    let surface = surface(case);
    let made = surface.tessellate_f64(
        &Fineness::Segments(Grid::from(count(case, "segments_u"))),
        Weld::None,
    );
    let Ok(precise) = made else {
        return Ok(());
    };
    let indices = precise.indices.clone();
    let rounded = value!(case, precise.to_f32());
    ensure!(rounded.indices == indices, "other triangles");
    is_mesh(&rounded)
}

fn to_obj(case: &Case) -> Checked {
    let made = surface(case).grid(Grid::from(count(case, "segments_u")), flag(case, "quads"));
    let Ok(mesh) = made else {
        return Ok(());
    };
    let text = answer!(case, mesh.to_obj(), positions(case));
    let rows = text.lines().filter(|line| line.starts_with("v ")).count();
    ensure!(rows == mesh.vertex_count(), "{rows} rows of vertices");
    ensure!(
        !text.contains("NaN") && !text.contains("inf"),
        "numbers that are not finite"
    );
    Ok(())
}

fn to_stl(case: &Case) -> Checked {
    let Ok(mesh) = mesh(case) else {
        return Ok(());
    };
    let bytes = answer!(case, mesh.to_stl(), positions(case));
    ensure!(
        bytes.len() == 84 + 50 * mesh.triangle_count(),
        "{} bytes",
        bytes.len()
    );
    Ok(())
}

fn to_glb(case: &Case) -> Checked {
    let Ok(mesh) = mesh(case) else {
        return Ok(());
    };
    let bytes = answer!(case, mesh.to_glb(), positions(case));
    ensure!(
        bytes.starts_with(b"glTF") && bytes.len().is_multiple_of(4),
        "no binary glTF file"
    );
    Ok(())
}

fn grid_check(case: &Case) -> Checked {
    let (grid, patches) = (grid_of(case), count(case, "count"));
    let checked = call(case, || grid.check(patches))?;
    let bytes = 44.0 * real(grid.vertex_count()) * patches as f64;
    match checked {
        Ok(()) => ensure!(
            bytes <= 2.0 * (1_u64 << 30) as f64,
            "{bytes:e} bytes are allowed"
        ),
        Err(error) => refused(
            &error,
            &["segments", "segments_u", "segments_v", "too many"],
        )?,
    }
    Ok(())
}

fn grid_quads(case: &Case) -> Checked {
    let grid = grid_of(case);
    if grid.check(1).is_err() {
        return Ok(());
    }
    let quads: Vec<[usize; 4]> = call(case, || grid.quads().collect())?;
    let triangles: Vec<[usize; 3]> = grid.triangles().collect();
    ensure!(
        quads.len() * 2 == triangles.len() && triangles.len() == grid.triangle_count(),
        "{} quads",
        quads.len()
    );
    ensure!(
        quads.iter().flatten().all(|&i| i < grid.vertex_count()),
        "an index past the vertices"
    );
    ensure!(
        quads[0] == grid.quad(0, 0) && grid.uv(0, 0) == (0.0, 0.0),
        "another first cell"
    );
    Ok(())
}
