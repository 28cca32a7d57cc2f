//! Tokens of SVG path data: separators, numbers, flags. `js/io/svg-number.ts` reads the same grammar.

use crate::text::shown::{END, shown};

/// A syntax error: its offset and what was expected.
pub(crate) struct Refusal {
    pub(crate) offset: usize,
    pub(crate) expected: &'static str,
}

/// A scanner of SVG path data.
pub(crate) struct SvgScanner<'a> {
    text: &'a str,
    pub(crate) at: usize,
}

impl<'a> SvgScanner<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// The next character, 0 at the end (and for a NUL, which is invalid everywhere).
    pub(crate) fn peek(&self) -> u8 {
        self.text.as_bytes().get(self.at).copied().unwrap_or(0)
    }

    pub(crate) fn at_end(&self) -> bool {
        self.at >= self.text.len()
    }

    pub(crate) fn skip_blanks(&mut self) {
        while is_blank(self.peek()) {
            self.at += 1;
        }
    }

    /// Skips blanks and at most one comma; returns whether there was a comma.
    pub(crate) fn skip_separator(&mut self) -> bool {
        self.skip_blanks();
        let comma = self.peek() == b',';
        if comma {
            self.at += 1;
            self.skip_blanks();
        }
        comma
    }

    /// Whether a number may start here.
    pub(crate) fn at_number(&self) -> bool {
        matches!(self.peek(), b'0'..=b'9' | b'.' | b'+' | b'-')
    }

    /// Reads a number: an optional sign, digits with an optional decimal point, an optional exponent. It is the longest
    /// possible one: "1.5.5" gives 1.5 and 0.5.
    pub(crate) fn number(&mut self) -> Result<f64, Refusal> {
        let from = self.at;
        self.skip_one_of(b"+-");
        let mut digits = self.skip_digits();
        if self.skip_one_of(b".") {
            digits += self.skip_digits();
        }
        if digits == 0 {
            return Err(Refusal {
                offset: from,
                expected: "a number",
            });
        }
        let mantissa_end = self.at;
        if self.skip_one_of(b"eE") {
            self.skip_one_of(b"+-");
            if self.skip_digits() == 0 {
                self.at = mantissa_end;
            }
        }
        let value = self.text[from..self.at].parse().unwrap_or(f64::INFINITY);
        if f64::is_finite(value) {
            return Ok(value);
        }
        Err(Refusal {
            offset: from,
            expected: "a finite number",
        })
    }

    /// Reads a flag of an arc, one character.
    pub(crate) fn flag(&mut self) -> Result<bool, Refusal> {
        let flag = self.peek();
        if matches!(flag, b'0' | b'1') {
            self.at += 1;
            return Ok(flag == b'1');
        }
        Err(Refusal {
            offset: self.at,
            expected: "a flag (0 or 1)",
        })
    }

    /// The text from an offset up to the next blank or comma (or that character itself), formatted for a message.
    pub(crate) fn shown(&self, offset: usize) -> String {
        let rest = self.text.get(offset..).unwrap_or_default();
        let Some(first) = rest.chars().next() else {
            return END.into();
        };
        let separates = |c: char| c == ',' || u8::try_from(c).is_ok_and(is_blank);
        let length = match rest.find(separates) {
            Some(0) => first.len_utf8(),
            Some(length) => length,
            None => rest.len(),
        };
        shown(&rest[..length])
    }

    fn skip_one_of(&mut self, bytes: &[u8]) -> bool {
        let found = bytes.contains(&self.peek());
        self.at += usize::from(found);
        found
    }

    fn skip_digits(&mut self) -> usize {
        let from = self.at;
        while self.peek().is_ascii_digit() {
            self.at += 1;
        }
        self.at - from
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | 0x0c | b'\r')
}
