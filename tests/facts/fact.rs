//! A record of golden data and its comparison.

use crate::support::curve;
use casteljau::Curve;
use casteljau::glam::DVec3;
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
            id: fact["id"].as_str().expect("an id"),
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

    pub(crate) fn t(&self) -> f64 {
        number(&self.input["t"])
    }

    pub(crate) fn number(&self, got: f64, expected: &Value) {
        let expected = number(expected);
        assert!(
            (got - expected).abs() <= self.tolerance,
            "{}: {got}, expected {expected}",
            self.id
        );
    }

    pub(crate) fn near(&self, got: DVec3, expected: &Value) {
        let difference = (got - point(expected)).abs().max_element();
        assert!(
            difference <= self.tolerance,
            "{}: {got}, expected {expected}",
            self.id
        );
    }

    pub(crate) fn all_near(&self, got: &Curve<DVec3>, expected: &Value) {
        let expected = expected.as_array().expect("points");
        assert_eq!(got.control_points().len(), expected.len(), "{}", self.id);
        got.control_points()
            .iter()
            .zip(expected)
            .for_each(|(&p, e)| self.near(p, e));
    }
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .expect("numbers")
        .iter()
        .map(number)
        .collect()
}

pub(crate) fn point(value: &Value) -> DVec3 {
    let coordinates = numbers(value);
    DVec3::new(
        coordinates[0],
        coordinates[1],
        coordinates.get(2).copied().unwrap_or(0.0),
    )
}

pub(crate) fn points(value: &Value) -> Vec<DVec3> {
    value
        .as_array()
        .expect("points")
        .iter()
        .map(point)
        .collect()
}
