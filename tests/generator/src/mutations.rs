//! Mutations of texts.
//!
//! They are values of `arbitrary`, read from seeded bytes: a fuzzer that supplies the bytes can drive the same code.

use crate::random::Rng;
use arbitrary::{Arbitrary, Unstructured};

/// One change to a text; places are parts of its length in 65536ths.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Mutation {
    Delete {
        at: u16,
        count: u8,
    },
    Repeat {
        at: u16,
        count: u8,
        times: u8,
    },
    Token {
        at: u16,
        token: u8,
    },
    Number {
        at: u16,
        mantissa: i16,
        exponent: i16,
    },
    Replace {
        at: u16,
        byte: u8,
    },
    Character {
        at: u16,
        character: char,
    },
    Truncate {
        at: u16,
    },
    Swap {
        first: u16,
        second: u16,
        count: u8,
    },
}

/// What goes wrong in texts: numbers at the ends of their range, keywords, separators, encodings.
pub(crate) const TOKENS: [&str; 48] = [
    "M",
    "m",
    "L",
    "Z",
    "z",
    "C",
    "c",
    "S",
    "s",
    "Q",
    "T",
    "A",
    "a",
    "H",
    "v",
    "1e999",
    "-1e999",
    "1e-999",
    "NaN",
    "Infinity",
    "-",
    "+",
    ".",
    "..",
    "e",
    "0",
    "-0",
    "00",
    "01",
    "4294967296",
    "18446744073709551616",
    "1.5",
    "99999999999999999999",
    ",",
    ",,",
    "\n",
    "\r\n",
    "\t",
    " ",
    "#",
    "surface",
    "patches",
    "vertices",
    "%",
    "%E2%80%A8",
    "&",
    "=",
    "(",
];

/// The text with one to eight mutations.
pub(crate) fn mutated(rng: &mut Rng, text: String) -> String {
    let count = rng.pick(&[1, 1, 2, 3, 8]);
    let bytes = rng.bytes(16 * count);
    let mut source = Unstructured::new(&bytes);
    let mut characters: Vec<char> = text.chars().collect();
    for _ in 0..count {
        let Ok(mutation) = Mutation::arbitrary(&mut source) else {
            break;
        };
        mutation.apply(&mut characters);
    }
    characters.into_iter().collect()
}

impl Mutation {
    fn apply(self, text: &mut Vec<char>) {
        let length = text.len();
        let location = |at: u16| usize::from(at) * (length + 1) / 65_536;
        let end = |at: usize, count: u8| (at + 1 + usize::from(count % 16)).min(length);
        match self {
            Self::Delete { at, count } => {
                let at = location(at).min(length);
                text.drain(at..end(at, count).max(at));
            }
            Self::Repeat { at, count, times } => {
                let at = location(at).min(length);
                let piece = text[at..end(at, count).max(at)].to_vec();
                insert(text, at, piece.repeat(usize::from(times % 32)));
            }
            Self::Token { at, token } => {
                insert(
                    text,
                    location(at),
                    TOKENS[usize::from(token) % TOKENS.len()].chars().collect(),
                );
            }
            Self::Number {
                at,
                mantissa,
                exponent,
            } => {
                insert(
                    text,
                    location(at),
                    format!("{mantissa}e{}", exponent % 400).chars().collect(),
                );
            }
            Self::Replace { at, byte } if length > 0 => {
                text[location(at).min(length - 1)] = char::from(byte % 128);
            }
            Self::Character { at, character } => text.insert(location(at), character),
            Self::Truncate { at } => text.truncate(location(at)),
            Self::Swap {
                first,
                second,
                count,
            } if length > 0 => {
                for k in 0..usize::from(count % 8) {
                    text.swap(
                        (location(first) + k) % length,
                        (location(second) + k) % length,
                    );
                }
            }
            _ => {}
        }
    }
}

fn insert(text: &mut Vec<char>, at: usize, piece: Vec<char>) {
    text.splice(at..at, piece);
}
