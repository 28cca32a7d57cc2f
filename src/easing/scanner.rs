//! Tokens of CSS timing functions: blanks, comments, words, numbers, percentages.

use super::EasingError;
use crate::text::shown::{END, shown};

/// The text of a timing function, read from front to back.
pub(crate) struct CssScanner<'a> {
    text: &'a str,
    pub(crate) at: usize,
}

impl<'a> CssScanner<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        let mut scanner = Self { text, at: 0 };
        scanner.skip(0);
        scanner
    }

    pub(crate) fn at_end(&self) -> bool {
        self.at == self.text.len()
    }

    fn rest(&self) -> &'a [u8] {
        &self.text.as_bytes()[self.at..]
    }

    /// Skips a token of this length, and the blanks and comments after it.
    pub(crate) fn skip(&mut self, length: usize) {
        self.at += length;
        loop {
            self.at += count(self.rest(), is_blank);
            let comment = self.text[self.at..].strip_prefix("/*");
            let Some(end) = comment.and_then(|comment| comment.find("*/")) else {
                return;
            };
            self.at += "/*".len() + end + "*/".len();
        }
    }

    pub(crate) fn skip_if(&mut self, byte: u8) -> bool {
        let found = self.rest().first() == Some(&byte);
        if found {
            self.skip(1);
        }
        found
    }

    pub(crate) fn expect(&mut self, byte: u8, expected: &'static str) -> Result<(), EasingError> {
        if self.skip_if(byte) {
            Ok(())
        } else {
            Err(self.refusal(expected))
        }
    }

    /// The word here in lower case, with the opening parenthesis that follows it directly.
    pub(crate) fn word(&self) -> String {
        let rest = self.rest();
        let length = count(rest, |byte| byte.is_ascii_alphabetic() || byte == b'-');
        let has_parenthesis = length > 0 && rest.get(length) == Some(&b'(');
        self.text[self.at..self.at + length + usize::from(has_parenthesis)].to_ascii_lowercase()
    }

    /// The length of the number here, without a percent sign; 0 if there is none.
    fn number_length(&self) -> usize {
        let rest = self.rest();
        let sign = usize::from(matches!(rest.first(), Some(b'+' | b'-')));
        let whole = count(&rest[sign..], |byte| byte.is_ascii_digit());
        let mut end = sign + whole;
        if rest.get(end) == Some(&b'.') {
            let decimals = count(&rest[end + 1..], |byte| byte.is_ascii_digit());
            if decimals > 0 {
                end += 1 + decimals;
            }
        }
        if end == sign {
            return 0;
        }
        if matches!(rest.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(rest.get(end + 1), Some(b'+' | b'-')));
            let digits = count(&rest[end + 1 + sign..], |byte| byte.is_ascii_digit());
            if digits > 0 {
                end += 1 + sign + digits;
            }
        }
        end
    }

    pub(crate) fn has_percentage(&self) -> bool {
        let length = self.number_length();
        length > 0 && self.rest().get(length) == Some(&b'%')
    }

    /// Whether a number without a decimal point, an exponent and a percent sign is here.
    pub(crate) fn has_whole_number(&self) -> bool {
        let number = &self.rest()[..self.number_length()];
        let is_whole = number
            .iter()
            .all(|byte| byte.is_ascii_digit() || b"+-".contains(byte));
        is_whole && !self.has_percentage()
    }

    /// Reads a number that is not a percentage.
    pub(crate) fn number(&mut self) -> Result<f64, EasingError> {
        if self.has_percentage() {
            return Err(self.refusal("a number"));
        }
        self.any_number()
    }

    /// Reads a number or a percentage.
    pub(crate) fn any_number(&mut self) -> Result<f64, EasingError> {
        let length = self.number_length();
        if length == 0 {
            return Err(self.refusal("a number"));
        }
        let value: f64 = self.text[self.at..self.at + length]
            .parse()
            .unwrap_or(f64::INFINITY);
        if !value.is_finite() {
            return Err(self.refusal("a finite number"));
        }
        self.skip(length + usize::from(self.has_percentage()));
        Ok(value + 0.0) // turns −0 into 0
    }

    /// The error that something else was expected here.
    pub(crate) fn refusal(&self, expected: &'static str) -> EasingError {
        self.refusal_at(self.at, expected)
    }

    /// The error that something else was expected at an offset.
    pub(crate) fn refusal_at(&self, offset: usize, expected: &'static str) -> EasingError {
        EasingError {
            offset,
            expected,
            got: self.got(offset),
        }
    }

    /// The text at an offset up to the next blank, comma or closing parenthesis, formatted for a message.
    fn got(&self, offset: usize) -> String {
        let rest = &self.text[offset..];
        let Some(first) = rest.chars().next() else {
            return END.into();
        };
        let separates = |c: char| u8::try_from(c).is_ok_and(|c| is_blank(c) || b",()".contains(&c));
        let mut length = rest.find(separates).unwrap_or(rest.len());
        if length == 0 {
            length = first.len_utf8();
        } else if rest[length..].starts_with('(') {
            length += 1;
        }
        shown(&rest[..length])
    }
}

fn count(bytes: &[u8], is_part: impl Fn(u8) -> bool) -> usize {
    bytes.iter().take_while(|&&byte| is_part(byte)).count()
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | 0x0c | b'\r')
}
