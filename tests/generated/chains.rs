//! Chains of two or three operations, whose results satisfy what constructors demand and can be asked everything.

use crate::arguments::*;
use crate::check::*;
use crate::numbers::Numbers;
use crate::runner::Row;
use casteljau::glam::{DVec2, DVec3};
use casteljau::mesh::TessellationOptions;
use casteljau::path::{FillRule, OffsetOptions, StrokeOptions};
use casteljau::spline::JointMode;
use casteljau::{Curve, Patch, Spline};
use casteljau_generator::{Case, Rng};

pub(crate) const ROWS: &[Row] = &[
    ("Curve::chain", both!(curve_chain)),
    ("Spline::chain", both!(spline_chain)),
    ("Path::chain", path_chain),
    ("Patch::chain", patch_chain),
    ("Surface::chain", surface_chain),
];

/// The operations of a chain and the random numbers that choose them.
struct Chain {
    rng: Rng,
    left: usize,
    names: Vec<&'static str>,
}

impl Chain {
    fn new(case: &Case) -> Self {
        let mut rng = Rng::for_case(case.seed, "chain", case.number);
        let left = 2 + rng.below(2);
        Self {
            rng,
            left,
            names: Vec::new(),
        }
    }

    /// The number of the next operation; `None` at the end.
    fn next(&mut self, count: usize) -> Option<usize> {
        self.left = self.left.checked_sub(1)?;
        Some(self.rng.below(count))
    }
}

/// Makes a call whose answer may be infinite, but holds no NaN.
fn ask<T: Numbers>(case: &Case, chain: &Chain, name: &str, act: impl FnOnce() -> T) -> Checked {
    match call_unbounded(case, act) {
        Ok(_) => Ok(()),
        Err(message) => Err(format!("{name} after {:?}: {message}", chain.names)),
    }
}

/// The next value of a chain: the result of an operation, or the value as it was if the operation refuses.
fn or<T, E>(result: Result<T, E>, value: T) -> T {
    result.unwrap_or(value)
}

fn curve_chain<P: Space>(case: &Case) -> Checked {
    let (map, t) = (affine::<P>(case, "map"), number(case, "t"));
    let (mut value, other) = (curve::<P>(case, "curve"), curve::<P>(case, "other"));
    let mut chain = Chain::new(case);
    while let Some(operation) = chain.next(8) {
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            2 => ("elevate", or(value.elevate(), value)),
            3 => ("reduce", value.reduce().curve),
            4 => ("derivative", value.derivative()),
            5 => ("split", value.split(t).1),
            6 => ("subsegment", value.subsegment(t, 1.0 - t)),
            _ => ("halve", value.halve().0),
        };
        chain.names.push(name);
        let valid = Curve::new(next.control_points());
        ensure!(valid.is_ok(), "{:?}: {:?}", chain.names, valid.err());
        value = next;
    }
    let tolerance = 1e-3
        * value
            .control_points()
            .iter()
            .fold(1e-300, |m: f64, p| m.max(p.max_abs()));
    ask(case, &chain, "eval", || value.eval(t))?;
    ask(case, &chain, "bounds", || value.bounds())?;
    ask(case, &chain, "length", || value.length(None))?;
    ask(case, &chain, "tangent", || value.tangent(t))?;
    ask(case, &chain, "curvature", || value.curvature(t))?;
    ask(case, &chain, "nearest", || value.nearest(other.start()))?;
    ask(case, &chain, "distance_to", || value.distance_to(&other))?;
    ask(case, &chain, "hausdorff", || value.hausdorff(&other))?;
    ask(case, &chain, "flatten", || value.flatten(tolerance))?;
    ask(case, &chain, "extrema", || value.extrema(0))?;
    ask(case, &chain, "cusps", || value.cusps())?;
    ask(case, &chain, "time_at_length", || {
        value.time_at_length(tolerance, None)
    })?;
    let [plane, second] = [&value, &other].map(flat);
    ask(case, &chain, "self_intersections", || {
        plane.self_intersections()
    })?;
    ask(case, &chain, "intersections", || {
        plane.intersections(&second)
    })?;
    ask(case, &chain, "inflections", || plane.inflections())?;
    ask(case, &chain, "area", || plane.area())?;
    ask(case, &chain, "hull", || plane.hull())?;
    ask(case, &chain, "offset", || {
        plane.offset(tolerance, None).map(|_| ())
    })
}

/// The projection of a curve along z.
fn flat<P: Space>(curve: &Curve<P>) -> Curve<DVec2> {
    let points: Vec<DVec2> = curve.control_points().iter().map(|p| p.to_2d()).collect();
    Curve::new(&points).expect("finite points")
}

fn is_valid<P: Space>(spline: &Spline<P>, names: &[&str]) -> Checked {
    let points = spline.control_points();
    let valid = Spline::with_degrees(points.to_vec(), &spline.degrees(), spline.is_closed());
    ensure!(valid.is_ok(), "{names:?}: {:?}", valid.err());
    Ok(())
}

fn spline_chain<P: Space>(case: &Case) -> Checked {
    let (map, t, p) = (
        affine::<P>(case, "map"),
        number(case, "t"),
        point::<P>(case, "p"),
    );
    let mut value = spline::<P>(case, "spline");
    let mut chain = Chain::new(case);
    let modes = [JointMode::Free, JointMode::C1, JointMode::G1, JointMode::C2];
    while let Some(operation) = chain.next(11) {
        let index = chain.rng.below(value.control_points().len());
        let joint = chain.rng.below(value.segment_count() + 1);
        let mode = chain.rng.pick(&modes);
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            2 => ("split", value.split(t).0),
            3 => ("subsegment", value.subsegment(t, 1.0 - t)),
            4 => ("insert", or(value.insert(t), value)),
            5 => ("remove", or(value.remove(joint), value)),
            6 => (
                "move_point",
                or(value.move_point(index, p, |_| mode), value),
            ),
            7 => ("set_joint", or(value.set_joint(joint, mode), value)),
            8 => (
                "interpolate",
                or(
                    Spline::interpolate(
                        value.control_points(),
                        Default::default(),
                        value.is_closed(),
                    ),
                    value,
                ),
            ),
            9 => ("append", or(value.append(p), value)),
            _ => (
                "from_bspline",
                or(
                    Spline::from_bspline(value.control_points(), 2, None, value.is_closed()),
                    value,
                ),
            ),
        };
        chain.names.push(name);
        is_valid(&next, &chain.names)?;
        value = next;
    }
    let tolerance = 1e-3
        * value
            .control_points()
            .iter()
            .fold(1e-300, |m: f64, p| m.max(p.max_abs()));
    ask(case, &chain, "bounds", || value.bounds())?;
    ask(case, &chain, "length", || value.length(None))?;
    ask(case, &chain, "nearest", || value.nearest(p))?;
    ask(case, &chain, "flatten", || value.flatten(tolerance))?;
    ask(case, &chain, "continuity", || {
        value.continuity(1, None).map(|_| ())
    })?;
    ask(case, &chain, "time_at_length", || {
        value.time_at_length(tolerance, None)
    })
}

fn path_chain(case: &Case) -> Checked {
    let (map, width) = (affine::<DVec2>(case, "map"), number(case, "width").abs());
    let (mut value, other) = (path(case, "path"), path(case, "other"));
    let mut chain = Chain::new(case);
    let rule = FillRule::EvenOdd;
    while let Some(operation) = chain.next(8) {
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            2 => ("union", or(value.union(&other, rule), value)),
            3 => (
                "stroke",
                or(value.stroke(width, &StrokeOptions::default()), value),
            ),
            4 => (
                "offset",
                or(value.offset(width, &OffsetOptions::default()), value),
            ),
            5 => ("dash", or(value.dash(&[width, 2.0 * width], 0.0), value)),
            6 => ("clip", or(value.clip(&other, rule), value)),
            _ => ("round_corners", or(value.round_corners(width), value)),
        };
        chain.names.push(name);
        for spline in next.subpaths() {
            is_valid(&spline, &chain.names)?;
        }
        value = next;
        if value.segment_count() > 2_000 {
            break;
        }
    }
    let p = other
        .subpath(0)
        .map_or(DVec2::ONE, |spline| spline.control_points()[0]);
    ask(case, &chain, "bounds", || value.bounds())?;
    ask(case, &chain, "length", || value.length(None))?;
    ask(case, &chain, "nearest", || value.nearest(p))?;
    ask(case, &chain, "self_intersections", || {
        value.self_intersections()
    })?;
    ask(case, &chain, "intersections", || {
        value.intersections(&other)
    })?;
    ask(case, &chain, "winding_number", || value.winding_number(p))?;
    ask(case, &chain, "filled_area", || value.filled_area(rule))?;
    let svg = or(value.to_svg(None, None), String::new());
    ensure!(
        !svg.contains("NaN") && !svg.contains("inf"),
        "{:?}: {svg}",
        chain.names
    );
    Ok(())
}

fn patch_chain(case: &Case) -> Checked {
    let (map, t, p) = (
        affine::<DVec3>(case, "map"),
        number(case, "t"),
        point::<DVec3>(case, "p"),
    );
    let mut value = patch(case);
    let mut chain = Chain::new(case);
    while let Some(operation) = chain.next(6) {
        let index = chain.rng.below(value.control_points().len());
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            2 => ("elevate", or(value.elevate(), value)),
            3 => ("split_u", value.split_u(t).1),
            4 => ("split_v", value.split_v(t).0),
            _ => ("move_point", or(value.move_point(index, p), value)),
        };
        chain.names.push(name);
        let valid = Patch::new(next.control_points(), next.degree_u(), next.degree_v());
        ensure!(valid.is_ok(), "{:?}: {:?}", chain.names, valid.err());
        value = next;
    }
    let line = value.isocurve_at_u(t);
    let valid = Curve::new(line.control_points());
    ensure!(
        valid.is_ok(),
        "{:?}, isocurve: {:?}",
        chain.names,
        valid.err()
    );
    ask(case, &chain, "eval", || value.eval(t, 0.5))?;
    ask(case, &chain, "normal", || value.normal(t, 0.5))?;
    ask(case, &chain, "bounds", || value.bounds())?;
    ask(case, &chain, "nearest", || value.nearest(p))?;
    ask(case, &chain, "area", || value.area())?;
    ask(case, &chain, "intersect_ray", || {
        value.intersect_ray(p, DVec3::Y)
    })
}

fn surface_chain(case: &Case) -> Checked {
    let (map, p) = (affine::<DVec3>(case, "map"), point::<DVec3>(case, "p"));
    let mut value = surface(case);
    let mut chain = Chain::new(case);
    while let Some(operation) = chain.next(3) {
        let index = chain.rng.below(value.vertices().len().max(1));
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            _ => ("move_point", or(value.move_point(index, p), value)),
        };
        chain.names.push(name);
        let finite = next.vertices().iter().all(|v| v.is_finite());
        ensure!(finite, "{:?}: a vertex is not finite", chain.names);
        value = next;
    }
    let size = value
        .vertices()
        .iter()
        .fold(1e-300, |m: f64, v| m.max(v.abs().max_element()));
    ask(case, &chain, "bounds", || value.bounds())?;
    ask(case, &chain, "area", || value.area())?;
    ask(case, &chain, "volume", || value.volume())?;
    ask(case, &chain, "nearest", || value.nearest(p))?;
    ask(case, &chain, "tessellate", || {
        value
            .tessellate(&TessellationOptions::tolerance(0.1 * size))
            .map(|_| ())
    })
}
