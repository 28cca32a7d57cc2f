//! Reading text by rows, and parse errors.

use crate::geometry::error::Error;
use crate::text::shown::END;
use std::fmt;

/// A parse error: its line, the expected and the actual text.
///
/// ```
/// use casteljau::Surface;
///
/// let error = Surface::parse("1\n1 1\n0 0 0\n1 0\n0 1 0\n1 1 0\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 4: expected 3 coordinates, got 2");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// The line number, from 1.
    pub line: usize,
    /// What the parser expected.
    pub expected: String,
    /// What the text contained.
    pub got: String,
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            line,
            expected,
            got,
        } = self;
        write!(f, "line {line}: expected {expected}, got {got}")
    }
}

impl std::error::Error for ParseError {}

impl From<ParseError> for Error {
    fn from(error: ParseError) -> Self {
        Self::Syntax {
            what: "text",
            expected: "another text",
            unit: "line",
            at: error.line,
        }
    }
}

/// A reader of text as rows of words.
///
/// Spaces, tabs and commas separate words; `#` starts a comment up to the end of the line; lines end with a line feed,
/// a carriage return or both. Lines without words are counted but skipped. `js/io/surface-text.ts` reads the same format.
pub(crate) struct RowReader<'a> {
    text: &'a str,
    at: usize,
    line: usize,
    /// The words of the current row, up to the requested number.
    words: Vec<&'a str>,
}

impl<'a> RowReader<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Self {
            text: text.strip_prefix('\u{feff}').unwrap_or(text),
            at: 0,
            line: 1,
            words: Vec::new(),
        }
    }

    /// The line number of the current row.
    pub(crate) fn line(&self) -> usize {
        self.line
    }

    /// Reads the next row and returns its number of words; 0 at the end. Words after the first `wanted` ones are only
    /// counted, because a row may be as long as the text.
    pub(crate) fn row(&mut self, wanted: usize) -> usize {
        self.words.clear();
        while !self.find_word() {
            if !self.next_line() {
                return 0;
            }
        }
        let mut count = 0;
        while self.find_word() {
            let word = self.word();
            if count < wanted {
                self.words.push(word);
            }
            count += 1;
        }
        count
    }

    /// Whether the row after the current one begins with a word.
    pub(crate) fn next_row_begins_with(&self, word: &str) -> bool {
        let mut ahead = Self {
            words: Vec::new(),
            ..*self
        };
        ahead.row(1);
        ahead.last_words().first() == Some(&word)
    }

    /// Reads the next row, which must have exactly `count` words; `what` names them.
    pub(crate) fn words(&mut self, count: usize, what: &str) -> Result<&[&'a str], ParseError> {
        match self.row(count) {
            got if got == count => Ok(&self.words),
            0 => Err(self.refuse(format!("{count} {what}"), END)),
            got => Err(self.refuse(format!("{count} {what}"), got)),
        }
    }

    /// The words of the current row.
    pub(crate) fn last_words(&self) -> &[&'a str] {
        &self.words
    }

    /// An error in the current row.
    pub(crate) fn refuse(&self, expected: impl Into<String>, got: impl ToString) -> ParseError {
        refuse(self.line, expected, got)
    }

    /// Skips blanks; returns whether a word follows on this line.
    fn find_word(&mut self) -> bool {
        self.skip(is_blank);
        if self.rest().first() == Some(&b'#') {
            self.skip(|byte| !is_line_break(byte));
        }
        self.rest()
            .first()
            .is_some_and(|&byte| !is_line_break(byte))
    }

    fn word(&mut self) -> &'a str {
        let from = self.at;
        self.skip(|byte| !is_blank(byte) && !is_line_break(byte) && byte != b'#');
        // Both ends are at ASCII characters or at the ends of the text, so the slice is valid.
        self.text.get(from..self.at).unwrap_or_default()
    }

    /// Moves to the start of the next line; returns false at the end of the text.
    fn next_line(&mut self) -> bool {
        let width = match self.rest() {
            [] => return false,
            [b'\r', b'\n', ..] => 2,
            _ => 1,
        };
        self.at += width;
        self.line += 1;
        true
    }

    fn rest(&self) -> &[u8] {
        self.text.as_bytes().get(self.at..).unwrap_or_default()
    }

    fn skip(&mut self, skipped: impl Fn(u8) -> bool) {
        let count = self.rest().iter().position(|&byte| !skipped(byte));
        self.at += count.unwrap_or(self.rest().len());
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b',' | 0x0b | 0x0c)
}

fn is_line_break(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

pub(crate) fn refuse(line: usize, expected: impl Into<String>, got: impl ToString) -> ParseError {
    ParseError {
        line,
        expected: expected.into(),
        got: got.to_string(),
    }
}

/// Parses a decimal number with optional sign, decimal point and exponent.
pub(crate) fn number(word: &str) -> Option<f64> {
    let numeric = |byte: &u8| byte.is_ascii_digit() || b"+-.eE".contains(byte);
    let numeric = word.as_bytes().iter().all(numeric); // excludes "inf" and "nan"
    numeric.then(|| word.parse().ok()).flatten()
}

/// Parses a whole number; saturates at the maximum.
pub(crate) fn whole_number(word: &str) -> Option<usize> {
    let digits = word.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| word.parse().unwrap_or(usize::MAX))
}
