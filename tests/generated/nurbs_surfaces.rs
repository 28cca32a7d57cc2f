//! Checks of rational patches and NURBS surfaces.

use crate::check::*;
use crate::curves::unit_or_zero;
use crate::geometry::*;
use crate::lines::are_images;
use casteljau::glam::{DAffine3, DMat4, DVec3};
use casteljau::{NurbsCurve, NurbsSurface, Patch, RationalPatch};
use casteljau_generator::NurbsSurfaceData;
use std::f64::consts::TAU;

/// What a map or a part of a surface may be refused for.
const IMAGE: &str = "image|points|net|weights";

finite! {
    // tests/rational/surface.rs
    [] patch_from(patch: Patch): call(|| RationalPatch::from(&patch))?;
    [] patch_partials(patch: RationalPatch, u: f64, v: f64):
        if is_inside(u, v) { call(|| patch.partials(u, v))? } else { patch.partials(u, v) };
    [] patch_curvature(patch: RationalPatch, u: f64, v: f64):
        if is_inside(u, v) { call_unbounded(|| patch.curvature(u, v))? } else { patch.curvature(u, v) };
    [] patch_elevate(patch: RationalPatch): answer!(patch.elevate());
    [] patch_project(patch: RationalPatch, map: DMat4): answer!(patch.project(&map), "projected weights|image|weights");
    [] plane(points: [DVec3; 4]): answer!(NurbsSurface::plane(points[0], points[1], points[2]), "net");
    [] curvature(surface: NurbsSurface, u: f64, v: f64): {
        let [u, v] = inside(&surface, u, v);
        call_unbounded(|| surface.curvature(u, v))?
    };
    [] project(surface: NurbsSurface, map: DMat4): answer!(surface.project(&map), "projected weights|image|weights");
    [] elevate_u(surface: NurbsSurface): answer!(surface.elevate_u());
    [] elevate_v(surface: NurbsSurface): answer!(surface.elevate_v());
    [] loft(curve: NurbsCurve<DVec3>, other: NurbsCurve<DVec3>, degree: usize): {
        let curves = [curve.clone(), other, curve.reverse()];
        answer!(NurbsSurface::loft(&curves, degree), "curves|index of the first curve of another kind|weights in v|net|points|weights|knots")
    };
}

fn is_inside(u: f64, v: f64) -> bool {
    [u, v].iter().all(|t| (0.0..=1.0).contains(t))
}

/// The parameters in the domain that are nearest to u and v.
fn inside(surface: &NurbsSurface, u: f64, v: f64) -> [f64; 2] {
    let ([u0, u1], [v0, v1]) = (surface.domain_u(), surface.domain_v());
    [u.clamp(u0, u1), v.clamp(v0, v1)]
}

/// How much rounding is enlarged by weights; infinite for large ratios.
pub(crate) fn slack_of(weights: &[f64], degrees: [usize; 2]) -> f64 {
    let ratio = max(weights.iter().copied()) / min(weights.iter().copied());
    if ratio > 1e4 {
        return f64::INFINITY;
    }
    ratio * 64.0 * slack(size(), degrees[0]).max(slack(size(), degrees[1]))
}

fn patch_slack(patch: &RationalPatch) -> f64 {
    slack_of(patch.weights(), [patch.degree_u(), patch.degree_v()])
}

fn surface_slack(surface: &NurbsSurface) -> f64 {
    slack_of(surface.weights(), [surface.degree_u(), surface.degree_v()])
}

pub(crate) fn patch_accessors(data: NurbsSurfaceData) -> Checked {
    let [m, n] = data.degrees;
    let patch = answer!(RationalPatch::new(&data.points, &data.weights, m, n));
    same([patch.degree_u(), patch.degree_v()], [m, n], "the degrees")?;
    same(patch.control_points(), &data.points[..], "the points")?;
    same(patch.weights(), &data.weights[..], "the weights")
}

pub(crate) fn patch_approx_eq(patch: RationalPatch, tolerance: f64) -> Checked {
    holds!(
        patch.approx_eq(&patch, tolerance.max(0.0)),
        "not equal to itself"
    )
}

pub(crate) fn patch_eval(patch: RationalPatch, u: f64, v: f64) -> Checked {
    if !is_inside(u, v) {
        let _ = patch.eval(u, v);
        return Ok(());
    }
    let p = value!(patch.eval(u, v));
    let slack = patch_slack(&patch);
    holds!(
        holds(&patch.control_bounds(), p, slack),
        "outside of the box of the control points"
    )
}

pub(crate) fn patch_normal(patch: RationalPatch, u: f64, v: f64) -> Checked {
    if !is_inside(u, v) {
        let _ = patch.normal(u, v);
        return Ok(());
    }
    let normal = call(|| patch.normal(u, v))?;
    unit_or_zero(normal, 1e-9)
}

pub(crate) fn patch_isocurve_at_u(patch: RationalPatch, u: f64) -> Checked {
    let curve = answer!(patch.isocurve_at_u(u), IMAGE);
    let slack = patch_slack(&patch);
    let is_near = |v: f64| near(curve.eval(v), patch.eval(u, v), slack, v);
    if is_inside(u, 0.0) {
        parameters(4, 1.0).try_for_each(is_near)
    } else {
        Ok(())
    }
}

pub(crate) fn patch_isocurve_at_v(patch: RationalPatch, v: f64) -> Checked {
    let curve = answer!(patch.isocurve_at_v(v), IMAGE);
    let slack = patch_slack(&patch);
    let is_near = |u: f64| near(curve.eval(u), patch.eval(u, v), slack, u);
    if is_inside(0.0, v) {
        parameters(4, 1.0).try_for_each(is_near)
    } else {
        Ok(())
    }
}

pub(crate) fn patch_split_u(patch: RationalPatch, u: f64) -> Checked {
    let (before, after) = answer!(patch.split_u(u), IMAGE);
    same(
        before.isocurve_at_u(1.0)?,
        after.isocurve_at_u(0.0)?,
        "the edge between the parts",
    )?;
    let slack = patch_slack(&patch);
    if !is_inside(u, 0.0) {
        return Ok(());
    }
    near(
        before.eval(0.5, 0.5),
        patch.eval(0.5 * u, 0.5),
        slack,
        "before u",
    )?;
    near(
        after.eval(0.5, 0.5),
        patch.eval(u + 0.5 * (1.0 - u), 0.5),
        slack,
        "after u",
    )
}

pub(crate) fn patch_split_v(patch: RationalPatch, v: f64) -> Checked {
    let (before, after) = answer!(patch.split_v(v), IMAGE);
    same(
        before.isocurve_at_v(1.0)?,
        after.isocurve_at_v(0.0)?,
        "the edge between the parts",
    )?;
    let slack = patch_slack(&patch);
    if !is_inside(0.0, v) {
        return Ok(());
    }
    near(
        before.eval(0.5, 0.5),
        patch.eval(0.5, 0.5 * v),
        slack,
        "before v",
    )?;
    near(
        after.eval(0.5, 0.5),
        patch.eval(0.5, v + 0.5 * (1.0 - v)),
        slack,
        "after v",
    )
}

pub(crate) fn patch_transform(patch: RationalPatch, map: DAffine3) -> Checked {
    let image = answer!(patch.transform(&map), "image");
    are_images(patch.control_points(), image.control_points(), &map)?;
    same(image.weights(), patch.weights(), "the weights")
}

pub(crate) fn patch_bounds(patch: RationalPatch) -> Checked {
    let bounds = value!(patch.bounds());
    let outer = patch.control_bounds();
    let slack = patch_slack(&patch);
    let outside = locations(6).find(|&(u, v)| !holds(&bounds, patch.eval(u, v), slack));
    ensure!(outside.is_none(), "the point at {outside:?} is outside");
    let is_within = holds(&outer, bounds.min, 0.0) && holds(&outer, bounds.max, 0.0);
    holds!(is_within, "larger than the box of the control points")
}

pub(crate) fn accessors(data: NurbsSurfaceData) -> Checked {
    let ([m, n], [u, v]) = (data.degrees, &data.knots);
    let surface = answer!(NurbsSurface::new(
        m,
        n,
        &data.points,
        Some(&data.weights),
        u,
        v
    ));
    same(
        [surface.degree_u(), surface.degree_v()],
        [m, n],
        "the degrees",
    )?;
    same(surface.control_points(), &data.points[..], "the points")?;
    same(surface.weights(), &data.weights[..], "the weights")?;
    same(
        [surface.knots_u(), surface.knots_v()],
        [&u[..], &v[..]],
        "the knots",
    )?;
    let joints = [surface.joints_u(), surface.joints_v()];
    let ends = joints.map(|joints| [joints[0], joints[joints.len() - 1]]);
    same([surface.domain_u(), surface.domain_v()], ends, "the domain")?;
    let patches = (joints[0].len() - 1) * (joints[1].len() - 1);
    same(surface.patches().len(), patches, "the number of patches")
}

pub(crate) fn approx_eq(surface: NurbsSurface, tolerance: f64) -> Checked {
    call(|| surface.approx_eq(&surface.reverse(), tolerance))?;
    holds!(surface.approx_eq(&surface, 0.0), "not equal to itself")
}

/// The length of a vector, without squares, which underflow for small ones.
fn length_of(vector: DVec3) -> f64 {
    vector.x.hypot(vector.y).hypot(vector.z)
}

/// Checks the points of a surface by their distances from an axis and along it.
fn is_around(
    surface: &NurbsSurface,
    [center, axis]: [DVec3; 2],
    check: impl Fn([f64; 2], f64, f64) -> Checked,
) -> Checked {
    let axis = (axis / axis.abs().max_element()).normalize();
    let points = surface.control_points().iter();
    let slack = 64.0 * slack(max(points.map(|p| p.abs().max_element())), 2);
    for (u, v) in locations(4) {
        let from_center = surface.eval(u, v) - center;
        let along = from_center.dot(axis);
        check([length_of(from_center - axis * along), along], v, slack)?;
    }
    Ok(())
}

const SHAPE: &str = "radius|axis|height|major_radius|minor_radius|points|net|image";

pub(crate) fn sphere(points: [DVec3; 4], radius: f64) -> Checked {
    let surface = answer!(NurbsSurface::sphere(points[0], radius, points[1]), SHAPE);
    let largest = points[0].abs().max_element() + radius;
    for (u, v) in locations(4) {
        near(
            length_of(surface.eval(u, v) - points[0]),
            radius,
            64.0 * slack(largest, 2),
            format_args!("({u}, {v})"),
        )?;
    }
    Ok(())
}

pub(crate) fn cylinder(points: [DVec3; 4], radius: f64, height: f64) -> Checked {
    let surface = answer!(
        NurbsSurface::cylinder(points[0], radius, height, points[1]),
        SHAPE
    );
    is_around(
        &surface,
        [points[0], points[1]],
        |[distance, along], v, slack| {
            near(distance, radius, slack, v)?;
            near(along, height * v, slack, v)
        },
    )
}

pub(crate) fn cone(points: [DVec3; 4], radius: f64, height: f64) -> Checked {
    let surface = answer!(
        NurbsSurface::cone(points[0], radius, height, points[1]),
        SHAPE
    );
    is_around(
        &surface,
        [points[0], points[1]],
        |[distance, along], v, slack| {
            near(distance, radius * (1.0 - v), slack, v)?;
            near(along, height * v, slack, v)
        },
    )
}

pub(crate) fn torus(points: [DVec3; 4], major: f64, minor: f64) -> Checked {
    let surface = answer!(
        NurbsSurface::torus(points[0], major, minor, points[1]),
        SHAPE
    );
    is_around(
        &surface,
        [points[0], points[1]],
        |[distance, along], v, slack| near((distance - major).hypot(along), minor, slack, v),
    )
}

/// What a curve may be refused for when its degree and knots are brought to those of another one.
const UNITED: &str = "ts|knots|points|image|net|weights|degree";

pub(crate) fn ruled(curve: NurbsCurve<DVec3>, other: NurbsCurve<DVec3>) -> Checked {
    let surface = answer!(NurbsSurface::ruled(&curve, &other), UNITED);
    same(
        [surface.domain_u(), surface.domain_v()],
        [[0.0, 1.0]; 2],
        "the domain",
    )
}

pub(crate) fn extrude(curve: NurbsCurve<DVec3>, vector: DVec3) -> Checked {
    let surface = answer!(NurbsSurface::extrude(&curve, vector), UNITED);
    let [from, to] = curve.domain();
    let slack = slack_of(curve.weights(), [curve.degree(), 1])
        + 64.0 * slack(vector.abs().max_element(), 1);
    parameters(4, 1.0).try_for_each(|u| {
        let p = curve.eval(from * (1.0 - u) + to * u);
        near(surface.eval(u, 0.5), p + vector * 0.5, slack, u)
    })
}

pub(crate) fn revolve(curve: NurbsCurve<DVec3>, origin: DVec3, axis: DVec3, angle: f64) -> Checked {
    let angle = TAU * (2.0 * angle - 1.0);
    let surface = answer!(
        NurbsSurface::revolve(&curve, origin, axis, angle),
        "axis|t where the profile meets the axis|points|net|image|weights"
    );
    same(surface.domain_v(), curve.domain(), "the domain")?;
    let slack = slack_of(curve.weights(), [curve.degree(), 2])
        + 64.0 * slack(origin.abs().max_element(), 2);
    let [from, to] = curve.domain();
    parameters(4, 1.0).try_for_each(|s| {
        let t = from * (1.0 - s) + to * s;
        near(surface.eval(0.0, t), curve.eval(t), slack, t)
    })
}

pub(crate) fn eval(surface: NurbsSurface, u: f64, v: f64) -> Checked {
    let [u, v] = inside(&surface, u, v);
    let p = value!(surface.eval(u, v));
    let slack = surface_slack(&surface);
    holds!(
        holds(&surface.control_bounds(), p, slack),
        "outside of the box of the control points"
    )
}

pub(crate) fn partials(surface: NurbsSurface, u: f64, v: f64) -> Checked {
    let [u, v] = inside(&surface, u, v);
    call(|| surface.partials(u, v))?;
    Ok(())
}

pub(crate) fn normal(surface: NurbsSurface, u: f64, v: f64) -> Checked {
    let [u, v] = inside(&surface, u, v);
    let normal = call(|| surface.normal(u, v))?;
    unit_or_zero(normal, 1e-9)
}

pub(crate) fn isocurve_at_u(surface: NurbsSurface, u: f64) -> Checked {
    let curve = answer!(surface.isocurve_at_u(u), "u");
    let ([from, to], slack) = (curve.domain(), surface_slack(&surface));
    same([from, to], surface.domain_v(), "the domain")?;
    let v = 0.5 * (from + to);
    near(curve.eval(v), surface.eval(u, v), slack, v)
}

pub(crate) fn isocurve_at_v(surface: NurbsSurface, v: f64) -> Checked {
    let curve = answer!(surface.isocurve_at_v(v), "v");
    let ([from, to], slack) = (curve.domain(), surface_slack(&surface));
    same([from, to], surface.domain_u(), "the domain")?;
    let u = 0.5 * (from + to);
    near(curve.eval(u), surface.eval(u, v), slack, u)
}

/// Checks that a surface has the points of another one at equal parameters.
fn has_same_points(surface: &NurbsSurface, other: &NurbsSurface) -> Checked {
    let slack = surface_slack(surface);
    let ([u0, u1], [v0, v1]) = (surface.domain_u(), surface.domain_v());
    for (s, t) in locations(3) {
        let (u, v) = (u0 * (1.0 - s) + u1 * s, v0 * (1.0 - t) + v1 * t);
        near(
            other.eval(u, v),
            surface.eval(u, v),
            slack,
            format_args!("({u}, {v})"),
        )?;
    }
    Ok(())
}

pub(crate) fn split_u(surface: NurbsSurface, u: f64) -> Checked {
    let (before, after) = answer!(surface.split_u(u), "u");
    same(
        [before.domain_u()[1], after.domain_u()[0]],
        [u; 2],
        "the domains",
    )?;
    near(
        before.eval(u, surface.domain_v()[0]),
        surface.eval(u, surface.domain_v()[0]),
        surface_slack(&surface),
        "the edge",
    )
}

pub(crate) fn split_v(surface: NurbsSurface, v: f64) -> Checked {
    let (before, after) = answer!(surface.split_v(v), "v");
    same(
        [before.domain_v()[1], after.domain_v()[0]],
        [v; 2],
        "the domains",
    )?;
    near(
        after.eval(surface.domain_u()[0], v),
        surface.eval(surface.domain_u()[0], v),
        surface_slack(&surface),
        "the edge",
    )
}

pub(crate) fn insert_knot_u(surface: NurbsSurface, u: f64, times: usize) -> Checked {
    let finer = answer!(surface.insert_knot_u(u, times), "u|times");
    has_same_points(&surface, &finer)
}

pub(crate) fn insert_knot_v(surface: NurbsSurface, v: f64, times: usize) -> Checked {
    let finer = answer!(surface.insert_knot_v(v, times), "v|times");
    has_same_points(&surface, &finer)
}

pub(crate) fn reverse(surface: NurbsSurface) -> Checked {
    let reversed = value!(surface.reverse());
    same(reversed.domain_u(), surface.domain_u(), "the domain")?;
    let twice = reversed.reverse();
    same(
        twice.control_points(),
        surface.control_points(),
        "twice backwards",
    )
}

pub(crate) fn transform(surface: NurbsSurface, map: DAffine3) -> Checked {
    let image = answer!(surface.transform(&map), "image");
    are_images(surface.control_points(), image.control_points(), &map)?;
    same(image.weights(), surface.weights(), "the weights")
}

pub(crate) fn box_of_surface(surface: NurbsSurface) -> Checked {
    let bounds = value!(surface.bounds());
    let outer = surface.control_bounds();
    let slack = surface_slack(&surface);
    let ([u0, u1], [v0, v1]) = (surface.domain_u(), surface.domain_v());
    for (s, t) in locations(4) {
        let p = surface.eval(u0 * (1.0 - s) + u1 * s, v0 * (1.0 - t) + v1 * t);
        ensure!(
            holds(&bounds, p, slack),
            "the point at ({s}, {t}) is outside"
        );
    }
    let is_within = holds(&outer, bounds.min, slack) && holds(&outer, bounds.max, slack);
    holds!(is_within, "larger than the box of the control points")
}

pub(crate) fn to_surface(surface: NurbsSurface) -> Checked {
    let patches: Vec<RationalPatch> =
        answer!(surface.to_surface().map(|all| all.patches().collect()));
    same(&patches[..], surface.patches(), "the patches")
}
