//! The inputs of other libraries' tests, from tests/data/boolean; results are judged as those of the families.

use crate::check::{faults, identity_error};
use crate::random::Random;
use casteljau::Path;
use casteljau::path::FillRule;

/// The largest error of an identity of areas, relative to the square of the size. These drawings have outlines that
/// nearly coincide.
const NEARLY_COINCIDENT: f64 = 1e-9;

fn check(suite: &str, fewest: usize) {
    let mut count = 0;
    for line in suite.lines().filter(|line| !line.starts_with("# ")) {
        let fields: Vec<&str> = line.split('\t').collect();
        let [name, a, b] = fields[..] else {
            panic!("expected a name and two paths, got {line}");
        };
        let [a, b] = [a, b].map(|d| Path::from_svg(d).expect("path data"));
        for rule in [FillRule::NonZero, FillRule::EvenOdd] {
            let found = faults(&a, &b, rule, &mut Random::new(count));
            assert!(found.is_empty(), "{name} {rule:?}: {found:#?}");
            let error = identity_error(&a, &b, rule);
            assert!(
                error <= NEARLY_COINCIDENT,
                "{name} {rule:?}: areas differ by {error:e}"
            );
        }
        count += 1;
    }
    assert!(count as usize >= fewest, "only {count} cases were read");
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
