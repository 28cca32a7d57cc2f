//! Checks of every call: finite numbers, steps within the limit, documented errors. Comparisons that name what differs.

use crate::arguments::Space;
use crate::geometry::parameters;
use crate::limits;
use crate::numbers::Numbers;
use casteljau::Error;
use casteljau_generator::{Case, Mode};
use std::cell::{Cell, RefCell};
use std::env;
use std::ffi::OsString;
use std::fmt::{Debug, Display};
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;
use std::sync::LazyLock;

/// Why a check fails.
pub(crate) struct Failure(pub(crate) String);

impl<T: Display> From<T> for Failure {
    fn from(reason: T) -> Self {
        Self(reason.to_string())
    }
}

/// The outcome of a check.
pub(crate) type Checked<T = ()> = Result<T, Failure>;

/// A check with a message: `Ok` if a condition holds.
macro_rules! holds {
    ($holds:expr, $($message:tt)+) => {{
        // A variable, because the negation of a comparison of numbers looks like a mistake to clippy.
        let holds: bool = $holds;
        if holds { Ok(()) } else { Err($crate::check::Failure(format!($($message)+))) }
    }};
}

/// Fails the check with a message unless a condition holds.
macro_rules! ensure {
    ($holds:expr, $($message:tt)+) => {
        holds!($holds, $($message)+)?
    };
}

/// The result of a call that may return an error. The check ends here for a documented error, and in extreme cases.
/// What an error may name is a text with `|` between the names.
macro_rules! answer {
    ($call:expr) => {
        answer!($call, "")
    };
    ($call:expr, $allowed:expr) => {
        match $crate::check::call(|| $call)? {
            Ok(_) if $crate::check::is_extreme() => return Ok(()),
            Ok(value) => value,
            Err(error) => return $crate::check::refused(&error, $allowed),
        }
    };
}

/// The result of a call that never returns an error; in extreme cases the check ends here.
macro_rules! value {
    ($call:expr) => {{
        let value = $crate::check::call(|| $call)?;
        if $crate::check::is_extreme() {
            return Ok(());
        }
        value
    }};
}

/// Defines checks that results consist of finite numbers and that refusals are stated, for functions whose results the
/// named tests compare with exact ones.
macro_rules! finite {
    ($([$($generic:tt)*] $name:ident($($argument:ident: $type:ty),*): $call:expr;)*) => {$(
        pub(crate) fn $name<$($generic)*>($($argument: $type),*) -> Checked {
            let _ = $call;
            Ok(())
        }
    )*};
}

pub(crate) use {answer, ensure, finite, holds, value};

/// Numbers and points, which have distances.
pub(crate) trait Metric: Copy {
    fn distance(self, other: Self) -> f64;
}

impl Metric for f64 {
    fn distance(self, other: Self) -> f64 {
        (self - other).abs()
    }
}

impl<P: Space> Metric for P {
    fn distance(self, other: Self) -> f64 {
        (self - other).norm()
    }
}

/// Checks that a number is at most a limit; NaN is not.
pub(crate) fn at_most(x: f64, max: f64, what: impl Display) -> Checked {
    ensure!(x <= max, "{what}: {x:e}, at most {max:e} is allowed");
    Ok(())
}

/// Checks that two numbers or points are at most a slack apart.
pub(crate) fn near<T: Metric>(a: T, b: T, slack: f64, what: impl Display) -> Checked {
    at_most(a.distance(b), slack, what)
}

/// Checks that two functions agree at `steps` + 1 parameters from 0 to 1.
pub(crate) fn agree<T: Metric>(
    steps: usize,
    slack: f64,
    got: impl Fn(f64) -> T,
    expected: impl Fn(f64) -> T,
) -> Checked {
    parameters(steps, 1.0).try_for_each(|t| near(got(t), expected(t), slack, t))
}

/// Checks that a result equals what is expected.
pub(crate) fn same<A, B>(got: A, expected: B, what: impl Display) -> Checked
where
    A: PartialEq<B> + Debug,
    B: Debug,
{
    if got != expected {
        let texts = [format!("{got:?}"), format!("{expected:?}")];
        let [got, expected] = texts.map(|text| text.chars().take(300).collect::<String>());
        return Err(format!("{what}: {got}, but {expected} is expected").into());
    }
    Ok(())
}

/// The case that runs on this thread.
#[derive(Clone, Copy)]
struct Running {
    function: &'static str,
    seed: u64,
    number: u64,
    mode: Mode,
    size: f64,
    /// The maximum number of steps.
    limit: usize,
    /// The steps of the calls so far.
    steps: usize,
}

/// The numbers of a call; `None` for a refusal.
pub(crate) type Outcome = Option<Vec<f64>>;

thread_local! {
    static RUNNING: Cell<Option<Running>> = const { Cell::new(None) };
    /// The results of the calls of a case, while `first_outcome` runs it.
    static OUTCOMES: RefCell<Option<Vec<Outcome>>> = const { RefCell::new(None) };
}

/// Runs a check and gives the result of the first call that it makes.
pub(crate) fn first_outcome(check: fn(&Case) -> Checked, case: &Case) -> Option<Outcome> {
    let (outcome, checked) = outcome_of(check, case);
    if let Err(Failure(reason)) = checked {
        panic!("{} {}: {reason}", case.function, case.number);
    }
    outcome
}

/// The result of the first call of a check, and what the check says.
pub(crate) fn outcome_of(check: fn(&Case) -> Checked, case: &Case) -> (Option<Outcome>, Checked) {
    start(case);
    OUTCOMES.set(Some(Vec::new()));
    let checked = check(case);
    let outcomes = OUTCOMES.take().unwrap_or_default();
    (outcomes.into_iter().next(), checked)
}

fn running() -> Running {
    RUNNING.get().expect("a case")
}

/// The largest absolute coordinate of the case.
pub(crate) fn size() -> f64 {
    running().size
}

pub(crate) fn mode() -> Mode {
    running().mode
}

/// Whether answers may be infinite or zero, so that only NaN is an error.
pub(crate) fn is_extreme() -> bool {
    running().mode == Mode::Extreme
}

pub(crate) fn seed_and_number() -> (u64, u64) {
    (running().seed, running().number)
}

/// Starts a case.
pub(crate) fn start(case: &Case) {
    RUNNING.set(Some(Running {
        function: case.function,
        seed: case.seed,
        number: case.number,
        mode: case.mode,
        size: case.size(),
        limit: limits::of(case),
        steps: 0,
    }));
}

/// Appends the numbers of a result to the file of its function in the folder `CASTELJAU_RECORD`, for `cargo xtask compare`:
/// how many there are, the number of the case, and the numbers.
fn record(case: Running, answer: &impl Numbers) {
    OUTCOMES.with_borrow_mut(|outcomes| {
        if let Some(outcomes) = outcomes {
            let mut numbers = Vec::new();
            answer.visit(&mut |x| numbers.push(x));
            outcomes.push(Some(numbers));
        }
    });
    static FOLDER: LazyLock<Option<OsString>> = LazyLock::new(|| env::var_os("CASTELJAU_RECORD"));
    let Some(folder) = FOLDER.as_ref() else {
        return;
    };
    let mut numbers = vec![case.number as f64];
    answer.visit(&mut |x| numbers.push(x));
    let words = numbers.iter().map(|x| x.to_bits());
    let words = [numbers.len() as u64].into_iter().chain(words);
    let bytes: Vec<u8> = words.flat_map(u64::to_le_bytes).collect();
    let path = Path::new(folder).join(case.function.replace("::", "."));
    let file = OpenOptions::new().create(true).append(true).open(path);
    let written = file.and_then(|mut file| file.write_all(&bytes));
    written.expect("CASTELJAU_RECORD: the folder can be written");
}

/// Makes the call of a case. Its result must consist of finite numbers.
///
/// A result never contains a NaN. It contains no infinity either, unless coordinates lie near the limits of the range
/// of f64 (`Mode::Extreme`).
pub(crate) fn call<T: Numbers>(act: impl FnOnce() -> T) -> Checked<T> {
    let answer = call_unbounded(act)?;
    let mut infinite = None;
    answer.visit(&mut |x| infinite = infinite.or((!x.is_finite()).then_some(x)));
    match infinite {
        Some(x) if !is_extreme() => Err(format!("the answer holds {x}").into()),
        _ => Ok(answer),
    }
}

/// As `call`, for results that may be infinite by definition (the curvature at a cusp), but not NaN.
pub(crate) fn call_unbounded<T: Numbers>(act: impl FnOnce() -> T) -> Checked<T> {
    casteljau::take_steps();
    let answer = act();
    let mut case = running();
    case.steps += casteljau::take_steps();
    RUNNING.set(Some(case));
    let (steps, limit) = (case.steps, case.limit);
    ensure!(steps <= limit, "{steps} steps, at most {limit} are allowed");
    record(case, &answer);
    let mut nan = false;
    answer.visit(&mut |x| nan |= x.is_nan());
    ensure!(!nan, "the answer holds a NaN");
    Ok(answer)
}

/// Checks that an error is one that the documentation states, for the argument that it names.
pub(crate) fn refused(error: &Error, allowed: &str) -> Checked {
    OUTCOMES.with_borrow_mut(|outcomes| {
        if let Some(last) = outcomes.iter_mut().flatten().last() {
            *last = None;
        }
    });
    let allows = |what: &str| allowed.split('|').any(|known| known == what);
    let fits = match *error {
        Error::Tolerance { min, got } => allows("tolerance") && got < min && min.is_finite(),
        Error::TooSmall { what, min, got } => allows(what) && got < min,
        Error::TooMany { limit, needed, .. } => {
            needed > limit && (allows("tolerance") || allows("too many"))
        }
        Error::Range { what, got, .. } => allows(what) && !got.is_nan(),
        Error::Index {
            what,
            first,
            last,
            got,
        } => allows(what) && !(first..=last).contains(&got),
        Error::NotFinite { what, got, .. } => allows(what) && !got.is_finite(),
        Error::Count { what, .. }
        | Error::Item { what, .. }
        | Error::Singular { what }
        | Error::ClosedSpline { what } => allows(what),
        Error::NoJoint => allows("joint"),
        Error::NotPlane => allows("mode"),
        _ => false,
    };
    ensure!(fits, "refused without a stated reason: {error} ({error:?})");
    ensure!(error.to_string().contains("expected"), "no reason: {error}");
    Ok(())
}
