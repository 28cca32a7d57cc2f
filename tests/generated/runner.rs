//! Runs the cases of a group on a thread with a large stack, reports failures, and names a call that does not return.

use crate::check::{self, Checked, Failure};
use casteljau::path::take_replaced_segments;
use casteljau_generator::{Case, case, find};
use std::collections::BTreeMap;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// A function and the check of one call of it.
pub(crate) type Row = (&'static str, fn(&Case) -> Checked);

const SEED: u64 = 11;
const CASES: u64 = 2_000;
/// With the environment variable `CASTELJAU_FEW`.
const FEW_CASES: u64 = 250;
const DEEP_CASES: u64 = 10_000;
/// A call that takes longer than this counts as one that does not return. No successful call takes a thousandth of it.
const HANG: Duration = Duration::from_secs(120);
/// Lines replace segments in at most one of this number of calls; scales are mixed in half of the calls.
const MIN_CALLS_WITHOUT_LINES: usize = 20;
/// The maximum number of failures of a function that are shown.
const SHOWN: usize = 2;

/// The settings from the environment.
#[derive(Clone)]
pub(crate) struct Settings {
    pub(crate) seed: u64,
    pub(crate) cases: u64,
    only: Option<(String, Option<u64>)>,
}

impl Settings {
    pub(crate) fn read() -> Self {
        let number = |name: &str| {
            std::env::var(name)
                .ok()
                .map(|text| text.parse().expect("a whole number"))
        };
        let set = |name: &str| std::env::var_os(name).is_some();
        let usual = match (set("CASTELJAU_DEEP"), set("CASTELJAU_FEW")) {
            (true, _) => DEEP_CASES,
            (_, true) => FEW_CASES,
            _ => CASES,
        };
        let only = std::env::var("CASTELJAU_ONLY")
            .ok()
            .map(|text| match text.rsplit_once(':') {
                Some((name, digits))
                    if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) =>
                {
                    (name.to_owned(), digits.parse().ok())
                }
                _ => (text, None),
            });
        Self {
            seed: number("CASTELJAU_SEED").unwrap_or(SEED),
            cases: number("CASTELJAU_CASES").unwrap_or(usual),
            only,
        }
    }

    /// The numbers of the cases of a function that are selected.
    pub(crate) fn numbers(&self, function: &str) -> std::ops::Range<u64> {
        let Some((name, number)) = &self.only else {
            return 0..self.cases;
        };
        let wanted = find(name).unwrap_or_else(|| panic!("CASTELJAU_ONLY: no function {name}"));
        match number {
            _ if wanted.name != function => 0..0,
            Some(number) => *number..*number + 1,
            None => 0..self.cases,
        }
    }
}

/// The results of some calls.
#[derive(Default)]
struct Results {
    /// The failures of each function: their number, and the texts of the first ones.
    failures: BTreeMap<&'static str, (usize, Vec<String>)>,
    calls: usize,
    /// The number of calls in which lines replaced segments of a contradictory division of the plane.
    calls_with_lines: usize,
}

impl Results {
    fn add(&mut self, case: &Case, message: &str) {
        let (count, shown) = self.failures.entry(case.function).or_default();
        *count += 1;
        if shown.len() < SHOWN {
            let text = describe(case, message);
            // Written at once and not captured, so that an interrupted run has reported its failures.
            let _ = writeln!(std::io::stderr(), "{text}");
            shown.push(text);
        }
    }

    fn report(&self) -> String {
        let mut text = format!("{} functions failed\n", self.failures.len());
        for (name, (count, shown)) in &self.failures {
            text += &format!("\n{name}: {count} failures\n{}\n", shown.join("\n"));
        }
        text
    }
}

/// Runs the checks and fails with a list of the failures.
pub(crate) fn run(rows: &'static [Row]) {
    let (started, cases) = channel();
    let work = move || {
        let (settings, mut results) = (Settings::read(), Results::default());
        for &(name, check) in rows {
            for number in settings.numbers(name) {
                let _ = started.send((name, number)); // fails when this call has been given up
                let case = case(settings.seed, name, number);
                let outcome = guarded(check, &case);
                results.calls += 1;
                results.calls_with_lines += usize::from(take_replaced_segments() > 0);
                if let Err(Failure(message)) = outcome {
                    results.add(&case, &message);
                }
            }
        }
        results
    };
    let builder = std::thread::Builder::new().stack_size(16 << 20);
    let worker = builder.spawn(work).expect("a thread");
    let mut last = ("", 0);
    loop {
        match cases.recv_timeout(HANG) {
            Ok(case) => last = case,
            Err(RecvTimeoutError::Disconnected) => break,
            Err(RecvTimeoutError::Timeout) => {
                panic!("{}:{}: no answer after {HANG:?}", last.0, last.1)
            }
        }
    }
    let results = worker.join().expect("panics of checks are failures");
    assert!(results.failures.is_empty(), "{}", results.report());
    let (some, all) = (results.calls_with_lines, results.calls);
    println!("lines replaced segments in {some} of {all} calls");
    assert!(
        some * MIN_CALLS_WITHOUT_LINES <= all + MIN_CALLS_WITHOUT_LINES,
        "{some} of {all}"
    );
}

/// Runs a check and turns its panics into failures.
pub(crate) fn guarded(check: fn(&Case) -> Checked, case: &Case) -> Checked {
    check::start(case);
    catch_unwind(AssertUnwindSafe(|| check(case))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
        Err(format!("panicked: {}", text.unwrap_or_default()).into())
    })
}

/// The text of a failure, with the command that repeats it and the call in JavaScript.
fn describe(case: &Case, message: &str) -> String {
    let Case {
        function,
        seed,
        number,
        mode,
        ..
    } = case;
    format!(
        "{function}, seed {seed}, number {number} ({mode:?}): {message}\n  repeat: CASTELJAU_SEED={seed} CASTELJAU_ONLY={function}:{number} cargo test --test generated\n  {}",
        case.to_javascript()
    )
}
