//! Prints generated cases as lines of JSON: `casteljau-generator SEED FUNCTION FIRST COUNT`, or `casteljau-generator list`.
//!
//! With `--javascript` after them, the lines of JavaScript that make the calls.

use casteljau_generator::{Case, FUNCTIONS, case, find};
use std::io::{BufWriter, Write};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut out = BufWriter::new(std::io::stdout().lock());
    let [seed, function, first, count, rest @ ..] = arguments.as_slice() else {
        for row in FUNCTIONS.iter() {
            writeln!(out, "{row}")?;
        }
        return Ok(());
    };
    let show: fn(&Case) -> String = match rest.first().map(String::as_str) {
        None => Case::to_json,
        Some("--javascript") => Case::to_javascript,
        Some(other) => return Err(format!("expected --javascript, got {other}").into()),
    };
    if find(function).is_none() {
        return Err(format!("expected a function of the list, got {function}").into());
    }
    let (seed, first, count): (u64, u64, u64) = (seed.parse()?, first.parse()?, count.parse()?);
    for number in first..first + count {
        writeln!(out, "{}", show(&case(seed, function, number)))?;
    }
    Ok(())
}
