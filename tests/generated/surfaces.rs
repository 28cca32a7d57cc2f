//! Checks of surfaces: construction, models, measures, topology, lines, pieces.

use crate::check::*;
use crate::recorder::Recorder;
use crate::shared::*;
use casteljau::glam::{DMat4, DVec3};
use casteljau::models::{Height, TeapotOptions, Up};
use casteljau::surface::Topology;
use casteljau::{Patch, Surface};
use casteljau_generator::SurfaceData;

pub(crate) fn new(data: SurfaceData) -> Checked {
    let ([m, n], vertices) = (data.degrees[0], data.vertices.clone());
    let surface = answer!(Surface::new(vertices, data.indices.clone(), m, n));
    has_data(&surface, &data)
}

fn has_data(surface: &Surface, data: &SurfaceData) -> Checked {
    same(surface.vertices(), data.vertices.as_slice(), "the vertices")?;
    same(surface.indices(), data.indices.as_slice(), "the indices")?;
    same(surface.patch_count(), data.degrees.len(), "the patches")?;
    same(surface.patches().count(), data.degrees.len(), "the patches")
}

pub(crate) fn accessors(data: SurfaceData) -> Checked {
    let (vertices, indices) = (data.vertices.clone(), data.indices.clone());
    let make = || Surface::with_degrees(vertices, indices, &data.degrees);
    has_data(&call(make)??, &data)
}

pub(crate) fn one_patch(surface: Surface, k: usize) -> Checked {
    let patch = call(|| surface.patch(k))?;
    let (degrees, indices) = (surface.degrees(k), surface.patch_indices(k));
    let there = [patch.is_some(), degrees.is_some(), indices.is_some()];
    same(there, [k < surface.patch_count(); 3], "a patch")?;
    let (Some(patch), Some(degrees), Some(indices)) = (patch, degrees, indices) else {
        return Ok(());
    };
    same([patch.degree_u(), patch.degree_v()], degrees, "the degrees")?;
    let vertices = surface.vertices();
    let points: Vec<DVec3> = indices.iter().map(|&i| vertices[i as usize]).collect();
    same(patch.control_points(), points.as_slice(), "the points")
}

pub(crate) fn teapot(parts: Vec<&'static str>, height: Height, up: Up) -> Checked {
    let has = |part: &str| parts.contains(&part);
    let options = (TeapotOptions::new().height(height).up(up))
        .rim(has("rim"))
        .body(has("body"))
        .handle(has("handle"))
        .spout(has("spout"))
        .lid(has("lid"))
        .bottom(has("bottom"));
    let surface = call(|| Surface::teapot(&options))?;
    let large = |part: &&str| ["body", "lid"].contains(part);
    let expected = 4 * (parts.len() + parts.iter().copied().filter(large).count());
    same(surface.patch_count(), expected, "the patches")
}

pub(crate) fn teacup(up: Up) -> Checked {
    let cup = call(|| Surface::teacup(up))?;
    same(cup.patch_count(), 26, "the patches")
}

pub(crate) fn teaspoon(up: Up) -> Checked {
    let spoon = call(|| Surface::teaspoon(up))?;
    same(spoon.patch_count(), 16, "the patches")
}

pub(crate) fn to_text(surface: Surface) -> Checked {
    let back = Surface::parse(&call(|| surface.to_text())?)?;
    same(back, surface, "the surface of the text")
}

pub(crate) fn area(surface: Surface) -> Checked {
    let area = value!(surface.area());
    let sum: f64 = surface.patches().map(|patch| patch.area()).sum();
    near(area, sum, 1e-7 * sum, "the sum of the patches")
}

pub(crate) fn volume(surface: Surface) -> Checked {
    let volume = value!(surface.volume());
    let topology = surface.topology();
    let closed = topology.open.is_empty() && topology.non_manifold.is_empty();
    let may_have = closed && surface.patch_count() > 0;
    holds!(may_have || volume.is_none(), "a volume of an open surface")
}

pub(crate) fn topology(surface: Surface) -> Checked {
    let topology = call(|| surface.topology())?;
    has_all_sides(&topology, surface.patch_count())
}

/// Checks that every side and every patch of a surface are in a topology.
pub(crate) fn has_all_sides(topology: &Topology, patches: usize) -> Checked {
    let groups = topology.shared.iter().chain(&topology.non_manifold);
    let grouped: usize = groups.map(Vec::len).sum();
    let sides = grouped + topology.open.len() + topology.collapsed.len();
    same(sides, 4 * patches, "the sides")?;
    let parts: usize = topology.components.iter().map(Vec::len).sum();
    same(parts, patches, "the components")
}

pub(crate) fn isocurves(surface: Surface, lines: usize) -> Checked {
    let curves = answer!(surface.isocurves(lines), "lines");
    let max = 2 * (lines + 1) * surface.patch_count();
    holds!(curves.len() <= max, "{} curves of {max}", curves.len())
}

pub(crate) fn trace_projected(
    surface: Surface,
    view: DMat4,
    lines: usize,
    tolerance: Option<f64>,
) -> Checked {
    let mut pen = Recorder::default();
    let mut trace = || surface.trace_projected(&mut pen, &view, lines, tolerance);
    answer!(trace(), "lines|tolerance");
    holds!(!pen.is_bad, "numbers that are not finite, or no start")
}

pub(crate) fn subdivide(surface: Surface, tolerance: f64) -> Checked {
    let pieces = answer!(surface.subdivide(tolerance), "tolerance");
    let patches: Vec<Patch> = surface.patches().collect();
    let mut areas = vec![0.0; patches.len()];
    for piece in &pieces {
        areas[piece.patch] += (piece.u1 - piece.u0) * (piece.v1 - piece.v0);
    }
    for area in areas {
        near(area, 1.0, 1e-9, "the area of the pieces of a patch")?;
    }
    let slack = 16.0 * surface.slack();
    for piece in pieces.iter().step_by(pieces.len().div_ceil(20).max(1)) {
        let corner = patches[piece.patch].eval(piece.u1, piece.v1);
        near(piece.corners[2], corner, slack, "a corner")?;
        same(piece.triangles()[0][0], piece.corners[0], "the triangles")?;
    }
    Ok(())
}
