//! Checks of surfaces of rational patches.

use crate::arguments::rational_surface_of;
use crate::check::*;
use crate::geometry::*;
use crate::lines::are_images;
use crate::meshes::{self, REFUSALS, WIRE_REFUSALS, in_view, is_mesh, is_tessellation, wires};
use crate::nurbs_surfaces::slack_of;
use crate::recorder::Recorder;
use crate::surfaces::has_all_sides;
use casteljau::glam::{DAffine3, DMat4, DVec3};
use casteljau::mesh::Weld;
use casteljau::surface::SurfacePoint;
use casteljau::{Error, Grid, Mesh, NurbsCurve, RationalPatch, RationalSurface, Surface};
use casteljau_generator::{NurbsSurfaceData, SurfaceData, changed};
use std::f64::consts::TAU;

/// What errors of tessellations may name.
const TESSELLATION: &str = "tolerance|pixels|too many|vertices|segments|\
    largest weight of a patch divided by its smallest one";

/// The slack for the points of a surface; infinite for weights whose ratio is large.
fn slack(surface: &RationalSurface) -> f64 {
    max(surface
        .patches()
        .map(|patch| slack_of(patch.weights(), [patch.degree_u(), patch.degree_v()])))
}

pub(crate) fn new(data: NurbsSurfaceData) -> Checked {
    let [m, n] = data.degrees;
    let indices: Vec<u32> = (0_u32..).take(data.points.len()).collect();
    let (points, weights) = (data.points.clone(), data.weights.clone());
    let make = || RationalSurface::new(points, indices, weights, m, n);
    let surface = answer!(make());
    same(surface.vertices(), &data.points[..], "the vertices")?;
    same(surface.weights(), &data.weights[..], "the weights")?;
    let patch = RationalPatch::new(&data.points, &data.weights, m, n)?;
    same(RationalSurface::from(&patch), surface, "that of the patch")
}

pub(crate) fn from(surface: Surface) -> Checked {
    let same_surface = call(|| RationalSurface::from(&surface))?;
    let is_one = same_surface.weights().iter().all(|&w| w == 1.0);
    ensure!(is_one, "a weight is not 1");
    same(same_surface.topology(), surface.topology(), "the topology")
}

pub(crate) fn from_patches(surface: RationalSurface) -> Checked {
    let patches: Vec<RationalPatch> = surface.patches().collect();
    let joined = answer!(RationalSurface::from_patches(&patches));
    same(joined.patch_count(), patches.len(), "the number of patches")?;
    for (patch, given) in joined.patches().zip(&patches) {
        let points = patch.control_points();
        same(points, given.control_points(), "the control points")?;
        // The quotients of weights are c·rⁱ·sʲ.
        let columns = patch.degree_u() + 1;
        let pairs = patch.weights().iter().zip(given.weights());
        let logarithms: Vec<f64> = pairs.map(|(a, b)| (a / b).ln()).collect();
        let c = logarithms[0];
        let [r, s] = [1, columns].map(|k| logarithms[k] - c);
        for (k, logarithm) in logarithms.iter().enumerate() {
            let expected = c + real(k % columns) * r + real(k / columns) * s;
            ensure!((logarithm - expected).abs() < 1e-9, "weight {k}");
        }
    }
    Ok(())
}

pub(crate) fn solid_of_revolution(
    curve: NurbsCurve<DVec3>,
    origin: DVec3,
    axis: DVec3,
    angle: f64,
) -> Checked {
    // Half of the angles are full turns.
    let angle = (2.0 * TAU * (2.0 * angle - 1.0)).clamp(-TAU, TAU);
    let solid = answer!(
        RationalSurface::solid_of_revolution(&curve, origin, axis, angle),
        "axis|t where the profile meets the axis|t where the profile turns back along the axis|\
         t where the profile turns back around its centroid|size of the profile|points|net|image|weights|knots"
    );
    let topology = solid.topology();
    has_all_sides(&topology, solid.patch_count())?;
    ensure!(topology.open.is_empty(), "open edges {:?}", topology.open);
    // The sign of a volume that almost vanishes, as of a thin loop, is noise.
    let size = solid
        .control_bounds()
        .map_or(0.0, |b| b.min.abs().max(b.max.abs()).max_element());
    let noise = 1e-6 * solid.area() * size;
    holds!(
        solid.volume().is_none_or(|volume| volume >= -noise),
        "normals point inwards"
    )
}

pub(crate) fn accessors(data: SurfaceData) -> Checked {
    let surface = call(|| rational_surface_of(&data))??;
    same(surface.vertices(), &data.vertices[..], "the vertices")?;
    same(surface.indices(), &data.indices[..], "the indices")?;
    same(surface.weights(), &data.weights[..], "the weights")?;
    let counts = [surface.patch_count(), surface.patches().count()];
    same(counts, [data.degrees.len(); 2], "the patches")
}

pub(crate) fn one_patch(surface: RationalSurface, k: usize) -> Checked {
    let patch = call(|| surface.patch(k))?;
    let parts = (
        surface.degrees(k),
        surface.patch_indices(k),
        surface.patch_weights(k),
    );
    let (Some(patch), (Some(degrees), Some(indices), Some(weights))) = (patch, parts) else {
        return holds!(
            k >= surface.patch_count() && parts == (None, None, None),
            "no patch {k}"
        );
    };
    same([patch.degree_u(), patch.degree_v()], degrees, "the degrees")?;
    let vertices = surface.vertices();
    let points: Vec<DVec3> = indices.iter().map(|&i| vertices[i as usize]).collect();
    same(patch.control_points(), &points[..], "the points")?;
    same(patch.weights(), weights, "the weights")
}

pub(crate) fn eval(surface: RationalSurface, k: usize, u: f64, v: f64) -> Checked {
    let is_inside = [u, v].iter().all(|t| (0.0..=1.0).contains(t));
    if !is_inside {
        let _ = surface.eval(k, u, v); // infinite where the denominator is 0
        return Ok(());
    }
    let point = answer!(surface.eval(k, u, v), "patch|patches");
    let patch = surface.patch(k).ok_or("no such patch")?;
    holds!(
        holds(&patch.control_bounds(), point, slack(&surface)),
        "outside of the box of the control points"
    )
}

pub(crate) fn transform(surface: RationalSurface, map: DAffine3) -> Checked {
    let image = answer!(surface.transform(&map), "image");
    are_images(surface.vertices(), image.vertices(), &map)?;
    same(image.indices(), surface.indices(), "the indices")?;
    same(image.weights(), surface.weights(), "the weights")
}

pub(crate) fn move_point(surface: RationalSurface, index: usize, to: DVec3) -> Checked {
    let moved = changed(&surface, |surface| surface.move_point(index, to));
    let moved = answer!(moved, "index|vertices");
    let from = surface.vertices()[index];
    for (old, new) in surface.vertices().iter().zip(moved.vertices()) {
        ensure!(new == old || (*old == from && *new == to), "another point");
    }
    same(moved.vertices()[index], to, "the point")?;
    same(moved.weights(), surface.weights(), "the weights")
}

pub(crate) fn topology(surface: RationalSurface) -> Checked {
    let topology = call(|| surface.topology())?;
    has_all_sides(&topology, surface.patch_count())
}

pub(crate) fn mismatches(surface: RationalSurface) -> Checked {
    let groups = call(|| surface.weight_mismatches())?;
    let sides = |surface: &RationalSurface| surface.topology().open.len();
    let names: Vec<_> = groups
        .iter()
        .flatten()
        .map(|side| (side.patch, side.edge))
        .collect();
    let is_alone = |group: &Vec<_>| group.len() == 1;
    ensure!(!groups.iter().any(is_alone), "one edge alone");
    let twice = (1..names.len()).find(|&k| names[..k].contains(&names[k]));
    ensure!(twice.is_none(), "an edge twice");
    // With the weights 1 all these edges are the same lines.
    let ones = vec![1.0; surface.indices().len()];
    let degrees: Vec<[usize; 2]> = (0..surface.patch_count())
        .filter_map(|k| surface.degrees(k))
        .collect();
    let (vertices, indices) = (surface.vertices().to_vec(), surface.indices().to_vec());
    let plain = RationalSurface::with_degrees(vertices, indices, ones, &degrees)?;
    ensure!(plain.weight_mismatches().is_empty(), "for weights 1");
    holds!(
        !groups.is_empty() || sides(&plain) == sides(&surface),
        "open edges whose weights are not named"
    )
}

pub(crate) fn to_text(surface: RationalSurface) -> Checked {
    let back = RationalSurface::parse(&call(|| surface.to_text())?)?;
    same(back, surface, "the surface of the text")
}

pub(crate) fn grid(surface: RationalSurface, u: usize, v: usize, quads: bool) -> Checked {
    is_grid(&surface, [u, v], quads, |grid| surface.grid(grid, quads))
}

pub(crate) fn grid_into(surface: RationalSurface, u: usize, v: usize, quads: bool) -> Checked {
    is_grid(&surface, [u, v], quads, |grid| {
        // Into a mesh of another size.
        let mut mesh = surface.grid(Grid::from(2), !quads)?;
        surface.grid_into(grid, quads, &mut mesh).map(|()| mesh)
    })
}

fn is_grid(
    surface: &RationalSurface,
    [segments_u, segments_v]: [usize; 2],
    quads: bool,
    make: impl Fn(Grid) -> Result<Mesh, Error>,
) -> Checked {
    let grid = Grid {
        segments_u,
        segments_v,
    };
    let mesh = answer!(make(grid), REFUSALS);
    is_mesh(&mesh)?;
    let counts = [grid.vertex_count(), grid.triangle_count()];
    let counts = counts.map(|count| count * surface.patch_count());
    let got = [mesh.vertex_count(), mesh.triangle_count()];
    same(got, counts, "vertices and triangles")?;
    same(mesh.quads.is_some(), quads, "quads")?;
    let (slack, vertices) = (
        1e-6 * size() + slack(surface),
        meshes::points(&mesh.positions),
    );
    let (iu, iv) = (segments_u / 2, segments_v / 2);
    let (u, v) = grid.uv(iu, iv);
    for (patch, vertices) in surface.patches().zip(vertices.chunks(grid.vertex_count())) {
        let vertex = vertices[grid.vertex(iu, iv)];
        near(vertex, patch.eval(u, v), slack, "a vertex")?;
    }
    Ok(())
}

pub(crate) fn tessellate(
    surface: RationalSurface,
    tolerance: f64,
    cells: Option<usize>,
    weld: Weld,
) -> Checked {
    let options = meshes::options(tolerance, cells, weld);
    is_tessellation(TESSELLATION, || surface.tessellate(&options))
}

pub(crate) fn tessellate_f64(
    surface: RationalSurface,
    tolerance: f64,
    cells: Option<usize>,
    weld: Weld,
) -> Checked {
    let options = meshes::options(tolerance, cells, weld);
    is_tessellation(TESSELLATION, || surface.tessellate_f64(&options))
}

pub(crate) fn tessellate_view(
    surface: RationalSurface,
    view: DMat4,
    pixels: f64,
    weld: Weld,
) -> Checked {
    let options = in_view(view, pixels, weld);
    is_mesh(&answer!(surface.tessellate(&options), TESSELLATION))
}

pub(crate) fn wireframe(
    surface: RationalSurface,
    lines: usize,
    wire: String,
    width: f64,
    sides: usize,
) -> Checked {
    let options = wires(lines, &wire, width, sides);
    is_mesh(&answer!(surface.wireframe(&options), WIRE_REFUSALS))
}

pub(crate) fn control_bounds(surface: RationalSurface) -> Checked {
    let bounds = call(|| surface.control_bounds())?;
    let patches = surface.patches();
    let points = patches.flat_map(|patch| patch.control_points().to_vec());
    same(bounds, box_of(points), "the box of the control points")
}

pub(crate) fn bounds(surface: RationalSurface) -> Checked {
    let bounds = value!(surface.bounds());
    same(bounds.is_some(), surface.patch_count() > 0, "a box")?;
    let (Some(bounds), Some(outer)) = (bounds, surface.control_bounds()) else {
        return Ok(());
    };
    let slack = slack(&surface);
    for patch in surface.patches() {
        let outside = locations(4).find(|&(u, v)| !holds(&bounds, patch.eval(u, v), slack));
        ensure!(outside.is_none(), "the point at {outside:?} is outside");
    }
    let is_within = holds(&outer, bounds.min, 0.0) && holds(&outer, bounds.max, 0.0);
    holds!(is_within, "larger than the box of the control points")
}

/// Checks that a found point is that at (u, v) of its patch.
fn is_there(surface: &RationalSurface, found: &SurfacePoint) -> Checked {
    let patch = surface.patch(found.patch).ok_or("no such patch")?;
    let (u, v, range) = (found.u, found.v, 0.0..=1.0);
    ensure!(range.contains(&u) && range.contains(&v), "({u}, {v})");
    let slack = 16.0 * slack(surface);
    near(found.point, patch.eval(u, v), slack, "the point at (u, v)")
}

pub(crate) fn nearest(surface: RationalSurface, p: DVec3) -> Checked {
    let found = answer!(surface.nearest(p));
    same(found.is_some(), surface.patch_count() > 0, "a point")?;
    let Some(found) = found else {
        return Ok(());
    };
    is_there(&surface, &found)?;
    let (slack, got) = (16.0 * slack(&surface), found.distance);
    near(found.point.distance(p), got, slack, "the distance")?;
    for patch in surface.patches() {
        let closest = from_nearest(p, locations(6).map(|(u, v)| patch.eval(u, v)));
        // Squares of distances are compared, so rounding counts as √ε where both are near zero.
        let square = closest * closest + slack * size();
        at_most(got * got, square, "a sample is nearer")?;
    }
    Ok(())
}

pub(crate) fn intersect_ray(surface: RationalSurface, origin: DVec3, direction: DVec3) -> Checked {
    let hits = answer!(
        surface.intersect_ray(origin, direction),
        "direction|too many"
    );
    let sorted = hits.is_sorted_by(|a, b| a.distance <= b.distance);
    ensure!(sorted, "the hits are not sorted");
    // The ray is as wide as for polynomial patches, where rounding is not enlarged by weights.
    let width = 1e-7 * (size() + origin.length()) + slack(&surface);
    for hit in &hits {
        is_there(&surface, hit)?;
        let on_ray = origin + direction.normalize() * hit.distance;
        near(on_ray, hit.point, width, "the point on the ray")?;
    }
    Ok(())
}

pub(crate) fn area(surface: RationalSurface) -> Checked {
    let area = value!(surface.area());
    ensure!(area >= 0.0, "{area:e} is negative");
    let single = |patch: RationalPatch| RationalSurface::from(&patch).area();
    let sum: f64 = surface.patches().map(single).sum();
    near(area, sum, 1e-9 * sum, "the sum of the patches")
}

pub(crate) fn volume(surface: RationalSurface) -> Checked {
    let volume = value!(surface.volume());
    let topology = surface.topology();
    let closed = topology.open.is_empty() && topology.non_manifold.is_empty();
    let may_have = closed && surface.patch_count() > 0;
    holds!(may_have || volume.is_none(), "a volume of an open surface")
}

pub(crate) fn isocurves(surface: RationalSurface, lines: usize) -> Checked {
    let curves = answer!(surface.isocurves(lines), "lines");
    let max = 2 * (lines + 1) * surface.patch_count();
    holds!(curves.len() <= max, "{} curves of {max}", curves.len())
}

pub(crate) fn trace_projected(
    surface: RationalSurface,
    view: DMat4,
    lines: usize,
    tolerance: Option<f64>,
) -> Checked {
    let mut pen = Recorder::default();
    let mut trace = || surface.trace_projected(&mut pen, &view, lines, tolerance);
    answer!(trace(), "lines|tolerance");
    holds!(!pen.is_bad, "numbers that are not finite, or no start")
}
