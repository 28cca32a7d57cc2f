//! Surfaces as text. The tables of valid and invalid texts are also read by tests/js/surface-text.test.js and
//! tests/js/nurbs-surface.test.js.

use crate::support::Rng;
use crate::support::nets::{nothing, teapot};
use casteljau::glam::DVec3;
use casteljau::models::Up;
use casteljau::{MAX_COORDINATE, RationalSurface, Surface};
use serde_json::Value;

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().unwrap().iter();
    list.map(|number| number.as_f64().unwrap()).collect()
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

fn coordinates(surface: &Surface) -> Vec<f64> {
    let vertices = surface.vertices().iter();
    vertices.flat_map(|vertex| vertex.to_array()).collect()
}

#[test]
fn table_of_texts() {
    let table: Value = serde_json::from_str(include_str!("../texts/surfaces.json")).unwrap();
    for entry in table.as_array().unwrap() {
        let name = &entry["name"];
        let result = Surface::parse(entry["text"].as_str().unwrap());
        if let Some(error) = entry["error"].as_str() {
            assert_eq!(result.unwrap_err().to_string(), error, "{name}");
            continue;
        }
        let surface = result.unwrap_or_else(|error| panic!("{name}: {error}"));
        let (got, expected) = (coordinates(&surface), numbers(&entry["vertices"]));
        assert_eq!(bits(&got), bits(&expected), "{name}: {got:?}");
        let indices: Vec<f64> = surface.indices().iter().map(|&i| f64::from(i)).collect();
        assert_eq!(indices, numbers(&entry["indices"]), "{name}");
        let degrees = (0..surface.patch_count()).filter_map(|patch| surface.degrees(patch));
        let degrees: Vec<f64> = degrees.flatten().map(|degree| degree as f64).collect();
        assert_eq!(degrees, numbers(&entry["degrees"]), "{name}");
    }
}

#[test]
fn table_of_weighted_texts() {
    let table: Value =
        serde_json::from_str(include_str!("../texts/weighted-surfaces.json")).unwrap();
    for entry in table.as_array().unwrap() {
        let (name, text) = (&entry["name"], entry["text"].as_str().unwrap());
        assert!(Surface::parse(text).is_err(), "{name}");
        let result = RationalSurface::parse(text);
        if let Some(error) = entry["error"].as_str() {
            assert_eq!(result.unwrap_err().to_string(), error, "{name}");
            continue;
        }
        let surface = result.unwrap_or_else(|error| panic!("{name}: {error}"));
        let weights = numbers(&entry["weights"]);
        assert_eq!(bits(surface.weights()), bits(&weights), "{name}");
        let indices: Vec<f64> = surface.indices().iter().map(|&i| f64::from(i)).collect();
        assert_eq!(indices, numbers(&entry["indices"]), "{name}");
        let written = entry["written"].as_str().unwrap_or(text);
        assert_eq!(surface.to_text(), written, "{name}");
    }
}

/// Checks that a surface is read back bit for bit.
fn there_and_back(surface: &Surface) {
    let text = surface.to_text();
    let again = Surface::parse(&text).unwrap();
    assert_eq!(bits(&coordinates(&again)), bits(&coordinates(surface)));
    assert_eq!(&again, surface);
    assert_eq!(again.to_text(), text);
}

#[test]
fn text_of_known_surfaces_reads_back() {
    there_and_back(&teapot());
    there_and_back(&Surface::teacup(Up::Y));
    there_and_back(&Surface::teaspoon(Up::Z));
    there_and_back(&nothing());
}

#[test]
fn text_of_adversarial_numbers_reads_back() {
    let mut random = Rng(5);
    let small = [0.0, -0.0, 5e-324, f64::MIN_POSITIVE, 1e-7, 1e-6, 0.1];
    let edges = [
        &small[..],
        &[1e15, 1e16, 123e18, 1e21, 1e23, MAX_COORDINATE],
    ]
    .concat();
    for case in 0..2000 {
        let (m, n) = (1 + case % 4, 1 + case % 3);
        let mut number = || {
            let (adversarial, edge) = (f64::from_bits(random.next()), random.pick(&edges));
            let allowed = adversarial.abs() <= MAX_COORDINATE;
            if allowed && random.chance(2.0 / 3.0) {
                adversarial
            } else {
                edge
            }
        };
        let count = (m + 1) * (n + 1);
        let net = (0..count).map(|_| DVec3::new(number(), number(), number()));
        let indices = (0..u32::try_from(count).unwrap()).rev().collect();
        there_and_back(&Surface::new(net.collect(), indices, m, n).unwrap());
    }
}

#[test]
fn bpt_joins_what_coincides() {
    let mut text = String::from("32\n");
    for patch in teapot().patches() {
        text += "3 3\n";
        for p in patch.control_points() {
            text += &format!("{:.5} {} {:.5}\n", p.x, p.y, p.z);
        }
    }
    // Five decimals represent all coordinates of the teapot.
    assert_eq!(Surface::parse(&text).unwrap(), teapot());
}

#[test]
fn large_texts_take_their_time_once() {
    // A quarter of a million points; a reader with quadratic time would need hours.
    let patch = format!("3 3\n1 2 3\n{}4 5 6\n", "0 0 0\n".repeat(14));
    let surface = Surface::parse(&format!("15000\n{}", patch.repeat(15_000))).unwrap();
    let counts = (surface.patch_count(), surface.vertices().len());
    assert_eq!(counts, (15_000, 3));
    for bad in ["1 ", "\n", "9"] {
        assert!(Surface::parse(&bad.repeat(1 << 22)).is_err());
    }
}
