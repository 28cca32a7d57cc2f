//! Serialisation with serde, behind the feature `serde`, of the types whose values are validated by a constructor.
//!
//! Curves and paths have the form of JavaScript's `toJSON`. Deserialised values are validated by the constructors.
//! Results and options are plain values and derive their form from their fields.

#[cfg(feature = "easing")]
mod easing;
#[cfg(feature = "surfaces")]
mod surfaces;

use crate::curve::{Cubic, Curve, Line, Quad};
use crate::geometry::point::Point;
use crate::path::Path;
#[cfg(feature = "nurbs")]
use crate::rational::{NurbsCurve, RationalCurve};
use crate::spline::Spline;
use glam::DVec2;
use serde::de::{Deserialize, Deserializer, Error};
use serde::{Deserialize as Read, Serialize as Write, Serializer};

/// `{ "points": [[x, y], …] }`
#[derive(Read, Write)]
struct CurveForm<P> {
    points: Vec<P>,
}

/// `{ "points": [[x, y], …], "degrees": [3, …], "closed": false }`
#[derive(Read, Write)]
struct SplineForm<P> {
    points: Vec<P>,
    degrees: Vec<usize>,
    closed: bool,
}

/// `{ "subpaths": [{ "points": [[x, y], …], "degrees": [3, …], "closed": false }, …] }`
#[derive(Read, Write)]
struct PathForm {
    subpaths: Vec<Spline<DVec2>>,
}

impl<P: Point + Write> Write for Curve<P> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        CurveForm {
            points: self.control_points().to_vec(),
        }
        .serialize(serializer)
    }
}

impl<'de, P: Point + Read<'de>> Deserialize<'de> for Curve<P> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = CurveForm::deserialize(deserializer)?;
        Self::new(&form.points).map_err(D::Error::custom)
    }
}

macro_rules! as_curve {
    ($($type:ident),*) => {
        $(
            impl<P: Point + Write> Write for $type<P> {
                fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                    Curve::from(*self).serialize(serializer)
                }
            }

            impl<'de, P: Point + Read<'de>> Deserialize<'de> for $type<P> {
                fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    Self::try_from(Curve::deserialize(deserializer)?).map_err(D::Error::custom)
                }
            }
        )*
    };
}

as_curve!(Line, Quad, Cubic);

impl<P: Point + Write> Write for Spline<P> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (points, degrees) = (self.control_points().to_vec(), self.degrees());
        SplineForm {
            points,
            degrees,
            closed: self.is_closed(),
        }
        .serialize(serializer)
    }
}

impl<'de, P: Point + Read<'de>> Deserialize<'de> for Spline<P> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = SplineForm::deserialize(deserializer)?;
        Self::with_degrees(form.points, &form.degrees, form.closed).map_err(D::Error::custom)
    }
}

/// `{ "points": [[x, y], …], "weights": [1, …] }`
#[cfg(feature = "nurbs")]
#[derive(Read, Write)]
struct RationalForm<P> {
    points: Vec<P>,
    weights: Vec<f64>,
}

#[cfg(feature = "nurbs")]
impl<P: Point + Write> Write for RationalCurve<P> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        RationalForm {
            points: self.control_points().to_vec(),
            weights: self.weights().to_vec(),
        }
        .serialize(serializer)
    }
}

#[cfg(feature = "nurbs")]
impl<'de, P: Point + Read<'de>> Deserialize<'de> for RationalCurve<P> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = RationalForm::deserialize(deserializer)?;
        Self::new(&form.points, &form.weights).map_err(D::Error::custom)
    }
}

/// `{ "degree": 2, "points": [[x, y], …], "weights": [1, …], "knots": [0, …], "closed": false }`
#[cfg(feature = "nurbs")]
#[derive(Read, Write)]
struct NurbsForm<P> {
    degree: usize,
    points: Vec<P>,
    weights: Vec<f64>,
    knots: Vec<f64>,
    closed: bool,
}

#[cfg(feature = "nurbs")]
impl<P: Point + Write> Write for NurbsCurve<P> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        NurbsForm {
            degree: self.degree(),
            points: self.control_points().to_vec(),
            weights: self.weights().to_vec(),
            knots: self.knots().to_vec(),
            closed: self.is_closed(),
        }
        .serialize(serializer)
    }
}

#[cfg(feature = "nurbs")]
impl<'de, P: Point + Read<'de>> Deserialize<'de> for NurbsCurve<P> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = NurbsForm::deserialize(deserializer)?;
        let weights = Some(&form.weights[..]);
        Self::new(form.degree, &form.points, weights, &form.knots, form.closed)
            .map_err(D::Error::custom)
    }
}

impl Write for Path {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let subpaths = self.subpaths().collect();
        PathForm { subpaths }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Path {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = PathForm::deserialize(deserializer)?;
        Ok(Self::new(&form.subpaths))
    }
}
