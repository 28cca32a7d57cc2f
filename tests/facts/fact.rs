//! A record of golden data and its comparison.

use crate::support::{curve, near_at};
use casteljau::Curve;
use casteljau::glam::{DVec2, DVec3};
use serde_json::Value;

pub(crate) struct Fact<'a> {
    pub(crate) id: &'a str,
    pub(crate) input: &'a Value,
    pub(crate) expect: Value,
    pub(crate) tolerance: f64,
}

impl<'a> Fact<'a> {
    pub(crate) fn new(fact: &'a Value) -> Self {
        Self {
            id: text(&fact["id"]),
            input: &fact["input"],
            expect: fact["expect"].clone(),
            tolerance: number(&fact["tol"]),
        }
    }

    pub(crate) fn points(&self, name: &str) -> Vec<DVec3> {
        points(&self.input[name])
    }

    pub(crate) fn named(&self, name: &str) -> Curve<DVec3> {
        curve(&self.points(name))
    }

    pub(crate) fn curve(&self) -> Curve<DVec3> {
        self.named("points")
    }

    /// The curve in the plane.
    pub(crate) fn flat(&self) -> Curve<DVec2> {
        curve(&self.points("points"))
    }

    pub(crate) fn t(&self) -> f64 {
        number(&self.input["t"])
    }

    pub(crate) fn number(&self, got: f64, expected: &Value) {
        near_at(got, number(expected), self.tolerance, self.id);
    }

    pub(crate) fn near(&self, got: DVec3, expected: &Value) {
        let difference = (got - point(expected)).abs().max_element();
        near_at(difference, 0.0, self.tolerance, (self.id, got, expected));
    }

    pub(crate) fn all_near(&self, got: &Curve<DVec3>, expected: &Value) {
        let expected = expected.as_array().expect("points");
        assert_eq!(got.control_points().len(), expected.len(), "{}", self.id);
        let pairs = got.control_points().iter().zip(expected);
        pairs.for_each(|(&p, e)| self.near(p, e));
    }
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub(crate) fn count(value: &Value) -> usize {
    let count = value.as_u64().expect("a count");
    usize::try_from(count).expect("a small count")
}

pub(crate) fn text(value: &Value) -> &str {
    value.as_str().expect("a text")
}

pub(crate) fn list<T>(value: &Value, of: impl Fn(&Value) -> T) -> Vec<T> {
    value.as_array().expect("a list").iter().map(of).collect()
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    list(value, number)
}

pub(crate) fn point(value: &Value) -> DVec3 {
    let numbers = numbers(value);
    DVec3::new(
        numbers[0],
        numbers[1],
        numbers.get(2).copied().unwrap_or(0.0),
    )
}

pub(crate) fn points(value: &Value) -> Vec<DVec3> {
    list(value, point)
}
