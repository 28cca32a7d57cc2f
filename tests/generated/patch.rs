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
    ("Patch::equals", equals),
    ("Patch::eval", eval),
    ("Patch::partials", partials),
    ("Patch::normal", normal),
    ("Patch::curvature", curvature),
    ("Patch::scaffold", scaffold),
    ("Patch::isocurve_at_u", isocurve_at_u),
    ("Patch::isocurve_at_v", isocurve_at_v),
    ("Patch::split_u", split_u),
    ("Patch::split_v", split_v),
    ("Patch::split", split),
    ("Patch::elevate", elevate),
    ("Patch::transform", transform),
    ("Patch::move_point", move_point),
    ("Patch::bounds", bounds),
    ("Patch::flatness", flatness),
    ("Patch::area", area),
    ("Patch::nearest", nearest),
    ("Patch::intersect_ray", intersect_ray),
    ("Patch::grid", mesh::patch_grid),
    ("Patch::grid_into", mesh::patch_grid),
    ("Patch::grid_by", mesh::patch_grid),
    ("Patch::tessellate", mesh::patch_tessellate),
    ("Patch::tessellate_f64", mesh::patch_tessellate_f64),
];

/// The slack at a place, by how much parameters outside enlarge coordinates.
pub(crate) fn slack_at(case: &Case, patch: &Patch, u: f64, v: f64) -> f64 {
    let (m, n) = (patch.degree_u(), patch.degree_v());
    slack(case.size(), m + n) * growth(u, m) * growth(v, n)
}

/// The point at (u, v) by de Casteljau's algorithm in both directions.
fn expected(patch: &Patch, u: f64, v: f64) -> DVec3 {
    let rows = patch.control_points().chunks(patch.degree_u() + 1);
    de_casteljau(&rows.map(|row| de_casteljau(row, u)).collect::<Vec<_>>(), v)
}

/// Places on a patch: a grid of them.
pub(crate) fn places(steps: usize) -> impl Iterator<Item = (f64, f64)> {
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
    let patch = answer!(case, Patch::from_basis(basis(case, "basis"), net));
    ensure!(
        (patch.degree_u(), patch.degree_v()) == (3, 3),
        "not bicubic"
    );
    Ok(())
}

fn equals(case: &Case) -> Checked {
    let (patch, tolerance) = (patch(case), number(case, "tolerance"));
    let same = call(case, || patch.equals(&patch, tolerance.max(0.0)))?;
    ensure!(same && patch.equals(&patch, 0.0), "not equal to itself");
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
    if case.mode == Mode::Extreme {
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
        cross.length() <= 1e3 * rounding || across <= rounding,
        "{across:e} off ∂u × ∂v, more than {rounding:e}"
    );
    Ok(())
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

fn scaffold(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let scaffold = value!(case, patch.scaffold(u, v));
    ensure!(
        scaffold.rows.len() == patch.degree_v() + 1,
        "{} rows",
        scaffold.rows.len()
    );
    ensure!(
        scaffold.column.len() == patch.degree_v() + 1,
        "{} levels",
        scaffold.column.len()
    );
    let gap = distance(scaffold.point, patch.eval(u, v));
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

/// A piece is the part of the patch over [u0, u1] × [v0, v1].
fn is_piece(
    case: &Case,
    patch: &Patch,
    piece: &Patch,
    [u0, u1]: [f64; 2],
    [v0, v1]: [f64; 2],
) -> Checked {
    let worst = |a: f64, b: f64, n: usize| growth(a, n).max(growth(b, n));
    let (m, n) = (patch.degree_u(), patch.degree_v());
    let slack = 8.0 * slack(case.size(), m + n) * worst(u0, u1, m) * worst(v0, v1, n);
    for (s, t) in places(3) {
        let (u, v) = (u0 * (1.0 - s) + u1 * s, v0 * (1.0 - t) + v1 * t);
        let gap = distance(piece.eval(s, t), patch.eval(u, v));
        ensure!(
            gap <= slack,
            "the piece is {gap:e} away at ({u}, {v}), more than {slack:e}"
        );
    }
    Ok(())
}

fn split_u(case: &Case) -> Checked {
    let (patch, u) = (patch(case), number(case, "u"));
    let (before, after) = value!(case, patch.split_u(u));
    is_piece(case, &patch, &before, [0.0, u], [0.0, 1.0])?;
    is_piece(case, &patch, &after, [u, 1.0], [0.0, 1.0])
}

fn split_v(case: &Case) -> Checked {
    let (patch, v) = (patch(case), number(case, "v"));
    let (before, after) = value!(case, patch.split_v(v));
    is_piece(case, &patch, &before, [0.0, 1.0], [0.0, v])?;
    is_piece(case, &patch, &after, [0.0, 1.0], [v, 1.0])
}

fn split(case: &Case) -> Checked {
    let (patch, u, v) = (patch(case), number(case, "u"), number(case, "v"));
    let [a, b, c, d] = value!(case, patch.split(u, v));
    is_piece(case, &patch, &a, [0.0, u], [0.0, v])?;
    is_piece(case, &patch, &b, [u, 1.0], [0.0, v])?;
    is_piece(case, &patch, &c, [0.0, u], [v, 1.0])?;
    is_piece(case, &patch, &d, [u, 1.0], [v, 1.0])
}

fn elevate(case: &Case) -> Checked {
    let patch = patch(case);
    let elevated = answer!(case, patch.elevate());
    ensure!(
        elevated.degree_u() == patch.degree_u() + 1,
        "degree {}",
        elevated.degree_u()
    );
    is_piece(case, &patch, &elevated, [0.0, 1.0], [0.0, 1.0])
}

fn transform(case: &Case) -> Checked {
    let (patch, map) = (patch(case), affine::<DVec3>(case, "map"));
    let image = value!(case, patch.transform(&map));
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

fn bounds(case: &Case) -> Checked {
    let patch = patch(case);
    let bounds = value!(case, patch.bounds());
    let slack = 4.0 * slack_at(case, &patch, 0.0, 0.0);
    for (u, v) in places(8) {
        ensure!(
            holds(&bounds, patch.eval(u, v), slack),
            "S({u}, {v}) lies outside"
        );
    }
    let outer = patch.control_bounds();
    ensure!(
        holds(&outer, bounds.min, slack) && holds(&outer, bounds.max, slack),
        "larger than the box of the control points"
    );
    Ok(())
}

fn flatness(case: &Case) -> Checked {
    let patch = patch(case);
    let flatness = value!(case, patch.flatness());
    let [a, b, c, d] =
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(u, v)| patch.eval(u, v));
    let slack = 8.0 * slack_at(case, &patch, 0.0, 0.0);
    for (u, v) in places(6) {
        // The point of the triangles at (u, v), with the diagonal from b to c.
        let flat = if u + v <= 1.0 {
            a + (b - a) * u + (c - a) * v
        } else {
            d + (c - d) * (1.0 - u) + (b - d) * (1.0 - v)
        };
        let gap = distance(patch.eval(u, v), flat);
        ensure!(
            gap <= flatness + slack,
            "{gap:e} from the triangles at ({u}, {v}), the bound is {flatness:e}"
        );
    }
    Ok(())
}

fn area(case: &Case) -> Checked {
    let patch = patch(case);
    let area = value!(case, patch.area());
    let [a, b, c, d] = patch.split(0.5, 0.5);
    let sum: f64 = [a, b, c, d].iter().map(Patch::area).sum();
    // 1e-8 each, and the eighth digit where the patch folds back.
    let slack = 1e-6 * area + 64.0 * slack_at(case, &patch, 0.0, 0.0) * case.size();
    ensure!(
        area >= 0.0 && (area - sum).abs() <= slack,
        "{area:e}, but the quarters have {sum:e}"
    );
    Ok(())
}

fn nearest(case: &Case) -> Checked {
    let (patch, p) = (patch(case), point::<DVec3>(case, "p"));
    let nearest = answer!(case, patch.nearest(p));
    ensure!(
        [nearest.u, nearest.v]
            .iter()
            .all(|x| (0.0..=1.0).contains(x)),
        "({}, {})",
        nearest.u,
        nearest.v
    );
    let slack = 16.0 * slack_at(case, &patch, 0.0, 0.0);
    ensure!(
        distance(nearest.point, patch.eval(nearest.u, nearest.v)) <= slack,
        "the point is not that at (u, v)"
    );
    let off = (distance(nearest.point, p) - nearest.distance).abs();
    ensure!(off <= slack, "the distance is {off:e} off");
    let least = places(12)
        .map(|(u, v)| distance(patch.eval(u, v), p))
        .fold(f64::INFINITY, f64::min);
    // Squares of distances are compared, so roundings count for √ε where both are about zero.
    let square = slack * case.size();
    ensure!(
        nearest.distance.powi(2) <= least * least + square,
        "{:e}, but a sample is {least:e} away",
        nearest.distance
    );
    Ok(())
}

/// A hit lies on the ray, and on the patch at (u, v).
pub(crate) fn is_hit(
    case: &Case,
    origin: DVec3,
    direction: DVec3,
    got: f64,
    point: DVec3,
    on: DVec3,
    slack: f64,
) -> Checked {
    let gap = distance(point, on);
    ensure!(
        gap <= slack,
        "the point is {gap:e} away from that at (u, v)"
    );
    let along = direction.normalize();
    let off = distance(origin + along * got, point);
    // Some 1e-14 of the size of patch and origin together; 1e-7 of it where the ray grazes.
    let width = 1e-7 * (case.size() + origin.length());
    ensure!(off <= width, "{off:e} off the ray, more than {width:e}");
    Ok(())
}

fn intersect_ray(case: &Case) -> Checked {
    let (patch, origin, direction) = (
        patch(case),
        point::<DVec3>(case, "origin"),
        point::<DVec3>(case, "direction"),
    );
    let hits = answer!(case, patch.intersect_ray(origin, direction), &["direction"]);
    ensure!(
        hits.windows(2).all(|w| w[0].distance <= w[1].distance),
        "the hits are not sorted"
    );
    let slack = 16.0 * slack_at(case, &patch, 0.0, 0.0);
    for hit in hits {
        is_hit(
            case,
            origin,
            direction,
            hit.distance,
            hit.point,
            patch.eval(hit.u, hit.v),
            slack,
        )?;
    }
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
