//! Writes an SVG picture of a spline, its control polygon, and a polyline within one pixel of it:
//!
//!     cargo run --example svg > spline.svg

use casteljau::glam::DVec2;
use casteljau::{Error, Spline, curve::PathSink};
use std::fmt::Write;

/// A path sink that writes SVG path data.
#[derive(Default)]
struct PathData(String);

impl PathData {
    fn step(&mut self, letter: char, points: &[DVec2]) {
        self.0.push(letter);
        for p in points {
            // Writing to a String cannot fail.
            let _ = write!(self.0, "{:.2} {:.2} ", p.x, p.y);
        }
    }
}

impl PathSink for PathData {
    fn move_to(&mut self, p: DVec2) {
        self.step('M', &[p]);
    }
    fn line_to(&mut self, p: DVec2) {
        self.step('L', &[p]);
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.step('Q', &[p1, p]);
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.step('C', &[p1, p2, p]);
    }
    fn close(&mut self) {
        self.step('Z', &[]);
    }
}

fn polyline(points: &[DVec2]) -> String {
    let mut data = PathData::default();
    for (i, &p) in points.iter().enumerate() {
        if i == 0 {
            data.move_to(p)
        } else {
            data.line_to(p)
        }
    }
    data.0
}

fn main() -> Result<(), Error> {
    let points = [
        (70, 330),
        (110, 90),
        (235, 120),
        (325, 230),
        (433, 362),
        (590, 400),
        (600, 130),
    ]
    .map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    let spline = Spline::new(&points, 3, false)?;
    let mut curve = PathData::default();
    spline.trace(&mut curve);
    let chords = spline.flatten(1.0)?;
    println!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 670 480" fill="none">"#);
    println!(r##"<path d="{}" stroke="#D55E00"/>"##, polyline(&points));
    println!(
        r##"<path d="{}" stroke="#0072B2" stroke-width="3"/>"##,
        curve.0
    );
    println!(
        r##"<path d="{}" stroke="#009E73"/></svg>"##,
        polyline(&chords.points)
    );
    Ok(())
}
