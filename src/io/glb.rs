//! Binary glTF 2.0 (GLB) export of meshes; `js/io/glb.ts` produces the same bytes.

use super::file_size::checked_length;
use crate::geometry::error::Error;
use crate::mesh::Indices;
use crate::text::number::{push, written};
use casteljau_kernels::numeric::order::to_u32;

/// The version of glTF, and the sizes of the file header and of the header of a chunk.
const VERSION: u32 = 2;
const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;

/// Values of `componentType` of accessors and `target` of buffer views.
const FLOAT: u32 = 5126;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// The largest vertex number that fits 16 bits; glTF reserves 65,535.
const GREATEST_SHORT: usize = 0xfffe;

/// The GLB file of a valid mesh.
pub(crate) fn glb(
    positions: &[f32],
    mut normals: Vec<f32>,
    uvs: &[f32],
    indices: &Indices,
) -> Result<Vec<u8>, Error> {
    let mut chunk = Chunk::default();
    if !indices.is_empty() {
        checked_length(4 * (2 * positions.len() + uvs.len() + indices.len()))?;
        for normal in normals.chunks_exact_mut(3) {
            if normal.iter().all(|&x| x == 0.0) {
                normal[2] = 1.0;
            }
        }
        chunk.push_floats(positions, 3, &bounds(positions));
        chunk.push_floats(&normals, 3, "");
        chunk.push_floats(uvs, 2, "");
        chunk.push_indices(indices, positions.len() / 3);
    }
    let json = padded(chunk.description().into_bytes(), b' ');
    let binary = padded(chunk.bytes, 0);
    let mut length = HEADER_BYTES + CHUNK_HEADER_BYTES + json.len();
    if !binary.is_empty() {
        length += CHUNK_HEADER_BYTES + binary.len();
    }
    let mut file = Vec::with_capacity(checked_length(length)?);
    file.extend_from_slice(b"glTF");
    file.extend(VERSION.to_le_bytes());
    file.extend(word(length));
    for (kind, bytes) in [(b"JSON", json), (b"BIN\0", binary)] {
        if !bytes.is_empty() {
            file.extend(word(bytes.len()));
            file.extend_from_slice(kind);
            file.extend(bytes);
        }
    }
    Ok(file)
}

/// The binary chunk, and the JSON of its accessors and buffer views.
#[derive(Default)]
struct Chunk {
    bytes: Vec<u8>,
    accessors: Vec<String>,
    views: Vec<String>,
}

impl Chunk {
    /// Appends vectors of `size` numbers, unless the list is empty.
    fn push_floats(&mut self, numbers: &[f32], size: usize, bounds: &str) {
        if !numbers.is_empty() {
            let bytes = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
            let rest = format!("\"type\":\"VEC{size}\"{bounds}");
            self.push(bytes, [FLOAT, ARRAY_BUFFER], numbers.len() / size, &rest);
        }
    }

    fn push_indices(&mut self, indices: &Indices, vertices: usize) {
        let scalar = "\"type\":\"SCALAR\"";
        if vertices > GREATEST_SHORT + 1 {
            let bytes = indices.iter().flat_map(word).collect();
            let kind = [UNSIGNED_INT, ELEMENT_ARRAY_BUFFER];
            self.push(bytes, kind, indices.len(), scalar);
        } else {
            // The lower two bytes of each index.
            let bytes = indices.iter().flat_map(|i| word(i).into_iter().take(2));
            let kind = [UNSIGNED_SHORT, ELEMENT_ARRAY_BUFFER];
            self.push(bytes.collect(), kind, indices.len(), scalar);
        }
    }

    fn push(&mut self, bytes: Vec<u8>, [kind, target]: [u32; 2], count: usize, rest: &str) {
        let (view, offset, length) = (self.views.len(), self.bytes.len(), bytes.len());
        self.accessors.push(format!(
            "{{\"bufferView\":{view},\"componentType\":{kind},\"count\":{count},{rest}}}"
        ));
        self.views.push(format!(
            "{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{length},\"target\":{target}}}"
        ));
        self.bytes.extend(padded(bytes, 0));
    }

    /// The JSON chunk: one node with one mesh, double-sided because the surfaces are open; an empty scene for an empty
    /// mesh.
    fn description(&self) -> String {
        let mut json = String::from(
            "{\"asset\":{\"version\":\"2.0\",\"generator\":\"casteljau\"},\"scene\":0,\"scenes\":[",
        );
        if self.views.is_empty() {
            return json + "{}]}";
        }
        let last = self.views.len() - 1;
        let uv = if last == 3 { ",\"TEXCOORD_0\":2" } else { "" };
        push(
            &mut json,
            format_args!(
                "{{\"nodes\":[0]}}],\"nodes\":[{{\"mesh\":0}}],\"meshes\":[{{\"primitives\":[{{\"attributes\":\
                {{\"POSITION\":0,\"NORMAL\":1{uv}}},\"indices\":{last},\"material\":0}}]}}],\
                \"materials\":[{{\"doubleSided\":true}}],\"accessors\":[{}],\"bufferViews\":[{}],\
                \"buffers\":[{{\"byteLength\":{}}}]}}",
                self.accessors.join(","),
                self.views.join(","),
                self.bytes.len(),
            ),
        );
        json
    }
}

/// The minimum and the maximum of each coordinate.
fn bounds(positions: &[f32]) -> String {
    let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for point in positions.chunks_exact(3) {
        for axis in 0..3 {
            min[axis] = min[axis].min(point[axis]);
            max[axis] = max[axis].max(point[axis]);
        }
    }
    // Adding 0 turns −0 into 0; JSON parsers differ in their treatment of −0.
    let list = |corner: [f32; 3]| corner.map(|x| written(f64::from(x) + 0.0)).join(",");
    format!(",\"min\":[{}],\"max\":[{}]", list(min), list(max))
}

/// The bytes padded to a multiple of four.
fn padded(mut bytes: Vec<u8>, with: u8) -> Vec<u8> {
    bytes.resize(bytes.len().next_multiple_of(4), with);
    bytes
}

/// A 32-bit little-endian number; file lengths and vertex numbers fit 32 bits.
fn word(number: usize) -> [u8; 4] {
    to_u32(number).to_le_bytes()
}
