//! Serialisation with serde, behind the feature `serde`, of the types whose values are validated by a constructor.
//!
//! Curves and paths have the form of JavaScript's `toJSON`. Deserialised values are validated by the constructors.
//! Results and options are plain values and derive their form from their fields.

use crate::curve::Curve;
use crate::easing::{Easing, Kind};
use crate::geometry::point::Point;
use crate::patch::Patch;
use crate::path::Path;
use crate::spline::Spline;
use crate::surface::network::Surface;
use glam::{DVec2, DVec3};
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

/// `{ "net": [[x, y, z], …], "degreeU": 3, "degreeV": 3 }`
#[derive(Read, Write)]
#[serde(rename_all = "camelCase")]
struct PatchForm {
    net: Vec<DVec3>,
    degree_u: usize,
    degree_v: usize,
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

impl Write for Patch {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (degree_u, degree_v) = (self.degree_u(), self.degree_v());
        PatchForm {
            net: self.control_points().to_vec(),
            degree_u,
            degree_v,
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Patch {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = PatchForm::deserialize(deserializer)?;
        Self::new(&form.net, form.degree_u, form.degree_v).map_err(D::Error::custom)
    }
}

/// `{ "vertices": [[x, y, z], …], "patches": [{ "vertices": [0, 1, …], "degreeU": 3, "degreeV": 3 }, …] }`
#[derive(Read, Write)]
struct SurfaceForm {
    vertices: Vec<DVec3>,
    patches: Vec<PatchOfVertices>,
}

#[derive(Read, Write)]
#[serde(rename_all = "camelCase")]
struct PatchOfVertices {
    vertices: Vec<u32>,
    degree_u: usize,
    degree_v: usize,
}

impl Write for Surface {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let patches = (0..self.patch_count()).filter_map(|k| {
            let [degree_u, degree_v] = self.degrees(k)?;
            let vertices = self.patch_indices(k)?.to_vec();
            Some(PatchOfVertices {
                vertices,
                degree_u,
                degree_v,
            })
        });
        SurfaceForm {
            vertices: self.vertices().to_vec(),
            patches: patches.collect(),
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Surface {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = SurfaceForm::deserialize(deserializer)?;
        let degrees = form
            .patches
            .iter()
            .map(|patch| [patch.degree_u, patch.degree_v]);
        let degrees: Vec<[usize; 2]> = degrees.collect();
        let indices = form.patches.into_iter().flat_map(|patch| patch.vertices);
        Self::with_degrees(form.vertices, indices.collect(), &degrees).map_err(D::Error::custom)
    }
}

/// `[x1, y1, x2, y2]`, or CSS text for `steps()` and `linear()`.
#[derive(Read)]
#[serde(untagged)]
enum EasingForm {
    Handles([f64; 4]),
    Css(String),
}

impl Write for Easing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.kind {
            Kind::Cubic(cubic) => cubic.handles.serialize(serializer),
            _ => serializer.collect_str(self),
        }
    }
}

impl<'de> Deserialize<'de> for Easing {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match EasingForm::deserialize(deserializer)? {
            EasingForm::Handles([x1, y1, x2, y2]) => {
                Self::new(x1, y1, x2, y2).map_err(D::Error::custom)
            }
            EasingForm::Css(text) => text.parse().map_err(D::Error::custom),
        }
    }
}
