//! What several types have in common: curves and splines; drawings; patches and surfaces.

use crate::arguments::{Argument, Space};
use crate::check::size;
use crate::geometry::{growth, real, slack};
use crate::numbers::Numbers;
use crate::recorder::Recorder;
use casteljau::curve::{
    Bounds, Frame, Intersection, Nearest, PointAtLength, Polyline, SelfIntersection,
};
use casteljau::glam::{DAffine3, DVec2, DVec3};
use casteljau::mesh::TessellationOptions;
use casteljau::patch::PatchPoint;
use casteljau::path::SvgOptions;
use casteljau::surface::SurfacePoint;
use casteljau::{Curve, Error, Grid, GridMethod, Mesh, Patch, Path, Spline, Surface};
use casteljau_generator::changed;
use std::fmt::Debug;
use std::ops::Range;

/// A trait of methods that several types have under the same name.
macro_rules! shared {
    ($(#[$doc:meta])* $trait:ident: $parent:path, $([$($generic:tt)*] $type:ty),+; $methods:tt) => {
        shared!(@ trait [$(#[$doc])* $trait: $parent] $methods);
        $(shared!(@ impl [$($generic)*] $trait, $type, $methods);)+
    };
    (@ trait [$(#[$doc:meta])* $trait:ident: $parent:path]
        { $($method:ident($($argument:ident: $type:ty),*) -> $result:ty;)* }
    ) => {
        $(#[$doc])*
        pub(crate) trait $trait: $parent {
            $(fn $method(&self, $($argument: $type),*) -> $result;)*
        }
    };
    (@ impl [$($generic:tt)*] $trait:ident, $for:ty,
        { $($method:ident($($argument:ident: $type:ty),*) -> $result:ty;)* }
    ) => {
        impl<$($generic)*> $trait for $for {
            $(fn $method(&self, $($argument: $type),*) -> $result {
                self.$method($($argument),*)
            })*
        }
    };
}

/// The parameters and the segments of a curve or a spline.
pub(crate) trait Segments: Clone + PartialEq + Debug + Numbers + Argument {
    type P: Space;
    /// The segments.
    fn curves(&self) -> Vec<Curve<Self::P>>;
    /// The slack for its points.
    fn slack(&self) -> f64;

    /// The last parameter.
    fn last(&self) -> f64;
    /// The largest degree.
    fn degree(&self) -> usize;

    /// The segment at t and the parameter on it.
    fn segment_at(&self, t: f64) -> (Curve<Self::P>, f64) {
        let curves = self.curves();
        let last = curves.len() - 1;
        let k = (0..last).find(|&k| t < real(k + 1)).unwrap_or(last);
        (curves[k].clone(), t - real(k))
    }
    /// The slack at a parameter; outside, the first or the last segment is extrapolated.
    fn slack_at(&self, t: f64) -> f64 {
        let beyond = if t < 0.0 {
            t
        } else {
            (t - self.last()).max(0.0) + 1.0
        };
        self.slack() * growth(beyond, self.degree())
    }
}

impl<P: Space> Segments for Curve<P> {
    type P = P;
    fn curves(&self) -> Vec<Curve<P>> {
        vec![self.clone()]
    }
    fn slack(&self) -> f64 {
        slack(size(), self.degree())
    }
    fn last(&self) -> f64 {
        1.0
    }
    fn degree(&self) -> usize {
        self.degree()
    }
}

impl<P: Space> Segments for Spline<P> {
    type P = P;
    fn curves(&self) -> Vec<Curve<P>> {
        self.segments().collect()
    }
    fn slack(&self) -> f64 {
        4.0 * slack(size(), self.degree())
    }
    fn last(&self) -> f64 {
        real(self.segment_count())
    }
    fn degree(&self) -> usize {
        self.degrees().into_iter().max().unwrap_or(1)
    }
}

shared! {
    /// A curve or a spline.
    Line: Segments, [P: Space] Curve<P>, [P: Space] Spline<P>;
    {
        bounds() -> Bounds<Self::P>;
        control_bounds() -> Bounds<Self::P>;
        control_points() -> &[Self::P];
        derivative_at(t: f64, k: usize) -> Self::P;
        equidistant_times(segments: usize) -> Result<Vec<f64>, Error>;
        eval(t: f64) -> Self::P;
        eval_at(ts: &[f64]) -> Vec<Self::P>;
        flatten(tolerance: f64) -> Result<Polyline<Self::P>, Error>;
        length() -> f64;
        length_within(tolerance: f64) -> Result<f64, Error>;
        nearest(p: Self::P) -> Result<Nearest<Self::P>, Error>;
        point_at_length(s: f64) -> PointAtLength<Self::P>;
        reverse() -> Self;
        sample(segments: usize) -> Result<Vec<Self::P>, Error>;
        split(t: f64) -> (Self, Self);
        split_at(ts: &[f64]) -> Vec<Self>;
        subsegment(range: Range<f64>) -> Self;
        time_at_length(s: f64) -> f64;
        time_at_length_within(s: f64, tolerance: f64) -> Result<f64, Error>;
        transform(map: &<Self::P as casteljau::Point>::Affine) -> Result<Self, Error>;
    }
}

shared! {
    /// A curve or a spline of the plane.
    PlaneLine: Line<P = DVec2>, [] Curve<DVec2>, [] Spline<DVec2>;
    {
        area() -> f64;
        intersections(other: &Self) -> Vec<Intersection>;
        self_intersections() -> Vec<SelfIntersection>;
    }
}

shared! {
    /// A curve or a spline in space.
    SpaceLine: Line<P = DVec3>, [] Curve<DVec3>, [] Spline<DVec3>;
    {
        frames(segments: usize) -> Result<Vec<Frame>, Error>;
        frames_at(ts: &[f64], normal: Option<DVec3>) -> Result<Vec<Frame>, Error>;
    }
}

shared! {
    /// What can be drawn.
    Drawing: Into<Path>, [] Curve<DVec2>, [] Spline<DVec2>, [] Path;
    {
        to_svg_with(options: &SvgOptions) -> Result<String, Error>;
        trace(sink: &mut Recorder) -> ();
        trace_within(sink: &mut Recorder, tolerance: f64) -> Result<(), Error>;
    }
}

/// A point of a surface: the patch, u and v, the point, the distance.
pub(crate) struct Found(pub(crate) usize, pub(crate) PatchPoint);

impl From<PatchPoint> for Found {
    fn from(found: PatchPoint) -> Self {
        Self(0, found)
    }
}

impl From<SurfacePoint> for Found {
    fn from(found: SurfacePoint) -> Self {
        let SurfacePoint {
            patch,
            u,
            v,
            point,
            distance,
        } = found;
        Self(
            patch,
            PatchPoint {
                u,
                v,
                point,
                distance,
            },
        )
    }
}

/// The patches of a patch or a surface, and queries whose results differ by their types.
pub(crate) trait Patches: Clone + PartialEq + Debug + Numbers {
    fn surface(&self) -> Surface;
    fn points(&self) -> &[DVec3];
    fn outer_box(&self) -> Option<Bounds<DVec3>>;
    fn moved(&self, index: usize, to: DVec3) -> Result<Self, Error>;
    fn inner_box(&self) -> Option<Bounds<DVec3>>;
    fn nearest_point(&self, p: DVec3) -> Result<Option<Found>, Error>;
    fn hits(&self, origin: DVec3, direction: DVec3) -> Result<Vec<Found>, Error>;

    fn patches(&self) -> Vec<Patch> {
        self.surface().patches().collect()
    }
    /// The slack for its points.
    fn slack(&self) -> f64 {
        let patches = self.patches().into_iter();
        let degrees = patches.map(|patch| patch.degree_u() + patch.degree_v());
        slack(size(), degrees.max().unwrap_or(2))
    }
}

macro_rules! patches {
    ($($type:ty, $points:ident, $found:ty, $surface:expr;)*) => {$(
        impl Patches for $type {
            fn surface(&self) -> Surface {
                let make: fn(&Self) -> Surface = $surface;
                make(self)
            }
            fn points(&self) -> &[DVec3] {
                self.$points()
            }
            fn outer_box(&self) -> Option<Bounds<DVec3>> {
                Option::from(self.control_bounds())
            }
            fn moved(&self, index: usize, to: DVec3) -> Result<Self, Error> {
                changed(self, |value| value.move_point(index, to))
            }
            fn inner_box(&self) -> Option<Bounds<DVec3>> {
                Option::from(self.bounds())
            }
            fn nearest_point(&self, p: DVec3) -> Result<Option<Found>, Error> {
                let found: Option<$found> = Option::from(self.nearest(p)?);
                Ok(found.map(Found::from))
            }
            fn hits(&self, origin: DVec3, direction: DVec3) -> Result<Vec<Found>, Error> {
                let hits = self.intersect_ray(origin, direction)?;
                Ok(hits.into_iter().map(Found::from).collect())
            }
        }
    )*};
}

patches! {
    Surface, vertices, SurfacePoint, Surface::clone;
    Patch, control_points, PatchPoint, |patch| {
        let points = patch.control_points().to_vec();
        let indices = (0_u32..).take(points.len()).collect();
        Surface::new(points, indices, patch.degree_u(), patch.degree_v()).expect("a surface")
    };
}

shared! {
    /// A patch or a surface.
    Sheet: Patches, [] Patch, [] Surface;
    {
        grid(grid: Grid, quads: bool) -> Result<Mesh, Error>;
        grid_by(method: GridMethod, grid: Grid, quads: bool, mesh: &mut Mesh) -> Result<(), Error>;
        grid_into(grid: Grid, quads: bool, mesh: &mut Mesh) -> Result<(), Error>;
        tessellate(options: &TessellationOptions) -> Result<Mesh, Error>;
        tessellate_f64(options: &TessellationOptions) -> Result<Mesh<f64>, Error>;
        transform(map: &DAffine3) -> Result<Self, Error>;
    }
}
