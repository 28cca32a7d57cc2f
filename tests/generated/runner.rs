//! Runs the cases of a group on a separate thread, detects calls that do not return, and reports failures.

use crate::check::{self, Checked, Failure};
use casteljau::path::take_replaced_segments;
use casteljau_generator::{Case, case, find};
use std::collections::BTreeMap;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::{Duration, Instant};

/// A function and the check of one call of it.
pub(crate) type Row = (&'static str, fn(&Case) -> Checked);

const SEED: u64 = 11;
const CASES: u64 = 2_000;
/// With the environment variable `CASTELJAU_FEW`.
const FEW_CASES: u64 = 250;
const DEEP_CASES: u64 = 10_000;
/// A call that takes longer than this is reported as one that does not return. No successful call takes a thousandth of
/// it.
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

/// The failures of each function: their number, and the texts of the first ones.
type Failures = BTreeMap<&'static str, (usize, Vec<String>)>;

/// The state that a worker and the watching thread share.
#[derive(Default)]
struct Shared {
    /// The running case, the row of its function, and its start time.
    current: Option<(Case, usize, Instant)>,
    failures: Failures,
    /// The number of calls, and of those in which lines replaced segments of a contradictory division of the plane.
    calls: usize,
    calls_with_lines: usize,
    /// The number of the worker. A worker that was given up has a lower number and must not write any more.
    worker: usize,
}

impl Shared {
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
}

/// Runs the checks and fails with a list of the failures.
pub(crate) fn run(rows: &'static [Row]) {
    let (shared, settings) = (Arc::<Mutex<Shared>>::default(), Settings::read());
    let mut first = 0;
    // A call that does not return keeps its thread; another worker continues with the next function.
    while let Some(next) = watch(&spawn(rows, first, &settings, &shared), &shared) {
        first = next;
    }
    let shared = lock(&shared);
    assert!(shared.failures.is_empty(), "{}", report(&shared.failures));
    let (some, all) = (shared.calls_with_lines, shared.calls);
    println!("lines replaced segments in {some} of {all} calls");
    assert!(
        some * MIN_CALLS_WITHOUT_LINES <= all + MIN_CALLS_WITHOUT_LINES,
        "{some} of {all}"
    );
}

fn lock(shared: &Mutex<Shared>) -> MutexGuard<'_, Shared> {
    shared.lock().expect("no panic while it is locked")
}

/// Starts a thread for the rows from `first` on; the receiver is notified when it ends.
fn spawn(
    rows: &'static [Row],
    first: usize,
    settings: &Settings,
    shared: &Arc<Mutex<Shared>>,
) -> Receiver<()> {
    let (sender, receiver) = channel();
    let (settings, shared) = (settings.clone(), Arc::clone(shared));
    let number = lock(&shared).worker;
    let work = move || {
        let _ended = sender; // dropped at the end, also after a panic
        for (row, &(name, check)) in rows.iter().enumerate().skip(first) {
            for number_of_case in settings.numbers(name) {
                let case = case(settings.seed, name, number_of_case);
                lock(&shared).current = Some((case.clone(), row, Instant::now()));
                let outcome = guarded(check, &case);
                let replaced = take_replaced_segments();
                let mut shared = lock(&shared);
                if shared.worker != number {
                    return;
                }
                shared.calls += 1;
                shared.calls_with_lines += usize::from(replaced > 0);
                if let Err(Failure(message)) = outcome {
                    shared.add(&case, &message);
                }
            }
        }
    };
    let builder = std::thread::Builder::new().stack_size(16 << 20);
    builder.spawn(work).expect("a thread");
    receiver
}

/// Waits for the end of a worker. If a call takes too long, records this and returns the row to continue with.
fn watch(ended: &Receiver<()>, shared: &Mutex<Shared>) -> Option<usize> {
    while ended.recv_timeout(Duration::from_secs(1)) == Err(RecvTimeoutError::Timeout) {
        let mut shared = lock(shared);
        if let Some((case, row, start)) = shared.current.clone()
            && start.elapsed() > HANG
        {
            shared.add(&case, &format!("no answer after {HANG:?}"));
            shared.worker += 1;
            return Some(row + 1);
        }
    }
    None
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

/// The text of a failure, with the command that repeats it and code that can be pasted into a test.
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
