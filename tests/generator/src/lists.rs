//! Arguments that are lists: points, parameters, knots, matrices.

use crate::arguments::{BASES, MODES, Maker, control_points, parameter};
use crate::case::Value;
use crate::geometry;
use crate::random::real;
use glam::DVec3;

/// The parts of the teapot.
const PARTS: [&str; 6] = ["rim", "body", "handle", "spout", "lid", "bottom"];

impl Maker<'_> {
    pub(crate) fn list(&mut self, kind: &str) -> Option<Value> {
        let any = 2 + self.rng.below(2);
        Some(match kind {
            "control points" => Value::Points(any, geometry::curve(self.rng, self.mode, any, 24)),
            "four points" => Value::Points(any, self.points(any, 4)),
            "space points" => Value::Points(3, self.points(3, 4)),
            "sixteen points" => Value::Points(3, self.points(3, 16)),
            "few points" => self.some_points(any, 2, 8),
            "many points" => self.some_points(any, 2, 24),
            "stroke" => self.some_points(any, 2, 60),
            "plane stroke" => self.some_points(2, 1, 60),
            "parameters" => Value::Numbers(self.parameters(1.0)),
            "spline parameters" => Value::Numbers(self.parameters(self.segments())),
            "distinct parameters" => self.distinct_parameters(),
            "nurbs parameters" => {
                let count = self.rng.below(6);
                Value::Numbers((0..count).map(|_| self.nurbs_parameter()).collect())
            }
            "weights" => self.weights(),
            "knots" => self.knots(),
            "basis" => {
                let is_matrix = self.rng.chance(0.3);
                let mut number = |_| (4.0 * self.rng.signed()).round() * 0.5;
                match is_matrix {
                    true => Value::Numbers((0..16).map(&mut number).collect()),
                    false => Value::Word(self.rng.pick(&BASES)),
                }
            }
            "joint modes" => {
                let joints = 0..=self.whole_segments();
                Value::Words(joints.map(|_| self.rng.pick(&MODES)).collect())
            }
            "parts" => Value::Words(PARTS.into_iter().filter(|_| self.rng.chance(0.6)).collect()),
            "map" => self.map(),
            "projective map" => self.projective_map(),
            "extreme map" => self.extreme_map(),
            "projection" => self.projection(),
            "closed" | "flag" => Value::Flag(self.rng.chance(0.5)),
            _ => return None,
        })
    }

    fn points(&mut self, dimension: usize, count: usize) -> Vec<DVec3> {
        let mut points = Vec::new();
        while points.len() < count {
            points.extend(geometry::curve(self.rng, self.mode, dimension, 12));
        }
        points.truncate(count);
        points
    }

    fn some_points(&mut self, dimension: usize, min: usize, max: usize) -> Value {
        let count = min + self.rng.below(max + 1 - min);
        Value::Points(dimension, self.points(dimension, count))
    }

    fn parameters(&mut self, end: f64) -> Vec<f64> {
        let count = self.rng.below(20);
        (0..count).map(|_| parameter(self.rng, end)).collect()
    }

    /// As many as the points, in order and not close together; in some cases shuffled, and in a few equal.
    fn distinct_parameters(&mut self) -> Value {
        let count = control_points(&self.result.arguments[0].1).len();
        let near = |k: usize| (real(k) + 0.5 * self.rng.unit()) / real(count);
        let mut ts: Vec<f64> = (0..count).map(near).collect();
        match self.rng.below(10) {
            0 => ts.reverse(),
            1 => ts.iter_mut().for_each(|t| *t = 3.0 * *t - 1.0),
            2 => ts[count - 1] = ts[0],
            _ => {}
        }
        Value::Numbers(ts)
    }

    /// Knots for the points and the degree before: ascending, some repeated.
    fn knots(&mut self) -> Value {
        let points = control_points(&self.result.arguments[0].1).len();
        let degree = match self.result.arguments[1].1 {
            Value::Count(degree) => degree,
            _ => 3,
        };
        // An open B-spline takes points + degree + 1 knots, a closed one points + 1; whether it is closed comes later.
        let is_open = self.rng.chance(0.5);
        let mut knots = vec![0.0; points + 1 + if is_open { degree } else { 0 }];
        let mut knot = 0.0;
        for known in &mut knots {
            if !self.rng.chance(0.3) {
                knot += self.rng.pick(&[1.0, 1.0, 0.25, 3.0]);
            }
            *known = knot;
        }
        Value::Numbers(knots)
    }

    /// An affine map, column-major: the 2 × 2 or 3 × 3 matrix, then the translation.
    fn map(&mut self) -> Value {
        let dimension = self.result.dimension();
        let entries = 0..dimension * (dimension + 1);
        let mut numbers: Vec<f64> = entries.map(|_| 2.0 * self.rng.signed()).collect();
        match self.rng.below(5) {
            0 => numbers.iter_mut().for_each(|x| *x = x.round()),
            1 => numbers[..dimension].fill(0.0), // singular
            _ => {}
        }
        Value::Numbers(numbers)
    }

    /// As many as the points; in a few cases one is missing or not above 0.
    fn weights(&mut self) -> Value {
        let count = control_points(&self.result.arguments[0].1).len();
        let mut weights = geometry::weights(self.rng, count);
        match self.rng.below(30) {
            0 => weights.truncate(count - 1),
            1 => weights[0] = self.rng.pick(&[0.0, -1.0, 1e-160, 1e160]),
            _ => {}
        }
        Value::Numbers(weights)
    }

    /// A square matrix, column by column, whose last row is small for points of the size of the case.
    fn projective_map(&mut self) -> Value {
        let n = self.result.dimension() + 1;
        let mut numbers: Vec<f64> = (0..n * n).map(|_| 2.0 * self.rng.signed()).collect();
        for column in 0..n - 1 {
            numbers[column * n + n - 1] /= self.size() * real(n);
        }
        numbers[n * n - 1] = self.rng.pick(&[1.0, 2.0, -3.0]);
        Value::Numbers(numbers)
    }

    /// A map whose images may leave the range of f64, or vanish.
    fn extreme_map(&mut self) -> Value {
        let Value::Numbers(mut numbers) = self.map() else {
            unreachable!("a map is a list of numbers");
        };
        let dimension = self.result.dimension();
        let sizes = [1.0, 1e100, 1e150, 1e300, 1e308, 1e-150, 1e-300, 0.0];
        let [linear, translation] = [self.rng.pick(&sizes), self.rng.pick(&sizes)];
        for (k, x) in numbers.iter_mut().enumerate() {
            let is_linear = k < dimension * dimension;
            let size = if is_linear { linear } else { translation };
            *x = (*x * size).clamp(-f64::MAX, f64::MAX);
        }
        Value::Numbers(numbers)
    }

    /// A 4 × 4 matrix, column-major: affine, or a perspective whose eye may lie amid the surface.
    fn projection(&mut self) -> Value {
        let (scale, mut m) = (self.rng.pick(&[1.0, 100.0]) / self.size(), vec![0.0; 16]);
        for k in 0..3 {
            let row = self.rng.point(3) * scale;
            [m[k], m[4 + k], m[8 + k]] = row.to_array();
            m[12 + k] = self.rng.signed();
        }
        m[15] = 1.0;
        if self.rng.chance(0.6) {
            let w = self.rng.point(3) / self.size();
            [m[3], m[7], m[11]] = w.to_array();
            m[15] = self.rng.pick(&[0.0, 1.0, 2.0]);
        }
        Value::Numbers(m)
    }
}
