//! Valid and invalid path data from a small random number generator. tests/js/random-path-data.js generates the same texts,
//! so that both APIs can be compared.

/// Mulberry32 (Tommy Ettinger, 2017): 32 bits, so that JavaScript can compute it too.
pub(crate) struct Rng(u32);

impl Rng {
    pub(crate) fn new(seed: u32) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x6d2b_79f5);
        let mut t = self.0;
        t = (t ^ (t >> 15)).wrapping_mul(t | 1);
        t ^= t.wrapping_add((t ^ (t >> 7)).wrapping_mul(t | 61));
        t ^ (t >> 14)
    }

    pub(crate) fn below(&mut self, n: u32) -> u32 {
        self.next() % n
    }

    fn pick(&mut self, words: &[&'static str]) -> &'static str {
        words[self.below(u32::try_from(words.len()).expect("few")) as usize]
    }
}

const COMMANDS: [&str; 20] = [
    "M", "m", "L", "l", "H", "h", "V", "v", "C", "c", "S", "s", "Q", "q", "T", "t", "A", "a", "Z",
    "z",
];
const GARBAGE: [&str; 16] = [
    ",", ",,", "-", "+", ".", "e", "1e", "--", "x", "NaN", "é", "😀", "\u{a0}", "1e999", "2", "M",
];
const SEPARATORS: [&str; 8] = [" ", " ", " ", ",", ", ", " ,\t", "\n", "  "];

fn arguments(command: &str) -> u32 {
    match command.to_ascii_uppercase().as_str() {
        "Z" => 0,
        "H" | "V" => 1,
        "C" => 6,
        "S" | "Q" => 4,
        "A" => 7,
        _ => 2,
    }
}

fn number(rng: &mut Rng) -> String {
    let sign = rng.pick(&["", "", "", "-", "-", "+"]);
    let (a, b) = (rng.below(1000), rng.below(10_000));
    match rng.below(12) {
        0..4 => format!("{sign}{}", a % 100),
        4..7 => format!("{sign}{a}.{b}"),
        7..9 => format!("{sign}.{b}"),
        9 => format!("{sign}{}e{}", a % 10, b % 8),
        10 => format!("{sign}{}.{b}E-{}", a % 10, b % 12),
        _ => format!("{sign}{a}{b}{a}.{b}{b}{a}{b}"),
    }
}

/// Path data; one text in eight contains an error.
pub(crate) fn text(rng: &mut Rng) -> String {
    let wrong = rng.below(8) == 0;
    let mut text = rng.pick(&["M", "m"]).to_owned() + &number(rng) + " " + &number(rng);
    for _ in 0..rng.below(8) {
        let command = rng.pick(&COMMANDS);
        text += rng.pick(&["", "", " ", "\n"]);
        text += command;
        let groups = if rng.below(4) == 0 {
            1 + rng.below(3)
        } else {
            1
        };
        for k in 0..groups * arguments(command) {
            if wrong && rng.below(16) == 0 {
                text += rng.pick(&GARBAGE);
            }
            if k > 0 {
                text += rng.pick(&SEPARATORS);
            }
            let flag = arguments(command) == 7 && (k % 7 == 3 || k % 7 == 4);
            if flag {
                text += rng.pick(&["0", "1"]);
            } else {
                text += &number(rng);
            }
        }
    }
    text
}

/// FNV-1a (Fowler, Noll and Vo), 32 bits.
pub(crate) fn hash(mut state: u32, text: &str) -> u32 {
    for byte in text.bytes() {
        state = (state ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    }
    state
}
