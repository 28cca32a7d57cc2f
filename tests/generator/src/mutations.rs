//! Mutations of texts.

use crate::random::Rng;

/// One change to a text; places are parts of its length in 65536ths.
#[derive(Clone, Copy, Debug)]
enum Mutation {
    /// Deletes some characters at a place.
    Delete(u16, u8),
    /// Repeats some characters at a place: their number, and how often.
    Repeat(u16, u8, u8),
    /// Inserts one of the tokens.
    Token(u16, u8),
    /// Inserts a number: mantissa and exponent.
    Number(u16, i16, i16),
    /// Replaces a character by one of ASCII.
    Replace(u16, u8),
    /// Inserts any character.
    Character(u16, char),
    /// Ends the text at a place.
    Truncate(u16),
    /// Exchanges some characters at two places.
    Swap(u16, u16, u8),
}

/// What goes wrong in texts: numbers at the ends of their range, keywords, separators, encodings. They are separated by
/// vertical lines.
const TOKENS: &str = "M|m|L|Z|z|C|c|S|s|Q|T|A|a|H|v|1e999|-1e999|1e-999|NaN|Infinity|-|+|.|..|e|0|-0|00|01|4294967296|18446744073709551616\
    |1.5|99999999999999999999|,|,,|\n|\r\n|\t| |#|surface|patches|vertices|%|%E2%80%A8|&|=|(";

pub(crate) fn tokens() -> Vec<&'static str> {
    TOKENS.split('|').collect()
}

/// The text with one to eight mutations.
pub(crate) fn mutated(rng: &mut Rng, text: String) -> String {
    let count = rng.pick(&[1, 1, 2, 3, 8]);
    let mut characters: Vec<char> = text.chars().collect();
    for _ in 0..count {
        Mutation::random(rng).apply(&mut characters);
    }
    characters.into_iter().collect()
}

impl Mutation {
    fn random(rng: &mut Rng) -> Self {
        let at = |rng: &mut Rng| rng.bits16();
        let small = |rng: &mut Rng| rng.bits16().to_le_bytes()[0];
        match rng.below(8) {
            0 => Self::Delete(at(rng), small(rng)),
            1 => Self::Repeat(at(rng), small(rng), small(rng)),
            2 => Self::Token(at(rng), small(rng)),
            3 => Self::Number(at(rng), at(rng).cast_signed(), at(rng).cast_signed()),
            4 => Self::Replace(at(rng), small(rng)),
            5 => Self::Character(at(rng), rng.character()),
            6 => Self::Truncate(at(rng)),
            _ => Self::Swap(at(rng), at(rng), small(rng)),
        }
    }

    fn apply(self, text: &mut Vec<char>) {
        let length = text.len();
        let location = |at: u16| usize::from(at) * (length + 1) / 65_536;
        let range = |at: u16, count: u8| {
            let first = location(at).min(length);
            first..(first + 1 + usize::from(count % 16)).min(length).max(first)
        };
        match self {
            Self::Delete(at, count) => _ = text.drain(range(at, count)),
            Self::Repeat(at, count, times) => {
                let piece = text[range(at, count)].repeat(usize::from(times % 32));
                insert(text, range(at, count).start, piece);
            }
            Self::Token(at, token) => {
                let tokens = tokens();
                let token = tokens[usize::from(token) % tokens.len()];
                insert(text, location(at), token.chars().collect());
            }
            Self::Number(at, mantissa, exponent) => {
                let number = format!("{mantissa}e{}", exponent % 400);
                insert(text, location(at), number.chars().collect());
            }
            Self::Replace(at, byte) if length > 0 => {
                text[location(at).min(length - 1)] = char::from(byte % 128);
            }
            Self::Character(at, character) => text.insert(location(at), character),
            Self::Truncate(at) => text.truncate(location(at)),
            Self::Swap(first, second, count) if length > 0 => {
                let [first, second] = [first, second].map(location);
                for k in 0..usize::from(count % 8) {
                    text.swap((first + k) % length, (second + k) % length);
                }
            }
            _ => {}
        }
    }
}

fn insert(text: &mut Vec<char>, at: usize, piece: Vec<char>) {
    text.splice(at..at, piece);
}
