//! Checks of meshes, grids and their exports.

use crate::arguments::*;
use crate::check::*;
use crate::numbers::Numbers;
use crate::patch::as_surface;
use casteljau::glam::{DVec2, DVec3};
use casteljau::mesh::{TessellationOptions, View, Weld};
use casteljau::{Error, Grid, GridMethod, Mesh, Surface};
use casteljau_generator::Case;

/// Checks that buffer lengths match, indices are in range, positions are finite, and normals have the length 1 or 0.
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

pub(crate) fn grid_of(case: &Case) -> Grid {
    Grid {
        segments_u: count(case, "segments_u"),
        segments_v: count(case, "segments_v"),
    }
}

pub(crate) const REFUSALS: [&str; 5] = [
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
    // Positions in f32: 4 ulps, and the rounding of forward differences.
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

fn options(case: &Case) -> TessellationOptions {
    match optional_count(case, "cells") {
        Some(cells) => TessellationOptions::segments(Grid::from(cells)),
        None => TessellationOptions::tolerance(number(case, "tolerance")),
    }
}

/// Checks that a mesh by tolerance comes near every sample of the surface: its bounding box contains them.
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
    let mesh = call(case, || surface.tessellate(&options(case).weld(weld(case))))?;
    tessellated(case, &surface, mesh)
}

pub(crate) fn surface_tessellate_f64(case: &Case) -> Checked {
    let surface = surface(case);
    let mesh = call(case, || {
        surface.tessellate_f64(&options(case).weld(weld(case)))
    })?;
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
        surface.tessellate(&TessellationOptions::pixels(view).weld(weld(case))),
        &["pixels", "tolerance", "too many", "vertices"]
    );
    is_mesh(&mesh)
}

pub(crate) fn patch_tessellate(case: &Case) -> Checked {
    let patch = patch(case);
    let mesh = call(case, || patch.tessellate(&options(case).weld(weld(case))))?;
    tessellated(case, &as_surface(&patch), mesh)
}

pub(crate) fn patch_tessellate_f64(case: &Case) -> Checked {
    let patch = patch(case);
    let mesh = call(case, || {
        patch.tessellate_f64(&options(case).weld(weld(case)))
    })?;
    tessellated(case, &as_surface(&patch), mesh)
}
