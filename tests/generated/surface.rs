//! Checks of surfaces.

use crate::arguments::*;
use crate::check::*;
use crate::curve_edit::Recorder;
use crate::curve_measure::holds;
use crate::mesh;
use crate::patch::{is_hit, places};
use crate::runner::Row;
use casteljau::glam::DVec3;
use casteljau::surface::{Height, TeapotOptions, Up, Wire, WireframeOptions};
use casteljau::{Patch, Point, Surface};
use casteljau_generator::{Case, Mode};

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
    ("Surface::bounds", bounds),
    ("Surface::area", area),
    ("Surface::volume", volume),
    ("Surface::topology", topology),
    ("Surface::nearest", nearest),
    ("Surface::intersect_ray", intersect_ray),
    ("Surface::grid", mesh::surface_grid),
    ("Surface::grid_into", mesh::surface_grid),
    ("Surface::grid_by", mesh::surface_grid),
    ("Surface::tessellate", mesh::surface_tessellate),
    ("Surface::tessellate_f64", mesh::surface_tessellate_f64),
    ("Surface::tessellate_view", mesh::surface_tessellate_view),
    ("Surface::isocurves", isocurves),
    ("Surface::trace_projected", trace_projected),
    ("Surface::wireframe", wireframe),
    ("Surface::subdivide", subdivide),
];

fn slack_of(case: &Case) -> f64 {
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
    let image = value!(case, surface.transform(&map));
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
    let moved = answer!(case, surface.move_point(index, to), &["index"]);
    ensure!(moved.vertices()[index] == to, "the vertex is elsewhere");
    ensure!(moved.indices() == surface.indices(), "other indices");
    Ok(())
}

fn bounds(case: &Case) -> Checked {
    let surface = surface(case);
    let bounds = value!(case, surface.bounds());
    ensure!(
        bounds.is_some() == (surface.patch_count() > 0),
        "a box of nothing, or none"
    );
    for patch in surface.patches() {
        let outside = places(4)
            .find(|&(u, v)| !bounds.is_some_and(|b| holds(&b, patch.eval(u, v), slack_of(case))));
        ensure!(outside.is_none(), "the point at {outside:?} lies outside");
    }
    Ok(())
}

fn area(case: &Case) -> Checked {
    let surface = surface(case);
    let area = value!(case, surface.area());
    let sum: f64 = surface.patches().map(|patch| patch.area()).sum();
    ensure!(
        (area - sum).abs() <= 1e-7 * sum,
        "{area:e}, but the patches have {sum:e}"
    );
    Ok(())
}

fn volume(case: &Case) -> Checked {
    let surface = surface(case);
    let volume = value!(case, surface.volume());
    let topology = surface.topology();
    let closed =
        topology.open.is_empty() && topology.non_manifold.is_empty() && surface.patch_count() > 0;
    ensure!(closed || volume.is_none(), "a volume of what is not closed");
    Ok(())
}

fn topology(case: &Case) -> Checked {
    let surface = surface(case);
    let topology = call(case, || surface.topology())?;
    let grouped = topology
        .shared
        .iter()
        .chain(&topology.non_manifold)
        .map(Vec::len)
        .sum::<usize>();
    let sides = grouped + topology.open.len() + topology.collapsed.len();
    ensure!(sides == 4 * surface.patch_count(), "{sides} sides");
    let parts: usize = topology.components.iter().map(Vec::len).sum();
    ensure!(
        parts == surface.patch_count(),
        "{parts} patches in the components"
    );
    Ok(())
}

fn nearest(case: &Case) -> Checked {
    let (surface, p) = (surface(case), point::<DVec3>(case, "p"));
    let nearest = answer!(case, surface.nearest(p));
    ensure!(
        nearest.is_some() == (surface.patch_count() > 0),
        "a point of nothing, or none"
    );
    let Some(nearest) = nearest else {
        return Ok(());
    };
    let slack = slack_of(case);
    let patch = surface.patch(nearest.patch).ok_or("no such patch")?;
    ensure!(
        distance(patch.eval(nearest.u, nearest.v), nearest.point) <= slack,
        "the point is not that at (u, v)"
    );
    for patch in surface.patches() {
        let least = places(6)
            .map(|(u, v)| distance(patch.eval(u, v), p))
            .fold(f64::INFINITY, f64::min);
        let far = nearest.distance.powi(2) > least * least + slack * case.size();
        ensure!(
            !far,
            "{:e}, but a sample is {least:e} away",
            nearest.distance
        );
    }
    Ok(())
}

fn intersect_ray(case: &Case) -> Checked {
    let (surface, origin, direction) = (
        surface(case),
        point::<DVec3>(case, "origin"),
        point::<DVec3>(case, "direction"),
    );
    let hits = answer!(
        case,
        surface.intersect_ray(origin, direction),
        &["direction"]
    );
    for hit in hits {
        let patch = surface.patch(hit.patch).ok_or("no such patch")?;
        is_hit(
            case,
            origin,
            direction,
            hit.distance,
            hit.point,
            patch.eval(hit.u, hit.v),
            slack_of(case),
        )?;
    }
    Ok(())
}

fn isocurves(case: &Case) -> Checked {
    let (surface, lines) = (surface(case), count(case, "lines"));
    let curves = answer!(case, surface.isocurves(lines), &["lines"]);
    let most = 2 * (lines + 1) * surface.patch_count();
    ensure!(
        curves.len() <= most,
        "{} curves, at most {most} are possible",
        curves.len()
    );
    Ok(())
}

fn trace_projected(case: &Case) -> Checked {
    let (surface, matrix, lines) = (
        surface(case),
        projection(case, "view"),
        count(case, "lines"),
    );
    let mut pen = Recorder::default();
    let tolerance = optional(case, "tolerance");
    answer!(
        case,
        surface.trace_projected(&mut pen, &matrix, lines, tolerance),
        &["lines", "tolerance"]
    );
    ensure!(
        pen.is_fine(),
        "numbers that are not finite, or a line without a start"
    );
    Ok(())
}

fn wireframe(case: &Case) -> Checked {
    let (surface, width) = (surface(case), number(case, "width"));
    let tube = word(case, "wire") == "tube";
    let wire = if tube {
        Wire::Tube {
            radius: width,
            sides: count(case, "sides"),
        }
    } else {
        Wire::Ribbon { width }
    };
    let options = WireframeOptions {
        lines: count(case, "lines"),
        wire,
    };
    let allowed = ["lines", "sides", "radius", "width", "too many", "vertices"];
    let mesh = answer!(case, surface.wireframe(&options), &allowed);
    mesh::is_mesh(&mesh)
}

fn subdivide(case: &Case) -> Checked {
    let (surface, tolerance) = (surface(case), number(case, "tolerance"));
    let pieces = answer!(case, surface.subdivide(tolerance), &["tolerance"]);
    if case.mode == Mode::Extreme {
        return Ok(());
    }
    let mut areas = vec![0.0; surface.patch_count()];
    for piece in &pieces {
        areas[piece.patch] += (piece.u1 - piece.u0) * (piece.v1 - piece.v0);
    }
    ensure!(
        areas.iter().all(|area: &f64| (area - 1.0).abs() <= 1e-9),
        "the pieces do not cover the patches: {areas:?}"
    );
    for piece in pieces.iter().step_by(pieces.len().div_ceil(20).max(1)) {
        let patch = surface.patch(piece.patch).ok_or("no such patch")?;
        let gap = distance(patch.eval(piece.u1, piece.v1), piece.corners[2]);
        ensure!(gap <= slack_of(case), "a corner is {gap:e} off");
        ensure!(
            piece.triangles()[0][0] == piece.corners[0],
            "other triangles"
        );
    }
    Ok(())
}
