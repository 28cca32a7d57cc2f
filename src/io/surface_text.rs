//! Writing surfaces as text, and parsing them.

use super::surface_arrays::read_arrays;
use super::text_reader::{ParseError, RowReader, number, refuse, whole_number};
use crate::geometry::check::MAX_COORDINATE;
use crate::geometry::error::MAX_DEGREE;
use crate::mesh::mesh_patch::PatchNetwork;
use crate::rational::{MAX_WEIGHT, RationalSurface};
use crate::surface::network::Surface;
use crate::text::number::{push, written_number};
use crate::text::shown::{END, shown};
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;
use std::collections::HashMap;
use std::ops::Range;

/// The minimum length of a vertex: `0 0 0` and a line break.
const VERTEX_CHARACTERS: usize = 6;
/// The minimum length of a patch given by vertex numbers: `1 1` and two rows `0 0`, with line breaks.
const NET_CHARACTERS: usize = 4 + 2 * 4;
/// The minimum length of a patch given by points: `1 1` and four vertices. A row of 16 vertex numbers is longer.
const PATCH_CHARACTERS: usize = 4 + 4 * VERTEX_CHARACTERS;
/// The number of vertex numbers of a patch in the listing form.
const LISTED_NUMBERS: usize = 16;

impl Surface {
    /// The surface as text; [`parse`](Self::parse) reads back an equal surface, bit for bit.
    ///
    /// The only exception are vertices that were moved to the same point: reading merges them, as every new surface
    /// does.
    ///
    /// The format: the row `surface`; `vertices` and their number, then a row x y z for each; `patches` and their
    /// number, then for each a row with its degrees in u and v, followed by its net: a row for each j with the vertex
    /// numbers, from 0, of its points Pᵢⱼ.
    ///
    /// ```
    /// use casteljau::{Surface, glam::DVec3};
    ///
    /// let square = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.5)];
    /// let surface = Surface::new(square.to_vec(), vec![0, 1, 2, 3], 1, 1)?;
    /// let text = surface.to_text();
    /// assert_eq!(
    ///     text.lines().collect::<Vec<_>>(),
    ///     ["surface", "vertices 4", "0 0 0", "1 0 0", "0 1 0", "1 1 0.5", "patches 1", "1 1", "0 1", "2 3"],
    /// );
    /// assert_eq!(Surface::parse(&text), Ok(surface));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn to_text(&self) -> String {
        written(self, |_, _| None)
    }

    /// Parses a surface from text in one of four forms, which are distinguished by their first rows.
    ///
    /// - The form of [`to_text`](Self::to_text): the row `surface`; `vertices` and their number, then a row x y z for
    ///   each; `patches` and their number, then for each a row with its degrees in u and v, followed by its net, row by
    ///   row, as vertex numbers from 0.
    /// - The .bpt form: the number of patches; for each patch a row with its degrees, followed by its points, one per
    ///   row, with u as the fast index. Points with equal coordinates become one vertex.
    /// - The listing in which the teapot was distributed: the number of patches, then a row of 16 vertex numbers from 1
    ///   for each; the number of vertices, then a row x y z for each. All patches are bicubic.
    ///
    /// - The arrays of C source code in which many programs carry the teapot: an array whose rows are 3 coordinates in
    ///   braces, and an array whose rows are 16 vertex numbers in braces, in either order. The numbers are from 0 if 0
    ///   occurs, otherwise from 1. Declarations around the arrays and the comments of C are skipped. All patches are
    ///   bicubic, and the vertices keep their order.
    ///
    /// In the other three forms, each row is a line; its words are separated by spaces, tabs or commas. Lines end with a line feed, a carriage
    /// return or both. Empty lines and comments (from `#` to the end of the line) are ignored.
    ///
    /// The time is proportional to the length of the text. Counts are checked against that length before memory is
    /// allocated for them.
    ///
    /// # Errors
    /// [`ParseError`] with the line number, for a wrong count, a word that is not a finite number, a degree outside 1
    /// to 64, or a vertex that does not exist.
    pub fn parse(text: &str) -> Result<Self, ParseError> {
        let mut parser = SurfaceParser::new(text);
        parser.read()?;
        let surface = Self::with_degrees(parser.vertices, parser.indices, &parser.degrees);
        surface.map_err(|error| parser.reader.refuse("a surface", error))
    }
}

impl RationalSurface {
    /// The surface as text; [`parse`](Self::parse) reads back an equal surface, bit for bit, with the exception that
    /// [`Surface::to_text`] names.
    ///
    /// The format is that of [`Surface::to_text`]. The net of a patch whose weights are not all 1 is followed by rows of the letter
    /// w and the weights of a row of the net.
    ///
    /// ```
    /// use casteljau::{RationalSurface, glam::DVec3};
    ///
    /// let square = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.5)];
    /// let surface = RationalSurface::new(square, vec![0, 1, 2, 3], vec![1.0, 1.0, 2.0, 0.5], 1, 1)?;
    /// let text = surface.to_text();
    /// assert!(text.ends_with("1 1\n0 1\n2 3\nw 1 1\nw 2 0.5\n"));
    /// assert_eq!(RationalSurface::parse(&text), Ok(surface));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn to_text(&self) -> String {
        written(self.network(), |patch, row| {
            let weights = self.patch_weights(patch)?;
            let columns = self.degrees(patch)?[0] + 1;
            let row = weights.get(row * columns..(row + 1) * columns)?;
            weights.iter().any(|&w| w != 1.0).then_some(row)
        })
    }

    /// Parses a surface from the text of [`to_text`](Self::to_text) or a text that [`Surface::parse`] reads. Weights are 1 where
    /// there are none.
    ///
    /// # Errors
    /// As [`Surface::parse`], also for a weight that is not a number from 2⁻⁵⁰⁰ to 2⁵⁰⁰.
    pub fn parse(text: &str) -> Result<Self, ParseError> {
        let mut parser = SurfaceParser::new(text);
        parser.weights = Some(Vec::new());
        parser.read()?;
        let mut weights = parser.weights.unwrap_or_default();
        weights.resize(parser.indices.len(), 1.0);
        let (vertices, indices) = (parser.vertices, parser.indices);
        let surface = Self::with_degrees(vertices, indices, weights, &parser.degrees);
        surface.map_err(|error| parser.reader.refuse("a surface", error))
    }
}

/// The text of a surface; `weights` returns those of a row of a patch, if they are written.
fn written<'a>(surface: &Surface, weights: impl Fn(usize, usize) -> Option<&'a [f64]>) -> String {
    let mut text = format!("surface\nvertices {}\n", surface.vertices().len());
    for vertex in surface.vertices() {
        let [x, y, z] = vertex.to_array().map(written_number);
        push(&mut text, format_args!("{x} {y} {z}\n"));
    }
    push(
        &mut text,
        format_args!("patches {}\n", surface.patch_count()),
    );
    for patch in 0..surface.patch_count() {
        let [degree_u, degree_v] = surface.degrees(patch).unwrap_or_default();
        push(&mut text, format_args!("{degree_u} {degree_v}\n"));
        let indices = surface.patch_indices(patch).unwrap_or_default();
        for (last_digit, index) in indices.iter().enumerate() {
            let last = last_digit % (degree_u + 1) == degree_u;
            push(
                &mut text,
                format_args!("{index}{}", if last { '\n' } else { ' ' }),
            );
        }
        for weights in (0..=degree_v).map_while(|row| weights(patch, row)) {
            text.push('w');
            for &weight in weights {
                push(&mut text, format_args!(" {}", written_number(weight)));
            }
            text.push('\n');
        }
    }
    text
}

/// The state of the surface parser.
struct SurfaceParser<'a> {
    text: &'a str,
    reader: RowReader<'a>,
    characters: usize,
    vertices: Vec<DVec3>,
    indices: Vec<u32>,
    degrees: Vec<[usize; 2]>,
    /// `None` if weights are not allowed.
    weights: Option<Vec<f64>>,
}

impl<'a> SurfaceParser<'a> {
    fn new(text: &'a str) -> Self {
        Self {
            text,
            reader: RowReader::new(text),
            // Count in UTF-16 as JavaScript does, so that both parsers refuse the same texts with the same messages.
            characters: text.encode_utf16().count(),
            vertices: Vec::new(),
            indices: Vec::new(),
            degrees: Vec::new(),
            weights: None,
        }
    }

    fn read(&mut self) -> Result<(), ParseError> {
        let words = self.reader.row(1);
        if words == 1 && self.reader.last_words().first() == Some(&"surface") {
            self.read_indexed()?;
        } else if self.has_arrays() {
            return self.read_arrays();
        } else {
            let count = self.whole_number(0, "\"surface\" or the number of patches")?;
            if words > 1 {
                let got = format!("{words} words");
                return Err(self.reader.refuse("the number of patches alone", got));
            }
            self.read_numbered(count)?;
        }
        match self.reader.row(1) {
            0 => Ok(()),
            _ => Err(self.refuse(0, "the end of the text")),
        }
    }

    /// Whether the text is C source code: it has a brace, and no number of patches in its first row.
    fn has_arrays(&self) -> bool {
        let first = self.reader.last_words().first();
        self.text.contains('{') && first.and_then(|word| whole_number(word)).is_none()
    }

    fn read_arrays(&mut self) -> Result<(), ParseError> {
        (self.vertices, self.indices) = read_arrays(self.text)?;
        self.degrees = vec![[3, 3]; self.indices.len() / LISTED_NUMBERS];
        Ok(())
    }

    /// Reads the form of `to_text`, after its first row.
    fn read_indexed(&mut self) -> Result<(), ParseError> {
        let count = self.named_count("vertices", VERTEX_CHARACTERS)?;
        self.read_vertices(count)?;
        let patches = self.named_count("patches", NET_CHARACTERS)?;
        for _ in 0..patches {
            self.reader.words(2, "degrees")?;
            let [degree_u, degree_v] = self.read_degrees()?;
            for _ in 0..=degree_v {
                self.reader.words(degree_u + 1, "vertex numbers")?;
                self.read_indices(0, count)?;
            }
            self.read_weights(degree_u + 1, degree_v + 1)?;
        }
        Ok(())
    }

    /// Reads the weights of a patch, or sets them to 1 if there are none.
    fn read_weights(&mut self, columns: usize, rows: usize) -> Result<(), ParseError> {
        let Some(mut weights) = self.weights.take() else {
            return Ok(());
        };
        if self.reader.next_row_begins_with("w") {
            for _ in 0..rows {
                self.reader.words(columns + 1, "words: w and weights")?;
                if self.reader.last_words().first() != Some(&"w") {
                    return Err(self.refuse(0, "\"w\""));
                }
                for index in 1..=columns {
                    let weight = number(self.reader.last_words()[index]);
                    let is_valid = |w: &f64| (1.0 / MAX_WEIGHT..=MAX_WEIGHT).contains(w);
                    let weight = weight.filter(is_valid).ok_or_else(|| {
                        self.refuse(index, "a number above 0, from 2^-500 to 2^500")
                    })?;
                    weights.push(weight);
                }
            }
        } else {
            weights.resize(weights.len() + columns * rows, 1.0);
        }
        self.weights = Some(weights);
        Ok(())
    }

    /// Reads one of the forms that start with the number of patches, after that number.
    fn read_numbered(&mut self, count: usize) -> Result<(), ParseError> {
        self.check_count(count, "patches", 0, PATCH_CHARACTERS)?;
        if count == 0 {
            return Ok(());
        }
        match self.reader.row(LISTED_NUMBERS) {
            LISTED_NUMBERS => self.read_listing(count),
            2 => self.read_points(count),
            0 => Err(self.reader.refuse("2 degrees or 16 vertex numbers", END)),
            got => Err(self.reader.refuse("2 degrees or 16 vertex numbers", got)),
        }
    }

    /// Reads the .bpt form; the row of the first degrees has already been read.
    fn read_points(&mut self, count: usize) -> Result<(), ParseError> {
        let mut numbers = HashMap::new();
        for patch in 0..count {
            if patch > 0 {
                self.reader.words(2, "degrees")?;
            }
            let [degree_u, degree_v] = self.read_degrees()?;
            for _ in 0..(degree_u + 1) * (degree_v + 1) {
                let point = self.read_point()?;
                // Adding 0 turns −0 into 0, so that both give the same vertex.
                let key = (point + DVec3::ZERO).to_array().map(f64::to_bits);
                let next = self.vertices.len();
                let index = *numbers.entry(key).or_insert(next);
                if index == next {
                    self.vertices.push(point);
                }
                self.indices.push(to_u32(index));
            }
        }
        Ok(())
    }

    /// Reads the listing form; its first row of vertex numbers has already been read.
    fn read_listing(&mut self, count: usize) -> Result<(), ParseError> {
        // The vertices follow the patches, so the range of the vertex numbers is checked at the end.
        let (mut largest, mut line, mut word) = (0, 0, "");
        for patch in 0..count {
            if patch > 0 {
                self.reader.words(LISTED_NUMBERS, "vertex numbers")?;
            }
            for word_index in self.read_indices(1, usize::MAX)? {
                let index = self.indices[self.indices.len() - LISTED_NUMBERS + word_index];
                if index >= largest {
                    (largest, line) = (index, self.reader.line());
                    word = self.reader.last_words()[word_index];
                }
            }
            self.degrees.push([3, 3]);
        }
        self.reader.words(1, "number of vertices")?;
        let count = self.whole_number(0, "the number of vertices")?;
        self.check_count(count, "vertices", 0, VERTEX_CHARACTERS)?;
        self.read_vertices(count)?;
        if largest as usize >= count {
            return Err(refuse(line, vertex_range(1, count), shown(word)));
        }
        Ok(())
    }

    /// The count in the next row, after its name.
    fn named_count(&mut self, name: &str, min: usize) -> Result<usize, ParseError> {
        let expected = format!("\"{name}\" and their number");
        if self.reader.row(2) != 2 || self.reader.last_words().first() != Some(&name) {
            return Err(self.refuse(0, expected));
        }
        let count = self.whole_number(1, expected)?;
        self.check_count(count, name, 1, min)?;
        Ok(count)
    }

    /// Returns an error for a count that the text cannot hold, at the given minimum of characters per item.
    fn check_count(
        &self,
        count: usize,
        name: &str,
        word_index: usize,
        min: usize,
    ) -> Result<(), ParseError> {
        let (characters, max) = (self.characters, self.characters / min);
        if count <= max {
            return Ok(());
        }
        let expected = format!("at most {max} {name} in a text of {characters} characters");
        Err(self.refuse(word_index, expected))
    }

    fn read_vertices(&mut self, count: usize) -> Result<(), ParseError> {
        for _ in 0..count {
            let vertex = self.read_point()?;
            self.vertices.push(vertex);
        }
        Ok(())
    }

    /// The next row as a point.
    fn read_point(&mut self) -> Result<DVec3, ParseError> {
        self.reader.words(3, "coordinates")?;
        let mut point = DVec3::ZERO;
        for axis in 0..3 {
            let word = self.reader.last_words()[axis];
            point[axis] = number(word).ok_or_else(|| self.refuse(axis, "a number"))?;
            if !point[axis].is_finite() {
                return Err(self.refuse(axis, "a finite number"));
            }
            if point[axis].abs() > MAX_COORDINATE {
                return Err(self.refuse(axis, "a number from -2^500 to 2^500"));
            }
        }
        Ok(point)
    }

    /// The degrees in the current row.
    fn read_degrees(&mut self) -> Result<[usize; 2], ParseError> {
        let mut degrees = [0; 2];
        for (word_index, degree) in degrees.iter_mut().enumerate() {
            let expected = "a degree from 1 to 64";
            *degree = self.whole_number(word_index, expected)?;
            if !(1..=MAX_DEGREE).contains(degree) {
                return Err(self.refuse(word_index, expected));
            }
        }
        self.degrees.push(degrees);
        Ok(degrees)
    }

    /// The vertex numbers in the current row; `count` different ones are allowed, from `first` on.
    fn read_indices(&mut self, first: usize, count: usize) -> Result<Range<usize>, ParseError> {
        let word_range = 0..self.reader.last_words().len();
        for word_index in word_range.clone() {
            let number = self.whole_number(word_index, "a vertex number")?;
            match number.checked_sub(first) {
                // A number above the range of u32 cannot occur: that many vertices exceed the memory.
                Some(index) if index < count => {
                    self.indices.push(to_u32(index));
                }
                _ => return Err(self.refuse(word_index, vertex_range(first, count))),
            }
        }
        Ok(word_range)
    }

    /// The whole number at a position in the current row.
    fn whole_number(
        &self,
        word_index: usize,
        expected: impl Into<String>,
    ) -> Result<usize, ParseError> {
        let word = self.reader.last_words().get(word_index);
        let number = word.and_then(|word| whole_number(word));
        number.ok_or_else(|| self.refuse(word_index, expected))
    }

    /// An error for the word at a position in the current row, or for the end of the text.
    fn refuse(&self, word_index: usize, expected: impl Into<String>) -> ParseError {
        let word = self.reader.last_words().get(word_index);
        let got = word.map_or(END.into(), |word| shown(word));
        self.reader.refuse(expected, got)
    }
}

fn vertex_range(first: usize, count: usize) -> String {
    match count {
        0 => "no vertex numbers, as there are no vertices".into(),
        usize::MAX => format!("a vertex number from {first}"),
        _ => format!("a vertex number from {first} to {}", first + count - 1),
    }
}
