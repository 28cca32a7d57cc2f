//! Access to all numbers of a result, whatever its type. A text or a kind counts as the number of its hash, so that two
//! results can be compared by their numbers.

use crate::shared::Found;
use casteljau::curve::*;
use casteljau::glam::{DVec2, DVec3};
use casteljau::mesh::*;
use casteljau::patch::*;
use casteljau::path::{
    CircularArc, Face, InkChanges, InkStroke, PathElement, PathIntersection, PathPoint, PathTime,
};
use casteljau::spline::*;
use casteljau::surface::*;
use casteljau::{
    Curve, EllipticalArc, Error, NurbsCurve, NurbsSurface, Path, Point, RationalCurve,
    RationalPatch, RationalSurface, Spline,
};
use std::fmt::Debug;
use std::hash::{DefaultHasher, Hasher};

/// A hash of 32 bits, which f64 holds exactly.
fn hash(value: &impl Debug) -> f64 {
    let mut hasher = DefaultHasher::new();
    hasher.write(format!("{value:?}").as_bytes());
    (hasher.finish() >> 32) as f64
}

/// A value that contains numbers.
pub(crate) trait Numbers {
    /// Calls `see` with each number.
    fn visit(&self, see: &mut dyn FnMut(f64));
}

/// Implements `Numbers` for a type and the name of its value by an expression.
macro_rules! numbers {
    ($([$($generic:tt)*] $type:ty, $value:ident, $see:ident => $visit:expr;)*) => {$(
        impl<$($generic)*> Numbers for $type {
            fn visit(&self, $see: &mut dyn FnMut(f64)) {
                let $value = self;
                $visit;
            }
        }
    )*};
}

/// Implements `Numbers` by fields; a type without numbers has none.
macro_rules! by_fields {
    ($([$($generic:tt)*] $type:ty { $($field:tt)* };)*) => {
        numbers! {$([$($generic)*] $type, _value, _see => { $(_value.$field.visit(_see);)* };)*}
    };
}

/// Implements `Numbers` by a method that gives other values with numbers.
macro_rules! by_method {
    ($([$($generic:tt)*] $type:ty: $method:ident;)*) => {
        numbers! {$([$($generic)*] $type, value, see => value.$method().visit(see);)*}
    };
}

numbers! {
    [] f64, x, see => see(*x);
    [] f32, x, see => see(f64::from(*x));
    [] bool, x, see => see(f64::from(u8::from(*x)));
    [] u8, x, see => see(f64::from(*x));
    [] i32, x, see => see(f64::from(*x));
    [] u32, x, see => see(f64::from(*x));
    [] usize, x, see => see(*x as f64);
    [] String, text, see => see(hash(text));
    [] CurveKind, kind, see => see(hash(kind));
    [] Topology, topology, see => see(hash(topology));
    [] EdgeUse, edge, see => see(hash(edge));
    [T: Numbers] [T], items, see => items.iter().for_each(|item| item.visit(see));
    [T: Numbers] Option<T>, item, see => item.as_slice().visit(see);
    [T: Numbers, E: Debug] Result<T, E>, item, see => match item {
        Ok(item) => item.visit(see),
        Err(error) => see(hash(error)),
    };
    [] Path, path, see => path.subpaths().for_each(|spline| spline.visit(see));
    [P: Point + Numbers] RationalCurve<P>, curve, see => {
        curve.control_points().visit(see);
        curve.weights().visit(see);
    };
    [P: Point + Numbers] NurbsCurve<P>, curve, see => {
        curve.control_points().visit(see);
        [curve.weights(), curve.knots()].iter().for_each(|numbers| numbers.visit(see));
    };
    [] RationalPatch, patch, see => {
        patch.control_points().visit(see);
        patch.weights().visit(see);
    };
    [] RationalSurface, surface, see => {
        surface.vertices().visit(see);
        surface.weights().visit(see);
    };
    [] NurbsSurface, surface, see => {
        surface.control_points().visit(see);
        let numbers = [surface.weights(), surface.knots_u(), surface.knots_v()];
        numbers.iter().for_each(|numbers| numbers.visit(see));
    };
    [] IntersectionKind, kind, see => if let IntersectionKind::Overlap { t_end, u_end } = kind {
        [*t_end, *u_end].visit(see);
    };
    [T: Numbers] Mesh<T>, mesh, see => {
        [&mesh.positions, &mesh.normals].into_iter().for_each(|numbers| numbers.visit(see));
        mesh.uvs.visit(see);
        mesh.indices.iter().for_each(|index| index.visit(see));
    };
    [] PathElement, element, see => match *element {
        PathElement::MoveTo(p) | PathElement::LineTo(p) => p.visit(see),
        PathElement::QuadTo(p1, p) => [p1, p].visit(see),
        PathElement::CubicTo(p1, p2, p) => [p1, p2, p].visit(see),
        PathElement::Close => {}
    };
}

by_method! {
    [] DVec2: to_array;
    [] DVec3: to_array;
    [T: Numbers, const N: usize] [T; N]: as_slice;
    [T: Numbers] Vec<T>: as_slice;
    [P: Point + Numbers] Curve<P>: control_points;
    [P: Point + Numbers] Spline<P>: control_points;
    [] Patch: control_points;
    [] Surface: vertices;
}

by_fields! {
    [] () {};
    [] Error {};
    [A: Numbers, B: Numbers] (A, B) {0 1};
    [P: Numbers] Bounds<P> {min max};
    [P: Numbers] Nearest<P> {t point distance};
    [P: Numbers] Polyline<P> {points ts};
    [P: Point + Numbers] Reduced<P> {curve error};
    [P: Point + Numbers] Subdivision<P> {curve t0 t1 polygon_length chord_length};
    [P: Point + Numbers] BSpline<P> {points knots};
    [P: Numbers] PointAtLength<P> {t point tangent normal};
    [] EllipticalArc {center radii rotation start_angle sweep_angle};
    [] Distance {t u distance};
    [] Frame {t point tangent normal binormal};
    [] Intersection {t u point kind};
    [] SelfIntersection {t u point};
    [] Moments {area x y xx xy yy};
    [] Continuity {c0 g1 c1 g2 c2 gap angle};
    [] Face {path inside};
    [] Found {0 1};
    [] InkStroke {};
    [] InkChanges {settled open};
    [] PathTime {subpath t};
    [] PathPoint {subpath t point distance};
    [] CircularArc {start end center start_angle end_angle}; // the radius of a line is infinite
    [] PathIntersection {subpath t other_subpath u point kind};
    [] PatchPoint {u v point distance};
    [] SurfacePoint {patch u v point distance};
    [] Partials {u v uu uv vv};
    [] Curvature {gaussian mean k1 k2};
    [] PatchDeCasteljau {rows column point};
    [] FlatPiece {patch u0 u1 v0 v1 corners};
}
