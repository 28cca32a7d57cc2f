//! Parsing a surface from arrays of C source code; `js/io/surface-arrays.ts` does the same with the same messages.

use super::text_reader::{ParseError, number, refuse, whole_number};
use crate::geometry::check::MAX_COORDINATE;
use crate::text::shown::{END, shown};
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;

const VERTEX_ROW: usize = 3;
const PATCH_ROW: usize = 16;
/// A word or a brace, and its line.
#[derive(Clone, Copy)]
struct Token<'a> {
    word: &'a str,
    line: usize,
}

/// Vertices, and sixteen indices for each patch.
pub(super) type Arrays = (Vec<DVec3>, Vec<u32>);

/// Parses the array of vertices and the array of patches in C source code: rows of 3 coordinates and rows of 16 vertex
/// numbers, each row and each array in braces. Text outside of braces is skipped.
pub(super) fn read_arrays(text: &str) -> Result<Arrays, ParseError> {
    let mut parser = ArrayParser {
        tokens: Tokens {
            text,
            at: 0,
            line: 1,
        },
        vertices: Vec::new(),
        numbers: Vec::new(),
        min: usize::MAX,
        largest: None,
    };
    while let Some(token) = parser.tokens.next() {
        match token.word {
            "{" => parser.read_array()?,
            "}" => return Err(parser.refuse("\"{\" or the end of the text", Some(token))),
            _ => {}
        }
    }
    parser.finish()
}

struct ArrayParser<'a> {
    tokens: Tokens<'a>,
    vertices: Vec<DVec3>,
    /// The vertex numbers of all patches.
    numbers: Vec<usize>,
    min: usize,
    largest: Option<(usize, Token<'a>)>,
}

impl<'a> ArrayParser<'a> {
    /// Reads an array after its opening brace.
    fn read_array(&mut self) -> Result<(), ParseError> {
        let mut width = None;
        loop {
            let token = match self.tokens.next() {
                Some(token) if token.word == "{" => token,
                Some(token) if token.word == "}" => return Ok(()),
                other => return Err(self.refuse("\"{\" or \"}\"", other)),
            };
            let (words, count) = self.read_row()?;
            self.check_row(token.line, count, width)?;
            width = Some(count);
            if count == VERTEX_ROW {
                self.read_vertex(&words)?;
            } else {
                self.read_patch(&words)?;
            }
        }
    }

    /// Reads a row after its opening brace. Words after the 16th are only counted.
    fn read_row(&mut self) -> Result<(Vec<Token<'a>>, usize), ParseError> {
        let (mut words, mut count) = (Vec::with_capacity(PATCH_ROW), 0);
        loop {
            match self.tokens.next() {
                Some(token) if token.word == "}" => return Ok((words, count)),
                Some(token) if token.word != "{" => {
                    if count < PATCH_ROW {
                        words.push(token);
                    }
                    count += 1;
                }
                other => return Err(self.refuse("a number or \"}\"", other)),
            }
        }
    }

    /// Checks the number of words in a row against the rows before it in the same array.
    fn check_row(&self, line: usize, count: usize, width: Option<usize>) -> Result<(), ParseError> {
        if let Some(width) = width {
            if count != width {
                return Err(refuse(line, format!("{width} {}", contents(width)), count));
            }
            return Ok(());
        }
        let is_read = match count {
            VERTEX_ROW => !self.vertices.is_empty(),
            PATCH_ROW => !self.numbers.is_empty(),
            _ => return Err(refuse(line, "3 coordinates or 16 vertex numbers", count)),
        };
        if is_read {
            let expected = format!("one array of {}", contents(count));
            return Err(refuse(line, expected, "a second one"));
        }
        Ok(())
    }

    fn read_vertex(&mut self, words: &[Token<'a>]) -> Result<(), ParseError> {
        let mut vertex = DVec3::ZERO;
        for (axis, &token) in words.iter().enumerate() {
            let digits = token.word.strip_suffix(['f', 'F', 'l', 'L']);
            vertex[axis] = number(digits.unwrap_or(token.word))
                .ok_or_else(|| self.refuse("a number", Some(token)))?;
            if !vertex[axis].is_finite() {
                return Err(self.refuse("a finite number", Some(token)));
            }
            if vertex[axis].abs() > MAX_COORDINATE {
                return Err(self.refuse("a number from -2^500 to 2^500", Some(token)));
            }
        }
        self.vertices.push(vertex);
        Ok(())
    }

    fn read_patch(&mut self, words: &[Token<'a>]) -> Result<(), ParseError> {
        for &token in words {
            let digits = without_integer_suffix(token.word);
            let index = Some(digits)
                .filter(|digits| !digits.is_empty())
                .and_then(whole_number)
                .map(|index| u32::try_from(index).unwrap_or(u32::MAX) as usize) // out of range, too
                .ok_or_else(|| self.refuse("a vertex number", Some(token)))?;
            self.min = self.min.min(index);
            if self.largest.is_none_or(|(largest, _)| index > largest) {
                self.largest = Some((index, token));
            }
            self.numbers.push(index);
        }
        Ok(())
    }

    /// Makes the vertex numbers start at 0: they do if 0 occurs, and are from 1 otherwise.
    fn finish(self) -> Result<Arrays, ParseError> {
        let Some((largest, token)) = self.largest else {
            return Err(self.refuse("an array with rows of 16 vertex numbers", None));
        };
        if self.vertices.is_empty() {
            return Err(self.refuse("an array with rows of 3 coordinates", None));
        }
        let first = self.min.min(1);
        let last = self.vertices.len() - 1 + first;
        if largest > last {
            let expected = format!("a vertex number from {first} to {last}");
            return Err(self.refuse(expected, Some(token)));
        }
        let indices = self.numbers.iter().map(|&index| to_u32(index - first));
        Ok((self.vertices, indices.collect()))
    }

    /// An error at a token, or at the end of the text.
    fn refuse(&self, expected: impl Into<String>, token: Option<Token<'_>>) -> ParseError {
        match token {
            Some(Token { word, line }) => refuse(line, expected, shown(word)),
            None => refuse(self.tokens.line, expected, END),
        }
    }
}

/// What a row of this length contains.
fn contents(width: usize) -> &'static str {
    if width == VERTEX_ROW {
        "coordinates"
    } else {
        "vertex numbers"
    }
}

/// Removes up to three of the letters that mark a type, as in `12UL`.
fn without_integer_suffix(word: &str) -> &str {
    (0..3).fold(word, |word, _| {
        word.strip_suffix(['u', 'U', 'l', 'L']).unwrap_or(word)
    })
}

/// The words and braces of C source code, without comments and preprocessor lines.
struct Tokens<'a> {
    text: &'a str,
    at: usize,
    line: usize,
}

impl<'a> Tokens<'a> {
    fn next(&mut self) -> Option<Token<'a>> {
        loop {
            let length = match self.rest() {
                [] => return None,
                [b'\r', b'\n', ..] => self.break_line(2),
                [b'\r' | b'\n', ..] => self.break_line(1),
                [b'#', ..] | [b'/', b'/', ..] => self.length_while(|byte| !is_line_break(byte)),
                [b'/', b'*', ..] => self.comment(),
                [byte, ..] if is_separator(*byte) => 1,
                [b'{' | b'}' | b'/', ..] => return Some(self.token(1)),
                _ => return Some(self.token(self.length_while(is_word))),
            };
            self.at += length;
        }
    }

    fn token(&mut self, length: usize) -> Token<'a> {
        let end = self.at + length;
        // Both ends are at ASCII characters or at the ends of the text, so the slice is valid.
        let word = self.text.get(self.at..end).unwrap_or_default();
        self.at = end;
        Token {
            word,
            line: self.line,
        }
    }

    fn break_line(&mut self, length: usize) -> usize {
        self.line += 1;
        length
    }

    /// The length of the comment that starts here; counts its lines.
    fn comment(&mut self) -> usize {
        let rest = self.rest();
        let end = rest[2..].windows(2).position(|pair| pair == b"*/");
        let length = end.map_or(rest.len(), |position| position + 4);
        let comment = &rest[..length];
        let pairs = comment.windows(2).filter(|pair| *pair == b"\r\n").count();
        self.line += comment.iter().filter(|&&byte| is_line_break(byte)).count() - pairs;
        length
    }

    fn length_while(&self, is_inside: impl Fn(u8) -> bool) -> usize {
        let rest = self.rest();
        let end = rest.iter().position(|&byte| !is_inside(byte));
        end.unwrap_or(rest.len())
    }

    fn rest(&self) -> &'a [u8] {
        self.text.as_bytes().get(self.at..).unwrap_or_default()
    }
}

fn is_line_break(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

fn is_separator(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b',' | b';' | 0x0b | 0x0c)
}

fn is_word(byte: u8) -> bool {
    !is_line_break(byte) && !is_separator(byte) && !matches!(byte, b'{' | b'}' | b'#' | b'/')
}
