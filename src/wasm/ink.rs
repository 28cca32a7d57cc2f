//! Bindings of freehand strokes. A stroke stays in this module, and JavaScript has its index.

use super::arena;
use super::arena::Arena;
use super::optional;
use super::region::write_path;
use super::single_thread_cell::SingleThreadCell;
use crate::geometry::error::Error;
use crate::path::{InkOptions, InkPressure, InkSample, InkStroke, Path};
use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

static STROKES: SingleThreadCell<Vec<Option<InkStroke>>> = SingleThreadCell::new(Vec::new());

/// Calls `f` with the arena and a stroke.
fn answer(
    index: usize,
    f: impl FnOnce(&mut Arena, &mut InkStroke) -> Result<usize, Error>,
) -> isize {
    STROKES.with(|strokes| match &mut strokes[index] {
        Some(stroke) => arena::answer(|a| f(a, stroke)),
        None => 0,
    })
}

/// Begins a stroke and returns its index. Arguments: the size, the thinning, both tapers, smoothing, streamlining, the
/// tolerance (0 for the default).
#[wasm_bindgen]
pub fn region_ink_begin(device_pressure: bool) -> isize {
    arena::answer(|a| {
        let numbers = a.numbers(0, 7);
        let stroke = InkStroke::new(&InkOptions {
            size: numbers[0],
            thinning: numbers[1],
            taper: [numbers[2], numbers[3]],
            smoothing: numbers[4],
            streamline: numbers[5],
            tolerance: optional(numbers[6]),
            pressure: if device_pressure {
                InkPressure::Device
            } else {
                InkPressure::Simulated
            },
        })?;
        STROKES.with(|strokes| {
            let free = strokes.iter().position(Option::is_none);
            let index = free.unwrap_or(strokes.len());
            if free.is_none() {
                strokes.push(None);
            }
            strokes[index] = Some(stroke);
            Ok(index)
        })
    })
}

/// Frees a stroke.
#[wasm_bindgen]
pub fn region_ink_end(index: usize) {
    STROKES.with(|strokes| strokes[index] = None);
}

/// Appends a sample; NaN stands for a pressure or a time that is not given. Returns 0.
#[wasm_bindgen]
pub fn region_ink_append(index: usize, x: f64, y: f64, pressure: f64, time: f64) -> isize {
    let given = |number: f64| (!number.is_nan()).then_some(number);
    let sample = InkSample {
        pressure: given(pressure),
        time: given(time),
    };
    answer(index, |_, stroke| {
        stroke.append(DVec2::new(x, y), sample).map(|()| 0)
    })
}

/// Writes the settled contours and the open ones, as two paths. Arguments: `count` predicted points.
#[wasm_bindgen]
pub fn region_ink_changes(index: usize, count: usize) -> isize {
    answer(index, |a, stroke| {
        let changes = stroke.changes(a.points(0, count))?;
        let at = write_path(a, 0, &changes.settled);
        Ok(write_path(a, at, &changes.open))
    })
}

/// Writes the outline.
#[wasm_bindgen]
pub fn region_ink_outline(index: usize) -> isize {
    answer(index, |a, stroke| Ok(write_path(a, 0, &stroke.outline()?)))
}

/// Writes the centre line as a path, which is empty without samples.
#[wasm_bindgen]
pub fn region_ink_spline(index: usize) -> isize {
    answer(index, |a, stroke| {
        Ok(write_path(
            a,
            0,
            &stroke.spline().map(Path::from).unwrap_or_default(),
        ))
    })
}

/// Writes the positions and the widths of the stops along the centre line.
#[wasm_bindgen]
pub fn region_ink_widths(index: usize) -> isize {
    answer(index, |a, stroke| {
        let stops = stroke.widths().stops;
        let numbers: Vec<f64> = stops
            .into_iter()
            .flat_map(|(at, width)| [at, width])
            .collect();
        Ok(a.write_numbers(0, &numbers))
    })
}
