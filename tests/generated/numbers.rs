//! Access to all numbers of a result, whatever its type.

use casteljau::curve::*;
use casteljau::glam::{DVec2, DVec3};
use casteljau::mesh::*;
use casteljau::patch::*;
use casteljau::path::{Face, PathElement};
use casteljau::path::{PathIntersection, PathPoint, PathTime};
use casteljau::spline::*;
use casteljau::surface::*;
use casteljau::{Curve, Error, Path, Point, Spline};

/// A value that contains numbers.
pub(crate) trait Numbers {
    /// Calls `see` with each number.
    fn visit(&self, see: &mut dyn FnMut(f64));
}

impl Numbers for f64 {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(*self);
    }
}

impl Numbers for f32 {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(f64::from(*self));
    }
}

macro_rules! without_numbers {
    ($($type:ty),*) => {$(
        impl Numbers for $type {
            fn visit(&self, _: &mut dyn FnMut(f64)) {}
        }
    )*};
}

without_numbers!(
    (),
    bool,
    u8,
    i32,
    u32,
    usize,
    String,
    Error,
    CurveKind,
    Topology
);

impl Numbers for DVec2 {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.to_array().visit(see);
    }
}

impl Numbers for DVec3 {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.to_array().visit(see);
    }
}

impl<T: Numbers> Numbers for [T] {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.iter().for_each(|item| item.visit(see));
    }
}

impl<T: Numbers, const N: usize> Numbers for [T; N] {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.as_slice().visit(see);
    }
}

impl<T: Numbers> Numbers for Vec<T> {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.as_slice().visit(see);
    }
}

impl<T: Numbers> Numbers for Option<T> {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.iter().for_each(|item| item.visit(see));
    }
}

impl<T: Numbers, E> Numbers for Result<T, E> {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.iter().for_each(|item| item.visit(see));
    }
}

impl<A: Numbers, B: Numbers> Numbers for (A, B) {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.0.visit(see);
        self.1.visit(see);
    }
}

/// Implements `Numbers` by fields, for types with and without a point type.
macro_rules! by_fields {
    ($([$($generic:tt)*] $type:ty: $($field:ident)*;)*) => {$(
        impl<$($generic)*> Numbers for $type {
            fn visit(&self, see: &mut dyn FnMut(f64)) {
                $(self.$field.visit(see);)*
            }
        }
    )*};
}

by_fields! {
    [P: Numbers] Bounds<P>: min max;
    [P: Numbers] Nearest<P>: t point distance;
    [P: Numbers] Polyline<P>: points ts;
    [P: Point + Numbers] Reduced<P>: curve error;
    [P: Point + Numbers] Subdivision<P>: curve t0 t1 polygon_length chord_length;
    [P: Point + Numbers] BSpline<P>: points knots;
    [] Distance: distance t u;
    [] Frame: t point tangent normal binormal;
    [] Intersection: t u point kind;
    [] SelfIntersection: t u point;
    [] Moments: area x y xx xy yy;
    [] Continuity: gap angle;
    [] Face: path;
    [] PathTime: t;
    [] PathPoint: t point distance;
    [] PathIntersection: t u point kind;
    [] PatchPoint: u v point distance;
    [] SurfacePoint: u v point distance;
    [] Partials: u v uu uv vv;
    [] Curvature: gaussian mean k1 k2;
    [] PatchDeCasteljau: rows column point;
    [] FlatPiece: u0 u1 v0 v1 corners;
    [T: Numbers] Mesh<T>: positions normals uvs;
}

impl Numbers for IntersectionKind {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        if let Self::Overlap { t_end, u_end } = self {
            [*t_end, *u_end].visit(see);
        }
    }
}

impl<P: Point + Numbers> Numbers for Curve<P> {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.control_points().visit(see);
    }
}

impl<P: Point + Numbers> Numbers for Spline<P> {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.control_points().visit(see);
    }
}

impl Numbers for PathElement {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        match *self {
            Self::MoveTo(p) | Self::LineTo(p) => p.visit(see),
            Self::QuadTo(p1, p) => [p1, p].visit(see),
            Self::CubicTo(p1, p2, p) => [p1, p2, p].visit(see),
            Self::Close => {}
        }
    }
}

impl Numbers for Path {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.subpaths().collect::<Vec<_>>().visit(see);
    }
}

impl Numbers for Patch {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.control_points().visit(see);
    }
}

impl Numbers for Surface {
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.vertices().visit(see);
    }
}
