//! Chains of two or three operations, whose results satisfy what constructors demand and can be asked everything.

use crate::arguments::Space;
use crate::check::*;
use crate::geometry::largest;
use casteljau::glam::{DAffine2, DAffine3, DVec2, DVec3};
use casteljau::mesh::TessellationOptions;
use casteljau::path::{FillRule, OffsetOptions, StrokeOptions};
use casteljau::spline::{Interpolation, JointMode};
use casteljau::{Curve, Error, Patch, Path, RationalSurface, Spline, Surface};
use casteljau_generator::{Rng, changed};

/// The operations of a chain and the random numbers that choose them.
struct Chain {
    rng: Rng,
    left: usize,
    names: Vec<&'static str>,
}

impl Chain {
    fn new() -> Self {
        let (seed, number) = seed_and_number();
        let mut rng = Rng::for_case(seed, "chain", number);
        let (left, names) = (2 + rng.below(2), Vec::new());
        Self { rng, left, names }
    }

    /// The number of the next operation; `None` at the end.
    fn next(&mut self, count: usize) -> Option<usize> {
        self.left = self.left.checked_sub(1)?;
        Some(self.rng.below(count))
    }

    /// Records an operation and what the constructor says to its result.
    fn record<T>(&mut self, name: &'static str, made: Result<T, Error>) -> Checked {
        self.names.push(name);
        let error = made.err().map(|error| error.to_string());
        same(error, None, format_args!("{:?}", self.names))
    }
}

/// Makes calls whose answers may be infinite, but hold no NaN.
macro_rules! ask {
    ($chain:expr, $value:expr, $($name:ident($($argument:expr),*))*) => {$(
        if let Err(Failure(message)) = call_unbounded(|| $value.$name($($argument),*)) {
            let name = stringify!($name);
            return Err(format!("{name} after {:?}: {message}", $chain.names).into());
        }
    )*};
}

/// The next value of a chain: the result of an operation, or the value as it was if the operation refuses.
fn or<T, E>(result: Result<T, E>, value: T) -> T {
    result.unwrap_or(value)
}

/// A tolerance for coordinates of the size of the points.
fn tolerance_of<P: Space>(points: &[P], part: f64) -> f64 {
    part * largest(points).max(1e-300)
}

pub(crate) fn curve<P: Space>(
    mut value: Curve<P>,
    map: P::Affine,
    t: f64,
    other: Curve<P>,
) -> Checked {
    let mut chain = Chain::new();
    while let Some(operation) = chain.next(8) {
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            2 => ("elevate", or(value.elevate(), value)),
            3 => ("reduce", value.reduce().curve),
            4 => ("derivative", value.derivative()),
            5 => ("split", value.split(t).1),
            6 => ("subsegment", value.subsegment(t..1.0 - t)),
            _ => ("halve", value.halve().0),
        };
        chain.record(name, Curve::new(next.control_points()))?;
        value = next;
    }
    let tolerance = tolerance_of(value.control_points(), 1e-3);
    ask! { chain, value,
        eval(t) bounds() length() tangent(t) curvature(t) nearest(other.start()) distance_to(&other)
        hausdorff(&other) flatten(tolerance) extrema(0) cusps() time_at_length(tolerance)
    }
    // The projections along z.
    let [plane, second] = [&value, &other].map(|curve| {
        let points: Vec<DVec2> = curve.control_points().iter().map(|p| p.to_2d()).collect();
        Curve::new(&points).expect("finite points")
    });
    ask! { chain, plane,
        self_intersections() intersections(&second) inflections() area() hull() offset(tolerance)
    }
    Ok(())
}

/// What the constructor says to the data of a spline.
fn remade<P: Space>(spline: &Spline<P>) -> Result<Spline<P>, Error> {
    let points = spline.control_points().to_vec();
    Spline::with_degrees(points, &spline.degrees(), spline.is_closed())
}

pub(crate) fn spline<P: Space>(mut value: Spline<P>, map: P::Affine, t: f64, p: P) -> Checked {
    let mut chain = Chain::new();
    let modes = [JointMode::Free, JointMode::C1, JointMode::G1, JointMode::C2];
    while let Some(operation) = chain.next(11) {
        let index = chain.rng.below(value.control_points().len());
        let joint = chain.rng.below(value.segment_count() + 1);
        let mode = chain.rng.pick(&modes);
        let (points, closed) = (value.control_points(), value.is_closed());
        let (name, result) = match operation {
            0 | 1 => ("transform", value.transform(&map)),
            2 => ("split", Ok(value.split(t).0)),
            3 => ("subsegment", Ok(value.subsegment(t..1.0 - t))),
            4 => ("insert", value.insert(t)),
            5 => ("remove", value.remove(joint)),
            6 => (
                "move_point",
                changed(&value, |s| s.move_point(index, p, |_| mode)),
            ),
            7 => ("set_joint", value.set_joint(joint, mode)),
            8 => {
                let kind = Interpolation::default();
                ("interpolate", Spline::interpolate(points, kind, closed))
            }
            9 => ("append", value.append(p)),
            _ => ("b-spline", Spline::from_bspline(points, 2, None, closed)),
        };
        value = or(result, value);
        chain.record(name, remade(&value))?;
    }
    let tolerance = tolerance_of(value.control_points(), 1e-3);
    ask! { chain, value,
        bounds() length() nearest(p) flatten(tolerance) continuity(1)
        time_at_length(tolerance)
    }
    Ok(())
}

pub(crate) fn path(mut value: Path, map: DAffine2, other: Path, width: f64) -> Checked {
    let (mut chain, rule, width) = (Chain::new(), FillRule::EvenOdd, width.abs());
    while let Some(operation) = chain.next(8) {
        let (name, result) = match operation {
            0 | 1 => ("transform", value.transform(&map)),
            2 => ("union", value.union(&other, rule)),
            3 => ("stroke", value.stroke(width, &StrokeOptions::default())),
            4 => ("offset", value.offset(width, &OffsetOptions::default())),
            5 => ("dash", value.dash(&[width, 2.0 * width], 0.0)),
            6 => ("clip", value.clip(&other, rule)),
            _ => ("round_corners", value.round_corners(width)),
        };
        value = or(result, value);
        let remade: Result<Vec<_>, _> = value.subpaths().map(|spline| remade(&spline)).collect();
        chain.record(name, remade)?;
        if value.segment_count() > 2_000 {
            break;
        }
    }
    let first = other.segments().next();
    let p = first.map_or(DVec2::ONE, |curve| curve.start());
    ask! { chain, value,
        bounds() length() nearest(p) self_intersections() intersections(&other) winding_number(p)
        filled_area(rule)
    }
    let svg = value.to_svg();
    let finite = !svg.contains("NaN") && !svg.contains("inf");
    holds!(finite, "{:?}: {svg}", chain.names)
}

pub(crate) fn patch(mut value: Patch, map: DAffine3, t: f64, p: DVec3) -> Checked {
    let mut chain = Chain::new();
    while let Some(operation) = chain.next(6) {
        let index = chain.rng.below(value.control_points().len());
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            2 => ("elevate", or(value.elevate(), value)),
            3 => ("split_u", value.split_u(t).1),
            4 => ("split_v", value.split_v(t).0),
            _ => (
                "move_point",
                or(changed(&value, |s| s.move_point(index, p)), value),
            ),
        };
        let [m, n] = [next.degree_u(), next.degree_v()];
        chain.record(name, Patch::new(next.control_points(), m, n))?;
        value = next;
    }
    let line = value.isocurve_at_u(t);
    chain.record("isocurve", Curve::new(line.control_points()))?;
    ask! { chain, value,
        eval(t, 0.5) normal(t, 0.5) bounds() nearest(p) area() intersect_ray(p, DVec3::Y)
    }
    Ok(())
}

pub(crate) fn surface(mut value: Surface, map: DAffine3, p: DVec3) -> Checked {
    let mut chain = Chain::new();
    while let Some(operation) = chain.next(3) {
        let index = chain.rng.below(value.vertices().len().max(1));
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            _ => (
                "move_point",
                or(changed(&value, |s| s.move_point(index, p)), value),
            ),
        };
        chain.names.push(name);
        let finite = next.vertices().iter().all(|v| v.is_finite());
        ensure!(finite, "{:?}: a vertex is not finite", chain.names);
        value = next;
    }
    let options = TessellationOptions::tolerance(tolerance_of(value.vertices(), 0.1));
    ask! { chain, value,
        bounds() area() volume() nearest(p) tessellate(&options)
    }
    Ok(())
}

pub(crate) fn rational_surface(mut value: RationalSurface, map: DAffine3, p: DVec3) -> Checked {
    let mut chain = Chain::new();
    while let Some(operation) = chain.next(3) {
        let index = chain.rng.below(value.vertices().len().max(1));
        let (name, next) = match operation {
            0 | 1 => ("transform", or(value.transform(&map), value)),
            _ => (
                "move_point",
                or(changed(&value, |s| s.move_point(index, p)), value),
            ),
        };
        chain.names.push(name);
        let finite = next.vertices().iter().all(|v| v.is_finite());
        ensure!(finite, "{:?}: a vertex is not finite", chain.names);
        value = next;
    }
    let options = TessellationOptions::tolerance(tolerance_of(value.vertices(), 0.1));
    ask! { chain, value,
        bounds() area() volume() nearest(p) intersect_ray(p, DVec3::Y) tessellate(&options)
    }
    Ok(())
}
