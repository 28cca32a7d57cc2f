//! Mesh export as OBJ, STL and GLB; `js/io/obj.ts`, `stl.js` and `glb.js` produce the same files.

use super::file_size::checked_length;
use super::glb::glb;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::mesh::Mesh;
use crate::mesh::buffers::to_f32;
use crate::text::number::{push, written};
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;
use std::fmt::{Display, LowerExp};

/// The header of a binary STL file, without the number of triangles.
const STL_HEADER_BYTES: usize = 80;
/// A normal and three corners of three f32 each, and two unused bytes.
const STL_TRIANGLE_BYTES: usize = 50;

impl<T: Copy + Into<f64> + Display + LowerExp> Mesh<T> {
    /// The text of a Wavefront OBJ file: positions, normals, (u, v) if there are any; quads if the mesh has them,
    /// otherwise triangles.
    ///
    /// Numbers are written with the fewest digits that round-trip.
    ///
    /// # Errors
    /// For a mesh with inconsistent buffers: [`Error::Count`], [`Error::NotFinite`], [`Error::Index`].
    pub fn to_obj(&self) -> Result<String, Error> {
        let (faces, corners) = match &self.quads {
            Some(quads) => (quads, 4),
            None => (&self.indices, 3),
        };
        self.check(faces.iter(), faces.len(), corners)?;
        let mut text = format!(
            "# {} vertices, {} faces\n",
            self.vertex_count(),
            faces.len() / corners
        );
        push_lines(&mut text, "v", &self.positions, 3);
        push_lines(&mut text, "vt", &self.uvs, 2);
        push_lines(&mut text, "vn", &self.normals, 3);
        let vertices: Vec<usize> = faces.iter().collect();
        for face in vertices.chunks(corners) {
            text.push('f');
            for number in face.iter().map(|vertex| vertex + 1) {
                if self.uvs.is_empty() {
                    push(&mut text, format_args!(" {number}//{number}"));
                } else {
                    push(&mut text, format_args!(" {number}/{number}/{number}"));
                }
            }
            text.push('\n');
        }
        Ok(text)
    }

    /// The bytes of a binary STL file: 84 bytes, and 50 for each triangle.
    ///
    /// Normals are computed from the corners by the right-hand rule; the normal of a degenerate triangle is zero.
    /// Positions are rounded to f32.
    ///
    /// # Errors
    /// As [`to_obj`](Self::to_obj); [`Error::TooMany`] above 1 GiB, [`Error::Range`] for positions outside the range of
    /// f32.
    pub fn to_stl(&self) -> Result<Vec<u8>, Error> {
        self.check(self.indices.iter(), self.indices.len(), 3)?;
        let positions = rounded_to_f32("positions", &self.positions)?;
        let triangles = self.triangle_count();
        let length = STL_HEADER_BYTES + 4 + triangles * STL_TRIANGLE_BYTES;
        let mut bytes = Vec::with_capacity(checked_length(length)?);
        // The header must not begin with "solid", which marks the text format.
        bytes.extend_from_slice(b"binary STL");
        bytes.resize(STL_HEADER_BYTES, 0);
        bytes.extend(to_u32(triangles).to_le_bytes());
        let vertices: Vec<usize> = self.indices.iter().collect();
        for triangle in vertices.chunks_exact(3) {
            let corners = [0, 1, 2].map(|k| 3 * triangle[k]);
            let points = corners.map(|at| &positions[at..at + 3]);
            let normal = face_normal(points).to_array().map(to_f32);
            for number in normal.iter().chain(points.into_iter().flatten()) {
                bytes.extend(number.to_le_bytes());
            }
            bytes.extend([0, 0]);
        }
        Ok(bytes)
    }

    /// The bytes of a self-contained binary glTF 2.0 file (GLB).
    ///
    /// The file has one double-sided mesh with positions, normals, indices and, if there are any, (u, v); an empty mesh
    /// gives an empty scene. Numbers are rounded to f32; zero normals become +z, because glTF does not allow them. In
    /// glTF the y-axis points up. Source: Khronos, glTF 2.0 specification, §3 and §4.
    ///
    /// # Errors
    /// As [`to_stl`](Self::to_stl).
    pub fn to_glb(&self) -> Result<Vec<u8>, Error> {
        self.check(self.indices.iter(), self.indices.len(), 3)?;
        let positions = rounded_to_f32("positions", &self.positions)?;
        let normals = rounded_to_f32("normals", &self.normals)?;
        glb(&positions, normals, &self.uvs, &self.indices)
    }

    /// Returns an error for a mesh with inconsistent buffers; the fields of a mesh are public, so users can change
    /// them. `faces` contains the vertices of `count / corners` faces.
    fn check(
        &self,
        mut faces: impl Iterator<Item = usize>,
        count: usize,
        corners: usize,
    ) -> Result<(), Error> {
        let vertices = self.vertex_count();
        let each = "3 numbers for each vertex";
        check_count("positions", each, self.positions.len(), 3 * vertices)?;
        check_count("normals", each, self.normals.len(), 3 * vertices)?;
        if !self.uvs.is_empty() {
            let each = "2 numbers for each vertex";
            check_count("uvs", each, self.uvs.len(), 2 * vertices)?;
        }
        let each = match corners {
            4 => "4 vertex numbers for each face",
            _ => "3 vertex numbers for each face",
        };
        check_count("indices", each, count, count / corners * corners)?;
        check_finite("positions", &self.positions)?;
        check_finite("normals", &self.normals)?;
        check_finite("uvs", &self.uvs)?;
        faces
            .find(|&vertex| vertex >= vertices)
            .map_or(Ok(()), |got| {
                Err(Error::Index {
                    what: "indices",
                    first: 0,
                    last: vertices.saturating_sub(1),
                    got,
                })
            })
    }
}

fn check_count(
    what: &'static str,
    expected: &'static str,
    got: usize,
    length: usize,
) -> Result<(), Error> {
    if got == length {
        return Ok(());
    }
    Err(Error::Count {
        what,
        expected,
        got,
    })
}

fn check_finite<T: Copy + Into<f64>>(what: &'static str, numbers: &[T]) -> Result<(), Error> {
    let index = numbers.iter().position(|&x| !x.into().is_finite());
    index.map_or(Ok(()), |index| {
        let got = numbers[index].into();
        Err(Error::NotFinite { what, index, got })
    })
}

/// Rounds finite numbers to f32.
fn rounded_to_f32<T: Copy + Into<f64>>(
    what: &'static str,
    numbers: &[T],
) -> Result<Vec<f32>, Error> {
    let round = |&x: &T| {
        let float = to_f32(x.into());
        let refusal = || Error::Range {
            what,
            expected: "numbers that 32 bits can hold",
            got: x.into(),
        };
        if float.is_finite() {
            Ok(float)
        } else {
            Err(refusal())
        }
    };
    numbers.iter().map(round).collect()
}

fn push_lines<T: Display + LowerExp>(text: &mut String, word: &str, numbers: &[T], count: usize) {
    for line in numbers.chunks(count) {
        text.push_str(word);
        for number in line {
            push(text, format_args!(" {}", written(number)));
        }
        text.push('\n');
    }
}

/// The unit normal of a triangle by the right-hand rule; zero if the triangle is degenerate.
fn face_normal(points: [&[f32]; 3]) -> DVec3 {
    let [a, b, c] = points.map(|p| DVec3::new(p[0].into(), p[1].into(), p[2].into()));
    let cross = (b - a).cross(c - a);
    // In f64, squares of f32 values neither overflow nor underflow.
    let length = Point::norm(cross);
    if length > 0.0 {
        cross / length
    } else {
        DVec3::ZERO
    }
}
