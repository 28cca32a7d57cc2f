//! Parsing SVG path data.

use super::svg_error::SvgError;
use super::svg_number::{Refusal, SvgScanner};
use crate::geometry::check::is_within_limit;
use crate::path::Path;
use crate::path::arc::Arc;
use crate::path::builder::PathBuilder;
use glam::DVec2;
use std::str::FromStr;

/// The number of arguments of a command; the arc is handled separately.
fn argument_count(command: u8) -> Option<usize> {
    match command {
        b'Z' => Some(0),
        b'H' | b'V' => Some(1),
        b'M' | b'L' | b'T' => Some(2),
        b'S' | b'Q' => Some(4),
        b'C' => Some(6),
        b'A' => Some(7),
        _ => None,
    }
}

impl Path {
    /// Parses a path from the `d` attribute of an SVG `<path>`.
    ///
    /// Supports all commands M L H V C S Q T A Z in upper and lower case, repeated arguments, and all number forms of
    /// the grammar ("1." too, as in SVG 1.1). Lines get degree 1, quadratics 2, cubics 3. An arc is converted to
    /// as few cubics as possible within 10⁻⁵ of the larger radius (8 for a circle of two arcs; see
    /// [`from_svg_with`](Self::from_svg_with)); radii that are too small are scaled up, a radius of 0 gives a
    /// line, and an arc whose ends are equal is omitted. If the ends are diametrically opposite up to the rounding of
    /// their coordinates, the arc is half the ellipse.
    ///
    /// Every `M` starts a subpath. A subpath without a segment ("M1 1" alone) draws nothing and is omitted; "M1 1Z" is
    /// a closed subpath of one line of length 0 (a dot, with round caps). `Z` adds a line to the start unless the
    /// current point is there; a `Z` directly after a `Z` has no effect. Empty data gives the empty path.
    ///
    /// The time is proportional to the length of the text. Source: *SVG 2*, §9.3 (grammar), §9.5 (errors), B.2 (arcs).
    ///
    /// # Errors
    /// [`SvgError`] with the offset and the path before it; as SVG requires, the path ends at the error.
    pub fn from_svg(d: &str) -> Result<Self, SvgError> {
        read_path(d, PathBuilder::new())
    }

    /// Parses a path as [`from_svg`](Self::from_svg), with cubics within `arc_tolerance` of the arcs, in the unit of the
    /// path; see [`PathBuilder::arc_tolerance`].
    ///
    /// # Errors
    /// [`SvgError`] for a text as [`from_svg`](Self::from_svg), and at offset 0 for a tolerance that is not above 0.
    ///
    /// ```
    /// use casteljau::Path;
    ///
    /// let circle = "M2 0A2 2 0 0 1 -2 0 2 2 0 0 1 2 0Z";
    /// assert_eq!(Path::from_svg(circle)?.segment_count(), 8);
    /// assert_eq!(Path::from_svg_with(circle, 1e-3)?.segment_count(), 4);
    /// assert_eq!(Path::from_svg_with(circle, 2e-9)?.segment_count(), 34);
    /// # Ok::<(), casteljau::path::SvgError>(())
    /// ```
    pub fn from_svg_with(d: &str, arc_tolerance: f64) -> Result<Self, SvgError> {
        if arc_tolerance.is_nan() || arc_tolerance <= 0.0 {
            return Err(SvgError {
                offset: 0,
                expected: "an arc tolerance above 0",
                got: arc_tolerance.to_string(),
                path: Self::default(),
            });
        }
        let mut builder = PathBuilder::new();
        builder.arc_tolerance(arc_tolerance);
        read_path(d, builder)
    }
}

impl FromStr for Path {
    type Err = SvgError;

    /// Parses SVG path data; see [`Path::from_svg`].
    fn from_str(d: &str) -> Result<Self, SvgError> {
        Self::from_svg(d)
    }
}

/// Parses path data with an empty builder.
fn read_path(d: &str, builder: PathBuilder) -> Result<Path, SvgError> {
    let mut scanner = SvgScanner::new(d);
    let mut reader = PathReader {
        builder,
        cubic: None,
        quadratic: None,
    };
    // The property d has the value `none` for an empty path (SVG 2, §9.3.2).
    let is_blank = [' ', '\t', '\n', '\x0c', '\r'];
    let result = if d.trim_matches(is_blank) == "none" {
        Ok(())
    } else {
        read(&mut scanner, &mut reader)
    };
    let path = reader.builder.finished();
    match result {
        Ok(()) => Ok(path),
        Err(Refusal { offset, expected }) => Err(SvgError {
            offset,
            expected,
            got: scanner.shown(offset),
            path,
        }),
    }
}

fn read(scanner: &mut SvgScanner<'_>, reader: &mut PathReader) -> Result<(), Refusal> {
    scanner.skip_blanks();
    let mut expected = "\"M\" or \"m\"";
    while !scanner.at_end() {
        let command = scanner.peek();
        // A path starts with a moveto.
        let first = expected != "a command";
        let count = argument_count(command.to_ascii_uppercase())
            .filter(|_| !first || command.eq_ignore_ascii_case(&b'M'));
        let Some(count) = count else {
            return Err(Refusal {
                offset: scanner.at,
                expected,
            });
        };
        expected = "a command";
        scanner.at += 1;
        scanner.skip_blanks();
        if count == 0 {
            reader.close();
        } else {
            read_groups(scanner, reader, command, count)?;
        }
    }
    Ok(())
}

/// Reads one or more groups of arguments of a command.
fn read_groups(
    scanner: &mut SvgScanner<'_>,
    reader: &mut PathReader,
    mut command: u8,
    count: usize,
) -> Result<(), Refusal> {
    loop {
        let offset = scanner.at;
        let mut numbers = [0.0; 7];
        for (k, number) in numbers[..count].iter_mut().enumerate() {
            if k > 0 {
                scanner.skip_separator();
            }
            // The two flags of an arc are one character each, and need no separator: "011 1" are 0, 1, 1 and 1.
            let flag = count == 7 && (k == 3 || k == 4);
            *number = if flag {
                f64::from(u8::from(scanner.flag()?))
            } else {
                scanner.number()?
            };
        }
        if !reader.draw(command, &numbers) {
            return Err(Refusal {
                offset,
                expected: "coordinates from -2^500 to 2^500",
            });
        }
        // After a comma there have to be further arguments, without one there may be.
        let comma = scanner.skip_separator();
        if !comma && !scanner.at_number() {
            return Ok(());
        }
        // Further arguments of a moveto are linetos.
        command = match command {
            b'M' => b'L',
            b'm' => b'l',
            _ => command,
        };
    }
}

/// The state of the parser: the path so far, and the points that later commands refer to.
struct PathReader {
    builder: PathBuilder,
    /// The last control point of the previous command if it was a cubic (for S) or a quadratic (for T).
    cubic: Option<DVec2>,
    quadratic: Option<DVec2>,
}

impl PathReader {
    /// Adds one command with its numbers. Returns false if a coordinate exceeds the limit.
    fn draw(&mut self, command: u8, n: &[f64; 7]) -> bool {
        let from = self.builder.current_point();
        let base = if command.is_ascii_lowercase() {
            from
        } else {
            DVec2::splat(-0.0) // the neutral element of addition, also for −0
        };
        let point = |k: usize| base + DVec2::new(n[k], n[k + 1]);
        // Without a curve of the same kind before it, S or T starts with a handle at the current point.
        let reflected = |control: Option<DVec2>| control.map_or(from, |c| from + (from - c));
        match command.to_ascii_uppercase() {
            b'M' => self.move_to(point(0)),
            b'L' => self.segment(&[point(0)]),
            b'H' => self.segment(&[DVec2::new(base.x + n[0], from.y)]),
            b'V' => self.segment(&[DVec2::new(from.x, base.y + n[0])]),
            b'C' => self.segment(&[point(0), point(2), point(4)]),
            b'S' => self.segment(&[reflected(self.cubic), point(0), point(2)]),
            b'Q' => self.segment(&[point(0), point(2)]),
            b'T' => self.segment(&[reflected(self.quadratic), point(0)]),
            _ => self.arc(n, point(5)),
        }
    }

    fn move_to(&mut self, p: DVec2) -> bool {
        if !is_within_limit(p) {
            return false;
        }
        self.builder.move_to(p);
        (self.cubic, self.quadratic) = (None, None);
        true
    }

    /// Adds a line, a quadratic or a cubic by its points after the first.
    fn segment(&mut self, points: &[DVec2]) -> bool {
        if !points.iter().all(|&p| is_within_limit(p)) {
            return false;
        }
        self.builder.add_segment(points);
        (self.cubic, self.quadratic) = match *points {
            [_, control, _] => (Some(control), None),
            [control, _] => (None, Some(control)),
            _ => (None, None),
        };
        true
    }

    fn arc(&mut self, n: &[f64; 7], to: DVec2) -> bool {
        (self.cubic, self.quadratic) = (None, None);
        is_within_limit(to)
            && self.builder.add_arc(&Arc {
                from: self.builder.current_point(),
                to,
                radii: DVec2::new(n[0].abs(), n[1].abs()),
                degrees: n[2],
                large: n[3] != 0.0,
                sweep: n[4] != 0.0,
            })
    }

    fn close(&mut self) {
        self.builder.close();
        (self.cubic, self.quadratic) = (None, None);
    }
}
