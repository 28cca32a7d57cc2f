//! Checks of parsers: no panic, errors within the text, and everything that was read can be written and read again.

use crate::arguments::*;
use crate::check::*;
use crate::runner::Row;
use casteljau::{Easing, Path, Surface};
use casteljau_generator::Case;

pub(crate) const ROWS: &[Row] = &[
    ("Path::from_svg_with", from_svg_with),
    ("Path::from_svg", from_svg),
    ("Surface::parse", parse),
    ("Easing::new", easing_new),
    ("Easing::eval", easing_eval),
    ("Easing::to_linear", easing_to_linear),
    ("Easing::text", easing_text),
];

fn from_svg(case: &Case) -> Checked {
    let text = text(case, "text");
    let (path, error) = match call(case, || Path::from_svg(text).map_err(Box::new))? {
        Ok(path) => (path, None),
        Err(error) => (error.path.clone(), Some(error)),
    };
    if let Some(error) = error {
        ensure!(
            error.offset <= text.len(),
            "offset {} of {}",
            error.offset,
            text.len()
        );
        ensure!(
            text.as_bytes()[..error.offset].is_ascii(),
            "text before the error that is not ASCII"
        );
        ensure!(
            error.to_string().len() < 300 + text.len(),
            "a message of {} bytes",
            error.to_string().len()
        );
        let before = Path::from_svg(&text[..error.offset]).unwrap_or_else(|error| error.path);
        ensure!(
            before.segment_count() <= error.path.segment_count() + 1,
            "more before the error than with it"
        );
    }
    // An arc becomes at most four cubics and takes at least nine characters.
    ensure!(
        path.segment_count() <= text.len() + 1,
        "{} segments of {} bytes",
        path.segment_count(),
        text.len()
    );
    let written = path.to_svg(None, None).map_err(|error| error.to_string())?;
    ensure!(
        written.len() <= 600 * (text.len() + 1),
        "{} bytes of {}",
        written.len(),
        text.len()
    );
    let again = Path::from_svg(&written).map_err(|error| error.to_string())?;
    ensure!(again == path, "another path is read from {written}");
    Ok(())
}

fn from_svg_with(case: &Case) -> Checked {
    let (text, tolerance) = (text(case, "text"), number(case, "tolerance"));
    let refused = |error: &casteljau::path::SvgError| error.expected == "an arc tolerance above 0";
    match call(case, || {
        Path::from_svg_with(text, tolerance).map_err(Box::new)
    })? {
        Ok(path) => {
            let plain = Path::from_svg(text).map_err(|error| error.to_string())?;
            ensure!(tolerance > 0.0, "a tolerance of {tolerance} is accepted");
            ensure!(
                path.subpath_count() == plain.subpath_count(),
                "{} subpaths, not {}",
                path.subpath_count(),
                plain.subpath_count()
            );
        }
        Err(error) => ensure!(
            refused(&error) != (tolerance > 0.0),
            "refused without a reason: {error}"
        ),
    }
    Ok(())
}

fn parse(case: &Case) -> Checked {
    let text = text(case, "text");
    let surface = match call(case, || Surface::parse(text).map_err(Box::new))? {
        Ok(surface) => surface,
        Err(error) => {
            let lines = text.split('\n').count() + text.matches('\r').count() + 1;
            ensure!(
                (1..=lines).contains(&error.line),
                "line {} of {lines}",
                error.line
            );
            ensure!(
                !error.expected.is_empty() && error.to_string().len() <= 300 + text.len(),
                "no short message"
            );
            return Ok(());
        }
    };
    ensure!(
        surface.vertices().len() + surface.indices().len() <= text.len(),
        "more numbers than characters"
    );
    let again = Surface::parse(&surface.to_text()).map_err(|error| error.to_string())?;
    let same = again.vertices() == surface.vertices() && again.indices() == surface.indices();
    ensure!(same, "another surface is read from what was written");
    Ok(())
}

fn handles(case: &Case) -> [f64; 4] {
    ["x1", "y1", "x2", "y2"].map(|name| number(case, name))
}

fn easing_new(case: &Case) -> Checked {
    let [x1, y1, x2, y2] = handles(case);
    casteljau::take_steps();
    let easing = Easing::new(x1, y1, x2, y2).map_err(|error| error.to_string())?;
    let ends = call(case, || [easing.eval(0.0), easing.eval(1.0)])?;
    ensure!(ends == [0.0, 1.0], "the ends are {ends:?}");
    Ok(())
}

fn easing_eval(case: &Case) -> Checked {
    let ([x1, y1, x2, y2], x) = (handles(case), number(case, "x"));
    let easing = Easing::new(x1, y1, x2, y2).map_err(|error| error.to_string())?;
    let y = call(case, || easing.eval(x))?;
    ensure!(y.is_finite(), "{y}");
    if !(0.0..=1.0).contains(&x) || case.size() > 0.0 {
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
            if weights(middle, x1, x2) < x {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    };
    let (below, above) = (parameter_at(x - 4e-15), parameter_at(x + 4e-15));
    let values = parameters(8, 1.0).map(|s| weights(below + (above - below) * s, y1, y2));
    let (min, max) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| {
        (a.min(y), b.max(y))
    });
    let slack = 1e-9 * y1.abs().max(y2.abs()).max(1.0);
    ensure!(
        y >= min - slack && y <= max + slack,
        "{y} at {x}, between {min} and {max} were expected"
    );
    Ok(())
}

fn easing_to_linear(case: &Case) -> Checked {
    let ([x1, y1, x2, y2], tolerance) = (handles(case), number(case, "tolerance"));
    let easing = Easing::new(x1, y1, x2, y2).map_err(|error| error.to_string())?;
    let text = answer!(case, easing.to_linear(tolerance), &["tolerance"]);
    let linear: Easing = text.parse().map_err(|error| format!("{text}: {error}"))?;
    for x in parameters(200, 1.0) {
        let error = (linear.eval(x) - easing.eval(x)).abs();
        ensure!(
            error <= tolerance * (1.0 + 1e-9),
            "an error of {error} at {x}"
        );
    }
    Ok(())
}

fn easing_text(case: &Case) -> Checked {
    let text = text(case, "text");
    let written = call(case, || {
        text.parse::<Easing>().map(|easing| easing.to_string())
    })?;
    let (written, easing) = match (written, text.parse::<Easing>()) {
        (Ok(written), Ok(easing)) => (written, easing),
        (_, Err(error)) | (Err(error), _) => {
            ensure!(error.offset <= text.len(), "offset {}", error.offset);
            ensure!(text.is_char_boundary(error.offset), "within a character");
            let length = error.to_string().len();
            ensure!(length <= 400, "a message of {length} bytes");
            return Ok(());
        }
    };
    let length = written.len();
    ensure!(length <= 600 * (text.len() + 1), "{length} bytes");
    let same = written.parse().as_ref() == Ok(&easing);
    ensure!(same, "another function is read from {written}");
    for x in [-1e308, -1.0, 0.0, 0.3, 1.0, 2.0, 1e308] {
        let y = easing.eval(x);
        ensure!(y.is_finite(), "{y} at {x}");
    }
    Ok(())
}
