//! Checks of grids and of exported mesh files.

use crate::arguments::*;
use crate::check::*;
use crate::mesh::{REFUSALS, grid_of, is_mesh};
use crate::runner::Row;
use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Error, Grid, Mesh};
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

/// Positions that f32 cannot hold are infinite in a grid, and exports reject them.
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
    let result = surface.tessellate_f64(
        &TessellationOptions::segments(Grid::from(count(case, "segments_u"))).weld(Weld::None),
    );
    let Ok(precise) = result else {
        return Ok(());
    };
    let indices = precise.indices.clone();
    let rounded = value!(case, precise.to_f32());
    ensure!(rounded.indices == indices, "other triangles");
    is_mesh(&rounded)
}

fn to_obj(case: &Case) -> Checked {
    let result = surface(case).grid(Grid::from(count(case, "segments_u")), flag(case, "quads"));
    let Ok(mesh) = result else {
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
