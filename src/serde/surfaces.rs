//! Patches and surfaces, also with weights.

use crate::patch::Patch;
use crate::rational::{NurbsSurface, RationalPatch};
use crate::surface::network::Surface;
use glam::DVec3;
use serde::de::{Deserialize, Deserializer, Error};
use serde::{Deserialize as Read, Serialize as Write, Serializer};

/// `{ "net": [[x, y, z], …], "degreeU": 3, "degreeV": 3 }`
#[derive(Read, Write)]
#[serde(rename_all = "camelCase")]
struct PatchForm {
    net: Vec<DVec3>,
    degree_u: usize,
    degree_v: usize,
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

/// `{ "net": [[x, y, z], …], "weights": [1, …], "degreeU": 3, "degreeV": 3 }`
#[derive(Read, Write)]
#[serde(rename_all = "camelCase")]
struct RationalPatchForm {
    net: Vec<DVec3>,
    weights: Vec<f64>,
    degree_u: usize,
    degree_v: usize,
}

impl Write for RationalPatch {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        RationalPatchForm {
            net: self.control_points().to_vec(),
            weights: self.weights().to_vec(),
            degree_u: self.degree_u(),
            degree_v: self.degree_v(),
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for RationalPatch {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = RationalPatchForm::deserialize(deserializer)?;
        Self::new(&form.net, &form.weights, form.degree_u, form.degree_v).map_err(D::Error::custom)
    }
}

/// `{ "degreeU": 2, "degreeV": 2, "points": [[x, y, z], …], "weights": [1, …], "knotsU": [0, …], "knotsV": [0, …] }`
#[derive(Read, Write)]
#[serde(rename_all = "camelCase")]
struct NurbsSurfaceForm {
    degree_u: usize,
    degree_v: usize,
    points: Vec<DVec3>,
    weights: Vec<f64>,
    knots_u: Vec<f64>,
    knots_v: Vec<f64>,
}

impl Write for NurbsSurface {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        NurbsSurfaceForm {
            degree_u: self.degree_u(),
            degree_v: self.degree_v(),
            points: self.control_points().to_vec(),
            weights: self.weights().to_vec(),
            knots_u: self.knots_u().to_vec(),
            knots_v: self.knots_v().to_vec(),
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for NurbsSurface {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let form = NurbsSurfaceForm::deserialize(deserializer)?;
        let (weights, knots) = (Some(&form.weights[..]), [&form.knots_u, &form.knots_v]);
        let (m, n) = (form.degree_u, form.degree_v);
        Self::new(m, n, &form.points, weights, knots[0], knots[1]).map_err(D::Error::custom)
    }
}
