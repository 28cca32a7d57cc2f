//! Checks of surfaces: bounding boxes, areas, nearest points, rays, isocurves.

use crate::arguments::*;
use crate::check::*;
use crate::curve_drawing::Recorder;
use crate::curve_measure::holds;
use crate::mesh;
use crate::patch::locations;
use crate::patch_query::is_hit;
use crate::runner::Row;
use crate::surface::slack_of;
use casteljau::glam::DVec3;
use casteljau::mesh::{Wire, WireframeOptions};
use casteljau_generator::{Case, Mode};

pub(crate) const ROWS: &[Row] = &[
    ("Surface::bounds", bounds),
    ("Surface::area", area),
    ("Surface::volume", volume),
    ("Surface::topology", topology),
    ("Surface::nearest", nearest),
    ("Surface::intersect_ray", intersect_ray),
    ("Surface::isocurves", isocurves),
    ("Surface::trace_projected", trace_projected),
    ("Surface::wireframe", wireframe),
    ("Surface::subdivide", subdivide),
];

fn bounds(case: &Case) -> Checked {
    let surface = surface(case);
    let bounds = value!(case, surface.bounds());
    ensure!(
        bounds.is_some() == (surface.patch_count() > 0),
        "a box of nothing, or none"
    );
    for patch in surface.patches() {
        let outside = locations(4)
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
        let min = locations(6)
            .map(|(u, v)| distance(patch.eval(u, v), p))
            .fold(f64::INFINITY, f64::min);
        let far = nearest.distance.powi(2) > min * min + slack * case.size();
        ensure!(!far, "{:e}, but a sample is {min:e} away", nearest.distance);
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
        &["direction", "too many"]
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
    let max = 2 * (lines + 1) * surface.patch_count();
    ensure!(
        curves.len() <= max,
        "{} curves, at most {max} are possible",
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
