//! Cases as lines of Rust and of JavaScript, to be pasted into a test.

use crate::case::{Case, SplineData, SurfaceData, Value};
use crate::functions;
use glam::DVec3;

impl Case {
    /// One line of Rust that makes the call.
    pub fn to_rust(&self) -> String {
        self.listing(
            Value::to_rust,
            |value| value.is_object(),
            "::",
            |name| name.to_owned(),
        )
    }

    /// One line of JavaScript that makes the call.
    pub fn to_javascript(&self) -> String {
        self.listing(
            Value::to_javascript,
            |value| value.is_object(),
            ".",
            camel_case,
        )
    }

    fn listing(
        &self,
        text: fn(&Value) -> String,
        is_object: fn(&Value) -> bool,
        separator: &str,
        rename: fn(&str) -> String,
    ) -> String {
        let (kind, function) = self
            .function
            .split_once("::")
            .unwrap_or(("", self.function));
        let word = if separator == "::" { "let" } else { "const" };
        let mut line = String::new();
        let kinds = functions::find(self.function).map_or(Vec::new(), |known| known.arguments);
        for (k, (name, value)) in self.arguments.iter().enumerate() {
            let mut text = text(value);
            let optional = kinds
                .get(k)
                .is_some_and(|(_, kind)| kind.starts_with("optional"));
            if optional && word == "let" && *value != Value::Nothing {
                text = format!("Some({text})");
            }
            line += &format!("{word} {} = {text}; ", rename(name));
        }
        let mut names = self.arguments.iter().map(|(name, _)| rename(name));
        let receiver = self
            .arguments
            .first()
            .is_some_and(|(_, value)| is_object(value));
        let call = if receiver && function != "new" {
            format!("{}.{}", names.next().unwrap_or_default(), rename(function))
        } else {
            format!("{kind}{separator}{}", rename(function))
        };
        line + &format!("{call}({});", names.collect::<Vec<_>>().join(", "))
    }
}

impl Value {
    fn is_object(&self) -> bool {
        matches!(
            self,
            Self::Curve(..) | Self::Spline(_) | Self::Path(_) | Self::Patch(_) | Self::Surface(_)
        )
    }

    fn to_rust(&self) -> String {
        match self {
            Self::Nothing => String::from("None"),
            Self::Word(word) => format!("{word:?}"),
            Self::Words(words) => format!("{words:?}"),
            Self::Numbers(numbers) => format!("{numbers:?}"),
            Self::Point(dimension, p) => rust_point(*dimension, *p),
            Self::Points(dimension, points) => rust_points(*dimension, points),
            Self::Curve(dimension, points) => {
                format!("Curve::new(&{})?", rust_points(*dimension, points))
            }
            Self::Spline(spline) => rust_spline(spline),
            Self::Path(splines) => format!("Path::new(&[{}])", joined(splines, rust_spline)),
            Self::Patch(SurfaceData {
                vertices, degrees, ..
            }) => {
                format!(
                    "Patch::new(&{}, {}, {})?",
                    rust_points(3, vertices),
                    degrees[0][0],
                    degrees[0][1]
                )
            }
            Self::Surface(SurfaceData {
                vertices,
                indices,
                degrees,
            }) => {
                format!(
                    "Surface::with_degrees({}.to_vec(), vec!{indices:?}, &{degrees:?})?",
                    rust_points(3, vertices)
                )
            }
            other => other.to_javascript(),
        }
    }

    fn to_javascript(&self) -> String {
        match self {
            Self::Nothing => String::from("undefined"),
            Self::Number(x) => format!("{x:?}"),
            Self::Count(n) => n.to_string(),
            Self::Flag(flag) => flag.to_string(),
            Self::Word(text) => format!("{text:?}"),
            Self::Text(text) => format!("{text:?}"),
            Self::Words(words) => format!("{words:?}"),
            Self::Numbers(numbers) => format!("{numbers:?}"),
            Self::Point(dimension, p) => format!("{:?}", &p.to_array()[..*dimension]),
            Self::Points(dimension, points) => js_points(*dimension, points),
            Self::Curve(dimension, points) => {
                format!("new Curve({})", js_points(*dimension, points))
            }
            Self::Spline(spline) => js_spline(spline),
            Self::Path(splines) => format!("new Path([{}])", joined(splines, js_spline)),
            Self::Patch(SurfaceData {
                vertices, degrees, ..
            }) => {
                format!(
                    "new Patch({}, {{ degreeU: {}, degreeV: {} }})",
                    js_points(3, vertices),
                    degrees[0][0],
                    degrees[0][1]
                )
            }
            Self::Surface(surface) => js_surface(surface),
        }
    }
}

fn joined<T>(items: &[T], text: impl Fn(&T) -> String) -> String {
    items.iter().map(text).collect::<Vec<_>>().join(", ")
}

fn rust_point(dimension: usize, p: DVec3) -> String {
    let numbers = joined(&p.to_array()[..dimension], |x| format!("{x:?}"));
    format!("DVec{dimension}::new({numbers})")
}

fn rust_points(dimension: usize, points: &[DVec3]) -> String {
    let tuples = joined(points, |p| {
        format!(
            "({})",
            joined(&p.to_array()[..dimension], |x| format!("{x:?}"))
        )
    });
    format!("[{tuples}].map(DVec{dimension}::from)")
}

fn rust_spline(spline: &SplineData) -> String {
    let points = rust_points(spline.dimension, &spline.points);
    format!(
        "Spline::with_degrees({points}.to_vec(), &{:?}, {})?",
        spline.degrees, spline.closed
    )
}

fn js_points(dimension: usize, points: &[DVec3]) -> String {
    format!(
        "[{}]",
        joined(points, |p| format!("{:?}", &p.to_array()[..dimension]))
    )
}

fn js_spline(spline: &SplineData) -> String {
    let points = js_points(spline.dimension, &spline.points);
    format!(
        "Spline.fromJSON({{ points: {points}, degrees: {:?}, closed: {} }})",
        spline.degrees, spline.closed
    )
}

/// By its text, the one form in which patches may have different degrees.
fn js_surface(surface: &SurfaceData) -> String {
    format!("Surface.parse({:?})", surface_text(surface))
}

/// A surface in the indexed form of its text.
pub(crate) fn surface_text(
    SurfaceData {
        vertices,
        indices,
        degrees,
    }: &SurfaceData,
) -> String {
    let mut text = format!("surface\nvertices {}\n", vertices.len());
    for p in vertices {
        text += &format!("{:?} {:?} {:?}\n", p.x, p.y, p.z);
    }
    text += &format!("patches {}\n", degrees.len());
    let mut rest = indices.as_slice();
    for &[m, n] in degrees {
        text += &format!("{m} {n}\n");
        for _ in 0..=n {
            let (row, others) = rest.split_at(m + 1);
            let words: Vec<String> = row.iter().map(u32::to_string).collect();
            text += &format!("{}\n", words.join(" "));
            rest = others;
        }
    }
    text
}

fn camel_case(name: &str) -> String {
    if name == "approx_eq" {
        return String::from("equals");
    }
    let mut words = name.split('_');
    let first = words.next().unwrap_or_default().to_owned();
    let upper = |word: &str| match word {
        "svg" | "json" | "obj" | "stl" | "glb" => word.to_uppercase(),
        "bspline" => String::from("BSpline"),
        word => word[..1].to_uppercase() + &word[1..],
    };
    words.fold(first, |name, word| name + &upper(word))
}
