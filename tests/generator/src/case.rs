//! One generated call: a function and its arguments, as plain data.

use glam::DVec3;

/// How the numbers of a case are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Coordinates of ordinary size and every kind of degenerate geometry; tolerances from 1e-1 to 1e-6 of the size.
    Moderate,
    /// Degrees 1 to 24, coordinates from 1e-12 to 1e15 within one curve, tolerances from 1e-1 to 1e-12 of the size.
    MixedScale,
    /// Coordinates near 1e-300, or up to the limit of 2⁵⁰⁰. Answers may be infinite or zero here, never NaN.
    Extreme,
}

/// A spline as plain data.
#[derive(Clone, Debug, PartialEq)]
pub struct SplineData {
    /// 2 or 3.
    pub dimension: usize,
    /// Control points, joints once each; z = 0 in the plane.
    pub points: Vec<DVec3>,
    /// The degree of each segment.
    pub degrees: Vec<usize>,
    /// Whether the end joins the start.
    pub closed: bool,
}

/// A NURBS curve as plain data; a rational curve has no knots.
#[derive(Clone, Debug, PartialEq)]
pub struct RationalData {
    /// 2 or 3.
    pub dimension: usize,
    /// Of a NURBS curve.
    pub degree: usize,
    /// Control points; z = 0 in the plane.
    pub points: Vec<DVec3>,
    /// A weight for each point.
    pub weights: Vec<f64>,
    /// The knots.
    pub knots: Vec<f64>,
    /// Whether points and knots are periodic.
    pub closed: bool,
}

/// A surface as plain data; a patch is a surface with one patch and the indices 0, 1, 2, ….
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceData {
    /// The vertices.
    pub vertices: Vec<DVec3>,
    /// The vertex indices of all patches.
    pub indices: Vec<u32>,
    /// The degrees in u and v of each patch.
    pub degrees: Vec<[usize; 2]>,
    /// A weight for each index; empty without weights.
    pub weights: Vec<f64>,
}

/// A NURBS surface as plain data; a rational patch has no knots.
#[derive(Clone, Debug, PartialEq)]
pub struct NurbsSurfaceData {
    /// The degrees in u and v.
    pub degrees: [usize; 2],
    /// The net of control points, u along the fast index.
    pub points: Vec<DVec3>,
    /// A weight for each point.
    pub weights: Vec<f64>,
    /// The knots in u and v.
    pub knots: [Vec<f64>; 2],
}

/// An argument.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// The argument is left out.
    Nothing,
    /// A number.
    Number(f64),
    /// A whole number that is not negative.
    Count(usize),
    /// A truth value.
    Flag(bool),
    /// A word from a list of choices.
    Word(&'static str),
    /// Several words.
    Words(Vec<&'static str>),
    /// Several numbers.
    Numbers(Vec<f64>),
    /// A point of the given dimension.
    Point(usize, DVec3),
    /// Several points of the given dimension.
    Points(usize, Vec<DVec3>),
    /// A curve of the given dimension, from its control points.
    Curve(usize, Vec<DVec3>),
    /// A rational curve.
    RationalCurve(RationalData),
    /// A NURBS curve.
    NurbsCurve(RationalData),
    /// A spline.
    Spline(SplineData),
    /// A path.
    Path(Vec<SplineData>),
    /// A patch.
    Patch(SurfaceData),
    /// A rational patch.
    RationalPatch(NurbsSurfaceData),
    /// A NURBS surface.
    NurbsSurface(NurbsSurfaceData),
    /// A surface.
    Surface(SurfaceData),
    /// A surface of rational patches.
    RationalSurface(SurfaceData),
    /// A text.
    Text(String),
}

/// A generated call.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The seed of the run.
    pub seed: u64,
    /// The function, as `Curve::offset`.
    pub function: &'static str,
    /// The number of the case among those of its function.
    pub number: u64,
    /// How its numbers were chosen.
    pub mode: Mode,
    /// The arguments by name, the receiver first.
    pub arguments: Vec<(&'static str, Value)>,
}

impl Case {
    /// An argument by its name.
    ///
    /// # Panics
    /// If the function has no such argument.
    pub fn get(&self, name: &str) -> &Value {
        let found = self.arguments.iter().find(|(known, _)| *known == name);
        &found
            .unwrap_or_else(|| panic!("{}: no argument {name}", self.function))
            .1
    }

    /// The case with a number in the place of another one, which is chosen among those of an argument and counted from 0:
    /// coordinates of points and vertices, numbers and lists of numbers. `None` for an argument without numbers.
    pub fn with_number(&self, argument: usize, place: usize, x: f64) -> Option<Self> {
        let mut changed = self.clone();
        let coordinate = |points: &mut [DVec3], dimension: usize| {
            let count = points
                .len()
                .checked_mul(dimension)
                .filter(|&count| count > 0)?;
            let place = place % count;
            points[place / dimension][place % dimension] = x;
            Some(())
        };
        match &mut changed.arguments[argument].1 {
            Value::Number(number) => *number = x,
            Value::Numbers(numbers) if !numbers.is_empty() => {
                let place = place % numbers.len();
                numbers[place] = x;
            }
            Value::Point(dimension, p) => coordinate(std::slice::from_mut(p), *dimension)?,
            Value::Points(dimension, points) => coordinate(points, *dimension)?,
            Value::Patch(surface) | Value::Surface(surface) | Value::RationalSurface(surface) => {
                coordinate(&mut surface.vertices, 3)?
            }
            _ => return None,
        }
        Some(changed)
    }

    /// The largest absolute coordinate among all points.
    pub fn size(&self) -> f64 {
        let values = self.arguments.iter().map(|(_, value)| value.size());
        values.fold(0.0, f64::max)
    }

    /// The dimension of the first argument that has one; 3 if there is none.
    pub fn dimension(&self) -> usize {
        let mut values = self.arguments.iter().map(|(_, value)| value.dimension());
        values.find_map(|dimension| dimension).unwrap_or(3)
    }
}

impl Value {
    /// The largest absolute coordinate; 0 for what has no coordinates.
    pub fn size(&self) -> f64 {
        let largest = |points: &[DVec3]| {
            let sizes = points.iter().map(|p| p.abs().max_element());
            sizes.fold(0.0, f64::max)
        };
        match self {
            Self::Point(_, p) => largest(&[*p]),
            Self::Points(_, points) | Self::Curve(_, points) => largest(points),
            Self::RationalCurve(curve) | Self::NurbsCurve(curve) => largest(&curve.points),
            Self::Spline(spline) => largest(&spline.points),
            Self::Path(splines) => {
                let sizes = splines.iter().map(|spline| largest(&spline.points));
                sizes.fold(0.0, f64::max)
            }
            Self::Patch(surface) | Self::Surface(surface) | Self::RationalSurface(surface) => {
                largest(&surface.vertices)
            }
            Self::RationalPatch(surface) | Self::NurbsSurface(surface) => largest(&surface.points),
            _ => 0.0,
        }
    }

    fn dimension(&self) -> Option<usize> {
        match self {
            Self::Point(dimension, _)
            | Self::Points(dimension, _)
            | Self::Curve(dimension, _)
            | Self::RationalCurve(RationalData { dimension, .. })
            | Self::NurbsCurve(RationalData { dimension, .. })
            | Self::Spline(SplineData { dimension, .. }) => Some(*dimension),
            Self::Path(_) => Some(2),
            _ => None,
        }
    }
}
