//! Cases as lines of JSON and JavaScript.
//!
//! Numbers have the fewest digits that give them back, so both languages see the same bits. JSON has neither infinities
//! nor NaN, and no case has any.

use crate::case::{Case, NurbsSurfaceData, RationalData, SplineData, SurfaceData, Value};
use glam::DVec3;
use std::fmt::Debug;

#[derive(Clone, Copy, PartialEq)]
enum Language {
    Json,
    JavaScript,
}
use Language::{JavaScript, Json};

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

    /// One line of JavaScript that makes the call, to be pasted into a test.
    pub fn to_javascript(&self) -> String {
        let (kind, function) = self
            .function
            .split_once("::")
            .unwrap_or(("", self.function));
        let mut line = String::new();
        for (name, value) in &self.arguments {
            line += &format!("const {} = {}; ", camel_case(name), value.text(JavaScript));
        }
        let mut names = self.arguments.iter().map(|(name, _)| camel_case(name));
        let receiver = self
            .arguments
            .first()
            .is_some_and(|(_, value)| value.is_object());
        let of = match receiver && function != "new" {
            true => names.next().unwrap_or_default(),
            false => kind.to_owned(),
        };
        let function = if function == "approx_eq" {
            "equals".to_owned()
        } else {
            camel_case(function)
        };
        line + &format!("{of}.{function}({});", names.collect::<Vec<_>>().join(", "))
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

    fn points(self, dimension: usize, points: &[DVec3]) -> String {
        self.list(points, |p| self.coordinates(dimension, *p))
    }

    fn coordinates(self, dimension: usize, p: DVec3) -> String {
        self.debug(&p.to_array()[..dimension])
    }

    fn spline(self, spline: &SplineData) -> String {
        let (dimension, closed) = (spline.dimension, spline.closed);
        let points = self.points(dimension, &spline.points);
        let degrees = self.debug(&spline.degrees);
        match self {
            Json => format!(
                "{{\"dimension\":{dimension},\"points\":{points},\"degrees\":{degrees},\"closed\":{closed}}}"
            ),
            JavaScript => format!(
                "Spline.fromJSON({{ points: {points}, degrees: {degrees}, closed: {closed} }})"
            ),
        }
    }

    fn rational(self, curve: &RationalData) -> String {
        let dimension = curve.dimension;
        let points = self.points(dimension, &curve.points);
        let weights = self.debug(&curve.weights);
        match self {
            Json => {
                format!("{{\"dimension\":{dimension},\"points\":{points},\"weights\":{weights}}}")
            }
            JavaScript => format!("new RationalCurve({points}, {weights})"),
        }
    }

    fn nurbs(self, curve: &RationalData) -> String {
        let (dimension, degree, closed) = (curve.dimension, curve.degree, curve.closed);
        let points = self.points(dimension, &curve.points);
        let [weights, knots] = [&curve.weights, &curve.knots].map(|list| self.debug(list));
        match self {
            Json => format!(
                "{{\"dimension\":{dimension},\"degree\":{degree},\"points\":{points},\"weights\":{weights},\"knots\":{knots},\"closed\":{closed}}}"
            ),
            JavaScript => format!(
                "new NurbsCurve({{ degree: {degree}, points: {points}, weights: {weights}, knots: {knots}, closed: {closed} }})"
            ),
        }
    }

    fn rational_patch(self, patch: &NurbsSurfaceData) -> String {
        let (points, [m, n]) = (self.points(3, &patch.points), patch.degrees);
        let weights = self.debug(&patch.weights);
        match self {
            Json => {
                format!("{{\"points\":{points},\"weights\":{weights},\"degrees\":[{m},{n}]}}")
            }
            JavaScript => {
                format!("new RationalPatch({points}, {weights}, {{ degreeU: {m}, degreeV: {n} }})")
            }
        }
    }

    fn nurbs_surface(self, surface: &NurbsSurfaceData) -> String {
        let (points, [m, n]) = (self.points(3, &surface.points), surface.degrees);
        let weights = self.debug(&surface.weights);
        let [u, v] = [0, 1].map(|k| self.debug(&surface.knots[k]));
        match self {
            Json => format!(
                "{{\"points\":{points},\"weights\":{weights},\"degrees\":[{m},{n}],\"knots\":[{u},{v}]}}"
            ),
            JavaScript => format!(
                "new NurbsSurface({{ degreeU: {m}, degreeV: {n}, points: {points}, weights: {weights}, knotsU: {u}, knotsV: {v} }})"
            ),
        }
    }

    fn surface(self, class: &str, surface: &SurfaceData) -> String {
        let vertices = self.points(3, &surface.vertices);
        let indices = self.debug(&surface.indices);
        let degrees = self.list(&surface.degrees, |degrees| self.debug(degrees));
        let text = surface_text(surface);
        match self {
            Json => format!(
                "{{\"vertices\":{vertices},\"indices\":{indices},\"degrees\":{degrees},\"text\":{}}}",
                quoted(&text)
            ),
            // By its text, the one form in which patches may have different degrees.
            JavaScript => format!("{class}.parse({text:?})"),
        }
    }

    fn patch(self, patch: &SurfaceData) -> String {
        let (vertices, [m, n]) = (self.points(3, &patch.vertices), patch.degrees[0]);
        match self {
            Json => self.surface("Surface", patch),
            JavaScript => format!("new Patch({vertices}, {{ degreeU: {m}, degreeV: {n} }})"),
        }
    }
}

impl Value {
    fn is_object(&self) -> bool {
        use Value::{
            Curve, NurbsCurve, NurbsSurface, Patch, Path, RationalCurve, RationalPatch,
            RationalSurface, Spline, Surface,
        };
        matches!(
            self,
            Curve(..)
                | RationalCurve(_)
                | NurbsCurve(_)
                | Spline(_)
                | Path(_)
                | Patch(_)
                | RationalPatch(_)
                | NurbsSurface(_)
                | Surface(_)
                | RationalSurface(_)
        )
    }

    fn text(&self, language: Language) -> String {
        match (self, language) {
            (Self::Nothing, Json) => String::from("null"),
            (Self::Nothing, JavaScript) => String::from("undefined"),
            (Self::Number(x), _) => format!("{x:?}"),
            (Self::Count(n), _) => n.to_string(),
            (Self::Flag(flag), _) => flag.to_string(),
            (Self::Word(word), _) => format!("{word:?}"),
            (Self::Words(words), _) => language.debug(words),
            (Self::Numbers(numbers), _) => language.debug(numbers),
            (Self::Point(dimension, p), _) => language.coordinates(*dimension, *p),
            (Self::Points(dimension, points), _) => language.points(*dimension, points),
            (Self::Curve(dimension, points), _) => {
                let points = language.points(*dimension, points);
                match language {
                    Json => format!("{{\"dimension\":{dimension},\"points\":{points}}}"),
                    JavaScript => format!("new Curve({points})"),
                }
            }
            (Self::RationalCurve(curve), _) => language.rational(curve),
            (Self::NurbsCurve(curve), _) => language.nurbs(curve),
            (Self::Spline(spline), _) => language.spline(spline),
            (Self::Path(splines), _) => {
                let list = language.list(splines, |spline| language.spline(spline));
                match language {
                    Json => list,
                    JavaScript => format!("new Path({list})"),
                }
            }
            (Self::Patch(patch), _) => language.patch(patch),
            (Self::RationalPatch(patch), _) => language.rational_patch(patch),
            (Self::NurbsSurface(surface), _) => language.nurbs_surface(surface),
            (Self::Surface(surface), _) => language.surface("Surface", surface),
            (Self::RationalSurface(surface), _) => language.surface("RationalSurface", surface),
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
    let mut weights = surface.weights.iter();
    for &[m, n] in &surface.degrees {
        text += &format!("{m} {n}\n");
        for _ in 0..=n {
            let row: Vec<String> = indices.by_ref().take(m + 1).collect();
            text += &format!("{}\n", row.join(" "));
        }
        for _ in 0..if surface.weights.is_empty() { 0 } else { n + 1 } {
            let row: Vec<String> = (weights.by_ref().take(m + 1))
                .map(|w| format!("{w:?}"))
                .collect();
            text += &format!("w {}\n", row.join(" "));
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
