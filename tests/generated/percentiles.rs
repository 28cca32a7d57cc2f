//! A table of steps and CPU time per function: `cargo test --release --test generated percentiles -- --ignored --nocapture`.

use crate::check;
use crate::runner::{self, Row, Settings};
use casteljau_generator::case;
use std::fmt::Write;

/// In thousandths: the median, 90 %, 99 %, 99.9 % and the maximum.
const PER_MILLE: [usize; 5] = [500, 900, 990, 999, 1000];

/// Prints the table; nothing is asserted. `CASTELJAU_CASES` and `CASTELJAU_ONLY` select the calls.
#[test]
#[ignore = "prints a table, asserts nothing"]
fn percentiles() {
    let settings = Settings::read();
    println!(
        "| function | steps 50 % | 90 % | 99 % | 99.9 % | max | µs 50 % | 90 % | 99 % | 99.9 % | max (case) |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for line in crate::rows().filter_map(|row| line(row, &settings)) {
        println!("{line}");
    }
}

fn line((name, check): Row, settings: &Settings) -> Option<String> {
    check::count_time();
    let (mut steps, mut times) = (Vec::new(), Vec::new());
    for number in settings.numbers(name) {
        let _ = runner::guarded(check, &case(settings.seed, name, number));
        let (used, time) = check::work();
        steps.push((used, number));
        times.push((time, number));
    }
    steps.sort_unstable();
    times.sort_unstable();
    let at = |part: usize| (steps.len() * part).div_ceil(1000).checked_sub(1);
    let mut line = format!("| {name} |");
    for part in PER_MILLE {
        let _ = write!(line, " {} |", steps[at(part)?].0);
    }
    for part in PER_MILLE {
        let (time, number) = times[at(part)?];
        let _ = write!(line, " {}.{}", time / 1000, time / 100 % 10);
        line += &if part == 1000 {
            format!(" ({number}) |")
        } else {
            String::from(" |")
        };
    }
    Some(line)
}
