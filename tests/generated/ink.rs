//! Checks of freehand strokes.

use crate::check::{Checked, answer, ensure, holds};
use crate::paths::{REFUSALS, is_closed};
use casteljau::glam::DVec2;
use casteljau::path::{InkOptions, InkPressure, InkSample, InkStroke};

/// What a stroke of ink may refuse, besides what other strokes refuse.
const OPTIONS: &str = "size|taper|position|tolerance|predicted";

/// The changes are asked for after so many samples.
const CHANGES: usize = 12;

/// All calls on the stroke of some samples.
pub(crate) fn outline(points: Vec<DVec2>, width: f64, part: f64, pressure: bool) -> Checked {
    let pressure = if pressure {
        InkPressure::Device
    } else {
        InkPressure::Simulated
    };
    let options = InkOptions::new(width)
        .thinning(2.0 * part - 1.0)
        .smoothing(part)
        .streamline(1.0 - part)
        .taper(part * width.abs(), 2.0 * part * width.abs())
        .pressure(pressure);
    let mut ink = answer!(InkStroke::new(&options), OPTIONS);
    for (k, &p) in points.iter().enumerate() {
        let sample = InkSample {
            pressure: Some(part),
            time: None,
        };
        answer!(ink.append(p, sample), OPTIONS);
        if k % CHANGES == 0 {
            let changes = answer!(ink.changes(&points[..1]), REFUSALS);
            is_closed(&changes.settled)?;
            is_closed(&changes.open)?;
        }
    }
    let spline = ink.spline();
    ensure!(spline.is_some(), "no centre line");
    for (position, width) in ink.widths().stops {
        ensure!(
            position.is_finite() && width >= 0.0,
            "{width} at {position}"
        );
    }
    is_closed(&answer!(ink.outline(), REFUSALS))
}
