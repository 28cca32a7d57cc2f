//! A value for each kind of argument.

use crate::adversarial::MAX_COORDINATE;
use crate::case::{Case, Mode, Value};
use crate::functions;
use crate::geometry;
use crate::large;
use crate::random::{Rng, real};
use crate::texts;
use glam::DVec3;

/// One of this many cases has a path of 10² to 10³ segments, or a surface of 10² patches; one of twenty of these has a
/// path of up to 10⁴ segments.
const CASES_PER_LARGE_CASE: u64 = 500;

/// The largest number of control points of drawings with wide strokes.
const MAX_POINTS_WITH_WIDE_STROKES: usize = 90;

pub(crate) const BASES: [&str; 4] = ["bezier", "hermite", "b-spline", "catmull-rom"];
pub(crate) const MODES: [&str; 6] = ["free", "g1", "c1", "c2", "g2", "auto"];

/// The words of each kind of choice.
const CHOICES: &[(&str, &[&str])] = &[
    ("named basis", &BASES),
    ("interpolation", &["natural", "catmull-rom"]),
    ("join", &["round", "miter", "bevel"]),
    ("joint mode", &MODES),
    ("rule", &["nonzero", "evenodd"]),
    ("method", &["bernstein", "forward"]),
    ("weld", &["position", "normal", "none"]),
    ("height", &["squashed", "original"]),
    ("up", &["z", "y"]),
    ("wire", &["tube", "ribbon"]),
];

/// The case of a seed, a function and a number.
///
/// # Panics
/// For a function that is not in the table, and for a kind of argument that this file does not know.
pub fn case(seed: u64, function: &str, number: u64) -> Case {
    let signature = functions::find(function)
        .unwrap_or_else(|| panic!("no row for {function} in functions.rs"));
    let mut rng = Rng::for_case(seed, signature.name, number);
    let mode = match number % 16 {
        15 => Mode::Extreme,
        number if number % 2 == 1 => Mode::MixedScale,
        _ => Mode::Moderate,
    };
    let mut result = Case {
        seed,
        function: signature.name,
        number,
        mode,
        arguments: Vec::new(),
    };
    for &(name, kind) in &signature.arguments {
        let value = Maker::new(&mut rng, &result).value(kind);
        result.arguments.push((name, value));
    }
    result
}

/// Makes one argument; the earlier ones are known.
pub(crate) struct Maker<'a> {
    pub(crate) rng: &'a mut Rng,
    pub(crate) mode: Mode,
    pub(crate) result: &'a Case,
}

impl<'a> Maker<'a> {
    fn new(rng: &'a mut Rng, result: &'a Case) -> Self {
        let mode = result.mode;
        Self { rng, mode, result }
    }

    fn value(&mut self, kind: &'static str) -> Value {
        if let Some(kind) = kind.strip_prefix("optional ") {
            let left_out = self.rng.chance(0.5);
            return if left_out {
                Value::Nothing
            } else {
                self.value(kind)
            };
        }
        if let Some((_, words)) = CHOICES.iter().find(|(known, _)| *known == kind) {
            return Value::Word(self.rng.pick(words));
        }
        let value = self
            .geometry(kind)
            .or_else(|| self.number(kind).map(Value::Number));
        let value = value.or_else(|| self.count(kind).map(Value::Count));
        let value = value.or_else(|| self.list(kind));
        let value = value.or_else(|| texts::text(self.rng, kind).map(Value::Text));
        value.unwrap_or_else(|| panic!("no kind of argument: {kind}"))
    }

    fn geometry(&mut self, kind: &str) -> Option<Value> {
        let (mode, rng) = (self.mode, &mut *self.rng);
        let any = 2 + rng.below(2);
        let curve = |rng: &mut Rng, dimension, max| {
            Value::Curve(dimension, geometry::curve(rng, mode, dimension, max))
        };
        let number = self.result.number;
        let is_large = number % CASES_PER_LARGE_CASE == CASES_PER_LARGE_CASE / 2;
        let is_largest = number % (20 * CASES_PER_LARGE_CASE) == CASES_PER_LARGE_CASE / 2;
        Some(match kind {
            "curve" => curve(rng, any, 24),
            "curve2" => curve(rng, 2, 24),
            "curve3" => curve(rng, 3, 24),
            "cubic" => curve(rng, any, 3),
            "other" => match &self.result.arguments[0].1 {
                Value::Curve(dimension, first) => {
                    Value::Curve(*dimension, geometry::related(rng, mode, *dimension, first))
                }
                Value::RationalCurve(first) => {
                    Value::RationalCurve(geometry::related_rational(rng, mode, first))
                }
                Value::NurbsCurve(first) => {
                    Value::NurbsCurve(geometry::related_nurbs(rng, mode, first))
                }
                _ => panic!("another curve needs a first one"),
            },
            "rationalcurve" => Value::RationalCurve(geometry::rational(rng, mode, any)),
            "rationalcurve2" => Value::RationalCurve(geometry::rational(rng, mode, 2)),
            "nurbscurve" => Value::NurbsCurve(geometry::nurbs(rng, mode, any)),
            "nurbscurve2" => Value::NurbsCurve(geometry::nurbs(rng, mode, 2)),
            "spline" => Value::Spline(geometry::spline(rng, mode, any)),
            "spline2" => Value::Spline(geometry::spline(rng, mode, 2)),
            "spline3" => Value::Spline(geometry::spline(rng, mode, 3)),
            "path" if is_largest => Value::Path(large::path(rng, 4.0)),
            "path" if is_large => Value::Path(large::path(rng, 3.0)),
            "path" => Value::Path(geometry::path(rng, mode)),
            "patch" => Value::Patch(geometry::patch(rng, mode)),
            "rationalpatch" => Value::RationalPatch(geometry::rational_patch(rng, mode)),
            "nurbscurve3" => Value::NurbsCurve(geometry::nurbs(rng, mode, 3)),
            "nurbssurface" => Value::NurbsSurface(geometry::nurbs_surface(rng, mode)),
            "rationalsurface" => {
                Value::RationalSurface(geometry::rational_surface(rng, mode, is_large))
            }
            "surface" if is_large => Value::Surface(large::surface(rng)),
            "surface" => Value::Surface(geometry::surface(rng, mode)),
            "point" => self.point(),
            "direction" => {
                let direction = rng.point(3) * rng.magnitude(-3.0, 3.0);
                let is_rounded = rng.chance(0.2);
                Value::Point(
                    3,
                    if is_rounded {
                        direction.round()
                    } else {
                        direction
                    },
                )
            }
            _ => return None,
        })
    }

    /// Near the geometry, on one of its control points, or far away.
    fn point(&mut self) -> Value {
        let (dimension, size) = (self.result.dimension(), self.size());
        let known = control_points(&self.result.arguments[0].1);
        let random = self.rng.point(3) * size;
        let mut p = match self.rng.below(8) {
            0 | 1 if !known.is_empty() => known[self.rng.below(known.len())],
            2 if !known.is_empty() => (known[0] + known[known.len() - 1]) * 0.5,
            3 => random * 1e3_f64.min(MAX_COORDINATE / (1.0 + size)),
            4 => DVec3::ZERO,
            _ => random,
        };
        if dimension == 2 {
            p.z = 0.0;
        }
        Value::Point(dimension, p)
    }

    /// The size of the earlier arguments, 1 where there is none.
    pub(crate) fn size(&self) -> f64 {
        let size = self.result.size();
        if size > 0.0 { size } else { 1.0 }
    }

    fn number(&mut self, kind: &str) -> Option<f64> {
        let (size, mixed) = (self.size(), self.mode == Mode::MixedScale);
        let min = if mixed { -12.0 } else { -6.0 };
        Some(match kind {
            "t" => parameter(self.rng, 1.0),
            "spline t" => parameter(self.rng, self.segments()),
            "nurbs t" => self.nurbs_parameter(),
            "surface u" => self.surface_parameter(0),
            "surface v" => self.surface_parameter(1),
            "weight" => geometry::weight(self.rng),
            "unit" => {
                let same = self.rng.clone().unit();
                self.rng.pick(&[0.0, 0.5, 1.0, same, same])
            }
            "handle" => self.handle(),
            "length" => self.length(size),
            "coordinate" => self.rng.signed() * size,
            "tolerance" => self.tolerance(size, min, -1.0),
            "coarse tolerance" => self.tolerance(size, min.max(-5.0), -1.0),
            // Large answers take long to make and to check: few cases ask for them.
            "flatten tolerance" => self.seldom_fine(0.01, size, min.max(-10.0), -7.0),
            "piece tolerance" => self.seldom_fine(0.02, size, min.max(-5.0), -2.0),
            "mesh tolerance" => self.seldom_fine(0.004, size, min, -3.0),
            "easing tolerance" => self.tolerance(1.0, -4.2, 1.0),
            "wire width" => self.tolerance(size, -4.0, -1.0),
            // Any number above 0 is allowed here.
            "pixels" if self.rng.chance(0.02) => self.rng.pick(&[0.0, -1.0]),
            "pixels" => {
                let across = self.pixels_across();
                let (size, min) = across.map_or((1.0, -1.0), |size| (size, -3.0));
                let is_fine = self.rng.chance(0.004);
                size * self.rng.magnitude(if is_fine { -4.0 } else { min }, 0.0)
            }
            _ => return None,
        })
    }

    /// Inside the domain of a NURBS curve, at its ends and knots; one in twenty is outside.
    pub(crate) fn nurbs_parameter(&mut self) -> f64 {
        let Some((_, Value::NurbsCurve(curve))) = self.result.arguments.first() else {
            panic!("a parameter needs a NURBS curve");
        };
        let first = if curve.closed { 0 } else { curve.degree };
        let (from, to) = (curve.knots[first], curve.knots[curve.points.len()]);
        self.knot_parameter(&curve.knots, [from, to])
    }

    /// The same for a direction of a NURBS surface.
    fn surface_parameter(&mut self, direction: usize) -> f64 {
        let Some((_, Value::NurbsSurface(surface))) = self.result.arguments.first() else {
            panic!("a parameter needs a NURBS surface");
        };
        let (knots, degree) = (&surface.knots[direction], surface.degrees[direction]);
        self.knot_parameter(knots, [knots[degree], knots[knots.len() - degree - 1]])
    }

    fn knot_parameter(&mut self, knots: &[f64], [from, to]: [f64; 2]) -> f64 {
        match self.rng.below(20) {
            0 => from,
            1 => to,
            2 | 3 => knots[self.rng.below(knots.len())].clamp(from, to),
            4 => to + self.rng.unit(),
            _ => from + (to - from) * self.rng.unit(),
        }
    }

    /// A part of the size; one in thirty is out of range.
    fn tolerance(&mut self, size: f64, min: f64, max: f64) -> f64 {
        match self.rng.below(60) {
            0 => self.rng.pick(&[0.0, -1.0, 1e-300, 1e-30, 1e30, 1e300]),
            1 => size * self.rng.magnitude(-20.0, -14.0),
            _ => size * self.rng.magnitude(min, max),
        }
    }

    /// A part of the size between 10^usual and 10^−1, or with a probability between 10^least and 10^−1.
    fn seldom_fine(&mut self, probability: f64, size: f64, min: f64, usual: f64) -> f64 {
        let is_fine = self.rng.chance(probability);
        self.tolerance(size, if is_fine { min } else { min.max(usual) }, -1.0)
    }

    /// How far the control points reach on a screen 640 pixels wide, if a projection was made already.
    fn pixels_across(&self) -> Option<f64> {
        let (_, Value::Numbers(m)) = self.result.arguments.last()? else {
            return None;
        };
        let points = control_points(&self.result.arguments[0].1);
        let row = |k: usize, p: DVec3| m[k] * p.x + m[4 + k] * p.y + m[8 + k] * p.z + m[12 + k];
        let depth = points.iter().map(|&p| row(3, p).abs()).fold(0.0, f64::max);
        let locations = points.iter().map(|&p| {
            let largest = row(0, p).abs().max(row(1, p).abs());
            320.0 * largest / row(3, p).max(1e-2 * depth)
        });
        let across = locations.fold(0.0, f64::max);
        let is_usable = across > 0.0 && across.is_finite();
        Some(if is_usable { across } else { 1.0 })
    }

    fn length(&mut self, mut size: f64) -> f64 {
        // Wide strokes of a large drawing cover each other thousands of times.
        if self.point_count() > MAX_POINTS_WITH_WIDE_STROKES {
            size *= 1e-3;
        }
        let sign = self.rng.sign();
        match self.rng.below(10) {
            0 => sign * self.rng.pick(&EXTREME_LENGTHS),
            1 => sign * size,
            2 if self.mode == Mode::MixedScale => sign * size * self.rng.magnitude(-12.0, 3.0),
            _ => sign * size * self.rng.magnitude(-3.0, 0.5),
        }
    }

    fn handle(&mut self) -> f64 {
        match self.mode {
            Mode::Moderate => 3.0 * self.rng.signed(),
            Mode::MixedScale => self.rng.signed() * self.rng.magnitude(-12.0, 15.0),
            Mode::Extreme => self.rng.signed() * self.rng.pick(&[1e300, 1e-300, 1.0]),
        }
    }

    fn count(&mut self, kind: &str) -> Option<usize> {
        let (known, joints) = (self.point_count(), self.whole_segments());
        let rng = &mut *self.rng;
        // One index or count in twenty is out of range.
        let outside = rng.chance(0.05);
        Some(match kind {
            "segments" | "cells" | "lines" if outside => 0,
            "segments" => rng.pick(&[1, 2, 3, 7, 10, 32, 100]),
            "cells" => rng.pick(&[1, 1, 2, 3, 4, 8, 13]),
            "lines" => rng.pick(&[1, 2, 3]),
            "sides" => rng.pick(&[3, 4, 6, 8, 2]),
            "order" => rng.below(26),
            "axis" if outside => 3,
            "axis" => rng.below(self.result.dimension()),
            "any degree" => rng.pick(&[0, 1, 2, 3, 7, 24, 63, 64, 65]),
            "any dimension" => 2 + rng.below(2),
            "any count" => rng.pick(&[0, 1, 2, 100, 1_000_000, usize::MAX >> 11]),
            "low degree" => rng.pick(&[1, 2, 3, 3, 3, 4, 7]),
            "joint" => rng.below(if outside { 8 } else { joints }),
            "index" => rng.below(5),
            "point index" => rng.below((known + usize::from(outside)).max(1)),
            "precision" => rng.pick(&[0, 1, 2, 3, 6, 12, 17, 100]),
            _ => return None,
        })
    }

    /// The number of control points of the first argument.
    fn point_count(&self) -> usize {
        let first = self.result.arguments.first();
        first.map_or(0, |(_, value)| control_points(value).len())
    }

    /// The number of segments of a spline, 1 for other arguments.
    pub(crate) fn whole_segments(&self) -> usize {
        match self.result.arguments.first() {
            Some((_, Value::Spline(spline))) => spline.degrees.len(),
            _ => 1,
        }
    }

    pub(crate) fn segments(&self) -> f64 {
        real(self.whole_segments())
    }
}

/// Lengths that rounding swallows, whose squares underflow or overflow, and that exceed the limit of coordinates.
const EXTREME_LENGTHS: [f64; 8] = [0.0, 0.0, 1e-300, 1e-160, 1e-17, 1e17, 1e149, 1e300];

/// In the range, at its ends, at joints, and outside.
pub(crate) fn parameter(rng: &mut Rng, end: f64) -> f64 {
    match rng.below(16) {
        0 => 0.0,
        1 => end,
        2 => (end * rng.unit()).round(),
        3 => end * 0.5,
        4 => rng.pick(&[f64::EPSILON, 1e-9, 1e-300]),
        5 => end - rng.pick(&[f64::EPSILON, 1e-9]),
        6 => -rng.unit(),
        7 => end + rng.unit(),
        _ => end * rng.unit(),
    }
}

pub(crate) fn control_points(value: &Value) -> Vec<DVec3> {
    match value {
        Value::Curve(_, points) | Value::Points(_, points) => points.clone(),
        Value::RationalCurve(curve) | Value::NurbsCurve(curve) => curve.points.clone(),
        Value::Spline(spline) => spline.points.clone(),
        Value::Path(splines) => splines.iter().flat_map(|one| one.points.clone()).collect(),
        Value::Patch(surface) | Value::Surface(surface) | Value::RationalSurface(surface) => {
            surface.vertices.clone()
        }
        Value::RationalPatch(surface) | Value::NurbsSurface(surface) => surface.points.clone(),
        _ => Vec::new(),
    }
}
