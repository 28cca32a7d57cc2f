//! The inputs of other libraries' tests, from tests/data/boolean; results are judged as those of the families.

use crate::path_boolean::check::{faults, identity_error, path};
use crate::path_boolean::random::Random;
use casteljau::path::FillRule;

/// The largest error of an identity of areas, relative to the square of the size. These drawings have outlines that
/// nearly coincide.
const NEARLY_COINCIDENT: f64 = 1e-9;

fn check(suite: &str, fewest: usize) {
    let cases: Vec<&str> = suite
        .lines()
        .filter(|line| !line.starts_with("# "))
        .collect();
    assert!(cases.len() >= fewest, "only {} cases", cases.len());
    let wrong: Vec<String> = cases.iter().flat_map(|case| faults_of(case)).collect();
    assert!(wrong.is_empty(), "{} wrong: {wrong:#?}", wrong.len());
}

/// What is wrong with the results of a case, with its name and fill rule.
fn faults_of(case: &str) -> Vec<String> {
    let fields: Vec<&str> = case.split('\t').collect();
    let [name, a, b] = fields[..] else {
        panic!("expected a name and two paths, got {case}");
    };
    let [a, b] = [a, b].map(path);
    let mut wrong = Vec::new();
    for rule in [FillRule::NonZero, FillRule::EvenOdd] {
        let mut random = Random::new(case.len() as u64);
        wrong.extend(faults(&a, &b, rule, &mut random));
        let error = identity_error(&a, &b, rule);
        if error > NEARLY_COINCIDENT {
            wrong.push(format!("areas differ by {error:e}"));
        }
        for fault in &mut wrong {
            if !fault.starts_with(name) {
                *fault = format!("{name} {rule:?}: {fault}");
            }
        }
    }
    wrong
}

#[test]
fn paper_js() {
    check(include_str!("../data/boolean/paper.js.txt"), 40);
}

#[test]
fn path_bool() {
    check(include_str!("../data/boolean/path-bool.txt"), 19);
}

#[test]
fn linesweeper() {
    check(include_str!("../data/boolean/linesweeper.txt"), 8);
}

#[test]
fn boolean_operations() {
    check(include_str!("../data/boolean/booleanOperations.txt"), 16);
}

#[test]
fn skia() {
    check(include_str!("../data/boolean/skia.txt"), 1054);
}
