//! Surfaces from text.

use super::text_reader::{END, ParseError, Reader, number, refuse, shown, whole};
use crate::geometry::error::MAX_DEGREE;
use crate::surface::network::Surface;
use glam::DVec3;
use std::collections::HashMap;
use std::ops::Range;

/// The shortest vertex, `0 0 0` and a line break.
const VERTEX_CHARACTERS: usize = 6;
/// The shortest patch of vertex numbers: `1 1` and twice `0 0`, with line breaks.
const NET_CHARACTERS: usize = 4 + 2 * 4;
/// The shortest patch of points: `1 1` and four vertices. A row of 16 vertex numbers is longer.
const PATCH_CHARACTERS: usize = 4 + 4 * VERTEX_CHARACTERS;
/// The vertex numbers of a patch in a listing.
const LISTED: usize = 16;

impl Surface {
    /// A surface from its text, in one of three forms, told apart by their first rows.
    ///
    /// - As [`to_text`](Self::to_text) writes it: the row `surface`; `vertices` and their number, a row x y z for each;
    ///   `patches` and their number, for each a row with its degrees in u and v and below it its net, row by row, as
    ///   vertex numbers from 0.
    /// - The .bpt form: the number of patches; for each a row with its degrees and below it its points, one a row, u
    ///   along the fast index. Points with equal coordinates become one vertex.
    /// - The listing in which the teapot was handed on: the number of patches, for each a row of 16 vertex numbers from
    ///   1; the number of vertices, for each a row x y z. Bicubic.
    ///
    /// A row is a line; blanks, tabs or commas separate its words. Lines end with a line feed, a carriage return or
    /// both. Empty lines and comments, from `#` to the end of the line, do not count.
    ///
    /// The time is proportional to the length of the text, and counts are checked against that length before anything
    /// is allocated for them.
    ///
    /// # Errors
    /// [`ParseError`] with the number of the line, for a wrong count, a word that is no finite number, a degree that is
    /// not 1 to 64, a vertex that is not there.
    pub fn parse(text: &str) -> Result<Self, ParseError> {
        let mut parser = Parser {
            reader: Reader::new(text),
            // JavaScript counts in UTF-16; so both doors refuse the same texts with the same words.
            characters: text.encode_utf16().count(),
            vertices: Vec::new(),
            indices: Vec::new(),
            degrees: Vec::new(),
        };
        parser.read()?;
        let surface = Self::with_degrees(parser.vertices, parser.indices, &parser.degrees);
        surface.map_err(|error| parser.reader.refuse("a surface", error))
    }
}

/// A surface that is being read.
struct Parser<'a> {
    reader: Reader<'a>,
    characters: usize,
    vertices: Vec<DVec3>,
    indices: Vec<u32>,
    degrees: Vec<[usize; 2]>,
}

impl Parser<'_> {
    fn read(&mut self) -> Result<(), ParseError> {
        let words = self.reader.row(1);
        if words == 1 && self.reader.last_words().first() == Some(&"surface") {
            self.read_indexed()?;
        } else {
            let count = self.whole(0, "\"surface\" or the number of patches")?;
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

    /// The form that `to_text` writes, after its first row.
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
        }
        Ok(())
    }

    /// The forms that start with the number of patches, after it.
    fn read_numbered(&mut self, count: usize) -> Result<(), ParseError> {
        self.check_count(count, "patches", 0, PATCH_CHARACTERS)?;
        if count == 0 {
            return Ok(());
        }
        match self.reader.row(LISTED) {
            LISTED => self.read_listing(count),
            2 => self.read_points(count),
            0 => Err(self.reader.refuse("2 degrees or 16 vertex numbers", END)),
            got => Err(self.reader.refuse("2 degrees or 16 vertex numbers", got)),
        }
    }

    /// The .bpt form from the first degrees on, which were read.
    fn read_points(&mut self, count: usize) -> Result<(), ParseError> {
        let mut numbers = HashMap::new();
        for patch in 0..count {
            if patch > 0 {
                self.reader.words(2, "degrees")?;
            }
            let [degree_u, degree_v] = self.read_degrees()?;
            for _ in 0..(degree_u + 1) * (degree_v + 1) {
                let point = self.read_point()?;
                // −0 + 0 is 0: the same place.
                let key = (point + DVec3::ZERO).to_array().map(f64::to_bits);
                let next = self.vertices.len();
                let index = *numbers.entry(key).or_insert(next);
                if index == next {
                    self.vertices.push(point);
                }
                self.indices.push(u32::try_from(index).unwrap_or(u32::MAX));
            }
        }
        Ok(())
    }

    /// The listing from its first row of vertex numbers on, which was read.
    fn read_listing(&mut self, count: usize) -> Result<(), ParseError> {
        // The vertices come later; only then is it known how many there are.
        let (mut largest, mut line, mut word) = (0, 0, "");
        for patch in 0..count {
            if patch > 0 {
                self.reader.words(LISTED, "vertex numbers")?;
            }
            for word_index in self.read_indices(1, usize::MAX)? {
                let index = self.indices[self.indices.len() - LISTED + word_index];
                if index >= largest {
                    (largest, line) = (index, self.reader.line());
                    word = self.reader.last_words()[word_index];
                }
            }
            self.degrees.push([3, 3]);
        }
        self.reader.words(1, "number of vertices")?;
        let count = self.whole(0, "the number of vertices")?;
        self.check_count(count, "vertices", 0, VERTEX_CHARACTERS)?;
        self.read_vertices(count)?;
        if largest as usize >= count {
            return Err(refuse(line, vertex_range(1, count), shown(word)));
        }
        Ok(())
    }

    /// The count in the next row, behind its name.
    fn named_count(&mut self, name: &str, min: usize) -> Result<usize, ParseError> {
        let expected = format!("\"{name}\" and their number");
        if self.reader.row(2) != 2 || self.reader.last_words().first() != Some(&name) {
            return Err(self.refuse(0, expected));
        }
        let count = self.whole(1, expected)?;
        self.check_count(count, name, 1, min)?;
        Ok(count)
    }

    /// Refuses more than the text can hold, each taking at least that many characters.
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
        }
        Ok(point)
    }

    /// The degrees in the row that was read last.
    fn read_degrees(&mut self) -> Result<[usize; 2], ParseError> {
        let mut degrees = [0; 2];
        for (word_index, degree) in degrees.iter_mut().enumerate() {
            let expected = "a degree from 1 to 64";
            *degree = self.whole(word_index, expected)?;
            if !(1..=MAX_DEGREE).contains(degree) {
                return Err(self.refuse(word_index, expected));
            }
        }
        self.degrees.push(degrees);
        Ok(degrees)
    }

    /// The vertex numbers in the row that was read last; `count` of them are allowed, from `first` on.
    fn read_indices(&mut self, first: usize, count: usize) -> Result<Range<usize>, ParseError> {
        let word_range = 0..self.reader.last_words().len();
        for word_index in word_range.clone() {
            let number = self.whole(word_index, "a vertex number")?;
            match number.checked_sub(first) {
                // More vertices than u32 can number are more than memory holds.
                Some(index) if index < count => {
                    self.indices.push(u32::try_from(index).unwrap_or(u32::MAX));
                }
                _ => return Err(self.refuse(word_index, vertex_range(first, count))),
            }
        }
        Ok(word_range)
    }

    /// The whole number at a place of the row that was read last.
    fn whole(&self, word_index: usize, expected: impl Into<String>) -> Result<usize, ParseError> {
        let word = self.reader.last_words().get(word_index);
        let number = word.and_then(|word| whole(word));
        number.ok_or_else(|| self.refuse(word_index, expected))
    }

    /// A refusal of the word at a place of the row that was read last, or of the text's end.
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
