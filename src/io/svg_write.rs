//! Writing paths as SVG path data.

use super::svg_arcs::Run;
#[cfg(feature = "nurbs")]
use super::svg_arcs::shortest;
use crate::curve::Curve;
use crate::curve::trace::PathSink;
use crate::geometry::check::check_tolerance;
#[cfg(feature = "nurbs")]
use crate::geometry::check::max_abs;
use crate::geometry::error::Error;
use crate::path::Path;
use crate::path::arc::Arc;
#[cfg(feature = "nurbs")]
use crate::rational::{NurbsCurve, RationalCurve};
use crate::spline::Spline;
use crate::text::number::{push, push_number, written_number};
use glam::DVec2;
use std::fmt;

/// The maximum number of digits, the limit of JavaScript's `toFixed`.
const MAX_DIGITS: u8 = 100;
/// The rotation of an ellipse has this many more digits, because an error of the angle moves points by its product with the radius.
const MORE_DIGITS: u8 = 3;
/// From this value on, numbers have no digits after the decimal point, and JavaScript writes them with an exponent.
const EXPONENT_FROM: f64 = 1e21;

/// Options of [`Path::to_svg_with`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct SvgOptions {
    /// The number of digits after the decimal point (100 at most; ties are rounded away from zero). With it the text has
    /// the shortest absolute form, "M0 0 1 .5Z", without optional blanks and letters, and with H and V where possible.
    pub precision: Option<u8>,
    /// The largest distance of the cubics that replace segments above degree 3; by default 10⁻⁴ of the diagonal of their
    /// control-point box.
    pub tolerance: Option<f64>,
    /// Whether neighbouring cubics that are equal arcs of one ellipse, up to rounding, are written as one arc, if they are at
    /// least as many as [`Path::from_svg`] makes of it: true by default. Curves and splines are written without arcs.
    pub arcs: bool,
}

impl Default for SvgOptions {
    fn default() -> Self {
        Self::new()
    }
}

/// Methods that set one option, for chaining.
impl SvgOptions {
    /// The default options.
    pub const fn new() -> Self {
        Self {
            precision: None,
            tolerance: None,
            arcs: true,
        }
    }

    /// Sets the number of digits after the decimal point.
    #[must_use]
    pub const fn precision(self, precision: u8) -> Self {
        Self {
            precision: Some(precision),
            ..self
        }
    }

    /// Sets the largest distance of the cubics that replace segments above degree 3.
    #[must_use]
    pub const fn tolerance(self, tolerance: f64) -> Self {
        Self {
            tolerance: Some(tolerance),
            ..self
        }
    }

    /// Sets whether cubics that are arcs are written as arcs.
    #[must_use]
    pub const fn arcs(self, arcs: bool) -> Self {
        Self { arcs, ..self }
    }
}

impl Path {
    /// The path as the `d` attribute of an SVG `<path>`.
    ///
    /// Absolute commands, "M0,0 L1,0.5 Z", each number with the fewest digits that round-trip, so
    /// [`from_svg`](Self::from_svg) reads a bit-identical path (for degrees 1 to 3). Cubics that it makes of an arc are written
    /// as the arc, so a circle takes two commands: these are read up to rounding. So are equal finer cubics, as those of
    /// [`round_corners`](Self::round_corners), of which it makes fewer, within its tolerance. Higher degrees are approximated by
    /// cubics (see [`Curve::trace`]). The last line of a closed subpath is represented by its `Z`. The empty path gives
    /// the empty text.
    ///
    /// ```
    /// use casteljau::{Path, path::SvgOptions};
    ///
    /// let path = Path::from_svg("m0 0 2 0 0 1.25z").expect("path data");
    /// assert_eq!(path.to_svg(), "M0,0 L2,0 L2,1.25 Z");
    /// assert_eq!(path.to_svg_with(&SvgOptions::new().precision(1))?, "M0 0H2V1.3Z");
    /// let circle = Path::circle((0.0, 0.0).into(), 5.0)?;
    /// assert_eq!(circle.to_svg(), "M5,0 A5,5 0 0 1 -5,0 A5,5 0 0 1 5,0 Z");
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn to_svg(&self) -> String {
        self.written(&SvgOptions::default())
    }

    /// [`to_svg`](Self::to_svg) with options.
    ///
    /// # Errors
    /// As [`Curve::trace_within`] for the tolerance.
    pub fn to_svg_with(&self, options: &SvgOptions) -> Result<String, Error> {
        if let Some(tolerance) = options.tolerance {
            check_tolerance(tolerance, self.max_abs())?;
        }
        Ok(self.written(options))
    }

    fn written(&self, options: &SvgOptions) -> String {
        let SvgOptions {
            precision,
            tolerance,
            arcs,
        } = *options;
        let mut writer = Writer::new(precision);
        for part in self.parts() {
            writer.move_to(part.points[0]);
            // The start of a last line; the points of a closed subpath end with its start.
            let last = part.points.len() - 2;
            // `Z` draws this line. It is also omitted if it is the only segment, even with length 0.
            let closing = part.closed
                && part.segment(part.segment_count() - 1).len() == 2
                && (last == 0 || part.points[last] != part.points[last + 1]);
            let count = part.segment_count() - usize::from(closing);
            let mut k = 0;
            while k < count {
                // The longest run of cubics on one ellipse; where it is no arc as a whole, its first half is tried.
                let run = arcs.then(|| Run::of((k..count).map(|k| part.segment(k))));
                if let Some(written) = run.flatten().and_then(|run| writer.arc_of(run)) {
                    k += written;
                    continue;
                }
                Curve::from_slice(part.segment(k)).trace_on(&mut writer, tolerance);
                k += 1;
            }
            if part.closed {
                writer.close_subpath(closing && last > 0);
            }
        }
        writer.text
    }
}

impl fmt::Display for Path {
    /// Writes SVG path data, as [`Path::to_svg`] without options; the precision of the format (`{:.2}`) is the number
    /// of digits after the decimal point.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut options = SvgOptions::new();
        let digits = f.precision();
        options.precision = digits.map(|digits| digits.try_into().unwrap_or(u8::MAX));
        f.write_str(&self.to_svg_with(&options).map_err(|_| fmt::Error)?)
    }
}

impl Curve<DVec2> {
    /// The curve as SVG path data, without arcs; see [`Path::to_svg`].
    pub fn to_svg(&self) -> String {
        Path::from(self.clone()).written(&SvgOptions::new().arcs(false))
    }

    /// [`to_svg`](Self::to_svg) with options.
    ///
    /// # Errors
    /// As [`trace_within`](Self::trace_within).
    pub fn to_svg_with(&self, options: &SvgOptions) -> Result<String, Error> {
        Path::from(self.clone()).to_svg_with(&options.arcs(false))
    }
}

impl Spline<DVec2> {
    /// The spline as SVG path data, without arcs; see [`Path::to_svg`].
    pub fn to_svg(&self) -> String {
        Path::new(std::slice::from_ref(self)).written(&SvgOptions::new().arcs(false))
    }

    /// [`to_svg`](Self::to_svg) with options.
    ///
    /// # Errors
    /// As [`trace_within`](Self::trace_within).
    pub fn to_svg_with(&self, options: &SvgOptions) -> Result<String, Error> {
        Path::new(std::slice::from_ref(self)).to_svg_with(&options.arcs(false))
    }
}

#[cfg(feature = "nurbs")]
impl RationalCurve<DVec2> {
    /// The curve as SVG path data: an arc of a circle or an ellipse as `A`, with the fewest of 12, 15 or all digits that are read as
    /// the same arc up to rounding; others as lines and cubics within `tolerance`.
    ///
    /// # Errors
    /// As [`trace_within`](Self::trace_within).
    ///
    /// ```
    /// use casteljau::{RationalCurve, glam::DVec2};
    ///
    /// let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    /// let parabola = RationalCurve::new(&points, &[1.0, 2.0, 4.0])?;
    /// assert_eq!(parabola.to_svg(1e-3)?.get(..4), Some("M1,0"));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn to_svg(&self, tolerance: f64) -> Result<String, Error> {
        check_tolerance(tolerance, max_abs(self.control_points()))?;
        let mut writer = Writer::new(None);
        writer.move_to(self.start());
        writer.rational(self, tolerance);
        Ok(writer.text)
    }
}

#[cfg(feature = "nurbs")]
impl NurbsCurve<DVec2> {
    /// The curve as SVG path data; see [`RationalCurve::to_svg`]. A curve that ends where it starts is closed.
    ///
    /// # Errors
    /// As [`trace_within`](Self::trace_within).
    pub fn to_svg(&self, tolerance: f64) -> Result<String, Error> {
        check_tolerance(tolerance, max_abs(self.control_points()))?;
        let mut writer = Writer::new(None);
        writer.move_to(self.start());
        for segment in self.segments() {
            writer.rational(segment, tolerance);
        }
        if self.start() == self.end() {
            writer.close();
        }
        Ok(writer.text)
    }
}

/// The arc that a conic is, with the fewest digits; `None` if it is none, or if numbers in text move it.
#[cfg(feature = "nurbs")]
fn arc_of_conic(curve: &RationalCurve<DVec2>) -> Option<Arc> {
    let arc = curve.to_elliptical_arc()?;
    let (p, w) = (curve.control_points(), curve.weights());
    // The point in the middle of the standard form, with the weights 1, w, 1.
    let w = w[1] / (w[0].sqrt() * w[2].sqrt());
    let middle = ((p[0] + p[2]) * 0.5 + p[1] * w) / (1.0 + w);
    let degrees = arc.rotation.to_degrees();
    let shape = Arc {
        from: curve.start(),
        to: curve.end(),
        radii: arc.radii,
        // Half a turn makes the same ellipse.
        degrees: degrees - 180.0 * (degrees / 180.0).round(),
        large: false,
        sweep: arc.sweep_angle > 0.0,
    };
    shortest(&shape, middle)
}

/// The sink that writes path data.
struct Writer {
    text: String,
    precision: Option<u8>,
    /// Short form only: the current point as text, and the command that a number without a command implies.
    at: [String; 2],
    start: [String; 2],
    implied: char,
    /// The previous number, if the next one follows it directly.
    last: String,
}

impl Writer {
    fn new(precision: Option<u8>) -> Self {
        Self {
            text: String::new(),
            precision,
            at: Default::default(),
            start: Default::default(),
            implied: ' ',
            last: String::new(),
        }
    }

    fn draw(&mut self, command: char, points: &[DVec2]) {
        match self.precision {
            None => self.draw_exactly(command, points),
            Some(digits) => self.draw_briefly(command, points, digits),
        }
    }

    fn draw_exactly(&mut self, command: char, points: &[DVec2]) {
        if !self.text.is_empty() {
            self.text.push(' ');
        }
        self.text.push(command);
        for (k, p) in points.iter().enumerate() {
            if k > 0 {
                self.text.push(' ');
            }
            push_number(&mut self.text, p.x);
            self.text.push(',');
            push_number(&mut self.text, p.y);
        }
    }

    /// Writes an arc that consists of the first cubics of a run; returns their number.
    fn arc_of(&mut self, mut run: Run<'_>) -> Option<usize> {
        while run.len() > 0 {
            let written = match self.precision {
                None => self.arc_exactly(&run),
                Some(digits) => self.arc_briefly(&run, digits.min(MAX_DIGITS)),
            };
            if written {
                return Some(run.len());
            }
            run.halve();
        }
        None
    }

    /// Continues with a rational curve.
    #[cfg(feature = "nurbs")]
    fn rational(&mut self, curve: &RationalCurve<DVec2>, tolerance: f64) {
        if let Some(arc) = arc_of_conic(curve) {
            return self.push_arc(&arc);
        }
        let mut draw = |part: &Curve<DVec2>| part.trace_on(self, Some(tolerance));
        curve.for_each_polynomial(tolerance, &mut draw);
    }

    fn arc_exactly(&mut self, run: &Run<'_>) -> bool {
        let Some(arc) = run.exact_arc() else {
            return false;
        };
        self.push_arc(&arc);
        true
    }

    fn push_arc(&mut self, arc: &Arc) {
        let (radii, to) = (arc.radii, arc.to);
        let [rx, ry, degrees, x, y] =
            [radii.x, radii.y, arc.degrees, to.x, to.y].map(written_number);
        let [large, sweep] = [arc.large, arc.sweep].map(u8::from);
        push(
            &mut self.text,
            format_args!(" A{rx},{ry} {degrees} {large} {sweep} {x},{y}"),
        );
    }

    /// The radii are rounded, or rounded down by one unit of the last digit: of half an ellipse, larger radii would move the center far.
    fn arc_briefly(&mut self, run: &Run<'_>, digits: u8) -> bool {
        let value = |word: &String| word.parse().unwrap_or(f64::NAN);
        let unit = 10_f64.powi(-i32::from(digits));
        let arc = run.arc();
        let to = [fixed(arc.to.x, digits), fixed(arc.to.y, digits)];
        let point = |words: &[String; 2]| DVec2::new(value(&words[0]), value(&words[1]));
        let degrees = fixed(arc.degrees, (digits + MORE_DIGITS).min(MAX_DIGITS));
        for less in [0.0, unit] {
            let radii = [arc.radii.x - less, arc.radii.y - less].map(|r| fixed(r, digits));
            let rounded = Arc {
                from: point(&self.at),
                to: point(&to),
                radii: point(&radii),
                degrees: value(&degrees),
                ..arc
            };
            if run.is_arc(&rounded, unit) {
                let [rx, ry] = radii;
                let [large, sweep] = [arc.large, arc.sweep].map(|flag| u8::from(flag).to_string());
                let [x, y] = to.clone();
                self.write('A', &[rx, ry, degrees, large, sweep, x, y]);
                self.at = to;
                return true;
            }
        }
        false
    }

    fn draw_briefly(&mut self, command: char, points: &[DVec2], digits: u8) {
        let digits = digits.min(MAX_DIGITS);
        let words = points
            .iter()
            .map(|p| [fixed(p.x, digits), fixed(p.y, digits)]);
        let words: Vec<[String; 2]> = words.collect();
        let Some(to) = words.last().cloned() else {
            return;
        };
        match command {
            'L' if to[1] == self.at[1] => self.write('H', &words[0][..1]),
            'L' if to[0] == self.at[0] => self.write('V', &words[0][1..]),
            _ => self.write(command, words.as_flattened()),
        }
        if command == 'M' {
            self.start.clone_from(&to);
        }
        self.at = to;
    }

    /// Closes the subpath, with or without a line to the start. If rounding reduces that line to length 0, it is
    /// written.
    fn close_subpath(&mut self, line: bool) {
        if line && self.precision.is_some() && self.at == self.start {
            let x = [self.start[0].clone()];
            self.write('H', &x);
        }
        self.close();
    }

    /// Writes a command and its arguments with as few separators as possible.
    fn write(&mut self, command: char, words: &[String]) {
        if command != self.implied {
            self.text.push(command);
            self.last.clear();
        }
        self.implied = if command == 'M' { 'L' } else { command };
        for word in words {
            // A number ends before a sign, and before a point if it has one already or an exponent: "1-2", "1.5.5".
            let is_separate = word.starts_with('-')
                || (word.starts_with('.') && self.last.contains(['.', 'e']))
                || self.last.is_empty();
            if !is_separate {
                self.text.push(' ');
            }
            self.text.push_str(word);
            self.last.clone_from(word);
        }
    }
}

impl PathSink for Writer {
    fn move_to(&mut self, p: DVec2) {
        self.draw('M', &[p]);
    }
    fn line_to(&mut self, p: DVec2) {
        self.draw('L', &[p]);
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.draw('Q', &[p1, p]);
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.draw('C', &[p1, p2, p]);
    }
    fn close(&mut self) {
        self.text.push_str(match self.precision {
            None => " Z",
            Some(_) => "Z",
        });
        self.implied = ' ';
    }
}

/// A number with at most `digits` digits after the decimal point, without redundant zeros: "-.5".
fn fixed(x: f64, digits: u8) -> String {
    if x.abs() >= EXPONENT_FROM {
        return written_number(x).replace('+', "");
    }
    let (size, half) = (x.abs(), 2_f64.powi(-i32::from(digits) - 1));
    let digits = usize::from(digits);
    // Ties: Rust rounds to even, JavaScript's `toFixed` away from zero. An f64 is in the middle of two decimals with d
    // digits exactly if it is m 2⁻ᵈ⁻¹ for an odd m, because 10ᵈ times this is m 5ᵈ / 2. It has d + 1 digits, the last
    // of them 5.
    let tie = size / half % 2.0 == 1.0;
    let mut word = if tie {
        rounded_up(format!("{size:.*}", digits + 1))
    } else {
        format!("{size:.digits$}")
    };
    if word.contains('.') {
        word.truncate(word.trim_end_matches('0').trim_end_matches('.').len());
    }
    match word.strip_prefix('0') {
        Some("") => word,
        Some(fraction) if x < 0.0 => format!("-{fraction}"),
        Some(fraction) => fraction.into(),
        None if x < 0.0 => format!("-{word}"),
        None => word,
    }
}

/// A positive number whose last digit 5 is removed, rounded up.
fn rounded_up(mut word: String) -> String {
    word.pop();
    let mut digits = word.trim_end_matches('.').to_owned().into_bytes();
    for digit in digits.iter_mut().rev() {
        match *digit {
            b'9' => *digit = b'0',
            b'.' => {}
            _ => {
                *digit += 1;
                return String::from_utf8_lossy(&digits).into_owned();
            }
        }
    }
    format!("1{}", String::from_utf8_lossy(&digits))
}
