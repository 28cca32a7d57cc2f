//! Cases as lines of JSON, Rust and JavaScript.
//!
//! Numbers have the fewest digits that give them back, so both languages see the same bits. JSON has neither infinities
//! nor NaN, and no case has any.

use crate::case::{Case, SplineData, SurfaceData, Value};
use crate::functions;
use glam::DVec3;
use std::fmt::Debug;

#[derive(Clone, Copy, PartialEq)]
enum Language {
    Json,
    Rust,
    JavaScript,
}
use Language::{JavaScript, Json, Rust};

impl Case {
    /// The case as one line of JSON: its function, number, mode, dimension, size and arguments.
    pub fn to_json(&self) -> String {
        let arguments = self.arguments.iter();
        let arguments = arguments.map(|(name, value)| format!("{name:?}:{}", value.text(Json)));
        format!(
            "{{\"function\":{:?},\"number\":{},\"mode\":\"{:?}\",\"dimension\":{},\"size\":{:?},\"arguments\":{{{}}}}}",
            self.function,
            self.number,
            self.mode,
            self.dimension(),
            self.size(),
            arguments.collect::<Vec<_>>().join(",")
        )
    }

    /// One line of Rust that makes the call, to be pasted into a test.
    pub fn to_rust(&self) -> String {
        self.listing(Rust)
    }

    /// One line of JavaScript that makes the call, to be pasted into a test.
    pub fn to_javascript(&self) -> String {
        self.listing(JavaScript)
    }

    fn listing(&self, language: Language) -> String {
        let (kind, function) = self
            .function
            .split_once("::")
            .unwrap_or(("", self.function));
        let signature = functions::find(self.function).expect("a row");
        let mut line = String::new();
        for ((name, value), (_, kind)) in self.arguments.iter().zip(&signature.arguments) {
            let (name, mut text) = (language.name(name), value.text(language));
            if language == Rust && kind.starts_with("optional") && *value != Value::Nothing {
                text = format!("Some({text})");
            }
            let word = if language == Rust { "let" } else { "const" };
            line += &format!("{word} {name} = {text}; ");
        }
        let mut names = self.arguments.iter().map(|(name, _)| language.name(name));
        let receiver = self
            .arguments
            .first()
            .is_some_and(|(_, value)| value.is_object());
        let (of, separator) = match language {
            _ if receiver && function != "new" => (names.next().unwrap_or_default(), "."),
            Rust => (kind.to_owned(), "::"),
            _ => (kind.to_owned(), "."),
        };
        let (function, names) = (language.name(function), names.collect::<Vec<_>>());
        line + &format!("{of}{separator}{function}({});", names.join(", "))
    }
}

impl Language {
    /// A list of items in brackets.
    fn list<T>(self, items: &[T], text: impl Fn(&T) -> String) -> String {
        let separator = if self == Json { "," } else { ", " };
        let items: Vec<String> = items.iter().map(text).collect();
        format!("[{}]", items.join(separator))
    }

    fn debug<T: Debug>(self, items: &[T]) -> String {
        self.list(items, |item| format!("{item:?}"))
    }

    /// A list of points. In Rust pairs or triples become points.
    fn points(self, dimension: usize, points: &[DVec3]) -> String {
        let list = self.list(points, |p| self.coordinates(dimension, *p));
        match self {
            Rust => format!("{list}.map(DVec{dimension}::from)"),
            _ => list,
        }
    }

    fn coordinates(self, dimension: usize, p: DVec3) -> String {
        let list = self.debug(&p.to_array()[..dimension]);
        match self {
            Rust => format!("({})", &list[1..list.len() - 1]),
            _ => list,
        }
    }

    /// A name of Rust as a name of the language.
    fn name(self, name: &str) -> String {
        match name {
            "approx_eq" if self == JavaScript => String::from("equals"),
            _ if self == JavaScript => camel_case(name),
            _ => name.to_owned(),
        }
    }

    fn spline(self, spline: &SplineData) -> String {
        let (dimension, closed) = (spline.dimension, spline.closed);
        let points = self.points(dimension, &spline.points);
        let degrees = self.debug(&spline.degrees);
        match self {
            Json => format!(
                "{{\"dimension\":{dimension},\"points\":{points},\"degrees\":{degrees},\"closed\":{closed}}}"
            ),
            Rust => format!("Spline::with_degrees({points}.to_vec(), &{degrees}, {closed})?"),
            JavaScript => format!(
                "Spline.fromJSON({{ points: {points}, degrees: {degrees}, closed: {closed} }})"
            ),
        }
    }

    fn surface(self, surface: &SurfaceData) -> String {
        let vertices = self.points(3, &surface.vertices);
        let indices = self.debug(&surface.indices);
        let degrees = self.list(&surface.degrees, |degrees| self.debug(degrees));
        let text = surface_text(surface);
        match self {
            Json => format!(
                "{{\"vertices\":{vertices},\"indices\":{indices},\"degrees\":{degrees},\"text\":{}}}",
                quoted(&text)
            ),
            Rust => {
                format!("Surface::with_degrees({vertices}.to_vec(), vec!{indices}, &{degrees})?")
            }
            // By its text, the one form in which patches may have different degrees.
            JavaScript => format!("Surface.parse({text:?})"),
        }
    }

    fn patch(self, patch: &SurfaceData) -> String {
        let (vertices, [m, n]) = (self.points(3, &patch.vertices), patch.degrees[0]);
        match self {
            Json => self.surface(patch),
            Rust => format!("Patch::new(&{vertices}, {m}, {n})?"),
            JavaScript => format!("new Patch({vertices}, {{ degreeU: {m}, degreeV: {n} }})"),
        }
    }
}

impl Value {
    fn is_object(&self) -> bool {
        use Value::{Curve, Patch, Path, Spline, Surface};
        matches!(
            self,
            Curve(..) | Spline(_) | Path(_) | Patch(_) | Surface(_)
        )
    }

    fn text(&self, language: Language) -> String {
        match (self, language) {
            (Self::Nothing, Json) => String::from("null"),
            (Self::Nothing, Rust) => String::from("None"),
            (Self::Nothing, JavaScript) => String::from("undefined"),
            (Self::Number(x), _) => format!("{x:?}"),
            (Self::Count(n), _) => n.to_string(),
            (Self::Flag(flag), _) => flag.to_string(),
            (Self::Word(word), _) => format!("{word:?}"),
            (Self::Words(words), _) => language.debug(words),
            (Self::Numbers(numbers), _) => language.debug(numbers),
            (Self::Point(dimension, p), Rust) => {
                format!(
                    "DVec{dimension}::new{}",
                    language.coordinates(*dimension, *p)
                )
            }
            (Self::Point(dimension, p), _) => language.coordinates(*dimension, *p),
            (Self::Points(dimension, points), _) => language.points(*dimension, points),
            (Self::Curve(dimension, points), _) => {
                let points = language.points(*dimension, points);
                match language {
                    Json => format!("{{\"dimension\":{dimension},\"points\":{points}}}"),
                    Rust => format!("Curve::new(&{points})?"),
                    JavaScript => format!("new Curve({points})"),
                }
            }
            (Self::Spline(spline), _) => language.spline(spline),
            (Self::Path(splines), _) => {
                let list = language.list(splines, |spline| language.spline(spline));
                match language {
                    Json => list,
                    Rust => format!("Path::new(&{list})"),
                    JavaScript => format!("new Path({list})"),
                }
            }
            (Self::Patch(patch), _) => language.patch(patch),
            (Self::Surface(surface), _) => language.surface(surface),
            (Self::Text(text), Json) => quoted(text),
            (Self::Text(text), _) => format!("{text:?}"),
        }
    }
}

/// A text in quotes, with the escapes of JSON.
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

/// A surface in the indexed form of its text.
fn surface_text(surface: &SurfaceData) -> String {
    let mut text = format!("surface\nvertices {}\n", surface.vertices.len());
    for p in &surface.vertices {
        text += &format!("{:?} {:?} {:?}\n", p.x, p.y, p.z);
    }
    text += &format!("patches {}\n", surface.degrees.len());
    let mut indices = surface.indices.iter().map(u32::to_string);
    for &[m, n] in &surface.degrees {
        text += &format!("{m} {n}\n");
        for _ in 0..=n {
            let row: Vec<String> = indices.by_ref().take(m + 1).collect();
            text += &format!("{}\n", row.join(" "));
        }
    }
    text
}

fn camel_case(name: &str) -> String {
    let mut words = name.split('_');
    let first = words.next().unwrap_or_default().to_owned();
    words.fold(first, |name, word| {
        name + &match word {
            "svg" | "json" | "obj" | "stl" | "glb" => word.to_uppercase(),
            "bspline" => String::from("BSpline"),
            word => word[..1].to_uppercase() + &word[1..],
        }
    })
}
