//! Patches and surfaces.

use crate::patch::Patch;
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
