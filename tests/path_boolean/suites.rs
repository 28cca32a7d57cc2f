//! The inputs of other libraries' tests, from tests/data/boolean; results are judged as those of the families.

use crate::path_boolean::check::{faults, identity_error, path};
use crate::support::Rng;
use casteljau::path::{FillRule, take_replaced_segments};

/// The largest error of an identity of areas, relative to the square of the size. These drawings have outlines that
/// nearly coincide.
const NEARLY_COINCIDENT: f64 = 1e-9;

fn check(suite: &str, at_least: usize) {
    let cases = suite.lines().filter(|line| !line.starts_with("# "));
    let cases: Vec<&str> = cases.collect();
    assert!(cases.len() >= at_least, "only {} cases", cases.len());
    take_replaced_segments();
    let wrong: Vec<String> = cases.into_iter().flat_map(faults_of).collect();
    assert!(wrong.is_empty(), "{} wrong: {wrong:#?}", wrong.len());
    assert_eq!(take_replaced_segments(), 0, "lines replace segments");
}

/// What is wrong with the results of a case, with its name and fill rule.
fn faults_of(case: &str) -> Vec<String> {
    let fields: Vec<&str> = case.split('\t').collect();
    let [name, a, b] = fields[..] else {
        panic!("expected a name and two paths, got {case}");
    };
    let [a, b] = [a, b].map(path);
    let of_rule = |rule| {
        let mut wrong = faults(&a, &b, rule, &mut Rng(case.len() as u64));
        let error = identity_error(&a, &b, rule);
        if error > NEARLY_COINCIDENT {
            wrong.push(format!("areas differ by {error:e}"));
        }
        let wrong = wrong.into_iter();
        wrong.map(move |fault| format!("{name} {rule:?}: {fault}"))
    };
    let rules = [FillRule::NonZero, FillRule::EvenOdd];
    rules.into_iter().flat_map(of_rule).collect()
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
