//! Writing numbers as text.

use std::fmt::{Arguments, Display, LowerExp, Write};

/// Appends formatted text; writing to a String cannot fail.
pub(crate) fn push(text: &mut String, words: Arguments<'_>) {
    let _ = text.write_fmt(words);
}

/// The fewest digits that round-trip, in the format of JavaScript (except that −0 keeps its sign): with an exponent
/// from 10²¹ on and below 10⁻⁶.
pub(crate) fn written(x: impl Display + LowerExp) -> String {
    let scientific = format!("{x:e}");
    let exponent = scientific.rsplit('e').next().map(str::parse::<i32>);
    match exponent {
        Some(Ok(21..)) => scientific.replace('e', "e+"),
        Some(Ok(..-6)) => scientific,
        _ => x.to_string(),
    }
}

/// Only a multiple of 2⁻¹⁸ can lie halfway between two shortest forms of 17 digits: a tie above 1 has at most 17
/// decimal places, hence at most as many binary places.
const DIGITS_OF_A_TIE: f64 = 262_144.0; // 2¹⁸

/// Any two numbers of at most 15 digits are read as different f64, so that a tie has more.
const DIGITS_WITHOUT_TIES: usize = 15;

/// [`written`] for all f64: if two shortest forms are equally close, JavaScript takes the even one, Rust the upper one.
pub(crate) fn written_number(x: f64) -> String {
    let mut text = String::new();
    push_number(&mut text, x);
    text
}

/// Appends [`written_number`].
pub(crate) fn push_number(text: &mut String, x: f64) {
    let (from, size) = (text.len(), x.abs());
    if size >= 1e21 {
        text.push_str(&written(x));
    } else if size < 1e-6 && size > 0.0 {
        push(text, format_args!("{x:e}"));
    } else {
        push(text, format_args!("{x}"));
    }
    let whole = size >= 1.0 / f64::EPSILON;
    let may_be_tie = size >= 1.0 && (whole || (x * DIGITS_OF_A_TIE).fract() == 0.0);
    if may_be_tie
        && text.len() - from > DIGITS_WITHOUT_TIES
        && let Some(even) = even(&text[from..], x)
    {
        text.replace_range(from.., &even);
    }
}

/// The form one below the shortest one, if its last digit is even and it is equally close.
fn even(plain: &str, x: f64) -> Option<String> {
    let mantissa = plain.split('e').next()?;
    let significant = mantissa.trim_end_matches('0').trim_end_matches('.');
    let count = significant.bytes().filter(u8::is_ascii_digit).count();
    let last = significant.bytes().last().filter(|digit| digit % 2 == 1)?;
    // In a tie the remaining digits are 5 and then zeros; 20 more digits decide it.
    let all = format!("{x:.*e}", count + 20);
    let digits: Vec<u8> = all.bytes().filter(u8::is_ascii_digit).collect();
    let tail = digits.get(count..=count + 20)?;
    if tail[0] != b'5' || tail[1..].iter().any(|&digit| digit != b'0') {
        return None;
    }
    let mut lower = plain.to_owned();
    let last_digit = significant.len() - 1..significant.len();
    lower.replace_range(last_digit, char::from(last - 1).encode_utf8(&mut [0; 4]));
    (lower.parse() == Ok(x)).then_some(lower)
}
