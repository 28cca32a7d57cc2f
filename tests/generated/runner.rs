//! Runs the cases of a group on a thread of its own, watches for calls that do not return, and reports failures.

use crate::check::{self, Checked};
use casteljau_generator::{Case, case, find};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// A function and the check of one call.
pub(crate) type Row = (&'static str, fn(&Case) -> Checked);

const SEED: u64 = 11;
const CASES: u64 = 2_000;
const DEEP_CASES: u64 = 100_000;
/// A call that takes longer than this is reported as one that does not return. No answer takes a thousandth of it.
const HANG: Duration = Duration::from_secs(60);
/// Failures of a function that are shown.
const SHOWN: usize = 2;

/// What the environment asks for.
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
        let deep = if std::env::var_os("CASTELJAU_DEEP").is_some() {
            DEEP_CASES
        } else {
            CASES
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
            cases: number("CASTELJAU_CASES").unwrap_or(deep),
            only,
        }
    }

    /// The numbers of the cases of a function that are asked for.
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

type Current = Arc<Mutex<Option<(Case, Instant)>>>;

/// Runs the checks and fails with a list of what was found.
pub(crate) fn run(tables: &'static [&'static [Row]]) {
    let settings = Settings::read();
    let (current, (sender, receiver)) = (Current::default(), channel());
    let seen = Arc::clone(&current);
    let worker = std::thread::Builder::new()
        .stack_size(16 << 20)
        .spawn(move || {
            let mut failures = BTreeMap::new();
            for &(name, check) in tables.iter().copied().flatten() {
                run_function(name, check, &settings, &seen, &mut failures);
            }
            let _ = sender.send(failures);
        });
    worker.expect("a thread");
    let failures = wait(&receiver, &current);
    assert!(failures.is_empty(), "{}", report(&failures));
}

/// The failures of a function, of which the first ones are kept as texts.
pub(crate) type Failures = BTreeMap<&'static str, (usize, Vec<String>)>;

fn run_function(
    name: &'static str,
    check: fn(&Case) -> Checked,
    settings: &Settings,
    current: &Current,
    failures: &mut Failures,
) {
    for number in settings.numbers(name) {
        let case = case(settings.seed, name, number);
        *current.lock().expect("the lock") = Some((case.clone(), Instant::now()));
        if let Err(message) = guarded(check, &case) {
            let (count, shown) = failures.entry(name).or_default();
            *count += 1;
            if shown.len() < SHOWN {
                shown.push(describe(&case, &message));
            }
        }
    }
}

/// A check whose panics are failures.
pub(crate) fn guarded(check: fn(&Case) -> Checked, case: &Case) -> Checked {
    check::start();
    catch_unwind(AssertUnwindSafe(|| check(case))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
        Err(format!("panicked: {}", text.unwrap_or_default()))
    })
}

/// Waits for the end of the worker, or for a call that takes too long.
fn wait(receiver: &Receiver<Failures>, current: &Current) -> Failures {
    loop {
        match receiver.recv_timeout(Duration::from_secs(1)) {
            Ok(failures) => return failures,
            Err(RecvTimeoutError::Disconnected) => panic!("the worker ended without an answer"),
            Err(RecvTimeoutError::Timeout) => {
                let running = current.lock().expect("the lock").clone();
                if let Some((case, start)) = running.filter(|(_, start)| start.elapsed() > HANG) {
                    panic!(
                        "{}",
                        describe(&case, &format!("no answer after {:?}", start.elapsed()))
                    );
                }
            }
        }
    }
}

/// A failure with what repeats it and what can be pasted into a test.
fn describe(case: &Case, message: &str) -> String {
    format!(
        "{}, seed {}, number {} ({:?}): {message}\n  repeat: CASTELJAU_SEED={} CASTELJAU_ONLY={}:{} cargo test --test generated\n  Rust: {}\n  JavaScript: {}",
        case.function,
        case.seed,
        case.number,
        case.mode,
        case.seed,
        case.function,
        case.number,
        case.to_rust(),
        case.to_javascript()
    )
}

fn report(failures: &Failures) -> String {
    let mut text = format!("{} functions failed\n", failures.len());
    for (name, (count, shown)) in failures {
        text += &format!("\n{name}: {count} failures\n{}\n", shown.join("\n"));
    }
    text
}
