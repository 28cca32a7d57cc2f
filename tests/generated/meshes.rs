//! Checks of meshes, grids and their exports.

use crate::check::*;
use crate::curves::unit_or_zero;
use crate::geometry::*;
use crate::numbers::Numbers;
use crate::shared::*;
use casteljau::glam::{DMat4, DVec2, DVec3};
use casteljau::mesh::{TessellationOptions, View, Weld, Wire, WireframeOptions};
use casteljau::{Error, Grid, GridMethod, Mesh, Surface};

pub(crate) fn points<T: Copy + Into<f64>>(numbers: &[T]) -> Vec<DVec3> {
    let point = |p: &[T]| DVec3::from([p[0], p[1], p[2]].map(Into::into));
    numbers.chunks(3).map(point).collect()
}

/// Checks that buffer lengths match, indices are in range, positions are finite, and normals have the length 1 or 0.
pub(crate) fn is_mesh<T: Copy + Into<f64>>(mesh: &Mesh<T>) -> Checked {
    let count = mesh.vertex_count();
    let lengths = [mesh.positions.len(), mesh.normals.len()];
    same(lengths, [3 * count; 2], "the lengths of the buffers")?;
    same(mesh.indices.len(), 3 * mesh.triangle_count(), "the indices")?;
    ensure!(mesh.indices.iter().all(|i| i < count), "a large index");
    let mut quads = mesh.quads.iter().flat_map(|quads| quads.iter());
    ensure!(quads.all(|i| i < count), "a quad past the vertices");
    let finite = mesh.positions.iter().all(|&x| x.into().is_finite());
    ensure!(finite, "positions that are not finite");
    let mut normals = points(&mesh.normals).into_iter();
    normals.try_for_each(|normal| unit_or_zero(normal, 1e-5))
}

/// What errors of grids and tessellations may name.
pub(crate) const REFUSALS: &str = "segments|segments_u|segments_v|tolerance|vertices";

pub(crate) fn grid<S: Sheet>(sheet: S, u: usize, v: usize, quads: bool) -> Checked {
    let fill = |grid, mesh: &mut Mesh| sheet.grid(grid, quads).map(|made| *mesh = made);
    are_grids(&sheet, [u, v], quads, fill)
}

pub(crate) fn grid_into<S: Sheet>(sheet: S, u: usize, v: usize, quads: bool) -> Checked {
    let fill = |grid, mesh: &mut Mesh| sheet.grid_into(grid, quads, mesh);
    are_grids(&sheet, [u, v], quads, fill)
}

pub(crate) fn grid_by<S: Sheet>(
    sheet: S,
    method: GridMethod,
    u: usize,
    v: usize,
    quads: bool,
) -> Checked {
    let fill = |grid, mesh: &mut Mesh| sheet.grid_by(method, grid, quads, mesh);
    are_grids(&sheet, [u, v], quads, fill)
}

/// Checks the mesh of a function, and that the other functions agree with it.
fn are_grids<S: Sheet>(
    sheet: &S,
    [segments_u, segments_v]: [usize; 2],
    quads: bool,
    fill: impl Fn(Grid, &mut Mesh) -> Result<(), Error>,
) -> Checked {
    let grid = Grid {
        segments_u,
        segments_v,
    };
    grids_agree(sheet, grid, quads)?;
    let mesh = || {
        let mut mesh = Mesh::default();
        fill(grid, &mut mesh).map(|()| mesh)
    };
    let mesh = answer!(mesh(), REFUSALS);
    is_mesh(&mesh)?;
    let patches = sheet.patches();
    let counts = [grid.vertex_count(), grid.triangle_count()];
    let [vertices, triangles] = counts.map(|count| count * patches.len());
    same(mesh.vertex_count(), vertices, "vertices")?;
    same(mesh.triangle_count(), triangles, "triangles")?;
    same(mesh.quads.is_some(), quads, "quads")?;
    // Positions in f32: 4 ulps, and the rounding of forward differences.
    let (slack, vertices) = (1e-5 * size(), points(&mesh.positions));
    let (iu, iv) = (segments_u / 2, segments_v / 2);
    let (u, v) = grid.uv(iu, iv);
    for (patch, vertices) in patches.iter().zip(vertices.chunks(grid.vertex_count())) {
        let vertex = vertices[grid.vertex(iu, iv)];
        near(vertex, patch.eval(u, v), slack, "a vertex")?;
    }
    Ok(())
}

/// Checks that a patch and a surface of it have the same mesh, and that all functions refuse the same grids.
fn grids_agree<S: Sheet>(sheet: &S, grid: Grid, quads: bool) -> Checked {
    let (single, mut mesh) = (sheet.grid(grid, quads), Mesh::default());
    same(&single, &sheet.surface().grid(grid, quads), "the surface")?;
    for method in [GridMethod::Bernstein, GridMethod::ForwardDifference] {
        let filled = sheet.grid_by(method, grid, quads, &mut mesh);
        same(filled.is_ok(), single.is_ok(), "whether a method refuses")?;
    }
    let filled = sheet.grid_into(grid, quads, &mut mesh);
    same(&filled.map(|()| mesh), &single, "the mesh of grid_into")
}

pub(crate) fn options(tolerance: f64, cells: Option<usize>, weld: Weld) -> TessellationOptions {
    let by_tolerance = || TessellationOptions::tolerance(tolerance);
    let options = cells.map(|cells| TessellationOptions::segments(Grid::from(cells)));
    options.unwrap_or_else(by_tolerance).weld(weld)
}

pub(crate) fn tessellate<S: Sheet>(
    sheet: S,
    tolerance: f64,
    cells: Option<usize>,
    weld: Weld,
) -> Checked {
    is_tessellation(REFUSALS, || {
        sheet.tessellate(&options(tolerance, cells, weld))
    })
}

pub(crate) fn tessellate_f64<S: Sheet>(
    sheet: S,
    tolerance: f64,
    cells: Option<usize>,
    weld: Weld,
) -> Checked {
    is_tessellation(REFUSALS, || {
        sheet.tessellate_f64(&options(tolerance, cells, weld))
    })
}

/// Checks that a mesh is within the box of the control points, and that no triangle has two corners at one place.
pub(crate) fn is_tessellation<T: Copy + Into<f64> + Numbers>(
    refusals: &str,
    make: impl Fn() -> Result<Mesh<T>, Error>,
) -> Checked {
    let mesh = answer!(make(), refusals);
    is_mesh(&mesh)?;
    let vertices = points(&mesh.positions);
    let corners: Vec<DVec3> = mesh.indices.iter().map(|i| vertices[i]).collect();
    let mut triangles = corners.chunks(3).map(|c| (c[0], c[1], c[2]));
    let degenerate = triangles.find(|(a, b, c)| a == b || b == c || c == a);
    ensure!(degenerate.is_none(), "equal corners: {degenerate:?}");
    at_most(largest(&vertices), size() * (1.0 + 1e-6), "the box")
}

pub(crate) fn in_view(view_projection: DMat4, pixels: f64, weld: Weld) -> TessellationOptions {
    let view = View {
        pixels,
        view_projection,
        viewport: DVec2::new(640.0, 480.0),
    };
    TessellationOptions::pixels(view).weld(weld)
}

pub(crate) fn tessellate_view(
    surface: Surface,
    view_projection: DMat4,
    pixels: f64,
    weld: Weld,
) -> Checked {
    let options = in_view(view_projection, pixels, weld);
    let allowed = "pixels|tolerance|too many|vertices";
    is_mesh(&answer!(surface.tessellate(&options), allowed))
}

pub(crate) fn wireframe(
    surface: Surface,
    lines: usize,
    wire: String,
    width: f64,
    sides: usize,
) -> Checked {
    let options = wires(lines, &wire, width, sides);
    is_mesh(&answer!(surface.wireframe(&options), WIRE_REFUSALS))
}

/// What errors of wireframes may name.
pub(crate) const WIRE_REFUSALS: &str = "lines|sides|radius|width|too many|vertices";

pub(crate) fn wires(lines: usize, wire: &str, width: f64, sides: usize) -> WireframeOptions {
    let wire = match wire {
        "tube" => Wire::Tube {
            radius: width,
            sides,
        },
        _ => Wire::Ribbon { width },
    };
    WireframeOptions::new().lines(lines).wire(wire)
}

/// What errors of exports may name: positions that f32 cannot hold are infinite in a grid.
fn positions() -> &'static str {
    if is_extreme() { "positions" } else { "" }
}

fn grid_mesh(surface: &Surface, cells: usize) -> Result<Mesh, Error> {
    surface.grid(Grid::from(cells), false)
}

pub(crate) fn counts(surface: Surface, cells: usize) -> Checked {
    let mesh = answer!(grid_mesh(&surface, cells), REFUSALS);
    same(mesh.vertex_count() * 3, mesh.positions.len(), "vertices")?;
    same(mesh.triangle_count() * 3, mesh.indices.len(), "triangles")
}

pub(crate) fn to_f32(surface: Surface, cells: usize) -> Checked {
    let options = options(0.0, Some(cells), Weld::None);
    let Ok(precise) = surface.tessellate_f64(&options) else {
        return Ok(());
    };
    let indices = precise.indices.clone();
    let rounded = value!(precise.to_f32());
    same(&rounded.indices, &indices, "the triangles")?;
    is_mesh(&rounded)
}

pub(crate) fn to_obj(surface: Surface, cells: usize, quads: bool) -> Checked {
    let Ok(mesh) = surface.grid(Grid::from(cells), quads) else {
        return Ok(());
    };
    let text = answer!(mesh.to_obj(), positions());
    let rows = text.lines().filter(|line| line.starts_with("v ")).count();
    same(rows, mesh.vertex_count(), "the rows of vertices")?;
    let finite = !text.contains("NaN") && !text.contains("inf");
    holds!(finite, "numbers that are not finite")
}

pub(crate) fn to_stl(surface: Surface, cells: usize) -> Checked {
    let Ok(mesh) = grid_mesh(&surface, cells) else {
        return Ok(());
    };
    let bytes = answer!(mesh.to_stl(), positions());
    same(bytes.len(), 84 + 50 * mesh.triangle_count(), "the bytes")
}

pub(crate) fn to_glb(surface: Surface, cells: usize) -> Checked {
    let Ok(mesh) = grid_mesh(&surface, cells) else {
        return Ok(());
    };
    let bytes = answer!(mesh.to_glb(), positions());
    let is_glb = bytes.starts_with(b"glTF") && bytes.len().is_multiple_of(4);
    holds!(is_glb, "no binary glTF file")
}

pub(crate) fn grid_check(segments_u: usize, segments_v: usize, patches: usize) -> Checked {
    let grid = Grid {
        segments_u,
        segments_v,
    };
    if let Err(error) = call(|| grid.check(patches))? {
        return refused(&error, "segments|segments_u|segments_v|too many");
    }
    let bytes = 44.0 * real(grid.vertex_count()) * patches as f64;
    at_most(bytes, 2.0 * (1_u64 << 30) as f64, "the number of bytes")
}

pub(crate) fn grid_quads(segments_u: usize, segments_v: usize) -> Checked {
    let grid = Grid {
        segments_u,
        segments_v,
    };
    if grid.check(1).is_err() {
        return Ok(());
    }
    let quads: Vec<[usize; 4]> = call(|| grid.quads().collect())?;
    let triangles = grid.triangles().count();
    same(2 * quads.len(), triangles, "quads")?;
    same(triangles, grid.triangle_count(), "triangles")?;
    let inside = quads.iter().flatten().all(|&i| i < grid.vertex_count());
    ensure!(inside, "an index past the vertices");
    same(quads[0], grid.quad(0, 0), "the first cell")?;
    same(grid.uv(0, 0), (0.0, 0.0), "the first vertex")
}
