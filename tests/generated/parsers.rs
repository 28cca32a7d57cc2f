//! Checks of parsers: no panic, errors within the text, and everything that was read can be written and read again.

use crate::check::*;
use crate::geometry::*;
use crate::numbers::Numbers;
use casteljau::path::SvgError;
use casteljau::surface::ParseError;
use casteljau::{Easing, Path, RationalSurface, Surface};
use std::fmt::Debug;

/// Checks that an error is at a place in the text, and that its message is short.
fn is_error(text: &str, offset: usize, message: &str) -> Checked {
    ensure!(offset <= text.len(), "offset {offset} of {}", text.len());
    ensure!(text.is_char_boundary(offset), "within a character");
    let length = message.len();
    holds!(length < 300 + text.len().min(100), "{length} bytes")
}

pub(crate) fn from_svg(text: String) -> Checked {
    let result = call(|| Path::from_svg(&text).map_err(Box::new))?;
    if let Err(error) = &result {
        is_error(&text, error.offset, &error.to_string())?;
        let before = &text[..error.offset];
        ensure!(before.is_ascii(), "text before the error that is not ASCII");
        let before = Path::from_svg(before).unwrap_or_else(|error| error.path);
        let more = before.segment_count() > error.path.segment_count() + 1;
        ensure!(!more, "more before the error than with it");
    }
    let path = result.unwrap_or_else(|error| error.path);
    // An arc becomes at most four cubics and takes at least nine characters.
    let (count, length) = (path.segment_count(), text.len());
    ensure!(count <= length + 1, "{count} segments of {length} bytes");
    let written = path.to_svg();
    let bytes = written.len();
    ensure!(bytes <= 600 * (length + 1), "{bytes} bytes");
    let back = Path::from_svg(&written)?;
    holds!(
        is_read_back(&back, &path, &written),
        "another path from {written}"
    )
}

pub(crate) fn from_svg_with(text: String, tolerance: f64) -> Checked {
    let read = || Path::from_svg_with(&text, tolerance).map_err(Box::new);
    let refused = |error: &SvgError| error.expected == "an arc tolerance above 0";
    match call(read)? {
        Ok(path) => {
            ensure!(tolerance > 0.0, "a tolerance of {tolerance} is accepted");
            let plain = Path::from_svg(&text)?;
            same(path.subpath_count(), plain.subpath_count(), "the subpaths")?;
        }
        Err(error) => {
            let stated = refused(&error) != (tolerance > 0.0);
            ensure!(stated, "refused without a reason: {error}");
        }
    }
    Ok(())
}

pub(crate) fn parse(text: String) -> Checked {
    is_read(&text, Surface::parse, Surface::to_text, |surface| {
        surface.vertices().len() + surface.indices().len()
    })
}

pub(crate) fn parse_rational(text: String) -> Checked {
    is_read(
        &text,
        RationalSurface::parse,
        RationalSurface::to_text,
        |surface| surface.vertices().len() + surface.indices().len(),
    )
}

/// Checks that what is read from a text is read again from the text of it.
fn is_read<S: Numbers + PartialEq + Debug>(
    text: &str,
    parse: fn(&str) -> Result<S, ParseError>,
    to_text: fn(&S) -> String,
    count: impl Fn(&S) -> usize,
) -> Checked {
    let surface = match call(|| parse(text).map_err(Box::new))? {
        Ok(surface) => surface,
        Err(error) => {
            let lines = text.split('\n').count() + text.matches('\r').count() + 1;
            let line = error.line;
            ensure!((1..=lines).contains(&line), "line {line} of {lines}");
            let short = error.to_string().len() <= 300 + text.len();
            ensure!(!error.expected.is_empty() && short, "no short message");
            return Ok(());
        }
    };
    let numbers = count(&surface);
    ensure!(numbers <= text.len(), "more numbers than characters");
    let again = parse(&to_text(&surface))?;
    same(again, surface, "the surface that is read again")
}

pub(crate) fn easing_new(x1: f64, y1: f64, x2: f64, y2: f64) -> Checked {
    casteljau::take_steps();
    let easing = Easing::new(x1, y1, x2, y2)?;
    let ends = call(|| [easing.eval(0.0), easing.eval(1.0)])?;
    same(ends, [0.0, 1.0], "the ends")
}

pub(crate) fn easing_eval(x1: f64, y1: f64, x2: f64, y2: f64, x: f64) -> Checked {
    let easing = Easing::new(x1, y1, x2, y2)?;
    let y = call(|| easing.eval(x))?;
    ensure!(y.is_finite(), "{y}");
    if !(0.0..=1.0).contains(&x) {
        return Ok(());
    }
    // x(t) is accurate to 1e-15, and y belongs to this t: every t with an equally close x is accepted.
    let weights = |t: f64, a: f64, b: f64| {
        3.0 * a * t * (1.0 - t).powi(2) + 3.0 * b * t * t * (1.0 - t) + t.powi(3)
    };
    let parameter_at = |x: f64| {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            let end = if weights(middle, x1, x2) < x {
                &mut low
            } else {
                &mut high
            };
            *end = middle;
        }
        low
    };
    let (below, above) = (parameter_at(x - 4e-15), parameter_at(x + 4e-15));
    let values = parameters(8, 1.0).map(|s| weights(below + (above - below) * s, y1, y2));
    let (low, high) = (min(values.clone()), -min(values.map(|y| -y)));
    let slack = 1e-9 * y1.abs().max(y2.abs()).max(1.0);
    let fits = y >= low - slack && y <= high + slack;
    holds!(fits, "{y} at {x}, between {low} and {high} was expected")
}

pub(crate) fn easing_to_linear(x1: f64, y1: f64, x2: f64, y2: f64, tolerance: f64) -> Checked {
    let easing = Easing::new(x1, y1, x2, y2)?;
    let text = answer!(easing.to_linear(tolerance), "tolerance");
    let linear: Easing = text.parse()?;
    let slack = tolerance * (1.0 + 1e-9);
    agree(200, slack, |x| linear.eval(x), |x| easing.eval(x))
}

pub(crate) fn easing_text(text: String) -> Checked {
    let read = || text.parse::<Easing>().map(|easing| easing.to_string());
    let (written, easing) = match (call(read)?, text.parse::<Easing>()) {
        (Ok(written), Ok(easing)) => (written, easing),
        (_, Err(error)) | (Err(error), _) => {
            return is_error(&text, error.offset, &error.to_string());
        }
    };
    let length = written.len();
    ensure!(length <= 600 * (text.len() + 1), "{length} bytes");
    same(
        &written.parse::<Easing>(),
        &Ok(easing.clone()),
        "what is read again",
    )?;
    for x in [-1e308, -1.0, 0.0, 0.3, 1.0, 2.0, 1e308] {
        let y = easing.eval(x);
        ensure!(y.is_finite(), "{y} at {x}");
    }
    Ok(())
}
