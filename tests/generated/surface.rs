//! Checks of surfaces.

use crate::arguments::*;
use crate::check::*;
use crate::curve_measure::holds;
use crate::mesh;
use crate::runner::Row;
use casteljau::glam::DVec3;
use casteljau::models::{Height, TeapotOptions, Up};
use casteljau::{Patch, Point, Surface};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Surface::new", new),
    ("Surface::with_degrees", accessors),
    ("Surface::teapot", teapot),
    ("Surface::teacup", |case| known(case, 26, Surface::teacup)),
    ("Surface::teaspoon", |case| {
        known(case, 16, Surface::teaspoon)
    }),
    ("Surface::vertices", accessors),
    ("Surface::indices", accessors),
    ("Surface::patch_count", accessors),
    ("Surface::degrees", one_patch),
    ("Surface::patch_indices", one_patch),
    ("Surface::patch", one_patch),
    ("Surface::patches", accessors),
    ("Surface::control_bounds", control_bounds),
    ("Surface::to_text", to_text),
    ("Surface::transform", transform),
    ("Surface::move_point", move_point),
    ("Surface::grid", mesh::surface_grid),
    ("Surface::grid_into", mesh::surface_grid),
    ("Surface::grid_by", mesh::surface_grid),
    ("Surface::tessellate", mesh::surface_tessellate),
    ("Surface::tessellate_f64", mesh::surface_tessellate_f64),
    ("Surface::tessellate_view", mesh::surface_tessellate_view),
];

pub(crate) fn slack_of(case: &Case) -> f64 {
    16.0 * slack(case.size(), 24)
}

fn new(case: &Case) -> Checked {
    let data = surface_data(case).clone();
    let [m, n] = data.degrees[0];
    let surface = answer!(
        case,
        Surface::new(data.vertices.clone(), data.indices, m, n)
    );
    ensure!(
        surface.vertices() == data.vertices && surface.patch_count() == 1,
        "another surface"
    );
    Ok(())
}

fn accessors(case: &Case) -> Checked {
    let data = surface_data(case);
    let surface = call(case, || surface(case))?;
    ensure!(
        surface.vertices() == data.vertices && surface.indices() == data.indices,
        "other vertices or indices"
    );
    ensure!(
        surface.patch_count() == data.degrees.len(),
        "{} patches",
        surface.patch_count()
    );
    let patches: Vec<Patch> = surface.patches().collect();
    ensure!(
        patches.len() == data.degrees.len(),
        "{} patches in turn",
        patches.len()
    );
    Ok(())
}

fn one_patch(case: &Case) -> Checked {
    let (surface, k) = (surface(case), count(case, "k"));
    let patch = call(case, || surface.patch(k))?;
    let (degrees, indices) = (surface.degrees(k), surface.patch_indices(k));
    let there = k < surface.patch_count();
    ensure!(
        [patch.is_some(), degrees.is_some(), indices.is_some()] == [there; 3],
        "patch {k} of {}",
        surface.patch_count()
    );
    let (Some(patch), Some(degrees), Some(indices)) = (patch, degrees, indices) else {
        return Ok(());
    };
    ensure!(
        [patch.degree_u(), patch.degree_v()] == degrees,
        "other degrees"
    );
    let points = indices.iter().map(|&i| surface.vertices()[i as usize]);
    ensure!(
        points.eq(patch.control_points().iter().copied()),
        "other control points"
    );
    Ok(())
}

fn teapot(case: &Case) -> Checked {
    let has = |part: &str| words(case, "parts").contains(&part);
    let options = TeapotOptions {
        rim: has("rim"),
        body: has("body"),
        handle: has("handle"),
        spout: has("spout"),
        lid: has("lid"),
        bottom: has("bottom"),
        height: if word(case, "height") == "original" {
            Height::Original
        } else {
            Height::Squashed
        },
        up: if word(case, "up") == "y" {
            Up::Y
        } else {
            Up::Z
        },
    };
    let surface = call(case, || Surface::teapot(options))?;
    let counts = [
        ("rim", 4),
        ("body", 8),
        ("handle", 4),
        ("spout", 4),
        ("lid", 8),
        ("bottom", 4),
    ];
    let expected: usize = counts
        .iter()
        .filter(|(part, _)| has(part))
        .map(|(_, count)| count)
        .sum();
    ensure!(
        surface.patch_count() == expected,
        "{} patches, not {expected}",
        surface.patch_count()
    );
    Ok(())
}

fn known(case: &Case, patches: usize, make: fn(Up) -> Surface) -> Checked {
    let surface = call(case, || {
        make(if word(case, "up") == "y" {
            Up::Y
        } else {
            Up::Z
        })
    })?;
    ensure!(
        surface.patch_count() == patches,
        "{} patches",
        surface.patch_count()
    );
    Ok(())
}

fn control_bounds(case: &Case) -> Checked {
    let surface = surface(case);
    let bounds = call(case, || surface.control_bounds())?;
    let inside = |p: DVec3| bounds.is_some_and(|bounds| holds(&bounds, p, 0.0));
    let mut used = surface
        .indices()
        .iter()
        .map(|&i| surface.vertices()[i as usize]);
    ensure!(used.all(inside), "a control point lies outside");
    Ok(())
}

fn to_text(case: &Case) -> Checked {
    let surface = surface(case);
    let text = call(case, || surface.to_text())?;
    let back = Surface::parse(&text).map_err(|error| error.to_string())?;
    let same = back.vertices() == surface.vertices() && back.indices() == surface.indices();
    ensure!(same, "another surface is read back");
    Ok(())
}

fn transform(case: &Case) -> Checked {
    let (surface, map) = (surface(case), affine::<DVec3>(case, "map"));
    let image = answer!(case, surface.transform(&map), &["image"]);
    let images = surface
        .vertices()
        .iter()
        .map(|p| Point::transform(*p, &map));
    ensure!(
        images.eq(image.vertices().iter().copied()),
        "not the mapped vertices"
    );
    Ok(())
}

fn move_point(case: &Case) -> Checked {
    let (surface, index, to) = (
        surface(case),
        count(case, "index"),
        point::<DVec3>(case, "to"),
    );
    let moved = answer!(case, surface.move_point(index, to), &["index", "vertices"]);
    ensure!(moved.vertices()[index] == to, "the vertex is elsewhere");
    ensure!(moved.indices() == surface.indices(), "other indices");
    Ok(())
}
