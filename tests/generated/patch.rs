//! Checks of patches.

use crate::arguments::*;
use crate::check::*;
use crate::curve_measure::holds;
use crate::mesh;
use crate::runner::Row;
use casteljau::glam::DVec3;
use casteljau::{Patch, Point, Surface};
use casteljau_generator::{Case, Mode, Value};

pub(crate) const ROWS: &[Row] = &[
    ("Patch::new", new),
    ("Patch::degree_u", new),
    ("Patch::degree_v", new),
    ("Patch::control_points", new),
    ("Patch::control_bounds", control_bounds),
    ("Patch::from_basis", from_basis),
    ("Patch::approx_eq", approx_eq),
    ("Patch::eval", eval),
    ("Patch::partials", partials),
    ("Patch::normal", normal),
    ("Patch::curvature", curvature),
    ("Patch::de_casteljau", every_level),
    ("Patch::isocurve_at_u", isocurve_at_u),
    ("Patch::isocurve_at_v", isocurve_at_v),
    ("Patch::transform", transform),
    ("Patch::move_point", move_point),
    ("Patch::grid", mesh::patch_grid),
    ("Patch::grid_into", mesh::patch_grid),
    ("Patch::grid_by", mesh::patch_grid),
    ("Patch::tessellate", mesh::patch_tessellate),
    ("Patch::tessellate_f64", mesh::patch_tessellate_f64),
];

/// The slack at (u, v), including the factor by which parameters outside [0, 1] enlarge coordinates.
pub(crate) fn slack_at(case: &Case, patch: &Patch, u: f64, v: f64) -> f64 {
    let (m, n) = (patch.degree_u(), patch.degree_v());
    slack(case.size(), m + n) * growth(u, m) * growth(v, n)
}

/// The point at (u, v) by de Casteljau's algorithm in both directions.
fn expected(patch: &Patch, u: f64, v: f64) -> DVec3 {
    let rows = patch.control_points().chunks(patch.degree_u() + 1);
    de_casteljau(&rows.map(|row| de_casteljau(row, u)).collect::<Vec<_>>(), v)
}

/// Parameters of a grid of points on a patch.
pub(crate) fn locations(steps: usize) -> impl Iterator<Item = (f64, f64)> {
    parameters(steps, 1.0).flat_map(move |v| parameters(steps, 1.0).map(move |u| (u, v)))
}

fn new(case: &Case) -> Checked {
    let data = surface_data(case);
    let [m, n] = data.degrees[0];
    let patch = answer!(case, Patch::new(&data.vertices, m, n));
    ensure!(
        (patch.degree_u(), patch.degree_v()) == (m, n),
        "other degrees"
    );
    ensure!(
        patch.control_points() == data.vertices,
        "other control points"
    );
    Ok(())
}

fn control_bounds(case: &Case) -> Checked {
    let patch = patch(case);
    let bounds = call(case, || patch.control_bounds())?;
    ensure!(
        patch
            .control_points()
            .iter()
            .all(|&p| holds(&bounds, p, 0.0)),
        "a control point lies outside"
    );
    Ok(())
}

fn from_basis(case: &Case) -> Checked {
    let Value::Points(_, points) = case.get("points") else {
        return Err(String::from("no points"));
    };
    let net: &[DVec3; 16] = points.as_slice().try_into().expect("sixteen points");
    let patch = answer!(case, Patch::from_basis(basis(case, "basis"), net), &["net"]);
    ensure!(
        (patch.degree_u(), patch.degree_v()) == (3, 3),
        "not bicubic"
    );
    Ok(())
}

fn approx_eq(case: &Case) -> Checked {
    let (patch, tolerance) = (patch(case), number(case, "tolerance"));
    let same = call(case, || patch.approx_eq(&patch, tolerance.max(0.0)))?;
    ensure!(same && patch.approx_eq(&patch, 0.0), "not equal to itself");
    Ok(())
}

fn eval(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let point = value!(case, patch.eval(u, v));
    let gap = distance(point, expected(&patch, u, v));
    ensure!(
        gap <= slack_at(case, &patch, u, v),
        "{gap:e} away from de Casteljau's algorithm"
    );
    Ok(())
}

fn partials(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let partials = value!(case, patch.partials(u, v));
    let (along_u, along_v) = (patch.isocurve_at_v(v), patch.isocurve_at_u(u));
    let slack = 16.0 * slack_at(case, &patch, u, v);
    let (m, n) = (real(patch.degree_u()), real(patch.degree_v()));
    for (name, got, curve, t, order, size) in [
        ("∂u", partials.u, &along_u, u, 1, m),
        ("∂v", partials.v, &along_v, v, 1, n),
        ("∂uu", partials.uu, &along_u, u, 2, m * m),
        ("∂vv", partials.vv, &along_v, v, 2, n * n),
    ] {
        let gap = distance(got, curve.derivative_at(t, order));
        ensure!(
            gap <= slack * size,
            "{name} is {gap:e} away from the isocurve's derivative"
        );
    }
    Ok(())
}

fn normal(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let normal = call(case, || patch.normal(u, v))?;
    let length = normal.length();
    ensure!(
        length == 0.0 || (length - 1.0).abs() <= 1e-9,
        "the length is {length}"
    );
    // Where coordinates differ by many powers of ten, rounding of the net decides the direction.
    if case.mode != Mode::Moderate {
        return Ok(());
    }
    let partials = patch.partials(u, v);
    let cross = partials.u.cross(partials.v);
    let rounding = 64.0
        * slack_at(case, &patch, u, v)
        * real(patch.degree_u() * patch.degree_v())
        * (partials.u.length() + partials.v.length());
    let across = distance(cross, normal * cross.length());
    ensure!(
        cross.length() <= (1e3 * rounding).max(vanishing(&patch)) || across <= rounding,
        "{across:e} off ∂u × ∂v, more than {rounding:e}"
    );
    Ok(())
}

/// The length of ∂u × ∂v below which it counts as vanishing (see `Patch::normal`). Differences are scaled by their
/// largest coordinate, which is up to √3 times shorter than the largest difference, along u and along v.
fn vanishing(patch: &Patch) -> f64 {
    let (net, columns) = (patch.control_points(), patch.degree_u() + 1);
    let largest = |pairs: &mut dyn Iterator<Item = (DVec3, DVec3)>| {
        pairs.map(|(a, b)| distance(a, b)).fold(0.0, f64::max)
    };
    let along_u = net.chunks(columns).flat_map(|row| row.windows(2));
    let along_u = largest(&mut along_u.map(|pair| (pair[0], pair[1])));
    let along_v = largest(&mut net.iter().copied().zip(net[columns..].iter().copied()));
    1e-13 * real(patch.degree_u() * patch.degree_v()) * along_u * along_v
}

fn curvature(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let curvature = call(case, || patch.curvature(u, v))?;
    ensure!(
        curvature.k1 >= curvature.k2,
        "k1 = {} is less than k2 = {}",
        curvature.k1,
        curvature.k2
    );
    let mean = 0.5 * (curvature.k1 + curvature.k2);
    let size = curvature.k1.abs().max(curvature.k2.abs());
    let fits = (mean - curvature.mean).abs() <= 1e-9 * size;
    ensure!(
        fits || case.mode == Mode::Extreme,
        "mean {} instead of {mean}",
        curvature.mean
    );
    Ok(())
}

fn every_level(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let levels = value!(case, patch.de_casteljau(u, v));
    ensure!(
        levels.rows.len() == patch.degree_v() + 1,
        "{} rows",
        levels.rows.len()
    );
    ensure!(
        levels.column.len() == patch.degree_v() + 1,
        "{} levels",
        levels.column.len()
    );
    let gap = distance(levels.point, patch.eval(u, v));
    ensure!(
        gap <= slack_at(case, &patch, u, v),
        "{gap:e} away from eval"
    );
    Ok(())
}

fn isocurve_at_u(case: &Case) -> Checked {
    let (patch, u) = (patch(case), number(case, "u"));
    let curve = value!(case, patch.isocurve_at_u(u));
    ensure!(
        curve.degree() == patch.degree_v(),
        "degree {}",
        curve.degree()
    );
    for v in parameters(4, 1.0) {
        let gap = distance(curve.eval(v), patch.eval(u, v));
        ensure!(
            gap <= 4.0 * slack_at(case, &patch, u, v),
            "{gap:e} away at v = {v}"
        );
    }
    Ok(())
}

fn isocurve_at_v(case: &Case) -> Checked {
    let (patch, v) = (patch(case), number(case, "v"));
    let curve = value!(case, patch.isocurve_at_v(v));
    ensure!(
        curve.degree() == patch.degree_u(),
        "degree {}",
        curve.degree()
    );
    for u in parameters(4, 1.0) {
        let gap = distance(curve.eval(u), patch.eval(u, v));
        ensure!(
            gap <= 4.0 * slack_at(case, &patch, u, v),
            "{gap:e} away at u = {u}"
        );
    }
    Ok(())
}

fn transform(case: &Case) -> Checked {
    let (patch, map) = (patch(case), affine::<DVec3>(case, "map"));
    let image = answer!(case, patch.transform(&map), &["image"]);
    let images = patch
        .control_points()
        .iter()
        .map(|p| Point::transform(*p, &map));
    ensure!(
        images.eq(image.control_points().iter().copied()),
        "not the mapped control points"
    );
    Ok(())
}

fn move_point(case: &Case) -> Checked {
    let (patch, index, to) = (
        patch(case),
        count(case, "index"),
        point::<DVec3>(case, "to"),
    );
    let moved = answer!(case, patch.move_point(index, to), &["index"]);
    ensure!(
        moved.control_points()[index] == to,
        "the point is elsewhere"
    );
    Ok(())
}

/// The patch as a surface.
pub(crate) fn as_surface(patch: &Patch) -> Surface {
    let count = u32::try_from(patch.control_points().len()).expect("a small net");
    let indices = (0..count).collect();
    Surface::new(
        patch.control_points().to_vec(),
        indices,
        patch.degree_u(),
        patch.degree_v(),
    )
    .expect("a surface")
}
