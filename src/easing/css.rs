//! Timing functions as CSS text. `js/geometry/easing-css.ts` reads and writes the same text, with the same error
//! messages.

use super::piecewise::{Linear, StepPosition, Steps, Stop};
use super::scanner::CssScanner;
use super::{Easing, EasingError, Kind};
use crate::text::number::written_number;
use std::fmt;
use std::str::FromStr;

/// Browsers limit the number of steps to this value.
const MAX_STEPS: f64 = 2_147_483_647.0;
const COUNT: &str = "a whole number from 1 to 2147483647";
const COUNT_WITHOUT_JUMPS: &str = "a whole number from 2 to 2147483647";

/// The function that a keyword stands for.
fn keyword(word: &str) -> Option<&'static str> {
    Some(match word {
        "linear" => "linear(0,1)",
        "ease" => "cubic-bezier(.25,.1,.25,1)",
        "ease-in" => "cubic-bezier(.42,0,1,1)",
        "ease-out" => "cubic-bezier(0,0,.58,1)",
        "ease-in-out" => "cubic-bezier(.42,0,.58,1)",
        "step-start" => "steps(1,start)",
        "step-end" => "steps(1)",
        _ => return None,
    })
}

/// What was meant by a word without its hyphens, as other libraries write it: `easeInOut`.
fn with_hyphens(word: &str) -> Option<&'static str> {
    Some(match word {
        "easein" => "ease-in",
        "easeout" => "ease-out",
        "easeinout" => "ease-in-out",
        "stepstart" => "step-start",
        "stepend" => "step-end",
        _ => return None,
    })
}

/// Reads a CSS timing function: `ease`, `ease-in`, `ease-out`, `ease-in-out`, `linear`, `step-start`, `step-end`,
/// `cubic-bezier(…)`, `steps(…)` or `linear(…)`.
///
/// Letters of either case and comments are read as CSS does; `calc()` and `var()` are not.
impl FromStr for Easing {
    type Err = EasingError;

    fn from_str(text: &str) -> Result<Self, EasingError> {
        let mut scanner = CssScanner::new(text);
        let word = scanner.word();
        let length = word.len();
        let kind = if let Some(function) = keyword(&word) {
            scanner.skip(length);
            function.parse::<Self>()?.kind
        } else {
            let read = match &*word {
                "cubic-bezier(" => read_cubic,
                "steps(" => read_steps,
                "linear(" => read_linear,
                _ => {
                    let expected = "linear, ease, ease-in, ease-out, ease-in-out, step-start, step-end, cubic-bezier(…), steps(…) or linear(…)";
                    return Err(scanner.refusal(with_hyphens(&word).unwrap_or(expected)));
                }
            };
            scanner.skip(length);
            let kind = read(&mut scanner)?;
            scanner.expect(b')', "\")\"")?;
            kind
        };
        if scanner.at_end() {
            Ok(Self { kind })
        } else {
            Err(scanner.refusal("the end of the text"))
        }
    }
}

fn read_cubic(scanner: &mut CssScanner) -> Result<Kind, EasingError> {
    let mut handles = [0.0; 4];
    for (k, handle) in handles.iter_mut().enumerate() {
        if k > 0 {
            scanner.expect(b',', "\",\"")?;
        }
        let at = scanner.at;
        *handle = scanner.number()?;
        if k % 2 == 0 && !(0.0..=1.0).contains(handle) {
            return Err(scanner.refusal_at(at, "a number from 0 to 1"));
        }
    }
    Ok(Kind::cubic(handles))
}

fn read_steps(scanner: &mut CssScanner) -> Result<Kind, EasingError> {
    let at = scanner.at;
    let is_whole = scanner.has_whole_number();
    let count = scanner.any_number()?;
    let mut position = StepPosition::End;
    if scanner.skip_if(b',') {
        let word = scanner.word();
        position = match &*word {
            "jump-start" | "start" => StepPosition::Start,
            "jump-end" | "end" => StepPosition::End,
            "jump-none" => StepPosition::None,
            "jump-both" => StepPosition::Both,
            _ => {
                let expected = "jump-start, jump-end, jump-none, jump-both, start or end";
                return Err(scanner.refusal(expected));
            }
        };
        scanner.skip(word.len());
    }
    let (min, expected) = match position {
        StepPosition::None => (2.0, COUNT_WITHOUT_JUMPS),
        _ => (1.0, COUNT),
    };
    if !(is_whole && (min..=MAX_STEPS).contains(&count)) {
        return Err(scanner.refusal_at(at, expected));
    }
    #[allow(clippy::cast_possible_truncation, reason = "at most 2³¹ − 1")]
    #[allow(clippy::cast_sign_loss, reason = "at least 1")]
    let count = count as u32;
    Ok(Kind::Steps(Steps { count, position }))
}

fn read_linear(scanner: &mut CssScanner) -> Result<Kind, EasingError> {
    let mut stops = Vec::new();
    let mut count = 0;
    loop {
        count += 1;
        // Percentages are before or after the output; two of them are two stops.
        let before = read_percentages(scanner)?;
        let y = scanner.number()?;
        let percentages = if before.is_empty() {
            read_percentages(scanner)?
        } else {
            before
        };
        if percentages.is_empty() {
            stops.push((None, y));
        }
        stops.extend(
            percentages
                .into_iter()
                .map(|percentage| (Some(percentage), y)),
        );
        if !scanner.skip_if(b',') {
            break;
        }
    }
    if count < 2 {
        return Err(scanner.refusal("\",\""));
    }
    let stops = complete_stops(&stops);
    Ok(Kind::Linear(Linear { stops }))
}

/// Reads up to two percentages.
fn read_percentages(scanner: &mut CssScanner) -> Result<Vec<f64>, EasingError> {
    let mut percentages = Vec::new();
    while percentages.len() < 2 && scanner.has_percentage() {
        percentages.push(scanner.any_number()?);
    }
    Ok(percentages)
}

/// Makes the percentages ascend and fills in the missing ones: 0 and 100 at the ends, evenly spaced between others.
fn complete_stops(given: &[(Option<f64>, f64)]) -> Vec<Stop> {
    let last = given.len() - 1;
    let mut stops: Vec<Stop> = given.iter().map(|&(_, y)| [0.0, y]).collect();
    let mut known = 0;
    let mut from = given[0].0.unwrap_or(0.0);
    let mut before = from;
    stops[0][0] = from;
    for (k, &(percentage, _)) in given.iter().enumerate().skip(1) {
        let Some(percentage) = percentage.or((k == last).then_some(100.0)) else {
            continue;
        };
        // A percentage below an earlier one is raised to it. The stops between `known` and k have none.
        let to = from.max(percentage);
        for (i, stop) in stops[known + 1..=k].iter_mut().enumerate() {
            let share = (i + 1) as f64 / (k - known) as f64;
            before = (from * (1.0 - share) + to * share).max(before).min(to); // rounding may descend
            stop[0] = before;
        }
        (known, from) = (k, to);
    }
    stops
}

/// The function as CSS text: `cubic-bezier(…)`, `steps(…)`, `linear(…)` or `linear`.
impl fmt::Display for Easing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            Kind::Cubic(cubic) => {
                let handles = cubic.handles.map(|handle| written_number(handle + 0.0));
                write!(f, "cubic-bezier({})", handles.join(", "))
            }
            Kind::Steps(Steps { count, position }) => {
                let position = match position {
                    StepPosition::Start => ", start",
                    StepPosition::End => "",
                    StepPosition::None => ", jump-none",
                    StepPosition::Both => ", jump-both",
                };
                write!(f, "steps({count}{position})")
            }
            Kind::Linear(Linear { stops }) => f.write_str(&written_linear(stops)),
        }
    }
}

/// The function `linear()` with some stops. Stops of equal output that follow each other share an argument.
pub(crate) fn written_linear(stops: &[Stop]) -> String {
    let last = stops.len() - 1;
    let mut parts = Vec::new();
    let mut k = 0;
    while k <= last {
        let [percentage, y] = stops[k];
        // Two stops stay two arguments, since one alone is invalid.
        let is_pair = last > 1 && k < last && stops[k + 1][1] == y;
        let is_implied = (k == 0 && percentage == 0.0) || (k == last && percentage == 100.0);
        let mut part = written_number(y);
        if is_pair || !is_implied {
            part += &format!(" {}%", written_number(percentage));
        }
        if is_pair {
            k += 1;
            part += &format!(" {}%", written_number(stops[k][0]));
        }
        parts.push(part);
        k += 1;
    }
    let arguments = parts.join(", ");
    if arguments == "0, 1" {
        return "linear".into();
    }
    format!("linear({arguments})")
}
