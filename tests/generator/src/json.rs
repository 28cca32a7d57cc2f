//! Cases as lines of JSON. Numbers have the fewest digits that give them back, so both languages see the same bits.

use crate::case::{Case, SplineData, SurfaceData, Value};
use crate::listing::surface_text;
use glam::DVec3;

impl Case {
    /// The case as one line of JSON: its function, number and mode, the line to paste into a test, and the arguments.
    pub fn to_json(&self) -> String {
        let arguments = self
            .arguments
            .iter()
            .map(|(name, value)| format!("{}:{}", quoted(name), value.to_json()));
        format!(
            "{{\"function\":{},\"number\":{},\"mode\":{},\"dimension\":{},\"size\":{},\"arguments\":{{{}}}}}",
            quoted(self.function),
            self.number,
            quoted(&format!("{:?}", self.mode)),
            self.dimension(),
            number(self.size()),
            arguments.collect::<Vec<_>>().join(",")
        )
    }
}

impl Value {
    fn to_json(&self) -> String {
        match self {
            Self::Nothing => String::from("null"),
            Self::Number(x) => number(*x),
            Self::Count(n) => n.to_string(),
            Self::Flag(flag) => flag.to_string(),
            Self::Word(word) => quoted(word),
            Self::Words(words) => list(words, |word| quoted(word)),
            Self::Numbers(numbers) => list(numbers, |x| number(*x)),
            Self::Point(dimension, p) => point(*dimension, *p),
            Self::Points(dimension, points) => list(points, |p| point(*dimension, *p)),
            Self::Curve(dimension, points) => format!(
                "{{\"dimension\":{dimension},\"points\":{}}}",
                list(points, |p| point(*dimension, *p))
            ),
            Self::Spline(spline) => spline.to_json(),
            Self::Path(splines) => list(splines, SplineData::to_json),
            Self::Patch(surface) | Self::Surface(surface) => surface.to_json(),
            Self::Text(text) => quoted(text),
        }
    }
}

impl SplineData {
    fn to_json(&self) -> String {
        let points = list(&self.points, |p| point(self.dimension, *p));
        let degrees = list(&self.degrees, usize::to_string);
        format!(
            "{{\"dimension\":{},\"points\":{points},\"degrees\":{degrees},\"closed\":{}}}",
            self.dimension, self.closed
        )
    }
}

impl SurfaceData {
    fn to_json(&self) -> String {
        let vertices = list(&self.vertices, |p| point(3, *p));
        let degrees = list(&self.degrees, |[m, n]| format!("[{m},{n}]"));
        format!(
            "{{\"vertices\":{vertices},\"indices\":{},\"degrees\":{degrees},\"text\":{}}}",
            list(&self.indices, u32::to_string),
            quoted(&surface_text(self))
        )
    }
}

fn list<T>(items: &[T], text: impl Fn(&T) -> String) -> String {
    format!("[{}]", items.iter().map(text).collect::<Vec<_>>().join(","))
}

/// JSON has neither infinities nor NaN, and no case has any.
fn number(x: f64) -> String {
    format!("{x:?}")
}

fn point(dimension: usize, p: DVec3) -> String {
    list(&p.to_array()[..dimension], |x| number(*x))
}

fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c < ' ' => quoted += &format!("\\u{:04x}", u32::from(c)),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
