//! Checks of patches, and those that patches and surfaces share.

use crate::check::*;
use crate::curves::unit_or_zero;
use crate::geometry::*;
use crate::lines::{are_images, compares};
use crate::shared::*;
use casteljau::Patch;
use casteljau::curve::Basis;
use casteljau::glam::{DAffine3, DVec3};
use casteljau_generator::{Mode, SurfaceData};

/// The slack at (u, v), including the factor by which parameters outside [0, 1] enlarge coordinates.
fn slack_at(patch: &Patch, u: f64, v: f64) -> f64 {
    patch.slack() * growth(u, patch.degree_u()) * growth(v, patch.degree_v())
}

fn degrees(patch: &Patch) -> [usize; 2] {
    [patch.degree_u(), patch.degree_v()]
}

finite! {
    // tests/surface/patch.rs
    [] eval(patch: Patch, u: f64, v: f64): call(|| patch.eval(u, v))?;
    [] isocurve_at_u(patch: Patch, u: f64): call(|| patch.isocurve_at_u(u))?;
    [] isocurve_at_v(patch: Patch, v: f64): call(|| patch.isocurve_at_v(v))?;
    [] elevate(patch: Patch): answer!(patch.elevate());
    // tests/queries/bend.rs
    [] every_level(patch: Patch, u: f64, v: f64): call(|| patch.de_casteljau(u, v))?;
}

pub(crate) fn new(data: SurfaceData) -> Checked {
    let [m, n] = data.degrees[0];
    let patch = answer!(Patch::new(&data.vertices, m, n));
    same(degrees(&patch), [m, n], "the degrees")?;
    same(patch.control_points(), &data.vertices[..], "the points")
}

pub(crate) fn from_basis(basis: Basis, net: [DVec3; 16]) -> Checked {
    let patch = answer!(Patch::from_basis(basis, &net), "net");
    same(degrees(&patch), [3, 3], "the degrees")
}

pub(crate) fn approx_eq(patch: Patch, tolerance: f64) -> Checked {
    let tolerance = tolerance.max(0.0);
    compares(Patch::approx_eq, (&patch, &patch), tolerance)?;
    holds!(patch.approx_eq(&patch, tolerance), "not equal to itself")
}

pub(crate) fn partials(patch: Patch, u: f64, v: f64) -> Checked {
    let partials = value!(patch.partials(u, v));
    let (along_u, along_v) = (patch.isocurve_at_v(v), patch.isocurve_at_u(u));
    let slack = 16.0 * slack_at(&patch, u, v);
    let [m, n] = degrees(&patch).map(real);
    let of_u = |order| along_u.derivative_at(u, order);
    let of_v = |order| along_v.derivative_at(v, order);
    near(partials.u, of_u(1), slack * m, "∂u of the isocurve")?;
    near(partials.v, of_v(1), slack * n, "∂v of the isocurve")?;
    near(partials.uu, of_u(2), slack * m * m, "∂uu of the isocurve")?;
    near(partials.vv, of_v(2), slack * n * n, "∂vv of the isocurve")
}

pub(crate) fn normal(patch: Patch, u: f64, v: f64) -> Checked {
    let normal = call(|| patch.normal(u, v))?;
    unit_or_zero(normal, 1e-9)?;
    // Where coordinates differ by many powers of ten, rounding of the net decides the direction.
    if mode() != Mode::Moderate {
        return Ok(());
    }
    let partials = patch.partials(u, v);
    let cross = partials.u.cross(partials.v);
    let rounding = 64.0
        * slack_at(&patch, u, v)
        * real(patch.degree_u() * patch.degree_v())
        * (partials.u.length() + partials.v.length());
    if cross.length() <= (1e3 * rounding).max(vanishing(&patch)) {
        return Ok(());
    }
    near(cross, normal * cross.length(), rounding, "∂u × ∂v")
}

/// The length of ∂u × ∂v below which it counts as vanishing (see `Patch::normal`). Differences are scaled by their
/// largest coordinate, which is up to √3 times shorter than the largest difference, along u and along v.
fn vanishing(patch: &Patch) -> f64 {
    let (net, columns) = (patch.control_points(), patch.degree_u() + 1);
    let rows = net.chunks(columns).flat_map(|row| row.windows(2));
    let along_u = max(rows.map(|pair| pair[0].distance(pair[1])));
    let along_v = max(net.iter().zip(&net[columns..]).map(|(a, b)| a.distance(*b)));
    1e-13 * real(patch.degree_u() * patch.degree_v()) * along_u * along_v
}

pub(crate) fn curvature(patch: Patch, u: f64, v: f64) -> Checked {
    let found = call(|| patch.curvature(u, v))?;
    let (k1, k2) = (found.k1, found.k2);
    ensure!(k1 >= k2, "k1 = {k1} is less than k2 = {k2}");
    let (mean, slack) = (0.5 * (k1 + k2), 1e-9 * k1.abs().max(k2.abs()));
    let fits = (mean - found.mean).abs() <= slack || is_extreme();
    holds!(fits, "mean {} instead of {mean}", found.mean)
}

/// Checks that pieces are the parts of the patch over [u0, u1] × [v0, v1].
fn are_pieces<const N: usize>(patch: &Patch, pieces: [(&Patch, [f64; 2], [f64; 2]); N]) -> Checked {
    let worst = |[a, b]: [f64; 2], n: usize| growth(a, n).max(growth(b, n));
    let [m, n] = degrees(patch);
    for (piece, us, vs) in pieces {
        let slack = 8.0 * patch.slack() * worst(us, m) * worst(vs, n);
        for (s, t) in locations(3) {
            let [u, v] = [(us, s), (vs, t)].map(|([a, b], s)| a * (1.0 - s) + b * s);
            near(piece.eval(s, t), patch.eval(u, v), slack, u)?;
        }
    }
    Ok(())
}

const ALL: [f64; 2] = [0.0, 1.0];

pub(crate) fn split_u(patch: Patch, u: f64) -> Checked {
    let (a, b) = value!(patch.split_u(u));
    are_pieces(&patch, [(&a, [0.0, u], ALL), (&b, [u, 1.0], ALL)])
}

pub(crate) fn split_v(patch: Patch, v: f64) -> Checked {
    let (a, b) = value!(patch.split_v(v));
    are_pieces(&patch, [(&a, ALL, [0.0, v]), (&b, ALL, [v, 1.0])])
}

pub(crate) fn split(patch: Patch, u: f64, v: f64) -> Checked {
    let [a, b, c, d] = value!(patch.split(u, v));
    let ([u0, u1], [v0, v1]) = ([[0.0, u], [u, 1.0]], [[0.0, v], [v, 1.0]]);
    are_pieces(&patch, [(&a, u0, v0), (&b, u1, v0)])?;
    are_pieces(&patch, [(&c, u0, v1), (&d, u1, v1)])
}

pub(crate) fn flatness(patch: Patch) -> Checked {
    let room = value!(patch.flatness()) + 8.0 * patch.slack();
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    let [a, b, c, d] = corners.map(|(u, v)| patch.eval(u, v));
    for (u, v) in locations(6) {
        // The point of the triangles at (u, v), with the diagonal from b to c.
        let flat = if u + v <= 1.0 {
            a + (b - a) * u + (c - a) * v
        } else {
            d + (c - d) * (1.0 - u) + (b - d) * (1.0 - v)
        };
        near(patch.eval(u, v), flat, room, format_args!("({u}, {v})"))?;
    }
    Ok(())
}

pub(crate) fn area(patch: Patch) -> Checked {
    let area = value!(patch.area());
    ensure!(area >= 0.0, "{area:e} is negative");
    // The quarters take four times as long, so they are only checked for some of the calls.
    if seed_and_number().1 % 8 > 1 {
        return Ok(());
    }
    let sum: f64 = patch.split(0.5, 0.5).iter().map(Patch::area).sum();
    // The relative error is 1e-8 each; up to 1e-3 where the patch folds back (documented).
    let slack = 1e-3 * area + 64.0 * patch.slack() * size();
    near(area, sum, slack, "the sum of the quarters")
}

pub(crate) fn control_bounds<S: Sheet>(sheet: S) -> Checked {
    let bounds = call(|| sheet.outer_box())?;
    let patches = sheet.patches().into_iter();
    let points = patches.flat_map(|patch| patch.control_points().to_vec());
    same(bounds, box_of(points), "the box of the control points")
}

fn same_indices<S: Sheet>(a: &S, b: &S) -> Checked {
    same(a.surface().indices(), b.surface().indices(), "the indices")
}

pub(crate) fn transform<S: Sheet>(sheet: S, map: DAffine3) -> Checked {
    let image = answer!(sheet.transform(&map), "image");
    are_images(sheet.points(), image.points(), &map)?;
    same_indices(&image, &sheet)
}

pub(crate) fn move_point<S: Sheet>(sheet: S, index: usize, to: DVec3) -> Checked {
    let moved = answer!(sheet.moved(index, to), "index|vertices");
    // Vertices at the same place move together.
    let from = sheet.points()[index];
    for (old, new) in sheet.points().iter().zip(moved.points()) {
        ensure!(new == old || (*old == from && *new == to), "another point");
    }
    same(moved.points()[index], to, "the point")?;
    same_indices(&moved, &sheet)
}

pub(crate) fn bounds<S: Sheet>(sheet: S) -> Checked {
    let bounds = value!(sheet.inner_box());
    let (slack, patches) = (4.0 * sheet.slack(), sheet.patches());
    same(bounds.is_some(), !patches.is_empty(), "a box")?;
    let (Some(bounds), Some(outer)) = (bounds, sheet.outer_box()) else {
        return Ok(());
    };
    for patch in &patches {
        let mut places = locations(if patches.len() > 8 { 4 } else { 8 });
        let outside = places.find(|&(u, v)| !holds(&bounds, patch.eval(u, v), slack));
        ensure!(outside.is_none(), "the point at {outside:?} is outside");
    }
    let inside = holds(&outer, bounds.min, slack) && holds(&outer, bounds.max, slack);
    holds!(inside, "larger than the box of the control points")
}

/// Checks that a found point is that at (u, v) of its patch.
fn is_there<S: Sheet>(sheet: &S, Found(patch, found): &Found) -> Checked {
    let patches = sheet.patches();
    let patch = patches.get(*patch).ok_or("no such patch")?;
    let (u, v, range) = (found.u, found.v, 0.0..=1.0);
    ensure!(range.contains(&u) && range.contains(&v), "({u}, {v})");
    let slack = 16.0 * sheet.slack();
    near(found.point, patch.eval(u, v), slack, "the point at (u, v)")
}

pub(crate) fn nearest<S: Sheet>(sheet: S, p: DVec3) -> Checked {
    let (found, patches) = (answer!(sheet.nearest_point(p)), sheet.patches());
    same(found.is_some(), !patches.is_empty(), "a point")?;
    let Some(found) = found else {
        return Ok(());
    };
    is_there(&sheet, &found)?;
    let (slack, got) = (16.0 * sheet.slack(), found.1.distance);
    near(found.1.point.distance(p), got, slack, "the distance")?;
    for patch in &patches {
        let places = locations(if patches.len() > 8 { 6 } else { 12 });
        let closest = from_nearest(p, places.map(|(u, v)| patch.eval(u, v)));
        // Squares of distances are compared, so rounding counts as √ε where both are near zero.
        let square = closest * closest + slack * size();
        at_most(got * got, square, "a sample is nearer")?;
    }
    Ok(())
}

pub(crate) fn intersect_ray<S: Sheet>(sheet: S, origin: DVec3, direction: DVec3) -> Checked {
    let hits = answer!(sheet.hits(origin, direction), "direction|too many");
    let sorted = hits.is_sorted_by(|a, b| a.1.distance <= b.1.distance);
    ensure!(sorted, "the hits are not sorted");
    // The ray is about 1e-14 of the size of patch and origin together wide, and 1e-7 of it where it grazes.
    let width = 1e-7 * (size() + origin.length());
    for hit in &hits {
        is_there(&sheet, hit)?;
        let on_ray = origin + direction.normalize() * hit.1.distance;
        near(on_ray, hit.1.point, width, "the point on the ray")?;
    }
    Ok(())
}
