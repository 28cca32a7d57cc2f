//! The arguments of a case as values of the library, and checks that take them in their order.

use crate::check::Checked;
use crate::numbers::Numbers;
use casteljau::curve::Basis;
use casteljau::glam::{DAffine2, DAffine3, DMat3, DMat4, DVec2, DVec3};
use casteljau::mesh::Weld;
use casteljau::models::{Height, Up};
use casteljau::path::FillRule;
use casteljau::spline::{Join, JointMode};
use casteljau::{
    Curve, Error, GridMethod, NurbsCurve, NurbsSurface, Patch, Path, Point, RationalCurve,
    RationalPatch, RationalSurface, Spline, Surface,
};
use casteljau_generator::{Case, NurbsSurfaceData, SplineData, SurfaceData, Value};

/// The plane or space; points are made from three coordinates.
pub(crate) trait Space: Point<Affine: Argument, Projective: Argument> + Numbers {
    fn from_3d(p: DVec3) -> Self;
}

impl Space for DVec2 {
    fn from_3d(p: DVec3) -> Self {
        p.truncate()
    }
}

impl Space for DVec3 {
    fn from_3d(p: DVec3) -> Self {
        p
    }
}

/// A type of arguments.
pub(crate) trait Argument: Sized {
    /// The argument as a value of this type; `None` for an argument of another type.
    fn read(value: &Value) -> Option<Self>;
}

/// Implements `Argument` by patterns; each is followed by the result, an `Option`.
macro_rules! arguments {
    ($([$($generic:tt)*] $type:ty: $($pattern:pat => $result:expr),+;)*) => {$(
        impl<$($generic)*> Argument for $type {
            fn read(value: &Value) -> Option<Self> {
                match value {
                    $($pattern => $result,)+
                    #[allow(unreachable_patterns, reason = "some types accept every value")]
                    _ => None,
                }
            }
        }
    )*};
}

/// Implements `Argument` for choices by their words; the last one stands for all other words.
macro_rules! choices {
    ($($type:ty: $($word:literal $choice:expr),+;)*) => {
        arguments! {$([] $type: Value::Word(word) => match *word {
            $($word => Some($choice),)+
            _ => None,
        };)*}
    };
}

arguments! {
    [] f64: Value::Number(x) => Some(*x);
    [] usize: Value::Count(n) => Some(*n);
    [] u8: Value::Count(n) => u8::try_from(*n).ok();
    [] bool: Value::Flag(flag) => Some(*flag);
    [] String: Value::Text(text) => Some(text.clone()), Value::Word(word) => Some((*word).to_owned());
    [] Vec<f64>: Value::Numbers(numbers) => Some(numbers.clone());
    [] Vec<&'static str>: Value::Words(words) => Some(words.clone());
    [] Vec<JointMode>: Value::Words(words) => words.iter().map(|word| JointMode::read(&Value::Word(word))).collect();
    [P: Space] P: Value::Point(_, p) => Some(P::from_3d(*p));
    [P: Space] Vec<P>: Value::Points(_, points) => Some(mapped(points));
    [P: Space, const N: usize] [P; N]: Value::Points(_, points) => mapped(points).try_into().ok();
    [P: Space] Curve<P>: Value::Curve(_, points) => Curve::new(&mapped(points)).ok();
    [P: Space] RationalCurve<P>: Value::RationalCurve(data) => RationalCurve::new(&mapped(&data.points), &data.weights).ok();
    [P: Space] NurbsCurve<P>: Value::NurbsCurve(data) => {
        let points: Vec<P> = mapped(&data.points);
        NurbsCurve::new(data.degree, &points, Some(&data.weights), &data.knots, data.closed).ok()
    };
    [P: Space] Spline<P>: Value::Spline(data) => Some(spline_of(data));
    [] Path: Value::Path(splines) => Some(Path::new(&splines.iter().map(spline_of).collect::<Vec<_>>()));
    [] Patch: Value::Patch(data) => Patch::new(&data.vertices, data.degrees[0][0], data.degrees[0][1]).ok();
    [] RationalPatch: Value::RationalPatch(data) => {
        RationalPatch::new(&data.points, &data.weights, data.degrees[0], data.degrees[1]).ok()
    };
    [] NurbsSurface: Value::NurbsSurface(data) => {
        let ([m, n], [u, v]) = (data.degrees, &data.knots);
        NurbsSurface::new(m, n, &data.points, Some(&data.weights), u, v).ok()
    };
    [] NurbsSurfaceData: Value::RationalPatch(data) | Value::NurbsSurface(data) => Some(data.clone());
    [] Surface: Value::Surface(data) => surface_of(data);
    [] RationalSurface: Value::RationalSurface(data) => rational_surface_of(data).ok();
    [] SplineData: Value::Spline(data) => Some(data.clone());
    [] SurfaceData: Value::Patch(data) | Value::Surface(data) | Value::RationalSurface(data) => Some(data.clone());
    [] DAffine2: Value::Numbers(numbers) => Some(DAffine2::from_cols_slice(numbers));
    [] DAffine3: Value::Numbers(numbers) => Some(DAffine3::from_cols_slice(numbers));
    [] DMat3: Value::Numbers(numbers) => Some(DMat3::from_cols_slice(numbers));
    [] DMat4: Value::Numbers(numbers) => Some(DMat4::from_cols_slice(numbers));
    [] Basis: Value::Numbers(numbers) => numbers.as_slice().try_into().ok().map(Basis::Matrix),
        Value::Word("bezier") => Some(Basis::Bezier), Value::Word("hermite") => Some(Basis::Hermite),
        Value::Word("b-spline") => Some(Basis::BSpline), Value::Word("catmull-rom") => Some(Basis::CatmullRom);
    [T: Argument] Option<T>: Value::Nothing => Some(None), value => T::read(value).map(Some);
}

choices! {
    FillRule: "evenodd" FillRule::EvenOdd, "nonzero" FillRule::NonZero;
    Join: "round" Join::Round, "miter" Join::Miter, "bevel" Join::Bevel;
    JointMode: "free" JointMode::Free, "g1" JointMode::G1, "c1" JointMode::C1,
        "c2" JointMode::C2, "g2" JointMode::G2, "auto" JointMode::Auto;
    Weld: "position" Weld::Position, "normal" Weld::Normal, "none" Weld::None;
    GridMethod: "forward" GridMethod::ForwardDifference, "bernstein" GridMethod::Bernstein;
    Height: "original" Height::Original, "squashed" Height::Squashed;
    Up: "y" Up::Y, "z" Up::Z;
}

fn mapped<P: Space>(points: &[DVec3]) -> Vec<P> {
    points.iter().map(|&p| P::from_3d(p)).collect()
}

pub(crate) fn spline_of<P: Space>(data: &SplineData) -> Spline<P> {
    Spline::with_degrees(mapped(&data.points), &data.degrees, data.closed).expect("a spline")
}

fn surface_of(data: &SurfaceData) -> Option<Surface> {
    Surface::with_degrees(data.vertices.clone(), data.indices.clone(), &data.degrees).ok()
}

pub(crate) fn rational_surface_of(data: &SurfaceData) -> Result<RationalSurface, Error> {
    let (vertices, indices) = (data.vertices.clone(), data.indices.clone());
    RationalSurface::with_degrees(vertices, indices, data.weights.clone(), &data.degrees)
}

/// A check of one call, whose parameters are the arguments of the case in their order.
pub(crate) trait Check<Arguments> {
    fn run(&self, case: &Case) -> Checked;
}

macro_rules! checks {
    ($($($type:ident $index:literal)*;)*) => {$(
        impl<Of: Fn($($type),*) -> Checked, $($type: Argument),*> Check<($($type,)*)> for Of {
            fn run(&self, case: &Case) -> Checked {
                self($(argument(case, $index)),*)
            }
        }
    )*};
}

checks! {
    A 0;
    A 0 B 1;
    A 0 B 1 C 2;
    A 0 B 1 C 2 D 3;
    A 0 B 1 C 2 D 3 E 4;
    A 0 B 1 C 2 D 3 E 4 F 5;
}

fn argument<T: Argument>(case: &Case, index: usize) -> T {
    let (name, value) = &case.arguments[index];
    T::read(value).unwrap_or_else(|| panic!("{name}: no argument of this type, but {value:?}"))
}

pub(crate) fn run<A>(check: &impl Check<A>, case: &Case) -> Checked {
    check.run(case)
}
