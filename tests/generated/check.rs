//! Checks of every call: finite numbers, steps within the limit, documented errors.

use crate::limits;
use crate::numbers::Numbers;
use casteljau::Error;
use casteljau_generator::{Case, Mode};
use std::cell::Cell;

/// Fails the check with a message unless a condition holds.
macro_rules! ensure {
    ($holds:expr, $($message:tt)+) => {{
        // A variable, because the negation of a comparison of numbers looks like a mistake to clippy.
        let holds: bool = $holds;
        if !holds {
            return Err(format!($($message)+));
        }
    }};
}

/// The result of a call that may return an error. The check ends here for a documented error, and in extreme cases.
macro_rules! answer {
    ($case:expr, $call:expr) => {
        answer!($case, $call, &[])
    };
    ($case:expr, $call:expr, $allowed:expr) => {
        match $crate::check::call($case, || $call)? {
            Ok(_) if $case.mode == casteljau_generator::Mode::Extreme => return Ok(()),
            Ok(value) => value,
            Err(error) => return $crate::check::refused(&error, $allowed),
        }
    };
}

/// The result of a call that never returns an error; in extreme cases the check ends here.
macro_rules! value {
    ($case:expr, $call:expr) => {{
        let value = $crate::check::call($case, || $call)?;
        if $case.mode == casteljau_generator::Mode::Extreme {
            return Ok(());
        }
        value
    }};
}

/// A check for curves or splines in the plane and in space, selected by the dimension of the case.
macro_rules! both {
    ($check:ident) => {
        |case| {
            if case.dimension() == 3 {
                $check::<casteljau::glam::DVec3>(case)
            } else {
                $check::<casteljau::glam::DVec2>(case)
            }
        }
    };
}

pub(crate) use {answer, both, ensure, value};

/// The outcome of a check.
pub(crate) type Checked = Result<(), String>;

thread_local! {
    /// The steps of the calls of the case so far.
    static STEPS: Cell<usize> = const { Cell::new(0) };
    /// CPU time of the calls of the case so far, in nanoseconds; counted only for the table of percentiles.
    static TIME: Cell<u64> = const { Cell::new(0) };
    static TIMED: Cell<bool> = const { Cell::new(false) };
}

/// Starts a case.
pub(crate) fn start() {
    STEPS.set(0);
    TIME.set(0);
}

/// Enables the measurement of CPU time.
pub(crate) fn count_time() {
    TIMED.set(true);
}

/// The steps and the CPU time in nanoseconds of the case.
pub(crate) fn work() -> (usize, u64) {
    (STEPS.get(), TIME.get())
}

fn cpu_time() -> u64 {
    if !TIMED.get() {
        return 0;
    }
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        u64::try_from(time.tv_sec).unwrap_or(0) * 1_000_000_000
            + u64::try_from(time.tv_nsec).unwrap_or(0)
    }
    #[cfg(not(unix))]
    0
}

/// Makes the call of a case. Its result must consist of finite numbers.
///
/// A result never contains a NaN. It contains no infinity either, unless coordinates lie near the limits of the range
/// of f64 (`Mode::Extreme`).
pub(crate) fn call<T: Numbers>(case: &Case, act: impl FnOnce() -> T) -> Result<T, String> {
    let answer = call_unbounded(case, act)?;
    let mut infinite = None;
    answer.visit(&mut |x| infinite = infinite.or((!x.is_finite()).then_some(x)));
    match infinite {
        Some(x) if case.mode != Mode::Extreme => Err(format!("the answer holds {x}")),
        _ => Ok(answer),
    }
}

/// As `call`, for results that may be infinite by definition (the curvature at a cusp), but not NaN.
pub(crate) fn call_unbounded<T: Numbers>(
    case: &Case,
    act: impl FnOnce() -> T,
) -> Result<T, String> {
    casteljau::take_steps();
    let begin = cpu_time();
    let answer = act();
    TIME.set(TIME.get() + cpu_time() - begin);
    STEPS.set(STEPS.get() + casteljau::take_steps());
    let (steps, limit) = (STEPS.get(), limits::of(case));
    ensure!(steps <= limit, "{steps} steps, at most {limit} are allowed");
    let mut nan = false;
    answer.visit(&mut |x| nan |= x.is_nan());
    ensure!(!nan, "the answer holds a NaN");
    Ok(answer)
}

/// Checks that an error is one that the documentation states, for the argument that it names.
pub(crate) fn refused(error: &Error, allowed: &[&str]) -> Checked {
    let message = error.to_string();
    ensure!(
        message.contains("expected"),
        "the refusal has no reason: {message}"
    );
    let allows = |what: &str| allowed.contains(&what);
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
        Error::Count { what, .. } | Error::Item { what, .. } => allows(what),
        _ => false,
    };
    ensure!(
        fits,
        "refused without a stated reason: {message} ({error:?})"
    );
    Ok(())
}
