//! Timing functions from and to CSS text, and their approximation by `linear()`.

use crate::support::{near_at, refused};
use casteljau::{Easing, Error};
use serde_json::Value;

/// The table that tests/js/easing-css.test.js reads, too.
fn table() -> Vec<Value> {
    serde_json::from_str(include_str!("../texts/easing.json")).expect("JSON")
}

#[test]
fn every_text_of_the_table_is_read_evaluated_and_written() {
    let rows = table();
    let rows: Vec<&Value> = rows.iter().filter(|row| row["css"].is_string()).collect();
    assert!(rows.len() > 30);
    for row in rows {
        let (text, css) = (row["text"].as_str().unwrap(), row["css"].as_str().unwrap());
        let easing: Easing = text.parse().expect(text);
        assert_eq!(easing.to_string(), css, "{text}");
        assert_eq!(css.parse(), Ok(easing.clone()), "{text}");
        for value in row["values"].as_array().unwrap() {
            let [x, y] = [0, 1].map(|k| value[k].as_f64().unwrap());
            near_at(easing.eval(x), y, 4e-16 * y.abs().max(1.0), (text, x));
        }
    }
}

#[test]
fn every_refused_text_of_the_table_has_its_message_and_its_offset() {
    let rows = table();
    let rows: Vec<&Value> = rows.iter().filter(|row| row["error"].is_string()).collect();
    assert!(rows.len() > 30);
    for row in rows {
        let text = row["text"].as_str().unwrap();
        let error = text.parse::<Easing>().expect_err(text);
        assert_eq!(error.to_string(), row["error"].as_str().unwrap());
        assert_eq!(Some(error.offset as u64), row["offset"].as_u64(), "{text}");
    }
}

const CURVES: [&str; 7] = [
    "ease",
    "ease-in-out",
    "cubic-bezier(0.68, -0.55, 0.265, 1.55)",
    "cubic-bezier(0, 1, 1, 0)",
    "cubic-bezier(1, 0, 0, 1)",
    "cubic-bezier(0, 1, 0, 1)",
    "cubic-bezier(0.1, 7, 0.9, -6)",
];

/// tests/js/easing-css.test.js has the same texts.
const LINEARS: [&str; 3] = [
    "linear(0, 0.1 9%, 0.21 20%, 0.29 30%, 0.4 40%, 0.4 60%, 0.9 60%, 0.95 80%, 1.01 90%, 1)",
    "linear(-3, 0.5 10%, 100 20%, 120 30%, 180 70%, 200)",
    "linear(0.123456789, 0.2 10%, 0.5 50%, 0.987654321)",
];

/// tests/js/easing-css.test.js has the same sum, and checks tolerances and numbers of stops.
#[test]
fn to_linear_writes_the_same_text_as_javascript() {
    let mut sum = 0_u64;
    for css in CURVES.into_iter().chain(LINEARS) {
        let easing: Easing = css.parse().unwrap();
        // The smallest tolerance is relative to the largest output.
        let scale = if css.contains("200") { 200.0 } else { 1.0 };
        for tolerance in [0.1, 0.03, 0.001].map(|share| share * scale) {
            let text = easing.to_linear(tolerance).unwrap();
            for byte in text.bytes() {
                sum = sum.rotate_left(7) ^ u64::from(byte);
            }
        }
    }
    assert_eq!(sum, 0x8c1f_008f_d538_8405, "{sum:#x}");
}

#[test]
fn to_linear_keeps_the_tolerance() {
    for css in CURVES {
        let easing: Easing = css.parse().unwrap();
        let linear: Easing = easing.to_linear(0.01).unwrap().parse().unwrap();
        for k in 0..=10_000 {
            let x = f64::from(k) / 10_000.0;
            let error = (linear.eval(x) - easing.eval(x)).abs();
            assert!(error <= 0.01, "{css} at {x}: {error}");
        }
    }
}

#[test]
fn refused_tolerances_and_steps() {
    let ease: Easing = "ease".parse().unwrap();
    for tolerance in [0.0, -1.0, 9e-5, f64::NAN, f64::INFINITY] {
        refused(ease.to_linear(tolerance), "Range tolerance");
    }
    let large = Easing::new(0.5, 5.0, 0.5, 1.0).unwrap();
    assert!(large.to_linear(4e-4).is_err() && large.to_linear(5e-4).is_ok());
    let many: Easing = "steps(40000)".parse().unwrap();
    let error = many.to_linear(0.1).expect_err("refused");
    let (what, limit, needed) = ("stops", 65_536, 80_001);
    assert_eq!(
        error,
        Error::TooMany {
            what,
            limit,
            needed
        }
    );
}

/// The range is a few ulps wide, so that rounding could descend within it.
#[test]
fn percentages_that_are_filled_in_ascend() {
    let text = "linear(0 79.87344453458203%, 1, 2, 3, 4, 5, 6, 7 79.87344453458206%)";
    let css = text.parse::<Easing>().unwrap().to_string();
    let percentage = |stop: &str| {
        let word = stop.split_whitespace().nth(1)?;
        word.trim_end_matches('%').parse().ok()
    };
    let percentages: Vec<f64> = css.split(['(', ',', ')']).filter_map(percentage).collect();
    assert_eq!(percentages.len(), 8, "{css}");
    assert!(percentages.is_sorted(), "{css}");
}
